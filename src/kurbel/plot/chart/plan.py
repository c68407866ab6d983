"""A panel before it is drawn: its height, its heading, its legend, and where its labels have room."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from kurbel.plot.chart.course import Course
from kurbel.plot.chart.legend import LEGEND_GAP, LEGEND_ROW, SAMPLE, SAMPLE_GAP
from kurbel.plot.chart.model import Panel
from kurbel.plot.place import AROUND, BESIDE, Box, Points, around, beside, box_points, densely, freest
from kurbel.plot.style import SMALL_TEXT, TEXT_SIZE, WIDTH, in_rows, size_of, text_of
from kurbel.plot.ticks import axis_label

# In mm: the numbers stand left of the panels, the quantity and the legend above each.
LEFT, RIGHT, ABOVE, BARE, BELOW = 13.0, 4.0, 7.5, 3.0, 10.5
PANEL_WIDTH = WIDTH - LEFT - RIGHT
# More labels than these beside the curves are harder to read than a legend.
MOST_LABELS = 4
# The radius of the mark of a spot, and the room for its text above a curve or below it.
SPOT, SPOT_ROW = 0.55, 5.5
# The share of the panel's height above the curves and below them.
EDGE = 0.045
# A share of the span of values below which a value is that of the frame.
NEAR = 1e-9


class Room(NamedTuple):
    """What a panel has: its width and height in mm, what stands between it and its heading, and beside this
    at the right, and the angles at which lines lead through it; where they are settled, the ends of the
    axis of values."""

    width: float
    height: float
    strip: float = 0.0
    said: str = ""
    ends: tuple[float, ...] = ()
    limits: tuple[float, float] | None = None


class Written(NamedTuple):
    """A text in the panel with its centre in mm from the lower left."""

    text: str
    place: Points
    points: float

    @property
    def box(self) -> Box:
        size = np.asarray(size_of(self.text, self.points))
        (left, bottom), (right, top) = self.place - size / 2, self.place + size / 2
        return float(left), float(bottom), float(right), float(top)


class Plan(NamedTuple):
    """A panel with all that must be known before the page is laid out; places in mm from its lower left."""

    panel: Panel
    courses: Sequence[Course]
    span: tuple[float, float]
    limits: tuple[float, float]
    room: Room
    heading: str
    texts: tuple[str, ...]
    labels: Sequence[Written] | None
    spots: Sequence[Written]
    columns: int
    # Whether the legend stands above the heading, not beside it.
    apart: bool = False

    @property
    def size(self) -> tuple[float, float]:
        return self.room.width, self.room.height

    def top(self) -> float:
        """Return what heading, strip and legend need above the panel."""
        heading = ABOVE + LEGEND_ROW * self.heading.count("\n") if self.heading or self.room.said else BARE
        if self.columns:
            rows = math.ceil(len(self.texts) / self.columns)
            heading += LEGEND_ROW * (rows if self.apart else rows - 1)
        return heading + self.room.strip + (LEGEND_ROW if self.said_apart else 0)

    @property
    def said_apart(self) -> bool:
        """Whether what is said at the right stands in a row of its own, above all others."""
        if not self.room.said:
            return False
        both = size_of(self.heading.split("\n")[0])[0] + LEGEND_GAP + size_of(self.room.said)[0]
        return bool(self.columns) or "\n" in self.heading or both > self.room.width

    def on_paper(self, course: Course) -> Points:
        """Return the points of a course in mm from the panel's lower left corner."""
        points = np.stack(course, axis=1)
        low, high = (np.asarray(ends) for ends in zip(self.span, self.limits, strict=True))
        return np.asarray((points - low) / (high - low) * self.size)

    def in_values(self, course: Course) -> Course:
        """Return angles and values of a course in mm."""
        (first, last), (low, high) = self.span, self.limits
        width, height = self.size
        return Course(
            first + course.angles * (last - first) / width, low + course.values * (high - low) / height
        )


def plan_of(panel: Panel, span: tuple[float, float], room: Room, mark: str) -> Plan:
    courses = [Course.of(curve) for curve in panel.curves]
    heading = in_rows(text_of(axis_label(panel.label, panel.unit, panel.power), mark), room.width)
    texts = tuple(text_of(curve.label, mark) for curve in panel.curves)
    limits = room.limits or _limits(courses, SPOT_ROW / room.height if panel.spots else EDGE)
    plan = Plan(panel, courses, span, limits, room, heading, texts, None, (), 0)
    if any(texts):
        labels = _labels(plan) if len(texts) <= MOST_LABELS else None
        plan = plan._replace(labels=labels) if labels else with_legend(plan)
    return with_spots(plan, mark)


