"""Vectors in the plane across the shaft, with certified length and direction.

A vector is a star, whose zeros are known by exact arithmetic, and multiples of others that are known on any
kind of number.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from math import inf
from typing import Any, NamedTuple, TypeAlias

import flint

from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact import certify
from kurbel.exact.kind import Kind, balls, bounds
from kurbel.exact.numerals import Number, figures, nearest
from kurbel.kernel.balance import Star
from kurbel.reading.units import Speed

EXACT_ZERO = Number(0, 0)
"""A value that is 0 by proof is printed as 0, one that is only small as 0.0000."""
ESTIMATE_BITS = 128
Point: TypeAlias = Callable[[Kind], tuple[Any, Any]]
Value: TypeAlias = Callable[[Kind], Any]


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

    def point(self, kind: Kind) -> tuple[Any, Any]:
        """Return x and y."""
        x, y = self.star.point(kind.circle, kind.of)
        for of, times in self.rest:
            along, across = of(kind)
            x, y = x + kind.of(times) * along, y + kind.of(times) * across
        return x, y

    def vanishes(self) -> bool:
        """Return whether it is 0, by proof."""
        if not self.rest:
            return self.star.vanishes()
        return is_zero(lambda kind: self.point(kind)[0]) and is_zero(lambda kind: self.point(kind)[1])

    def lies_along(self, degrees: Fraction) -> bool:
        """Return whether it has this direction or the opposite one, by proof."""
        if not self.rest:
            turned = self.star.turned(-degrees)
            return (turned - turned.mirrored()).vanishes()

        def across(kind: Kind) -> Any:
            x, y = self.point(kind)
            circle = kind.circle(degrees)
            return y * circle.cosine - x * circle.sine

        return is_zero(across)

    def square(self) -> Value:
        """Return the square of the length."""

        def value(kind: Kind) -> Any:
            x, y = self.point(kind)
            return x * x + y * y

        return value

    def length(self) -> Value:
        """Return the length."""
        square = self.square()

        def value(kind: Kind) -> Any:
            found = square(kind)
            if isinstance(found, flint.arb):
                # A ball about 0, of a vector that is not told from it, has no root.
                found = found.nonnegative_part()
            return found ** kind.exponent(Fraction(1, 2))

        return value


def is_zero(value: Value) -> bool:
    """Return whether an algebraic number is 0, by proof."""
    return certify.vanishes(lambda: value(balls()), value(bounds()).bits())


class Scale(NamedTuple):
    """A rational number times a power of π, and times a transcendental number that is known on balls."""

    value: Fraction = Fraction(1)
    turns: int = 0
    factor: Value | None = None

    @classmethod
    def speed(cls, speed: Speed, power: int = 1) -> Scale:
        """Return a power of the angular velocity in 1/s."""
        return cls((2 * speed.value if speed.turns else speed.value) ** power, power if speed.turns else 0)

    @classmethod
    def pin_acceleration(cls, crank: Crank) -> Scale:
        """Return R ω² in m/s²."""
        assert crank.speed is not None and crank.radius is not None
        return cls.speed(crank.speed, 2).times(crank.radius)

    def times(self, times: Fraction | Value) -> Scale:
        if isinstance(times, Fraction):
            return self._replace(value=self.value * times)
        return self._replace(factor=times)

    @property
    def algebraic(self) -> bool:
        return not self.turns and self.factor is None

    def on(self, kind: Kind) -> Any:
        own = kind.of(self.value)
        for _ in range(abs(self.turns)):
            own = own * kind.pi if self.turns > 0 else own / kind.pi
        return own if self.factor is None else own * self.factor(kind)


ONE = Scale()


def printed(
    value: Value, decimals: int | None, rounding: str = "half-away", algebraic: bool = True
) -> Number:
    """Return a value that is not 0 by proof, correctly rounded; without decimals to five figures.

    One that is not `algebraic` is not a rational number.
    """
    if decimals is None:
        decimals = figures(estimate(value))

    def tie_bits(boundary: Fraction) -> float:
        kind = bounds()
        return float((value(kind) - kind.of(boundary)).bits())

    ties = tie_bits if algebraic else certify.NEVER_TIES
    return Number(certify.rounded(lambda: value(balls()), decimals, rounding, ties), decimals)


def estimate(value: Value) -> float:
    """Return a float near the value, 0 for one that is not told from it."""
    with flint.ctx.workprec(ESTIMATE_BITS):
        near = value(balls())
        return float(near.mid()) if near.is_finite() else 0.0


def length(vector: Vector, decimals: int | None, rounding: str = "half-away", scale: Scale = ONE) -> Number:
    """Return the length times a scale above 0, correctly rounded; 0 where it is proved to be 0."""
    if vector.vanishes():
        return EXACT_ZERO
    own = vector.length()
    return printed(lambda kind: scale.on(kind) * own(kind), decimals, rounding, scale.algebraic)


def component(
    vector: Vector,
    axis: int,
    decimals: int | None,
    rounding: str = "half-away",
    scale: Scale = ONE,
) -> Number:
    """Return x (axis 0) or y (axis 1) times a scale, correctly rounded; 0 where it is proved to be 0."""
    if vector.lies_along(Fraction(90 - 90 * axis)):
        return EXACT_ZERO
    return printed(
        lambda kind: scale.on(kind) * vector.point(kind)[axis], decimals, rounding, scale.algebraic
    )


def direction(vector: Vector, decimals: int, rounding: str = "half-away", parts: int = 1) -> Number | None:
    """Return the direction in degrees within 0..360, correctly rounded, None where there is none; or one of
    so many parts of it.

    That a direction lies half-way between two printed ones is decided by exact arithmetic for stars; others
    are arcs of what is algebraic.
    """
    if vector.vanishes():
        return None
    quarter = _quarter(vector)
    if vector.lies_along(Fraction(90 * quarter)):
        return nearest(Fraction(90 * quarter, parts), decimals, rounding)

    def value() -> Any:
        x, y = vector.point(balls())
        for _ in range(quarter):
            x, y = y, -x
        turn = 360 if not quarter and y < 0 else 90 * quarter
        return (flint.arb.atan2(y, x) * 180 / flint.arb.pi() + turn) / parts

    def tie_bits(boundary: Fraction) -> float:
        return 0.0 if vector.lies_along(boundary * parts) else inf

    ties = certify.NEVER_TIES if vector.rest else tie_bits
    return Number(certify.rounded(value, decimals, rounding, ties), decimals)


def _quarter(vector: Vector) -> int:
    """Return the quarter turn that is nearest to the direction of a vector that is not 0."""
    bits = ESTIMATE_BITS
    while True:
        with flint.ctx.workprec(bits):
            x, y = vector.point(balls())
            if abs(x) > abs(y) * flint.arb(0.5):
                if not x.contains(0):
                    return 0 if x > 0 else 2
            elif not y.contains(0):
                return 1 if y > 0 else 3
        bits *= 2
        if bits > certify.MOST_BITS:
            raise ProblemError(
                f"a direction is not settled by {bits // 2} bits: what it is of may be 0; leave its column"
                " out"
            )
