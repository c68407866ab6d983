"""Mechanisms that stand at given crank angles, true to scale, with their dimensions.

The first angle is drawn strong, with its dimensions, the others light, and the paths of points of the rod.
The shaft is at the left; the crank turns counter-clockwise from φ = 0.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.errors import ProblemError
from kurbel.linkage.linkage import LinkagePosition, Outline
from kurbel.linkage.rocker import RockerCrank
from kurbel.plot.moving import (
    LONGEST_ROD,
    SHAFT,
    FixedExtent,
    Position,
    Rocker,
    RockingDrive,
    Slide,
    crank_pin,
    links_fixed,
    polar_point,
)
from kurbel.plot.panel import DEAD_CENTRES, degrees
from kurbel.plot.place import CLEAR
from kurbel.plot.sketch import (
    DOWN,
    HANGING,
    HATCH,
    LEAST_DIMENSION,
    LEFTWARD,
    UP,
    Point,
    Sketch,
    Text,
    laid_out,
    page_fitted,
)
from kurbel.plot.stage import RodPointPath, around, draw_fixed, draw_paths, usual_scale
from kurbel.plot.style import BLACK, MEDIUM, PALE, WIDTH, Size, arrowhead, style, text_of
from kurbel.reading.notation import about

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# In mm. A short rod leaves the crank more room than it needs.
LARGEST_RADIUS, MOST_HEIGHT = 24.0, 150.0
# Around a drive: at the left, below and above, and for dimensions; beside links without a crosshead.
LEFT, OUTSIDE, DIMENSIONS, BESIDE = 8.0, 7.0, 9.0, 9.0
# How far centre lines go on beyond a crank circle.
SHAFT_OVERRUN = 3.5
# Around a slide, where an offset is dimensioned at the left; its crosshead, and how far the guides go on.
OFFSET_LEFT, SLIDE_RIGHT, SLIDE_DIMENSIONS, LETTER = 3.0, 9.0, 17.0, 3.5
HEAD_LENGTH, HEAD_HEIGHT, OVERRUN = 8.0, 6.5, 3.0
# At the right of a rocker, whose pivot is dimensioned there. The arc goes on beyond the dead centres by so
# many mm, the path is dimensioned so far outside of it, and the names of these end lines so long.
ROCKER_RIGHT, ARC_OVERRUN, OUTWARD, LEADER = 17.0, 4.0, 4.5, 7.0
PSI, THETA = text_of("$ψ$", "."), text_of("$θ$", ".")


class StandingDrawing(ABC):
    """A mechanism with its shafts, and by itself so many mm for a unit."""

    shafts: tuple[Point, ...] = (SHAFT,)
    usual: float
    # Where the names of dead centres come from.
    lang: str = "de"

    @abstractmethod
    def stand(self, angle: float) -> LinkagePosition:
        """Return its links and pins at a crank angle in degrees."""

    def side(self, pin: Point) -> int:
        """Return on which side the dimensions stand, 1 above, -1 below, by the place of the first pin."""
        return 1

    @abstractmethod
    def corners(self, side: int, mm: float) -> tuple[Point, Point]:
        """Return the corners of the page, of which a millimetre is so much of R."""

    @abstractmethod
    def fixed(self, sketch: Sketch) -> None:
        """Draw what does not move."""

    @abstractmethod
    def dimensions(self, sketch: Sketch, angle: float) -> None:
        """Draw the dimensions of the drive, and those of the first position."""

    def ground(self, pin: Point, shaft: Point) -> Point:
        """Return in which direction the ground of a shaft is; a crank that hangs down would hide it."""
        return UP if pin[1] < -HANGING else DOWN

    def strong(self, sketch: Sketch, first: LinkagePosition, pin: Point) -> None:
        sketch.strong_links(**first.links)
        for shaft in self.shafts:
            sketch.bearing(shaft, self.ground(pin, shaft))
        sketch.joints(first.pins)

    def names(self, mm: float) -> Sequence[Text]:
        """Return the names of places that do not move, for `beside_points`."""
        return ()

    def drawn(
        self,
        angles: Sequence[float | Fraction],
        lang: str,
        mark: str,
        size: Size,
        paths: Sequence[RodPointPath],
    ) -> Figure:
        """Return the drawing; raises ProblemError for a page that is too small."""
        self.lang = lang
        pins = [crank_pin(float(angle)) for angle in angles]
        stands = [self.stand(float(angle)) for angle in angles]
        side = self.side(pins[0])
        corners = around(lambda mm: self.corners(side, mm), paths)
        with style():
            scale = usual_scale(corners, self.usual, paths)
            sketch = laid_out(*page_fitted(corners, scale, size), side)
            self.fixed(sketch)
            for one in stands[1:]:
                for chain in one.chains:
                    sketch.light_links(chain, one.pins, self.shafts)
            self.dimensions(sketch, float(angles[0]))
            self.strong(sketch, stands[0], pins[0])
            if paths:
                draw_paths(sketch, paths, *stands[0].links["rod"], mark)
            sketch.beside_points(self.names(sketch.mm), CLEAR)
            several = zip(pins, angles, strict=True) if len(pins) > 1 else ()
            sketch.beside_points([(pin, pin, degrees(angle, mark)) for pin, angle in several])
            sketch.write()
        return sketch.figure


class SwungStanding(StandingDrawing):
    """One whose rod has two dead centres."""

    drive: RockingDrive

    def stand(self, angle: float) -> LinkagePosition:
        return self.drive.stand(angle)


class SlideStanding(SwungStanding):
    """The crank drive by λ = R/L and the offset e/R; the slide is to the right of the shaft and, by the
    offset, above. Raises ProblemError for a rod too long to be drawn."""

    drive: Slide

    def __init__(self, ratio: float, offset: float) -> None:
        if ratio * LONGEST_ROD < 1:
            rod = f"{1 / ratio:.4g} R" if ratio > 0 else "infinite"
            raise ProblemError(
                f"the length of the rod is {rod}; drawn to scale it may be at most {LONGEST_ROD} R, or the"
                " crank is too small to be seen"
            )
        self.drive, self.offset = Slide(ratio, offset), offset
        self.beside = LEFT + (OFFSET_LEFT if offset else 0)
        self.start, self.end = self.drive.outer.head[0], self.drive.inner.head[0]
        room = WIDTH - self.beside - HEAD_LENGTH / 2 - OVERRUN - SLIDE_RIGHT
        self.usual = min(LARGEST_RADIUS, room / (1 + self.end))

    def side(self, pin: Point) -> int:
        # On that side of the slide where the rod is not.
        return -1 if pin[1] >= self.offset else 1

    def corners(self, side: int, mm: float) -> tuple[Point, Point]:
        edge = self.offset + side * (HEAD_HEIGHT / 2 + SLIDE_DIMENSIONS + LETTER * (side > 0)) * mm
        bottom = min(-1 - OUTSIDE * mm, edge, self.offset - HEAD_HEIGHT * mm)
        top = max(1 + OUTSIDE * mm, edge, self.offset + HEAD_HEIGHT * mm)
        right = self.end + (HEAD_LENGTH / 2 + OVERRUN + SLIDE_RIGHT) * mm
        return (-1 - self.beside * mm, bottom), (right, top)

    def fixed(self, sketch: Sketch) -> None:
        overrun, mm = HEAD_LENGTH / 2 + OVERRUN, sketch.mm
        right = self.end + (overrun + 2) * mm
        reach = FixedExtent(1 + SHAFT_OVERRUN * mm, right, overrun * mm, HEAD_HEIGHT / 2 * mm)
        draw_fixed(sketch, (*self.drive.fixed(reach), *self.drive.dead), self.shafts)

    def strong(self, sketch: Sketch, first: LinkagePosition, pin: Point) -> None:
        from matplotlib.patches import Rectangle

        (x, y), mm = first.pins[1], sketch.mm
        corner = (x - HEAD_LENGTH / 2 * mm, y - HEAD_HEIGHT / 2 * mm)
        for level, look in (
            (0, {"facecolor": PALE, "linewidth": 0}),
            (5, {"fill": False, "linewidth": MEDIUM}),
        ):
            box = Rectangle(corner, HEAD_LENGTH * mm, HEAD_HEIGHT * mm, zorder=level, edgecolor=BLACK)
            box.set(**look)
            sketch.axes.add_patch(box)
        sketch.hide((x, y), (HEAD_LENGTH / 2, HEAD_HEIGHT / 2), False, 5)
        super().strong(sketch, first, pin)

    def dimensions(self, sketch: Sketch, angle: float) -> None:
        """Draw the stroke between the dead centres, with their names, and the offset; φ, ψ, R, L and the
        piston path x."""
        mm, side, one = sketch.mm, sketch.side, self.drive.at(angle)
        level = self._level(sketch, 2)
        sketch.dimension((self.start, level), (self.end, level), "$S$")
        for x, name in ((self.end, "inner"), (self.start, "outer")):
            # Above the dimension line the names leave room for its letter.
            end = (x, level + (1 if side < 0 else LETTER) * side * mm)
            sketch.line((x, self.offset), end, zorder=4)
            opposite = (x, self.offset - side * (HEAD_HEIGHT / 2 + HATCH + 1) * mm)
            sketch.at_end(end, opposite, DEAD_CENTRES[name][self.lang])
        if self.offset:
            x = -1 - 6 * mm
            for y in (0.0, self.offset):
                sketch.line((x - 1 * mm, y), (-1 - 3 * mm, y))
            sketch.dimension((x, 0), (x, self.offset), "$e$")
        # The rod is at the right of the crank, its label at the left.
        sketch.crank_dimensions(one.pin, angle % 360)
        sketch.beside((one.pin, one.head), "$L$", 0.4, 1 if side < 0 else -1)
        self._rod_angle(sketch, one)
        level = self._level(sketch, 1)
        if (self.end - one.head[0]) / mm > LEAST_DIMENSION:
            sketch.line(one.head, (one.head[0], level + side * mm), zorder=4)
            sketch.dimension((self.end, level), (one.head[0], level), "$x$")

    def _level(self, sketch: Sketch, row: int) -> float:
        """Return where the dimension lines of a row are, counted from the guides."""
        return self.offset + sketch.side * (HEAD_HEIGHT / 2 + 5.5 * row) * sketch.mm

    def _rod_angle(self, sketch: Sketch, one: Position) -> None:
        mm, turn = sketch.mm, one.lean
        # The guides leave room for the arc at their end, unless the rod is too short.
        start = self.start - (HEAD_LENGTH / 2 + OVERRUN + 2.5) * mm
        radius = min(max(one.head[0] - start, 16 * mm), 0.7 / self.drive.ratio)
        if abs(math.radians(turn)) * radius < 1.2 * mm:
            return
        arc = sketch.arc(one.head, radius, 180 - max(turn, 0), 180 - min(turn, 0), arrow=False)
        # Where there is no room in the angle the letter stands at the slide, not at the rod.
        sketch.beside(arc[::-1] if turn > 0 else arc, PSI, 0.5, 1 if turn > 0 else -1, ends=True)


class RockerStanding(SwungStanding):
    """The arc crank or the beam engine: φ counts from the slide direction, θ likewise from the rocker square
    to it. Raises ProblemError for links too long to be drawn."""

    drive: Rocker

    def __init__(self, crank: RockerCrank) -> None:
        if crank.crank.ratio * LONGEST_ROD < 1 or crank.rocker > LONGEST_ROD:
            rod = f"{about(1 / crank.crank.ratio)} R" if crank.crank.ratio else "infinite"
            raise ProblemError(
                f"the length of the rod is {rod}, that of the rocker {about(crank.rocker)} R; drawn to scale"
                f" they may be at most {LONGEST_ROD} R, or the crank is too small to be seen"
            )
        drive = self.drive = Rocker(crank)
        self.letter, self.pivot = f"${crank.letter}$", drive.pivot
        self.shafts = (SHAFT, drive.pivot)
        arc = drive.arc()
        reached = [drive.pivot, *arc, *map(drive.end, arc), (-1.0, -1.0), (1.0, 1.0)]
        self.low, self.high = ((end(x for x, _ in reached), end(y for _, y in reached)) for end in (min, max))
        width, height = self.high[0] - self.low[0], self.high[1] - self.low[1]
        beside, above = LEFT + ROCKER_RIGHT, 2 * OUTSIDE + DIMENSIONS
        self.usual = min(LARGEST_RADIUS, (WIDTH - beside) / width, (MOST_HEIGHT - above) / height)

    def side(self, pin: Point) -> int:
        return 1 if self.pivot[1] >= 0 else -1

    def corners(self, side: int, mm: float) -> tuple[Point, Point]:
        left, right = self.low[0] - LEFT * mm, self.high[0] + ROCKER_RIGHT * mm
        bottom = self.low[1] - (OUTSIDE + DIMENSIONS * (side > 0)) * mm
        return (left, bottom), (right, self.high[1] + (OUTSIDE + DIMENSIONS * (side < 0)) * mm)

    def beyond(self, point: Point, way: float) -> Point:
        """Return a point so much farther from the pivot."""
        share, (x, y) = 1 + way / self.drive.length, self.pivot
        return x + (point[0] - x) * share, y + (point[1] - y) * share

    def ground(self, pin: Point, shaft: Point) -> Point:
        if shaft == SHAFT:
            return super().ground(pin, shaft)
        return LEFTWARD if self.drive.is_beam else UP if self.pivot[1] >= 0 else DOWN

    def fixed(self, sketch: Sketch) -> None:
        mm, drive, (x, y) = sketch.mm, self.drive, self.pivot
        reach = FixedExtent(1 + SHAFT_OVERRUN * mm, self.high[0] + 4 * mm, ARC_OVERRUN * mm)
        draw_fixed(sketch, (*drive.fixed(reach), *drive.dead), self.shafts)
        sketch.centre_line((x, y + sketch.side * 4 * mm), (x, y), (x, self._lowest(sketch)))
        for dead in (drive.inner, drive.outer):
            sketch.line(dead.head, self.beyond(dead.head, LEADER * mm))

    def _lowest(self, sketch: Sketch) -> float:
        """Return how far the lines reach on the side away from the pivot."""
        edge = self.low[1] if sketch.side > 0 else self.high[1]
        return edge - sketch.side * (OUTSIDE + 1) * sketch.mm

    def dimensions(self, sketch: Sketch, angle: float) -> None:
        """Draw D and H, the places of the pivot along and across the slide direction; φ, θ, R, L, B and the
        path x along the arc."""
        mm, side, (x, y), one = sketch.mm, sketch.side, self.pivot, self.drive.at(angle)
        level = self._lowest(sketch) - side * 2 * mm
        for place, start in ((0.0, -side * (1 + 4.5 * mm)), (x, self._lowest(sketch))):
            sketch.line((place, start), (place, level - side * mm))
        sketch.dimension((0, level), (x, level), "$D$")
        if abs(y) > 3 * mm:
            right = self.high[0] + 8 * mm
            for height, start in ((0.0, right - 4 * mm), (y, x + 3 * mm)):
                sketch.line((start, height), (right + mm, height))
            sketch.dimension((right, 0), (right, y), "$H$")
        sketch.crank_dimensions(one.pin, angle % 360)
        sketch.beside((one.pin, one.head), "$L$", 0.45, 1 if one.pin[1] >= one.head[1] else -1)
        sketch.beside((self.pivot, one.head), self.letter, 0.45, -1 if one.lean < 0 else 1)
        self._rocker_angle(sketch, one)
        self._path(sketch, one)

    def _rocker_angle(self, sketch: Sketch, one: Position) -> None:
        """Draw θ from the rocker's place square to the slide, where it can be seen."""
        mm, square = sketch.mm, -90.0 * sketch.side
        radius = min(22 * mm, 0.5 * self.drive.length)
        if abs(math.radians(one.lean)) * radius < 2 * mm:
            return
        first, last = sorted((square, square + one.lean))
        sketch.beside(sketch.arc(self.pivot, radius, first, last, arrow=False), THETA, 0.5, -1, ends=True)

    def _path(self, sketch: Sketch, one: Position) -> None:
        """Draw the path x outside of the arc, from the inner dead centre."""
        mm, drive = sketch.mm, self.drive
        turns = drive.swept(drive.inner.head, one.head)
        if math.radians(turns[-1] - turns[0]) * drive.length < 5 * mm:
            return
        points = [polar_point(self.pivot, drive.length + OUTWARD * mm, turn) for turn in turns]
        sketch.line(*points, zorder=4)
        for tip, near in (points[:2], points[:-3:-1]):
            arrowhead(sketch.axes, tip, (tip[0] - near[0], tip[1] - near[1]), mm)
        sketch.line(self.beyond(one.head, 1.6 * mm), self.beyond(one.head, (OUTWARD + 1) * mm), zorder=4)
        sketch.beside(points, "$x$", 0.5, -1)

    def names(self, mm: float) -> Sequence[Text]:
        x, y = self.pivot
        heads = {"inner": self.drive.inner.head, "outer": self.drive.outer.head}
        return [
            (self.beyond(head, LEADER * mm), (head[0] - x, head[1] - y), DEAD_CENTRES[name][self.lang])
            for name, head in heads.items()
        ]


