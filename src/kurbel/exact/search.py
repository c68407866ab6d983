"""Zeros and extremes of functions, each enclosed with a proof that none is missed, by interval arithmetic.

A piece of an interval over which the ball of the function excludes zero has none; where the ball of the
slope excludes zero the function is monotone and the signs at the ends decide. What is neither is halved.

Values with their first two slopes: a kernel formula that is run on jets returns its own derivatives.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any, TypeVar

import flint
from flint import arb

from kurbel.exact.certify import at_bits, ball, half_turn_circle, pi
from kurbel.exact.place import Place, fraction, unsettled
from kurbel.kernel.circle import Circle, Numeric

Function = Callable[[arb], arb]
# Whether anything within a piece is asked for.
Concern = Callable[[arb], bool]
Candidate = TypeVar("Candidate")

# What is undecided below this width, 2e-10 of a stroke, is a double zero or lies on a kink or an end.
LEAST_WIDTH = Fraction(1, 2**32)
ISOLATING_BITS = 64
# Beside a double zero these leave four pieces undecided, beside a triple one a few; 64 bits leave thousands.
SHARP_BITS = 128
PARTS = 8
# Two values that agree to so many bits are taken for equal, as on the two strokes of the infinite rod; so
# are two places.
EQUAL_BITS = 200
# How far zeros are sought beyond edges, so that one at an edge is within: shares of half a turn that no
# halving brings to a round angle.
BEFORE, BEHIND = Fraction(5, 11 << 20), Fraction(7, 13 << 20)
# Round angles are quarters of a turn.
QUARTERS = 2


class Zero:
    """A zero of a function that rises or falls there, the one between `low` and `high`.

    `rising` None: possibly none or several; also a zero at an end of the search or where a piece was halved.
    """

    __slots__ = ("_bits", "_found", "function", "high", "low", "rising", "slope")

    def __init__(
        self, function: Function, slope: Function, low: Fraction, high: Fraction, rising: bool | None = True
    ) -> None:
        self.function, self.slope, self.low, self.high, self.rising = function, slope, low, high, rising
        self._bits = 0
        self._found: arb | None = None

    def of(self, function: Function, slope: Function) -> Zero:
        """Return the same of a function that is enclosed by this one's."""
        return Zero(function, slope, self.low, self.high, self.rising)

    def place(self) -> arb:
        """Return a ball that holds it, as narrow as the precision in force allows: interval Newton."""
        if self.rising is None:
            return interval(self.low, self.high)
        if self._found is None or self._bits < flint.ctx.prec:
            found = interval(self.low, self.high) if self._found is None else self._found
            if self.slope(found).contains(0):
                self._halve()
                found = interval(self.low, self.high)
            self._bits, self._found = flint.ctx.prec, self._narrowed(found)
        return self._found

    def _narrowed(self, found: arb) -> arb:
        while True:
            middle = found.mid()
            better = middle - self.function(middle) / self.slope(found)
            if not better.is_finite():
                return found
            better = better.intersection(found)
            if not better.rad() < 0.75 * found.rad():
                return better
            found = better

    def _halve(self) -> None:
        """Halve the interval by signs, down to the last bit, until the slope over it is not zero.

        In rational numbers, for the ends of a ball are rounded, and beyond them may be other zeros.
        """
        least = Fraction(1, 2**flint.ctx.prec)
        while self.high - self.low > least and self.slope(interval(self.low, self.high)).contains(0):
            # In the middle the zero itself may lie.
            for share in (Fraction(1, 2), Fraction(5, 11)):
                cut = self.low + (self.high - self.low) * share
                value = self.function(ball(cut))
                if not value.contains(0):
                    break
            else:
                return
            if bool(value > 0) == self.rising:
                self.high = cut
            else:
                self.low = cut


def _everywhere(piece: arb) -> bool:
    return True


def isolate(
    function: Function,
    slope: Function,
    start: Fraction,
    end: Fraction,
    concerns: Concern = _everywhere,
    bits: int = ISOLATING_BITS,
) -> list[Zero]:
    """Return every zero within start..end, in order, but for those in pieces that do not concern.

    The function is continuous; where it has kinks the ball of its slope holds both sides. Neighbours that
    are undecided are one.
    """
    ends = [start + (end - start) * part / PARTS for part in range(PARTS + 1)]
    found: list[Zero] = []
    with at_bits(bits):
        for low, high in pairwise(ends):
            for zero in _isolated(function, slope, low, high, concerns):
                before = found[-1] if found else zero
                if before is not zero and before.rising is zero.rising is None and before.high == zero.low:
                    before.high = zero.high
                else:
                    found.append(zero)
    return found


