"""Mechanisms as they move, to scale: where their links are at a crank angle, and the scene of a turn.

Lengths are in units of R from the shaft. Nothing here draws.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple, TypedDict

from kurbel.drive.crank import Crank
from kurbel.exact.kind import floats
from kurbel.kernel.circle import circle
from kurbel.kernel.kinematics import dead_centre_sine, rod_sine
from kurbel.linkage.arc_quantities import arc_registry
from kurbel.linkage.linkage import Linkage, LinkagePosition, Outline
from kurbel.linkage.rocker import RockerCrank
from kurbel.motion.evaluation import OUT, RETURN, value
from kurbel.page.steps import Joint, Line, Link, Point, Scene

# In crank radii. Drawn to scale beside a longer rod the crank is too small to be seen.
LONGEST_ROD = 12
# Between two of so many places of a turn a joint leaves its way by 0.04 % of R at the most.
PLACES = 120
# The crank angles in degrees at which joints are known.
TURN = tuple(360 * place / PLACES for place in range(PLACES))
SHAFT: Point = (0.0, 0.0)
# Half the length of the crosshead, half the height of its way and the place of dimensions below it, in R.
HEAD, GUIDE, LEVEL = 0.17, 0.15, 0.5
# How far centre lines reach beyond a shaft, and what else is free around a drive, in R.
BEYOND, ROOM = 1.25, 0.25


class Position(NamedTuple):
    """A drive at one angle: crank pin and head of the rod from the shaft, the angle of rod or rocker."""

    angle: float
    pin: Point
    head: Point
    lean: float = 0.0


def crank_pin(angle: float) -> Point:
    point = circle(angle)
    return point.cosine, point.sine


def polar_point(centre: Point, radius: float, turn: float) -> Point:
    angle = math.radians(turn)
    return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)


class FixedExtent(NamedTuple):
    """How far goes what does not move: centre lines from a shaft, the one through it up to the right, guides
    and arcs beyond the dead centres; half the height between guides."""

    shaft: float
    right: float
    overrun: float = 0.0
    guide: float = 0.0


class RockingDrive(ABC):
    """A drive whose rod leads its head to and fro between two dead centres, `inner` and `outer`."""

    inner: Position
    outer: Position

    @abstractmethod
    def at(self, angle: float) -> Position:
        """Return where the drive stands at a crank angle in degrees."""

    @abstractmethod
    def placed(self, one: Position) -> LinkagePosition:
        """Return its links and pins where it stands."""

    @abstractmethod
    def fixed(self, reach: FixedExtent) -> tuple[Line, ...]:
        """Return the lines that do not move, but for dead centres and bearings."""

    def stand(self, angle: float) -> LinkagePosition:
        return self.placed(self.at(angle))

    @property
    def dead(self) -> tuple[Line, ...]:
        places = (place for dead in (self.inner, self.outer) for place in (dead.pin, dead.head))
        return tuple(Line("dead", (place,)) for place in places)


class Slide(RockingDrive):
    """The straight or the offset crank; the rod's angle is ψ."""

    def __init__(self, ratio: float, offset: float) -> None:
        self.ratio, self.offset = ratio, offset
        self.inner = self.at(math.degrees(math.asin(dead_centre_sine(ratio, offset))))
        self.outer = self.at(180 + math.degrees(math.asin(dead_centre_sine(-ratio, -offset))))

    def at(self, angle: float) -> Position:
        sine = rod_sine(circle(angle), self.ratio, self.offset)
        pin = crank_pin(angle)
        along = pin[0] + math.sqrt((1 - sine) * (1 + sine)) / self.ratio
        return Position(angle, pin, (along, self.offset), math.degrees(math.asin(sine)))

    def placed(self, one: Position) -> LinkagePosition:
        links = {"crank": (SHAFT, one.pin), "rod": (one.pin, one.head)}
        letters = (("crank", "$R$", 0.68), ("rod", "$L$", 0.4))
        return LinkagePosition(links, (one.pin, one.head), ((SHAFT, one.pin, one.head),), letters)

    def fixed(self, reach: FixedExtent) -> tuple[Line, ...]:
        level, beyond = self.offset, reach.shaft
        low, high = level - reach.guide, level + reach.guide
        start, end = self.outer.head[0] - reach.overrun, self.inner.head[0] + reach.overrun
        return (
            *_crossed(SHAFT, beyond),
            Line("centre", ((-beyond, 0), (beyond if level else reach.right, 0))),
            *([Line("centre", ((-beyond, level), (reach.right, level)))] if level else ()),
            Line("left", ((start, high), (end, high))),
            Line("right", ((start, low), (end, low))),
        )


