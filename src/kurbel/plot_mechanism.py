"""The crank drive true to scale: crank, rod and crosshead at given crank angles."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.errors import ProblemError
from kurbel.kernel.circle import circle
from kurbel.kernel.kinematics import dead_centre_sine, rod_sine
from kurbel.plot_place import AROUND, Points, around, box_points, densely, freest
from kurbel.plot_style import (
    BLACK,
    GREY,
    MEDIUM,
    PALE,
    SMALL_TEXT,
    THIN,
    WHITE,
    WIDTH,
    arrowhead,
    page,
    size_of,
    style,
    text_of,
)
from kurbel.plot_ticks import degrees

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

Point = tuple[float, float]

WORDS = {
    "drive": {"de": "Kurbeltrieb", "en": "Crank drive"},
    "inner": {"de": "innerer Totpunkt", "en": "inner dead centre"},
    "outer": {"de": "äußerer Totpunkt", "en": "outer dead centre"},
}
# In mm. A short rod leaves the crank more room than it needs.
LARGEST_RADIUS = 24.0
LONGEST_ROD = 12
LEFT, OFFSET_LEFT, RIGHT, OUTSIDE, DIMENSIONS = 8.0, 3.0, 9.0, 7.0, 17.0
HEAD_LENGTH, HEAD_HEIGHT, OVERRUN = 8.0, 6.5, 3.0
LEAST_DIMENSION, SMALL_CRANK = 5.0, 9.5
PHI, PSI = text_of("$φ$", "."), text_of("$ψ$", ".")
# Chains of long and short strokes, for centre lines.
CHAIN = (0, (14, 3, 2, 3))
BACKGROUND = {"facecolor": WHITE, "edgecolor": "none", "pad": 0.6}


class Position(NamedTuple):
    """The crank drive at one angle: shaft, crank pin and crosshead pin in units of R."""

    angle: float
    pin: Point
    head: Point
    rod_angle: float


class _Drive(NamedTuple):
    """What does not move: λ, η = e/R, the two dead centres, and R in mm."""

    ratio: float
    offset: float
    inner: Position
    outer: Position
    radius: float


class _Sketch(NamedTuple):
    """A drawing in units of R: what a millimetre is in them, and the side of the dimensions, 1 above."""

    figure: Figure
    axes: Axes
    drive: _Drive
    mm: float
    side: int


def mechanism(
    ratio: float, offset: float, angles: Sequence[float | Fraction], lang: str, mark: str
) -> Figure:
    """Return a drawing of the crank drive, true to scale and 120 mm wide: λ = R/L, the offset e/R, angles.

    The shaft is at the left, the slide to the right of it and, by the offset, above; the crank turns
    counter-clockwise from φ = 0, where it points along the slide. The first angle is drawn strong, with its
    dimensions, the others light. Raises ProblemError for a rod too long to be drawn.
    """
    drive = _drive(ratio, offset)
    positions = [position(ratio, offset, float(angle)) for angle in angles]
    with style():
        sketch = _laid_out(drive, positions[0])
        _lines_and_circle(sketch)
        _guides(sketch)
        for one in positions[1:]:
            _light(sketch, one)
        _dimensions_of_drive(sketch, lang)
        _dimensions_of_position(sketch, positions[0])
        _strong(sketch, positions[0])
        if len(angles) > 1:
            _angle_texts(sketch, positions, [degrees(angle, mark) for angle in angles])
    return sketch.figure


def position(ratio: float, offset: float, angle: float) -> Position:
    """Return crank pin and crosshead pin in units of R, from the shaft; the rod's angle ψ in degrees."""
    point = circle(angle)
    sine = rod_sine(point, ratio, offset)
    along = point.cosine + math.sqrt((1 - sine) * (1 + sine)) / ratio
    return Position(angle, (point.cosine, point.sine), (along, offset), math.degrees(math.asin(sine)))


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


