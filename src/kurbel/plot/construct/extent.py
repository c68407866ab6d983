"""How far a construction reaches: its points, whole circles and arcs, in units of R."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain

from kurbel.books.constructions import model
from kurbel.books.constructions.model import Construction
from kurbel.plot.sketch import Point


def extent(
    shown: Construction, points: Mapping[str, Point], curves: Mapping[str, Sequence[Point]]
) -> tuple[Point, Point]:
    """Return the lower left and the upper right corner of what is drawn."""
    xs, ys = zip(*_reached(shown, points), *chain.from_iterable(curves.values()), strict=True)
    return (min(xs), min(ys)), (max(xs), max(ys))


def _reached(shown: Construction, points: Mapping[str, Point]) -> Iterator[Point]:
    for step in shown.steps:
        yield from (points[letter] for letter in step.points)
        for one in step.drawn:
            if isinstance(one, model.Circle):
                (x, y), radius = points[one.centre], math.dist(points[one.centre], points[one.through])
                yield x - radius, y - radius
                yield x + radius, y + radius
            elif isinstance(one, model.Line | model.Arrow | model.Scale):
                yield from (points[one.start], points[one.end])
