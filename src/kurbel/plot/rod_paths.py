"""The paths of points of the rod over a turn, in drawings of mechanisms to scale."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.motion.points import RodPoint, carried, paths_of
from kurbel.page.steps import Point, Scene
from kurbel.plot.moving import PLACES
from kurbel.plot.panel import degrees
from kurbel.plot.sketch import LEAST, Corners, Sketch, Text, towards
from kurbel.plot.style import BLACK, MEDIUM, THIN, WHITE, WIDTH, text_of

MOST_POINTS = 12
# Paths more than these have angles told on the first alone.
MOST_TOLD = 2
# Crank angles between marks on a path, and between those that are told, in degrees.
MARKED, TOLD = 30, 90
# In mm: the marks, the points themselves, what paths leave free around them, and the highest drawing.
MARK, POINT, ROOM, HIGHEST = 0.55, 0.9, 6.0, 150.0
# A path lower than that, in R, is a line along the slide, on which marks would cover each other.
LEAST_HEIGHT = 0.05
# Before the strong links.
LEVEL = 7


class Coupled(NamedTuple):
    """A point of the rod, its label and what a drawing calls it, and where it is at equal steps of a turn."""

    share: float
    beside: float
    label: Label
    name: Label
    path: tuple[Point, ...]

    def at(self, pin: Point, end: Point) -> Point:
        """Return where the point is with the ends of the rod at these places."""
        return carried(pin, end, self.share, self.beside)


def coupled(points: Sequence[RodPoint], scene: Scene | None) -> tuple[Coupled, ...]:
    """Return the points on the rod of what moves; a drive too long to be drawn has none."""
    if len(points) > MOST_POINTS:
        raise ProblemError(
            f"the paths of {len(points)} points were asked for; at most {MOST_POINTS} can be told apart"
        )
    return tuple(_coupled(points, scene)) if scene else ()


def _coupled(points: Sequence[RodPoint], scene: Scene) -> Iterator[Coupled]:
    for one, path in zip(points, paths_of(points, scene), strict=True):
        share, beside = float(one.share), float(one.beside)
        yield Coupled(share, beside, one.label, "$P$" if len(points) == 1 else one.label, path)


def around(corners: Corners, paths: Sequence[Coupled]) -> Corners:
    """Return the corners of a page that has room for the paths, too."""
    if not paths:
        return corners
    xs, ys = zip(*(place for one in paths for place in one.path), strict=True)

    def reaching(mm: float) -> tuple[Point, Point]:
        (left, bottom), (right, top) = corners(mm)
        room = ROOM * mm
        return (
            (min(left, min(xs) - room), min(bottom, min(ys) - room)),
            (max(right, max(xs) + room), max(top, max(ys) + room)),
        )

    return reaching


def usual_scale(corners: Corners, usual: float, paths: Sequence[Coupled]) -> float:
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


def draw_paths(sketch: Sketch, paths: Sequence[Coupled], pin: Point, end: Point, mark: str) -> None:
    """Draw the paths with their marks, the points at the first position, and what joins these to the rod."""
    first = next((one for one in paths if _is_open(one)), None)
    for number, one in enumerate(paths):
        sketch.line(*one.path, one.path[0], linewidth=MEDIUM, zorder=LEVEL - 2).set_gid(f"path-{number + 1}")
        if _is_open(one):
            _marks(sketch, one, mark, told=one is first or len(paths) <= MOST_TOLD)
    for one in paths:
        place = one.at(pin, end)
        for start in _joined(one, pin, end):
            sketch.line(start, place, linewidth=THIN, zorder=LEVEL - 1)
        sketch.disc(place, POINT, THIN, BLACK, above=LEVEL + 1)
        sketch.beside_points([(place, _outward(one, place), text_of(one.name, mark))], POINT + 0.5)


def _is_open(one: Coupled) -> bool:
    """Whether the path is more than a line."""
    heights = [up for _, up in one.path]
    return max(heights) - min(heights) > LEAST_HEIGHT


def _joined(one: Coupled, pin: Point, end: Point) -> tuple[Point, ...]:
    """Return the ends of the rod to which a line leads from a point that is not on it."""
    if one.beside:
        return pin, end
    return () if 0 <= one.share <= 1 else (pin if one.share > 1 else end,)


def _marks(sketch: Sketch, one: Coupled, mark: str, told: bool) -> None:
    """Mark crank angles on a path; of many paths they are told on one."""
    step = PLACES * MARKED // 360
    texts: list[Text] = []
    for number, place in enumerate(one.path[::step]):
        sketch.disc(place, MARK, THIN, WHITE, above=LEVEL - 1)
        angle = MARKED * number
        if told and angle % TOLD == 0:
            texts.append((place, _outward(one, place), degrees(angle, mark)))
    sketch.beside_points(texts, MARK + 0.5)


def _outward(one: Coupled, place: Point) -> Point:
    """Return the direction from the middle of a path."""
    xs, ys = zip(*one.path, strict=True)
    middle = (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
    return towards(middle, place) if math.dist(middle, place) else (0.0, 1.0)
