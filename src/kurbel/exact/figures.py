"""How many decimals print a value to so many figures."""

from __future__ import annotations

from fractions import Fraction
from math import floor, log10

from kurbel.exact.numerals import Number, finite_decimals, nearest

FIGURES = 5


def decimals_of(value: float, figures: int = FIGURES) -> int:
    """Return the decimals that print so many figures of a value, 0 where more stand before the point."""
    # 9.99996 is 10.000 to five figures.
    rounded_off = float(f"{value:.{figures - 1}e}")
    before_point = floor(log10(abs(rounded_off))) + 1 if value else 1
    return max(0, figures - before_point)


def as_given(value: Fraction, decimals: int | None, rounding: str = "half-away") -> Number:
    """Return a rational value to so many decimals, without them as it was given where that is short."""
    if decimals is None:
        exact, decimals = finite_decimals(value), decimals_of(float(value))
        decimals = decimals if exact is None else min(exact, decimals)
    return nearest(value, decimals, rounding)
