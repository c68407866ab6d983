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
from typing import TYPE_CHECKING

from kurbel.books.constructions import model
from kurbel.books.constructions.model import Construction, Element, lettered
from kurbel.errors import ProblemError
from kurbel.exact.kind import floats
from kurbel.formats.html.live import lesson
from kurbel.page.build import build
from kurbel.page.labels import plain
from kurbel.plot.drawings import Drawing
from kurbel.plot.elements import DRAW, ROW, Board
from kurbel.plot.moving import LONGEST_ROD
from kurbel.plot.sketch import DOT, LEAST, Point, laid_out, page_fitted
from kurbel.plot.style import THIN, USUAL, WIDTH, Size, style

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from kurbel.books.constructions.page import ConstructionRequest


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
            if isinstance(one, model.Measure):
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
    from kurbel.books.constructions.page import caption

    shown = request.construction
    if request.drive.crank.ratio * LONGEST_ROD < 1:
        raise ProblemError(
            f"the rod is too long to be drawn; drawn to scale it may be at most {LONGEST_ROD} R, or the crank"
            " is too small to be seen"
        )
    at = request.at(floats())
    # In units of R; a mirrored drive has the crosshead on the left.
    sign = -1 if shown.given.mirrored else 1
    points = {letter: (sign * point.x, point.y) for letter, point in shown.points(at).items()}
    curves = {name: [(sign * point.x, point.y) for point in shown.curve(name, at)] for name in shown.curves}
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
    measures = [one for step in shown.steps for one in step.drawn if isinstance(one, model.Measure)]
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
