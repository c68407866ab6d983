"""The pages of points of the rod: what is asked for, records, subject."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, floats
from kurbel.exact.numerals import Label, Number
from kurbel.kernel.circle import Circle, circle
from kurbel.motion.evaluation import NEEDS
from kurbel.motion.page import CURVES, AngleQuestion, check_pairs, long_records
from kurbel.motion.points import captions
from kurbel.motion.points.digits import Ends, Moved
from kurbel.motion.points.direction import continued
from kurbel.motion.points.point import Point, decimals_of
from kurbel.motion.points.quantities import DIRECTION, points_registry
from kurbel.page.axes import AngleAxis, ColumnAxis, ListAxis, Place, RatioAxis
from kurbel.page.layouts import Layout, LayoutColumn
from kurbel.page.quantity import Column, Quantity, words
from kurbel.page.subject import Subject
from kurbel.page.table import Field

if TYPE_CHECKING:
    from kurbel.motion.mechanism import Mechanism
    from kurbel.page.steps import Scene

POINT = words("Punkt der Schubstange|Point of the rod")
RATIO = "ratio"


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class PointsRequest(AngleQuestion):
    """What is asked for of these points on the rods of these drives, alike but for their ratios, at these
    angles. By the method of the infinite rod all ratios are 1:∞."""

    mechanism: Mechanism
    points: tuple[Point, ...]
    method: str | None = None

    def check(self) -> None:
        super().check()
        check_pairs(self.layout, "points of the rod")
        if self.method == "infinite":
            drives = (replace(one, ratio=Fraction(0)) for one in self.drives)
            object.__setattr__(self, "drives", tuple(dict.fromkeys(drives)))
        elif self.method == "series" and any(one.crank.offset for one in self.drives):
            raise ProblemError(
                'method "series" has no formulas for an offset crank; use exact, or leave the offset out'
            )
        if self.has_ratio and any(one.beside for one in self.points):
            self._check_finite()
        if not self.has_ratio and self.layout.subject == SUBJECT.key:
            object.__setattr__(self, "layout", _without_ratio(self.layout))

    def _check_finite(self) -> None:
        if all(one.crank.ratio for one in self.drives):
            return
        raise ProblemError(
            "a point beside the axis of an infinite rod is infinitely far from it, for it stands there so"
            " many rod lengths; give a point on the axis, such as --point 0.5, or the rod a length"
        )

    @property
    def has_ratio(self) -> bool:
        """Whether the motion depends on the length of the rod."""
        return RATIO in self.mechanism.takes

    @property
    def subject(self) -> Subject:
        return SUBJECT if self.has_ratio else RODLESS

    @property
    def moving(self) -> tuple[str, Any]:
        return self.mechanism.name, self.drives[0]

    def carrying(self, scene: Scene | None, whole: Callable[[], Scene | None] | None = None) -> Scene | None:
        from kurbel.motion.points.carried import with_points

        return None if scene is None else with_points(scene, self.points, whole and whole())

    def methods_of(self, column: LayoutColumn) -> tuple[str, ...]:
        return (self.method or "exact",)

    def too_long(self) -> str:
        return f"{len(self.points)} points at {len(self.angles)} angles make a table of {len(self)} rows"

    def moved(self, place: Mapping[str, int]) -> Moved:
        """Return the point at a place on its drive."""
        ends: Ends = self.mechanism.rod_ends()
        return Moved(
            ends, self.drives[place.get(RATIO, 0)], self.method or "exact", self.points[place["point"]]
        )

    @property
    def places(self) -> list[dict[str, int]]:
        """All points on all drives, in the order of records."""
        return [
            {RATIO: drive, "point": point}
            for drive in range(len(self.drives))
            for point in range(len(self.points))
        ]

    @property
    def told(self) -> list[tuple[Label, ...]]:
        return [(*drive, one.label) for drive in super().told for one in self.points]

    def value(self, column: Column, place: Mapping[str, int], point: Circle[Any], kind: Kind) -> Any:
        return self.moved(place).value(column.quantity, point, kind)

    def curves(self, degrees: Any) -> list[list[Any]]:
        point, kind, moved = circle(degrees), floats(), [self.moved(place) for place in self.places]
        return [[_curve(column.quantity, one, point, kind) for one in moved] for column in self.page_columns]


def _without_ratio(page: Layout) -> Layout:
    """Return the layout of drives whose motion does not depend on a ratio."""
    own = vars(page)
    left = {name: tuple(one for one in own[name] if one != RATIO) for name in ("down", "stub", "across")}
    return Layout(**{**own, **left, "ratios": ()})


class PointAxis(ListAxis):
    """The points of the rod."""

    def __init__(self, question: PointsRequest) -> None:
        decimals, name = decimals_of(question.points), POINT[question.lang]
        super().__init__(
            question.points,
            Field("point", name, "$s$", "", decimals),
            lambda one: one.value(decimals),
            lambda one: one.label,
        )

    def over_group(self, place: Place) -> Label:
        point: Point = self._things[place["point"]]
        return point.label


def _curve(quantity: Quantity, moved: Moved, at: Any, kind: Kind) -> Any:
    """Return a column over the crank angle, as floats; a direction has gaps where the point rests."""
    values = moved.value(quantity, at, kind)
    if quantity.of != DIRECTION:
        return values
    amount = points_registry()[quantity.key.removesuffix("_direction")]
    return continued(values, moved.value(amount, at, kind))


def _number(question: PointsRequest, column: Column, place: Place, times: int) -> Number | None:
    moved, angle = question.moved(place), question.angles[place["angle"]]
    scaled = moved.certified(column.quantity, angle, column.places, question.rounding)
    return None if scaled is None else Number(scaled * times, column.places)


SUBJECT = Subject(
    key="rod points",
    layout="rod-points",
    command="table --point 0.5",
    axes={RATIO: RatioAxis, "point": PointAxis, "angle": AngleAxis, "column": ColumnAxis},
    axis_keys=(RATIO, "point", "phi"),
    quantities=points_registry,
    number=_number,
    caption=captions.caption,
    notes=captions.notes,
    rows=long_records,
    options=NEEDS,
    drawn=CURVES,
)
RODLESS = SUBJECT._replace(
    axes={"point": PointAxis, "angle": AngleAxis, "column": ColumnAxis}, axis_keys=("point", "phi")
)
"""The same of a drive whose motion does not depend on the length of its rod."""
