"""The beam engine as a crank drive, in its true geometry: what its pages say, and as a mechanism.

φ counts from the vertical through the shaft, on which the pivot lies beside the way of the beam's end; the
piston at the other end, on an arm as long, has the path of the beam's end along its arc.

Conditions see it as an arc crank whose formulas no polynomial with rational numbers has.

Where a quantity rises and falls is therefore proved by balls: all zeros of its slope are enclosed
(`roots.isolate`), and a value that is just reached stays unsettled.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, lru_cache
from typing import ClassVar

import flint
from flint import arb

from kurbel.drive.at import known
from kurbel.drive.crank import LONGEST_ROD, Crank, DescribedDrive, radii
from kurbel.errors import ProblemError
from kurbel.exact.certify import ball
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label, exact_text
from kurbel.kernel import beam
from kurbel.kernel.circle import Numeric
from kurbel.linkage.arc import ArcDrive
from kurbel.linkage.arc_mechanism import NAMES as ARC_NAMES
from kurbel.linkage.arc_mechanism import WORDS as ARC_WORDS
from kurbel.linkage.arc_mechanism import RockerMechanism, named, printed
from kurbel.linkage.arc_quantities import OF_TURN, arc_registry
from kurbel.linkage.beam_engine import BeamEngine, chord_square
from kurbel.linkage.linkage import FORCES, linkage_subject
from kurbel.linkage.rocker import RockerCrank
from kurbel.page.quantity import Quantity, Words, words
from kurbel.reading.notation import about

PLACES = 4
# What stands for the rocker in the words of other pages, the longer words first.
_PARTS = (
    ("der Schwinge auf ihr Ende", "des Balanciers auf sein Ende"),
    ("an der Schwinge", "am Balancier"),
    ("der Schwinge", "des Balanciers"),
    ("Schwingen", "Balancier"),
    ("Schwinge", "Balancier"),
    ("rocker", "beam"),
    ("Rocker", "Beam"),
)


def _of_beam(said: str) -> str:
    for rocker, own in _PARTS:
        said = said.replace(rocker, own)
    return said


_SAID = (
    "Schwingenwinkel|Rocker angle|Drehung der Schwinge|Turn of the rocker",
    "Winkelgeschwindigkeit der Schwinge|Angular velocity of the rocker",
    "Winkelbeschleunigung der Schwinge|Angular acceleration of the rocker",
    "|".join(OF_TURN.values()),
    *(text for one in FORCES.values() for text in (one.name, one.direction)),
)
NAMES: Mapping[str, str] = {
    "Weg auf dem Bogen": "Kolbenweg",
    "Path along the arc": "Piston path",
    "Geschwindigkeit": "Kolbengeschwindigkeit",
    "Velocity": "Piston velocity",
    "Beschleunigung": "Kolbenbeschleunigung",
    "Acceleration": "Piston acceleration",
    **{said: _of_beam(said) for texts in _SAID for said in texts.split("|")},
    **{said: _of_beam(of_rocker) for said, of_rocker in ARC_NAMES.items()},
}
"""What pages call the parts of the drive, in place of what they say of a rocker and of a crosshead."""
WORDS: Mapping[str, Words] = {
    **ARC_WORDS,
    "closure": words(
        "{closure}; Arm $a$ des Balanciers, dessen Drehpunkt $D$ über und $H$ neben der Welle liegt"
        "|{closure}; arm $a$ of the beam, whose pivot lies $D$ above the shaft and $H$ beside it"
    ),
    "angles": words(
        "$φ$ und $ψ$ von der Senkrechten durch die Welle, $θ$ von der Waagrechten; $φ$ und $θ$ im Drehsinn"
        " der Kurbel, $ψ$ im entgegengesetzten"
        "|$φ$ and $ψ$ from the vertical through the shaft, $θ$ from the horizontal; $φ$ and $θ$ in the"
        " crank's sense, $ψ$ in the opposite one"
    ),
    "force": words(
        "$F$ auf den Kolben, in der Richtung des Hubes|$F$ on the piston, in the direction of the stroke"
    ),
    "piston": words(
        "Der Kolben am anderen Ende des Balanciers, an gleichem Arm, hat den Weg des Stangenendes auf seinem"
        " Bogen; Watts Geradführung ist als vollkommen genommen"
        "|The piston at the other end of the beam, on an arm as long, has the path of the rod's end along its"
        " arc; Watt's linkage is taken as perfect"
    ),
    "swing": words(
        "Der Balancier schwingt gleich weit über und unter die Waagrechte, die Welle liegt unter der Mitte"
        " der Pfeilhöhe seines Bogens"
        "|The beam swings alike above and below the horizontal, and the shaft lies below the middle of the"
        " sagitta of its arc"
    ),
    "reciprocating": words("am Kolben|at the piston"),
    "held": words(
        "$N$ ohne die Masse am Kolben, die der andere Arm des Balanciers auf ihrem Bogen hält"
        "|$N$ without the mass at the piston, which the other arm of the beam keeps on its arc"
    ),
    "rocker": words("Balancier um seinen Drehpunkt|beam about its pivot"),
    "connecting_rod": {
        # The arm of the beam is a.
        lang: _of_beam(said).replace("$a = ", "$a_S = ").replace("- a b", "- a_S b_S")
        for lang, said in ARC_WORDS["connecting_rod"].items()
    },
}


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

    def figures(self, stroke: int, kind: Kind) -> tuple[Numeric, Numeric, Numeric, Numeric]:
        sign = kind.of(Fraction(stroke))
        offset, shift = (sign * kind.enclosed(one) for one in (self._offset, self._shift))
        return sign * kind.of(self.crank.ratio), sign * kind.of(self.curvature), offset, shift

    def height(self, kind: Kind) -> Numeric:
        """Return how far the pivot lies above the shaft, of a rod that is not infinite."""
        return kind.of(1 / self.crank.ratio) + kind.enclosed(self._shift)

    def distance(self, kind: Kind) -> Numeric:
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
    sagitta, chord = ball(beam.sagitta(square, arm)), square.sqrt()
    # (1/q - 1)/λ, in which `closure` takes the place of 1 - q² = (1 - q)(1 + q).
    bent = ratio * sagitta * sagitta * chord
    return -sagitta / 2, -bent / (4 * (1 - ratio * ratio * square) * (1 + chord))


class BeamDrive(ArcDrive):
    """The beam engine."""

    def __init__(self, crank: BeamCrank, page: str = "beam") -> None:
        super().__init__(crank, page)

    def is_free(self, quantity: Quantity) -> bool:
        return False


# Of the way of the rod's end, which no piston has.
OF_END = ("chord", "slide_path", "rise")


@cache
def beam_registry() -> Mapping[str, Quantity]:
    """Return every quantity of the beam engine by its key, the return stroke's beside the outstroke's."""
    return {
        key: named(one, NAMES)
        for key, one in arc_registry().items()
        if key.removesuffix("_return") not in OF_END
    }


class Beam(RockerMechanism):
    name = "beam"
    title = BeamCrank.title
    layout = "beam"
    forces_layout = "forces-beam"
    takes = ("ratio", "stroke", "rod", "speed", "acceleration", "beam", "rocker_inertia", "method")
    words = WORDS
    further = ("piston", "swing")
    names = NAMES

    def measures(self, drive: BeamCrank) -> Mapping[str, Label | None]:
        height = printed(drive.height, PLACES) if drive.crank.ratio else None
        return {"a": exact_text(drive.arm), "D": height, "H": printed(drive.distance, PLACES)}

    def lacking(self, said: DescribedDrive) -> str:
        if said.beam is not None:
            return ""
        return "the beam engine needs the arm of its beam; add --beam, for example --beam 3"

    def drives(self, said: DescribedDrive, ratios: Sequence[str]) -> tuple[BeamCrank, ...]:
        self.check_method(said)
        return tuple(
            BeamCrank(crank, radii(known(said.beam), "beam", crank.radius)) for crank in said.cranks(ratios)
        )

    def solved(self, drives: Sequence[BeamCrank], method: str | None) -> tuple[BeamDrive, ...]:
        return tuple(map(BeamDrive, drives))


MECHANISM = Beam()
SUBJECT = linkage_subject(
    "beam engine",
    layout="beam",
    command="table --mechanism beam",
    quantities=beam_registry,
    caption=MECHANISM.caption,
    notes=MECHANISM.notes,
    ratios=True,
)
