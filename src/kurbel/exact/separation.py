"""How near an algebraic number can come to zero without being zero, and how large an exact one would be.

A kernel formula that is run on `Separation` numbers returns, instead of a value, a lower bound of the
value's magnitude in case it is not zero. With it an exact tie (0.575 to two decimals) is recognised as
one: a ball that contains the tie and is narrower than the bound can contain nothing else.

Rules: Burnikel, Funke, Mehlhorn, Schirra and Schmitt, A separation bound for real algebraic expressions,
Algorithmica 55 (2009), section 3 (BFMSS without roots of higher degree).

Exact numbers double their figures with every product, so that a line of powers asks for more than there is
memory for. All other numbers, such as floats and balls, keep their size, and pass as they are.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import lcm, log2, prod
from typing import Any, TypeAlias

from kurbel.errors import NotationError
from kurbel.exact.numerals import MOST_FIGURES
from kurbel.kernel.circle import Circle, Numeric


# Not frozen, which would be half the time of a product.
@dataclass(slots=True, eq=False)
class Separation:
    """A quotient U/L of algebraic integers whose conjugates are at most 2**upper and 2**lower.

    `roots` names the roots that occur, each with its degree; the field below them is the cyclotomic one of
    this order.
    """

    upper: float
    lower: float
    order: int = 1
    roots: frozenset[tuple[object, int]] = frozenset()

    @classmethod
    def rational(cls, value: Fraction | int) -> Separation:
        exact = Fraction(value)
        return cls(log2(max(abs(exact.numerator), 1)), log2(exact.denominator))

    def bits(self) -> float:
        """Return b such that the number is zero or at least 2**-b in magnitude."""
        degree = _totient(self.order) * prod(order for _, order in self.roots)
        # One bit more covers the rounding of the logarithms.
        return (degree - 1) * self.upper + self.lower + 1

    def __add__(self, other: Separation | int) -> Separation:
        other = _separation(other)
        upper = max(self.upper + other.lower, other.upper + self.lower) + 1
        return self._with(other, upper, self.lower + other.lower)

    __radd__ = __sub__ = __rsub__ = __add__

    def __mul__(self, other: Separation | int) -> Separation:
        other = _separation(other)
        return self._with(other, self.upper + other.upper, self.lower + other.lower)

    __rmul__ = __mul__

    def __truediv__(self, other: Separation | int) -> Separation:
        other = _separation(other)
        return self._with(other, self.upper + other.lower, self.lower + other.upper)

    def __rtruediv__(self, other: int) -> Separation:
        return _separation(other) / self

    def __neg__(self) -> Separation:
        return self

    def __abs__(self) -> Separation:
        # It is the number or its negative.
        return self

    def __pow__(self, exponent: float | Fraction) -> Separation:
        power = Fraction(exponent)
        if power < 0:
            return (1 / self) ** -power
        if power.denominator > 1:
            return self._root(power.denominator) ** power.numerator
        return Separation(self.upper * power, self.lower * power, self.order, self.roots)

    def _root(self, order: int) -> Separation:
        # The root of U/L is that of U L^(k-1), over L.
        upper = (self.upper + (order - 1) * self.lower) / order
        return Separation(upper, self.lower, self.order, self.roots | {(object(), order)})

    def union(self, other: Separation | int) -> Separation:
        """Return what bounds either number, whichever it is."""
        other = _separation(other)
        return self._with(other, max(self.upper, other.upper), max(self.lower, other.lower))

    max = union

    def _with(self, other: Separation, upper: float, lower: float) -> Separation:
        order = self.order if other.order in (1, self.order) else lcm(self.order, other.order)
        return Separation(upper, lower, order, self.roots | other.roots if other.roots else self.roots)


def circle_separation(degrees: Fraction) -> Circle[Separation]:
    """Return the bounds of sine, cosine and versine of a rational number of degrees.

    2 sin φ and 2 cos φ are algebraic integers with conjugates up to 2, in the cyclotomic field of order
    lcm(n, 4), where n is the denominator of φ/360°.
    """
    denominator = (degrees / 360).denominator
    order = lcm(4, denominator)
    half = Separation(1, 1, order)
    return Circle(half, half, Separation(2, 1, order))


def _separation(value: Separation | int) -> Separation:
    return value if isinstance(value, Separation) else _of_number(value)


_of_number = lru_cache(maxsize=64)(Separation.rational)


def _totient(order: int) -> int:
    """Return how many numbers below the order share no factor with it, or more if large primes divide it."""
    # Degrees as typed have small primes only; to factor any 30 digits takes years, and more is safe.
    result, rest, prime = order, order, 2
    while prime * prime <= rest and prime < 1000:
        if rest % prime == 0:
            result -= result // prime
            while rest % prime == 0:
                rest //= prime
        prime += 1
    return result - result // rest if rest > 1 else result


# Numerator and denominator together. A power of so many takes a thousandth of a second.
MOST_BITS = log2(10) * MOST_FIGURES
# Of the logarithms of two such numbers.
_DOUBT = 1e-9

Operation: TypeAlias = Callable[[Any, Any], Any]


class TooLargeError(NotationError):
    """An exact number that is not computed, for its size."""

    def __init__(self) -> None:
        super().__init__(
            f"a number of more than {MOST_FIGURES} figures would come out, which is not computed;"
            " write it with smaller numbers and powers"
        )


def _bounded(operation: Operation) -> Operation:
    def apply(first: Any, second: Any) -> Any:
        if isinstance(first, Fraction) and isinstance(second, Fraction):
            size = operation(Separation.rational(first), Separation.rational(second))
            if size.upper + size.lower > MOST_BITS:
                raise TooLargeError
        return operation(first, second)

    return apply


plus, minus, times, over = map(_bounded, (operator.add, operator.sub, operator.mul, operator.truediv))


def power(base: Numeric, exponent: int) -> Any:
    """Return a whole power."""
    if isinstance(base, Fraction):
        size = Separation.rational(base)
        # An exponent may be beyond all floats.
        if abs(exponent) * Fraction(size.upper + size.lower) > MOST_BITS:
            raise TooLargeError
    return base**exponent


def outgrows(base: Fraction, exponent: int) -> bool:
    """Return whether a power is certainly beyond all numbers of so many bits."""
    size = Separation.rational(base)
    bits = size.upper - size.lower
    grows = (bits > 0) == (exponent > 0)
    return grows and abs(exponent) * Fraction(abs(bits) - _DOUBT) > MOST_BITS
