"""The textbook formulas of the crank drive on arrays of 106 bits: sums of two floats (Dekker, Knuth).

`tests/kernel/test_double_double.py` holds them against balls.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import factorial
from typing import Any, NamedTuple

import numpy as np
from mpmath import mp
from numpy.typing import NDArray

Floats = NDArray[np.float64]


class Double(NamedTuple):
    """The unrounded sum of two floats or arrays, the second below the last place of the first."""

    high: Any
    low: Any

    @classmethod
    def exact(cls, high: Any) -> Double:
        return cls(high, high * 0)

    def __add__(self, other: Any) -> Double:
        total, rest = _sum(self.high, other.high)
        return _normal(total, rest + (self.low + other.low))

    def __neg__(self) -> Double:
        return Double(-self.high, -self.low)

    def __sub__(self, other: Double) -> Double:
        return self + (-other)

    def __mul__(self, other: Any) -> Double:
        product, rest = _product(self.high, other.high)
        return _normal(product, rest + (self.high * other.low + self.low * other.high))

    def __truediv__(self, other: Double) -> Double:
        quotient = Double.exact(self.high / other.high)
        return quotient + Double.exact((self - quotient * other).high / other.high)

    def root(self) -> Double:
        near = Double.exact(np.sqrt(self.high))
        return near + Double.exact((self - near * near).high / (2 * near.high))

    def times(self, factor: Any) -> Double:
        """Return the product with a power of two, or a sign."""
        return Double(self.high * factor, self.low * factor)


def _sum(one: Any, other: Any) -> tuple[Any, Any]:
    total = one + other
    part = total - one
    return total, (one - (total - part)) + (other - part)


def _product(one: Any, other: Any) -> tuple[Any, Any]:
    product = one * other
    (one_high, one_low), (other_high, other_low) = _halves(one), _halves(other)
    rest = (one_high * other_high - product) + one_high * other_low + one_low * other_high
    return product, rest + one_low * other_low


def _halves(number: Any) -> tuple[Any, Any]:
    raised = 134217729.0 * number
    high = raised - (raised - number)
    return high, number - high


def _normal(high: Any, low: Any) -> Double:
    total = high + low
    return Double(total, low - (total - high))


def constant(number: Fraction) -> Double:
    high = float(number)
    return Double(high, float(number - Fraction(high)))


def _radian() -> Double:
    with mp.workprec(200):
        radian = mp.pi / 180
        high = float(radian)
        return Double(high, float(radian - high))


RADIAN, ONE = _radian(), Double(1.0, 0.0)
TERMS = 28


def sine_and_cosine(degrees: Floats) -> tuple[Double, Double]:
    """Return them by their series within ±45° of a quarter turn, from which the angle is exact."""
    quarters = np.rint(degrees / 90)
    angle = Double.exact(degrees - 90 * quarters) * RADIAN
    sine, cosine = angle * _series(angle * angle, 1), _series(angle * angle, 0)
    odd, back = quarters % 2 == 1, quarters % 4 >= 2
    turned = np.where(back, -1.0, 1.0)
    across = Double(*(np.where(odd, *either) for either in zip(cosine, sine, strict=True)))
    along = Double(*(np.where(odd, *either) for either in zip(-sine, cosine, strict=True)))
    return across.times(turned), along.times(turned)


def _series(square: Double, first: int) -> Double:
    powers = range(first, TERMS, 2)
    total = Double(0.0, 0.0)
    for count, power in reversed(list(enumerate(powers))):
        total = total * square + constant(Fraction((-1) ** count, factorial(power)))
    return total


def motion(degrees: Floats, ratio: Floats) -> Mapping[str, Double]:
    """Return x, c, p and the forces of the drive by the formulas of the books, of a ratio or its negative."""
    sine, cosine = sine_and_cosine(degrees)
    half, _ = sine_and_cosine(degrees / 2)
    slope = Double.exact(ratio)
    slant = slope * sine
    w = (ONE - slant * slant).root()
    bend = cosine * cosine - sine * sine + slant * slant * (sine * sine)
    return {
        "x": (half * half).times(2) + slant * sine / (ONE + w),
        "c": sine + slant * cosine / w,
        "p": cosine + slope * bend / (w * w * w),
        "psi": arcsine(slant, w),
        "rod_force": ONE / w,
        "guide_force": slant / w,
        "radial_force": cosine - sine * slant / w,
    }


def arcsine(sine: Double, cosine: Double) -> Double:
    """Return the angle in degrees: the library's, and from its own sine what is left, sin(a - b)."""
    near = np.degrees(np.arcsin(sine.high))
    near_sine, near_cosine = sine_and_cosine(near)
    left = sine * near_cosine - cosine * near_sine
    # The next term of the arc is below 2**-150.
    return Double.exact(near) + left / RADIAN


def ulps(values: Floats, true: Double, least: float = 0.0) -> Floats:
    """Return how many units in the last place of the true value, or of so much at the least, lie between."""
    unit = np.spacing(np.maximum(np.abs(true.high), least))
    found: Floats = np.abs((values - true.high) - true.low) / unit
    return found
