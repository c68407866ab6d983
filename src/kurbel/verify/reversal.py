"""The load along a rod over the cycle of an engine: its extremes, and over which angles it has which sign.

From one dead centre or corner of a pressure to the next it is smooth; at a dead centre both sides count.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cache, cached_property, partial
from itertools import groupby, pairwise

from kurbel.verify.crank import Crank
from kurbel.verify.enclose import by_bits
from kurbel.verify.extremes import Smooth, Summit, best_of, summits
from kurbel.verify.jets import Jet
from kurbel.verify.numbers import Number, largest, number, spread
from kurbel.verify.zeros import Place, around, between, told_apart

THRUST, PULL = 1, -1
# So near a dead centre or corner, in degrees, at which it may be zero, the load has the sign of what is next.
NEAR = Fraction(1, 2**30)


class RodLoad:
    """With the precision in force; a thrust is above 0. The load on a part of the cycle is that of its stroke
    and its pressures, which are those at its middle."""

    def __init__(self, crank: Crank, load: Callable[[Place, Place, int], Jet]) -> None:
        self.parts: list[tuple[Smooth, Number, Number]] = []
        for begin, end in pairwise(crank.breaks):
            if begin.high < end.low:
                middle = Place((begin.high + end.low) / 2)
                self.parts.append((cache(partial(load, middle)), begin, end))

    @by_bits
    def greatest(self, sign: int) -> list[Summit]:
        """The places at which thrust or pull may be greatest, in order."""

        def signed(load: Smooth, at: Place, order: int) -> Jet:
            return load(at, order) * sign

        found = [
            Summit(one, signed(load, around(one), 0).value) for load, *ends in self.parts for one in ends
        ]
        for load, begin, end in self.parts:
            reached = max(one.value.low for one in found)
            found += summits(partial(signed, load), begin.high, end.low, reached)
        return best_of(found)

    @cached_property
    def spans(self) -> list[tuple[int, Number]]:
        """The signs in order, and over how many degrees the load has each; of neighbours they differ."""
        found = [one for part in self.parts for one in _signs(*part)]
        runs = groupby(found, lambda one: one[0])
        return [(sign, sum((one for _, one in run), number(0))) for sign, run in runs]

    def over(self, sign: int) -> Number:
        return sum((length for own, length in self.spans if own == sign), number(0))

    def unbroken(self, sign: int) -> Number:
        """The longest of these spans; the cycle goes on where it began."""
        spans = self.spans
        if len(spans) > 1 and spans[0][0] == spans[-1][0]:
            spans = [*spans[1:-1], (spans[0][0], spans[0][1] + spans[-1][1])]
        return largest([number(0), *(length for own, length in spans if own == sign)])

    def least(self, of: Callable[[int], Number]) -> Number:
        """The lesser of what thrust and pull have."""
        return -largest([-of(THRUST), -of(PULL)])

    def size(self, sign: int) -> Number:
        return largest([number(0), largest([one.value for one in self.greatest(sign)])])


def _signs(load: Smooth, begin: Number, end: Number) -> Iterator[tuple[int, Number]]:
    def value(at: Place, slope: int) -> Number:
        return load(at, slope).terms[slope]

    low, high = begin.high + NEAR, end.low - NEAR
    whole = Place((low + high) / 2, (high - low) / 2)
    if load(Place(whole.degrees), 1).is_zero:
        yield 0, end - begin
        return
    cells = sorted(told_apart(value, [whole]))
    zeros = [between(lambda at: value(at, 0), *cell.ends).angle for cell, _ in cells]
    for one, other in pairwise((number(low), *zeros, number(high))):
        middle = value(Place((one.high + other.low) / 2), 0)
        yield middle.sign(), other - one + spread(-2 * NEAR, 2 * NEAR)
