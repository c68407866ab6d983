"""The greatest value over an interval of crank angles, with proof that no place has a greater one.

About the middle m of a cell a function lies in f(m) + f'(X)(X - m). Cells whose bound is below a value that
is reached are left out, the others are halved; near a maximum both differ by the square of a cell's width.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from kurbel.verify.enclose import Working
from kurbel.verify.numbers import Number, Undecided, pi, spread
from kurbel.verify.places import Place
from kurbel.verify.zeros import TOO_WIDE

CELLS, MOST, WIDEST = 24, 4000, Fraction(10**400)
# A function over the crank angle, or its slope by that in radians.
Sloping = Callable[[Place, int], Number]


def greatest(function: Sloping, low: Fraction, high: Fraction) -> Number:
    width = (high - low) / CELLS / 2
    cells = [Place(low + width * (2 * index + 1), width) for index in range(CELLS)]
    reached, fine, tried = -WIDEST, Fraction(1, 2 ** (Working.bits // 3)), 0
    while tried < MOST:
        bounds: list[tuple[Fraction, Place]] = []
        tried += len(cells)
        for cell in cells:
            try:
                middle = function(Place(cell.degrees), 0)
                around = middle + function(cell, 1) * spread(-cell.reach, cell.reach) * pi() / 180
            except TOO_WIDE:
                bounds.append((WIDEST, cell))
            else:
                reached = max(reached, middle.low)
                bounds.append((around.high, cell))
        bounds = [(bound, cell) for bound, cell in bounds if bound >= reached]
        top = max(bound for bound, _ in bounds)
        if top - reached <= fine * max(abs(reached), fine):
            return spread(reached, top)
        cells = [
            Place(cell.degrees + side * cell.reach / 2, cell.reach / 2)
            for _, cell in bounds
            for side in (-1, 1)
        ]
    raise Undecided("the greatest value")
