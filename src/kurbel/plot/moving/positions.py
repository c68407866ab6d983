"""Where the joints of the straight and the offset crank are, in units of R; nothing here draws."""

from __future__ import annotations

import math
from typing import NamedTuple

from kurbel.kernel.circle import circle
from kurbel.kernel.kinematics import rod_sine
from kurbel.page.steps import Point

# In crank radii. Drawn to scale beside a longer rod the crank is too small to be seen.
LONGEST_ROD = 12


class Position(NamedTuple):
    """A drive at one angle: crank pin and head of the rod from the shaft, the angle of rod or rocker."""

    angle: float
    pin: Point
    head: Point
    lean: float = 0.0


def position(ratio: float, offset: float, angle: float) -> Position:
    """Return crank pin and crosshead pin in units of R, from the shaft; the rod's angle ψ in degrees."""
    point = circle(angle)
    sine = rod_sine(point, ratio, offset)
    along = point.cosine + math.sqrt((1 - sine) * (1 + sine)) / ratio
    return Position(angle, (point.cosine, point.sine), (along, offset), math.degrees(math.asin(sine)))


def polar_point(centre: Point, radius: float, turn: float) -> Point:
    angle = math.radians(turn)
    return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)
