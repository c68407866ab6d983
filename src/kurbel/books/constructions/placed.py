"""A drive at a crank angle, as constructions have it, with compasses and ruler on numbers of any kind: its
points and lengths, and what may stand beside it: a point of the rod, the rod's masses, the steam.

Points are pairs of such numbers, floats, balls or separation bounds. Nothing here asks what a number is or
which of two is greater: where two points answer, the caller says which one by a sign.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.drive.at import At
from kurbel.drive.rod import Rod
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label, exact_text
from kurbel.kernel.circle import Circle, Numeric, root
from kurbel.kernel.parts import AccelerationParts, parted
from kurbel.kernel.rocker import LoadedRocker
from kurbel.kernel.rod import LoadedCrank
from kurbel.motion.evaluation import OUT
from kurbel.page.quantity import Words, words

if TYPE_CHECKING:
    from kurbel.engine.loads.ideal import Steam


class Point(NamedTuple):
    """A point, or a vector, across and up."""

    x: Numeric
    y: Numeric


def plus(point: Point, vector: Point, times: Numeric = 1) -> Point:
    """Return a point moved by so many times a vector."""
    return Point(point.x + times * vector.x, point.y + times * vector.y)


def to(start: Point, end: Point) -> Point:
    """Return the vector from one point to another."""
    return Point(end.x - start.x, end.y - start.y)


def turned(vector: Point) -> Point:
    """Return the vector turned by 90° to the left."""
    return Point(-vector.y, vector.x)


def dot(one: Point, other: Point) -> Numeric:
    return one.x * other.x + one.y * other.y


def cross(one: Point, other: Point) -> Numeric:
    """Return the area between two vectors, positive where the second is on the left of the first."""
    return one.x * other.y - one.y * other.x


def distance(start: Point, end: Point) -> Numeric:
    """Return the length between two points; positive, and 0 where they are the same."""
    vector = to(start, end)
    return root(dot(vector, vector))


def foot(point: Point, start: Point, end: Point) -> Point:
    """Return where the perpendicular from a point meets the line through two others."""
    along = to(start, end)
    return plus(start, along, dot(to(start, point), along) / dot(along, along))


def meet(start: Point, along: Point, other: Point, way: Point) -> Point:
    """Return where a line through one point along a vector meets that through another along its vector."""
    return plus(start, along, cross(to(start, other), way) / cross(along, way))


def on_circle(start: Point, along: Point, centre: Point, radius: Numeric, side: int = 1) -> Point:
    """Return where a line meets a circle, the farther point along the vector (1) or the nearer (-1)."""
    back = to(centre, start)
    square, half = dot(along, along), dot(along, back)
    deep = root(half * half - square * (dot(back, back) - radius * radius))
    return plus(start, along, (side * deep - half) / square)


def circles(one: Point, radius: Numeric, other: Point, second: Numeric, side: int = 1) -> Point:
    """Return where two circles meet, on the left (1) or the right (-1) of the way between their centres."""
    way = to(one, other)
    square = dot(way, way)
    share = (square + radius * radius - second * second) / (2 * square)
    high = root(radius * radius / square - share * share)
    return plus(plus(one, way, share), turned(way), side * high)


# Of the rod, in its lengths, where they are not given: its centre of mass from B and its radius of gyration.
CENTRE, GYRATION = Fraction(65, 100), Fraction(35, 100)


class BesideDrive(NamedTuple):
    """The share of the rod from the crosshead pin at which a point of it lies, the rod and the steam, where
    they are given."""

    point: Fraction = Fraction(1, 2)
    rod: Rod | None = None
    steam: Steam | None = None


ALONE = BesideDrive()
# The options.
TAKEN = ("point", "centre", "gyration", "eps", "back")
WORDS: Mapping[str, Words] = {
    "point": words("$D$ liegt um $x = {x} l$ von $B$|$D$ lies $x = {x} l$ from $B$"),
    "constant": words("Die Kolbenkraft ist überall $P = Q$|The piston force is $P = Q$ throughout"),
    "steam": words(
        "Dampf mit dem Expansionsverhältnis $ε = {eps}$ und dem Gegendruck $R_b = {back}$; $Q$ vor der"
        " Absperrung"
        "|Steam with the expansion ratio $ε = {eps}$ and the back pressure $R_b = {back}$; $Q$ before cut-off"
    ),
}


def beside_labels(beside: BesideDrive, takes: Collection[str], lang: str) -> Iterator[Label]:
    """Yield what pages say of what stands beside the drive."""
    if "point" in takes:
        yield WORDS["point"][lang].format(x=exact_text(beside.point))
    if "eps" in takes and beside.steam is None:
        yield WORDS["constant"][lang]
    elif beside.steam is not None:
        back, ratio = beside.steam.back, exact_text(beside.steam.expansion)
        said = "Q/ε" if back is None else f"{exact_text(back)} Q" if back else "0"
        yield WORDS["steam"][lang].format(eps=ratio, back=said)


# The rod's mass where it is not given.
USUAL = Rod.from_crosshead(CENTRE, GYRATION)


class Position(NamedTuple):
    """A position of the straight crank that no angle in degrees says: where its pin is, and in words."""

    pin: Callable[[PlacedDrive], Point]
    words: Words


@dataclass(frozen=True)
class PlacedDrive:
    """A drive, a Crank or one that has its crank, at a crank angle φ in degrees, on a kind of number. Of a
    Crank φ counts from the slide direction, as of the straight one from the inner dead centre.

    A `position` gives the place on the circle of what no angle in degrees says; the angle is then near it.
    Lengths are in units of R, from the shaft O: across towards the crosshead, up on the side of the crank pin
    on the outstroke.
    """

    drive: Any
    angle: Fraction
    kind: Kind
    position: Position | None = None
    beside: BesideDrive = ALONE

    @cached_property
    def circle(self) -> Circle[Numeric]:
        if self.position is None:
            return self.kind.circle(self.angle)
        pin = self.position.pin(self)
        return Circle(pin.y, pin.x, 1 - pin.x)

    @cached_property
    def ratio(self) -> Numeric:
        """λ."""
        return self.number(self.drive.crank.ratio)

    @cached_property
    def rod(self) -> Numeric:
        """L."""
        return self.number(1 / self.drive.crank.ratio)

    @cached_property
    def offset(self) -> Numeric:
        """e."""
        return self.number(self.drive.crank.offset)

    def number(self, value: Fraction | int) -> Numeric:
        return self.kind.of(Fraction(value))

    @property
    def pin(self) -> Point:
        return Point(self.circle.cosine, self.circle.sine)

    @property
    def guided(self) -> bool:
        """Whether the rod's end is on a rocker."""
        return hasattr(self.drive, "rocker")

    @cached_property
    def end(self) -> Point:
        """Where the rod ends: the crosshead, or the pin of the rocker."""
        if self.guided:
            return self.end_on_rocker(self.pin, self.rod)
        return self.crosshead(self.pin)

    def crosshead(self, pin: Point) -> Point:
        """Return where the crosshead stands while the crank pin is there."""
        side = pin.y - self.offset
        return Point(pin.x + root(self.rod * self.rod - side * side), self.offset)

    @cached_property
    def pivot(self) -> Point:
        """The bearing of the rocker."""
        drive = self.drive
        return Point(self.number(1 / drive.crank.ratio + drive.shift), self.number(drive.pivot_height))

    @cached_property
    def bearing(self) -> Point:
        """That of a slotted lever, below the shaft."""
        return Point(self.number(0), self.number(-self.drive.pivot))

    @cached_property
    def tip(self) -> Point:
        """The end of that lever's arm."""
        way = to(self.bearing, self.pin)
        return plus(self.bearing, way, self.number(self.drive.arm) / root(dot(way, way)))

    def end_on_rocker(self, centre: Point, radius: Numeric) -> Point:
        """Return where a circle cuts that of the rocker: seen from its centre right of the pivot, for a
        negative curvature left of it."""
        side = -1 if self.drive.curvature > 0 else 1
        return circles(centre, radius, self.pivot, self.number(self.drive.rocker), side)

    @cached_property
    def linked(self) -> At:
        """What kernel calls of a linkage take."""
        found: At = self.drive.at(OUT, self.circle, self.kind, "exact")
        return found

    @property
    def mass(self) -> Rod:
        """The rod with its mass."""
        return self.beside.rod or USUAL

    @cached_property
    def parted(self) -> AccelerationParts:
        """What the kernel knows of the rod's acceleration."""
        masses = self.mass.masses("exact", self.kind.of)
        if self.guided:
            found = self.linked
            own = {"place": found.place, "arc": found.arc}
            return parted(LoadedRocker(found.circle, found.arc.ratio, masses, **own))
        offset = self.offset if self.drive.offset else None
        return parted(LoadedCrank(self.circle, self.ratio, masses, offset))
