"""The pages of points of the rod: what is asked for, what they say of it, records, subject."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from typing import Any, Self

from kurbel.drive.crank import Diameters
from kurbel.drive.mechanisms import MECHANISMS
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label, Number
from kurbel.kernel.circle import Circle, Numeric
from kurbel.motion.bulk import long_records
from kurbel.motion.captions import formula_lines
from kurbel.motion.evaluation import METHODS, OFFSET, RETURN, columns_in_balls
from kurbel.motion.mechanism import Mechanism, mechanism
from kurbel.motion.motion_page import CURVES, AngleQuestion, check_pairs
from kurbel.motion.motion_quantities import registry
from kurbel.motion.point_quantities import (
    BESIDE,
    MovedPoint,
    RodEnds,
    Vectorial,
    acceleration,
    continued,
    path,
    points_registry,
    vector_of,
    velocity,
)
from kurbel.motion.points import RodPoint, decimals_of, with_points
from kurbel.page.axes import AngleAxis, ColumnAxis, ListAxis, Place, RatioAxis
from kurbel.page.layouts import Layout, LayoutColumn
from kurbel.page.quantity import Column, Of, Quantity, Texts, bare, words
from kurbel.page.steps import Scene
from kurbel.page.subject import Subject
from kurbel.page.subject import subject as registered
from kurbel.page.table import Field

WORDS = Texts("motion", "points")


def notes(question: PointsRequest) -> Iterator[Label]:
    """Yield the lines below the table: where the point is, formulas, zeros and signs, the machine."""
    lang, layout = question.lang, question.layout
    shown = [one.quantity for one in question.page_columns if one.key in points_registry()]
    beside = any(one.beside for one in question.points)
    driven = WORDS["crosshead" if question.mechanism.crosshead else "rocker"][lang]
    if question.has_ratio:
        said = WORDS["point"][lang].format(driven=driven)
        yield said + (WORDS["beside"][lang] if beside else "")
    if layout.formulas:
        yield from _formulas(question, shown)
    if shown:
        yield from _directions(question, shown)
    turning = (one.direction[lang] for one in _beside(question) if one.direction)
    if directions := "; ".join(dict.fromkeys(turning)):
        yield directions
    yield from question.mechanism.rod_notes(question.drives, lang)
    if question.mechanism.crosshead and not all(question.ratios):
        yield WORDS["ellipse"][lang]


def _formulas(question: PointsRequest, shown: Sequence[Quantity]) -> Iterator[Label]:
    """Yield how the point's vectors follow from those of the ends of the rod."""
    lang, beside = question.lang, any(one.beside for one in question.points)
    if not question.has_ratio and shown:
        yield WORDS["circle"][lang]
    if not question.has_ratio:
        return
    if question.mechanism.crosshead:
        offset = any(one.crank.offset for one in question.drives)
        key = (OFFSET if offset else "exact") + (BESIDE if beside else "")
        if shown:
            yield ", ".join(dict.fromkeys(one.formulas[key].printed for one in shown))
        yield from _of_crosshead(question, shown)
        return
    if shown:
        yield WORDS["vectors"][lang] + (WORDS["turned"][lang] if beside else "")
    own = dict.fromkeys(one.formulas["exact"].printed for one in shown if one.of is not Of.ANY)
    if own:
        yield ", ".join(own)


def _beside(question: PointsRequest) -> list[Quantity]:
    """Return what the page shows of the drive beside its points."""
    return [one.quantity for one in question.page_columns if one.key not in points_registry()]


_CROSSHEAD: Mapping[Vectorial, str] = {path: "x", velocity: "c", acceleration: "p"}


def _of_crosshead(question: PointsRequest, shown: Sequence[Quantity]) -> Iterator[Label]:
    """Yield the formulas of the crosshead's motion that stand in these, and those of what stands beside them,
    as pages of that print them."""
    keys = dict.fromkeys(_CROSSHEAD[vector_of(one)] for one in shown)
    asked = [*(registry()[key] for key in keys), *(one for one in _beside(question) if one.key not in keys)]
    columns = [bare(one, question.method or "exact", None) for one in asked]
    yield from formula_lines(question, columns)


def _directions(question: PointsRequest, shown: Sequence[Quantity]) -> Iterator[Label]:
    """Yield from where and in which directions vectors count."""
    lang = question.lang
    ways = ("along", "across") if question.has_ratio else ("shafts",)
    yield "; ".join(WORDS[key][lang] for key in (*ways, "signs"))
    if any(one.of is Of.DIRECTION for one in shown):
        yield WORDS["directions"][lang]


# What stands beside points: of the rod, of the driven end, of the rocker.
OF_DRIVE = (
    *("x", "c", "p", "psi", "rod_velocity", "rod_acceleration", "time", "rod_along", "slowest_point"),
    *(f"{pin}_rubbing" for pin in Diameters._fields),
    *("path", "rocker", "rod", "turn_velocity", "turn_acceleration"),
)
_UNITS = ("_mm", "_mps", "_mps2", "_radps", "_radps2")


