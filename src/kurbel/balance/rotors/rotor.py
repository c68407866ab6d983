"""Rotating masses of a shaft: what they leave unbalanced, and what balances them in given planes.

The unbalance of a mass is its mass times its radius, a vector from the shaft to it; its moment is that times
the position of its plane along the shaft. Turning at ω it pulls at the shaft with ω² times the unbalance.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from kurbel.balance.vector import Value, Vector
from kurbel.drive.crank import LARGEST_ANGLE
from kurbel.errors import ProblemError
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
        assert self.angle is not None
        return Vector.ray(self.angle, self.unbalance)

    @property
    def unbalance(self) -> Fraction:
        assert self.mass is not None and self.radius is not None
        return self.mass * self.radius


class Placed(NamedTuple):
    """A mass as it is known or found: its unbalance in kg m, its plane in m; as it was given, if it was."""

    vector: Vector
    plane: Fraction | Value
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
    planes = [one.plane for one in masses]
    if not all(isinstance(plane, Fraction) for plane in planes):
        # Planes are found from two linear equations, so that masses balanced in their forces have no couple.
        return Vector()
    return sum((one.vector * (plane - about) for one, plane in _in_planes(masses)), Vector())


def _in_planes(masses: Sequence[Placed]) -> Iterator[tuple[Placed, Fraction]]:
    for one in masses:
        assert isinstance(one.plane, Fraction)
        yield one, one.plane


def balancing(masses: Sequence[Placed], planes: Sequence[Fraction]) -> tuple[Vector, ...]:
    """Return the unbalances in kg m that balance the masses in these planes.

    In two planes they leave nothing; in one they balance the forces and leave a couple.
    """
    return tuple(shared * Fraction(-1) for shared in shares(masses, planes))


def shares(masses: Sequence[Placed], planes: Sequence[Fraction]) -> tuple[Vector, ...]:
    """Return the unbalances in one or two planes that have the force and the moment of the masses.

    Times ω² they are the forces on bearings there.
    """
    if len(planes) == 1:
        return (force(masses),)
    near, far = planes
    if near == far:
        raise ProblemError(f"both planes lie at {about(near)} m; only two different ones take up a couple")
    there = moment(masses, near) * (1 / (far - near))
    return force(masses) - there, there
