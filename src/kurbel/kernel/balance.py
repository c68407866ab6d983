"""Free forces of engines with several cranks: the star of cranks of each order, with exact arithmetic.

All pistons of an engine have the mass m. Each presses on the frame along its slide, away from the shaft,
with m times its acceleration p, the share of order k of which is B_k cos k(φ + δ - β) in units of m v²/R:
φ is the angle of the shaft, δ that of the cylinder's crank pin at φ = 0, β that of its slide, all from the
same line, counted as the shaft turns. As a complex number in the plane of the slides, x along that line,

    e^iβ cos k(φ + δ - β) = ½ e^i(kδ - (k-1)β) e^ikφ + ½ e^-i(kδ - (k+1)β) e^-ikφ,

a vector that turns forward and one that turns backward. Over the cylinders they add up to two `Star`s; times
the cylinders' positions along the shaft, to those of the moment. Standard theory, re-derived.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm
from typing import Any

from kurbel.kernel.circle import Circle, Numeric

HALF = Fraction(1, 2)


@dataclass(frozen=True, slots=True)
class Star:
    """Vectors in a plane, added: rays of a rational length at rational parts of a turn, each turn once."""

    rays: tuple[tuple[Fraction, Fraction], ...] = ()

    @classmethod
    def of(cls, rays: Iterable[tuple[Fraction, Fraction]]) -> Star:
        """Return the sum of rays (turn, length)."""
        lengths: dict[Fraction, Fraction] = {}
        for turn, length in rays:
            lengths[turn % 1] = lengths.get(turn % 1, Fraction(0)) + length
        return cls(tuple((turn, length) for turn, length in sorted(lengths.items()) if length))

    @classmethod
    def ray(cls, degrees: Fraction, length: Fraction = Fraction(1)) -> Star:
        return cls.of([(degrees / 360, length)])

    def __add__(self, other: Star) -> Star:
        return Star.of(self.rays + other.rays)

    def __sub__(self, other: Star) -> Star:
        return self + other * -1

    def __mul__(self, other: Star | Fraction | int) -> Star:
        """Return the product as of complex numbers, or a multiple."""
        rays = other.rays if isinstance(other, Star) else ((Fraction(0), Fraction(other)),)
        return Star.of((one + two, long * wide) for one, long in self.rays for two, wide in rays)

    def turned(self, degrees: Fraction) -> Star:
        return self * Star.ray(degrees)

    def mirrored(self) -> Star:
        """Return the conjugate, mirrored in the x-axis."""
        return Star.of((-turn, length) for turn, length in self.rays)

    def square(self) -> Star:
        """Return the square of the magnitude, a vector along the x-axis."""
        return self * self.mirrored()

    def point(
        self, circle: Callable[[Fraction], Circle[Numeric]], of: Callable[[Fraction], Numeric]
    ) -> tuple[Any, Any]:
        """Return x and y in the kind of number that `circle`, of degrees, and `of` make."""
        x = y = of(Fraction(0))
        for turn, length in self.rays:
            direction = circle(360 * turn)
            x = x + of(length) * direction.cosine
            y = y + of(length) * direction.sine
        return x, y

    def vanishes(self) -> bool:
        """Return whether the vectors add up to nothing, by proof."""
        order = lcm(*(turn.denominator for turn, _ in self.rays))
        return _vanish({int(turn * order): length for turn, length in self.rays}, order)


def forward(order: int, crank: Fraction, bank: Fraction, weight: Fraction) -> Star:
    """Return a cylinder's vector that turns forward, at φ = 0, in units of m R ω² B_k; angles in degrees."""
    return Star.ray(order * crank - (order - 1) * bank, weight * HALF)


def backward(order: int, crank: Fraction, bank: Fraction, weight: Fraction) -> Star:
    """Return a cylinder's vector that turns backward, at φ = 0, in units of m R ω² B_k."""
    return Star.ray((order + 1) * bank - order * crank, weight * HALF)


Powers = Mapping[int, Fraction]
"""Rational multiples of the powers of a primitive root of unity, by exponent."""


def _vanish(powers: Powers, order: int) -> bool:
    """Return whether the sum of the powers of a primitive root ζ of unity of this order is 0.

    A root of p² n-th order has the degree p over those of p n-th order, so that its powers 0..p-1 are
    independent over them: the sums that belong to each must vanish. One of order p, prime to n, has the
    degree p - 1 over those of n-th order, its powers adding up to 0: the sums that belong to each must be
    equal. Where there are fewer powers than p some of them are empty, and all must vanish. Hence
    primes above the number of powers need not be known.
    """
    if len(powers) < 2:
        return not any(powers.values())
    primes = [prime for prime in range(2, len(powers) + 1) if order % prime == 0 and _is_prime(prime)]
    smooth = order
    for prime in primes:
        while smooth % prime == 0:
            smooth //= prime
    rough, smooth = smooth, order // smooth
    return all(_vanish_smooth(part, smooth, primes) for part in _prime_parts(powers, rough, smooth).values())


def _vanish_smooth(powers: Powers, order: int, primes: list[int]) -> bool:
    """The same for an order that has no other primes than these."""
    free = 1
    for prime in primes:
        free *= prime
    square = order // free
    parts: dict[int, dict[int, Fraction]] = {}
    for exponent, length in powers.items():
        parts.setdefault(exponent % square, {})[exponent // square] = length
    return all(_vanish_square_free(part, free, primes) for part in parts.values())


def _vanish_square_free(powers: Powers, order: int, primes: list[int]) -> bool:
    if not primes:
        return not sum(powers.values())
    prime, *rest = primes
    order //= prime
    parts = _prime_parts(powers, prime, order)
    if len(parts) < prime:
        return all(_vanish_square_free(part, order, rest) for part in parts.values())
    first, *others = sorted(parts.values(), key=len)
    return all(_vanish_square_free(_difference(part, first), order, rest) for part in others)


def _prime_parts(powers: Powers, one: int, other: int) -> Mapping[int, Powers]:
    """Return the powers of roots of `one` · `other`-th order, which have no common factor, as powers of the
    `other`-th for each power of the first."""
    to_one, to_other = pow(other, -1, one), pow(one, -1, other)
    parts: dict[int, dict[int, Fraction]] = {}
    for exponent, length in powers.items():
        parts.setdefault(exponent * to_one % one, {})[exponent * to_other % other] = length
    return parts


def _difference(one: Powers, other: Powers) -> Powers:
    return {key: one.get(key, Fraction(0)) - other.get(key, Fraction(0)) for key in {**one, **other}}


def _is_prime(number: int) -> bool:
    return all(gcd(number, divisor) == 1 for divisor in range(2, int(number**0.5) + 1))