class Rocker(RockingDrive):
    """A crank that moves a rocker, or a beam, whose other arm reaches beyond its pivot; the angle is that of
    the rocker, θ."""

    def __init__(self, crank: RockerCrank) -> None:
        self.crank, self.length, self.is_beam = crank, float(crank.rocker), not crank.at_end
        ratio, curvature, offset, shift = map(float, crank.figures(OUT, floats()))
        self.pivot: Point = (1 / ratio + shift, offset + 1 / curvature)
        self.inner = self.at(float(crank.dead_angle(OUT, floats())))
        self.outer = self.at(180 + float(crank.dead_angle(RETURN, floats())))

    def at(self, angle: float) -> Position:
        turn = float(value(arc_registry()["rocker"], "exact", self.crank, circle(angle), floats()))
        side = 1 if self.crank.curvature > 0 else -1
        across, along = math.sin(math.radians(turn)), math.cos(math.radians(turn))
        x, y = self.pivot
        head = (x + side * self.length * across, y - side * self.length * along)
        return Position(angle, crank_pin(angle), head, turn)

    def placed(self, one: Position) -> LinkagePosition:
        end = self.end(one.head)
        links = {"crank": (SHAFT, one.pin), "rod": (one.pin, one.head), "rocker": (one.head, end)}
        pins = (one.pin, one.head, end) if self.is_beam else (one.pin, one.head)
        letters = (("crank", "$R$", 0.68), ("rod", "$L$", 0.45), ("rocker", f"${self.crank.letter}$", 0.45))
        return LinkagePosition(links, pins, ((SHAFT, one.pin, one.head, end),), letters)

    def fixed(self, reach: FixedExtent) -> tuple[Line, ...]:
        level = Line("centre", ((-reach.shaft, 0), (reach.right, 0)))
        return (*_crossed(SHAFT, reach.shaft), level, Line("centre", self.arc(reach.overrun)))

    def end(self, head: Point) -> Point:
        """Return where the rocker ends: at its pivot, or with another arm as far beyond it."""
        x, y = self.pivot
        return (2 * x - head[0], 2 * y - head[1]) if self.is_beam else self.pivot

    def swept(self, start: Point, end: Point) -> list[float]:
        """Return directions from the pivot to places of the arc between two, in degrees, rising."""
        (x, y), places = self.pivot, (start, end)
        first, last = (math.degrees(math.atan2(up - y, along - x)) for along, up in places)
        turn = (last - first + 180) % 360 - 180
        return sorted(first + turn * step / 40 for step in range(41))

    def arc(self, overrun: float = 0.0) -> tuple[Point, ...]:
        """Return the way of the rod's end between the dead centres, and so far beyond them."""
        turns, more = self.swept(self.inner.head, self.outer.head), math.degrees(overrun / self.length)
        if overrun:
            turns = [turns[0] - more, *turns, turns[-1] + more]
        return tuple(polar_point(self.pivot, self.length, turn) for turn in turns)


