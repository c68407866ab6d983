"""Columns in sums of two floats: the circle of many exact angles, the kind of number, and their digits."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from math import factorial
from typing import Any

import flint
import numpy as np

from kurbel.exact.bulk import Integers
from kurbel.exact.enclosures.double import Double, chosen, exact
from kurbel.exact.enclosures.enclosure import UNIT
from kurbel.exact.kind import Kind
from kurbel.exact.precision import at_bits
from kurbel.kernel.circle import Circle

# Within ±45° the next terms of both series, b^29/29! and b^30/30!, are below this.
TERMS, REST = 14, 1.1e-34
BALL_BITS = 256
# Integers of 64 bits hold them, with room for what is added.
GREATEST = 2.0**61
# Whole numbers up to here are floats.
WHOLE = 2**53


def numbers() -> Kind:
    """Return sums of two floats as a kind of number: without arcs."""
    return Kind(Double.of, pi=_enclosed(flint.arb.pi), exponent=Fraction, enclosed=_enclosed)


def _enclosed(value: Callable[[], Any]) -> Double:
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
