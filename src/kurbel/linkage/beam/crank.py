"""The beam engine as a crank drive, in its true geometry: an arc crank whose rocker is the arm of the beam.

φ counts from the vertical through the shaft, on which the pivot lies beside the way of the beam's end; the
piston at the other end, on an arm as long, has the path of the beam's end along its arc.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any, ClassVar

import flint
from flint import arb

from kurbel.drive.crank import LONGEST_ROD, Crank
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.kernel import beam
from kurbel.linkage.arc.rocker import RockerCrank
from kurbel.linkage.beam.engine import BeamEngine, chord_square
from kurbel.page.quantity import Words, words
from kurbel.reading.notation import about


@dataclass(frozen=True, slots=True)
class BeamCrank(RockerCrank):
    """A beam engine with an arm a of the beam in units of R; its pivot stands on the side of the crank pin
    during the outstroke, which begins with crank and rod stretched.

    The beam swings alike above and below the horizontal and the shaft lies below the middle of the sagitta:
    where the pivot is, and so every length that depends on it, is irrational. Valid where `BeamEngine` is.
    """

    mechanism: ClassVar[str] = "beam"
    title: ClassVar[str] = "the beam engine"
    noun: ClassVar[Words] = words("Balanciermaschine|Beam engine")
    letter: ClassVar[str] = "a"
    at_end: ClassVar[bool] = False

    crank: Crank
    arm: Fraction

    def __post_init__(self) -> None:
        if self.arm > LONGEST_ROD:
            raise ProblemError(
                f"beam arm a is {about(self.arm)} r, beyond {LONGEST_ROD} r; take the straight crank for it"
            )
        BeamEngine(self.arm, self.crank.ratio)

    @property
    def rocker(self) -> Fraction:  # type: ignore[override]
        return self.arm

    @property
    def curvature(self) -> Fraction:
        return 1 / self.arm

    def figures(self, stroke: int, kind: Kind) -> tuple[Any, Any, Any, Any]:
        sign = kind.of(Fraction(stroke))
        offset, shift = (sign * kind.enclosed(one) for one in (self._offset, self._shift))
        return sign * kind.of(self.crank.ratio), sign * kind.of(self.curvature), offset, shift

    def height(self, kind: Kind) -> Any:
        """Return how far the pivot lies above the shaft, of a rod that is not infinite."""
        return kind.of(1 / self.crank.ratio) + kind.enclosed(self._shift)

    def distance(self, kind: Kind) -> Any:
        """Return how far it lies beside the shaft."""
        return kind.of(self.arm) + kind.enclosed(self._offset)

    def _offset(self) -> arb:
        """η = -½e, the half sagitta by which the arc's end swings beyond the vertical through the shaft."""
        return self._place()[0]

    def _shift(self) -> arb:
        """σ, the height l r/q of the pivot above the shaft less the rod's length."""
        return self._place()[1]

    def _place(self) -> tuple[arb, arb]:
        return _place(BeamEngine(self.arm, self.crank.ratio), flint.ctx.prec)


@lru_cache(maxsize=256)
def _place(engine: BeamEngine, precision: int) -> tuple[arb, arb]:
    """Return η and σ at the precision in force."""
    square, (arm, ratio) = chord_square(engine), engine.numbers()
    sagitta, chord = beam.sagitta(square, arm), square.sqrt()
    # (1/q - 1)/λ, in which `closure` takes the place of 1 - q² = (1 - q)(1 + q).
    bent = ratio * sagitta * sagitta * chord
    return -sagitta / 2, -bent / (4 * (1 - ratio * ratio * square) * (1 + chord))
