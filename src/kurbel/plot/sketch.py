"""What drawings of mechanisms are made of: links, joints, bearings, dimensions, texts where there is room.

Lengths are in units of the crank radius R. Lines are those of ISO 128-2: links are extra-wide, outlines
wide, all others narrow. Dimensions are those of ISO 129-1: filled arrows of 15°, each text above its line, to
be read from below or from the right.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise
from math import ceil
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kurbel.errors import ProblemError
from kurbel.plot.lettering import Hole, Lettering, cut
from kurbel.plot.moving import polar_point
from kurbel.plot.style import (
    BLACK,
    HEAVY,
    LONG_DASH_DOT,
    LONG_DASH_DOUBLE_DOT,
    MEDIUM,
    MM,
    STRONG,
    THIN,
    arrowhead,
    fitted,
    page,
    text_of,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D
    from matplotlib.path import Path

    from kurbel.plot.style import Size

# Lower left and upper right in units of a drawing's own, by how many of them a millimetre is.
Corners = Callable[[float], tuple[tuple[float, float], tuple[float, float]]]
# In mm for a unit: below the least nothing can be told apart.
LEAST, MOST = 4.0, 1000.0
STEPS = 60


def page_fitted(
    corners: Corners, usual: float, size: Size
) -> tuple[tuple[float, float], tuple[float, float], float]:
    """Return corners that fill a page, and a millimetre in the drawing's units.

    The drawing is in the middle of the page. So many mm for a unit are usual; a page of another width or
    height has as many as fit it. Raises ProblemError for a page that is too small.
    """
    if not size.exact and size.height is None:
        return (*corners(1 / usual), 1 / usual)
    least = _extent(corners, LEAST)
    if not _fits(least, size):
        height = "" if size.height is None else f" and {size.height:.6g} mm high"
        raise ProblemError(
            f"the drawing is {size.width:.6g} mm wide{height}; to scale this one needs {ceil(least[0])} mm"
            f" and {ceil(least[1])} mm"
        )
    low, high = LEAST, MOST if size.exact else usual
    for _ in range(STEPS):
        middle = (low + high) / 2
        low, high = (middle, high) if _fits(_extent(corners, middle), size) else (low, middle)
    (left, bottom), (right, top) = corners(1 / low)
    across, up = _extent(corners, low)
    spare = (size.width - across if size.exact else 0.0, size.height - up if size.height else 0.0)
    along, above = (one / 2 / low for one in spare)
    return (left - along, bottom - above), (right + along, top + above), 1 / low


def _extent(corners: Corners, scale: float) -> tuple[float, float]:
    """Return width and height in mm at so many mm for a unit."""
    (left, bottom), (right, top) = corners(1 / scale)
    return (right - left) * scale, (top - bottom) * scale


def _fits(extent: tuple[float, float], size: Size) -> bool:
    return extent[0] <= size.width and (size.height is None or extent[1] <= size.height)


Point = tuple[float, float]
# A text for a point, with the direction from it that is best.
Text = tuple[Point, Point, str]

# In mm: dimensions, discs, and bearings with their ground.
LEAST_DIMENSION, SMALL_CRANK = 5.0, 9.5
SHAFT, PIN, LIGHT_PIN, CENTRE, DEAD, DOT = 1.7, 1.1, 0.7, 0.35, 0.5, 0.45
BEARING, GROUND, HATCH = 4.2, 3.0, 1.1
# The sine of the crank angle, with a minus, beyond which the crank would hide a bearing under the shaft.
HANGING = 0.3
# The radius of an arc that leaves room for its letter within the crank circle.
LARGEST_ARC = 0.65
# The level of the strong links: only pins and shafts are before them.
STRONG_LEVEL = 6
PHI = text_of("$φ$", ".")
UP, DOWN, LEFTWARD = (0.0, 1.0), (0.0, -1.0), (-1.0, 0.0)


class Sketch(NamedTuple):
    """A drawing in units of R: what a millimetre is in them; one of its sides, 1 above, -1 below; texts;
    what hides lines behind it."""

    figure: Figure
    axes: Axes
    mm: float
    side: int
    texts: Lettering
    holes: list[Hole]

    def line(self, *points: Point, **look: Any) -> Line2D:
        own = {"color": BLACK, "linewidth": THIN, "solid_capstyle": "butt", **look}
        return self.axes.plot(*zip(*points, strict=True), **own)[0]

    def chain(
        self, *points: Point, pattern: Sequence[float] = LONG_DASH_DOT, begun: float = 0, open: float = 0
    ) -> Line2D:
        """Draw a narrow chain line; it leaves out a share of its first dash and one of its last."""
        widths = sum(math.dist(*pair) for pair in pairwise(points)) / self.mm * MM / THIN
        return self.line(*points, linestyle=fitted(pattern, widths, begun, open), dash_capstyle="butt")

    def centre_line(self, *points: Point) -> None:
        """Draw a centre line through points; at all but the ends it has the middle of a dash."""
        last = len(points) - 2
        for number, pair in enumerate(pairwise(points)):
            self.chain(*pair, begun=0.5 * (number > 0), open=0.5 * (number < last))

    def disc(self, centre: Point, radius: float, width: float, filling: str = "none", above: int = 7) -> None:
        from matplotlib.patches import Circle

        disc = Circle(centre, radius * self.mm, zorder=above)
        disc.set(facecolor=filling, edgecolor=BLACK, linewidth=width)
        self.axes.add_patch(disc)
        if filling == "none":
            self.hide(centre, (radius, radius), True, above)

    def hide(self, centre: Point, half: Point, is_round: bool, level: float) -> None:
        """Hide what is drawn below a level in a disc or a box, of which half the sides are in mm."""
        self.holes.append(Hole(self.texts.on_page(centre)[0], np.asarray(half), is_round, level))

    def strong_links(self, **links: tuple[Point, Point]) -> None:
        """Draw links by their names as of the first position, the cranks among them thicker."""
        for name, ends in links.items():
            strong = self.line(*ends, linewidth=HEAVY if "crank" in name else STRONG, zorder=STRONG_LEVEL)
            strong.set_gid(name.replace("_", "-"))

    def joints(self, pins: Iterable[Point]) -> None:
        """Draw the pins between links."""
        for centre in pins:
            self.disc(centre, PIN, MEDIUM)

    def light_links(self, joints: Sequence[Point], pins: Sequence[Point], shafts: Sequence[Point]) -> None:
        """Draw links from joint to joint as of a further position, with line 05.1 of ISO 128-2."""
        radii = dict.fromkeys(shafts, SHAFT) | dict.fromkeys(pins, LIGHT_PIN)
        for start, end in pairwise(joints):
            way = towards(start, end)
            if math.dist(start, end) > (radii.get(start, 0) + radii.get(end, 0)) * self.mm:
                near = moved(start, way, radii.get(start, 0) * self.mm)
                far = moved(end, way, -radii.get(end, 0) * self.mm)
                self.chain(near, far, pattern=LONG_DASH_DOUBLE_DOT).set(zorder=3, gid="further")
        for centre in pins:
            around = [polar_point(centre, LIGHT_PIN * self.mm, turn) for turn in range(0, 361, 10)]
            self.line(*around, zorder=4)
            self.hide(centre, (LIGHT_PIN, LIGHT_PIN), True, 4)

    def bearing(self, centre: Point, way: Point = DOWN) -> None:
        """Draw the end of a shaft, and its bearing on the ground that lies in a direction."""
        mm, across = self.mm, (-way[1], way[0])
        middle = moved(centre, way, BEARING * mm)
        for side in (-1, 1):
            foot = moved(middle, across, side * 0.7 * GROUND * mm)
            self.line(moved(centre, towards(centre, foot), SHAFT * mm), foot, linewidth=MEDIUM, zorder=3)
        self.ground(moved(middle, across, -GROUND * mm), moved(middle, across, GROUND * mm), way)
        self.disc(centre, SHAFT, MEDIUM)
        self.disc(centre, CENTRE, MEDIUM, BLACK)

    def ground(self, start: Point, end: Point, way: Point) -> None:
        """Draw an edge of the frame, hatched in a direction; every hatch rises to the right by 45°."""
        self.line(start, end, linewidth=MEDIUM, zorder=2)
        reach = HATCH * self.mm * (1 if sum(way) > 0 else -1)
        count = int(math.dist(start, end) / (1.5 * self.mm))
        along = towards(start, end)
        for number in range(count):
            # A hatch leans over its place to both sides.
            distance = math.dist(start, end) * (number + 0.5) / count - sum(along) * reach / 2
            x, y = moved(start, along, distance)
            self.line((x, y), (x + reach, y + reach), zorder=1).set_gid("hatch")

    def arc(self, centre: Point, radius: float, start: float, end: float, arrow: bool) -> list[Point]:
        """Draw an arc and return its points."""
        steps = max(2, int((end - start) / 2) + 1)
        turns = [start + (end - start) * step / steps for step in range(steps + 1)]
        points = [polar_point(centre, radius, turn) for turn in turns]
        self.line(*points, zorder=4)
        if arrow:
            # The head is straight: turned by half its own length it follows the arc.
            lean = math.radians(end) - 0.95 * self.mm / radius
            arrowhead(self.axes, points[-1], (-math.sin(lean), math.cos(lean)), self.mm)
        return points

    def crank_dimensions(self, pin: Point, turn: float) -> None:
        """Draw R, and φ within the crank circle or, of a crank too small in mm for that, around it."""
        self.beside(((0, 0), pin), "$R$", 0.68, 1 if pin[1] >= 0 else -1)
        if not turn:
            return
        mm, share = self.mm, 0.5
        # Within the circle the arc goes round the bearing, if this stands above the shaft.
        at = max(0.42, (BEARING + HATCH + 1.2) * mm * (pin[1] < -HANGING))
        if mm * SMALL_CRANK > 1 or at > LARGEST_ARC:
            # Outside, the rod passes above the middle of the arc.
            at, share, end = 1 + 2.4 * mm, 0.3, 1 + 4 * mm
            self.line(pin, (pin[0] * end, pin[1] * end), zorder=4)
        self.beside(self.arc((0, 0), at, 0, turn, arrow=True), PHI, share, -1, ends=True)

    def dimension(
        self, start: Point, end: Point, text: str, others: tuple[float, float] = (0.0, 0.0)
    ) -> None:
        """Draw a dimension line; where it is too short for two arrows they point at it from outside.

        `others` are the lengths of those that share its ends, the left one first, 0 where none does: the
        broader has the arrow there; where neither has room for one stands a dot.
        """
        mm, (start, end) = self.mm, sorted((start, end))
        way, ends = towards(start, end), []
        inside = math.dist(start, end) > LEAST_DIMENSION * mm
        for point, outward, other in ((start, -1, others[0]), (end, 1, others[1])):
            ends.append(point if inside or other else moved(point, way, 4 * outward * mm))
            if inside or not other:
                pointing = outward if inside else -outward
                arrowhead(self.axes, point, (pointing * way[0], pointing * way[1]), mm)
            elif outward > 0 and other <= LEAST_DIMENSION * mm:
                self.disc(point, DOT, THIN, "#000000")
        self.line(*ends, zorder=4)
        self.beside(ends, text, 0.5, 1, turned=abs(way[1]) > abs(way[0]), ends=True)

    def beside(self, line: Sequence[Point], text: str, share: float, side: int, **look: bool) -> None:
        """Ask for a text beside a line, on its left (1) or right (-1), at best at a share of its length."""
        self.texts.beside_line(self.texts.on_page(*line), text, share, side, **look)

    def at_end(self, end: Point, opposite: Point, text: str) -> None:
        """Ask for a text at an end of an upright line, that on the sketch's own side or the opposite one."""
        near, far = self.texts.on_page(end, opposite)
        self.texts.at_end(near, self.side, text, far)

    def beside_points(self, places: Sequence[Text], clear: float = PIN + 0.4) -> None:
        """Ask for texts beside points, each at best in a direction of its own, so many mm away."""
        for point, outward, text in places:
            at, ahead = self.texts.on_page(point, moved(point, outward, 1))
            self.texts.beside_point(at, ahead - at, text, clear)

    def crank_circle(self, centre: Point = (0, 0)) -> None:
        """Draw the path of the crank pin, of which line 04.1 of ISO 128-2 is.

        There are as many dashes in each quarter, and one on each of the four axes.
        """
        points = [polar_point(centre, 1, turn) for turn in range(0, 361, 3)]
        widths = 2 * math.pi / self.mm * MM / THIN
        stretch = widths / (max(1, round(widths / sum(LONG_DASH_DOT) / 4)) * 4 * sum(LONG_DASH_DOT))
        pattern = tuple(part * stretch for part in LONG_DASH_DOT)
        look: dict[str, object] = {"linestyle": (pattern[0] / 2, pattern), "dash_capstyle": "butt"}
        self.line(*points, zorder=2, **look)

    def write(self) -> None:
        """Write the texts, once all else is drawn, and cut off what stands behind something."""
        (left, right), (bottom, top) = self.axes.get_xlim(), self.axes.get_ylim()
        self.texts.write((right - left) / self.mm, (top - bottom) / self.mm)
        for line in self.axes.lines:
            level = line.get_zorder()
            before = [one for one in (*self.holes, *self.texts.grounds) if one.level > level]
            if level == STRONG_LEVEL:
                line.set_clip_path(self._outside(before), self.axes.transData)
                continue
            seen = cut(self.texts.on_page(*np.asarray(line.get_xydata())), before)
            if seen is not None:
                line.set_data(*self.texts.on_axes(seen).T)

    def _outside(self, holes: Sequence[Hole]) -> Path:
        """Return the page without discs: strong links keep their true length, and are not seen in there."""
        from matplotlib.path import Path

        (left, right), (bottom, top) = self.axes.get_xlim(), self.axes.get_ylim()
        # The page is clockwise, the discs are not.
        page = Path([(left, bottom), (left, top), (right, top), (right, bottom), (left, bottom)], closed=True)
        middles = [tuple(self.texts.on_axes(one.centre[None])[0]) for one in holes]
        discs = [Path.circle(at, one.half[0] * self.mm) for at, one in zip(middles, holes, strict=True)]
        return Path.make_compound_path(page, *discs)

    def dead_centre(self, place: Point) -> None:
        """Mark a dead centre on the path of a pin: by a dot, which no dash of the path is taken for."""
        self.disc(place, DEAD, THIN, BLACK, above=3)


def laid_out(low: Point, high: Point, mm: float, side: int = 1) -> Sketch:
    """Return an empty drawing between two corners. Only inside `style`."""
    figure = page((high[1] - low[1]) / mm, (high[0] - low[0]) / mm)
    return sketch_in(figure, (0, 0, 1, 1), low, high, mm, side)


def sketch_in(
    figure: Figure, box: tuple[float, float, float, float], low: Point, high: Point, mm: float, side: int = 1
) -> Sketch:
    """Return an empty drawing between two corners in a box of a page, by shares of it: left, bottom, width,
    height."""
    axes = figure.add_axes(box, label="mechanism", xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    axes.set_axis_off()
    return Sketch(figure, axes, mm, side, Lettering(axes), [])


def moved(point: Point, way: Point, distance: float) -> Point:
    return point[0] + distance * way[0], point[1] + distance * way[1]


def towards(start: Point, end: Point) -> Point:
    """Return the direction from one point to another, of length 1."""
    length = math.dist(start, end) or 1
    return (end[0] - start[0]) / length, (end[1] - start[1]) / length
