"""Zeros with proof: interval Newton."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from kurbel.verify import enclose
from kurbel.verify.jets import Jet
from kurbel.verify.numbers import Number, Undecided, number, spread


def zero(function: Callable[[Jet], Any], guess: Fraction) -> Number:
    """Return an enclosure of the zero near a guess.

    Newton's steps from the guess find a point m; then m - f(m)/f'(X) within X = m ± ε proves that X has
    exactly one zero, and that it lies there (f(m) = f'(ξ)(m - z) with ξ in X by the mean value).
    """
    bits = enclose.Working.bits
    point = guess
    for _ in range(60):
        at = function(Jet([number(point), number(1)]))
        step = at.value / at.slope()
        moved = point - (step.low + step.high) / 2
        point = Fraction(round(moved * 2**bits), 2**bits)
        if max(abs(step.low), abs(step.high)) < Fraction(1, 2 ** (bits - 20)):
            break
    for widening in range(bits - 20, 8, -8):
        reach = Fraction(1, 2**widening)
        wide = Jet([spread(point - reach, point + reach), number(1)])
        try:
            found = number(point) - function(Jet([number(point), number(1)])).value / function(wide).slope()
        except Undecided:
            continue
        if point - reach < found.low and found.high < point + reach:
            return found
    raise Undecided("a zero")
