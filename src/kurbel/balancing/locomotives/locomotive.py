"""What the cranks of a locomotive leave unbalanced, with masses in the wheels for a share of what goes to
and fro.

The masses in the wheels turn: they balance what turns with the cranks wholly, of what goes to and fro the
share c along the slides, and what they have for that presses the wheels on the rails and lifts them, the
hammer blow. Along the slides the rest, 1 - c, pulls at the train and turns the frame about its upright.
Forces of the first order, of an infinite rod. Standard theory, re-derived.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from kurbel.balancing.rotors.rotor import Mass, Placed, force, moment, shares
from kurbel.balancing.vector import Vector, omega
from kurbel.errors import ProblemError
from kurbel.exact.real import Real
from kurbel.reading.notation import about
from kurbel.reading.units import Speed

MOST_CYLINDERS = 8
LARGEST = 10**9
_UNKNOWN = Mass(None, None, None, None)


class Crank(NamedTuple):
    """A crank: its angle in degrees, the place of its cylinder's centre line in m across the engine, and the
    masses in kg that go to and fro and that turn with it, at its radius."""

    angle: Fraction
    place: Fraction
    reciprocating: Fraction
    revolving: Fraction


@dataclass(frozen=True, slots=True)
class Locomotive:
    """The cranks on an axle, their radius and the distance of the planes of its wheels, in m.

    Of several coupled `axles` each has an equal part of what balances the reciprocating masses; the revolving
    ones are those of the axle with the cranks.
    """

    cranks: tuple[Crank, ...]
    radius: Fraction
    gauge: Fraction
    axles: int = 1

    def __post_init__(self) -> None:
        if not 1 <= len(self.cranks) <= MOST_CYLINDERS:
            raise ProblemError(f"{len(self.cranks)} cranks were given; an axle has 1 to {MOST_CYLINDERS}")
        for what, size in (("gauge", self.gauge), ("crank radius", self.radius)):
            if not 0 < size <= LARGEST:
                raise ProblemError(f"the {what} is {about(size)} m; it must be above 0")
        if not any(one.reciprocating for one in self.cranks):
            raise ProblemError("no mass goes to and fro; add that of a cylinder, --reciprocating 300kg")

    @property
    def planes(self) -> tuple[Fraction, Fraction]:
        return -self.gauge / 2, self.gauge / 2

    def _placed(self, masses: Iterable[Fraction]) -> list[Placed]:
        return [
            Placed(Vector.ray(one.angle, mass * self.radius), Real.of(one.place), _UNKNOWN)
            for one, mass in zip(self.cranks, masses, strict=True)
        ]

    def balance(self, share: Fraction) -> tuple[Vector, ...]:
        """Return the unbalances in kg m of the masses in the left and the right wheel."""
        masses = (one.revolving + share / self.axles * one.reciprocating for one in self.cranks)
        return tuple(one * Fraction(-1) for one in shares(self._placed(masses), self.planes))

    def blows(self, share: Fraction) -> tuple[Vector, ...]:
        """Return those of them that are for what goes to and fro; times ω² they are the hammer blows."""
        masses = (share / self.axles * one.reciprocating for one in self.cranks)
        return shares(self._placed(masses), self.planes)

    def blow(self, share: Fraction) -> Vector:
        """Return the greater one."""
        left, right = self.blows(share)
        return right if float(right.square()) > float(left.square()) else left

    def left(self, share: Fraction) -> list[Placed]:
        """Return what pulls along the slides at φ = 0; it turns with the axle."""
        return self._placed((1 - share) * one.reciprocating for one in self.cranks)

    def pull(self, share: Fraction) -> Vector:
        """Return the sum of that, in kg m."""
        return force(self.left(share))

    def sway(self, share: Fraction) -> Vector:
        """Return its moment about the middle of the axle, in kg m²."""
        return moment(self.left(share), Fraction(0))


class Run(NamedTuple):
    """How it runs, as far as that is known: ω as a speed of the axle or by the train's in m/s, the diameter
    of the wheels in m, the load of a wheel and the greatest hammer blow allowed in N, and the radius of the
    balancing masses in m."""

    speed: Speed | None = None
    velocity: Fraction | None = None
    wheel: Fraction | None = None
    load: Fraction | None = None
    limit: Fraction | None = None
    radius: Fraction | None = None

    @property
    def omega(self) -> Real | None:
        """ω in 1/s, None where it is not known."""
        if self.speed is not None:
            return omega(self.speed)
        if self.velocity is None or self.wheel is None:
            return None
        return Real.of(2 * self.velocity / self.wheel)
