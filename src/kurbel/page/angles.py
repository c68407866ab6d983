"""Crank angles and other exact values of an axis as numbers of records."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from kurbel.exact.numerals import Number, finite_decimals, nearest
from kurbel.reading.notation import Progression

# An angle that is no finite decimal, such as 0°20', is given to programs to this many places.
ANGLE_DECIMALS = 15
MOST_ANGLE_DECIMALS = 50


def angle_decimals(angles: Sequence[Fraction]) -> int | None:
    """Return how many decimals write every angle exactly, or None if no number up to 50 of them does."""
    ends = (angles.start, angles.step) if isinstance(angles, Progression) else angles
    counts = [_decimals(angle) for angle in ends]
    known = [count for count in counts if count is not None]
    return max(known) if len(known) == len(counts) else None


def angle_number(angle: Fraction, decimals: int | None) -> Number:
    """Return the angle to the decimals of its column, or to its own where the column has no common ones."""
    if decimals is None:
        decimals = _decimals(angle)
    return nearest(angle, ANGLE_DECIMALS if decimals is None else decimals)


def _decimals(angle: Fraction) -> int | None:
    count = finite_decimals(angle)
    return None if count is None or count > MOST_ANGLE_DECIMALS else count
