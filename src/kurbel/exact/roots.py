"""All zeros of a function on an interval, each enclosed with a proof, by interval arithmetic.

A piece of the interval over which the ball of the function excludes zero has none; where the ball of the
slope excludes zero the function is monotone and the signs at the ends decide. What is neither is halved.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

import flint
from flint import arb

from kurbel.exact.certify import ball

Function = Callable[[arb], arb]
# Whether anything within a piece is asked for.
Concern = Callable[[arb], bool]

# What is undecided below this width, 2e-10 of a stroke, is a double zero or lies on a kink or an end.
LEAST_WIDTH = Fraction(1, 2**32)
ISOLATING_BITS = 64
PARTS = 8


class Root(NamedTuple):
    """An interval with one zero, at which the function rises or falls, or exactly that zero.

    `rising` None: possibly none or two; also a zero at an end of the search or where a piece was halved.
    """

    low: Fraction
    high: Fraction
    rising: bool | None = None

    @property
    def is_exact(self) -> bool:
        return self.low == self.high


def _everywhere(piece: arb) -> bool:
    return True


def isolate(
    function: Function, slope: Function, start: Fraction, end: Fraction, concerns: Concern = _everywhere
) -> list[Root]:
    """Return every zero within start..end, in order, but for those in pieces that do not concern.

    The function is continuous; where it has kinks the ball of its slope holds both sides.
    """
    ends = [start + (end - start) * part / PARTS for part in range(PARTS + 1)]
    with flint.ctx.workprec(ISOLATING_BITS):
        return [
            root for low, high in pairwise(ends) for root in _isolated(function, slope, low, high, concerns)
        ]


def _isolated(
    function: Function, slope: Function, low: Fraction, high: Fraction, concerns: Concern
) -> Iterator[Root]:
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
            yield Root(low, high, rising)
            return
    if high - low < LEAST_WIDTH:
        yield Root(low, high, None)
        return
    yield from _isolated(function, slope, low, middle, concerns)
    yield from _isolated(function, slope, middle, high, concerns)


def refined(function: Function, slope: Function, root: Root) -> arb:
    """Return a ball that holds the zero, as narrow as the precision in force allows: interval Newton."""
    found = interval(root.low, root.high)
    if root.rising is None:
        return found
    while True:
        middle = found.mid()
        better = middle - function(middle) / slope(found)
        # Over a steep bend the slope may be anything; there halves are found by the sign.
        narrower = better.is_finite() and better.overlaps(found)
        better = better.intersection(found) if narrower else _half(function, root.rising, found)
        if not better.rad() < 0.75 * found.rad():
            return better
        found = better


def _half(function: Function, rising: bool, found: arb) -> arb:
    """Return the half of the interval in which the function changes its sign."""
    middle = found.mid()
    value = function(middle)
    if value.contains(0):
        return found
    above = bool(value > 0) == rising
    return found.lower().union(middle) if above else middle.union(found.upper())


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
