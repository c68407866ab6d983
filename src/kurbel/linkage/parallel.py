"""The parallel crank: two equal cranks, joined by a rod as long as their shafts are apart."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from kurbel.drive.combination import PARALLEL
from kurbel.drive.crank import Crank
from kurbel.exact.kind import Kind
from kurbel.kernel.circle import Circle
from kurbel.kernel.linkage import Place
from kurbel.kernel.parallel import coupler_place

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
    def name(self) -> str:
        return PARALLEL

    def place(self, stroke: int, circle: Circle[Any], kind: Kind) -> Place[Any]:
        """Return where any point of the rod stands, which moves alike on both strokes."""
        return coupler_place(circle)

    @property
    def crank(self) -> Crank:
        return Crank(Fraction(0), radius=self.radius, force=self.force)
