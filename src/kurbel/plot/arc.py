"""The arc crank true to scale: crank, rod and rocker at given crank angles, and the arc of the rod's end."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from kurbel.errors import ProblemError
from kurbel.kernel.circle import circle
from kurbel.linkage.arc import ArcCrank, dead_angle, floats, value
from kurbel.motion.evaluation import OUT, RETURN
from kurbel.plot.mechanism import LARGEST_RADIUS, LEFT, LONGEST_ROD
from kurbel.plot.sketch import (
    CHAIN,
    DEAD_CENTRES,
    Point,
    arc,
    bearing,
    beside_link,
    beside_points,
    crank_angle,
    crank_circle,
    dead_tick,
    dimension,
    joint,
    light_links,
    line,
    polar_point,
    write,
)
from kurbel.plot.style import BLACK, GREY, MEDIUM, WIDTH, arrowhead, page, style, text_of
from kurbel.plot.ticks import degrees
from kurbel.reading.notation import about

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# In mm. The dimensions of the pivot stand below and at the right.
RIGHT, OUTSIDE, DIMENSIONS, MOST_HEIGHT = 17.0, 7.0, 9.0, 150.0
# The arc goes on beyond the dead centres by so many mm, and the path is dimensioned so far outside of it.
OVERRUN, OUTWARD = 4.0, 4.5
# The names of the dead centres stand at the ends of lines so long.
LEADER = 7.0
THETA = text_of("$θ$", ".")


class ArcPosition(NamedTuple):
    """The arc crank at one angle: crank pin and rocker pin in units of R from the shaft, the angle θ."""

    angle: float
    pin: Point
    head: Point
    rocker_angle: float


class _Drive(NamedTuple):
    """What does not move: the pivot, the length of the rocker, the dead centres, the ends of the drawing."""

    pivot: Point
    rocker: float
    inner: ArcPosition
    outer: ArcPosition
    low: Point
    high: Point


class _Sketch(NamedTuple):
    """A drawing in units of R: what a millimetre is in them, and the side of the pivot, 1 above."""

    figure: Figure
    axes: Axes
    drive: _Drive
    mm: float
    side: int


def arc_mechanism(crank: ArcCrank, angles: Sequence[float | Fraction], lang: str, mark: str) -> Figure:
    """Return a drawing of the arc crank, true to scale and 120 mm wide at most.

    The shaft is at the left, φ counts counter-clockwise from the slide direction, θ likewise from the rocker
    square to it. The first angle is drawn strong, with its dimensions, the others light. Raises ProblemError
    for links too long to be drawn.
    """
    drive = _drive(crank)
    positions = [arc_position(crank, float(angle)) for angle in angles]
    with style():
        sketch = _laid_out(drive)
        _fixed_lines(sketch)
        for one in positions[1:]:
            light_links(sketch, (0, 0), one.pin, one.head, drive.pivot)
        _pivot_dimensions(sketch)
        _position_dimensions(sketch, positions[0])
        _strong(sketch, positions[0])
        dead = [(drive.inner, DEAD_CENTRES["inner"][lang]), (drive.outer, DEAD_CENTRES["outer"][lang])]
        names = [(_from_pivot(sketch, one.head, LEADER), _away(drive, one.head), name) for one, name in dead]
        texts = [degrees(angle, mark) for angle in angles] if len(angles) > 1 else []
        pins = [(one.pin, one.pin, text) for one, text in zip(positions, texts, strict=False)]
        beside_points(sketch, [*names, *pins])
    return sketch.figure


def arc_position(crank: ArcCrank, angle: float) -> ArcPosition:
    """Return where the drive stands at a crank angle in degrees."""
    point = circle(angle)
    turn = float(value("rocker", crank, OUT, point, floats()))
    side = 1 if crank.curvature > 0 else -1
    (x, y), rocker = _pivot(crank), float(crank.rocker)
    across, along = math.sin(math.radians(turn)), math.cos(math.radians(turn))
    head = (x + side * rocker * across, y - side * rocker * along)
    return ArcPosition(angle, (point.cosine, point.sine), head, turn)


def _pivot(crank: ArcCrank) -> Point:
    return float(1 / crank.crank.ratio + crank.shift), float(crank.pivot_height)


def _drive(crank: ArcCrank) -> _Drive:
    rod = f"{about(1 / crank.crank.ratio)} R" if crank.crank.ratio else "infinite"
    if crank.crank.ratio * LONGEST_ROD < 1 or crank.rocker > LONGEST_ROD:
        raise ProblemError(
            f"the length of the rod is {rod}, that of the rocker {about(crank.rocker)} R; drawn to scale they"
            f" may be at most {LONGEST_ROD} R, or the crank is too small to be seen"
        )
    inner = arc_position(crank, float(dead_angle(crank, OUT, floats())))
    outer = arc_position(crank, 180 + float(dead_angle(crank, RETURN, floats())))
    pivot = _pivot(crank)
    swept = [polar_point(pivot, float(crank.rocker), turn) for turn in _swept(pivot, inner.head, outer.head)]
    corners = [pivot, *swept, (-1.0, -1.0), (1.0, 1.0)]
    low, high = ((end(x for x, _ in corners), end(y for _, y in corners)) for end in (min, max))
    return _Drive(pivot, float(crank.rocker), inner, outer, low, high)


def _swept(pivot: Point, start: Point, end: Point) -> list[float]:
    """Return directions from the pivot to places of the arc between two, in degrees, rising."""
    first, last = (math.degrees(math.atan2(y - pivot[1], x - pivot[0])) for x, y in (start, end))
    turn = (last - first + 180) % 360 - 180
    return sorted(first + turn * step / 40 for step in range(41))


def _laid_out(drive: _Drive) -> _Sketch:
    side = 1 if drive.pivot[1] >= 0 else -1
    width, height = drive.high[0] - drive.low[0], drive.high[1] - drive.low[1]
    beside, around = LEFT + RIGHT, 2 * OUTSIDE + DIMENSIONS
    radius = min(LARGEST_RADIUS, (WIDTH - beside) / width, (MOST_HEIGHT - around) / height)
    mm = 1 / radius
    left, right = drive.low[0] - LEFT * mm, drive.high[0] + RIGHT * mm
    bottom = drive.low[1] - (OUTSIDE + DIMENSIONS * (side > 0)) * mm
    top = drive.high[1] + (OUTSIDE + DIMENSIONS * (side < 0)) * mm
    figure = page((top - bottom) / mm, (right - left) / mm)
    axes = figure.add_axes((0, 0, 1, 1), label="mechanism", xlim=(left, right), ylim=(bottom, top))
    axes.set_axis_off()
    return _Sketch(figure, axes, drive, mm, side)


def _fixed_lines(sketch: _Sketch) -> None:
    """Draw centre lines, the crank circle, the arc and the dead centres on both."""
    drive, mm = sketch.drive, sketch.mm
    beyond, (x, y) = 1 + 3.5 * mm, drive.pivot
    line(sketch, (0, -beyond), (0, beyond), linestyle=CHAIN)
    line(sketch, (-beyond, 0), (drive.high[0] + 4 * mm, 0), linestyle=CHAIN)
    line(sketch, (x, y + sketch.side * 4 * mm), (x, _lowest(sketch)), linestyle=CHAIN)
    crank_circle(sketch)
    turns = _swept(drive.pivot, drive.inner.head, drive.outer.head)
    more = math.degrees(OVERRUN * mm / drive.rocker)
    path = [
        polar_point(drive.pivot, drive.rocker, one) for one in (turns[0] - more, *turns, turns[-1] + more)
    ]
    line(sketch, *path, color=GREY, linewidth=MEDIUM, zorder=2).set_gid("arc")
    for dead in (drive.inner, drive.outer):
        dead_tick(sketch, dead.pin)
        near, far, end = (_from_pivot(sketch, dead.head, way) for way in (-1.6, 1.6, LEADER))
        line(sketch, near, far, linewidth=MEDIUM, zorder=3)
        line(sketch, far, end)


def _from_pivot(sketch: _Sketch, point: Point, way: float) -> Point:
    """Return a point so many mm farther from the pivot."""
    share = 1 + way * sketch.mm / sketch.drive.rocker
    x, y = sketch.drive.pivot
    return x + (point[0] - x) * share, y + (point[1] - y) * share


def _away(drive: _Drive, point: Point) -> Point:
    return point[0] - drive.pivot[0], point[1] - drive.pivot[1]


def _lowest(sketch: _Sketch) -> float:
    """Return how far the lines reach on the side away from the pivot."""
    edge = sketch.drive.low[1] if sketch.side > 0 else sketch.drive.high[1]
    return edge - sketch.side * (OUTSIDE + 1) * sketch.mm


def _pivot_dimensions(sketch: _Sketch) -> None:
    """Draw D and H, the places of the pivot along and across the slide direction."""
    mm, (x, y) = sketch.mm, sketch.drive.pivot
    level = _lowest(sketch) - sketch.side * 2 * mm
    for place, start in ((0.0, -sketch.side * (1 + 4.5 * mm)), (x, _lowest(sketch))):
        line(sketch, (place, start), (place, level - sketch.side * mm))
    dimension(sketch, (0, level), (x, level), "$D$")
    if abs(y) > 3 * mm:
        right = sketch.drive.high[0] + 8 * mm
        for height, start in ((0.0, right - 4 * mm), (y, x + 3 * mm)):
            line(sketch, (start, height), (right + mm, height))
        dimension(sketch, (right, 0), (right, y), "$H$")


def _position_dimensions(sketch: _Sketch, one: ArcPosition) -> None:
    """Draw φ, θ, R, L, B and the path x along the arc."""
    drive, mm = sketch.drive, sketch.mm
    if turn := one.angle % 360:
        crank_angle(sketch, one.pin, turn, 1 / mm)
    beside_link(sketch, (0, 0), one.pin, "$R$", 0.68, 1 if one.pin[1] >= 0 else -1)
    beside_link(sketch, one.pin, one.head, "$L$", 0.45, 1 if one.pin[1] >= one.head[1] else -1)
    beside_link(sketch, drive.pivot, one.head, "$B$", 0.45, -1 if one.rocker_angle < 0 else 1)
    _rocker_angle(sketch, one)
    _path(sketch, one)


def _rocker_angle(sketch: _Sketch, one: ArcPosition) -> None:
    """Draw θ from the rocker's place square to the slide, where it can be seen."""
    mm, square = sketch.mm, -90.0 * sketch.side
    radius = min(22 * mm, 0.5 * sketch.drive.rocker)
    if abs(math.radians(one.rocker_angle)) * radius < 2 * mm:
        return
    first, last = sorted((square, square + one.rocker_angle))
    arc(sketch, sketch.drive.pivot, radius, first, last, arrow=False)
    write(sketch, polar_point(sketch.drive.pivot, radius + 2.6 * mm, (first + last) / 2), THETA, zorder=5)


