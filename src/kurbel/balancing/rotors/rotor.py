"""Rotating masses of a shaft: what they leave unbalanced, and what balances them in given planes.

The unbalance of a mass is its mass times its radius, a vector from the shaft to it; its moment is that times
the position of its plane along the shaft. Turning at ω it pulls at the shaft with ω² times the unbalance.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from kurbel.balancing.vector import Vector
from kurbel.drive.at import known
from kurbel.drive.crank import LARGEST_ANGLE
from kurbel.errors import ProblemError
from kurbel.exact.real import Real
from kurbel.reading.notation import about

MOST_MASSES = 100
LARGEST = 10**6


class Mass(NamedTuple):
    """A mass in kg at a radius in m, in a direction in degrees, in a plane in m; None is asked for."""

    mass: Fraction | None
    radius: Fraction | None
    angle: Fraction | None
    plane: Fraction | None

    @property
    def free(self) -> bool:
        """Whether nothing is known but its radius, and its plane or not."""
        return self.mass is None and self.angle is None

    @property
    def vector(self) -> Vector:
        """The unbalance in kg m of a mass that is known."""
        return Vector.ray(known(self.angle), self.unbalance)

    @property
    def unbalance(self) -> Fraction:
        return known(self.mass) * known(self.radius)


class Placed(NamedTuple):
    """A mass as it is known or found: its unbalance in kg m, its plane in m; as it was given, if it was."""

    vector: Vector
    plane: Real
    given: Mass


@dataclass(frozen=True, slots=True)
class Rotor:
    """The masses of a shaft, and the zero of the moments along it."""

    masses: tuple[Mass, ...]
    about: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        if not 1 <= len(self.masses) <= MOST_MASSES:
            raise ProblemError(f"{len(self.masses)} masses were given; a rotor has 1 to {MOST_MASSES}")
        for number, one in enumerate(self.masses, 1):
            _check(number, one)


def _check(number: int, one: Mass) -> None:
    for what, unit, value in (("mass", "kg", one.mass), ("radius", "m", one.radius)):
        if value is not None and not 0 < value <= LARGEST:
            raise ProblemError(
                f"{what} {number} is {about(value)} {unit}; it must be above 0 and at most {LARGEST} {unit},"
                " and what lies opposite has its angle 180° farther"
            )
    if one.radius is None and one.mass is not None:
        raise ProblemError(f"mass {number} has no radius; give all, --radii, or one for all masses")
    if one.angle is not None and abs(one.angle) > LARGEST_ANGLE:
        raise ProblemError(f"the angle of mass {number} is beyond {LARGEST_ANGLE}°; give it within one turn")
    if one.plane is not None and abs(one.plane) > LARGEST:
        raise ProblemError(f"the plane of mass {number} lies beyond {LARGEST} m")


def force(masses: Sequence[Placed]) -> Vector:
    """Return the unbalance of all masses together, in kg m."""
    return sum((one.vector for one in masses), Vector())


def moment(masses: Sequence[Placed], about: Fraction) -> Vector:
    """Return the moment of the unbalances in kg m², in the direction of the forces of the couple.

    Without an unbalance of all together it is the same about any point.
    """
    planes = [one.plane.rational for one in masses]
    if None in planes:
        # Planes are found from two linear equations, so that masses balanced in their forces have no couple.
        return Vector()
    arms = zip(masses, planes, strict=True)
    return sum((one.vector * (known(plane) - about) for one, plane in arms), Vector())


def shares(masses: Sequence[Placed], planes: Sequence[Fraction]) -> tuple[Vector, ...]:
    """Return the unbalances in one or two planes that have the force and the moment of the masses.

    Times ω² they are the forces on bearings there; the opposite ones balance the masses. In one plane they
    leave a couple.
    """
    if len(planes) == 1:
        return (force(masses),)
    near, far = planes
    if near == far:
        raise ProblemError(f"both planes lie at {about(near)} m; only two different ones take up a couple")
    there = moment(masses, near) * (1 / (far - near))
    return force(masses) - there, there


class Places(NamedTuple):
    """The planes of balancing masses with the radii of these, and those of bearings, in m."""

    balance: tuple[Fraction, ...] = ()
    radii: tuple[Fraction | None, ...] = ()
    bearings: tuple[Fraction, ...] = ()


class Line(NamedTuple):
    """A line of a page by its key: of a mass, balancing mass or bearing by its number, or of all masses
    together. What it says nothing of is None."""

    key: str
    number: int = 0
    mass: Real | None = None
    radius: Real | None = None
    plane: Real | None = None
    unbalance: Real | None = None
    moment: Real | None = None
    angle: Fraction | Vector | None = None


def lines(rotor: Rotor, standing: Sequence[Placed], places: Places) -> Iterator[Line]:
    """Yield the lines of a way in which the masses stand: these, what they leave, what balances them."""
    yield from _masses("mass", standing, rotor.about)
    yield from _sums("", standing, rotor.about)
    if places.balance:
        found = zip(shares(standing, places.balance), places.balance, places.radii, strict=True)
        added = [
            Placed(one * Fraction(-1), Real.of(plane), Mass(None, radius, None, plane))
            for one, plane, radius in found
        ]
        yield from _masses("balance", added, rotor.about)
        standing = (*standing, *added)
        yield from _sums("left_", standing, rotor.about)
    if places.bearings:
        pulls = zip(shares(standing, places.bearings), places.bearings, strict=True)
        for number, (one, plane) in enumerate(pulls, 1):
            yield Line("bearing", number, plane=Real.of(plane), unbalance=one.length(), angle=one)


def _masses(key: str, masses: Sequence[Placed], about: Fraction) -> Iterator[Line]:
    for number, (vector, plane, given) in enumerate(masses, 1):
        mass, radius, angle, _ = given
        of_radius = None if radius is None else Real.of(radius)
        unbalance = vector.length() if mass is None else Real.of(given.unbalance)
        own = Real.of(mass) if mass is not None else unbalance / of_radius if of_radius else None
        direction = vector if mass is None or angle is None else angle
        yield Line(key, number, own, of_radius, plane, unbalance, unbalance * (plane - about), direction)


def _sums(before: str, masses: Sequence[Placed], about: Fraction) -> Iterator[Line]:
    """Yield what masses leave together: an unbalance and a couple."""
    rest, couple = force(masses), moment(masses, about)
    yield Line(f"{before}unbalance", unbalance=rest.length(), angle=rest)
    yield Line(f"{before}couple", moment=couple.length(), angle=couple)
