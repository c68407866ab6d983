"""Quotients of polynomials with rational coefficients in any number of letters, exactly, by flint; and how
much work is done with them, for a source may ask for years of it.

Letters that are roots of a polynomial have a rule for their square, by which products are reduced: with
sin² = 1 - cos² a polynomial in sine and cosine that is zero everywhere has no terms.
"""

from __future__ import annotations

from functools import cache
from typing import Any, TypeAlias

from flint import fmpq_mpoly_ctx

from kurbel.exact.size import MOST_BITS

# flint has no types.
Polynomial: TypeAlias = Any
# No formula of a book needs more.
MOST_LETTERS = 96
# In what a product of two terms costs, or an operation with balls: each about a second and half a one. The
# proofs of the books take 50,000 at the most, their points 30,000.
MOST_OF_PROOFS, MOST_AT_POINTS = 100_000, 500_000
# Of a product of two terms.
SHARE_OF_SUM = 0.3
# Bits of a coefficient for which a product costs as much again.
BITS_OF_PRODUCT = 500


class UnprovableError(ArithmeticError):
    """What is not within reach of these proofs."""


class Work:
    """The work that is left; what asks for more is not settled."""

    def __init__(self, left: float) -> None:
        self.left = left

    def spend(self, amount: float) -> None:
        """Count work that is about to be done. Raises UnprovableError where there is too much."""
        self.left -= amount
        if self.left < 0:
            raise UnprovableError("too much work")


class Ring:
    """The letters by their places in monomials, and the rules for the squares of some; later letters, which
    have the lower places, are greater ones."""

    def __init__(self, work: Work) -> None:
        self.work = work
        self.letters: tuple[Polynomial, ...] = _letters()
        self.one = self.letters[0] ** 0
        self.last = MOST_LETTERS
        self.rules: list[tuple[int, Polynomial]] = []

    def letter(self, square: Polynomial | None = None) -> int:
        """Return a new letter, whose square is a polynomial if there is one."""
        if not self.last:
            raise UnprovableError("too many letters")
        self.last -= 1
        if square is not None:
            self.rules.insert(0, (self.last, self.letters[self.last] ** 2 - square))
        return self.last

    def sum(self, one: Polynomial, other: Polynomial, factor: int = 1) -> Polynomial:
        """Return one plus the other, which is multiplied by a factor."""
        self.work.spend(SHARE_OF_SUM * (len(one) + len(other)))
        return one + factor * other

    def product(self, one: Polynomial, other: Polynomial) -> Polynomial:
        """Return the product, reduced by the rules."""
        self._count(one, other)
        total = one * other
        for letter, rule in self.rules:
            if total.degrees()[letter] > 1:
                self._count(total, rule)
                total %= rule
        return total

    def _count(self, one: Polynomial, other: Polynomial) -> None:
        """Count the work of a product before it is made."""
        bits = [max((each.height_bits() for each in factor.coeffs()), default=0) for factor in (one, other)]
        if max(bits) > MOST_BITS:
            raise UnprovableError("too large a number")
        self.work.spend(len(one) * len(other) * (1 + sum(bits) / BITS_OF_PRODUCT))


@cache
def _letters() -> tuple[Polynomial, ...]:
    return tuple(fmpq_mpoly_ctx.get([f"x{place}" for place in range(MOST_LETTERS)], "lex").gens())


class Quotient:
    """A quotient of two polynomials of a ring, without the factors that are plain letters."""

    def __init__(self, ring: Ring, top: Polynomial, bottom: Polynomial | None = None) -> None:
        bottom = ring.one if bottom is None else bottom
        if not bottom:
            raise UnprovableError("division by zero")
        shared = top.term_content().gcd(bottom.term_content()) if top else bottom
        scale = shared * (bottom / shared).leading_coefficient()
        self.ring, self.top, self.bottom = ring, top / scale, bottom / scale

    def __add__(self, other: Quotient, times: int = 1) -> Quotient:
        ring = self.ring
        if self.bottom == other.bottom:
            return Quotient(ring, ring.sum(self.top, other.top, times), self.bottom)
        left, right = ring.product(self.top, other.bottom), ring.product(other.top, self.bottom)
        return Quotient(ring, ring.sum(left, right, times), ring.product(self.bottom, other.bottom))

    def __sub__(self, other: Quotient) -> Quotient:
        return self.__add__(other, -1)

    def __neg__(self) -> Quotient:
        return Quotient(self.ring, -self.top, self.bottom)

    def __mul__(self, other: Quotient) -> Quotient:
        product = self.ring.product
        return Quotient(self.ring, product(self.top, other.top), product(self.bottom, other.bottom))

    def __truediv__(self, other: Quotient) -> Quotient:
        return self * Quotient(other.ring, other.bottom, other.top)

    def vanishes(self) -> bool:
        return not self.top

    def equals(self, other: Quotient) -> bool:
        return (self - other).vanishes()