def _path(sketch: _Sketch, one: ArcPosition) -> None:
    """Draw the path x outside of the arc, from the inner dead centre."""
    drive, mm = sketch.drive, sketch.mm
    turns = _swept(drive.pivot, drive.inner.head, one.head)
    if math.radians(turns[-1] - turns[0]) * drive.rocker < 5 * mm:
        return
    radius = drive.rocker + OUTWARD * mm
    points = [polar_point(drive.pivot, radius, turn) for turn in turns]
    line(sketch, *points, zorder=4)
    for number, other in ((0, 1), (-1, -2)):
        tip, near = points[number], points[other]
        arrowhead(sketch.axes, tip, (tip[0] - near[0], tip[1] - near[1]), mm)
    line(sketch, _from_pivot(sketch, one.head, 1.6), _from_pivot(sketch, one.head, OUTWARD + 1), zorder=4)
    write(sketch, points[len(points) // 2], "$x$")


def _strong(sketch: _Sketch, one: ArcPosition) -> None:
    pivot = sketch.drive.pivot
    line(sketch, (0, 0), one.pin, linewidth=2.4, zorder=6).set_gid("crank")
    line(sketch, one.pin, one.head, linewidth=1.6, zorder=6).set_gid("rod")
    line(sketch, one.head, pivot, linewidth=1.6, zorder=6).set_gid("rocker")
    for centre in ((0.0, 0.0), pivot):
        bearing(sketch, centre)
    for centre in (one.pin, one.head):
        joint(sketch, centre, 1.1, BLACK, MEDIUM)
