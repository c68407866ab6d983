"""The parallel crank: two equal cranks, joined by a rod as long as their shafts are apart."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from kurbel.drive.crank import Crank

CHANGE_POINTS = (Fraction(0), Fraction(180))
"""The angles from the line of shafts at which a parallel crank may fold into the antiparallel crank."""


@dataclass(frozen=True, slots=True)
class ParallelCrank:
    """A parallel crank; its motion in units of R is that of a crank with an infinite rod, square to it too.

    The radius R in metres and the force of the rod on a crank in newtons may be known.
    """

    radius: Fraction | None = None
    force: Fraction | None = None

    @property
    def crank(self) -> Crank:
        return Crank(Fraction(0), radius=self.radius, force=self.force)