def _laid_out(drive: _Drive, first: Position) -> _Sketch:
    # The dimensions stand on that side of the slide where the rod is not.
    side = -1 if first.pin[1] >= drive.offset else 1
    mm = 1 / drive.radius
    beside = LEFT + (OFFSET_LEFT if drive.offset else 0)
    edge = drive.offset + side * (HEAD_HEIGHT / 2 + DIMENSIONS) * mm
    bottom = min(-1 - OUTSIDE * mm, edge, drive.offset - HEAD_HEIGHT * mm)
    top = max(1 + OUTSIDE * mm, edge, drive.offset + HEAD_HEIGHT * mm)
    left, right = -1 - beside * mm, drive.inner.head[0] + (HEAD_LENGTH / 2 + OVERRUN + RIGHT) * mm
    figure = page((top - bottom) / mm, (right - left) / mm)
    axes = figure.add_axes((0, 0, 1, 1), label="mechanism", xlim=(left, right), ylim=(bottom, top))
    axes.set_axis_off()
    return _Sketch(figure, axes, drive, mm, side)


def _line(sketch: _Sketch, *points: Point, **look: Any) -> Line2D:
    own: dict[str, Any] = {"color": BLACK, "linewidth": THIN, "solid_capstyle": "butt"}
    return sketch.axes.plot(*zip(*points, strict=True), **(own | look))[0]


def _lines_and_circle(sketch: _Sketch) -> None:
    from matplotlib.patches import Circle

    drive, mm = sketch.drive, sketch.mm
    beyond = 1 + 3.5 * mm
    end = drive.inner.head[0] + (HEAD_LENGTH / 2 + OVERRUN + 2) * mm
    _line(sketch, (0, -beyond), (0, beyond), linestyle=CHAIN)
    _line(sketch, (-beyond, 0), (beyond if drive.offset else end, 0), linestyle=CHAIN)
    if drive.offset:
        _line(sketch, (-beyond, drive.offset), (end, drive.offset), linestyle=CHAIN)
    sketch.axes.add_patch(Circle((0, 0), 1, fill=False, edgecolor=GREY, linewidth=MEDIUM, zorder=2))
    for dead in (drive.inner, drive.outer):
        x, y = dead.pin
        inside, outside = 1 - 1.6 * mm, 1 + 1.6 * mm
        _line(sketch, (x * inside, y * inside), (x * outside, y * outside), linewidth=MEDIUM, zorder=3)


def _guides(sketch: _Sketch) -> None:
    """Draw both guides of the crosshead, hatched on the side of the frame."""
    drive, mm = sketch.drive, sketch.mm
    start = drive.outer.head[0] - (HEAD_LENGTH / 2 + OVERRUN) * mm
    end = drive.inner.head[0] + (HEAD_LENGTH / 2 + OVERRUN) * mm
    count = int((end - start) / (1.5 * mm))
    for side in (-1, 1):
        y = drive.offset + side * HEAD_HEIGHT / 2 * mm
        _line(sketch, (start, y), (end, y), linewidth=MEDIUM, zorder=2)
        for number in range(count):
            x = start + (number + 0.9) * (end - start) / count
            across = (x - 1.1 * mm, y + 1.1 * mm) if side > 0 else (x - 1.1 * mm, y - 1.1 * mm)
            _line(sketch, (x, y), across, color=GREY, zorder=1)


def _light(sketch: _Sketch, one: Position) -> None:
    _line(sketch, (0, 0), one.pin, color=GREY, linewidth=MEDIUM, zorder=3)
    _line(sketch, one.pin, one.head, color=GREY, linewidth=MEDIUM, zorder=3)
    for joint in (one.pin, one.head):
        _joint(sketch, joint, 0.7, GREY, MEDIUM)


def _strong(sketch: _Sketch, one: Position) -> None:
    mm = sketch.mm
    corner = (one.head[0] - HEAD_LENGTH / 2 * mm, one.head[1] - HEAD_HEIGHT / 2 * mm)
    from matplotlib.patches import Rectangle

    box = Rectangle(corner, HEAD_LENGTH * mm, HEAD_HEIGHT * mm, zorder=5)
    box.set(facecolor=PALE, edgecolor=BLACK, linewidth=MEDIUM)
    sketch.axes.add_patch(box)
    _line(sketch, (0, 0), one.pin, linewidth=2.4, zorder=6).set_gid("crank")
    _line(sketch, one.pin, one.head, linewidth=1.6, zorder=6).set_gid("rod")
    _joint(sketch, (0, 0), 1.7, BLACK, MEDIUM)
    _joint(sketch, (0, 0), 0.35, BLACK, MEDIUM, BLACK)
    for joint in (one.pin, one.head):
        _joint(sketch, joint, 1.1, BLACK, MEDIUM)


