"""Joints over a turn of the crank."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from kurbel.page.steps import Joint, Line, Point

# Between two of so many places of a turn a joint leaves its way by 0.04 % of R at the most.
PLACES = 120
LETTERS = {"crank": "R", "rod": "L"}
SHAFT: Point = (0.0, 0.0)


# The crank angles in degrees at which joints are known.
TURN = tuple(360 * place / PLACES for place in range(PLACES))


def joint(at: Callable[[float], Point], angles: Sequence[float]) -> Joint:
    """Return where a joint is at angles, once if it stays."""
    places = tuple(map(at, angles))
    return places[:1] if len(set(places)) == 1 else places


def fixed(point: Point) -> Joint:
    return (point,)


def around(points: Iterable[Point], more: float = 0.0) -> tuple[Point, Point]:
    """Return the corners around points, and so much more on all sides."""
    xs, ys = zip(*points, strict=True)
    return (min(xs) - more, min(ys) - more), (max(xs) + more, max(ys) + more)


def crossed(centre: Point, beyond: float = 1.25) -> Iterable[Line]:
    """Yield a circle of radius R and the centre line square to the line of shafts."""
    x, y = centre
    yield Line("circle", (centre,))
    yield Line("centre", ((x, y - beyond), (x, y + beyond)))
