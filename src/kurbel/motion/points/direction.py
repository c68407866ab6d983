"""The direction of a vector as certified degrees: counted as the crank angle, from 0° to below 360°."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from kurbel.exact.certify import GUARD_BITS, NEVER_TIES, at_bits, ball_degrees, rounded
from kurbel.exact.kind import Kind, balls
from kurbel.exact.numerals import nearest
from kurbel.exact.terms import vanishes
from kurbel.kernel.coupler import Vector, amount

# What makes a vector on a kind of number.
Made = Callable[[Kind], Vector[Any]]
TURN, QUARTER = 360, 90
FIRST_BITS = 2 * GUARD_BITS


def of_floats(vector: Vector[Any]) -> Any:
    """Return the direction of floats or arrays, in degrees; that of no vector is 0."""
    import numpy as np

    return np.degrees(np.arctan2(vector.across, 0.0 - vector.along)) % TURN


def continued(values: Any, amounts: Any) -> Any:
    """Return directions over the crank angle, as floats, without steps by a whole turn; that of no vector is
    no number."""
    import numpy as np

    known = amounts != 0
    found = np.full(np.shape(values), np.nan)
    found[known] = np.unwrap(values[known], period=TURN)
    return found


def reduced(degrees: Fraction, decimals: int, rounding: str) -> int:
    """Return an exact direction times 10**decimals, rounded, within a turn."""
    return nearest(degrees % TURN, decimals, rounding).scaled % _turn(decimals)


def digits(made: Made, decimals: int, rounding: str) -> int | None:
    """Return the direction of a vector times 10**decimals, rounded correctly; None where there is no vector.

    The angle of a vector is no rational number of degrees but at few places, and a tie at none that is known:
    one is not taken for proved (`certify.rounded` then raises ProblemError).
    """
    sector = _sector(made)
    if sector is None:
        return None
    found = rounded(lambda: _in_sector(made(balls()), sector), decimals, rounding, NEVER_TIES)
    return found % _turn(decimals)


def _turn(decimals: int) -> int:
    whole: int = TURN * 10**decimals
    return whole


def _sector(made: Made) -> int | None:
    """Return the quarter, from 0, in whose middle or near it the vector points; None if there is none."""
    precision = GUARD_BITS
    while True:
        precision *= 2
        with at_bits(precision):
            one = made(balls())
            forth, up = -one.along, one.across
            level = abs(forth).mid() >= abs(up).mid()
            strong = forth if level else up
            if not strong.contains(0):
                return (0 if strong > 0 else 2) if level else (1 if strong > 0 else 3)
        if precision == FIRST_BITS and _is_none(made):
            return None


def _is_none(made: Made) -> bool:
    return vanishes(lambda kind: made(kind).along) and vanishes(lambda kind: made(kind).across)


def _in_sector(vector: Vector[Any], sector: int) -> Any:
    """Return the degrees of a vector in its quarter, within 45° of the middle of that or somewhat more."""
    forth, up = -vector.along, vector.across
    aside = (up, -forth, -up, forth)[sector]
    return QUARTER * sector + ball_degrees(aside / amount(vector))
