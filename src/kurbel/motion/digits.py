"""Columns of certified digits: a page in balls outright, long columns in floats with their doubtful cells
settled in balls.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import lcm
from typing import TYPE_CHECKING, Any

from kurbel.drive.crank import Crank
from kurbel.exact.certify import floats
from kurbel.motion.evaluation import LOADED, certified, greatest_load, value
from kurbel.page.quantity import Column
from kurbel.reading.notation import Progression

if TYPE_CHECKING:
    import numpy as np

# Below this many cells balls are done before NumPy is imported.
PAGE_CELLS = 20_000
# Floats are worth their while as long as few of them are doubtful.
DOUBTFUL_SHARE = 0.1
# Integers of 64 bits have no more digits.
MOST_DECIMALS = 18


def columns_in_balls(
    columns: Sequence[Column], crank: Crank, angles: Sequence[Fraction], rounding: str
) -> list[list[int]]:
    """Return for each column its values times 10**decimals, rounded correctly, one for each angle.

    Every value is certified by itself: no NumPy, any number of decimals.
    """
    return [[_settled(column, crank, angle, rounding) for angle in angles] for column in columns]


def is_long(columns: Sequence[Column], cranks: Sequence[Crank], angles: Sequence[Fraction]) -> bool:
    """Whether so many cells, to so few decimals, are worth NumPy's start-up: `columns_in_floats`."""
    if len(columns) * len(cranks) * len(angles) <= PAGE_CELLS:
        return False
    if max(column.places for column in columns) > MOST_DECIMALS:
        return False
    reach = float(largest(angles))
    doubtful = (
        2 * float_bound(column, crank, reach) * 10.0**column.places for column in columns for crank in cranks
    )
    return max(doubtful) < DOUBTFUL_SHARE


def largest(angles: Sequence[Fraction]) -> Fraction:
    """Return the greatest magnitude among the angles."""
    ends: Sequence[Fraction] = (angles[0], angles[-1]) if isinstance(angles, Progression) else angles
    return max(map(abs, ends))


def float_bound(column: Column, crank: Crank, largest_angle: float) -> float:
    """Return how far a float of this column can lie from the true value at the exact angle.

    The kernel's own error is a few units in the last place (tests/kernel); rounding λ and the
    angle to floats adds their share times the slope. Powers of 1/(1 - sin² ψ) cover the growth of all of them
    up to the slope of the acceleration as λ nears 1.
    """
    steepest = float(crank.ratio) * (1 + abs(float(crank.offset)))
    growth = (1 - min(steepest, 1 - 1e-12) ** 2) ** -3.5
    unit = 2.0**-53
    in_radians = max(largest_angle, 360.0) / 57
    quantity = column.quantity
    scale = abs(float(quantity.scale(crank, floats()))) if quantity.scale else 1.0
    if quantity.needs in ("force", "torque") and crank.force is not None:
        scale *= float(crank.force.growth)
    if LOADED in quantity.formulas and crank.moving is not None:
        # A force is a sum of few products of these with powers of 1/cos ψ.
        scale *= 8 * float(greatest_load(crank))
    return float((16 + 4 * in_radians) * unit * growth * quantity.bound * scale)


def _settled(column: Column, crank: Crank, angle: Fraction, rounding: str) -> int:
    return certified(column.quantity, column.method, crank, angle, column.places, rounding)


def columns_in_floats(
    columns: Sequence[Column], crank: Crank, angles: Sequence[Fraction], rounding: str
) -> list[np.ndarray]:
    """Return the same as int64 arrays: all values in floats, certified where they are doubtful."""
    from kurbel.exact.bulk import evaluate, nearest

    degrees = float_angles(angles)
    values = evaluate([on_floats(column, crank) for column in columns], degrees)
    reach = float(abs(degrees).max())
    settled = []
    for column, found in zip(columns, values, strict=True):
        bound = float_bound(column, crank, reach)
        scaled, doubtful = nearest(found, column.places, bound, half_even=rounding == "half-even")
        for row in doubtful.nonzero()[0].tolist():
            scaled[row] = _settled(column, crank, angles[row], rounding)
        settled.append(scaled)
    return settled


def on_floats(column: Column, crank: Crank) -> Callable[[Any], Any]:
    """Return the column as a function of the circle of floats or arrays."""
    return lambda circle: value(column.quantity, column.method, crank, circle, floats())


def float_angles(angles: Sequence[Fraction]) -> np.ndarray:
    """Return the angles as floats, each at most one unit in the last place off."""
    import numpy as np

    if isinstance(angles, Progression):
        numerators, denominator = integer_angles(angles)
        if abs(int(numerators[0])) < 2**53 and abs(int(numerators[-1])) < 2**53 and denominator < 2**53:
            return numerators / denominator
    return np.array([float(angle) for angle in angles])


def integer_angles(angles: Progression) -> tuple[np.ndarray, int]:
    """Return the numerators of all angles over one denominator; Python integers where 62 bits are too few."""
    import numpy as np

    denominator = lcm(angles.start.denominator, angles.step.denominator)
    first, step = int(angles.start * denominator), int(angles.step * denominator)
    last = first + step * len(angles)
    kind = np.int64 if max(abs(first), abs(last)) < 2**62 else object
    return first + step * np.arange(len(angles), dtype=kind), denominator
