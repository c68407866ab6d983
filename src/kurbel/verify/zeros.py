"""Zeros with proof: interval Newton."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from kurbel.verify import enclose
from kurbel.verify.jets import Jet
from kurbel.verify.numbers import Number, Undecided, number, pi, spread

# What an enclosure too wide for a cell raises.
TOO_WIDE = (Undecided, ZeroDivisionError, OverflowError, ValueError)


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


def narrowed(
    function: Callable[[Fraction], Number],
    slope: Callable[[Fraction, Fraction], Number],
    middle: Fraction,
    half: Fraction,
) -> tuple[Fraction, Fraction]:
    """Return a point and a reach about it, in degrees, that hold the one zero of a cell.

    Newton's steps within the cell find a point m; m - f(m)/f'(X) within X = m ± ε proves a zero in X.
    """
    bits, point, arc = enclose.Working.bits, middle, 180 / pi()
    low, high = middle - half, middle + half
    for _ in range(80):
        step = function(point) / slope(point, Fraction(1, 2**bits)) * arc
        moved = point - (step.low + step.high) / 2
        moved = Fraction(round(min(max(moved, low), high) * 2**bits), 2**bits)
        near, point = abs(moved - point) < Fraction(1, 2 ** (bits - 24)), moved
        if near:
            break
    for widening in range(bits - 24, 8, -8):
        reach = Fraction(1, 2**widening)
        try:
            off = function(point) / slope(point, reach) * arc
        except TOO_WIDE:
            continue
        bound = max(abs(off.low), abs(off.high))
        if bound < reach and low <= point - reach and point + reach <= high:
            return point, Fraction(int(bound * 2 ** (2 * bits)) + 1, 2 ** (2 * bits))
    raise Undecided("a zero")
