"""Polynomials with rational coefficients in any number of letters, and their quotients, exactly.

A polynomial is its terms, coefficients by monomials; a monomial is its letters with their exponents, in
order. Letters that are roots of a polynomial have a rule for their square, by which products are reduced:
with sin² = 1 - cos² a polynomial in sine and cosine that is zero everywhere has no terms.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import TypeAlias

from kurbel.books.formulas.work import BITS_OF_PRODUCT, UnprovableError, Work
from kurbel.exact.size import plus, times

Monomial: TypeAlias = tuple[tuple[int, int], ...]
Polynomial: TypeAlias = Mapping[Monomial, Fraction]
ONE: Polynomial = {(): Fraction(1)}
# Of a product of two terms.
SHARE_OF_SUM = 0.3
# So many letters of a monomial cost as much again.
LETTERS = 8


class Ring:
    """The letters by their numbers, and the rules for the squares of some."""

    def __init__(self, work: Work) -> None:
        self.work = work
        self.count = 0
        self.squares: dict[int, Polynomial] = {}

    def letter(self, square: Polynomial | None = None) -> int:
        """Return a new letter, whose square is a polynomial if there is one."""
        self.count += 1
        if square is not None:
            self.squares[self.count] = square
        return self.count

    def power(self, letter: int, exponent: int = 1) -> Polynomial:
        return {((letter, exponent),): Fraction(1)}

    def sum(self, one: Polynomial, other: Polynomial, factor: Fraction = Fraction(1)) -> Polynomial:
        """Return one plus the other, which is multiplied by a factor."""
        self.work.spend(SHARE_OF_SUM * (len(one) + len(other)))
        total = dict(one)
        for monomial, coefficient in other.items():
            total[monomial] = plus(total.get(monomial, Fraction(0)), factor * coefficient)
        return {monomial: coefficient for monomial, coefficient in total.items() if coefficient}

    def product(self, one: Polynomial, other: Polynomial) -> Polynomial:
        """Return the product, reduced by the rules."""
        self.work.spend(len(one) * len(other) * (_size(one) + _size(other)))
        total: dict[Monomial, Fraction] = {}
        for left, first in one.items():
            for right, second in other.items():
                monomial = multiplied(left, right)
                total[monomial] = plus(total.get(monomial, Fraction(0)), times(first, second))
        return self._reduced(
            {monomial: coefficient for monomial, coefficient in total.items() if coefficient}
        )

    def _reduced(self, polynomial: Polynomial) -> Polynomial:
        """Return the polynomial with no letter that has a rule in a power above the first."""
        total: dict[Monomial, Fraction] = {}
        for monomial, coefficient in polynomial.items():
            square = next((one for one, power in monomial if power > 1 and one in self.squares), None)
            terms: Polynomial = {monomial: coefficient}
            if square is not None:
                rest = {multiplied(monomial, ((square, -2),)): coefficient}
                terms = self.product(self.squares[square], rest)
            for one, value in terms.items():
                total[one] = plus(total.get(one, Fraction(0)), value)
        return {monomial: coefficient for monomial, coefficient in total.items() if coefficient}


def _size(polynomial: Polynomial) -> float:
    """Return what its longest term adds to the work of a product of two terms."""
    longest = max(map(len, polynomial), default=0)
    bits = max(
        (one.numerator.bit_length() + one.denominator.bit_length() for one in polynomial.values()), default=0
    )
    return 0.5 + longest / LETTERS + bits / BITS_OF_PRODUCT


def multiplied(one: Monomial, other: Monomial) -> Monomial:
    """Return the product of two monomials; exponents may be below zero."""
    exponents = dict(one)
    for letter, power in other:
        exponents[letter] = exponents.get(letter, 0) + power
    return tuple(sorted((letter, power) for letter, power in exponents.items() if power))


def common(polynomial: Polynomial) -> Monomial:
    """Return the greatest monomial that divides all terms."""
    first, *others = polynomial
    shared = dict(first)
    for monomial in others:
        powers = dict(monomial)
        shared = {letter: min(power, powers[letter]) for letter, power in shared.items() if letter in powers}
    return tuple(sorted(shared.items()))


class Quotient:
    """A quotient of two polynomials of a ring, without the factors that are plain letters."""

    def __init__(self, ring: Ring, top: Polynomial, bottom: Polynomial = ONE) -> None:
        if not bottom:
            raise UnprovableError("division by zero")
        self.ring = ring
        self.top, self.bottom = _cancelled(top, bottom)

    def __add__(self, other: Quotient, times: int = 1) -> Quotient:
        ring = self.ring
        if self.bottom == other.bottom:
            return Quotient(ring, ring.sum(self.top, other.top, Fraction(times)), self.bottom)
        left, right = ring.product(self.top, other.bottom), ring.product(other.top, self.bottom)
        bottom = ring.product(self.bottom, other.bottom)
        return Quotient(ring, ring.sum(left, right, Fraction(times)), bottom)

    def __sub__(self, other: Quotient) -> Quotient:
        return self.__add__(other, -1)

    def __neg__(self) -> Quotient:
        return Quotient(self.ring, {one: -coefficient for one, coefficient in self.top.items()}, self.bottom)

    def __mul__(self, other: Quotient) -> Quotient:
        ring = self.ring
        return Quotient(ring, ring.product(self.top, other.top), ring.product(self.bottom, other.bottom))

    def __truediv__(self, other: Quotient) -> Quotient:
        return self * Quotient(other.ring, other.bottom, other.top)

    def vanishes(self) -> bool:
        return not self.top

    def equals(self, other: Quotient) -> bool:
        return (self - other).vanishes()


def _cancelled(top: Polynomial, bottom: Polynomial) -> tuple[Polynomial, Polynomial]:
    """Return both without their common plain letters, the first coefficient below the line 1."""
    if not top:
        return {}, ONE
    above, below = dict(common(top)), dict(common(bottom))
    shared = tuple((letter, -min(power, above.get(letter, 0))) for letter, power in below.items())
    scale = bottom[min(bottom)]
    return _times(top, shared, 1 / scale), _times(bottom, shared, 1 / scale)


def _times(polynomial: Polynomial, monomial: Monomial, factor: Fraction) -> Polynomial:
    return {multiplied(one, monomial): coefficient * factor for one, coefficient in polynomial.items()}
