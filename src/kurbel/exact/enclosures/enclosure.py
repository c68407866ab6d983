"""The number of long columns: floats, each with a bound of its error that goes through every formula with it.

What is proved: IEEE 754 floats, rounded to nearest, lie at most 2**-53 of themselves from the true result of
+ - * / and the square root, or 2**-1075 where they are subnormal. An operation's bound is what the errors of
its operands make of the result at most, plus that rounding. Bounds are themselves rounded: no negative
numbers and at most eight roundings, which GROWTH is more than; SUBNORMAL is more than all that underflows.
Nothing is asked of a library but those five operations, so that the bound is that of every machine.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, TypeAlias

import numpy as np

# A float64 array of any shape, or one float.
Floats: TypeAlias = Any

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
    def of(number: Any) -> Enclosure:
        """Return what encloses an exact number: a float, an integer or a fraction."""
        if isinstance(number, Enclosure):
            return number
        value = float(number)
        exact = isinstance(number, float) or Fraction(value) == number
        return Enclosure(np.float64(value), np.float64(0 if exact else abs(value) * UNIT + SUBNORMAL))

    def __add__(self, other: Any) -> Enclosure:
        if _is_exact(other):
            return self if other == 0 else _rounded(self.value + other, self.error)
        added = Enclosure.of(other)
        return _rounded(self.value + added.value, self.error + added.error)

    __radd__ = __add__

    def __neg__(self) -> Enclosure:
        return Enclosure(-self.value, self.error)

    def __sub__(self, other: Any) -> Enclosure:
        less = Enclosure.of(other).__neg__()
        return self + less

    def __rsub__(self, other: Any) -> Enclosure:
        return Enclosure.of(other) - self

    def __mul__(self, other: Any) -> Enclosure:
        if _is_exact(other):
            return self if other == 1 else _rounded(self.value * other, self.error * abs(other))
        by = Enclosure.of(other)
        # |a'b' - ab| <= |a'| |b' - b| + |b| |a' - a|.
        spread = (abs(self.value) + self.error) * by.error + abs(by.value) * self.error
        return _rounded(self.value * by.value, spread)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Enclosure:
        if _is_exact(other) and other:
            return _rounded(self.value / other, self.error / abs(other))
        below = Enclosure.of(other)
        quotient, least = self.value / below.value, abs(below.value) - below.error
        # |a'/b' - q| = |(a' - a) - q (b' - b)|/|b'|, and b' is not nearer to 0 than this.
        spread = (self.error + abs(quotient) * below.error) / np.where(least > 0, least, np.nan)
        return _rounded(quotient, spread)

    def __rtruediv__(self, other: Any) -> Enclosure:
        return Enclosure.of(other) / self

    def __pow__(self, exponent: Any) -> Enclosure:
        """Return the square root for 0.5, products for small whole exponents, else by the logarithm."""
        if isinstance(exponent, float) and exponent == 0.5:
            return self.root()
        if isinstance(exponent, int) and 1 <= exponent <= 4:
            return self if exponent == 1 else self * self ** (exponent - 1)
        from kurbel.exact.enclosures.functions import exponential

        return exponential(self.log() * exponent)

    def root(self) -> Enclosure:
        """Return the square root; a number that may be 0 or less is one that is 0 at least."""
        root = np.sqrt(np.maximum(self.value, 0.0))
        # |√a' - √a| = |a' - a|/(√a' + √a), at most the quotient by √a and at most √|a' - a|.
        spread = np.fmin(self.error / root, np.sqrt(self.error))
        return _rounded(root, np.where(self.value + self.error < 0, np.nan, spread))

    def log(self) -> Enclosure:
        """Return the natural logarithm."""
        from kurbel.exact.enclosures.functions import logarithm

        return logarithm(self)

    def __abs__(self) -> Enclosure:
        return Enclosure(abs(self.value), self.error)

    def max(self, other: Any) -> Enclosure:
        """Return the larger of two numbers; at a corner, where floats cannot tell which, it is as near."""
        than = Enclosure.of(other)
        return Enclosure(np.maximum(self.value, than.value), np.maximum(self.error, than.error))

    def union(self, other: Any) -> Enclosure:
        """Return what holds either number."""
        with_it = Enclosure.of(other)
        apart = abs(self.value - with_it.value)
        return _rounded(self.value, apart + np.maximum(self.error, with_it.error))

    def piecewise(self, corners: Any, pieces: Any) -> Enclosure:
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

    def __lt__(self, other: Any) -> bool:
        """Whether it is less for certain, all of it."""
        than = Enclosure.of(other)
        return bool((self.value + self.error < than.value - than.error).all())

    def __gt__(self, other: Any) -> bool:
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


def _is_exact(number: Any) -> bool:
    return isinstance(number, float) or (isinstance(number, int) and abs(number) < WHOLE)
