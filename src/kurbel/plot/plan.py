"""A chart before it is drawn: the ways of its curves, its heights, headings, legends, where its labels have
room, and panels to scale, whose axis and values are as long on paper."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kurbel.errors import ProblemError
from kurbel.plot.panel import Curve, Panel, axis_label
from kurbel.plot.place import AROUND, BESIDE, Box, Points, around, beside, box_points, densely, freest
from kurbel.plot.style import MM, PALE, SMALL_TEXT, TEXT_SIZE, THIN, Size, in_rows, size_of, text_of

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

LEGEND_ROW, SAMPLE, SAMPLE_GAP, LEGEND_GAP = 4.2, 9.0, 1.5, 4.0
Corner = Literal["lower left", "lower right"]


def draw_legend(
    axes: Axes, drawn: Sequence[Artist], texts: Sequence[str], columns: int, above: float, corner: Corner
) -> None:
    """Draw the legend of lines, at a height above the frame that is a share of the frame's."""
    in_sizes = MM / TEXT_SIZE
    # matplotlib fills the columns one after the other; we read along the rows.
    order = [place for column in range(columns) for place in range(len(drawn))[column::columns]]
    axes.legend(
        [drawn[place] for place in order],
        [texts[place] for place in order],
        loc=corner,
        bbox_to_anchor=(corner == "lower right", 1 + above),
        ncols=columns,
        frameon=False,
        handlelength=SAMPLE * in_sizes,
        handletextpad=SAMPLE_GAP * in_sizes,
        columnspacing=LEGEND_GAP * in_sizes,
        labelspacing=0.35,
        borderaxespad=0,
        borderpad=0.3,
    )


def lined(axes: Axes) -> None:
    """Draw the lines of ticks, pale and below all else."""
    axes.grid(color=PALE, linewidth=THIN)
    axes.set_axisbelow(True)
    axes.tick_params(width=THIN, length=2, pad=2, labelsize=SMALL_TEXT)


class Course(NamedTuple):
    """The angles and values of a curve, with NaN for what is not finite."""

    angles: Points
    values: Points

    @classmethod
    def of(cls, curve: Curve) -> Course:
        values = np.asarray(curve.values, float)
        return cls(np.asarray(curve.angles, float), np.where(np.isfinite(values), values, np.nan))

    @classmethod
    def level(cls, span: tuple[float, float], value: float) -> Course:
        """Return one and the same value all over a span."""
        return cls(np.asarray(span), np.full(2, value))

    def broken(self) -> Course:
        """Return the course with a gap in every jump."""
        after = self._after_jumps()
        gaps = np.insert(self.values, after, np.nan)
        return Course(np.insert(self.angles, after, self.angles[after]), gaps)

    def jumps(self) -> Course:
        """Return the jumps alone, with gaps between them."""
        after = self._after_jumps()
        ends = (self.values[after - 1], self.values[after], np.full(len(after), np.nan))
        return Course(np.repeat(self.angles[after], 3), np.stack(ends, axis=1).ravel())

    def at(self, angles: Points) -> Points:
        """Return the values at angles, NaN beyond its ends."""
        return np.asarray(np.interp(angles, self.angles, self.values, left=np.nan, right=np.nan))

    def _after_jumps(self) -> NDArray[np.intp]:
        """Return the numbers of the points after jumps, at the angles of those before."""
        return np.flatnonzero(np.diff(self.angles) == 0) + 1


# In mm: the numbers stand left of the panels, the quantity and the legend above each.
LEFT, RIGHT, ABOVE, BARE, BELOW = 13.0, 4.0, 7.5, 3.0, 10.5
# More labels than these beside the curves are harder to read than a legend.
MOST_LABELS = 4
# The radius of the mark of a spot, and the room for its text above a curve or below it.
SPOT, SPOT_ROW = 0.55, 5.5
# The share of the panel's height above the curves and below them.
EDGE = 0.045
# A share of the span of values below which a value is that of the frame.
NEAR = 1e-9


class PanelRoom(NamedTuple):
    """What a panel has: its width and height in mm, what stands between it and its heading, and beside this
    at the right, and the angles at which lines lead through it; where they are settled, the ends of the
    axis of values."""

    width: float
    height: float
    strip: float = 0.0
    said: str = ""
    ends: tuple[float, ...] = ()
    limits: tuple[float, float] | None = None


class PlacedText(NamedTuple):
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
    room: PanelRoom
    heading: str
    texts: tuple[str, ...]
    labels: Sequence[PlacedText] | None
    spots: Sequence[PlacedText]
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
        return heading + self.room.strip + (LEGEND_ROW if self.legend_is_apart else 0)

    @property
    def legend_is_apart(self) -> bool:
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