@cache
def of_drive(name: str) -> Mapping[str, Quantity]:
    """Return what a page of points can show of a mechanism, over the whole turn."""
    known = registered(mechanism(name).subject).quantities()
    keys = (key for one in OF_DRIVE for key in (one, *(f"{one}{unit}" for unit in _UNITS)))
    return {
        key: one._replace(part=None, spanners=tuple(label for label in one.spanners if label != one.part))
        for key in keys
        if (one := known.get(key)) is not None and one.stroke != RETURN
    }


@cache
def quantities() -> Mapping[str, Quantity]:
    """Return what pages of points can show, of all mechanisms that have a rod."""
    found = dict(points_registry())
    for name in MECHANISMS:
        if mechanism(name).rod:
            for key, one in of_drive(name).items():
                found.setdefault(key, one)
    return found


POINT = words("Punkt der Schubstange|Point of the rod")
RATIO = "ratio"


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class PointsRequest(AngleQuestion):
    """What is asked for of these points on the rods of these drives, alike but for their ratios, at these
    angles. By the method of the infinite rod all ratios are 1:∞."""

    mechanism: Mechanism
    points: tuple[RodPoint, ...]
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
    def caption_parts(self) -> Mapping[str, Label]:
        rod = WORDS["rod" if self.has_ratio else "parallel"][self.lang]
        of = WORDS["one" if len(self.points) == 1 else "several"][self.lang]
        method = METHODS[self.method or "exact"].caption[self.lang]
        points = of.format(point=self.points[0].label, rod=rod)
        return {**super().caption_parts, "{points}": points, "{method}": method}

    @property
    def subject(self) -> Subject[Self]:
        return SUBJECT if self.has_ratio else RODLESS

    @property
    def moving(self) -> tuple[str, Any]:
        return self.mechanism.name, self.drives[0]

    def carrying(self, scene: Scene | None, whole: Callable[[], Scene | None] | None = None) -> Scene | None:
        return None if scene is None else with_points(scene, self.points, whole and whole())

    def methods_of(self, column: LayoutColumn) -> tuple[str, ...]:
        return (self.method or "exact",)

    def entry(self, key: str) -> Quantity:
        own = points_registry().get(key) or of_drive(self.mechanism.name).get(key)
        return super().entry(key) if own is None else own

    def missing(self, quantity: Quantity) -> str:
        if quantity.key in points_registry() or quantity.key in of_drive(self.mechanism.name):
            return super().missing(quantity)
        return f"column {quantity.key} belongs to another mechanism; leave it out"

    def too_long(self) -> str:
        return f"{len(self.points)} points at {len(self.angles)} angles make a table of {len(self)} rows"

    def moved(self, place: Mapping[str, int]) -> MovedPoint:
        """Return the point at a place on its drive."""
        ends: RodEnds = self.mechanism.rod_ends()
        return MovedPoint(
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

    def value(self, column: Column, place: Mapping[str, int], point: Circle[Any], kind: Kind) -> Numeric:
        if column.key not in points_registry():
            return super().value(column, place, point, kind)
        return self.moved(place).value(column.quantity, point, kind)

    def curve(self, column: Column, place: Mapping[str, int], point: Circle[Any], kind: Kind) -> Numeric:
        values, quantity = super().curve(column, place, point, kind), column.quantity
        if quantity.of is not Of.DIRECTION:
            return values
        # A direction has gaps where the point rests.
        amount = points_registry()[quantity.key.removesuffix("_direction")]
        return continued(values, self.moved(place).value(amount, point, kind))


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


def _number(question: PointsRequest, column: Column, place: Place, times: int) -> Number | None:
    moved, angle = question.moved(place), question.angles[place["angle"]]
    if column.key in points_registry():
        scaled = moved.certified(column.quantity, angle, column.places, question.rounding)
    else:
        [[scaled]] = columns_in_balls([column], moved.drive, [angle], question.rounding)
    return None if scaled is None else Number(scaled * times, column.places)


SUBJECT = Subject(
    key="rod points",
    layout="rod-points",
    command="table --point 0.5",
    axes={RATIO: RatioAxis, "point": PointAxis, "angle": AngleAxis, "column": ColumnAxis},
    axis_keys=(RATIO, "point", "phi"),
    quantities=quantities,
    number=_number,
    notes=notes,
    rows=long_records,
    listed=lambda: [("table --point 0.5", one) for one in points_registry().values()],
    drawn=CURVES,
)
RODLESS = SUBJECT._replace(
    axes={"point": PointAxis, "angle": AngleAxis, "column": ColumnAxis}, axis_keys=("point", "phi")
)
"""The same of a drive whose motion does not depend on the length of its rod."""
