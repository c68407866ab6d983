"""The greatest value over an interval of crank angles, with proof that no place has a greater one.

About the middle m of a cell a function lies in f(m) + f'(X)(X - m). Cells whose bound is below a value that
is reached are left out, the others are halved; near a maximum both differ by the square of a cell's width.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from kurbel.verify.enclose import Working
from kurbel.verify.numbers import Number, Undecided, spread
from kurbel.verify.zeros import TOO_WIDE, Place

CELLS, MOST, WIDEST = 24, 4000, Fraction(10**400)
# A function over the crank angle, or its slope by that in radians.
Sloping = Callable[[Place, int], Number]


def greatest(function: Sloping, low: Fraction, high: Fraction) -> Number:
    cells = Place((low + high) / 2, (high - low) / 2).parts(CELLS)
    reached, fine, tried = -WIDEST, Fraction(1, 2 ** (Working.bits // 3)), 0
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
