"""Formulas on exact quotients of polynomials, in which an equality is proved by the terms themselves.

Letters, π and logarithms are taken for independent of one another, an angle of its sine and cosine too: what
holds so holds for all numbers. Sine and cosine of all angles are made of those of a part of each letter, and
s² is 1 - c²; a root is a letter whose square is the radicand. Letters are positive, so that the root of a
square of letters alone is known.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import TypeAlias

from flint import fmpq

from kurbel.books.formulas.polynomial import Polynomial, Quotient, Ring, UnprovableError, Work

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
        self._roots: list[tuple[Polynomial, Quotient]] = []
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
        if angle.bottom != 1:
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
        return root if rest == 1 else root * self._root_of(rest)

    def _is_positive(self, polynomial: Polynomial) -> bool:
        """Whether it is a product of plain letters, which are positive."""
        return all(
            coefficient > 0 and all(place in self._positive for place, power in enumerate(powers) if power)
            for powers, coefficient in polynomial.terms()
        )

    def _parted(self, radicand: Polynomial) -> tuple[Polynomial, Polynomial]:
        """Return what stands before the root, letters and a number; and what is left below it."""
        (shared,), before = radicand.term_content().monoms(), self.ring.one
        for place in self._positive:
            before *= self.ring.letters[place] ** (shared[place] // 2)
        constant = abs(radicand.coeffs()[-1])
        # √(n/d) is √(n d)/d, so that roots of numbers alone are those of whole ones without squares.
        before *= fmpq(square_root_in(int(constant.p * constant.q)), constant.q)
        return before, radicand / (before * before)

    def _root_of(self, radicand: Polynomial) -> Quotient:
        for known, root in self._roots:
            if known == radicand:
                return root
        root = Quotient(self.ring, self.ring.letters[self.ring.letter(radicand)])
        self._roots.append((radicand, root))
        return root
