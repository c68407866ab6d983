"""A value that can be enclosed as narrowly as a question needs, and the decimal that is printed for it."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from math import ceil
from typing import TypeVar

from kurbel.errors import ProblemError
from kurbel.verify.enclose import working
from kurbel.verify.numbers import Number, Undecided

CONFIRMED, WRONG, UNDECIDED = "confirmed", "wrong", "undecided"
ROUNDINGS = ("half-away", "half-even", "up")
# Bits to begin with, and those at which a question is given up.
FIRST, LAST = 90, 3000
Found = TypeVar("Found")


@dataclass(frozen=True)
class Value:
    """A recipe for a number, which is computed anew with more bits until a question is decided."""

    recipe: Callable[[], Number]

    def enclosure(self, bits: int = FIRST) -> Number:
        """Return the number enclosed with so many working bits."""
        with working(bits):
            found = self.recipe()
            found.span  # noqa: B018 with these bits, not with those of who asks
            return found

    def decided(self, question: Callable[[Number], Found]) -> Found:
        """Return the answer of a question that raises `Undecided` while the enclosure is too wide."""
        bits = FIRST
        while True:
            try:
                with working(bits):
                    return question(self.recipe())
            except (Undecided, OverflowError):
                bits *= 2
                if bits > LAST:
                    raise Undecided(f"not even {bits // 2} bits decide") from None

    def scaled(self, decimals: int, rounding: str = "half-away") -> int:
        """Return the value times 10**decimals, rounded."""
        if rounding not in ROUNDINGS:
            raise ProblemError(f'there is no rounding "{rounding}" to verify')
        return self.decided(lambda one: _rounded(one, decimals, rounding))

    def digits(self, decimals: int, rounding: str = "half-away") -> str:
        """Return the value rounded to so many decimals; of a zero without a sign."""
        whole = self.scaled(decimals, rounding)
        front, rest = divmod(abs(whole), 10**decimals)
        sign = "-" if whole < 0 else ""
        return f"{sign}{front}.{rest:0{decimals}d}" if decimals else f"{sign}{front}"

    def confirms(self, printed: str, rounding: str = "half-away") -> str:
        """Say whether a printed decimal is the value rounded: confirmed, wrong or undecided."""
        text = printed.strip().replace("−", "-").replace(",", ".")
        if not re.fullmatch(r"-?[0-9]+(\.[0-9]+)?", text):
            raise ProblemError(f'"{printed}" is no decimal to verify')
        decimals = len(text.partition(".")[2])
        try:
            right = self.scaled(decimals, rounding) == Fraction(text) * 10**decimals
        except Undecided:
            return UNDECIDED
        return CONFIRMED if right else WRONG

    def near(self, bits: int = 200) -> Fraction:
        """Return the middle of an enclosure, for those who compare with a tolerance."""
        return self.enclosure(bits).middle

    def __float__(self) -> float:
        return float(self.near(FIRST))

    def __sub__(self, other: Value) -> Value:
        return Value(lambda: self.recipe() - other.recipe())

    def __neg__(self) -> Value:
        return Value(lambda: -self.recipe())

    def __mul__(self, factor: Fraction | int) -> Value:
        return Value(lambda: self.recipe() * factor)


def _rounded(found: Number, decimals: int, rounding: str) -> int:
    exact = found.rational
    if exact is not None:
        return _nearest(exact * 10**decimals, rounding)
    ends = [one * 10**decimals for one in (found.low, found.high)]
    nearest = {_nearest(one, rounding) for one in ends}
    # An end that is itself a tie could be rounded to one side and the value to the other.
    if len(nearest) > 1 or any((2 * one).denominator == 1 and one.denominator != 1 for one in ends):
        raise Undecided("a rounding")
    return nearest.pop()


def _nearest(scaled: Fraction, rounding: str) -> int:
    if rounding != "half-away":
        return ceil(scaled) if rounding == "up" else round(scaled)
    away = (2 * abs(scaled) + 1) // 2
    return int(away if scaled >= 0 else -away)
