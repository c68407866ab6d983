"""A construction to scale: its lines step by step, the letters of its points, and its lengths as dimensions.

Each line has the id of its step in SVG, "step-3-2", a length that is read off that of its letters,
"length-ad": it is as long there as its true length times the scale.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import chain
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.books.constructions import model
from kurbel.books.constructions.model import Construction, Element, Length, lettered
from kurbel.errors import ProblemError
from kurbel.exact.kind import floats
from kurbel.formats.html.live import lesson
from kurbel.page.build import build
from kurbel.page.labels import plain
from kurbel.plot.drawings import Drawing
from kurbel.plot.moving import LONGEST_ROD, polar_point
from kurbel.plot.sketch import (
    DOT,
    LEAST,
    LEAST_DIMENSION,
    STRONG_LEVEL,
    Point,
    Sketch,
    laid_out,
    moved,
    page_fitted,
    towards,
)
from kurbel.plot.style import MEDIUM, STRONG, THIN, USUAL, WIDTH, Size, arrowhead, style, text_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from kurbel.books.constructions.construction_page import ConstructionRequest

# In mm: between rows of dimensions, at a mark, and below that a length has no dimension.
ROW, CORNER, SHORTEST = 6.0, 2.2, 0.15
# In mm: below that an angle has no arc, how far arrows from outside reach, half a tick.
LEAST_ANGLE, OUTSIDE, TICK = 1.2, 5.0, 0.8
# Points nearer to each other than that, in R, are one for their letters.
NEAREST = 0.01
# The arrowhead of a vector: its length in mm and how slim it is.
HEAD = (2.6, 0.17)
HIDDEN = (0, (6, 3))
LOOKS: Mapping[str, Mapping[str, object]] = {
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
    measures: Sequence[model.Dimension]
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


def _scale(board: Board, one: model.Scale) -> None:
    start, end = board.points[one.start], board.points[one.end]
    board.sketch.line(start, end, linewidth=MEDIUM)
    for point in (start, end):
        board.sketch.line(
            moved(point, (0, 1), -TICK * board.sketch.mm), moved(point, (0, 1), TICK * board.sketch.mm)
        )
    board.sketch.beside((start, end), board.text(one.symbol), 0.5, 1, led=True)


def _measure(board: Board, one: model.Dimension) -> None:
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


def _beside(board: Board, one: model.Dimension, end: float) -> float:
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


DRAW: Mapping[type, Callable[[Board, Any], object]] = {
    model.Line: _line,
    model.Arrow: _arrow,
    model.Arc: _arc,
    model.Circle: _circle,
    model.RightAngle: _right_angle,
    model.Angle: _angle,
    model.Curve: lambda board, one: board.sketch.line(*board.curves[one.name], **LOOKS[one.look]),
    model.Text: lambda board, one: board.sketch.beside_points(
        [(board.points[one.at], (0.0, 1.0), board.text(one.text))], CORNER
    ),
    model.Scale: _scale,
    model.Dimension: _measure,
}


def extent(
    shown: Construction, points: Mapping[str, Point], curves: Mapping[str, Sequence[Point]]
) -> tuple[Point, Point]:
    """Return the lower left and the upper right corner of what is drawn."""
    xs, ys = zip(*_reached(shown, points), *chain.from_iterable(curves.values()), strict=True)
    return (min(xs), min(ys)), (max(xs), max(ys))


def _reached(shown: Construction, points: Mapping[str, Point]) -> Iterator[Point]:
    for step in shown.steps:
        yield from (points[letter] for letter in step.points)
        for one in step.drawn:
            if isinstance(one, model.Circle):
                (x, y), radius = points[one.centre], math.dist(points[one.centre], points[one.through])
                yield x - radius, y - radius
                yield x + radius, y + radius
            elif isinstance(one, model.Line | model.Arrow | model.Scale):
                yield from (points[one.start], points[one.end])


_STEP = re.compile(r"step-(\d+)-")


def step_of(shown: Construction) -> Callable[[str], int]:
    """Return what says the number of the step by an id, 0 for one of none."""
    lengths = dict(_lengths(shown))

    def step(name: str) -> int:
        found = _STEP.match(name)
        return int(found[1]) if found else lengths.get(name, 0)

    return step


def _lengths(shown: Construction) -> Iterator[tuple[str, int]]:
    """Yield the ids of lengths that are read off, which have those of their letters, with their steps."""
    ends = {one.ends: one.letters for one in shown.lengths}
    for number, step in enumerate(shown.steps, 1):
        for one in step.drawn:
            if isinstance(one, model.Dimension):
                yield f"length-{one.letters}", number
            elif isinstance(one, model.Arrow | model.Line) and (one.start, one.end) in ends:
                yield f"length-{ends[one.start, one.end]}", number


def hide_later(axes: Axes, shown: Construction, last: int) -> None:
    """Hide what is drawn after a step; what is left stays where it is."""
    step = step_of(shown)
    for one in (*axes.lines, *axes.patches, *axes.texts):
        one.set_visible(step(str(one.get_gid() or "")) <= last)


# In mm: the largest crank radius, and what is left free about the drawing.
LARGEST_RADIUS, MARGIN = 24.0, 7.0
# Higher, in mm, it would not stand on a page with its caption.
TALLEST = 160.0


def construction_drawing(
    request: ConstructionRequest, mark: str, size: Size = USUAL, last: int | None = None
) -> Drawing:
    """Return the drawing of a construction with its steps, up to the last one. Raises ProblemError for a rod
    that is too long or a page too small to be drawn."""
    from kurbel.books.constructions.construction_page import caption

    shown = request.construction
    if 0 < request.drive.crank.ratio * LONGEST_ROD < 1:
        raise ProblemError(
            f"the rod is too long to be drawn; drawn to scale it may be at most {LONGEST_ROD} R, or the crank"
            " is too small to be seen"
        )
    at = request.at(floats())
    # In units of R; a mirrored drive has the crosshead on the left.
    sign = -1 if shown.given.mirrored else 1
    points = {letter: (sign * float(point.x), float(point.y)) for letter, point in shown.points(at).items()}
    curves = {
        name: [(sign * float(point.x), float(point.y)) for point in shown.curve(name, at)]
        for name in shown.curves
    }
    with style():
        board = _board(shown, points, curves, size, mark)
        for number, step in enumerate(shown.steps, 1):
            board.sketch.texts.name = f"step-{number}"
            for place, element in enumerate(step.drawn, 1):
                _named(board, element, f"step-{number}-{place}")
            for letter in step.points:
                _dot(board, letter, f"step-{number}-{letter}")
        board.sketch.write()
    if last is not None:
        hide_later(board.sketch.axes, shown, last)
    said = (plain(shown.overlined(step.text[request.lang]), mark) for step in shown.steps[:last])
    scales = {"$R$": Fraction(1), **shown.scales}
    about = ", ".join(
        f"{plain(unit, mark)} = {float(times) / board.sketch.mm:.6g} mm" for unit, times in scales.items()
    )
    about += "; " + " ".join(f"{number}. {text}" for number, text in enumerate(said, 1))
    return Drawing(board.sketch.figure, caption(request), about)


def _board(
    shown: Construction,
    points: Mapping[str, Point],
    curves: Mapping[str, Sequence[Point]],
    size: Size,
    mark: str,
) -> Board:
    low, high = extent(shown, points, curves)
    measures = [one for step in shown.steps for one in step.drawn if isinstance(one, model.Dimension)]
    levels = [one.level for one in measures]
    below, above = -min((0, *levels)) * ROW, max((0, *levels)) * ROW
    margin = (MARGIN, MARGIN)

    def corners(mm: float) -> tuple[Point, Point]:
        return (
            (low[0] - margin[0] * mm, low[1] - (margin[1] + below) * mm),
            (high[0] + margin[0] * mm, high[1] + (margin[1] + above) * mm),
        )

    room, height = WIDTH - 2 * MARGIN, TALLEST - 2 * MARGIN - above - below
    largest = min(LARGEST_RADIUS, room / (high[0] - low[0]), height / (high[1] - low[1]))
    if largest < LEAST:
        raise ProblemError(
            f"drawn to scale R would be {largest:.2g} mm long, too short to be seen, for the whole is"
            f" {high[0] - low[0]:.3g} R wide and {high[1] - low[1]:.3g} R high; take another angle or other"
            " lengths, or --table for the numbers"
        )
    usual = math.floor(2 * largest) / 2
    lower, upper, mm = page_fitted(corners, usual, size)
    sketch = laid_out(lower, upper, mm)
    lengths = {one.letters: one for one in shown.lengths}
    turning = -1 if shown.given.mirrored else 1
    return Board(sketch, points, curves, lengths, measures, low[1], high[1], mark, turning)


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
    sketch.beside_points([(at, board.outward(at), board.text(lettered(letter)))], DOT + 0.5)


def construction_page(request: ConstructionRequest, svg: str, decimal: str | None) -> str:
    """Return the page of a construction of which this is the drawing, an SVG file."""
    shown, table = request.construction, build(request)
    # The steps stand beside the drawing; below the table would be a second list of them.
    below = replace(table, notes=table.notes[len(shown.steps) :])
    texts = [shown.overlined(step.text[request.lang]) for step in shown.steps]
    return lesson(svg, step_of(shown), texts, below, decimal)