def plan_of(panel: Panel, span: tuple[float, float], room: PanelRoom, mark: str) -> Plan:
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


def _labels(plan: Plan) -> Sequence[PlacedText] | None:
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
        written.append(PlacedText(text, place, TEXT_SIZE))
        taken.append(box_points(place, size))
    return written


def with_spots(plan: Plan, mark: str) -> Plan:
    """Return the plan with the texts of its spots, as far as these have room."""
    lines = [*_lines(plan), _zero(plan)]
    written: list[PlacedText] = []
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
            written.append(PlacedText(text, place, SMALL_TEXT))
            taken.append(_box(written[-1]))
    return plan._replace(spots=tuple(written))


def _lines(plan: Plan) -> list[Points]:
    return [densely(plan.on_paper(course.broken())) for course in plan.courses]


def _zero(plan: Plan) -> Points:
    return densely(plan.on_paper(Course.level(plan.span, 0.0)))


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


def _box(one: PlacedText) -> Points:
    left, bottom, right, top = one.box
    return box_points(one.place, (right - left, top - bottom))


# In mm: the room beside the curves in their frame, that above and below, the greatest height of a drawing of
# which none is given, that of a panel without a scale, and the least width of the curves.
SIDE, SCALE_EDGE, MOST_HEIGHT, PLAIN, LEAST = 5.0, 7.0, 185.0, 38.0, 25.0

# From panels, the ends of the axis and the room of each to their plans.
Planned = Callable[[tuple[float, float], Sequence[PanelRoom]], list[Plan]]


class _Extent(NamedTuple):
    """The least and the greatest value of a panel, and its scale if it has one."""

    low: float
    high: float
    scale: float | None

    @classmethod
    def of(cls, panel: Panel) -> _Extent:
        values = np.concatenate([np.asarray(curve.values, float) for curve in panel.curves])
        finite = values[np.isfinite(values)]
        return cls(min(float(finite.min()), 0.0), max(float(finite.max()), 0.0), panel.scale)

    def along(self) -> float:
        """Return its height in units of the axis, 0 without a scale."""
        return (self.high - self.low) / self.scale if self.scale else 0.0

    def room(self, room: PanelRoom, mm: float, more: float) -> PanelRoom:
        """Return the room of the panel with so many mm for a unit of the axis, and so much more height."""
        if not self.scale:
            return room._replace(height=PLAIN)
        height = self.along() * mm + 2 * SCALE_EDGE + more
        middle, half = (self.low + self.high) / 2, height / mm * self.scale / 2
        return room._replace(height=height, limits=(middle - half, middle + half))


def plans_to_scale(
    panels: Sequence[Panel],
    span: tuple[float, float],
    rooms: Sequence[PanelRoom],
    size: Size,
    planned: Planned,
) -> list[Plan]:
    """Return the panels as large as the size allows, or as a page of usual height does; what is wider than
    the curves need is theirs on both sides."""
    extents, way = [_Extent.of(panel) for panel in panels], span[1] - span[0]
    mm = (size.width - LEFT - RIGHT - 2 * SIDE) / way
    most = size.height or (None if size.exact else MOST_HEIGHT)
    plans = _planned(extents, span, rooms, mm, size, planned)
    # Legends may need more rows in less width.
    for _ in range(3 if most else 0):
        assert most is not None
        scaled = sum(extent.along() for extent in extents)
        over = _height(plans) - most
        mm = min(mm, mm - over / scaled) if over > 0 else mm
        if mm * way < LEAST:
            raise ProblemError(
                f"the drawing is {size.width:.6g} mm wide and at most {most:.6g} mm high; these curves, which"
                f" are to scale, need {LEAST + 2 * SIDE + LEFT + RIGHT:.6g} mm of width and more height"
            )
        plans = _planned(extents, span, rooms, mm, size, planned)
    if size.height:
        count = sum(bool(extent.scale) for extent in extents)
        plans = _planned(extents, span, rooms, mm, size, planned, (size.height - _height(plans)) / count)
    return plans


def _planned(
    extents: Sequence[_Extent],
    span: tuple[float, float],
    rooms: Sequence[PanelRoom],
    mm: float,
    size: Size,
    planned: Planned,
    more: float = 0.0,
) -> list[Plan]:
    width = size.width - LEFT - RIGHT if size.exact else (span[1] - span[0]) * mm + 2 * SIDE
    middle, half = sum(span) / 2, width / mm / 2
    own = [
        extent.room(room._replace(width=width), mm, more) for extent, room in zip(extents, rooms, strict=True)
    ]
    return planned((middle - half, middle + half), own)


def _height(plans: Sequence[Plan]) -> float:
    return BELOW + sum(plan.top() + plan.room.height for plan in plans)
