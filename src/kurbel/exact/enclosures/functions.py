"""Logarithm, power, sine, cosine and arc of floats with bounds: by series, of which the rest is known.

The series run on the enclosures themselves, and so does their rounding. No function of the C library or of
NumPy is trusted: arcsine is checked by the sine of what they say.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from math import factorial
from typing import Any

import flint
import numpy as np

from kurbel.exact.enclosures.enclosure import SUBNORMAL, UNIT, Enclosure, Floats
from kurbel.exact.kind import Kind
from kurbel.exact.precision import at_bits
from kurbel.kernel.circle import Circle
from kurbel.kernel.kinematics import rod_sine

# π less the float is 1.2247e-16.
PI = Enclosure(np.float64(np.pi), np.float64(1.225e-16))
# Logarithms of the numbers k/128 from ½ to 1.
TABLE = 128
BALL_BITS = 128
# The series take arguments up to these; of wider ones nothing is known.
LARGEST_ARC, LARGEST_POWER, WIDEST = 0.8, 0.5, 2.0**-7
# Terms of the series, after which at most the rest is left: 0.8^19/19!, 0.8^20/20!, 2 z^9/9 for z <= 2^-8,
# and ½^17/17! twice.
SINE_TERMS, COSINE_TERMS, LOG_TERMS, POWER_TERMS = 9, 10, 4, 17
SINE_REST, COSINE_REST, LOG_REST, POWER_REST = 1.2e-19, 4.8e-21, 2.0**-74, 4.3e-20


def enclosed(value: Any) -> Enclosure:
    """Return what holds the ball that a function gives at some bits."""
    with at_bits(BALL_BITS):
        found = value()
        middle = float(found.mid())
        radius = float(abs(found - flint.arb(middle)).upper())
    return Enclosure(np.float64(middle), np.float64(radius * (1 + 8 * UNIT) + SUBNORMAL))


@cache
def _logarithms() -> Enclosure:
    balls = [enclosed((flint.arb(one) / TABLE).log) for one in range(TABLE // 2, TABLE + 1)]
    return Enclosure(np.array([one.value for one in balls]), np.array([one.error for one in balls]))


@cache
def _log_two() -> Enclosure:
    return enclosed(flint.arb(2).log)


def logarithm(number: Enclosure) -> Enclosure:
    """Return the natural logarithm: ln m + k ln 2 of m 2^k, and ln m by the nearest number of the table."""
    part, power = np.frexp(number.value)
    index = np.rint(part * TABLE)
    near = index / TABLE
    # Both are within a factor of 2: their difference is exact.
    quotient = _exact(part - near) / (_exact(part) + _exact(near))
    square = quotient * quotient
    series = _polynomial([Fraction(2, 2 * term + 1) for term in range(LOG_TERMS)], square) * quotient
    series.error = series.error + LOG_REST
    inside = np.clip(index - TABLE // 2, 0, TABLE // 2).astype(np.int64)
    found = _logarithms()[inside] + _exact(power.astype(np.float64)) * _log_two() + series
    # |ln a' - ln a| <= |a' - a|/min(a', a).
    least = number.value - number.error
    spread = number.error / np.where(least > 0, least, np.nan)
    return Enclosure(found.value, (found.error + spread) * (1 + 8 * UNIT))


def exponential(number: Enclosure) -> Enclosure:
    """Return e to a number: 2^k times that of what is left of k ln 2."""
    power = np.rint(number.value / _log_two().value)
    rest = number - _exact(power) * _log_two()
    terms = [Fraction(1, factorial(term)) for term in range(POWER_TERMS)]
    series = _polynomial(terms, rest)
    error = np.where(_is_within(rest, LARGEST_POWER), series.error + POWER_REST, np.nan)
    whole = np.clip(power, -1000, 1000).astype(np.int64)
    value, error = np.ldexp(series.value, whole), np.ldexp(error, whole) * (1 + 8 * UNIT) + SUBNORMAL
    return Enclosure(value, np.where(abs(power) <= 1000, error, np.nan))


def half_turn_circle(half_turns: Enclosure) -> Circle[Enclosure]:
    """Return sine, cosine and versine of half turns; |half turns| < 2**50."""
    quarters = np.rint(2 * half_turns.value)
    # Exact, the two being within a factor of 2 or the second 0.
    rest = Enclosure(half_turns.value - quarters / 2, half_turns.error) * PI
    across, along = _sine_cosine(rest)
    index = quarters.astype(np.int64) & 3
    odd = (index & 1) == 1
    sine_sign, cosine_sign = np.where(index >= 2, -1.0, 1.0), np.where((index == 1) | (index == 2), -1.0, 1.0)
    sine, cosine = _chosen(odd, along, across, sine_sign), _chosen(odd, across, along, cosine_sign)
    return Circle(sine, cosine, 1 - cosine)


def _chosen(first: Floats, one: Enclosure, other: Enclosure, sign: Floats) -> Enclosure:
    value = sign * np.where(first, one.value, other.value)
    return Enclosure(value, np.where(first, one.error, other.error))


def _sine_cosine(angle: Enclosure) -> tuple[Enclosure, Enclosure]:
    """Return both of an angle in radians, within an eighth of a turn or a little more."""
    square, known = angle * angle, _is_within(angle, LARGEST_ARC)
    signs = [(-1) ** term for term in range(COSINE_TERMS)]
    sine = angle * _polynomial(
        [Fraction(signs[term], factorial(2 * term + 1)) for term in range(SINE_TERMS)], square
    )
    cosine = _polynomial([Fraction(signs[term], factorial(2 * term)) for term in range(COSINE_TERMS)], square)
    sine.error = np.where(known, sine.error + SINE_REST, np.nan)
    cosine.error = np.where(known, cosine.error + COSINE_REST, np.nan)
    return sine, cosine


def arc(sine: Enclosure) -> Enclosure:
    """Return the angle in degrees, within -90..90, that has this sine."""
    near = np.arcsin(np.clip(sine.value, -1.0, 1.0))
    # Whatever it is, an arc lies no farther from it than the sines do, over the least cosine between them.
    circle = half_turn_circle(_exact(near) / PI)
    off = abs(sine - circle.sine)
    largest = np.maximum(abs(sine.value) + sine.error, abs(circle.sine.value) + circle.sine.error)
    least = (1 - _exact(largest)) * (1 + _exact(largest))
    cosine = np.where(least.value > least.error, np.sqrt(np.maximum(least.value - least.error, 0)), np.nan)
    error = (off.value + off.error) / cosine * (1 + 16 * UNIT) + SUBNORMAL
    return Enclosure(near, error) * 180 / PI


def _polynomial(coefficients: list[Fraction], number: Enclosure) -> Enclosure:
    """Return a polynomial, by its coefficients from the constant one on."""
    *others, last = map(Enclosure.of, coefficients)
    total = number * last
    for one in reversed(others[1:]):
        total = (total + one) * number
    return total + others[0]


def _is_within(number: Enclosure, most: float) -> Floats:
    return (number.error < WIDEST) & (abs(number.value) + number.error < most)


def _exact(value: Floats) -> Enclosure:
    return Enclosure(value, np.zeros_like(value))


def _circle(degrees: Any) -> Circle[Enclosure]:
    return half_turn_circle(Enclosure.of(degrees / 180) if isinstance(degrees, Fraction) else degrees / 180)


def _rod_angle(circle: Circle[Enclosure], ratio: Enclosure, offset: Enclosure | None) -> Enclosure:
    return arc(rod_sine(circle, ratio, 0 if offset is None else offset))


ENCLOSURES = Kind(Enclosure.of, _circle, arc, PI, _rod_angle, Enclosure.of, enclosed)
"""Enclosures as a kind of number on which formulas run."""
