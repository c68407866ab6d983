"""The arc crank as courses of its quantities over both strokes, with certified digits at any place."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cache, cached_property
from math import pi, tan
from typing import TYPE_CHECKING, Any

from kurbel.exact.certify import NEVER_TIES, ball, half_turn_circle, rounded
from kurbel.exact.certify import pi as ball_pi
from kurbel.exact.course import Course
from kurbel.exact.jet import Jet, ball_jets, jets
from kurbel.exact.kind import balls, surds
from kurbel.exact.place import SQUARE, Centre, Place
from kurbel.exact.surd import Field
from kurbel.kernel.circle import Circle
from kurbel.linkage import evaluation as linkage
from kurbel.linkage.arc import ArcCrank
from kurbel.linkage.evaluation import STROKE
from kurbel.linkage.quantities import arc_registry
from kurbel.motion.drives import column_named, condition_names, ties_at
from kurbel.motion.evaluation import OUT, STROKES, is_known
from kurbel.motion.quantities import registry
from kurbel.page.quantity import Quantity

if TYPE_CHECKING:
    from flint import arb

PATH_SHARE = "path_stroke"
# Half turns about the middle of the stroke within which t = tan ½(φ - 90°) stays far from infinity.
HALF_REACH = 0.45


@cache
def arc_columns() -> Mapping[str, Quantity]:
    """Return what can be shown of a place: the outstroke's quantities, which stand for either stroke."""
    found = {}
    for key, one in arc_registry().items():
        if one.stroke == OUT:
            found[key] = one
            if key == "path":
                share = registry()["x_stroke"]
                found[PATH_SHARE] = one._replace(
                    key=PATH_SHARE, heading=share.heading, unit=share.unit, names=share.names
                )
    return found


@cache
def arc_names() -> Mapping[str, str]:
    """Return the names that conditions on the arc crank may give quantities."""
    return condition_names(arc_columns().values())


class ArcDrive:
    """The arc crank."""

    method = "exact"

    def __init__(self, crank: ArcCrank) -> None:
        self.crank = crank
        self.ratio = crank.crank.ratio
        self.course = cache(self._course)

    @cached_property
    def columns(self) -> Mapping[str, Quantity]:
        return {key: one for key, one in arc_columns().items() if is_known(one, self.crank.crank)}

    @property
    def names(self) -> Mapping[str, str]:
        return arc_names()

    def column_of(self, quantity: str) -> str:
        return column_named(self.columns, quantity)

    def digits(self, column: str, stroke: int, place: Place, decimals: int, rounding: str) -> int:
        if column != PATH_SHARE and place.degrees is not None:
            quantity = self._quantity(column, stroke)
            return linkage.certified(quantity, self.crank, place.degrees, decimals, rounding)
        ties = NEVER_TIES
        if self._is_free(column):
            ties = ties_at(place, self._jet(column, stroke).value)
        return rounded(
            lambda: self._value(column, stroke, half_turn_circle(place.half_turns())),
            decimals,
            rounding,
            ties,
        )

    @cached_property
    def centre(self) -> Centre:
        """An angle about the middle of both strokes."""
        ends = [float(place().mid()) for stroke in STROKES for place in self._dead_centres(stroke)]
        if min(ends) > -HALF_REACH and max(ends) < 1 + HALF_REACH:
            return SQUARE
        middle = (min(ends) + max(ends)) / 2
        turns = round(middle / 2)
        return Centre(Fraction(tan(pi * (middle / 2 - turns))).limit_denominator(10), turns)

    def _quantity(self, column: str, stroke: int) -> Quantity:
        return self.columns[column]._replace(stroke=stroke)

    def _is_free(self, column: str) -> bool:
        """Whether it is algebraic and needs no root for the dead centre."""
        one = self.columns[column]
        return not one.is_arc and one.of != STROKE

    def _value(self, column: str, stroke: int, at: Circle[Any]) -> Any:
        kind = balls()
        found = linkage.value(self._quantity(column, stroke), self.crank, at, kind)
        return found / linkage.arc_stroke(self.crank, kind) if column == PATH_SHARE else found

    def _jet(self, column: str, stroke: int) -> Jet:
        field = Field()
        at = jets(field.circle(self.centre.tangent))
        found = linkage.direct_value(self._quantity(column, stroke), self.crank, at, surds(field))
        assert isinstance(found, Jet)
        return found

    def _dead_centres(self, stroke: int) -> tuple[Callable[[], arb], Callable[[], arb]]:
        def begin() -> arb:
            found: arb = linkage.dead_angle(self.crank, stroke, balls()) / 180
            return found

        def end() -> arb:
            found: arb = begin() + 1 + stroke * linkage.lead(self.crank, balls()) / 180
            return found

        return begin, end

    def _course(self, quantity: str, stroke: int) -> Course:
        column = self.column_of(quantity)
        velocity = self._jet("velocity", stroke).value.norm()
        begin, end = (Place(one, self.centre, velocity) for one in self._dead_centres(stroke))

        def at(half_turns: arb) -> arb:
            found: arb = self._value(column, stroke, half_turn_circle(half_turns))
            return found

        if self._is_free(column):

            def slope(half_turns: arb) -> arb:
                jet = self._value(column, stroke, ball_jets(half_turns))
                found: arb = jet.slope * ball_pi()
                return found

            jet = self._jet(column, stroke)
            return Course(at, slope, begin, end, jet.value, jet.slope)

        def rise(half_turns: arb) -> arb:
            found: arb = self._value("velocity", stroke, half_turn_circle(half_turns)) * self._gauge(
                column, stroke
            )
            return found

        ends = {"path": (Fraction(0), None), PATH_SHARE: (Fraction(0), Fraction(1))}
        return Course(at, rise, begin, end, ends=ends.get(column, (None, None)))

    def _gauge(self, column: str, stroke: int) -> arb:
        """Return by how much the path, its share or the rocker's angle grows in half a turn at v = 1."""
        if column == "path":
            return ball_pi()
        if column == PATH_SHARE:
            share: arb = ball_pi() / linkage.arc_stroke(self.crank, balls())
            return share
        return ball(-180 * stroke * self.crank.curvature)
