"""What is marked in a panel: areas between curves, by hatching of either slope; spots, the swing of a curve,
strokes and dead centres."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

from kurbel.plot.panel import Strokes
from kurbel.plot.place import Box, Points
from kurbel.plot.plan import SPOT, Course, Plan
from kurbel.plot.style import BLACK, LONG_DASH_DOT, MM, SMALL_TEXT, TEXT_SIZE, THIN, size_of, text_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# In mm: the lines are so far apart, and their ends are found to such a step.
SPACING, STEP = 1.3, 0.03
# What is left free around a label.
MARGIN = 0.5

Taken: TypeAlias = NDArray[np.bool_]


def hatching(
    courses: Sequence[Course], size: tuple[float, float], rising: bool, free: Iterable[Box] = ()
) -> Course:
    """Return lines over the area in which the first course is above the second, or below if not `rising`.

    The courses are in mm on the panel of this size. Lines are at 45°, rising or falling from left to right,
    with gaps between them; the boxes stay free.
    """
    width, height = size
    side = STEP / math.sqrt(2)
    along = np.arange(0, width + height, side)
    pieces = [np.empty((0, 2))]
    for start in np.arange(-height, width, SPACING * math.sqrt(2)):
        across = start + along
        up = along if rising else height - along
        within = (across >= 0) & (across <= width) & (up >= 0) & (up <= height)
        line = np.stack((across[within], up[within]), axis=1)
        pieces.extend(_runs(line, _inside(line, courses, rising) & _outside(line, free)))
    dots = np.concatenate(pieces)
    return Course(dots[:, 0], dots[:, 1])


def _inside(line: Points, courses: Sequence[Course], above: bool) -> Taken:
    first, second = (course.at(line[:, 0]) for course in courses)
    low, high = (second, first) if above else (first, second)
    return (line[:, 1] > low) & (line[:, 1] < high)


def _outside(line: Points, boxes: Iterable[Box]) -> Taken:
    free = np.full(len(line), True)
    for left, bottom, right, top in boxes:
        across = (line[:, 0] > left - MARGIN) & (line[:, 0] < right + MARGIN)
        free &= ~(across & (line[:, 1] > bottom - MARGIN) & (line[:, 1] < top + MARGIN))
    return free


def _runs(line: Points, taken: Taken) -> Iterable[Points]:
    """Yield both ends of each stretch of a line that is taken, and a gap."""
    edges = np.diff(np.concatenate(([0], taken.astype(int), [0])))
    for begin, end in zip(np.flatnonzero(edges == 1), np.flatnonzero(edges == -1) - 1, strict=True):
        if end > begin:
            yield np.stack((line[begin], line[end], np.full(2, np.nan)))


# In mm. The strip of the strokes has their names in a row, and the dead centres' in one above it.
ROW = 4.0
STRIP, STRIP_OF_STROKES = 9.0, 5.0
ARROW, LEAST_ARROW = 1.9, 5.0
# Beside the frame: the arrow of a swing, and its text, which is read from the right.
SWING, SWING_TEXT, BESIDE_SWING = 3.0, 4.6, 9.5
UP, ALONG = np.asarray((0.0, 1.0)), np.asarray((1.0, 0.0))


def draw_areas(axes: Axes, plan: Plan, number: int) -> None:
    """Hatch what the first curve encloses with the second."""
    if not plan.panel.areas:
        return
    courses = [Course(*plan.on_paper(one).T) for one in plan.courses[:2]]
    free = [one.box for one in (*(plan.labels or ()), *plan.spots)]
    for name, rising in (("above", True), ("below", False)):
        lines = plan.in_values(hatching(courses, plan.size, rising, free))
        artist = axes.plot(*lines, color=BLACK, linewidth=THIN, zorder=1.5)[0]
        artist.set_gid(f"area-{number}-{name}")


def draw_spots(axes: Axes, plan: Plan) -> None:
    """Mark the spots and write beside them."""
    for spot in plan.panel.spots:
        place = (np.asarray([spot.angle]), np.asarray([spot.value]))
        if spot.way is not None:
            (tip,), span = plan.on_paper(Course(*place)), (plan.span[1] - plan.span[0])
            across, up = spot.way
            rise = up * plan.room.height / (plan.limits[1] - plan.limits[0])
            way = np.asarray((across * plan.room.width / span, rise))
            _head(axes, plan, tip, way / np.hypot(*way), 2.8, 0.28)
            continue
        axes.plot(*place, marker="o", markersize=2 * SPOT * MM, color=BLACK, zorder=5, clip_on=False)
    for one in plan.spots:
        x, y = one.place / plan.size
        axes.text(
            x, y, one.text, ha="center", va="center", fontsize=one.points, transform=axes.transAxes, zorder=6
        )


def draw_swing(axes: Axes, plan: Plan, mark: str) -> None:
    """Draw an arrow between the greatest and the least value, at the right of the frame."""
    swing = plan.panel.swing
    if swing is None:
        return
    ends = Course(np.zeros(2), np.asarray((swing.least, swing.greatest)))
    low, high = plan.on_paper(ends)[:, 1].tolist()
    x = plan.room.width + SWING
    for level, value in ((low, swing.least), (high, swing.greatest)):
        reached = [spot.angle for spot in plan.panel.spots if spot.value == value]
        begin = min(reached, default=plan.span[1])
        first = plan.on_paper(Course(np.asarray([begin]), np.asarray([value])))[0][0]
        _line(axes, plan, (first, level), (x + 1, level))
    _arrow(axes, plan, (x, low), (x, high))
    axes.text(
        (plan.room.width + SWING_TEXT) / plan.room.width, (low + high) / 2 / plan.room.height,
        text_of(swing.text, mark), rotation=90, ha="left", va="center", transform=axes.transAxes,
        fontsize=TEXT_SIZE,
    )  # fmt: skip


def draw_ends(axes: Axes, plan: Plan) -> None:
    """Draw the lines of the dead centres through a panel."""
    for end in plan.room.ends:
        if end not in plan.span:
            axes.axvline(end, color=BLACK, linewidth=THIN, dashes=LONG_DASH_DOT, zorder=2)


def strip_of(strokes: Strokes, span: tuple[float, float], width: float, mark: str) -> float:
    """Return the height of the strip: lower where the names of the dead centres have no room in it."""
    return STRIP if any(_dead_centres(strokes, span, width, mark)) else STRIP_OF_STROKES


def draw_strokes(axes: Axes, plan: Plan, strokes: Strokes, mark: str) -> None:
    """Draw the strip above the first panel: the strokes, and the names of their dead centres."""
    width, height = plan.size
    places = [_across(end, plan.span, width) for end in strokes.ends]
    for place, end in zip(places, strokes.ends, strict=True):
        if plan.span[0] <= end <= plan.span[1]:
            _line(axes, plan, (place, height), (place, height + ROW + 0.5))
    for (begin, end), name in zip(pairwise(places), strokes.names, strict=True):
        _stroke(axes, plan, (max(begin, 0.0), min(end, width)), text_of(name, mark))
    for place, text in _dead_centres(strokes, plan.span, width, mark):
        _write(axes, plan, (place, height + 1.6 * ROW), text)


def _stroke(axes: Axes, plan: Plan, ends: tuple[float, float], name: str) -> None:
    """Write the name of a stroke between its ends, with arrows to them where there is room."""
    begin, end = ends
    width, middle, y = size_of(name, SMALL_TEXT)[0], (begin + end) / 2, plan.room.height + ROW / 2 + 0.2
    if width > end - begin:
        return
    _write(axes, plan, (middle, y), name)
    room = (end - begin - width) / 2 - 1.2
    if room > LEAST_ARROW / 2:
        for tip, base in ((begin, begin + room), (end, end - room)):
            _line(axes, plan, (base, y), (tip, y))
            _head(axes, plan, (tip, y), ALONG if tip > base else -ALONG)


def _dead_centres(
    strokes: Strokes, span: tuple[float, float], room: float, mark: str
) -> Iterator[tuple[float, str]]:
    """Yield the names of the dead centres that are seen and where they stand, if all of them have room."""
    both = zip(strokes.ends, strokes.dead, strict=True)
    seen = [
        (_across(end, span, room), text_of(name, mark)) for end, name in both if span[0] <= end <= span[1]
    ]
    widths = [size_of(name, SMALL_TEXT)[0] for _, name in seen]
    found = [
        min(max(place, width / 2), room - width / 2) for (place, _), width in zip(seen, widths, strict=True)
    ]
    apart = [
        (second - first) - (before + after) / 2
        for (first, second), (before, after) in zip(pairwise(found), pairwise(widths), strict=True)
    ]
    if min(apart, default=1.0) >= 1.0:
        yield from zip(found, (name for _, name in seen), strict=True)


def _across(angle: float, span: tuple[float, float], width: float) -> float:
    first, last = span
    return (angle - first) / (last - first) * width


def _write(axes: Axes, plan: Plan, place: tuple[float, float], text: str) -> None:
    x, y = np.asarray(place) / plan.size
    axes.text(x, y, text, ha="center", va="center", fontsize=SMALL_TEXT, transform=axes.transAxes)


def _line(axes: Axes, plan: Plan, start: tuple[float, float], end: tuple[float, float]) -> None:
    points = plan.in_values(Course(*np.asarray((start, end)).T))
    axes.plot(*points, color=BLACK, linewidth=THIN, zorder=2.5, clip_on=False)


def _arrow(axes: Axes, plan: Plan, start: tuple[float, float], end: tuple[float, float]) -> None:
    """Draw a line with arrowheads at both ends, upright."""
    _line(axes, plan, start, end)
    if end[1] - start[1] > 2 * ARROW:
        _head(axes, plan, start, -UP)
        _head(axes, plan, end, UP)


def _head(
    axes: Axes,
    plan: Plan,
    tip: tuple[float, float],
    way: np.ndarray,
    length: float = ARROW,
    slim: float = 0.17,
) -> None:
    """Draw a filled arrowhead of a length in mm; along and across are of two scales."""
    side = np.asarray((-way[1], way[0])) * slim
    base = np.asarray(tip) - way * length
    corners = np.stack((np.asarray(tip), base + side * length, base - side * length))
    axes.fill(*plan.in_values(Course(*corners.T)), color=BLACK, linewidth=0, zorder=6, clip_on=False)
