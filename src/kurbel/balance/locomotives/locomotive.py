"""What the cranks of a locomotive leave unbalanced, with masses in the wheels for a share of what goes to
and fro.

The masses in the wheels turn: they balance what turns with the cranks wholly, of what goes to and fro the
share c along the slides, and what they have for that presses the wheels on the rails and lifts them, the
hammer blow. Along the slides the rest, 1 - c, pulls at the train and turns the frame about its upright.
Forces of the first order, of an infinite rod. Standard theory, re-derived.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from kurbel.balance.rotors.rotor import Mass, Placed, balancing, force, moment, shares
from kurbel.balance.vector import Scale, Value, Vector, estimate
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.reading.notation import about
from kurbel.reading.units import Speed

MOST_CYLINDERS = 8
LARGEST = 10**9


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

    def _placed(self, masses: Sequence[Fraction]) -> list[Placed]:
        return [
            Placed(
                Vector.ray(one.angle, mass * self.radius),
                one.place,
                Mass(mass, self.radius, one.angle, one.place),
            )
            for one, mass in zip(self.cranks, masses, strict=True)
        ]

    def balance(self, share: Fraction) -> tuple[Vector, ...]:
        """Return the unbalances in kg m of the masses in the left and the right wheel."""
        return balancing(
            self._placed([one.revolving + share / self.axles * one.reciprocating for one in self.cranks]),
            self.planes,
        )

    def blows(self, share: Fraction) -> tuple[Vector, ...]:
        """Return those of them that are for what goes to and fro; times ω² they are the hammer blows."""
        return shares(
            self._placed([share / self.axles * one.reciprocating for one in self.cranks]), self.planes
        )

    def blow(self, share: Fraction) -> Vector:
        """Return the greater one."""
        left, right = self.blows(share)
        return right if estimate(right.square()) > estimate(left.square()) else left

    def pull(self, share: Fraction) -> Vector:
        """Return what pulls along the slides, in kg m at φ = 0; it turns with the axle."""
        return force(self._placed(self._left(share)))

    def sway(self, share: Fraction) -> Vector:
        """Return the moment of that about the middle of the axle, in kg m²."""
        return moment(self._placed(self._left(share)), Fraction(0))

    def _left(self, share: Fraction) -> list[Fraction]:
        return [(1 - share) * one.reciprocating for one in self.cranks]


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

    def omega(self, power: int = 1) -> Scale | None:
        """Return a power of ω, None where it is not known."""
        if self.speed is not None:
            return Scale.speed(self.speed, power)
        if self.velocity is None or self.wheel is None:
            return None
        return Scale((2 * self.velocity / self.wheel) ** power)


def lifting(blow: Vector, load: Fraction) -> Value:
    """Return ω in 1/s at which the hammer blow is the load of the wheel."""
    length = blow.length()

    def value(kind: Kind) -> object:
        return (kind.of(load) / length(kind)) ** kind.exponent(Fraction(1, 2))

    return value
