"""The greatest value over an interval of crank angles, with proof that no place has a greater one.

About the middle m of a cell a function lies in f(m) + f'(X)(X - m). Cells whose bound is below a value that
is reached are left out, the others are halved; near a maximum both differ by the square of a cell's width.

Of a smooth function the places are found, too. It lies in f(m) + f'(m)(X - m) + f''(X)(X - m)²/2, and a cell
is halved until f' has one sign in it, or f'' is below zero: then it has one maximum, or none but at its ends.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

from kurbel.verify.enclose import WorkingPrecision
from kurbel.verify.jets import Jet
from kurbel.verify.numbers import Number, Undecided, hull, number, pi, spread
from kurbel.verify.zeros import TOO_WIDE, Place, between

CELLS, MOST, WIDEST = 24, 4000, Fraction(10**400)
# How near each other, in degrees, places count as one, and with how many bits values as the same.
NEAR, ALIKE = Fraction(1, 10**12), 160
# A function over the crank angle, or its slope by that in radians.
Sloping = Callable[[Place, int], Number]
# A function with as many slopes.
Smooth = Callable[[Place, int], Jet]


def greatest(function: Sloping, low: Fraction, high: Fraction) -> Number:
    cells = Place((low + high) / 2, (high - low) / 2).parts(CELLS)
    reached, fine, tried = -WIDEST, Fraction(1, 2 ** (WorkingPrecision.bits // 3)), 0
    while tried < MOST:
        bounds: list[tuple[Fraction, Place]] = []
        tried += len(cells)
        for cell in cells:
            try:
                middle = function(Place(cell.degrees), 0)
                around = middle + function(cell, 1) * cell.arc
            except TOO_WIDE:
                bounds.append((WIDEST, cell))
            else:
                reached = max(reached, middle.low)
                bounds.append((around.high, cell))
        bounds = [(bound, cell) for bound, cell in bounds if bound >= reached]
        top = max(bound for bound, _ in bounds)
        if top - reached <= fine * max(abs(reached), fine):
            return spread(reached, top)
        cells = [half for _, cell in bounds for half in cell.parts()]
    raise Undecided("the greatest value")


class Summit(NamedTuple):
    """Where a function may be greatest, in degrees, and its value there."""

    angle: Number
    value: Number


def summits(function: Smooth, low: Fraction, high: Fraction, reached: Fraction = -WIDEST) -> list[Summit]:
    """Return all places between two angles at which a function may be greatest, in order; none where it is
    below what is reached elsewhere."""
    cells, done = Place((low + high) / 2, (high - low) / 2).parts(CELLS), list[tuple[Fraction, Place, Jet]]()
    tried = 0
    while cells and tried < MOST:
        bounds, tried = list[tuple[Fraction, Place, Jet]](), tried + len(cells)
        for cell in cells:
            try:
                over, (value, slope) = function(cell, 2), function(Place(cell.degrees), 1).terms
                around = value + slope * cell.arc + over.terms[2] * (cell.arc * cell.arc)
            except TOO_WIDE:
                bounds.append((WIDEST, cell, Jet([])))
            else:
                reached = max(reached, value.low)
                bounds.append((around.high, cell, over))
        cells = []
        for one in bounds:
            if one[0] >= reached:
                _, *slopes = one[2].terms or (None,)
                is_settled = slopes and (slopes[0].side() is not None or slopes[1].side() == -1)
                done.append(one) if is_settled else cells.extend(one[1].parts())
    if cells:
        raise Undecided("where the greatest value is")
    found = [
        one for bound, cell, over in done if bound >= reached for one in _of(function, cell, over, low, high)
    ]
    return best_of(found)


def best_of(found: Sequence[Summit]) -> list[Summit]:
    """Those that may be the greatest, in order."""
    best = max((value.low for _, value in found), default=-WIDEST)
    return sorted((one for one in found if one.value.high >= best), key=lambda one: float(one.angle))


def _of(function: Smooth, cell: Place, over: Jet, low: Fraction, high: Fraction) -> Iterator[Summit]:
    """The maximum within a cell, or at an end of all. Where a cell's end may be the place, it is as far from
    there at most as f' there is of the least -f''."""
    ends = [function(Place(one), 1) for one in cell.ends]
    rises, falls = ends[0].terms[1], -ends[1].terms[1]
    if rises.low > 0 and falls.low > 0:
        at = between(lambda place: function(place, 1).terms[1], *cell.ends)
        middle = function(Place(at.degrees), 0).value
        yield Summit(at.angle, middle + function(at, 1).terms[1] * at.arc)
    for k, (slope, is_last) in enumerate(((rises, cell.ends[0] == low), (falls, cell.ends[1] == high))):
        if slope.low <= 0 and (is_last or slope.high >= 0):
            up, off = spread(Fraction(0), max(slope.high, Fraction(0))), number(0)
            if up.high:
                off = up / (over.terms[2] * -2) * (180 * (1 - 2 * k)) / pi()
            yield Summit(off + cell.ends[k], ends[k].value + up * cell.half * 2)


def where(found: Sequence[Summit]) -> Number:
    """The place of the greatest value; the first of those that so many bits do not tell apart."""
    first = [one.angle for one in found if one.angle.low - found[0].angle.high < NEAR]
    if len(first) < len(found) and WorkingPrecision.bits < ALIKE:
        raise Undecided("which place has the extreme")
    return hull(first)
