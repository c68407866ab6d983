"""The parallel crank and its outline."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from kurbel.drive.crank import Crank
from kurbel.drive.load import PistonForce
from kurbel.exact.certify import Kind
from kurbel.kernel.circle import Circle
from kurbel.kernel.linkage import Place
from kurbel.kernel.parallel import coupler_place
from kurbel.linkage.linkage import Linkage, Outline, Point, Stand
from kurbel.page.quantity import words

CHANGE_POINTS = (Fraction(0), Fraction(180))
"""The angles from the line of shafts at which a parallel crank may fold into the antiparallel crank."""
# In units of R. The motion is the same whatever the distance of the shafts; this one parts the circles.
SHAFTS = 3.0
TITLE = words("Parallelkurbel|Parallel crank")


@dataclass(frozen=True, slots=True)
class ParallelCrank(Linkage):
    """A parallel crank; its motion in units of R is that of a crank with an infinite rod, square to it too.

    The radius R in metres and the force of the rod on a crank in newtons may be known. The motion depends on
    no length.
    """

    radius: Fraction | None = None
    force: PistonForce | None = None

    def place(self, stroke: int, circle: Circle[Any], kind: Kind) -> Place[Any]:
        """Return where any point of the rod stands, which moves alike on both strokes."""
        return coupler_place(circle)

    @property
    def crank(self) -> Crank:
        return Crank(Fraction(0), radius=self.radius, force=self.force)

    def outline(self) -> Outline:
        return Outline(TITLE, ((0, 0), (SHAFTS, 0)), -1, SHAFTS + 1, _stand)


def _stand(pin: Point) -> Stand:
    shaft, other, second = (0.0, 0.0), (SHAFTS, 0.0), (pin[0] + SHAFTS, pin[1])
    return Stand(
        {"crank": (shaft, pin), "second_crank": (other, second), "rod": (pin, second)},
        (pin, second),
        ((shaft, pin, second, other),),
        (("second_crank", "$R$", 0.68), ("rod", "$L$", 0.5)),
        ((0, SHAFTS, "$L$"),),
    )