def _joint(
    sketch: _Sketch, centre: Point, radius: float, colour: str, width: float, filling: str = WHITE
) -> None:
    from matplotlib.patches import Circle

    disc = Circle(centre, radius * sketch.mm, zorder=7 if colour == BLACK else 4)
    disc.set(facecolor=filling, edgecolor=colour, linewidth=width)
    sketch.axes.add_patch(disc)


def _angle_texts(sketch: _Sketch, positions: Sequence[Position], texts: Sequence[str]) -> None:
    """Write the angles beside the crank pins, outside the circle where there is room."""
    import numpy as np

    (left, right), (bottom, top) = sketch.axes.get_xlim(), sketch.axes.get_ylim()
    corner, mm = np.asarray((left, bottom)), sketch.mm
    frame = (0, 0, (right - left) / mm, (top - bottom) / mm)
    taken = (_drawn(sketch) - corner) / mm
    for one, text in zip(positions, texts, strict=True):
        size = size_of(text, SMALL_TEXT)
        near = around((np.asarray(one.pin) - corner) / mm, size, np.asarray(one.pin))
        place = freest(near, size, np.empty((0, 2)), taken, frame, AROUND)
        if place is not None:
            taken = np.concatenate((taken, box_points(place, size)))
            x, y = corner + place * mm
            _text(sketch, (float(x), float(y)), text, fontsize=SMALL_TEXT, bbox=None)


def _drawn(sketch: _Sketch) -> Points:
    """Return points of all lines and texts so far."""
    import numpy as np

    apart = 0.5 * sketch.mm
    circle = [_polar((0, 0), 1, turn) for turn in range(0, 361, 5)]
    lines = [np.asarray(circle), *(np.asarray(line.get_xydata()) for line in sketch.axes.lines)]
    boxes = [text.get_window_extent() for text in sketch.axes.texts]
    to_radii = sketch.axes.transData.inverted()
    corners = [to_radii.transform(((box.x0, box.y0), (box.x1, box.y1))) for box in boxes]
    written = [box_points(low / 2 + high / 2, tuple(high - low), apart) for low, high in corners]
    return np.concatenate([*(densely(line, apart) for line in lines), *written])


def _text(sketch: _Sketch, place: Point, text: str, **look: Any) -> None:
    own: dict[str, Any] = {"ha": "center", "va": "center", "zorder": 8, "bbox": BACKGROUND}
    sketch.axes.text(*place, text, **(own | look))


def _dimensions_of_drive(sketch: _Sketch, lang: str) -> None:
    """Draw the stroke between the dead centres, with their names, and the offset."""
    drive, mm, side = sketch.drive, sketch.mm, sketch.side
    level = _level(sketch, 2)
    inner, outer = drive.inner.head[0], drive.outer.head[0]
    _dimension(sketch, (outer, level), (inner, level), "$S$")
    names = [(inner, WORDS["inner"][lang], "left", 1), (outer, WORDS["outer"][lang], "right", -1)]
    widest = max(size_of(name, SMALL_TEXT)[0] for _, name, _, _ in names) + 2
    for x, name, towards, way in names:
        _line(sketch, (x, drive.offset - side * 1.2 * mm), (x, level + side * 1 * mm), zorder=4)
        look: dict[str, Any] = {}
        if inner - outer < widest * mm:
            x, look = (inner + outer) / 2 + way * mm, {"ha": towards}
        _text(sketch, (x, level + side * 3.2 * mm), name, fontsize=SMALL_TEXT, **look)
    if drive.offset:
        x = -1 - 6 * mm
        for y in (0.0, drive.offset):
            _line(sketch, (x - 1 * mm, y), (-1 - 3 * mm, y))
        _dimension(sketch, (x, 0), (x, drive.offset), "$e$")


def _dimensions_of_position(sketch: _Sketch, one: Position) -> None:
    """Draw φ, ψ, R, L and the piston path x."""
    mm = sketch.mm
    if turn := one.angle % 360:
        _crank_angle(sketch, one, turn)
    # The rod is at the right of the crank, its label at the left.
    _beside(sketch, (0, 0), one.pin, "$R$", 0.68, 1 if one.pin[1] >= 0 else -1)
    _beside(sketch, one.pin, one.head, "$L$", 0.4, 1 if sketch.side < 0 else -1)
    _rod_angle(sketch, one)
    level, start = _level(sketch, 1), sketch.drive.inner.head[0]
    if (start - one.head[0]) / mm > LEAST_DIMENSION:
        _line(sketch, one.head, (one.head[0], level + sketch.side * mm), zorder=4)
        _dimension(sketch, (start, level), (one.head[0], level), "$x$")


