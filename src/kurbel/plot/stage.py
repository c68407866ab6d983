"""A mechanism that moves, to scale: what is fixed, its links, φ and the path of the crosshead; and the paths
of points of the rod over a turn.

Lengths are in crank radii but where they are said to be in mm. Discs and the crosshead have a white ground,
for what they hide is another thing at each angle.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import count
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.motion.points import RodPoint, carried, paths_of
from kurbel.page.steps import Joint, Line, Link, Point, Scene
from kurbel.plot.film import GrowingLine, Part, VisibleArtists, Way, crossing, toggled
from kurbel.plot.moving import GUIDE, HEAD, PLACES, polar_point
from kurbel.plot.panel import degrees
from kurbel.plot.place import Points
from kurbel.plot.sketch import (
    BEARING,
    CENTRE,
    DOWN,
    HATCH,
    LEAST,
    LEFTWARD,
    PHI,
    PIN,
    SHAFT,
    UP,
    Corners,
    Sketch,
    Text,
    towards,
)
from kurbel.plot.style import (
    BLACK,
    HEAVY,
    MEDIUM,
    PALE,
    STRONG,
    TEXT_SIZE,
    THIN,
    WHITE,
    WIDTH,
    arrowhead,
    text_of,
)

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

# The radius of a point of a link, in mm.
POINT = 0.9
# The levels of what moves: dimensions, crosshead, links, pins, letters.
DIMENSIONS, CROSSHEAD, LINKS, PINS, LETTERS = 4.5, 5.2, 6.2, 7.2, 8.0
# In mm: from a line to the middle of its letter, an arrowhead, the shortest path that has a letter.
BESIDE, ARROW, LEAST_PATH, LEAST_TURN = 2.6, 1.9, 6.0, 12.0
# Where the letter of a link stands, as a share of it, and the angle beyond which that of φ stays.
OF_CRANK, OF_LINK, LAST_PHI, LAST_OUTSIDE = 0.6, 0.42, 25.0, 90.0
ARC, ROOM = 0.46, BEARING + HATCH + 1.2
# Nearer to the rod a point is on it, in mm.
NEAR = 0.05
# What has a lesser sine is level.
LEVEL = 1e-9
GROUNDS = {"bearing": DOWN, "below": DOWN, "hung": UP, "beside": LEFTWARD}


class MovingScene(NamedTuple):
    """What moves of a mechanism, and what stands still before it."""

    parts: tuple[Part, ...]
    grown: tuple[GrowingLine, ...]
    seen: tuple[VisibleArtists, ...]
    above: tuple[Artist, ...]


def draw_scene(sketch: Sketch, scene: Scene, angles: Points, at: int) -> MovingScene:
    """Draw a mechanism as it stands at one of the angles, for which its scene has all joints."""
    shafts = [line.points[0] for line in scene.fixed if line.kind in GROUNDS]
    draw_fixed(sketch, scene.fixed, shafts)
    sketch.write()
    stage = _Stage(sketch, angles, at)
    parts = [*stage.links(scene), *stage.heads(scene)]
    turning, grown, seen = stage.turned()
    parts += turning
    if scene.path is not None:
        moving, path, shown = stage.reached(scene.path, scene.heads[0])
        parts, grown, seen = [*parts, *moving], [*grown, *path], [*seen, *shown]
    return MovingScene(tuple(parts), tuple(grown), tuple(seen), tuple(stage.shafts(shafts)))


def draw_fixed(sketch: Sketch, lines: Sequence[Line], shafts: Sequence[Point]) -> None:
    """Draw what stands still; at a shaft a centre line has the middle of a dash."""
    for kind, points in lines:
        if kind == "centre" and len(points) == 2:
            start, end = points
            on = [one for one in shafts if start[0] <= one[0] <= end[0] and start[1] <= one[1] <= end[1]]
            sketch.centre_line(start, *on, end)
        elif kind == "centre":
            # Ways of points are closed.
            sketch.chain(*points).set_gid("arc" if points[0] != points[-1] else None)
        elif kind == "circle":
            sketch.crank_circle(points[0])
        elif kind == "dead":
            sketch.dead_centre(points[0])
        elif kind in ("left", "right"):
            sketch.ground(points[0], points[1], UP if kind == "left" else DOWN)
        else:
            sketch.bearing(points[0], GROUNDS[kind])


class _Stage:
    """Draws what moves at one of the angles, and says how it goes on."""

    def __init__(self, sketch: Sketch, angles: Points, at: int) -> None:
        self.sketch, self.axes, self.mm = sketch, sketch.axes, sketch.mm
        self.angles, self.at = angles, at

    def places(self, joint: Joint) -> Points:
        """Return where a joint is at all angles."""
        return np.broadcast_to(np.asarray(joint, float), (len(self.angles), 2))

    def part(
        self,
        name: str,
        artists: Sequence[Artist],
        places: Points,
        turns: Points | float = 0.0,
        reach: float = 0,
    ) -> Part:
        """Return a part by the places of a point of it, and its turns; it reaches so far beyond the point."""
        for one in artists:
            one.set_clip_on(False)
        turned = np.broadcast_to(turns, len(self.angles))
        return Part(
            name, tuple(artists), self.axes, Way(self.angles, np.column_stack((places, turned))),
            reach / self.mm,
        )  # fmt: skip

    def line(self, points: Points, width: float, level: float) -> Line2D:
        line = self.sketch.line(*map(tuple, points), linewidth=width, zorder=level)
        line.set_clip_on(False)
        return line

    def disc(self, centre: Point, radius: float, filling: str = WHITE, level: float = PINS) -> Patch:
        from matplotlib.patches import Circle

        disc = Circle(centre, radius * self.mm, zorder=level, linewidth=MEDIUM)
        disc.set(facecolor=filling, edgecolor=BLACK)
        self.axes.add_patch(disc)
        return disc

    def letter(self, text: str, point: Points) -> Artist:
        x, y = point
        return self.axes.text(
            x, y, text, ha="center", va="center", fontsize=TEXT_SIZE, zorder=LETTERS, clip_on=False
        )

    def head(self, tip: Points, way: Point) -> Patch:
        return arrowhead(self.axes, tip, way, self.mm, ARROW, level=DIMENSIONS)

    def shafts(self, places: Sequence[Point]) -> Iterator[Patch]:
        """Draw the ends of shafts before the links, again: these are drawn over their bearings."""
        for place in places:
            yield self.disc(place, SHAFT, level=PINS + 0.1)
            yield self.disc(place, CENTRE, BLACK, PINS + 0.2)

    def links(self, scene: Scene) -> Iterator[Part]:
        """Draw links with their pins and letters."""
        pins, kinds, numbers = [*scene.pins], [link.kind for link in scene.links], count(1)
        for link in scene.links:
            name = link.kind if kinds.count(link.kind) == 1 else f"{link.kind}-{next(numbers)}"
            start, end = self.places(link.start), self.places(link.end)
            away = end - start
            turns = np.degrees(np.unwrap(np.arctan2(*away.T[::-1])))
            is_crank = link.kind == "crank"
            here = np.stack((start[self.at], end[self.at]))
            bar = self.line(here, HEAVY if is_crank else STRONG, LINKS + 0.1 * is_crank)
            own = [pin for pin in pins if pin in (link.start, link.end)]
            pins = [pin for pin in pins if pin not in own]
            discs = [self.disc(tuple(self.places(pin)[self.at]), PIN) for pin in own]
            length = float(np.hypot(*away[self.at]))
            yield self.part(name, (bar, *discs), start, turns, length)
            if link.letter:
                yield self._named(f"{name}-letter", link, start, away / length)
        # What is no end of a link is a point of one.
        for number, pin in enumerate(pins, 1):
            places = self.places(pin)
            yield self.part(f"point-{number}", (self.disc(tuple(places[self.at]), POINT, BLACK),), places)
            yield from self._arms(f"point-{number}", scene.links, places)

    def _arms(self, name: str, links: Sequence[Link], places: Points) -> Iterator[Part]:
        """Draw what joins a point that is not on the rod to its ends, beyond one to that end alone."""
        rod = next(link for link in links if link.kind == "rod")
        start, end = self.places(rod.start), self.places(rod.end)
        here, along = places[self.at] - start[self.at], end[self.at] - start[self.at]
        share, near = float(here @ along / (along @ along)), NEAR * self.mm
        beside = math.dist(here, share * along) > near
        ends = [joint for joint, beyond in ((start, share < 0), (end, share > 1)) if beside or beyond]
        # What is itself a pin needs no arm, whatever is lost in its share.
        apart = [joint for joint in ends if math.dist(places[self.at], joint[self.at]) > near]
        for number, joint in enumerate(apart, 1):
            away = places - joint
            turns = np.degrees(np.unwrap(np.arctan2(*away.T[::-1])))
            line = self.line(np.stack((joint[self.at], places[self.at])), THIN, LINKS - 0.1)
            yield self.part(f"{name}-arm-{number}", (line,), joint, turns, float(np.hypot(*away[self.at])))

    def _named(self, name: str, link: Link, start: Points, way: Points) -> Part:
        """Draw the letter of a link at its left, as it goes, that of a crank which points down at its right:
        at the other side is the rod."""
        is_crank, angles = link.kind == "crank", self.angles
        length = float(math.dist(link.start[0], link.end[0]))
        left = np.column_stack((-way[:, 1], way[:, 0]))
        along = start + (OF_CRANK if is_crank else OF_LINK) * length * way
        places = along + BESIDE * self.mm * left
        if is_crank:
            angles, places = crossing(angles, way[:, 1] < -LEVEL, places, along - BESIDE * self.mm * left)
        here = int(np.searchsorted(angles, self.angles[self.at], side="right")) - 1
        letter = self.letter(f"${link.letter}$", places[here])
        return Part(name, (letter,), self.axes, Way(angles, np.column_stack((places, 0 * angles))))

    def heads(self, scene: Scene) -> Iterator[Part]:
        from matplotlib.patches import Rectangle

        for number, joint in enumerate(scene.heads, 1):
            places = self.places(joint)
            x, y = places[self.at]
            boxes = []
            for level, look in (
                (0.0, {"facecolor": WHITE, "linewidth": 0}),
                (0.1, {"facecolor": PALE, "linewidth": 0}),
                (0.2, {"fill": False, "linewidth": MEDIUM}),
            ):
                box = Rectangle((x - HEAD, y - GUIDE), 2 * HEAD, 2 * GUIDE, zorder=CROSSHEAD + level)
                box.set(**{"edgecolor": BLACK, **look})
                boxes.append(self.axes.add_patch(box))
            yield self.part(f"head-{number}" if number > 1 else "head", boxes, places)

    def turned(self) -> tuple[list[Part], list[GrowingLine], list[VisibleArtists]]:
        """Draw the crank angle φ, within the crank circle or around a small one."""
        mm, turns = self.mm, self.angles % 360
        turns = np.where((turns == 0) & (self.angles > self.angles[0]), 360.0, turns)
        radius = ARC if ROOM * mm < ARC else 1 + 2.4 * mm
        points = np.asarray([polar_point((0, 0), radius, turn) for turn in range(361)])
        arc = self.line(points, THIN, DIMENSIONS)
        # An angle that comes twice ends one turn and begins the next.
        again = np.flatnonzero(turns == 360)
        order = np.sort(np.concatenate((np.arange(len(turns)), again[again < len(turns) - 1])))
        ends = turns[order]
        ends[1:][np.diff(order) == 0] = 0
        angles = self.angles[order]
        lean = self.angles[self.at] - math.degrees(0.5 * ARROW * mm / radius)
        direction = (-math.sin(math.radians(lean)), math.cos(math.radians(lean)))
        centre = np.zeros((len(self.angles), 2))
        tip = self.head(np.asarray(polar_point((0, 0), radius, self.angles[self.at])), direction)
        # From the pin to an arc around the circle leads a line.
        out = [polar_point((0, 0), one, self.angles[self.at]) for one in (1.0, radius + 1.6 * mm)]
        beyond = [self.line(np.asarray(out), THIN, DIMENSIONS)] if radius > 1 else []
        beside = np.minimum(ends / 2, LAST_PHI if radius < 1 else LAST_OUTSIDE)
        outer = radius + BESIDE * mm
        places = np.asarray([polar_point((0, 0), outer, turn) for turn in beside])
        here = int(np.flatnonzero(order == self.at)[0])
        letter = self.letter(PHI, places[here])
        rows = np.column_stack((places, np.zeros(len(places))))
        parts = [
            self.part("turned", [tip, *beyond], centre, self.angles, radius),
            Part("phi", (letter,), self.axes, Way(angles, rows)),
        ]
        shown = toggled(angles, ends > LEAST_TURN)
        seen = [VisibleArtists("phi-seen", (tip, letter), shown)]
        return parts, [GrowingLine("arc", arc, self.axes, Way(angles, ends[:, None] / 360))], seen

    def reached(
        self, path: Point, joint: Joint
    ) -> tuple[list[Part], list[GrowingLine], list[VisibleArtists]]:
        """Draw the path x of the crosshead from its inner dead centre."""
        mm, (start, level), heads = self.mm, path, self.places(joint)
        beyond = math.copysign(mm, level - heads[0][1])
        ends = [heads[0][1] + math.copysign(GUIDE, beyond) + 1.6 * beyond, level + beyond]
        self.sketch.line((start, ends[0]), (start, ends[1]), zorder=4)
        far = np.column_stack((heads[:, 0], np.full(len(heads), level)))
        x = far[self.at][0]
        follower = self.line(np.asarray([(x, ends[0]), (x, ends[1])]), THIN, DIMENSIONS)
        least = float(heads[:, 0].min())
        line = self.line(np.asarray([(start, level), (least, level)]), THIN, DIMENSIONS)
        tip = self.head(far[self.at], (-1.0, 0.0))
        still = self.head(np.asarray((start, level)), (1.0, 0.0))
        middle = np.column_stack(((start + far[:, 0]) / 2, far[:, 1] + 1.9 * mm))
        letter = self.letter("$x$", middle[self.at])
        shown = toggled(self.angles, (start - far[:, 0]) / mm > LEAST_PATH)
        parts = [
            self.part("path", [follower, tip], far),
            self.part("path-start", [still], np.broadcast_to((start, level), far.shape)),
            self.part("path-letter", [letter], middle),
        ]
        grown = [
            GrowingLine(
                "reach", line, self.axes, Way(self.angles, ((start - far[:, 0]) / (start - least))[:, None])
            )
        ]
        return parts, grown, [VisibleArtists("path-seen", (tip, still, letter), shown)]


def corners(scene: Scene, margin: float, mm: float) -> tuple[Point, Point]:
    """Return the corners of a scene with a margin in mm, of which a millimetre is so much of R."""
    (left, low), (right, high) = scene.low, scene.high
    return (left - margin * mm, low - margin * mm), (right + margin * mm, high + margin * mm)


MOST_POINTS = 12
# Paths more than these have angles told on the first alone.
MOST_TOLD = 2
# Crank angles between marks on a path, and between those that are told, in degrees.
MARKED, TOLD = 30, 90
# In mm: the marks, what paths leave free around them, and the highest drawing.
MARK, AROUND_PATHS, HIGHEST = 0.55, 6.0, 150.0
# A path lower than that, in R, is a line along the slide, on which marks would cover each other.
LEAST_HEIGHT = 0.05
# In front of the strong links.
FRONT = 7


class RodPointPath(NamedTuple):
    """A point of the rod, its label and what a drawing calls it, and where it is at equal steps of a turn."""

    share: float
    beside: float
    label: Label
    name: Label
    path: tuple[Point, ...]

    def at(self, pin: Point, end: Point) -> Point:
        """Return where the point is with the ends of the rod at these places."""
        return carried(pin, end, self.share, self.beside)


def coupled(points: Sequence[RodPoint], scene: Scene | None) -> tuple[RodPointPath, ...]:
    """Return the points on the rod of what moves; a drive too long to be drawn has none."""
    if len(points) > MOST_POINTS:
        raise ProblemError(
            f"the paths of {len(points)} points were asked for; at most {MOST_POINTS} can be told apart"
        )
    return tuple(_coupled(points, scene)) if scene else ()


def _coupled(points: Sequence[RodPoint], scene: Scene) -> Iterator[RodPointPath]:
    for one, path in zip(points, paths_of(points, scene), strict=True):
        share, beside = float(one.share), float(one.beside)
        yield RodPointPath(share, beside, one.label, "$P$" if len(points) == 1 else one.label, path)


def around(corners: Corners, paths: Sequence[RodPointPath]) -> Corners:
    """Return the corners of a page that has room for the paths, too."""
    if not paths:
        return corners
    xs, ys = zip(*(place for one in paths for place in one.path), strict=True)

    def reaching(mm: float) -> tuple[Point, Point]:
        (left, bottom), (right, top) = corners(mm)
        room = AROUND_PATHS * mm
        return (
            (min(left, min(xs) - room), min(bottom, min(ys) - room)),
            (max(right, max(xs) + room), max(top, max(ys) + room)),
        )

    return reaching


def usual_scale(corners: Corners, usual: float, paths: Sequence[RodPointPath]) -> float:
    """Return how many mm a unit is by itself, so that a drawing with paths is no larger than others."""
    if not paths:
        return usual
    scale = usual
    # A page is nearly as wide as its scale says.
    for _ in range(40):
        (left, bottom), (right, top) = corners(1 / scale)
        scale *= min(1.0, WIDTH / ((right - left) * scale), HIGHEST / ((top - bottom) * scale))
        if scale < LEAST:
            raise ProblemError(
                "a point of the rod goes so far that the crank, drawn to scale beside it, is too small to be"
                " seen; give one nearer to the rod, or --columns for curves over the crank angle"
            )
    return scale


def draw_paths(sketch: Sketch, paths: Sequence[RodPointPath], pin: Point, end: Point, mark: str) -> None:
    """Draw the paths with their marks, the points at the first position, and what joins these to the rod."""
    first = next((one for one in paths if _is_open(one)), None)
    for number, one in enumerate(paths):
        sketch.line(*one.path, one.path[0], linewidth=MEDIUM, zorder=FRONT - 2).set_gid(f"path-{number + 1}")
        if _is_open(one):
            _marks(sketch, one, mark, told=one is first or len(paths) <= MOST_TOLD)
    for one in paths:
        place = one.at(pin, end)
        for start in _joined(one, pin, end):
            sketch.line(start, place, linewidth=THIN, zorder=FRONT - 1)
        sketch.disc(place, POINT, THIN, BLACK, above=FRONT + 1)
        sketch.beside_points([(place, _outward(one, place), text_of(one.name, mark))], POINT + 0.5)


def _is_open(one: RodPointPath) -> bool:
    """Whether the path is more than a line."""
    heights = [up for _, up in one.path]
    return max(heights) - min(heights) > LEAST_HEIGHT


def _joined(one: RodPointPath, pin: Point, end: Point) -> tuple[Point, ...]:
    """Return the ends of the rod to which a line leads from a point that is not on it."""
    if one.beside:
        return pin, end
    return () if 0 <= one.share <= 1 else (pin if one.share > 1 else end,)


def _marks(sketch: Sketch, one: RodPointPath, mark: str, told: bool) -> None:
    """Mark crank angles on a path; of many paths they are told on one."""
    step = PLACES * MARKED // 360
    texts: list[Text] = []
    for number, place in enumerate(one.path[::step]):
        sketch.disc(place, MARK, THIN, WHITE, above=FRONT - 1)
        angle = MARKED * number
        if told and angle % TOLD == 0:
            texts.append((place, _outward(one, place), degrees(angle, mark)))
    sketch.beside_points(texts, MARK + 0.5)


def _outward(one: RodPointPath, place: Point) -> Point:
    """Return the direction from the middle of a path."""
    xs, ys = zip(*one.path, strict=True)
    middle = (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
    return towards(middle, place) if math.dist(middle, place) else (0.0, 1.0)
