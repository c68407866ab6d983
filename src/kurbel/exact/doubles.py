"""Sums of two floats with a bound of their error: 106 bits, for long columns of more digits than floats have.

What is proved, with u = 2**-53 and |low| <= u |high| of every number: the sum of two floats is `_sum` exactly
(Knuth), their product `_product` (Dekker). An addition then rounds twice what is below u of its terms, and a
multiplication leaves out the product of the lows and rounds four times what is below 3u of its result. A
quotient and a root are a float and one step of Newton's, whose rest is computed with its own bound. As in
enclosure.py, GROWTH covers the rounding of the bounds and SUBNORMAL what underflows.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from math import factorial
from typing import Any

import flint
import numpy as np
from flint import arb

from kurbel.exact.bulk import Integers
from kurbel.exact.certify import at_bits
from kurbel.exact.enclosure import GROWTH, SUBNORMAL, UNIT, Floats
from kurbel.exact.kind import Kind, unordered
from kurbel.kernel.circle import Circle

ADDED, MULTIPLIED = 4 * UNIT**2, 9 * UNIT**2


class Double:
    """The true number of each sum high + low lies within `error` of it; infinite or NaN, anywhere."""

    __slots__ = ("error", "high", "low")
    # Numbers of NumPy leave their operators to this class.
    __array_ufunc__ = None

    def __init__(self, high: Floats, low: Floats, error: Floats) -> None:
        self.high, self.low, self.error = high, low, error

    @staticmethod
    def of(number: Double | Fraction | float) -> Double:
        """Return what encloses an exact number: a float, an integer or a fraction."""
        if isinstance(number, Double):
            return number
        high = float(number)
        rest = Fraction(number) - Fraction(high)
        low = float(rest)
        error = 0.0 if low == rest else abs(low) * UNIT + SUBNORMAL
        return Double(np.float64(high), np.float64(low), np.float64(error))

    def __neg__(self) -> Double:
        return Double(-self.high, -self.low, self.error)

    def __add__(self, other: Double | Fraction | float) -> Double:
        one = Double.of(other)
        total, rest = _sum(self.high, one.high)
        rounded = ADDED * (abs(self.high) + abs(one.high))
        return _normal(total, rest + (self.low + one.low), rounded + self.error + one.error)

    __radd__ = __add__

    def __sub__(self, other: Double | Fraction | float) -> Double:
        return self + -Double.of(other)

    def __rsub__(self, other: Double | Fraction | float) -> Double:
        return Double.of(other) + -self

    def __mul__(self, other: Double | Fraction | float) -> Double:
        one = Double.of(other)
        product, rest = _product(self.high, one.high)
        low = rest + (self.high * one.low + self.low * one.high)
        error = abs(self.high) * one.error + abs(one.high) * self.error + self.error * one.error
        return _normal(product, low, MULTIPLIED * abs(product) + error)

    __rmul__ = __mul__

    def __truediv__(self, other: Double | Fraction | float) -> Double:
        one = Double.of(other)
        near = self.high / one.high
        rest = self - one * exact(near)
        step = rest.high / one.high
        off = UNIT * abs(one.high) + one.error
        left = abs(rest.low) + rest.error + abs(step) * off
        # A divisor that may be 0 leaves nothing known.
        least = np.maximum(abs(one.high) - off, 0)
        return _normal(*_sum(near, step), left / least + 2 * UNIT * abs(step))

    def __rtruediv__(self, other: Double | Fraction | float) -> Double:
        return Double.of(other) / self

    def __pow__(self, power: Fraction | float) -> Double:
        if power == 0.5:
            return self._root()
        if power != int(power) or power < 1:
            raise ValueError(f"the power {power} of a sum of two floats")
        found = self
        for _ in range(int(power) - 1):
            found = found * self
        return found

    def _root(self) -> Double:
        near = np.sqrt(self.high)
        rest = self - exact(near) * exact(near)
        step = rest.high / (2 * near)
        # √a - r = (a - r²)/(√a + r), and √a + r is above r.
        left = abs(rest.low) + rest.error
        bend = abs(rest.high) * (abs(rest.high) + left) / (2 * near * near * near)
        return _normal(*_sum(near, step), left / near + bend + 2 * UNIT * abs(step))


def exact(floats: Floats) -> Double:
    """Return floats that are the true numbers themselves."""
    return Double(floats, np.float64(0), np.float64(0))


def chosen(condition: Any, one: Double, other: Double) -> Double:
    """Return one number or the other, element by element."""
    pairs = ((one.high, other.high), (one.low, other.low), (one.error, other.error))
    return Double(*(np.where(condition, *pair) for pair in pairs))


def _normal(high: Floats, low: Floats, error: Floats) -> Double:
    total, rest = _sum(high, low)
    return Double(total, rest, error * GROWTH + SUBNORMAL)


def _sum(one: Floats, other: Floats) -> tuple[Floats, Floats]:
    total = one + other
    part = total - one
    return total, (one - (total - part)) + (other - part)


def _product(one: Floats, other: Floats) -> tuple[Floats, Floats]:
    product = one * other
    (one_high, one_low), (other_high, other_low) = _halves(one), _halves(other)
    rest = (one_high * other_high - product) + one_high * other_low + one_low * other_high
    return product, rest + one_low * other_low


def _halves(number: Floats) -> tuple[Floats, Floats]:
    raised = 134217729.0 * number
    high = raised - (raised - number)
    return high, number - high


# Within ±45° the next terms of both series, b^29/29! and b^30/30!, are below this.
TERMS, REST = 14, 1.1e-34
BALL_BITS = 256
# Integers of 64 bits hold them, with room for what is added.
GREATEST = 2.0**61
# Whole numbers up to here are floats.
WHOLE = 2**53


def numbers() -> Kind:
    """Return sums of two floats as a kind of number: without arcs."""
    return unordered(Double.of, pi=_enclosed(flint.arb.pi), exponent=Fraction, enclosed=_enclosed)


def _enclosed(value: Callable[[], arb]) -> Double:
    with at_bits(BALL_BITS):
        found = value()
        high = float(found.mid())
        low = float((found - high).mid())
        error = float(abs(found - high - low).upper()) * (1 + 8 * UNIT)
    return Double(np.float64(high), np.float64(low), np.float64(error))


@cache
def _radian() -> Double:
    return _enclosed(lambda: flint.arb.pi() / 180)


def circle(numerators: Integers, denominator: int) -> Circle[Double]:
    """Return sine, cosine and versine of angles in degrees, fractions of one denominator.

    For denominators below 2**46.
    """
    quarter = 90 * denominator
    quarters = (numerators + quarter // 2) // quarter
    rest = exact((numerators - quarters * quarter).astype(np.float64))
    angle = rest / denominator * _radian()
    sine, versine = _series(angle)
    cosine, turn = 1 - versine, quarters & 3
    odd, back = turn & 1 == 1, turn >= 2
    across, along = chosen(odd, cosine, sine), chosen(odd, -sine, cosine)
    straight, bent = chosen(back, 2 - versine, versine), chosen(back, 1 - sine, 1 + sine)
    return Circle(chosen(back, -across, across), chosen(back, -along, along), chosen(odd, bent, straight))


def _series(angle: Double) -> tuple[Double, Double]:
    """Return sine and versine of angles within ±45°."""
    square = angle * angle
    sine, versine = Double.of(0), Double.of(0)
    for term in range(TERMS, -1, -1):
        sign = (-1) ** term
        sine = sine * square + Fraction(sign, factorial(2 * term + 1))
        versine = versine * square + Fraction(sign, factorial(2 * term + 2))
    for series in (sine, versine):
        series.error = series.error + REST
    return angle * sine, square * versine


def settled(found: Any, size: int, places: int, exactly: Callable[[int], int]) -> Integers:
    """Return a column of so many cells times 10**places, rounded; `exactly` settles a doubtful one."""
    with np.errstate(all="ignore"):
        scaled = Double.of(found) * 10**places
        parts = scaled.high, scaled.low, scaled.error
        scaled = Double(*(np.broadcast_to(part, (size,)) for part in parts))
        known = np.isfinite(scaled.error) & (abs(scaled.high) < GREATEST)
        high, low = np.where(known, scaled.high, 0), np.where(known, scaled.low, 0)
        whole = np.rint(high)
        rest = (high - whole) + low
        near = np.rint(rest)
        distance = 0.5 - abs(rest - near)
        doubtful = ~(known & (distance > scaled.error + 4 * UNIT * (1 + abs(rest))))
    digits: Integers = whole.astype(np.int64) + near.astype(np.int64)
    for row in doubtful.nonzero()[0].tolist():
        digits[row] = exactly(row)
    return digits
