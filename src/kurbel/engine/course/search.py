"""Where a quantity over segments has a value, and where it is greatest or least, each enclosed with proof.

A quantity is a jet of a segment and a place in it. At an edge it has the limits from both sides, which differ
where it jumps.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import partial
from itertools import pairwise
from typing import NamedTuple

import flint
from flint import arb

from kurbel.engine.course.segments import Segment
from kurbel.engine.turn import EQUAL_BITS
from kurbel.exact.certify import ball, pi
from kurbel.exact.jet import Jet
from kurbel.exact.place import PRECISIONS, Place, fraction, unsettled
from kurbel.exact.roots import ISOLATING_BITS, Function, Root, isolate, refined

Quantity = Callable[[Segment, arb], Jet]

# How far zeros are sought beyond the edges, so that one at an edge is within: shares of half a turn that no
# halving brings to a round angle.
BEFORE, BEHIND = Fraction(5, 11 << 20), Fraction(7, 13 << 20)
# A double zero at an edge, where of some steam both force and slope are zero, leaves four pieces undecided
# with these; with the 64 bits of `isolate` a triple one leaves thousands.
SEARCHING_BITS = 128
# Shares of a segment at which nothing is likely to be zero.
ANYWHERE = (Fraction(3, 17), Fraction(5, 11), Fraction(23, 29))
# Round angles are quarters of a turn.
QUARTERS = 2


class At(NamedTuple):
    """A place in a segment, or the limit at one of its edges."""

    segment: Segment
    place: Place

    def value(self, quantity: Quantity) -> arb:
        """Return the quantity as a ball at the precision in force."""
        value: arb = quantity(self.segment, self.place.half_turns()).value
        return value


class Part(NamedTuple):
    """A part of a segment over which a quantity is above zero, 1, below it, -1, or zero throughout, 0."""

    start: Place
    end: Place
    sign: int


def zeros(segment: Segment, quantity: Quantity, value: Function) -> list[Place]:
    """Return where in a segment the quantity has a value, its edges included.

    A quantity that is constant there has no such place, nor one that only comes near; where it touches the
    value, the place is known to 2e-10 of half a turn.
    """

    def apart(half_turns: arb) -> arb:
        found: arb = quantity(segment, half_turns).value
        return found - value(half_turns)

    def slope(half_turns: arb) -> arb:
        return _steepness(segment, quantity, half_turns)

    return [] if is_level(segment, quantity) else [*_within(segment, apart, slope)]


def stationary(segment: Segment, quantity: Quantity) -> list[Place]:
    """Return where within a segment the slope of the quantity is zero, the edges left out."""

    def slope(half_turns: arb) -> arb:
        return _steepness(segment, quantity, half_turns)

    def bend(half_turns: arb) -> arb:
        found: arb = quantity(segment, half_turns).bend * pi()
        return found * pi()

    edges = (segment.start, segment.end)
    return (
        []
        if is_level(segment, quantity)
        else [place for place in _within(segment, slope, bend) if place not in edges]
    )


def is_level(segment: Segment, quantity: Quantity) -> bool:
    """Whether the quantity is constant over a segment: its slope is zero to EQUAL_BITS at places of no
    meaning, as no smooth formula's is by chance."""
    low, high = _reach(segment)
    with flint.ctx.workprec(2 * EQUAL_BITS):
        slopes = [quantity(segment, ball(low + (high - low) * part)).slope for part in ANYWHERE]
        least = ball(2) ** -EQUAL_BITS
        return all(bool(abs(arb(slope)) < least) for slope in slopes)


def extremes(segments: Sequence[Segment], quantity: Quantity, sign: int = 1) -> list[At]:
    """Return where the quantity is greatest or, with sign -1, least, in order.

    Several only if they cannot be told apart, as on both strokes of the infinite rod.
    """
    left = [
        At(segment, place)
        for segment in segments
        for place in (segment.start, *stationary(segment, quantity), segment.end)
    ]
    for bits in (ISOLATING_BITS, EQUAL_BITS):
        with flint.ctx.workprec(bits):
            values = [sign * one.value(quantity) for one in left]
        least = max(value.lower() for value in values)
        left = [one for one, value in zip(left, values, strict=True) if not value.upper() < least]
    return left


