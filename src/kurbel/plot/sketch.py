"""What drawings of mechanisms are made of: links, joints, dimensions, and texts where there is room.

Lengths are in units of the crank radius R.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kurbel.page.quantity import words
from kurbel.plot.place import AROUND, Points, around, box_points, densely, freest
from kurbel.plot.style import BLACK, GREY, MEDIUM, SMALL_TEXT, THIN, WHITE, arrowhead, page, size_of, text_of
from kurbel.plot.ticks import degrees

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

Point = tuple[float, float]
# A text for a point, with the direction from it that is best.
Text = tuple[Point, Point, str]

# What drawings call the ends of the stroke.
DEAD_CENTRES = {
    "inner": words("innerer Totpunkt|inner dead centre"),
    "outer": words("äußerer Totpunkt|outer dead centre"),
}
# In mm.
LEAST_DIMENSION, SMALL_CRANK = 5.0, 9.5
PHI = text_of("$φ$", ".")
# Chains of long and short strokes, for centre lines.
CHAIN = (0, (14, 3, 2, 3))
BACKGROUND = {"facecolor": WHITE, "edgecolor": "none", "pad": 0.6}


class Position(NamedTuple):
    """A drive at one angle: crank pin and head of the rod from the shaft, the angle of rod or rocker."""

    angle: float
    pin: Point
    head: Point
    lean: float = 0.0


class Sketch(NamedTuple):
    """A drawing in units of R: what a millimetre is in them, and one of its sides, 1 above, -1 below."""

    figure: Figure
    axes: Axes
    mm: float
    side: int

    def line(self, *points: Point, **look: Any) -> Line2D:
        own: dict[str, Any] = {"color": BLACK, "linewidth": THIN, "solid_capstyle": "butt"}
        return self.axes.plot(*zip(*points, strict=True), **(own | look))[0]

    def joint(self, centre: Point, radius: float, colour: str, width: float, filling: str = WHITE) -> None:
        from matplotlib.patches import Circle

        disc = Circle(centre, radius * self.mm, zorder=7 if colour == BLACK else 4)
        disc.set(facecolor=filling, edgecolor=colour, linewidth=width)
        self.axes.add_patch(disc)

    def strong_links(self, **links: tuple[Point, Point]) -> None:
        """Draw links by their names as of the first position, the cranks among them thicker."""
        for name, ends in links.items():
            strong = self.line(*ends, linewidth=2.4 if "crank" in name else 1.6, zorder=6)
            strong.set_gid(name.replace("_", "-"))

    def joints(self, shafts: Sequence[Point], pins: Sequence[Point]) -> None:
        """Draw the ends of shafts, which are fixed in the frame, and the pins between links."""
        for centre in shafts:
            self.joint(centre, 1.7, BLACK, MEDIUM)
            self.joint(centre, 0.35, BLACK, MEDIUM, BLACK)
        for centre in pins:
            self.joint(centre, 1.1, BLACK, MEDIUM)

    def light_links(self, *joints: Point) -> None:
        """Draw links from joint to joint as of a further position; pin and head come after the shaft."""
        self.line(*joints, color=GREY, linewidth=MEDIUM, zorder=3)
        for centre in joints[1:3]:
            self.joint(centre, 0.7, GREY, MEDIUM)

    def write(self, place: Point, text: str, **look: Any) -> None:
        own: dict[str, Any] = {"ha": "center", "va": "center", "zorder": 8, "bbox": BACKGROUND}
        self.axes.text(*place, text, **(own | look))

    def arc(self, centre: Point, radius: float, start: float, end: float, arrow: bool) -> None:
        steps = max(2, int((end - start) / 2) + 1)
        turns = [start + (end - start) * step / steps for step in range(steps + 1)]
        points = [polar_point(centre, radius, turn) for turn in turns]
        self.line(*points, linewidth=MEDIUM, zorder=4)
        if arrow:
            # The head is straight: turned by half its own length it follows the arc.
            lean = math.radians(end) - 0.95 * self.mm / radius
            arrowhead(self.axes, points[-1], (-math.sin(lean), math.cos(lean)), self.mm)

    def crank_dimensions(self, pin: Point, turn: float) -> None:
        """Draw R, and φ within the crank circle or, of a crank too small in mm for that, around it."""
        self.beside_link((0, 0), pin, "$R$", 0.68, 1 if pin[1] >= 0 else -1)
        if not turn:
            return
        mm, at, share = self.mm, 0.42, 0.5
        if mm * SMALL_CRANK > 1:
            # Outside, the rod passes above the middle of the arc.
            at, share, end = 1 + 2.4 * mm, 0.3, 1 + 4 * mm
            self.line(pin, (pin[0] * end, pin[1] * end), zorder=4)
        self.arc((0, 0), at, 0, turn, arrow=True)
        self.write(polar_point((0, 0), at + 2.5 * mm, turn * share), PHI, zorder=5)

    def dimension(self, start: Point, end: Point, text: str) -> None:
        """Draw a dimension line; where it is too short for two arrows they point at it from outside."""
        mm, length = self.mm, math.dist(start, end)
        way = ((end[0] - start[0]) / length, (end[1] - start[1]) / length)
        inside = length > LEAST_DIMENSION * mm
        reach = 0 if inside else 4 * mm
        self.line(moved(start, way, -reach), moved(end, way, reach), zorder=4)
        outward = 1 if inside else -1
        arrowhead(self.axes, start, (-outward * way[0], -outward * way[1]), mm)
        arrowhead(self.axes, end, (outward * way[0], outward * way[1]), mm)
        beside = 0 if inside else 2.2 * mm
        middle = moved(start, way, length / 2)
        self.write((middle[0] - beside * abs(way[1]), middle[1] + beside * abs(way[0])), text)

    def beside_link(self, start: Point, end: Point, text: str, share: float, side: int) -> None:
        """Write a text beside a link, on its left (1) or right (-1), at a share of its length."""
        x, y = (begin + share * (stop - begin) for begin, stop in zip(start, end, strict=True))
        length = math.dist(start, end)
        distance = side * 2.6 * self.mm / length
        self.write((x - (end[1] - start[1]) * distance, y + (end[0] - start[0]) * distance), text)

    def crank_circle(self, centre: Point = (0, 0)) -> None:
        from matplotlib.patches import Circle

        self.axes.add_patch(Circle(centre, 1, fill=False, edgecolor=GREY, linewidth=MEDIUM, zorder=2))

    def dead_tick(self, pin: Point) -> None:
        """Mark a dead centre on the crank circle about the origin."""
        inside, outside = 1 - 1.6 * self.mm, 1 + 1.6 * self.mm
        ends = [(pin[0] * share, pin[1] * share) for share in (inside, outside)]
        self.line(*ends, linewidth=MEDIUM, zorder=3)

    def beside_points(self, places: Sequence[Text]) -> None:
        """Write texts beside points, each at best in a direction of its own, as far as there is room."""
        (left, right), (bottom, top) = self.axes.get_xlim(), self.axes.get_ylim()
        corner, mm = np.asarray((left, bottom)), self.mm
        frame = (0, 0, (right - left) / mm, (top - bottom) / mm)
        taken = (self._taken() - corner) / mm
        for point, outward, text in places:
            size = size_of(text, SMALL_TEXT)
            near = around((np.asarray(point) - corner) / mm, size, np.asarray(outward))
            place = freest(near, size, np.empty((0, 2)), taken, frame, AROUND)
            if place is not None:
                taken = np.concatenate((taken, box_points(place, size)))
                x, y = corner + place * mm
                self.write((float(x), float(y)), text, fontsize=SMALL_TEXT, bbox=None)

    def _taken(self) -> Points:
        """Return points of all crank circles, lines and texts so far."""
        from matplotlib.patches import Circle

        apart = 0.5 * self.mm
        centres = [one.center for one in self.axes.patches if isinstance(one, Circle) and one.radius == 1]
        circles = [[polar_point(one, 1, turn) for turn in range(0, 361, 5)] for one in centres]
        lines = [*map(np.asarray, circles), *(np.asarray(line.get_xydata()) for line in self.axes.lines)]
        boxes = [text.get_window_extent() for text in self.axes.texts]
        to_radii = self.axes.transData.inverted()
        corners = [to_radii.transform(((box.x0, box.y0), (box.x1, box.y1))) for box in boxes]
        written = [box_points(low / 2 + high / 2, tuple(high - low), apart) for low, high in corners]
        return np.concatenate([*(densely(line, apart) for line in lines), *written])


def laid_out(low: Point, high: Point, mm: float, side: int = 1) -> Sketch:
    """Return an empty drawing between two corners. Only inside `style`."""
    figure = page((high[1] - low[1]) / mm, (high[0] - low[0]) / mm)
    axes = figure.add_axes((0, 0, 1, 1), label="mechanism", xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    axes.set_axis_off()
    return Sketch(figure, axes, mm, side)


def pin_texts(pins: Sequence[Point], angles: Sequence[float | Fraction], mark: str) -> list[Text]:
    """Return the angles beside the pins, for `beside_points`, where there are several."""
    if len(pins) < 2:
        return []
    return [(pin, pin, degrees(angle, mark)) for pin, angle in zip(pins, angles, strict=True)]


def polar_point(centre: Point, radius: float, turn: float) -> Point:
    angle = math.radians(turn)
    return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)


def moved(point: Point, way: Point, distance: float) -> Point:
    return point[0] + distance * way[0], point[1] + distance * way[1]
