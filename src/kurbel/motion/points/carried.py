"""Where points of the rod are in drawings: carried along by the ends of the rod."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kurbel.motion.points.point import Point as RodPoint
from kurbel.page.steps import Joint, Line, Point, Scene

# What paths leave free beyond them, in R.
ROOM = 0.25


def carried(pin: Point, end: Point, share: float, beside: float) -> Point:
    """Return a point of a rod from its driven end to the crank pin, and beside it by so many of its lengths,
    above a rod that leads to the left."""
    along, up = pin[0] - end[0], pin[1] - end[1]
    return end[0] + share * along + beside * up, end[1] + share * up - beside * along


def paths_of(points: Sequence[RodPoint], scene: Scene) -> Iterator[Joint]:
    """Yield where points on the rod of what moves are, at equal steps of a turn."""
    rod = next(link for link in scene.links if link.kind == "rod")
    for one in points:
        share, beside = float(one.share), float(one.beside)
        yield tuple(carried(pin, end, share, beside) for pin, end in zip(rod.start, rod.end, strict=True))


def with_points(scene: Scene, points: Sequence[RodPoint], whole: Scene | None = None) -> Scene:
    """Return what moves with points of its rod as pins, and their paths, which are those of a whole turn."""
    paths = tuple(paths_of(points, whole or scene))
    xs, ys = zip(*(place for path in paths for place in path), strict=True)
    return scene._replace(
        low=(min(scene.low[0], min(xs) - ROOM), min(scene.low[1], min(ys) - ROOM)),
        high=(max(scene.high[0], max(xs) + ROOM), max(scene.high[1], max(ys) + ROOM)),
        fixed=(*scene.fixed, *(Line("centre", (*path, path[0])) for path in paths)),
        pins=(*scene.pins, *paths_of(points, scene)),
    )