def _isolated(
    function: Function, slope: Function, low: Fraction, high: Fraction, concerns: Concern
) -> Iterator[Zero]:
    middle = (low + high) / 2
    whole = interval(low, high)
    if not (concerns(whole) and function(whole).contains(0)):
        return
    steepness = slope(whole)
    # The mean-value form is far narrower than the formula where the interval is short.
    if not (function(ball(middle)) + steepness * (whole - ball(middle))).contains(0):
        return
    if not steepness.contains(0):
        rising = bool(steepness > 0)
        ends = function(ball(low)), function(ball(high))
        falls = ends if rising else (ends[1], ends[0])
        if falls[0] > 0 or falls[1] < 0:
            return
        if falls[0] < 0 and falls[1] > 0:
            yield Zero(function, slope, low, high, rising)
            return
    if high - low < LEAST_WIDTH:
        yield Zero(function, slope, low, high, None)
        return
    yield from _isolated(function, slope, low, middle, concerns)
    yield from _isolated(function, slope, middle, high, concerns)


def between(
    function: Function, slope: Function, start: Place, end: Place, *, proved: bool = False
) -> Iterator[Place]:
    """Yield the zeros of a function over half turns from edge to edge, in order, those at an edge as the
    edge; the function goes on beyond both.

    Where it only touches zero, or comes very near, the place is known to 2e-10 of half a turn; if all are to
    be proved, that raises ProblemError, and none is taken for a round angle.
    """
    with at_bits(SHARP_BITS):
        low, high = fraction(start.half_turns().lower()), fraction(end.half_turns().upper())
    for zero in isolate(function, slope, low - BEFORE, high + BEHIND, bits=SHARP_BITS):
        if proved and zero.rising is None:
            raise unsettled("where a quantity rises and where it falls")
        place = None if proved else _round(zero)
        place = place or Place(zero.place, start.centre)
        before, behind = _compared(place, start), _compared(end, place)
        if not (before and behind):
            yield end if before else start
        elif before > 0 and behind > 0:
            yield place


def _compared(place: Place, other: Place) -> int:
    """Return 1 where a place lies behind another, -1 where before it, 0 where both are taken for one."""
    if place.exact is not None and other.exact is not None:
        return (place.exact > other.exact) - (place.exact < other.exact)
    for bits in (ISOLATING_BITS, EQUAL_BITS):
        with at_bits(bits):
            apart = place.half_turns() - other.half_turns()
            if not apart.contains(0):
                return 1 if apart > 0 else -1
    return 0


def _round(zero: Zero) -> Place | None:
    """Return the quarter of a turn at which, to EQUAL_BITS, the zero lies, None if at none."""
    quarter = Fraction(round((zero.low + zero.high) / 2 * QUARTERS), QUARTERS)
    if not zero.low <= quarter <= zero.high:
        return None
    with at_bits(EQUAL_BITS):
        there = zero.rising is None or zero.function(ball(quarter)).contains(0)
    return Place(lambda: ball(quarter), exact=quarter) if there else None


def greatest(
    candidates: Iterable[Candidate],
    value: Callable[[Candidate], arb],
    sign: int = 1,
    precisions: Iterable[int] = (ISOLATING_BITS, EQUAL_BITS),
) -> list[Candidate]:
    """Return where a value is greatest or, with sign -1, least; several only if they cannot be told apart."""
    left = list(candidates)
    for bits in precisions:
        if len(left) > 1:
            with at_bits(bits):
                values = [sign * value(one) for one in left]
                least = max(one.lower() for one in values)
                left = [one for one, own in zip(left, values, strict=True) if not own.upper() < least]
    return left


class Summit:
    """A function, and what it comes to at least where it is greatest: what lies below concerns no search."""

    def __init__(self, value: Function) -> None:
        self.value, self.least = value, arb("-inf")

    def reach(self, place: arb) -> None:
        """Know the value at a place."""
        self.least = self.least.max(self.value(place).lower())

    def concerns(self, piece: arb) -> bool:
        """Whether the function may be greatest within a piece."""
        self.reach(piece.mid())
        return not self.value(piece) < self.least


def crossing(function: Function, low: Fraction, high: Fraction) -> arb:
    """Return a ball that holds the one zero of a function that rises, as narrow as the precision allows.

    The function is below zero at `low` and above at `high`. Secants: their error is the square of the width,
    where the function is nearly straight; where it is not, halves are found by the sign.
    """
    left, right = ball(low).mid(), ball(high).mid()
    below, above = function(left), function(right)
    while True:
        width, slope = right - left, (above - below) / (right - left)
        guess, rest = left - below / slope, 4 * max(below.rad(), above.rad()) / slope
        margin = width * width / (abs(left) + abs(right)) + rest
        narrow = margin < width / 8
        for place in (guess - margin, guess + margin) if narrow else [(left + right) / 2]:
            at = place.mid()
            if at > left and at < right:
                value = function(at)
                if value > 0:
                    right, above = at, value
                elif value < 0:
                    left, below = at, value
        if rest > margin / 2 or not right - left < width:
            return left.union(right)


