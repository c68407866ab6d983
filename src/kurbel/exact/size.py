"""Arithmetic of formulas that anybody may write: how large a number would be is known before it is computed.

Exact numbers double their figures with every product, so that a line of powers asks for more than there is
memory for. All other numbers, such as floats and balls, keep their size, and pass as they are.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from fractions import Fraction
from math import log2
from typing import Any

from kurbel.errors import NotationError
from kurbel.exact.numerals import MOST_FIGURES
from kurbel.exact.separation import Separation

# Numerator and denominator together. A power of so many takes a thousandth of a second.
MOST_BITS = log2(10) * MOST_FIGURES
# Of the logarithms of two such numbers.
_DOUBT = 1e-9


class TooLargeError(NotationError):
    """An exact number that is not computed, for its size."""

    def __init__(self) -> None:
        super().__init__(
            f"a number of more than {MOST_FIGURES} figures would come out, which is not computed;"
            " write it with smaller numbers and powers"
        )


def _bounded(operation: Callable[[Any, Any], Any]) -> Callable[[Any, Any], Any]:
    def apply(first: Any, second: Any) -> Any:
        if isinstance(first, Fraction) and isinstance(second, Fraction):
            size = operation(Separation.rational(first), Separation.rational(second))
            if size.upper + size.lower > MOST_BITS:
                raise TooLargeError
        return operation(first, second)

    return apply


plus, minus, times, over = map(_bounded, (operator.add, operator.sub, operator.mul, operator.truediv))


def power(base: Any, exponent: int) -> Any:
    """Return a whole power."""
    if isinstance(base, Fraction):
        size = Separation.rational(base)
        # An exponent may be beyond all floats.
        if abs(exponent) * Fraction(size.upper + size.lower) > MOST_BITS:
            raise TooLargeError
    return base**exponent


def outgrows(base: Fraction, exponent: int) -> bool:
    """Return whether a power is certainly beyond all numbers of so many bits."""
    size = Separation.rational(base)
    bits = size.upper - size.lower
    grows = (bits > 0) == (exponent > 0)
    return grows and abs(exponent) * Fraction(abs(bits) - _DOUBT) > MOST_BITS
