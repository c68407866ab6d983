"""The crank drive true to scale: crank, rod and crosshead at given crank angles."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from kurbel.errors import ProblemError
from kurbel.kernel.kinematics import dead_centre_sine
from kurbel.plot.coupler.paths import Coupled, around, draw_paths, usual_scale
from kurbel.plot.moving.positions import LONGEST_ROD as LONGEST_ROD
from kurbel.plot.moving.positions import Position
from kurbel.plot.moving.positions import position as position
from kurbel.plot.paper.fit import fitted
from kurbel.plot.sketch import (
    DEAD_CENTRES,
    DOWN,
    HANGING,
    HATCH,
    LEAST_DIMENSION,
    UP,
    Point,
    Sketch,
    laid_out,
    pin_texts,
)
from kurbel.plot.style import BLACK, MEDIUM, PALE, USUAL, WIDTH, Size, style, text_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# In mm. A short rod leaves the crank more room than it needs.
LARGEST_RADIUS = 24.0
LEFT, OFFSET_LEFT, RIGHT, OUTSIDE, DIMENSIONS, LETTER = 8.0, 3.0, 9.0, 7.0, 17.0, 3.5
HEAD_LENGTH, HEAD_HEIGHT, OVERRUN = 8.0, 6.5, 3.0

PSI = text_of("$ψ$", ".")


class _Drive(NamedTuple):
    """What does not move: λ, η = e/R, the two dead centres, and R in mm."""

    ratio: float
    offset: float
    inner: Position
    outer: Position
    radius: float


def mechanism(
    ratio: float,
    offset: float,
    angles: Sequence[float | Fraction],
    lang: str,
    mark: str,
    size: Size = USUAL,
    paths: Sequence[Coupled] = (),
) -> Figure:
    """Return a drawing of the crank drive, true to scale, by λ = R/L, the offset e/R, angles.

    The shaft is at the left, the slide to the right of it and, by the offset, above; the crank turns
    counter-clockwise from φ = 0, where it points along the slide. The first angle is drawn strong, with its
    dimensions, the others light, with the paths of points of the rod. Raises ProblemError for a rod too long
    or a page too small to be drawn.
    """
    drive = _drive(ratio, offset)
    positions = [position(ratio, offset, float(angle)) for angle in angles]
    with style():
        sketch = _laid_out(drive, positions[0], size, paths)
        _lines_and_circle(sketch, drive)
        _guides(sketch, drive)
        for one in positions[1:]:
            sketch.light_links(((0, 0), one.pin, one.head), (one.pin, one.head), ((0, 0),))
        _dimensions_of_drive(sketch, drive, lang)
        _dimensions_of_position(sketch, drive, positions[0])
        _strong(sketch, positions[0])
        draw_paths(sketch, paths, positions[0].pin, positions[0].head, mark)
        sketch.beside_points(pin_texts([one.pin for one in positions], angles, mark))
        sketch.write()
    return sketch.figure


def _drive(ratio: float, offset: float) -> _Drive:
    if ratio * LONGEST_ROD < 1:
        rod = f"{1 / ratio:.4g} R" if ratio > 0 else "infinite"
        raise ProblemError(
            f"the length of the rod is {rod}; drawn to scale it may be at most {LONGEST_ROD} R, or the crank"
            " is too small to be seen"
        )
    inner = position(ratio, offset, math.degrees(math.asin(dead_centre_sine(ratio, offset))))
    outer = position(ratio, offset, 180 + math.degrees(math.asin(dead_centre_sine(-ratio, -offset))))
    beside = LEFT + (OFFSET_LEFT if offset else 0)
    room = WIDTH - beside - HEAD_LENGTH / 2 - OVERRUN - RIGHT
    return _Drive(ratio, offset, inner, outer, min(LARGEST_RADIUS, room / (1 + inner.head[0])))


def _laid_out(drive: _Drive, first: Position, size: Size, paths: Sequence[Coupled]) -> Sketch:
    # The dimensions stand on that side of the slide where the rod is not.
    side = -1 if first.pin[1] >= drive.offset else 1
    corners = around(lambda mm: _corners(drive, side, mm), paths)
    low, high, mm = fitted(corners, usual_scale(corners, drive.radius, paths), size)
    return laid_out(low, high, mm, side)


def _corners(drive: _Drive, side: int, mm: float) -> tuple[Point, Point]:
    """Return the corners of the page, of which a millimetre is so much of R."""
    beside = LEFT + (OFFSET_LEFT if drive.offset else 0)
    edge = drive.offset + side * (HEAD_HEIGHT / 2 + DIMENSIONS + LETTER * (side > 0)) * mm
    bottom = min(-1 - OUTSIDE * mm, edge, drive.offset - HEAD_HEIGHT * mm)
    top = max(1 + OUTSIDE * mm, edge, drive.offset + HEAD_HEIGHT * mm)
    left, right = -1 - beside * mm, drive.inner.head[0] + (HEAD_LENGTH / 2 + OVERRUN + RIGHT) * mm
    return (left, bottom), (right, top)


def _lines_and_circle(sketch: Sketch, drive: _Drive) -> None:
    mm = sketch.mm
    beyond = 1 + 3.5 * mm
    end = drive.inner.head[0] + (HEAD_LENGTH / 2 + OVERRUN + 2) * mm
    sketch.centre_line((0, -beyond), (0, 0), (0, beyond))
    sketch.centre_line((-beyond, 0), (0, 0), (beyond if drive.offset else end, 0))
    if drive.offset:
        sketch.centre_line((-beyond, drive.offset), (end, drive.offset))
    sketch.crank_circle()
    for dead in (drive.inner, drive.outer):
        sketch.dead_centre(dead.pin)
        sketch.dead_centre(dead.head)


def _guides(sketch: Sketch, drive: _Drive) -> None:
    """Draw both guides of the crosshead, hatched on the side of the frame."""
    mm = sketch.mm
    start = drive.outer.head[0] - (HEAD_LENGTH / 2 + OVERRUN) * mm
    end = drive.inner.head[0] + (HEAD_LENGTH / 2 + OVERRUN) * mm
    for way in (UP, DOWN):
        y = drive.offset + way[1] * HEAD_HEIGHT / 2 * mm
        sketch.ground((start, y), (end, y), way)


def _strong(sketch: Sketch, one: Position) -> None:
    mm = sketch.mm
    corner = (one.head[0] - HEAD_LENGTH / 2 * mm, one.head[1] - HEAD_HEIGHT / 2 * mm)
    from matplotlib.patches import Rectangle

    for level, look in ((0, {"facecolor": PALE, "linewidth": 0}), (5, {"fill": False, "linewidth": MEDIUM})):
        box = Rectangle(corner, HEAD_LENGTH * mm, HEAD_HEIGHT * mm, zorder=level, edgecolor=BLACK)
        box.set(**look)
        sketch.axes.add_patch(box)
    sketch.hide(one.head, (HEAD_LENGTH / 2, HEAD_HEIGHT / 2), False, 5)
    sketch.strong_links(crank=((0, 0), one.pin), rod=(one.pin, one.head))
    # A crank that hangs down would hide the bearing.
    sketch.bearing((0, 0), UP if one.pin[1] < -HANGING else DOWN)
    sketch.joints([one.pin, one.head])


def _dimensions_of_drive(sketch: Sketch, drive: _Drive, lang: str) -> None:
    """Draw the stroke between the dead centres, with their names, and the offset."""
    mm, side = sketch.mm, sketch.side
    level = _level(sketch, drive, 2)
    inner, outer = drive.inner.head[0], drive.outer.head[0]
    sketch.dimension((outer, level), (inner, level), "$S$")
    for x, name in ((inner, "inner"), (outer, "outer")):
        # Above the dimension line the names leave room for its letter.
        end = (x, level + (1 if side < 0 else LETTER) * side * mm)
        sketch.line((x, drive.offset), end, zorder=4)
        opposite = (x, drive.offset - side * (HEAD_HEIGHT / 2 + HATCH + 1) * mm)
        sketch.at_end(end, opposite, DEAD_CENTRES[name][lang])
    if drive.offset:
        x = -1 - 6 * mm
        for y in (0.0, drive.offset):
            sketch.line((x - 1 * mm, y), (-1 - 3 * mm, y))
        sketch.dimension((x, 0), (x, drive.offset), "$e$")


def _dimensions_of_position(sketch: Sketch, drive: _Drive, one: Position) -> None:
    """Draw φ, ψ, R, L and the piston path x."""
    mm = sketch.mm
    # The rod is at the right of the crank, its label at the left.
    sketch.crank_dimensions(one.pin, one.angle % 360)
    sketch.beside((one.pin, one.head), "$L$", 0.4, 1 if sketch.side < 0 else -1)
    _rod_angle(sketch, drive, one)
    level, start = _level(sketch, drive, 1), drive.inner.head[0]
    if (start - one.head[0]) / mm > LEAST_DIMENSION:
        sketch.line(one.head, (one.head[0], level + sketch.side * mm), zorder=4)
        sketch.dimension((start, level), (one.head[0], level), "$x$")


def _level(sketch: Sketch, drive: _Drive, row: int) -> float:
    """Return where the dimension lines of a row are, counted from the guides."""
    return drive.offset + sketch.side * (HEAD_HEIGHT / 2 + 5.5 * row) * sketch.mm


def _rod_angle(sketch: Sketch, drive: _Drive, one: Position) -> None:
    mm, turn = sketch.mm, one.lean
    # The guides leave room for the arc at their end, unless the rod is too short.
    start = drive.outer.head[0] - (HEAD_LENGTH / 2 + OVERRUN + 2.5) * mm
    radius = min(max(one.head[0] - start, 16 * mm), 0.7 / drive.ratio)
    if abs(math.radians(turn)) * radius < 1.2 * mm:
        return
    arc = sketch.arc(one.head, radius, 180 - max(turn, 0), 180 - min(turn, 0), arrow=False)
    # Where there is no room in the angle the letter stands at the slide, not at the rod.
    sketch.beside(arc[::-1] if turn > 0 else arc, PSI, 0.5, 1 if turn > 0 else -1, ends=True)
