"""Crank angles at which something printed holds, put back: a sign that changes, proved at both ends.

Of a continuous function over the crank angle that is below zero at one end of an interval and above it at the
other, a zero lies between. Nothing else of the function is needed, neither slopes nor a formula of the zero.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from kurbel.verify.enclose import Working
from kurbel.verify.numbers import Number, Undecided
from kurbel.verify.places import Place
from kurbel.verify.value import Value

# How far from a printed angle its zero is looked for, in degrees: first near, then farther.
NEAREST, FARTHEST = Fraction(1, 2000), Fraction(2)
# A zero with a denominator up to this may be exact.
SIMPLE = 720
Function = Callable[[Place], Number]


class Spot:
    """A crank angle that is found anew with more bits, as narrow as they say."""

    def __init__(self, found: Callable[[], Place]) -> None:
        self._find = found
        self._kept: dict[int, Place] = {}

    def __call__(self) -> Place:
        bits = Working.bits
        if bits not in self._kept:
            self._kept[bits] = self._find()
        return self._kept[bits]

    @property
    def value(self) -> Value:
        """The angle in degrees."""
        return Value(lambda: self().angle)


def around(angle: Number) -> Place:
    exact = angle.rational
    return Place(angle.middle, angle.high - angle.middle) if exact is None else Place(exact)


def root(function: Function, near: Fraction, slope: Function | None = None) -> Spot:
    """Return where a function over the crank angle is zero near an angle.

    With its `slope` also where it only touches zero: where the slope changes its sign, and no enclosure of
    the function excludes zero.
    """

    def found() -> Place:
        try:
            return _Zero(function, near).found()
        except Undecided:
            if slope is None:
                raise
            place = _Zero(slope, near).found()
            value = function(place)
            if Fraction(0) not in value:
                raise
            return place

    return Spot(found)


class _Zero:
    def __init__(self, function: Function, near: Fraction) -> None:
        self.function, self.near = function, near
        self._kept: dict[Fraction, Number] = {}

    def at(self, degrees: Fraction) -> Number:
        if degrees not in self._kept:
            self._kept[degrees] = self.function(Place(degrees))
        return self._kept[degrees]

    def sign(self, degrees: Fraction) -> int:
        return self.at(degrees).sign()

    def found(self) -> Place:
        if self.at(self.near).is_zero:
            return Place(self.near)
        low, high = self._ends()
        before, narrow = self.sign(low), Fraction(1, 2 ** (Working.bits * 2 // 3))
        while high - low > narrow:
            low, high = self._narrower(low, high, before, narrow / 4)
        middle = (low + high) / 2
        simple = middle.limit_denominator(SIMPLE)
        if low <= simple <= high and self.at(simple).is_zero:
            return Place(simple)
        return Place(middle, (high - low) / 2)

    def _ends(self) -> tuple[Fraction, Fraction]:
        reach = NEAREST
        while reach <= FARTHEST:
            low, high = self.near - reach, self.near + reach
            if self.sign(low) != self.sign(high):
                return low, high
            reach *= 16
        raise Undecided("no change of sign at the angle that is printed")

    def _narrower(
        self, low: Fraction, high: Fraction, before: int, least: Fraction
    ) -> tuple[Fraction, Fraction]:
        """Halve, or better: about where a straight line through both ends is zero, for the rest is of second
        order."""
        width, bits = high - low, Working.bits
        at_low, at_high = (abs(self.at(one).middle) for one in (low, high))
        guess = low + width * at_low / (at_low + at_high) if at_low + at_high else low + width / 2
        about = max(width * width / 16, least)
        for one in (guess - about, guess + about):
            point = Fraction(round(one * 2**bits), 2**bits)
            if low < point < high:
                low, high = (point, high) if self.sign(point) == before else (low, point)
        if high - low > width / 4:
            middle = (low + high) / 2
            low, high = (middle, high) if self.sign(middle) == before else (low, middle)
        return low, high