def extreme_value(found: Sequence[At], quantity: Quantity, sign: int = 1) -> arb:
    """Return the value that all of these places may have, a ball at the precision in force."""
    first, *others = (sign * one.value(quantity) for one in found)
    for other in others:
        first = first.max(other)
    return sign * first


def parts(segment: Segment, quantity: Quantity) -> Iterator[Part]:
    """Yield the parts of a segment in order, at each of which the quantity has one sign."""
    inner = zeros(segment, quantity, lambda half_turns: ball(0))
    edges = (segment.start, segment.end)
    places = [segment.start, *(place for place in inner if place not in edges), segment.end]
    for start, end in pairwise(places):
        yield Part(start, end, _sign_between(segment, quantity, start, end))


def _sign_between(segment: Segment, quantity: Quantity, start: Place, end: Place) -> int:
    for bits in PRECISIONS:
        with flint.ctx.workprec(bits):
            middle = ball(fraction(((start.half_turns() + end.half_turns()) / 2).mid()))
            value = quantity(segment, middle).value
            if not value.contains(0):
                return 1 if value > 0 else -1
            if bits > EQUAL_BITS and is_level(segment, quantity):
                return 0
    raise unsettled("which sign a force has")


def _reach(segment: Segment) -> tuple[Fraction, Fraction]:
    """Return the rational ends of what zeros are sought in."""
    with flint.ctx.workprec(ISOLATING_BITS):
        low, high = segment.start.half_turns().lower(), segment.end.half_turns().upper()
    return fraction(low) - BEFORE, fraction(high) + BEHIND


def _within(segment: Segment, function: Function, slope: Function) -> Iterator[Place]:
    """Yield the zeros of a function from edge to edge, in order, those at an edge as the edge."""
    for root in _merged(isolate(_sharper(function), _sharper(slope), *_reach(segment))):
        place = _round(function, root) or Place(partial(refined, function, slope, root))
        if not (before := _compared(place, segment.start)):
            yield segment.start
        elif not (behind := _compared(segment.end, place)):
            yield segment.end
        elif before > 0 and behind > 0:
            yield place


def _steepness(segment: Segment, quantity: Quantity, half_turns: arb) -> arb:
    """Return the slope of a quantity over the half turns."""
    slope: arb = quantity(segment, half_turns).slope * pi()
    return slope


def _sharper(function: Function) -> Function:
    """Return the function with so many bits that near a double or triple zero little remains undecided."""

    def at(half_turns: arb) -> arb:
        with flint.ctx.workprec(SEARCHING_BITS):
            return function(half_turns)

    return at


def _merged(roots: Sequence[Root]) -> list[Root]:
    """Return the roots with neighbouring undecided ones as one."""
    found: list[Root] = []
    for root in roots:
        if root.rising is None and found and found[-1].rising is None and found[-1].high == root.low:
            root = Root(found.pop().low, root.high)
        found.append(root)
    return found


def _compared(place: Place, other: Place) -> int:
    """Return 1 where a place lies behind another, -1 where before it, 0 where both are taken for one."""
    if place.exact is not None and other.exact is not None:
        return (place.exact > other.exact) - (place.exact < other.exact)
    for bits in (ISOLATING_BITS, EQUAL_BITS):
        with flint.ctx.workprec(bits):
            apart = place.half_turns() - other.half_turns()
            if not apart.contains(0):
                return 1 if apart > 0 else -1
    return 0


def _round(function: Function, root: Root) -> Place | None:
    """Return the quarter of a turn at which, to EQUAL_BITS, the one zero lies, None if at none."""
    quarter = Fraction(round((root.low + root.high) / 2 * QUARTERS), QUARTERS)
    if not root.low <= quarter <= root.high:
        return None
    with flint.ctx.workprec(EQUAL_BITS):
        there = root.rising is None or function(ball(quarter)).contains(0)
    return Place(lambda: ball(quarter), exact=quarter) if there else None