def _limits(courses: Sequence[Course], edge: float) -> tuple[float, float]:
    """Return the ends of the axis of values, beyond the curves by a share of the panel's height; the frame is
    the zero line where all are on one side of it."""
    values = np.concatenate([course.values for course in courses])
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    edge = min(edge, 0.25)
    room, near = (
        edge / (1 - 2 * edge) * (high - low) or 0.1 * abs(high) or 1.0,
        NEAR * max(abs(low), abs(high)),
    )
    least, greatest = low - room, high + room
    if high > near and abs(low) <= near:
        least = 0.0
    elif low < -near and abs(high) <= near:
        greatest = 0.0
    return least, greatest


def with_one_legend(plans: list[Plan]) -> list[Plan]:
    """Return the plans with a legend in the first panel alone, where one of like panels needs one."""
    if len({plan.texts for plan in plans}) > 1 or not any(plan.columns for plan in plans):
        return plans
    return [with_legend(plans[0]), *(plan._replace(labels=None, columns=0) for plan in plans[1:])]


def with_legend(plan: Plan) -> Plan:
    """Return the plan with a legend beside the heading or, where the two do not fit beside, above it."""
    width = plan.room.width
    widest = max(size_of(text)[0] for text in plan.texts) + SAMPLE + SAMPLE_GAP + LEGEND_GAP
    beside = 0 if "\n" in plan.heading else int((width - size_of(plan.heading)[0]) / widest)
    most, count = beside or max(1, int((width + LEGEND_GAP) / widest)), len(plan.texts)
    # Rows of equal length: three and three, not four and two.
    columns = math.ceil(count / math.ceil(count / most))
    return plan._replace(labels=None, columns=columns, apart=not beside)


def _labels(plan: Plan) -> Sequence[Written] | None:
    """Return where labels beside the curves have room, or None unless all have."""
    lines = _lines(plan)
    jumps = (densely(plan.on_paper(course.jumps())) for course in plan.courses)
    taken = [_zero(plan), *jumps, *_dots(plan), *_ends(plan), *_levels(plan)]
    written = []
    for line, text in zip(lines, plan.texts, strict=True):
        if not text:
            continue
        size = size_of(text)
        others = np.concatenate([*(other for other in lines if other is not line), *taken])
        place = freest(beside(line, size), size, line, others, (0, 0, *plan.size), BESIDE)
        if place is None:
            return None
        written.append(Written(text, place, TEXT_SIZE))
        taken.append(box_points(place, size))
    return written


def with_spots(plan: Plan, mark: str) -> Plan:
    """Return the plan with the texts of its spots, as far as these have room."""
    lines = [*_lines(plan), _zero(plan)]
    written: list[Written] = []
    taken = [*_dots(plan), *_ends(plan), *_levels(plan), *(_box(one) for one in plan.labels or ())]
    for spot in plan.panel.spots:
        text = text_of(spot.text, mark)
        if not text or any(one.text == text for one in written):
            continue
        (at,) = plan.on_paper(Course(np.asarray([spot.angle]), np.asarray([spot.value])))
        size, line = size_of(text, SMALL_TEXT), np.concatenate(lines)
        outward = np.asarray((0.0, -1.0 if at[1] < plan.room.height / 2 else 1.0))
        others = np.concatenate([np.empty((0, 2)), *taken])
        others = others[np.hypot(*(others - at).T) > 2 * SPOT]
        place = freest(around(at, size, outward), size, line, others, (0, 0, *plan.size), AROUND)
        if place is not None:
            written.append(Written(text, place, SMALL_TEXT))
            taken.append(_box(written[-1]))
    return plan._replace(spots=tuple(written))


def _lines(plan: Plan) -> list[Points]:
    return [densely(plan.on_paper(course.broken())) for course in plan.courses]


def _zero(plan: Plan) -> Points:
    return densely(plan.on_paper(Course.level(plan.span)))


def _ends(plan: Plan) -> Iterable[Points]:
    """Yield the points of the lines that lead through the panel."""
    for end in plan.room.ends:
        yield densely(plan.on_paper(Course(np.full(2, end), np.asarray(plan.limits))))


def _levels(plan: Plan) -> Iterable[Points]:
    """Yield the points of the lines to the arrow of a swing."""
    for value in (plan.panel.swing.least, plan.panel.swing.greatest) if plan.panel.swing else ():
        yield densely(plan.on_paper(Course.level(plan.span, value)))


def _dots(plan: Plan) -> Iterable[Points]:
    """Yield the points around the marks of the spots."""
    for spot in plan.panel.spots:
        (at,) = plan.on_paper(Course(np.asarray([spot.angle]), np.asarray([spot.value])))
        yield box_points(at, (2 * SPOT, 2 * SPOT))


def _box(one: Written) -> Points:
    left, bottom, right, top = one.box
    return box_points(one.place, (right - left, top - bottom))
