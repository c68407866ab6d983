"""The arc crank true to scale: crank, rod and rocker at given crank angles, and the arc of the rod's end."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from kurbel.errors import ProblemError
from kurbel.exact.kind import floats
from kurbel.linkage.arc.rocker import RockerCrank
from kurbel.motion.evaluation import OUT, RETURN
from kurbel.plot.coupler.paths import Coupled, around, draw_paths, usual_scale
from kurbel.plot.mechanism import LARGEST_RADIUS, LEFT, LONGEST_ROD
from kurbel.plot.moving.arcs import arc_pivot, swept
from kurbel.plot.moving.arcs import arc_position as arc_position
from kurbel.plot.moving.positions import Position
from kurbel.plot.paper.fit import fitted
from kurbel.plot.place import CLEAR
from kurbel.plot.sketch import (
    DEAD_CENTRES,
    DOWN,
    HANGING,
    LEFTWARD,
    UP,
    Point,
    Sketch,
    laid_out,
    pin_texts,
    polar_point,
)
from kurbel.plot.style import USUAL, WIDTH, Size, arrowhead, style, text_of
from kurbel.reading.notation import about

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# In mm. The dimensions of the pivot stand below and at the right.
RIGHT, OUTSIDE, DIMENSIONS, MOST_HEIGHT = 17.0, 7.0, 9.0, 150.0
# The arc goes on beyond the dead centres by so many mm, and the path is dimensioned so far outside of it.
OVERRUN, OUTWARD = 4.0, 4.5
# The names of the dead centres stand at the ends of lines so long.
LEADER = 7.0
THETA = text_of("$θ$", ".")


class _Drive(NamedTuple):
    """What does not move: the pivot, the length of the rocker and its letter, whether it has another arm, the
    dead centres, the ends of the drawing."""

    pivot: Point
    rocker: float
    letter: str
    is_beam: bool
    inner: Position
    outer: Position
    low: Point
    high: Point

    def beyond(self, point: Point, way: float) -> Point:
        """Return a point so much farther from the pivot."""
        share, (x, y) = 1 + way / self.rocker, self.pivot
        return x + (point[0] - x) * share, y + (point[1] - y) * share

    def pins(self, one: Position) -> tuple[Point, ...]:
        """Return the pins between links, that at the other arm of a beam among them."""
        return (one.pin, one.head, self.end(one.head)) if self.is_beam else (one.pin, one.head)

    def end(self, head: Point) -> Point:
        """Return where the rocker ends: at its pivot, or with another arm as far beyond it."""
        x, y = self.pivot
        return (2 * x - head[0], 2 * y - head[1]) if self.is_beam else self.pivot

    def away(self, point: Point) -> Point:
        """Return the direction of a point from the pivot."""
        return point[0] - self.pivot[0], point[1] - self.pivot[1]


def arc_mechanism(
    crank: RockerCrank,
    angles: Sequence[float | Fraction],
    lang: str,
    mark: str,
    size: Size = USUAL,
    paths: Sequence[Coupled] = (),
) -> Figure:
    """Return a drawing of the arc crank, true to scale, by itself 120 mm wide at most.

    The shaft is at the left, φ counts counter-clockwise from the slide direction, θ likewise from the rocker
    square to it. The first angle is drawn strong, with its dimensions, the others light. Raises ProblemError
    for links too long or a page too small to be drawn.
    """
    drive = _drive(crank)
    positions = [arc_position(crank, float(angle)) for angle in angles]
    with style():
        sketch = _laid_out(drive, size, paths)
        _fixed_lines(sketch, drive)
        for one in positions[1:]:
            links = (0, 0), one.pin, one.head, drive.end(one.head)
            sketch.light_links(links, drive.pins(one), ((0, 0), drive.pivot))
        _pivot_dimensions(sketch, drive)
        _position_dimensions(sketch, drive, positions[0])
        _strong(sketch, drive, positions[0])
        draw_paths(sketch, paths, positions[0].pin, positions[0].head, mark)
        dead = [(drive.inner, DEAD_CENTRES["inner"][lang]), (drive.outer, DEAD_CENTRES["outer"][lang])]
        leader = LEADER * sketch.mm
        names = [(drive.beyond(one.head, leader), drive.away(one.head), name) for one, name in dead]
        sketch.beside_points(names, CLEAR)
        sketch.beside_points(pin_texts([one.pin for one in positions], angles, mark))
        sketch.write()
    return sketch.figure


def _drive(crank: RockerCrank) -> _Drive:
    rod = f"{about(1 / crank.crank.ratio)} R" if crank.crank.ratio else "infinite"
    if crank.crank.ratio * LONGEST_ROD < 1 or crank.rocker > LONGEST_ROD:
        raise ProblemError(
            f"the length of the rod is {rod}, that of the rocker {about(crank.rocker)} R; drawn to scale they"
            f" may be at most {LONGEST_ROD} R, or the crank is too small to be seen"
        )
    inner = arc_position(crank, float(crank.dead_angle(OUT, floats())))
    outer = arc_position(crank, 180 + float(crank.dead_angle(RETURN, floats())))
    pivot = arc_pivot(crank)
    arc = [polar_point(pivot, float(crank.rocker), turn) for turn in swept(pivot, inner.head, outer.head)]
    corners = [pivot, *arc, (-1.0, -1.0), (1.0, 1.0)]
    if not crank.at_end:
        corners += [(2 * pivot[0] - x, 2 * pivot[1] - y) for x, y in arc]
    low, high = ((end(x for x, _ in corners), end(y for _, y in corners)) for end in (min, max))
    return _Drive(pivot, float(crank.rocker), crank.letter, not crank.at_end, inner, outer, low, high)


def _laid_out(drive: _Drive, size: Size, paths: Sequence[Coupled]) -> Sketch:
    side = 1 if drive.pivot[1] >= 0 else -1
    width, height = drive.high[0] - drive.low[0], drive.high[1] - drive.low[1]
    beside, above = LEFT + RIGHT, 2 * OUTSIDE + DIMENSIONS
    radius = min(LARGEST_RADIUS, (WIDTH - beside) / width, (MOST_HEIGHT - above) / height)
    corners = around(lambda mm: _corners(drive, side, mm), paths)
    low, high, mm = fitted(corners, usual_scale(corners, radius, paths), size)
    return laid_out(low, high, mm, side)


def _corners(drive: _Drive, side: int, mm: float) -> tuple[Point, Point]:
    """Return the corners of the page, of which a millimetre is so much of R."""
    left, right = drive.low[0] - LEFT * mm, drive.high[0] + RIGHT * mm
    bottom = drive.low[1] - (OUTSIDE + DIMENSIONS * (side > 0)) * mm
    top = drive.high[1] + (OUTSIDE + DIMENSIONS * (side < 0)) * mm
    return (left, bottom), (right, top)


def _fixed_lines(sketch: Sketch, drive: _Drive) -> None:
    """Draw centre lines, the crank circle, the arc and the dead centres on both."""
    mm = sketch.mm
    beyond, (x, y) = 1 + 3.5 * mm, drive.pivot
    sketch.centre_line((0, -beyond), (0, 0), (0, beyond))
    sketch.centre_line((-beyond, 0), (0, 0), (drive.high[0] + 4 * mm, 0))
    sketch.centre_line((x, y + sketch.side * 4 * mm), (x, y), (x, _lowest(sketch, drive)))
    sketch.crank_circle()
    turns = swept(drive.pivot, drive.inner.head, drive.outer.head)
    more = math.degrees(OVERRUN * mm / drive.rocker)
    path = [
        polar_point(drive.pivot, drive.rocker, one) for one in (turns[0] - more, *turns, turns[-1] + more)
    ]
    sketch.chain(*path).set_gid("arc")
    for dead in (drive.inner, drive.outer):
        sketch.dead_centre(dead.pin)
        sketch.dead_centre(dead.head)
        sketch.line(dead.head, drive.beyond(dead.head, LEADER * mm))


def _lowest(sketch: Sketch, drive: _Drive) -> float:
    """Return how far the lines reach on the side away from the pivot."""
    edge = drive.low[1] if sketch.side > 0 else drive.high[1]
    return edge - sketch.side * (OUTSIDE + 1) * sketch.mm


def _pivot_dimensions(sketch: Sketch, drive: _Drive) -> None:
    """Draw D and H, the places of the pivot along and across the slide direction."""
    mm, (x, y) = sketch.mm, drive.pivot
    level = _lowest(sketch, drive) - sketch.side * 2 * mm
    for place, start in ((0.0, -sketch.side * (1 + 4.5 * mm)), (x, _lowest(sketch, drive))):
        sketch.line((place, start), (place, level - sketch.side * mm))
    sketch.dimension((0, level), (x, level), "$D$")
    if abs(y) > 3 * mm:
        right = drive.high[0] + 8 * mm
        for height, start in ((0.0, right - 4 * mm), (y, x + 3 * mm)):
            sketch.line((start, height), (right + mm, height))
        sketch.dimension((right, 0), (right, y), "$H$")


def _position_dimensions(sketch: Sketch, drive: _Drive, one: Position) -> None:
    """Draw φ, θ, R, L, B and the path x along the arc."""
    sketch.crank_dimensions(one.pin, one.angle % 360)
    sketch.beside((one.pin, one.head), "$L$", 0.45, 1 if one.pin[1] >= one.head[1] else -1)
    sketch.beside((drive.pivot, one.head), f"${drive.letter}$", 0.45, -1 if one.lean < 0 else 1)
    _rocker_angle(sketch, drive, one)
    _path(sketch, drive, one)


def _rocker_angle(sketch: Sketch, drive: _Drive, one: Position) -> None:
    """Draw θ from the rocker's place square to the slide, where it can be seen."""
    mm, square = sketch.mm, -90.0 * sketch.side
    radius = min(22 * mm, 0.5 * drive.rocker)
    if abs(math.radians(one.lean)) * radius < 2 * mm:
        return
    first, last = sorted((square, square + one.lean))
    sketch.beside(sketch.arc(drive.pivot, radius, first, last, arrow=False), THETA, 0.5, -1, ends=True)


