"""A construction to scale: its lines step by step, the letters of its points, and its lengths as dimensions.

Each line has the id of its step in SVG, "step-3-2", a length that is read off that of its letters,
"length-ad": it is as long there as its true length times the scale.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.books.constructions import model
from kurbel.books.constructions.model import Construction, Element, Length, Placed, lettered
from kurbel.errors import ProblemError
from kurbel.exact.kind import floats
from kurbel.page.labels import plain
from kurbel.plot.construct.extent import extent
from kurbel.plot.drawings import Drawing
from kurbel.plot.moving.positions import LONGEST_ROD
from kurbel.plot.paper.fit import fitted
from kurbel.plot.sketch import (
    LEAST_DIMENSION,
    STRONG_LEVEL,
    Point,
    Sketch,
    laid_out,
    moved,
    polar_point,
    towards,
)
from kurbel.plot.style import MEDIUM, STRONG, THIN, USUAL, WIDTH, Size, arrowhead, style, text_of

if TYPE_CHECKING:
    from kurbel.books.constructions.page import ConstructionRequest

# In mm: the largest crank radius, what is left free about the drawing, between rows of dimensions, at a mark.
LARGEST_RADIUS, MARGIN, ROW, CORNER, DOT = 24.0, 7.0, 6.0, 2.2, 0.45
HIDDEN = (0, (6, 3))
LOOKS: Mapping[str, Mapping[str, Any]] = {
    model.LINK: {"linewidth": STRONG, "zorder": STRONG_LEVEL},
    model.GIVEN: {"linewidth": MEDIUM},
    model.AID: {"linewidth": THIN},
    model.HIDDEN: {"linewidth": THIN, "linestyle": HIDDEN},
    model.RESULT: {"linewidth": STRONG, "zorder": STRONG_LEVEL},
}


class Board(NamedTuple):
    """What is being drawn on: the sketch, the points in units of R, the lengths by their letters; what lies
    lowest and highest; the decimal mark."""

    sketch: Sketch
    points: Mapping[str, Point]
    lengths: Mapping[str, Length]
    low: float
    high: float
    mark: str

    def text(self, label: str) -> str:
        return text_of(label, self.mark)

    @property
    def middle(self) -> Point:
        xs, ys = zip(*self.points.values(), strict=True)
        return sum(xs) / len(xs), sum(ys) / len(ys)


def construction_drawing(request: ConstructionRequest, mark: str, size: Size = USUAL) -> Drawing:
    """Return the drawing of a construction with all its steps. Raises ProblemError for a rod that is too long
    or a page too small to be drawn."""
    from kurbel.books.constructions.page import caption

    shown = request.construction
    if request.drive.ratio * LONGEST_ROD < 1:
        raise ProblemError(
            f"the rod is too long to be drawn; drawn to scale it may be at most {LONGEST_ROD} R, or the crank"
            " is too small to be seen"
        )
    points = drawn_points(shown, request.at(floats()))
    with style():
        board = _board(shown, points, size, mark)
        for number, step in enumerate(shown.steps, 1):
            board.sketch.texts.name = f"step-{number}"
            for place, element in enumerate(step.drawn, 1):
                _named(board, element, f"step-{number}-{place}")
            for letter in step.points:
                _dot(board, letter, f"step-{number}-{letter}")
        board.sketch.write()
    said = (plain(shown.said(step.text[request.lang]), mark) for step in shown.steps)
    about = f"R = {1 / board.sketch.mm:.6g} mm; " + " ".join(
        f"{number}. {text}" for number, text in enumerate(said, 1)
    )
    return Drawing(board.sketch.figure, caption(request), about)


def drawn_points(shown: Construction, at: Placed) -> Mapping[str, Point]:
    """Return the points as they are drawn, in units of R: a mirrored drive has the crosshead on the left."""
    sign = -1 if shown.mirrored else 1
    return {letter: (sign * point.x, point.y) for letter, point in shown.points(at).items()}


def _board(shown: Construction, points: Mapping[str, Point], size: Size, mark: str) -> Board:
    low, high = extent(shown, points)
    levels = [one.level for step in shown.steps for one in step.drawn if isinstance(one, model.Measure)]
    below, above = -min((0, *levels)) * ROW, max((0, *levels)) * ROW
    margin = (MARGIN, MARGIN)

    def corners(mm: float) -> tuple[Point, Point]:
        return (
            (low[0] - margin[0] * mm, low[1] - (margin[1] + below) * mm),
            (high[0] + margin[0] * mm, high[1] + (margin[1] + above) * mm),
        )

    room = WIDTH - 2 * MARGIN
    usual = math.floor(2 * min(LARGEST_RADIUS, room / (high[0] - low[0]))) / 2
    lower, upper, mm = fitted(corners, usual, size)
    sketch = laid_out(lower, upper, mm)
    return Board(sketch, points, {one.letters: one for one in shown.lengths}, low[1], high[1], mark)


def _named(board: Board, element: Element, name: str) -> None:
    """Draw an element and give its artists the name of its step."""
    axes = board.sketch.axes
    before = {*axes.lines, *axes.patches}
    DRAW[type(element)](board, element)
    new = [one for one in (*axes.lines, *axes.patches) if one not in before]
    for place, artist in enumerate(new):
        if not artist.get_gid():
            artist.set_gid(f"{name}-{place}" if place else name)


def _dot(board: Board, letter: str, name: str) -> None:
    sketch, at = board.sketch, board.points[letter]
    sketch.disc(at, DOT, THIN, "#000000")
    sketch.axes.patches[-1].set_gid(name)
    outward = (at[0] - board.middle[0], at[1] - board.middle[1])
    if not any(outward):
        outward = (0.0, -1.0)
    sketch.beside_points([(at, outward, board.text(lettered(letter)))], DOT + 0.5)


def _line(board: Board, one: model.Line) -> None:
    start, end = board.points[one.start], board.points[one.end]
    way, by = towards(start, end), one.beyond * board.sketch.mm
    start, end = moved(start, way, -by), moved(end, way, by)
    if one.look == model.CENTRE:
        board.sketch.chain(start, end)
    else:
        board.sketch.line(start, end, **LOOKS[one.look])


def _arrow(board: Board, one: model.Arrow) -> None:
    start, end = board.points[one.start], board.points[one.end]
    if math.dist(start, end) < 0.05 * board.sketch.mm:
        return
    board.sketch.line(start, end, **LOOKS[one.look])
    arrowhead(board.sketch.axes, end, towards(start, end), board.sketch.mm)
    if one.symbol:
        board.sketch.beside((start, end), board.text(one.symbol), 0.5, 1)


def _arc(board: Board, one: model.Arc) -> None:
    centre = board.points[one.centre]
    radius, start, end = arc_of(board.points, one)
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
    radius = min(0.42, 0.6 * reach) if reach < 2 else 0.25 * reach
    if abs(math.radians(end - start)) * radius < 1.2 * board.sketch.mm:
        return
    line = arc_points(centre, radius, start, end)
    board.sketch.line(*line)
    board.sketch.beside(line, board.text(one.symbol), 0.5, 1 if end < start else -1, ends=True)


def _measure(board: Board, one: model.Measure) -> None:
    """Draw the dimension of a length: in its place, or on a row, where lines lead to its ends."""
    sketch, length = board.sketch, board.lengths[one.letters]
    start, end = (board.points[letter] for letter in length.ends)
    said = board.text(length.symbol or lettered(one.letters))
    if not one.level:
        _length(sketch, start, end, one.letters, model.RESULT)
        sketch.beside((start, end), said, 0.5, 1)
        return
    mm = sketch.mm
    edge = board.low if one.level < 0 else board.high
    level = edge + (one.level * ROW - math.copysign(1.0, one.level)) * mm
    for point in (start, end):
        sketch.line(point, (point[0], level + math.copysign(1, one.level) * mm))
    left, right = sorted(((start[0], level), (end[0], level)))
    _length(sketch, left, right, one.letters, model.AID)
    inside = math.dist(left, right) > LEAST_DIMENSION * mm
    reach, outward = (0.0, 1) if inside else (4 * mm, -1)
    if not inside:
        sketch.line((left[0] - reach, level), left)
        sketch.line(right, (right[0] + reach, level))
    arrowhead(sketch.axes, left, (-outward, 0), mm)
    arrowhead(sketch.axes, right, (outward, 0), mm)
    sketch.beside(((left[0] - reach, level), (right[0] + reach, level)), said, 0.5, 1, ends=True)


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
    model.Measure: _measure,
}