def slide_scene(crank: Crank, angles: Sequence[float] = TURN) -> Scene | None:
    """Return the crank drive, nothing for a rod too long to be drawn beside its crank."""
    if crank.ratio * LONGEST_ROD < 1:
        return None
    drive = Slide(float(crank.ratio), float(crank.offset))
    offset, last = drive.offset, drive.inner.head[0]
    right = last + 2 * HEAD + 0.1
    level = min(offset, -1.0) - LEVEL if offset < 0 else offset - GUIDE - LEVEL
    joints = _joints(drive.stand, angles)
    return Scene(
        low=(-BEYOND, min(-BEYOND, level - 0.2)),
        high=(right, max(BEYOND, offset + GUIDE + 0.2)),
        fixed=(
            *drive.fixed(FixedExtent(BEYOND, right, 2 * HEAD, GUIDE)),
            Line("bearing", (SHAFT,)),
            *drive.dead,
        ),
        **joints,
        heads=joints["pins"][1:],
        path=(last, level),
    )


def rocker_scene(crank: RockerCrank, angles: Sequence[float] = TURN) -> Scene | None:
    """Return the arc crank or the beam engine, nothing for a rod or a rocker too long to be drawn beside its
    crank."""
    if crank.crank.ratio * LONGEST_ROD < 1 or crank.rocker > LONGEST_ROD:
        return None
    drive = Rocker(crank)
    joints, arc, pivot = _joints(drive.stand, angles), drive.arc(), drive.pivot
    xs, ys = zip(*arc, *joints["links"][2].end, pivot, (-1.0, -1.0), (1.0, 1.0), strict=True)
    high = max(xs) + ROOM, max(ys) + ROOM
    # The ground of the pivot is away from the rocker, or beside a beam.
    bearing = "beside" if drive.is_beam else "hung" if pivot[1] >= 0 else "below"
    return Scene(
        low=(min(xs) - ROOM, min(ys) - ROOM),
        high=high,
        fixed=(
            *drive.fixed(FixedExtent(BEYOND, high[0])),
            Line("bearing", (SHAFT,)),
            Line(bearing, (pivot,)),
            *drive.dead,
        ),
        **joints,
    )


def links_fixed(outline: Outline, beyond: float, beside: float) -> tuple[Line, ...]:
    """Return the lines of a drive that do not move, which go so far beyond shafts and beside links."""
    return (
        *(Line("centre", ((outline.left - beside, y), (outline.right + beside, y))) for y in outline.lines),
        *(line for shaft in outline.shafts for line in _crossed(shaft, beyond)),
    )


def links_scene(drive: Linkage, angles: Sequence[float] = TURN) -> Scene | None:
    """Return a drive by what it says of its outline, nothing for one without an outline."""
    outline = drive.outline()
    if outline is None:
        return None
    return Scene(
        low=(outline.left - 0.3, outline.low - 0.3),
        high=(outline.right + 0.3, outline.high + 0.3),
        fixed=(
            *links_fixed(outline, BEYOND, 0.3),
            *(Line("bearing", (shaft,)) for shaft in (*outline.shafts, *outline.pivots)),
        ),
        **_joints(lambda angle: outline.stand(crank_pin(angle)), angles),
    )


class Joints(TypedDict):
    """The links and the pins of a scene."""

    links: tuple[Link, ...]
    pins: tuple[Joint, ...]


def _joints(stand: Callable[[float], LinkagePosition], angles: Sequence[float]) -> Joints:
    """Return the links and the pins of a scene over these angles."""
    stands = [stand(angle) for angle in angles]
    letters = {name: letter.strip("$") for name, letter, _ in stands[0].letters}
    return {
        "links": tuple(
            Link(
                "crank" if "crank" in name else name,
                _joint(one.links[name][0] for one in stands),
                _joint(one.links[name][1] for one in stands),
                letters.get(name, ""),
            )
            for name in stands[0].links
        ),
        "pins": tuple(map(_joint, zip(*(one.pins for one in stands), strict=True))),
    }


def _joint(places: Iterable[Point]) -> Joint:
    """Return where a joint is, once if it stays."""
    found = tuple(places)
    return found[:1] if len(set(found)) == 1 else found


def _crossed(centre: Point, beyond: float) -> tuple[Line, ...]:
    """Return a circle of radius R and the centre line square to the line of shafts."""
    x, y = centre
    return Line("circle", (centre,)), Line("centre", ((x, y - beyond), (x, y + beyond)))