def interval(low: Fraction, high: Fraction) -> arb:
    """Return the ball around everything from low to high."""
    return ball(low).union(ball(high))


# Not frozen, which would be half the time of a sum.
@dataclass(slots=True)
class Jet:
    """A value, its slope and its bend, f, f' and f'', all of one kind of number; a bare one is a constant."""

    value: Any
    slope: Any
    bend: Any

    def __add__(self, other: Jet | Numeric) -> Jet:
        if not isinstance(other, Jet):
            return Jet(self.value + other, self.slope, self.bend)
        return Jet(self.value + other.value, self.slope + other.slope, self.bend + other.bend)

    __radd__ = __add__

    def __neg__(self) -> Jet:
        return Jet(-self.value, -self.slope, -self.bend)

    def __sub__(self, other: Jet | Numeric) -> Jet:
        return self.__add__(-other)

    def __rsub__(self, other: Jet | Numeric) -> Jet:
        return (-self).__add__(other)

    def __mul__(self, other: Jet | Numeric) -> Jet:
        if not isinstance(other, Jet):
            return Jet(self.value * other, self.slope * other, self.bend * other)
        return Jet(
            self.value * other.value,
            self.slope * other.value + self.value * other.slope,
            self.bend * other.value + 2 * (self.slope * other.slope) + self.value * other.bend,
        )

    __rmul__ = __mul__

    def __truediv__(self, other: Jet | Numeric) -> Jet:
        if not isinstance(other, Jet):
            return Jet(self.value / other, self.slope / other, self.bend / other)
        value = self.value / other.value
        slope = (self.slope - value * other.slope) / other.value
        return Jet(value, slope, (self.bend - 2 * (slope * other.slope) - value * other.bend) / other.value)

    def __rtruediv__(self, other: Jet | Numeric) -> Jet:
        return Jet(other, 0, 0) / self

    def __pow__(self, exponent: Numeric) -> Jet:
        """Return the power to a number, of a positive value but for whole exponents."""
        if exponent == 0.5:
            return self.sqrt()
        value = self.value**exponent
        rate = exponent * value / self.value
        rise = (exponent - 1) * rate / self.value
        return Jet(value, rate * self.slope, rate * self.bend + rise * self.slope * self.slope)

    def sqrt(self) -> Jet:
        value = self.value**0.5
        slope = self.slope / (2 * value)
        return Jet(value, slope, (self.bend / 2 - slope * slope) / value)

    def __abs__(self) -> Jet:
        """Return the magnitude; about a zero its slope is a ball with both signs, and its bend any number."""
        if not self.value.contains(0):
            return self if self.value > 0 else -self
        slope = arb(self.slope)
        return Jet(abs(self.value), slope.union(-slope), arb(0, "inf"))

    def log(self) -> Jet:
        rate = self.slope / self.value
        return Jet(self.value.log(), rate, self.bend / self.value - rate * rate)

    def asin(self) -> Jet:
        """Return the arc that has this sine, within a right angle."""
        cosine = (1 - self.value * self.value) ** 0.5
        slope = self.slope / cosine
        return Jet(self.value.asin(), slope, (self.bend + self.value * slope * slope) / cosine)


def jets(circle: Circle[Any]) -> Circle[Jet]:
    """Return the circle of an angle with its slopes over the angle in radians."""
    sine, cosine, versine, *_ = circle
    return Circle(Jet(sine, cosine, -sine), Jet(cosine, -sine, -cosine), Jet(versine, sine, cosine))


def ball_jets(half_turns: arb) -> Circle[Jet]:
    """Return the same of an angle in half turns, a ball."""
    return jets(half_turn_circle(half_turns))


def jet_of(value: Jet | Numeric) -> Jet:
    """Return a value with its slopes; what has none is constant."""
    return value if isinstance(value, Jet) else Jet(value, 0, 0)


def slopes(jet: Callable[[arb], Jet | Numeric]) -> tuple[Callable[[arb], arb], Callable[[arb], arb]]:
    """Return the slope and the bend, over half turns, of what has slopes over the angle in radians."""

    def slope(half_turns: arb) -> arb:
        found: arb = jet_of(jet(half_turns)).slope * pi()
        return found

    def bend(half_turns: arb) -> arb:
        found: arb = jet_of(jet(half_turns)).bend * pi() * pi()
        return found

    return slope, bend
