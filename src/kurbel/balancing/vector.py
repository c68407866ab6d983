"""Vectors in the plane across the shaft, with certified length and direction.

A vector is a star, whose zeros are known by exact arithmetic, and multiples of others that are known on any
kind of number.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from math import inf
from typing import TypeAlias

import flint

from kurbel.errors import ProblemError
from kurbel.exact import certify
from kurbel.exact.certify import at_bits, ball
from kurbel.exact.kind import Kind, balls
from kurbel.exact.numerals import Number, nearest
from kurbel.exact.real import ESTIMATE_BITS, PI, Real
from kurbel.kernel.circle import Numeric, root
from kurbel.kernel.harmonics import Star
from kurbel.reading.units import Speed

Point: TypeAlias = Callable[[Kind], tuple[Numeric, Numeric]]


@dataclass(frozen=True, slots=True)
class Vector:
    """A star and rational multiples of further points, each point once."""

    star: Star = field(default_factory=Star)
    rest: tuple[tuple[Point, Fraction], ...] = ()

    @classmethod
    def ray(cls, degrees: Fraction, length: Fraction) -> Vector:
        return cls(Star.ray(degrees, length))

    def __add__(self, other: Vector) -> Vector:
        multiples: dict[Point, Fraction] = dict(self.rest)
        for point, times in other.rest:
            multiples[point] = multiples.get(point, Fraction(0)) + times
        return Vector(self.star + other.star, tuple(one for one in multiples.items() if one[1]))

    def __sub__(self, other: Vector) -> Vector:
        return self + other * Fraction(-1)

    def __mul__(self, times: Fraction) -> Vector:
        return Vector(self.star * times, tuple((point, own * times) for point, own in self.rest if times))

    def point(self, kind: Kind) -> tuple[Numeric, Numeric]:
        """Return x and y."""
        x, y = self.star.point(kind.circle, kind.of)
        for of, times in self.rest:
            along, across = of(kind)
            x, y = x + kind.of(times) * along, y + kind.of(times) * across
        return x, y

    def doubled(self) -> Vector:
        """Return a vector of the same length, not 0, twice as far from 0°."""

        def point(kind: Kind) -> tuple[Numeric, Numeric]:
            x, y = self.point(kind)
            length = root(x * x + y * y)
            return (x * x - y * y) / length, 2 * x * y / length

        return Vector(rest=((point, Fraction(1)),))

    @property
    def parts(self) -> tuple[Real, Real]:
        return Real(lambda kind: self.point(kind)[0]), Real(lambda kind: self.point(kind)[1])

    def vanishes(self) -> bool:
        """Return whether it is 0, by proof."""
        return all(one.vanishes() for one in self.parts) if self.rest else self.star.vanishes()

    def lies_along(self, degrees: Fraction) -> bool:
        """Return whether it has this direction or the opposite one, by proof."""
        if not self.rest:
            turned = self.star.turned(-degrees)
            return (turned - turned.mirrored()).vanishes()

        def across(kind: Kind) -> Numeric:
            (x, y), circle = self.point(kind), kind.circle(degrees)
            return y * circle.cosine - x * circle.sine

        return Real(across).vanishes()

    def square(self) -> Real:
        """Return the square of the length."""
        # Of a star the angles between its rays are simpler than those in the plane.
        first = self.star.rays[0][0] if self.star.rays and not self.rest else Fraction(0)
        turned = Vector(self.star.turned(-360 * first), self.rest)

        def on(kind: Kind) -> Numeric:
            x, y = turned.point(kind)
            return x * x + y * y

        return Real(on)

    def length(self) -> Real:
        return Real.of(0) if self.vanishes() else self.square().root()

    def component(self, axis: int) -> Real:
        """Return x (axis 0) or y (axis 1)."""
        return Real.of(0) if self.lies_along(Fraction(90 - 90 * axis)) else self.parts[axis]

    def number(self, decimals: int, rounding: str = "half-away", parts: int = 1) -> Number | None:
        """Return the direction in degrees within 0..360, correctly rounded, None where there is none; or one
        of so many parts of it.

        That a direction lies half-way between two printed ones is decided by exact arithmetic for stars;
        others are arcs of what is algebraic.
        """
        if self.vanishes():
            return None
        quarter = self._quarter()
        if self.lies_along(Fraction(90 * quarter)):
            return nearest(Fraction(90 * quarter, parts), decimals, rounding)

        def value() -> Numeric:
            x, y = map(ball, self.point(balls()))
            for _ in range(quarter):
                x, y = y, -x
            turn = 360 if not quarter and y < 0 else 90 * quarter
            return (flint.arb.atan2(y, x) * 180 / flint.arb.pi() + turn) / parts

        def tie_bits(boundary: Fraction) -> float:
            return 0.0 if self.lies_along(boundary * parts) else inf

        ties = certify.NEVER_TIES if self.rest else tie_bits
        return Number(certify.rounded(value, decimals, rounding, ties), decimals)

    def _quarter(self) -> int:
        """Return the quarter turn that is nearest to the direction of a vector that is not 0."""
        bits = ESTIMATE_BITS
        while bits <= certify.MOST_BITS:
            with at_bits(bits):
                x, y = map(ball, self.point(balls()))
                if abs(x) > abs(y) * flint.arb(0.5):
                    if not x.contains(0):
                        return 0 if x > 0 else 2
                elif not y.contains(0):
                    return 1 if y > 0 else 3
            bits *= 2
        raise ProblemError(
            f"a direction is not settled by {bits // 2} bits: what it is of may be 0; leave its column out"
        )


def omega(speed: Speed) -> Real:
    """Return the angular velocity in 1/s."""
    return 2 * speed.value * PI if speed.turns else Real.of(speed.value)
