"""A drive at a crank angle, as constructions have it: its points and lengths on a kind of number."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple

from kurbel.books.constructions.beside import ALONE, CENTRE, GYRATION, Beside
from kurbel.books.constructions.geometry import Point, circles
from kurbel.drive.rod import Rod
from kurbel.exact.kind import Kind
from kurbel.kernel.circle import Circle, root
from kurbel.kernel.inertia.parts import Parted, parted, parted_rocker
from kurbel.motion.evaluation import OUT
from kurbel.page.quantity import Words

# The rod's mass where it is not given.
USUAL = Rod.from_crosshead(CENTRE, GYRATION)


class Position(NamedTuple):
    """A position of the straight crank that no angle in degrees says: where its pin is, and in words."""

    pin: Callable[[Placed], Point]
    words: Words


@dataclass(frozen=True)
class Placed:
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
    beside: Beside = ALONE

    @cached_property
    def circle(self) -> Any:
        if self.position is None:
            return self.kind.circle(self.angle)
        pin = self.position.pin(self)
        return Circle(pin.y, pin.x, 1 - pin.x)

    @cached_property
    def ratio(self) -> Any:
        """λ."""
        return self.number(self.drive.crank.ratio)

    @cached_property
    def rod(self) -> Any:
        """L."""
        return self.number(1 / self.drive.crank.ratio)

    @cached_property
    def offset(self) -> Any:
        """e."""
        return self.number(self.drive.crank.offset)

    def number(self, value: Fraction | int) -> Any:
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

    def end_on_rocker(self, centre: Point, radius: Any) -> Point:
        """Return where a circle cuts that of the rocker: seen from its centre right of the pivot, for a
        negative curvature left of it."""
        side = -1 if self.drive.curvature > 0 else 1
        return circles(centre, radius, self.pivot, self.number(self.drive.rocker), side)

    @cached_property
    def linked(self) -> Any:
        """What kernel calls of the rocker take."""
        return self.drive.at(OUT, self.circle, self.kind)

    @property
    def mass(self) -> Rod:
        """The rod with its mass."""
        return self.beside.rod or USUAL

    @cached_property
    def parted(self) -> Parted:
        """What the kernel knows of the rod's acceleration."""
        masses = self.mass.masses("exact", self.kind.of)
        if self.guided:
            found = self.linked
            return parted_rocker(found.circle, found.place, found.arc, masses)
        return parted(self.circle, self.ratio, masses, self.offset if self.drive.offset else None)
