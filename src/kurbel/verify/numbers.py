"""A real number: an enclosure, and where it is one, an exact sum of square roots."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TypeAlias

from kurbel.verify import enclose, surd
from kurbel.verify.enclose import Interval

# What is added to a number; a series does this by itself.
Addend: TypeAlias = "Number | Fraction | int"


class Undecided(Exception):
    """An enclosure too wide for the question; with more bits it may be narrow enough."""


class Number:
    """What is known of a real number at the working precision."""

    __slots__ = ("_span", "exact")

    def __init__(self, span: Interval | None = None, exact: surd.Surd | None = None) -> None:
        self._span, self.exact = span, exact

    @property
    def span(self) -> Interval:
        if self._span is None:
            assert self.exact is not None
            self._span = enclose.of(0)
            for radicand, factor in self.exact.items():
                one = enclose.of(factor)
                self._span += one if radicand == 1 else one * enclose.root(enclose.of(radicand))
        return self._span

    @property
    def low(self) -> Fraction:
        return enclose.low(self.span)

    @property
    def high(self) -> Fraction:
        return enclose.high(self.span)

    @property
    def rational(self) -> Fraction | None:
        """The number itself where it is known to be a fraction."""
        if self.exact is None or set(self.exact) - {1}:
            return None
        return self.exact.get(1, Fraction(0))

    @property
    def is_zero(self) -> bool:
        return self.exact == {}

    def side(self) -> int | None:
        """The sign where it is known."""
        return 0 if self.is_zero else 1 if self.low > 0 else -1 if self.high < 0 else None

    def sign(self) -> int:
        known = self.side()
        if known is None:
            raise Undecided("a sign")
        return known

    @property
    def middle(self) -> Fraction:
        return (self.low + self.high) / 2

    def __float__(self) -> float:
        return float(self.middle)

    def __repr__(self) -> str:
        return f"Number({float(self)!r} ± {float(self.high - self.low) / 2:.1e})"

    def __contains__(self, number: Fraction) -> bool:
        return self.low <= number <= self.high

    def __add__(self, other: Addend) -> Number:
        if not isinstance(other, KINDS):
            return NotImplemented
        other = number(other)
        if self.exact is not None and other.exact is not None:
            exact = surd.added(self.exact, other.exact)
            if exact is not None:
                return Number(exact=exact)
        if self.is_zero:
            return other
        return self if other.is_zero else Number(self.span + other.span)

    __radd__ = __add__

    def __neg__(self) -> Number:
        if self.exact is not None:
            return Number(exact={radicand: -factor for radicand, factor in self.exact.items()})
        return Number(-self.span)

    def __sub__(self, other: Addend) -> Number:
        return self + -other

    def __rsub__(self, other: Addend) -> Number:
        return -self + other

    def __mul__(self, other: Addend) -> Number:
        if not isinstance(other, KINDS):
            return NotImplemented
        other = number(other)
        if self.is_zero or other.is_zero:
            return Number(exact={})
        if self.exact is not None and other.exact is not None:
            exact = surd.multiplied(self.exact, other.exact)
            if exact is not None:
                return Number(exact=exact)
        return Number(self.span * other.span)

    __rmul__ = __mul__

    def __truediv__(self, other: Addend) -> Number:
        if not isinstance(other, KINDS):
            return NotImplemented
        other = number(other)
        if other.exact is not None:
            if other.is_zero:
                raise ZeroDivisionError("a division by zero")
            exact = surd.inverse(other.exact)
            if exact is not None:
                return self * Number(exact=exact)
        if other.low <= 0 <= other.high:
            raise Undecided("a division")
        return Number(self.span / other.span)

    def __rtruediv__(self, other: Addend) -> Number:
        return number(other) / self

    def __abs__(self) -> Number:
        return self if self.low >= 0 else -self if self.high <= 0 else Number(abs(self.span))

    def root(self) -> Number:
        if self.exact is not None:
            exact = surd.root(self.exact)
            if exact is not None:
                return Number(exact=exact)
        if self.high < 0:
            raise ValueError("the root of a negative number")
        return Number(enclose.root(self.span))

    def exp(self) -> Number:
        return Number(enclose.exponential(self.span))

    def log(self) -> Number:
        return Number(exact={}) if self.rational == 1 else Number(enclose.logarithm(self.span))

    def power(self, exponent: Fraction) -> Number:
        """x^(p/q) of a positive x: whole powers by products, half ones by roots, others e^(p/q log x).

        It rises or falls throughout, so a wide enclosure goes through by its ends.
        """
        exponent = Fraction(exponent)
        if self.exact is None and self.low > 0 and self.high - self.low >= WIDE:
            return hull([number(one).power(exponent) for one in (self.low, self.high)])
        if exponent.denominator > 2 or abs(exponent) > 64:
            return Number(enclose.exponential(enclose.of(exponent) * enclose.logarithm(self.span)))
        base = self if exponent.denominator == 1 else self.root()
        found = number(1)
        for _ in range(abs(exponent.numerator)):
            found = found * base
        return found if exponent >= 0 else 1 / found


# What goes through what is monotone by its ends.
WIDE = Fraction(1, 2**30)
KINDS = (Number, int, Fraction)


def number(given: Number | Fraction | int | str) -> Number:
    return given if isinstance(given, Number) else Number(exact=surd.rational(Fraction(given)))


def spread(low: Fraction, high: Fraction) -> Number:
    return Number(enclose.between(low, high))


def hull(numbers: Sequence[Number]) -> Number:
    """Return an enclosure of all of them."""
    if len(numbers) == 1:
        return numbers[0]
    return spread(min(one.low for one in numbers), max(one.high for one in numbers))


def largest(numbers: Sequence[Number]) -> Number:
    """Return an enclosure of the greatest of them."""
    best = max(one.low for one in numbers)
    return hull([one for one in numbers if one.high >= best])


def pi() -> Number:
    return Number(enclose.pi())


# Sine and cosine of multiples of 15° up to 45°.
_QUARTER, _HALF = Fraction(1, 4), Fraction(1, 2)
_KNOWN: dict[int, tuple[surd.Surd, surd.Surd]] = {
    0: ({}, {1: Fraction(1)}),
    15: ({6: _QUARTER, 2: -_QUARTER}, {6: _QUARTER, 2: _QUARTER}),
    30: ({1: _HALF}, {3: _HALF}),
    45: ({2: _HALF}, {2: _HALF}),
}


def sine_cosine(degrees: Fraction, reach: Fraction = Fraction(0)) -> tuple[Number, Number]:
    """Return sine and cosine of an angle, or of all within a reach of it.

    Quarters are taken off exactly; |t| <= 45° is left, of multiples of 15° with known values, and of others
    by the series at t π/180 < 1. A reach widens both by as much in radians, for no slope is above 1.
    """
    quarter = round(degrees / 90)
    rest = degrees - 90 * quarter
    if abs(rest) in _KNOWN:
        s, c = (Number(exact=dict(one)) for one in _KNOWN[int(abs(rest))])
        sine, cosine = (-s if rest < 0 else s), c
    else:
        found = enclose.sine_cosine(enclose.of(rest) * enclose.pi() / 180)
        sine, cosine = Number(found[0]), Number(found[1])
    sine, cosine = [(sine, cosine), (cosine, -sine), (-sine, -cosine), (-cosine, sine)][quarter % 4]
    if reach:
        wide = Number(enclose.sized(enclose.of(reach) * enclose.pi() / 180))
        sine, cosine = Number(sine.span + wide.span), Number(cosine.span + wide.span)
    return sine, cosine


def degrees_of(x: Number, y: Number) -> Number:
    """Return the angle of (x, y) in degrees, from -180° to 180°.

    The larger of |x| and |y| divides the other: arctan (y/x), or ±90° - arctan (x/y). Where x² : y² is 0, 1,
    3 or 1/3 for certain, the angle is exact.
    """
    known = _known_degrees(x, y)
    if known is not None:
        return number(known)
    if abs(float(x)) >= abs(float(y)):
        along = x.sign()
        found = _arctangent(y / x)
        return found if along > 0 else found + 180 * y.sign()
    return 90 * number(y.sign()) - _arctangent(x / y)


def heading(x: Number, y: Number) -> Number:
    """The angle of (x, y) in degrees from 0 up to 360."""
    found = degrees_of(x, y)
    return found if found.sign() >= 0 else found + 360


def arccosine(cosine: Number) -> Number:
    """In degrees, from 0 to 180."""
    return degrees_of(cosine, (1 - cosine * cosine).root())


def _arctangent(slope: Number) -> Number:
    return Number(enclose.arctangent(slope.span) * 180 / enclose.pi())


def _known_degrees(x: Number, y: Number) -> Fraction | None:
    if x.is_zero and y.is_zero:
        raise ZeroDivisionError("what stands still has no direction")
    if x.is_zero or y.is_zero:
        return Fraction(90 * y.sign() if x.is_zero else 0 if x.sign() > 0 else 180)
    if x.exact is None or y.exact is None:
        return None
    slope = (x * x / (y * y)).rational
    if slope not in (1, 3, Fraction(1, 3)):
        return None
    angle = {Fraction(1): 45, Fraction(3): 30, Fraction(1, 3): 60}[slope]
    return Fraction(y.sign() * (angle if x.sign() > 0 else 180 - angle))
