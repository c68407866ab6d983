"""The arc crank as conditions see it: dead centres off the slide direction, and paths that are arcs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import cache
from math import pi, tan
from typing import Any

from flint import arb

from kurbel.exact.certify import FLOAT_BITS, at_bits, ball, half_turn_circle
from kurbel.exact.certify import pi as ball_pi
from kurbel.exact.course import Course
from kurbel.exact.kind import balls
from kurbel.exact.place import SQUARE, Centre, Place
from kurbel.linkage.arc.quantities import arc_registry
from kurbel.linkage.arc.rocker import STROKE, RockerCrank
from kurbel.linkage.mechanism import LinkageDrive
from kurbel.motion.evaluation import OUT, STROKES
from kurbel.motion.quantities import registry
from kurbel.page.quantity import Formula, Quantity

PATH_SHARE = "path_stroke"
# Half turns about the middle of the stroke within which t = tan ½(φ - 90°) stays far from infinity.
HALF_REACH = 0.45


@cache
def arc_columns() -> Mapping[str, Quantity]:
    """Return what can be shown of a place: the outstroke's quantities, which stand for either stroke."""
    return with_share({key: one for key, one in arc_registry().items() if one.stroke == OUT})


def with_share(own: Mapping[str, Quantity]) -> Mapping[str, Quantity]:
    """Return the quantities with the path's share of the stroke."""
    path, share = own["path"], registry()["x_stroke"]
    kernel = path.formulas["exact"].kernel
    part = path._replace(
        key=PATH_SHARE,
        heading=share.heading,
        unit=share.unit,
        names=share.names,
        formulas={"exact": Formula(lambda at: kernel(at) / at.drive.arc_stroke(at.numbers))},
    )
    return {"path": path, PATH_SHARE: part, **own}


class ArcDrive(LinkageDrive):
    """The arc crank."""

    def __init__(self, crank: RockerCrank, page: str = "arc") -> None:
        super().__init__(crank, page)
        self.arc = crank
        self.centre = self._centre()

    @staticmethod
    def columns_of(page: str) -> Mapping[str, Quantity]:
        return arc_columns()

    @property
    def is_straight(self) -> bool:
        return False

    def _centre(self) -> Centre:
        with at_bits(FLOAT_BITS):
            ends = [float(place().mid()) for stroke in STROKES for place in self._dead_angles(stroke)]
        if min(ends) > -HALF_REACH and max(ends) < 1 + HALF_REACH:
            return SQUARE
        middle = (min(ends) + max(ends)) / 2
        turns = round(middle / 2)
        return Centre(Fraction(tan(pi * (middle / 2 - turns))).limit_denominator(10), turns)

    def is_free(self, quantity: Quantity) -> bool:
        return quantity.of != STROKE and super().is_free(quantity)

    def ends(self, stroke: int) -> tuple[Place, Place]:
        return self.rests(self.asked("velocity", stroke), self._dead_angles(stroke))

    def unclosed(self, quantity: Quantity, course: Course) -> Course:
        velocity = self.asked("velocity", quantity.stroke)

        def rise(half_turns: arb) -> Any:
            return self.value(velocity, half_turn_circle(half_turns), balls()) * self._gauge(quantity)

        ends = {"path": (Fraction(0), None), PATH_SHARE: (Fraction(0), Fraction(1))}
        return replace(course, slope=rise, ends=ends.get(quantity.key, (None, None)))

    def _dead_angles(self, stroke: int) -> tuple[Callable[[], arb], Callable[[], arb]]:
        def begin() -> Any:
            return self.arc.dead_angle(stroke, balls()) / 180

        return begin, lambda: begin() + 1 + stroke * self.arc.lead(balls()) / 180

    def _gauge(self, quantity: Quantity) -> Any:
        """Return by how much the path, its share or the rocker's angle grows in half a turn at v = 1."""
        if quantity.key == "path":
            return ball_pi()
        if quantity.key == PATH_SHARE:
            return ball_pi() / self.arc.arc_stroke(balls())
        return ball(-180 * quantity.stroke * self.arc.curvature)
