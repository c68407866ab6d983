"""Formulas on exact quotients of polynomials, by flint: an equality is proved by the terms themselves.

Letters, π and logarithms are taken for independent of one another, an angle of its sine and cosine too: what
holds so holds for all numbers. Sine and cosine of all angles are made of those of a part of each letter, and
s² is 1 - c²; a root is a letter whose square is the radicand. Letters that are roots of a polynomial have a
rule for their square, by which products are reduced: a polynomial that is zero everywhere has no terms.
Letters are positive, so that the root of a square of letters alone is known. Work is counted, for a source
may ask for years of it.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from typing import TypeAlias

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from kurbel.exact.separation import MOST_BITS

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
        self.letters: tuple[fmpq_mpoly, ...] = _letters()
        self.one = self.letters[0] ** 0
        self.last = MOST_LETTERS
        self.rules: list[tuple[int, fmpq_mpoly]] = []

    def letter(self, square: fmpq_mpoly | None = None) -> int:
        """Return a new letter, whose square is a polynomial if there is one."""
        if not self.last:
            raise UnprovableError("too many letters")
        self.last -= 1
        if square is not None:
            self.rules.insert(0, (self.last, self.letters[self.last] ** 2 - square))
        return self.last

    def sum(self, one: fmpq_mpoly, other: fmpq_mpoly, factor: int = 1) -> fmpq_mpoly:
        """Return one plus the other, which is multiplied by a factor."""
        self.work.spend(SHARE_OF_SUM * (len(one) + len(other)))
        return one + factor * other

    def product(self, one: fmpq_mpoly, other: fmpq_mpoly) -> fmpq_mpoly:
        """Return the product, reduced by the rules."""
        self._count(one, other)
        total = one * other
        for letter, rule in self.rules:
            if total.degrees()[letter] > 1:
                self._count(total, rule)
                total %= rule
        return total

    def _count(self, one: fmpq_mpoly, other: fmpq_mpoly) -> None:
        """Count the work of a product before it is made."""
        bits = [max((each.height_bits() for each in factor.coeffs()), default=0) for factor in (one, other)]
        if max(bits) > MOST_BITS:
            raise UnprovableError("too large a number")
        self.work.spend(len(one) * len(other) * (1 + sum(bits) / BITS_OF_PRODUCT))


@cache
def _letters() -> tuple[fmpq_mpoly, ...]:
    return tuple(fmpq_mpoly_ctx.get([f"x{place}" for place in range(MOST_LETTERS)], "lex").gens())


class Quotient:
    """A quotient of two polynomials of a ring, without the factors that are plain letters."""

    def __init__(self, ring: Ring, top: fmpq_mpoly, bottom: fmpq_mpoly | None = None) -> None:
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


Circle: TypeAlias = tuple[Quotient, Quotient]
# Of a letter in an angle; halves and quarters of angles are in the books.
PARTS = (1, 2, 4)
# Sine and cosine of 0°, 90°, 180°, 270°.
_QUARTERS = ((0, 1), (1, 0), (0, -1), (-1, 0))
# Of which an angle is made.
MOST_PARTS = 64
# Whose squares are taken out of a root.
LARGEST_PRIME = 100


def square_root_in(number: int) -> int:
    """Return the greatest whole number whose square divides a number, as far as its primes are small."""
    root = 1
    for prime in range(2, LARGEST_PRIME):
        while number % (prime * prime) == 0:
            number //= prime * prime
            root *= prime
    return root


class Symbols:
    """The algebra of quotients. `parts` is into how many parts the angles are divided."""

    def __init__(self, parts: int, work: Work) -> None:
        self.ring = Ring(work)
        self.parts = parts
        self._positive: set[int] = set()
        self.pi = self.letter()
        self._pi = self.ring.last
        self._circles: dict[int, Circle] = {}
        self._whole: set[int] = set()
        self._roots: list[tuple[fmpq_mpoly, Quotient]] = []
        self._logarithms: list[tuple[Quotient, Quotient]] = []
        self._functions: dict[str, Callable[[Quotient], Quotient]] = {
            "sin": lambda angle: self._circle(angle)[0],
            "cos": lambda angle: self._circle(angle)[1],
            "tan": lambda angle: self._circle(angle)[0] / self._circle(angle)[1],
            "cot": lambda angle: self._circle(angle)[1] / self._circle(angle)[0],
            "sqrt": self._root,
            "ln": self._logarithm,
            "arcsin": self._arcsin,
            "arctan": self._arctan,
        }

    def letter(self) -> Quotient:
        """Return a new letter that stands for any positive number."""
        number = self.ring.letter()
        self._positive.add(number)
        return Quotient(self.ring, self.ring.letters[number])

    def spend(self, operations: float) -> None:
        self.ring.work.spend(operations)

    def of(self, value: Fraction) -> Quotient:
        return Quotient(self.ring, fmpq(value.numerator, value.denominator) * self.ring.one)

    def apply(self, function: str, value: Quotient) -> Quotient:
        return self._functions[function](value)

    def _circle(self, angle: Quotient) -> Circle:
        """Return sine and cosine of a sum of letters with rational factors."""
        if not angle.bottom.is_one():
            raise UnprovableError("the angle is a quotient")
        sine, cosine = self.of(Fraction(0)), self.of(Fraction(1))
        for powers, factor in angle.top.terms():
            if sum(powers) != 1:
                raise UnprovableError("the angle is no sum of letters")
            share = Fraction(int(factor.p), int(factor.q))
            other_sine, other_cosine = self._multiple(powers.index(1), share)
            sine, cosine = (
                sine * other_cosine + cosine * other_sine,
                cosine * other_cosine - sine * other_sine,
            )
        return sine, cosine

    def _multiple(self, letter: int, factor: Fraction) -> Circle:
        if letter == self._pi and (2 * factor).denominator == 1:
            of_quarter = _QUARTERS[int(2 * factor) % 4]
            return self.of(Fraction(of_quarter[0])), self.of(Fraction(of_quarter[1]))
        count = factor if letter in self._whole else factor * self.parts
        if count.denominator != 1 or abs(count) > MOST_PARTS:
            raise UnprovableError("a part of an angle is too small, or the angle too many")
        sine, cosine = self.of(Fraction(0)), self.of(Fraction(1))
        step_sine, step_cosine = self._step(letter)
        for _ in range(abs(int(count))):
            sine, cosine = sine * step_cosine + cosine * step_sine, cosine * step_cosine - sine * step_sine
        return (-sine if count < 0 else sine), cosine

    def _step(self, letter: int) -> Circle:
        """Return sine and cosine of the part of a letter of which all its angles are made."""
        if letter not in self._circles:
            ring = self.ring
            cosine = ring.letter()
            sine = ring.letter(1 - ring.letters[cosine] ** 2)
            self._circles[letter] = Quotient(ring, ring.letters[sine]), Quotient(ring, ring.letters[cosine])
        return self._circles[letter]

    def _arc(self, sine: Quotient, cosine: Quotient) -> Quotient:
        angle = self.ring.letter()
        self._circles[angle] = sine, cosine
        self._whole.add(angle)
        return Quotient(self.ring, self.ring.letters[angle])

    def _arcsin(self, sine: Quotient) -> Quotient:
        return self._arc(sine, self._root(self.of(Fraction(1)) - sine * sine))

    def _arctan(self, tangent: Quotient) -> Quotient:
        secant = self._root(self.of(Fraction(1)) + tangent * tangent)
        return self._arc(tangent / secant, self.of(Fraction(1)) / secant)

    def _logarithm(self, value: Quotient) -> Quotient:
        for known, logarithm in self._logarithms:
            if known.equals(value):
                return logarithm
        # Of either sign, and so none of the letters that may stand before a root.
        logarithm = Quotient(self.ring, self.ring.letters[self.ring.letter()])
        self._logarithms.append((value, logarithm))
        return logarithm

    def _root(self, value: Quotient) -> Quotient:
        """Return the root of N/D as √(N D)/D, with the squares of letters before the root."""
        if not self._is_positive(value.bottom):
            raise UnprovableError("the sign below the line is not known")
        radicand = self.ring.product(value.top, value.bottom)
        if not radicand:
            return self.of(Fraction(0))
        before, rest = self._parted(radicand)
        root = Quotient(self.ring, before, value.bottom)
        return root if rest.is_one() else root * self._root_of(rest)

    def _is_positive(self, polynomial: fmpq_mpoly) -> bool:
        """Whether it is a product of plain letters, which are positive."""
        return all(
            coefficient > 0 and all(place in self._positive for place, power in enumerate(powers) if power)
            for powers, coefficient in polynomial.terms()
        )

    def _parted(self, radicand: fmpq_mpoly) -> tuple[fmpq_mpoly, fmpq_mpoly]:
        """Return what stands before the root, letters and a number; and what is left below it."""
        (shared,), before = radicand.term_content().monoms(), self.ring.one
        for place in self._positive:
            before *= self.ring.letters[place] ** (shared[place] // 2)
        constant = abs(radicand.coeffs()[-1])
        # √(n/d) is √(n d)/d, so that roots of numbers alone are those of whole ones without squares.
        before *= fmpq(square_root_in(int(constant.p * constant.q)), constant.q)
        return before, radicand / (before * before)

    def _root_of(self, radicand: fmpq_mpoly) -> Quotient:
        for known, root in self._roots:
            if known == radicand:
                return root
        root = Quotient(self.ring, self.ring.letters[self.ring.letter(radicand)])
        self._roots.append((radicand, root))
        return root
