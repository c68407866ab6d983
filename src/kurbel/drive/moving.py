"""The moving masses of a crank drive, checked once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from kurbel.drive.crank_forces import Weights
from kurbel.drive.rod import Rod
from kurbel.errors import ProblemError
from kurbel.kernel.rod import Masses, joined
from kurbel.reading.notation import about

HEAVIEST = 10**9


@dataclass(frozen=True, slots=True)
class Moving:
    """The moving masses of one crank drive in kg: piston and crosshead, the rod, and `rotating`, the crank's
    own at its pin, which is negative where counterweights outweigh it.
    """

    reciprocating: Fraction
    rod: Rod | None = None
    rotating: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        if not 0 <= self.reciprocating <= HEAVIEST:
            raise ProblemError(
                f"the reciprocating mass is {about(self.reciprocating)} kg; it must lie within 0..10^9 kg"
            )
        if self.rod is not None and self.rod.mass is None:
            raise ProblemError("the rod's masses are shares; add its mass in kg, --rod-mass")
        if abs(self.rotating) > HEAVIEST:
            raise ProblemError(
                f"the rotating mass is {about(self.rotating)} kg; it must lie within -10^9..10^9 kg"
            )

    @property
    def joined(self) -> Masses[Fraction]:
        """The masses of rod and reciprocating parts, in kg."""
        if self.rod is None:
            return Masses(Fraction(0), self.reciprocating, Fraction(0))
        return joined(self.rod.masses("exact", Fraction), self.rod.mass, self.reciprocating)

    def weights(self, of: Callable[[Fraction], Any], factor: Any) -> Weights:
        """Return the masses times a factor, in a kind of number."""
        masses = Masses(*(of(Fraction(part)) * factor for part in self.joined))
        return Weights(masses, of(self.reciprocating) * factor, of(self.rotating) * factor)
