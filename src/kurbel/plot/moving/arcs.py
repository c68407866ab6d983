"""Where the joints of a crank are that moves a rocker, in units of R; nothing here draws."""

from __future__ import annotations

import math

from kurbel.exact.kind import floats
from kurbel.kernel.circle import circle
from kurbel.linkage.arc.quantities import arc_registry
from kurbel.linkage.arc.rocker import RockerCrank
from kurbel.linkage.linkage import value
from kurbel.motion.evaluation import OUT
from kurbel.page.steps import Point
from kurbel.plot.moving.positions import Position


def arc_position(crank: RockerCrank, angle: float) -> Position:
    """Return where the drive stands at a crank angle in degrees."""
    point = circle(angle)
    turn = float(value(arc_registry()["rocker"], crank, point, floats()))
    side = 1 if crank.curvature > 0 else -1
    (x, y), rocker = arc_pivot(crank), float(crank.rocker)
    across, along = math.sin(math.radians(turn)), math.cos(math.radians(turn))
    head = (x + side * rocker * across, y - side * rocker * along)
    return Position(angle, (point.cosine, point.sine), head, turn)


def arc_pivot(crank: RockerCrank) -> Point:
    ratio, curvature, offset, shift = map(float, crank.figures(OUT, floats()))
    return 1 / ratio + shift, offset + 1 / curvature


def swept(pivot: Point, start: Point, end: Point) -> list[float]:
    """Return directions from the pivot to places of the arc between two, in degrees, rising."""
    first, last = (math.degrees(math.atan2(y - pivot[1], x - pivot[0])) for x, y in (start, end))
    turn = (last - first + 180) % 360 - 180
    return sorted(first + turn * step / 40 for step in range(41))
