"""Truncated Taylor series: a value with its slopes, so that nothing is differentiated by hand.

The coefficients are numbers, or series in another variable.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import reduce
from math import factorial
from operator import add
from typing import Any

from kurbel.verify.numbers import Number, degrees_of, hull, number, pi, sine_cosine

# A number or a series of numbers.
Coefficient = Any


class Jet:
    """c₀ + c₁ h + c₂ h² + ..., as far as it goes."""

    __slots__ = ("terms",)

    def __init__(self, terms: Sequence[Coefficient]) -> None:
        self.terms = tuple(terms)

    @property
    def value(self) -> Coefficient:
        return self.terms[0]

    def slope(self, order: int = 1) -> Coefficient:
        """The derivative of this order: k! times the coefficient."""
        return self.terms[order] * factorial(order)

    def derived(self, times: int = 1) -> Jet:
        terms = self.terms
        for _ in range(times):
            terms = tuple(k * one for k, one in enumerate(terms))[1:]
        return Jet(terms)

    @property
    def is_zero(self) -> bool:
        return all(one.is_zero for one in self.terms)

    def __float__(self) -> float:
        return float(self.value)

    def at(self, h: Number | Jet) -> Coefficient:
        total = self.terms[-1]
        for one in reversed(self.terms[:-1]):
            total = total * h + one
        return total

    def _like(self, other: Jet | Number | Fraction | int) -> Jet:
        """A number as a series that does not change, or a series in φ as one in λ."""
        if isinstance(other, Jet) and _depth(other) == _depth(self):
            return other
        zero = self.terms[0] * 0
        return Jet([zero + other, *(zero for _ in self.terms[1:])])

    def __add__(self, other: Jet | Number | Fraction | int) -> Jet:
        if isinstance(other, Jet) and _depth(other) > _depth(self):
            return other._like(self) + other
        return Jet([a + b for a, b in zip(self.terms, self._like(other).terms, strict=False)])

    __radd__ = __add__

    def __neg__(self) -> Jet:
        return Jet([-one for one in self.terms])

    def __sub__(self, other: Jet | Number | Fraction | int) -> Jet:
        return self + -other

    def __rsub__(self, other: Jet | Number | Fraction | int) -> Jet:
        return -self + other

    def __mul__(self, other: Jet | Number | Fraction | int) -> Jet:
        if not isinstance(other, Jet) or _depth(other) < _depth(self):
            return Jet([one * other for one in self.terms])
        if _depth(other) > _depth(self):
            return other * self
        a, b = self.terms, other.terms
        return Jet([reduce(add, (a[i] * b[k - i] for i in range(k + 1))) for k in range(min(len(a), len(b)))])

    __rmul__ = __mul__

    def __truediv__(self, other: Jet | Number | Fraction | int) -> Jet:
        if not isinstance(other, Jet) or _depth(other) < _depth(self):
            return Jet([one / other for one in self.terms])
        found: list[Coefficient] = []
        for k in range(min(len(self.terms), len(other.terms))):
            taken = (-found[i] * other.terms[k - i] for i in range(k))
            found.append(reduce(add, taken, self.terms[k]) / other.terms[0])
        return Jet(found)

    def __rtruediv__(self, other: Jet | Number | Fraction | int) -> Jet:
        return self._like(other) / self

    def power(self, exponent: Fraction) -> Jet:
        """r = f^a, of which f r' = a f' r: k f₀ r_k is the sum of the (a i - (k - i)) f_i r_(k - i)."""
        f, found = self.terms, [self.terms[0].power(exponent)]
        for k in range(1, len(f)):
            parts = (f[i] * found[k - i] * ((exponent + 1) * i - k) for i in range(1, k + 1))
            found.append(reduce(add, parts) / (f[0] * k))
        return Jet(found)

    def root(self) -> Jet:
        return self.power(Fraction(1, 2))


def _depth(one: object) -> int:
    return 1 + _depth(one.terms[0]) if isinstance(one, Jet) else 0


def turning(degrees: Fraction, order: int, reach: Fraction = Fraction(0)) -> tuple[Jet, Jet]:
    """Return cosine and sine of an angle with their slopes by it in radians: each is the other's."""
    return turned_by(*sine_cosine(degrees, reach), order)


def turned_by(sine: Number, cosine: Number, order: int) -> tuple[Jet, Jet]:
    """The same of an angle whose sine and cosine are known."""
    around = [cosine, -sine, -cosine, sine]
    return (
        Jet([around[k % 4] / factorial(k) for k in range(order + 1)]),
        Jet([around[(k - 1) % 4] / factorial(k) for k in range(order + 1)]),
    )


def slope_of_angle(x: Jet, y: Jet) -> Jet:
    """The slope of the angle of (x, y), in radians: (x y' - y x')/(x² + y²)."""
    return (x * y.derived() - y * x.derived()) / (x * x + y * y)


def direction(x: Jet, y: Jet) -> Jet:
    """The angle of (x, y) in degrees."""
    angle = degrees_of(x.value, y.value)
    return angle_of(angle, slope_of_angle(x, y) * (180 / pi()) if len(x.terms) > 1 else Jet([]))


def angle_of(value: Number, slope: Jet) -> Jet:
    """What has this value and this slope."""
    return Jet([value, *(one / k for k, one in enumerate(slope.terms, 1))])


def slope_of(found: Jet | Number, order: int) -> Number:
    """The slope of this order, 0 the value, of what may have none for it does not change."""
    if isinstance(found, Jet):
        return found.slope(order)
    return number(0) if order else found


def hulled(jets: Sequence[Jet]) -> Jet:
    """All that they may be, coefficient by coefficient."""
    return (
        jets[0]
        if len(jets) == 1
        else Jet([hull(each) for each in zip(*(one.terms for one in jets), strict=True)])
    )