def _path(sketch: Sketch, drive: _Drive, one: Position) -> None:
    """Draw the path x outside of the arc, from the inner dead centre."""
    mm = sketch.mm
    turns = swept(drive.pivot, drive.inner.head, one.head)
    if math.radians(turns[-1] - turns[0]) * drive.rocker < 5 * mm:
        return
    radius = drive.rocker + OUTWARD * mm
    points = [polar_point(drive.pivot, radius, turn) for turn in turns]
    sketch.line(*points, zorder=4)
    for number, other in ((0, 1), (-1, -2)):
        tip, near = points[number], points[other]
        arrowhead(sketch.axes, tip, (tip[0] - near[0], tip[1] - near[1]), mm)
    sketch.line(drive.beyond(one.head, 1.6 * mm), drive.beyond(one.head, (OUTWARD + 1) * mm), zorder=4)
    sketch.beside(points, "$x$", 0.5, -1)


def _strong(sketch: Sketch, drive: _Drive, one: Position) -> None:
    pivot = drive.pivot
    sketch.strong_links(
        crank=((0, 0), one.pin), rod=(one.pin, one.head), rocker=(one.head, drive.end(one.head))
    )
    sketch.bearing((0, 0), UP if one.pin[1] < -HANGING else DOWN)
    sketch.bearing(pivot, LEFTWARD if drive.is_beam else UP if sketch.side > 0 else DOWN)
    sketch.joints(drive.pins(one))
