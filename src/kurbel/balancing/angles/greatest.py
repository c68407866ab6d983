"""Where a free force or moment is greatest over the turn, with proof.

Its square is greatest where it has no slope and bends downwards: all such places are enclosed, but for those
in parts of the turn over which it is proved to be below what it reaches elsewhere.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

import flint
from flint import arb

from kurbel.balancing.angles.curve import Curve
from kurbel.errors import ProblemError
from kurbel.exact import search
from kurbel.exact.certify import at_bits, ball
from kurbel.exact.search import SHARP_BITS, Summit, Zero, isolate

# No part of the turn ends at an angle at which an engine is greatest.
START = Fraction(1_234_567, 10**8)
PARTS = 48
MOST_PARTS = 6_000
# So many angles are asked for again while a part of the turn is looked at.
KEPT = 8


class Greatest(NamedTuple):
    """The zero of the slope at which it is greatest, the first where there are several alike."""

    curve: Curve
    zero: Zero

    def place(self) -> arb:
        """Return the angle in half turns, at the precision in force."""
        return self.zero.place()

    def length(self) -> arb:
        return self.curve.square(self.place())[0].sqrt()


class _Squares:
    """The square over half turns with its slopes."""

    def __init__(self, curve: Curve) -> None:
        self._at = lru_cache(KEPT)(lambda place, bits: curve.square(arb(*place)))

    def _term(self, half_turns: arb, order: int) -> arb:
        found: arb = self._at((half_turns.mid().man_exp(), half_turns.rad().man_exp()), flint.ctx.prec)[order]
        return found

    def value(self, half_turns: arb) -> arb:
        """Return the square, over an interval as narrow as the mean-value form is."""
        middle = half_turns.mid()
        away = self.slope(half_turns) * (half_turns - middle)
        return self._term(half_turns, 0).intersection(self._term(middle, 0) + away)

    def slope(self, half_turns: arb) -> arb:
        return self._term(half_turns, 1)

    def bend(self, half_turns: arb) -> arb:
        return 2 * self._term(half_turns, 2)


def greatest(curve: Curve) -> Greatest:
    """Return the greatest value of a curve that does not vanish and is no circle.

    Raises ProblemError where it is not found within MOST_PARTS parts.
    """
    squares = _Squares(curve)
    summit, parts = Summit(squares.value), iter(range(MOST_PARTS))

    def concerns(part: arb) -> bool:
        if next(parts, None) is None:
            raise _not_found()
        return summit.concerns(part)

    with at_bits(SHARP_BITS):
        for part in range(PARTS):
            summit.reach(ball(START + Fraction(2 * part + 1, PARTS)))
    found = isolate(squares.slope, squares.bend, START, START + 2, concerns, SHARP_BITS)
    if any(zero.rising is None for zero in found):
        raise _not_found()
    tops = [Greatest(curve, zero) for zero in found if not zero.rising]
    return min(search.greatest(tops, Greatest.length), key=_degrees)


def _degrees(one: Greatest) -> float:
    return float(one.place().mid()) * 180 % 360


def _not_found() -> ProblemError:
    return ProblemError(
        "the greatest of all orders together is not found: it is too small beside the forces of the"
        " cylinders, or nearly the same all around; take --method series, or look at the orders"
    )
