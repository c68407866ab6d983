"""The number of long columns: floats, each with a bound of its error that goes through every formula with it.

What is proved: IEEE 754 floats, rounded to nearest, lie at most 2**-53 of themselves from the true result of
+ - * / and the square root, or 2**-1075 where they are subnormal. An operation's bound is what the errors of
its operands make of the result at most, plus that rounding. Bounds are themselves rounded: no negative
numbers and at most eight roundings, which GROWTH is more than; SUBNORMAL is more than all that underflows.
Nothing is asked of a library but those five operations, so that the bound is that of every machine.

Logarithm, power, sine, cosine and arc are by series, of which the rest is known. These run on the enclosures
themselves, and so does their rounding. No function of the C library or of NumPy is trusted: arcsine is
checked by the sine of what they say.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from math import factorial
from typing import Any, TypeAlias

import flint
import numpy as np

from kurbel.exact.bulk import Integers, nearest
from kurbel.exact.certify import at_bits
from kurbel.exact.kind import unordered
from kurbel.kernel.circle import Circle
from kurbel.kernel.kinematics import rod_sine

# A float64 array of any shape, or one float.
Floats: TypeAlias = Any
Known: TypeAlias = "Enclosure | Fraction | float"

UNIT = 2.0**-53
GROWTH = 1 + 2.0**-48
SUBNORMAL = 2.0**-1000
# Whole numbers up to here are floats.
WHOLE = 2**53


class Enclosure:
    """The true number of each float of `value` lies within `error` of it; infinite or NaN, anywhere."""

    __slots__ = ("error", "value")
    # Numbers of NumPy leave their operators to this class.
    __array_ufunc__ = None

    def __init__(self, value: Floats, error: Floats) -> None:
        self.value, self.error = value, error

    @staticmethod
    def of(number: Known) -> Enclosure:
        """Return what encloses an exact number: a float, an integer or a fraction."""
        if isinstance(number, Enclosure):
            return number
        value = float(number)
        exact = isinstance(number, float) or Fraction(value) == number
        return Enclosure(np.float64(value), np.float64(0 if exact else abs(value) * UNIT + SUBNORMAL))

    def __add__(self, other: Known) -> Enclosure:
        if _is_exact(other):
            return self if other == 0 else _rounded(self.value + other, self.error)
        added = Enclosure.of(other)
        return _rounded(self.value + added.value, self.error + added.error)

    __radd__ = __add__

    def __neg__(self) -> Enclosure:
        return Enclosure(-self.value, self.error)

    def __sub__(self, other: Known) -> Enclosure:
        less = Enclosure.of(other).__neg__()
        return self + less

    def __rsub__(self, other: Known) -> Enclosure:
        return Enclosure.of(other) - self

    def __mul__(self, other: Known) -> Enclosure:
        if _is_exact(other):
            return self if other == 1 else _rounded(self.value * other, self.error * abs(other))
        by = Enclosure.of(other)
        # |a'b' - ab| <= |a'| |b' - b| + |b| |a' - a|.
        spread = (abs(self.value) + self.error) * by.error + abs(by.value) * self.error
        return _rounded(self.value * by.value, spread)

    __rmul__ = __mul__

    def __truediv__(self, other: Known) -> Enclosure:
        if _is_exact(other) and other:
            return _rounded(self.value / other, self.error / abs(other))
        below = Enclosure.of(other)
        quotient, least = self.value / below.value, abs(below.value) - below.error
        # |a'/b' - q| = |(a' - a) - q (b' - b)|/|b'|, and b' is not nearer to 0 than this.
        spread = (self.error + abs(quotient) * below.error) / np.where(least > 0, least, np.nan)
        return _rounded(quotient, spread)

    def __rtruediv__(self, other: Known) -> Enclosure:
        return Enclosure.of(other) / self

    def __pow__(self, exponent: Known) -> Enclosure:
        """Return the square root for 0.5, products for small whole exponents, else by the logarithm."""
        if isinstance(exponent, float) and exponent == 0.5:
            return self.root()
        if isinstance(exponent, int) and 1 <= exponent <= 4:
            return self if exponent == 1 else self * self ** (exponent - 1)

        return exponential(self.log() * exponent)

    def root(self) -> Enclosure:
        """Return the square root; a number that may be 0 or less is one that is 0 at least."""
        root = np.sqrt(np.maximum(self.value, 0.0))
        # |√a' - √a| = |a' - a|/(√a' + √a), at most the quotient by √a and at most √|a' - a|.
        spread = np.fmin(self.error / root, np.sqrt(self.error))
        return _rounded(root, np.where(self.value + self.error < 0, np.nan, spread))

    def log(self) -> Enclosure:
        """Return the natural logarithm."""
        return logarithm(self)

    def __abs__(self) -> Enclosure:
        return Enclosure(abs(self.value), self.error)

    def max(self, other: Known) -> Enclosure:
        """Return the larger of two numbers; at a corner, where floats cannot tell which, it is as near."""
        than = Enclosure.of(other)
        return Enclosure(np.maximum(self.value, than.value), np.maximum(self.error, than.error))

    def union(self, other: Known) -> Enclosure:
        """Return what holds either number."""
        with_it = Enclosure.of(other)
        apart = abs(self.value - with_it.value)
        return _rounded(self.value, apart + np.maximum(self.error, with_it.error))

    def piecewise(self, corners: Sequence[Known], pieces: Sequence[Known]) -> Enclosure:
        """Return of each number the one of its piece, which the corner behind it still belongs to; so near to
        a corner that it may lie on either side, what holds both."""
        found = Enclosure.of(pieces[-1])
        for corner, piece in zip(reversed(corners), reversed(pieces[:-1]), strict=True):
            beyond, own, at = found, Enclosure.of(piece), self - corner
            both, before = own.union(beyond), at.value <= 0
            near = ~(abs(at.value) > at.error)
            value = np.where(near, both.value, np.where(before, own.value, beyond.value))
            error = np.where(near, both.error, np.where(before, own.error, beyond.error))
            found = Enclosure(value, error)
        return found

    def __eq__(self, other: object) -> bool:
        """Whether it is one number, and for certain this one."""
        return _is_exact(other) and np.ndim(self.value) == 0 and self.error == 0 and self.value == other

    def __lt__(self, other: Known) -> bool:
        """Whether it is less for certain, all of it."""
        than = Enclosure.of(other)
        return bool((self.value + self.error < than.value - than.error).all())

    def __gt__(self, other: Known) -> bool:
        return Enclosure.of(other) < self

    __hash__ = None  # type: ignore[assignment]

    def __getitem__(self, index: Any) -> Enclosure:
        return Enclosure(self.value[index], self.error[index])


def _rounded(value: Floats, spread: Floats) -> Enclosure:
    """Return a result that rounding has changed, of operands whose errors spread it so far."""
    error = abs(value)
    error = error * UNIT
    error += spread
    error *= GROWTH
    error += SUBNORMAL
    return Enclosure(value, error)


def _is_exact(number: object) -> bool:
    return isinstance(number, float) or (isinstance(number, int) and abs(number) < WHOLE)


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


def _rod_angle(circle: Circle[Any], ratio: Any, offset: Any) -> Enclosure:
    sine: Any = rod_sine(circle, ratio, 0 if offset is None else offset)
    return arc(sine)


ENCLOSURES = unordered(Enclosure.of, _circle, arc, PI, _rod_angle, Enclosure.of, enclosed)
"""Enclosures as a kind of number on which formulas run."""


# Up to this share of doubtful cells floats are worth their while.
DOUBTFUL_SHARE = 0.1
# Integers of 64 bits hold a million times as much, should a number be so much greater between two probes.
GREATEST = 2.0**43


def column(value: Callable[[], Any], size: int) -> Enclosure | None:
    """Return a column of so many cells, None where its formula is NotImplemented.

    What is not known of a cell makes its error infinite or no number there.
    """
    # What is divided by nothing or compared with it is read by nobody.
    with np.errstate(all="ignore"):
        made = value()
        if made is NotImplemented:
            return None
        found = Enclosure.of(made)
    return Enclosure(*(np.broadcast_to(part, (size,)) for part in (found.value, found.error)))


def is_worth(probe: Enclosure, places: int) -> bool:
    """Whether cells that are alike would be settled in floats, nearly all of them."""
    unit = 10.0**places
    known = np.isfinite(probe.error) & np.isfinite(probe.value)
    share = 2 * unit * probe.error[known]
    greatest = abs(probe.value[known]).max(initial=0) * unit
    return bool(known.any() and share.max() < DOUBTFUL_SHARE and greatest < GREATEST)


def settled(found: Enclosure, places: int, rounding: str, exactly: Callable[[int], int]) -> Integers:
    """Return the column times 10**places, rounded; `exactly` settles a doubtful cell by its row."""
    with np.errstate(all="ignore"):
        scaled, doubtful = nearest(found.value, places, found.error, half_even=rounding == "half-even")
    for row in doubtful.nonzero()[0].tolist():
        scaled[row] = exactly(row)
    return scaled
