"""The elements of a construction as they are drawn: lines, arrows, arcs, angles, dimensions."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from kurbel.books.constructions import model
from kurbel.books.constructions.model import Length, lettered
from kurbel.plot.sketch import LEAST_DIMENSION, STRONG_LEVEL, Point, Sketch, moved, polar_point, towards
from kurbel.plot.style import MEDIUM, STRONG, THIN, arrowhead, text_of

# In mm: between rows of dimensions, at a mark, and below that a length has no dimension.
ROW, CORNER, SHORTEST = 6.0, 2.2, 0.15
# In mm: below that an angle has no arc, how far arrows from outside reach, half a tick.
LEAST_ANGLE, OUTSIDE, TICK = 1.2, 5.0, 0.8
# Points nearer to each other than that, in R, are one for their letters.
NEAREST = 0.01
# The arrowhead of a vector: its length in mm and how slim it is.
HEAD = (2.6, 0.17)
HIDDEN = (0, (6, 3))
LOOKS: Mapping[str, Mapping[str, Any]] = {
    model.LINK: {"linewidth": STRONG, "zorder": STRONG_LEVEL},
    model.GIVEN: {"linewidth": MEDIUM},
    model.AID: {"linewidth": THIN},
    model.HIDDEN: {"linewidth": THIN, "linestyle": HIDDEN},
    model.RESULT: {"linewidth": STRONG, "zorder": STRONG_LEVEL},
}


class Board(NamedTuple):
    """What is being drawn on: the sketch, the points in units of R, the lengths by their letters and their
    dimensions; what lies lowest and highest; the decimal mark; the sense in which the crank turns, 1 to the
    left."""

    sketch: Sketch
    points: Mapping[str, Point]
    curves: Mapping[str, Sequence[Point]]
    lengths: Mapping[str, Length]
    measures: Sequence[model.Measure]
    low: float
    high: float
    mark: str
    turning: int = 1

    def text(self, label: str) -> str:
        return text_of(label, self.mark)

    def read_off(self, start: str, end: str) -> str:
        """Return the letters of the length that has these ends, nothing where there is none."""
        return next((one.letters for one in self.lengths.values() if one.ends == (start, end)), "")

    def outward(self, at: Point) -> Point:
        """Return the direction away from the other points, the nearest above all, in which a letter is not
        taken for one of theirs."""
        across, up = 0.0, -1e-6
        for other in self.points.values():
            away = math.dist(at, other)
            if away > NEAREST:
                across += (at[0] - other[0]) / away**3
                up += (at[1] - other[1]) / away**3
        return across, up


def _line(board: Board, one: model.Line) -> None:
    start, end = board.points[one.start], board.points[one.end]
    way, by = towards(start, end), one.beyond * board.sketch.mm
    start, end = moved(start, way, -by), moved(end, way, by)
    if start == end:
        return
    if one.look == model.CENTRE:
        board.sketch.chain(start, end)
        return
    drawn = board.sketch.line(start, end, **LOOKS[one.look])
    if (letters := board.read_off(one.start, one.end)) and not one.beyond:
        drawn.set(zorder=STRONG_LEVEL, gid=f"length-{letters}")
    if one.symbol:
        board.sketch.beside((start, end), board.text(one.symbol), 0.5, 1, led=True)


def _arrow(board: Board, one: model.Arrow) -> None:
    start, end = board.points[one.start], board.points[one.end]
    letters = board.read_off(one.start, one.end)
    if math.dist(start, end) < 0.05 * board.sketch.mm:
        if letters:
            _length(board.sketch, start, end, letters, one.look)
        return
    drawn = board.sketch.line(start, end, **{**LOOKS[one.look], "linewidth": MEDIUM})
    if letters:
        drawn.set(zorder=STRONG_LEVEL, gid=f"length-{letters}")
    size, slim = HEAD
    size = min(size, 0.7 * math.dist(start, end) / board.sketch.mm)
    arrowhead(board.sketch.axes, end, towards(start, end), board.sketch.mm, size, slim)
    if one.symbol:
        board.sketch.beside((start, end), board.text(one.symbol), 0.5, 1, led=True)


def _arc(board: Board, one: model.Arc) -> None:
    centre = board.points[one.centre]
    radius, start, end = arc_of(board.points, one)
    if radius == 0:
        return
    by = math.degrees(one.beyond * board.sketch.mm / radius) * math.copysign(1, end - start)
    board.sketch.line(*arc_points(centre, radius, start - by, end + by), **LOOKS[one.look])


def arc_of(points: Mapping[str, Point], one: model.Arc) -> tuple[float, float, float]:
    """Return radius, first and last angle in degrees of an arc, the shorter way."""
    centre = points[one.centre]
    first, last = (
        math.degrees(math.atan2(points[name][1] - centre[1], points[name][0] - centre[0]))
        for name in (one.start, one.end)
    )
    return math.dist(centre, points[one.start]), first, first + (last - first + 180) % 360 - 180


def arc_points(centre: Point, radius: float, start: float, end: float) -> list[Point]:
    steps = max(8, int(abs(end - start)))
    return [polar_point(centre, radius, start + (end - start) * step / steps) for step in range(steps + 1)]


def _circle(board: Board, one: model.Circle) -> None:
    centre = board.points[one.centre]
    radius = math.dist(centre, board.points[one.through])
    if one.look == model.CENTRE and abs(radius - 1) < 1e-9:
        board.sketch.crank_circle(centre)
    else:
        board.sketch.line(*arc_points(centre, radius, 0, 360), **LOOKS[one.look])


def _right_angle(board: Board, one: model.RightAngle) -> None:
    corner, by = board.points[one.corner], CORNER * board.sketch.mm
    ends = [board.points[one.one], board.points[one.other]]
    if min(math.dist(corner, end) for end in ends) < by:
        return
    first, second = (towards(corner, end) for end in ends)
    inner = moved(moved(corner, first, by), second, by)
    board.sketch.line(moved(corner, first, by), inner, moved(corner, second, by))


def _angle(board: Board, one: model.Angle) -> None:
    centre = board.points[one.corner]
    reach = min(math.dist(centre, board.points[name]) for name in (one.one, one.other))
    radius, start, end = arc_of(board.points, model.Arc(one.corner, one.one, one.other))
    if one.sense and (end - start) * one.sense * board.turning < 0:
        end += 360 * one.sense * board.turning
    usual = min(0.42, 0.6 * reach) if reach < 2 else 0.25 * reach
    radius = usual if one.at is None else one.at * reach
    span = abs(math.radians(end - start)) * radius / board.sketch.mm
    if one.at is None and span < LEAST_ANGLE:
        return
    if one.at is not None and span < LEAST_DIMENSION:
        start, end = _from_outside(board, centre, radius, start, end)
    line = arc_points(centre, radius, start, end)
    board.sketch.line(*line)
    if one.sense:
        # The head is straight: turned by half its own length it follows the arc.
        lean = math.radians(end) - one.sense * board.turning * 0.95 * board.sketch.mm / radius
        way = (-math.sin(lean), math.cos(lean))
        arrowhead(board.sketch.axes, line[-1], moved((0, 0), way, one.sense * board.turning), board.sketch.mm)
    board.sketch.beside(line, board.text(one.symbol), 0.5, 1 if end < start else -1, ends=True)


def _from_outside(
    board: Board, centre: Point, radius: float, start: float, end: float
) -> tuple[float, float]:
    """Draw the arrows that point from outside at an angle too small for its letter; return where they
    begin."""
    mm = board.sketch.mm
    by = math.copysign(math.degrees(OUTSIDE * mm / radius), end - start)
    for turn, outside in ((start, start - by), (end, end + by)):
        tip, tail = polar_point(centre, radius, turn), polar_point(centre, radius, outside)
        arrowhead(board.sketch.axes, tip, towards(tail, tip), mm)
    return start - by, end + by


def _curve(board: Board, one: model.Curve) -> None:
    board.sketch.line(*board.curves[one.name], **LOOKS[one.look])


def _said(board: Board, one: model.Text) -> None:
    board.sketch.beside_points([(board.points[one.at], (0.0, 1.0), board.text(one.text))], CORNER)


def _scale(board: Board, one: model.Scale) -> None:
    start, end = board.points[one.start], board.points[one.end]
    board.sketch.line(start, end, linewidth=MEDIUM)
    for point in (start, end):
        board.sketch.line(
            moved(point, (0, 1), -TICK * board.sketch.mm), moved(point, (0, 1), TICK * board.sketch.mm)
        )
    board.sketch.beside((start, end), board.text(one.symbol), 0.5, 1, led=True)


def _measure(board: Board, one: model.Measure) -> None:
    """Draw the dimension of a length: in its place, or on a row, where lines lead to its ends."""
    sketch, length = board.sketch, board.lengths[one.letters]
    start, end = (board.points[letter] for letter in length.ends)
    said = board.text(length.symbol or lettered(one.letters))
    if not one.level:
        _length(sketch, start, end, one.letters, one.look)
        if one.written and math.dist(start, end) > SHORTEST * sketch.mm:
            sketch.beside((start, end), said, 0.5, 1, led=True)
        return
    mm = sketch.mm
    edge = board.low if one.level < 0 else board.high
    level = edge + (one.level * ROW - math.copysign(1.0, one.level)) * mm
    left, right = sorted(((start[0], level), (end[0], level)))
    _length(sketch, left, right, one.letters, model.AID)
    if math.dist(left, right) < SHORTEST * mm:
        return
    for point in (start, end):
        sketch.line(point, (point[0], level + math.copysign(1, one.level) * mm))
    sketch.dimension(left, right, said, (_beside(board, one, left[0]), _beside(board, one, right[0])))


def _beside(board: Board, one: model.Measure, end: float) -> float:
    """Return how long the dimension is that shares an end with one in its row, in R, 0 where none does."""
    for other in board.measures:
        xs = sorted(board.points[letter][0] for letter in board.lengths[other.letters].ends)
        if (
            other.level == one.level
            and other != one
            and end in xs
            and xs[1] - xs[0] >= SHORTEST * board.sketch.mm
        ):
            return xs[1] - xs[0]
    return 0.0


def _length(sketch: Sketch, start: Point, end: Point, letters: str, look: str) -> None:
    """Draw a length itself: no text or disc before it shortens it."""
    sketch.line(start, end, **{**LOOKS[look], "zorder": STRONG_LEVEL}).set_gid(f"length-{letters}")


DRAW: Mapping[type, Callable[[Board, Any], None]] = {
    model.Line: _line,
    model.Arrow: _arrow,
    model.Arc: _arc,
    model.Circle: _circle,
    model.RightAngle: _right_angle,
    model.Angle: _angle,
    model.Curve: _curve,
    model.Text: _said,
    model.Scale: _scale,
    model.Measure: _measure,
}