class LinksStanding(StandingDrawing):
    """A drive by what it says of its outline: cranks turn from the line of shafts."""

    def __init__(self, outline: Outline) -> None:
        self.outline, self.shafts = outline, (*outline.shafts, *outline.pivots)
        self.usual = (WIDTH - 2 * BESIDE) / (outline.right - outline.left)

    def stand(self, angle: float) -> LinkagePosition:
        return self.outline.stand(crank_pin(angle))

    def corners(self, side: int, mm: float) -> tuple[Point, Point]:
        left, right = self.outline.left - BESIDE * mm, self.outline.right + BESIDE * mm
        low, high = self.outline.low, self.outline.high
        return (left, low - (OUTSIDE + DIMENSIONS) * mm), (right, high + OUTSIDE * mm)

    def fixed(self, sketch: Sketch) -> None:
        beyond = SHAFT_OVERRUN * sketch.mm
        draw_fixed(sketch, links_fixed(self.outline, 1 + beyond, beyond), self.outline.shafts)

    def dimensions(self, sketch: Sketch, angle: float) -> None:
        """Draw φ and R of the first crank, the letters of links, and lengths along the line of shafts."""
        mm, pin, stand = sketch.mm, crank_pin(angle), self.stand(angle)
        sketch.crank_dimensions(pin, angle % 360)
        for name, letter, share in stand.letters:
            sketch.beside(stand.links[name], letter, share, 1 if pin[1] >= 0 else -1)
        level = -1 - (OUTSIDE + 4) * mm
        for start, end, letter in stand.lengths:
            if abs(end - start) > mm:
                for x in (start, end):
                    sketch.line((x, -1 - 4.5 * mm), (x, level - mm))
                sketch.dimension((start, level), (end, level), letter)
