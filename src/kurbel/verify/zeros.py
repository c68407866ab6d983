"""Crank angles at which something is zero: a sign that changes, proved at both ends.

Of a continuous function over the crank angle that is below zero at one end of an interval and above it at the
other, a zero lies between. Nothing else of the function is needed, neither slopes nor a formula of the zero.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from kurbel.verify.enclose import WorkingPrecision, by_bits
from kurbel.verify.numbers import Number, Undecided, number, pi, spread
from kurbel.verify.value import Value

# What an enclosure too wide for a cell raises.
TOO_WIDE = (Undecided, ZeroDivisionError, OverflowError, ValueError)
# How far from a printed angle its zero is looked for, in degrees: first near, then farther.
NEAREST, FARTHEST = Fraction(1, 2048), Fraction(2)
# A zero with a denominator up to this may be exact.
SIMPLE = 720
# Cells in which zeros are told apart are no less, in degrees.
LEAST = Fraction(1, 2**40)


class Place(NamedTuple):
    """A crank angle in degrees, or all within a reach of it."""

    degrees: Fraction
    reach: Fraction = Fraction(0)

    @property
    def ends(self) -> tuple[Fraction, Fraction]:
        return self.degrees - self.reach, self.degrees + self.reach

    @property
    def angle(self) -> Number:
        return spread(*self.ends) if self.reach else number(self.degrees)

    @property
    def arc(self) -> Number:
        """What they are from the middle, in radians."""
        return spread(-self.reach, self.reach) * pi() / 180

    @property
    def half(self) -> Number:
        """Its half width in radians."""
        return pi() * self.reach / 180

    def turned(self, degrees: Fraction) -> Place:
        return Place(self.degrees + degrees, self.reach)

    def parts(self, count: int = 2) -> list[Place]:
        """The same in parts of equal width."""
        width = self.reach / count
        return [Place(self.degrees + width * (2 * index + 1 - count), width) for index in range(count)]


Function = Callable[[Place], Number]


class FoundAngle:
    """A crank angle that is found anew with more bits, as narrow as they say."""

    def __init__(self, found: Callable[[], Place]) -> None:
        self._find = found

    @by_bits
    def __call__(self) -> Place:
        return self._find()

    @property
    def value(self) -> Value:
        """The angle in degrees."""
        return Value(lambda: self().angle)


def around(angle: Number) -> Place:
    exact = angle.rational
    return Place(angle.middle, angle.high - angle.middle) if exact is None else Place(exact)


def root(function: Function, near: Fraction, slope: Function | None = None) -> FoundAngle:
    """Return where a function over the crank angle is zero near an angle.

    With its `slope` also where it only touches zero: where the slope changes its sign, and no enclosure of
    the function excludes zero.
    """

    def found() -> Place:
        try:
            return _nearest(cache(function), near)
        except Undecided:
            if slope is None:
                raise
            place = _nearest(cache(slope), near)
            if Fraction(0) not in function(place):
                raise
            return place

    return FoundAngle(found)


def _nearest(function: Function, near: Fraction) -> Place:
    if function(Place(near)).is_zero:
        return Place(near)
    reach = NEAREST
    while reach <= FARTHEST:
        low, high = near - reach, near + reach
        if function(Place(low)).sign() != function(Place(high)).sign():
            return between(function, low, high)
        reach *= 16
    raise Undecided("no change of sign at the angle that is printed")


class Crossing(NamedTuple):
    """A cell in which a function is zero exactly once."""

    cell: Place
    rising: bool


def told_apart(function: Callable[[Place, int], Number], cells: list[Place]) -> Iterator[Crossing]:
    """All zeros in cells of a function, 0, by its slope over a cell, 1: about the middle m it lies in
    f(m) + f'(X)(X - m). A cell is halved until that excludes zero, or f' has one sign there and the ends
    tell."""
    zero = Fraction(0)
    while cells:
        cell = cells.pop()
        try:
            slope = function(cell, 1)
            if zero not in function(Place(cell.degrees), 0) + slope * cell.arc:
                continue
            if zero not in slope:
                before, after = (function(Place(end), 0).sign() for end in cell.ends)
                if before != after:
                    yield Crossing(cell, after > 0)
                continue
        except TOO_WIDE:
            pass
        if cell.reach < LEAST:
            raise Undecided("a place at which there may be a zero")
        cells += cell.parts()


def between(function: Function, low: Fraction, high: Fraction) -> Place:
    """Return where a function whose signs at two ends differ is zero between them.

    To two thirds of the bits it must have signs; beyond, the zero gets as narrow as there are any.
    """
    bits, at = WorkingPrecision.bits, cache(lambda degrees: function(Place(degrees)))
    before = at(low).sign()
    if before == at(high).sign():
        raise Undecided("no change of sign")

    def cut(point: Fraction) -> None:
        nonlocal low, high
        point = Fraction(round(point * 2**bits), 2**bits)
        if low < point < high:
            low, high = (point, high) if at(point).sign() == before else (low, point)

    def narrow(least: Fraction) -> None:
        """Halve, or better: cut about where a straight line through both ends is zero, for the rest is of
        second order."""
        while (width := high - low) > least:
            at_low, at_high = (abs(at(one).middle) for one in (low, high))
            guess, about = low + width * at_low / (at_low + at_high), max(width * width / 16, least / 8)
            cut(guess - about)
            cut(guess + about)
            if high - low > width / 2:
                cut((low + high) / 2)

    narrow(Fraction(1, 2 ** (bits * 2 // 3)))
    with suppress(Undecided):
        narrow(Fraction(1, 2 ** (bits - 24)))
    middle = (low + high) / 2
    simple = middle.limit_denominator(SIMPLE)
    if low <= simple <= high and at(simple).is_zero:
        return Place(simple)
    return Place(middle, (high - low) / 2)
