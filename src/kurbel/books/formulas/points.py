"""Formulas at points: in balls, which prove that two values differ, and in power series of a small letter."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cached_property
from random import Random
from typing import Any

import flint
from flint import arb, arb_series

from kurbel.books.formulas.polynomial import Work
from kurbel.exact.certify import ball
from kurbel.exact.numerals import MOST_FIGURES

BITS = 256
# Letters are eighths up to 3/2: angles of the first quadrant, ratios on both sides of 1.
EIGHTHS = 12
POINTS = 8
# Points at which formulas have no value are passed over.
MOST_POINTS = 400
# Of their range, to part roots.
CELLS = 96
# Of a power series.
TERMS = 12
# What an operation with such a series costs, in those with balls.
OF_SERIES = 10
# Beyond this, numbers are not told apart.
LARGEST = ball(Fraction(10**MOST_FIGURES))
_NAMES = {"ln": "log", "arcsin": "asin", "arctan": "atan"}


class Balls:
    """The algebra of balls."""

    def __init__(self, work: Work) -> None:
        self.work = work

    @cached_property
    def pi(self) -> arb:
        return arb.pi()

    def spend(self, operations: float) -> None:
        self.work.spend(operations)

    def of(self, value: Fraction) -> arb:
        return ball(value)

    def apply(self, function: str, value: arb) -> Any:
        return getattr(value, _NAMES.get(function, function))()


class Series:
    """The algebra of power series in a small letter, with balls for coefficients."""

    def __init__(self, work: Work) -> None:
        self.work = work

    @cached_property
    def pi(self) -> arb_series:
        return self.constant(arb.pi())

    def spend(self, operations: float) -> None:
        self.work.spend(OF_SERIES * operations)

    def of(self, value: Fraction) -> arb_series:
        return self.constant(ball(value))

    def constant(self, value: arb) -> arb_series:
        return arb_series([value], TERMS)

    @property
    def small(self) -> arb_series:
        return arb_series([0, 1], TERMS)

    def apply(self, function: str, value: arb_series) -> Any:
        if function == "cot":
            sine, cosine = value.sin_cos()
            return cosine / sine
        return getattr(value, _NAMES.get(function, function))()


def points(letters: frozenset[str]) -> Iterator[Mapping[str, Fraction]]:
    """Yield points for letters, always the same: fractions that differ as far as there are enough."""
    chosen = Random(" ".join(sorted(letters)))
    for _ in range(MOST_POINTS):
        yield {name: Fraction(chosen.randint(1, EIGHTHS), 8) for name in sorted(letters)}


def at_points(letters: frozenset[str], value_at: Callable[[Mapping[str, Fraction]], Any]) -> Iterator[Any]:
    """Yield what is found at the first points where there is something, at high precision."""
    found = 0
    with flint.ctx.workprec(BITS):
        for point in points(letters):
            value = value_at(point)
            if value is not None:
                found += 1
                yield value
            if found == POINTS or (not letters and found):
                return


def is_moderate(value: arb) -> bool:
    """Whether a ball is of a number that is computed: of so many figures, or places, at the most."""
    return bool(abs(value) < LARGEST and (0 in value or abs(value) * LARGEST > 1))


def cells() -> Iterator[arb]:
    """Yield balls that cover what letters are chosen from."""
    for index in range(CELLS):
        yield arb(2 * index + 1, 1) * EIGHTHS / (16 * CELLS)


def ends(cell: arb) -> tuple[arb, arb]:
    """Return the ends of a ball."""
    return arb(cell.lower()), arb(cell.upper())


def order_of(series: arb_series) -> int | None:
    """Return the power of the first term that is certainly there, None without one."""
    for power, coefficient in enumerate(series.coeffs()):
        if 0 not in coefficient:
            return power
    return None
