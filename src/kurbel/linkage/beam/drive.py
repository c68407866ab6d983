"""The beam engine as conditions see it: an arc crank whose formulas no polynomial with rational numbers has.

Where a quantity rises and falls is therefore proved by balls: all zeros of its slope are enclosed
(`roots.isolate`), and a value that is just reached stays unsettled.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from kurbel.exact.course import Course
from kurbel.exact.place import Place
from kurbel.linkage.arc.drive import ArcDrive, with_share
from kurbel.linkage.beam.crank import BeamCrank
from kurbel.linkage.beam.quantities import beam_registry
from kurbel.motion.evaluation import OUT
from kurbel.page.quantity import Quantity

# What is zero at the dead centres.
AT_REST = ("velocity", "tangential_force", "torque")


@cache
def beam_columns() -> Mapping[str, Quantity]:
    """Return what can be shown of a place: the outstroke's quantities, which stand for either stroke."""
    return with_share({key: one for key, one in beam_registry().items() if one.stroke == OUT})


class BeamDrive(ArcDrive):
    """The beam engine."""

    def __init__(self, crank: BeamCrank, page: str = "beam") -> None:
        super().__init__(crank, page)

    @staticmethod
    def columns_of(page: str) -> Mapping[str, Quantity]:
        return beam_columns()

    def is_free(self, quantity: Quantity) -> bool:
        return False

    def ends(self, stroke: int) -> tuple[Place, Place]:
        begin, end = (Place(angle, self.centre) for angle in self._dead_angles(stroke))
        return begin, end

    def _course(self, quantity: str, stroke: int) -> Course:
        one = self.asked(quantity, stroke)
        if one.rises:
            return super()._course(quantity, stroke)
        return self.by_balls(one, stroke, *AT_REST)
