"""The places at which a function of the crank angle neither rises nor falls, where no algebra tells them.

All zeros of its slope are enclosed by balls (`roots.isolate`); a value that is just reached stays unsettled.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import flint

from kurbel.exact.place import FIRST_BITS, Centre, Place, fraction, unsettled
from kurbel.exact.roots import Function, Root, isolate, refined

# How far beyond the ends zeros are sought, so that no halving cuts at a round angle, and the bits to which a
# zero is told from an end: the infinite rod has both.
BEFORE, BEHIND = Fraction(5, 11 << 20), Fraction(7, 13 << 20)
EQUAL_BITS = 512


def level_places(slope: Function, bend: Function, begin: Place, end: Place) -> Iterator[Place]:
    """Yield, in order, the places between both ends where the slope is zero."""
    with flint.ctx.workprec(FIRST_BITS):
        low, high = fraction(begin.half_turns().lower()), fraction(end.half_turns().upper())
    for root in isolate(slope, bend, low - BEFORE, high + BEHIND):
        if root.rising is None:
            raise unsettled("where a quantity rises and where it falls")
        place = _place(slope, bend, root, begin.centre)
        if _is_between(begin, place, end):
            yield place


def _is_between(begin: Place, place: Place, end: Place) -> bool:
    """Whether a place lies between two others, and not so near to one that it is taken for it."""
    with flint.ctx.workprec(EQUAL_BITS):
        apart = place.half_turns() - begin.half_turns(), end.half_turns() - place.half_turns()
        return all(bool(one > 0) for one in apart)


def _place(slope: Function, bend: Function, root: Root, centre: Centre) -> Place:
    return Place(lambda: refined(slope, bend, root), centre)