def _crank_angle(sketch: _Sketch, one: Position, turn: float) -> None:
    mm, radius, share = sketch.mm, 0.42, 0.5
    if sketch.drive.radius < SMALL_CRANK:
        # There is no room within the circle; outside, the rod passes above the middle of the arc.
        radius, share, end = 1 + 2.4 * mm, 0.3, 1 + 4 * mm
        _line(sketch, one.pin, (one.pin[0] * end, one.pin[1] * end), zorder=4)
    _arc(sketch, (0, 0), radius, 0, turn, arrow=True)
    _text(sketch, _polar((0, 0), radius + 2.5 * mm, turn * share), PHI, zorder=5)


def _polar(centre: Point, radius: float, turn: float) -> Point:
    angle = math.radians(turn)
    return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)


def _level(sketch: _Sketch, row: int) -> float:
    """Return where the dimension lines of a row are, counted from the guides."""
    return sketch.drive.offset + sketch.side * (HEAD_HEIGHT / 2 + 5.5 * row) * sketch.mm


def _rod_angle(sketch: _Sketch, one: Position) -> None:
    mm, turn = sketch.mm, one.rod_angle
    # The guides leave room for the arc at their end, unless the rod is too short.
    start = sketch.drive.outer.head[0] - (HEAD_LENGTH / 2 + OVERRUN + 2.5) * mm
    radius = min(max(one.head[0] - start, 16 * mm), 0.7 / sketch.drive.ratio)
    if abs(math.radians(turn)) * radius < 1.2 * mm:
        return
    _arc(sketch, one.head, radius, 180 - max(turn, 0), 180 - min(turn, 0), arrow=False)
    place = _polar(one.head, radius + 2.3 * mm, 180 - turn / 2)
    if abs(math.radians(turn)) * (radius + 2.3 * mm) < 3.6 * mm:
        place = (one.head[0] - radius, one.head[1] + sketch.side * 2.6 * mm)
    # The rod passes over the background of the letter, which would cut it.
    _text(sketch, place, PSI, zorder=5)


def _arc(sketch: _Sketch, centre: Point, radius: float, start: float, end: float, arrow: bool) -> None:
    steps = max(2, int((end - start) / 2) + 1)
    turns = [start + (end - start) * step / steps for step in range(steps + 1)]
    points = [_polar(centre, radius, turn) for turn in turns]
    _line(sketch, *points, linewidth=MEDIUM, zorder=4)
    if arrow:
        # The head is straight: turned by half its own length it follows the arc.
        lean = math.radians(end) - 0.95 * sketch.mm / radius
        arrowhead(sketch.axes, points[-1], (-math.sin(lean), math.cos(lean)), sketch.mm)


def _beside(sketch: _Sketch, start: Point, end: Point, text: str, share: float, side: int) -> None:
    """Write a text beside a link, on its left (1) or right (-1), at a share of its length."""
    x, y = (begin + share * (stop - begin) for begin, stop in zip(start, end, strict=True))
    length = math.dist(start, end)
    distance = side * 2.6 * sketch.mm / length
    _text(sketch, (x - (end[1] - start[1]) * distance, y + (end[0] - start[0]) * distance), text)


def _dimension(sketch: _Sketch, start: Point, end: Point, text: str) -> None:
    """Draw a dimension line; where it is too short for two arrows they point at it from outside."""
    mm, length = sketch.mm, math.dist(start, end)
    way = ((end[0] - start[0]) / length, (end[1] - start[1]) / length)
    inside = length > LEAST_DIMENSION * mm
    reach = 0 if inside else 4 * mm
    _line(sketch, _moved(start, way, -reach), _moved(end, way, reach), zorder=4)
    outward = 1 if inside else -1
    arrowhead(sketch.axes, start, (-outward * way[0], -outward * way[1]), mm)
    arrowhead(sketch.axes, end, (outward * way[0], outward * way[1]), mm)
    beside = 0 if inside else 2.2 * mm
    middle = _moved(start, way, length / 2)
    _text(sketch, (middle[0] - beside * abs(way[1]), middle[1] + beside * abs(way[0])), text)


def _moved(point: Point, way: Point, distance: float) -> Point:
    return point[0] + distance * way[0], point[1] + distance * way[1]
