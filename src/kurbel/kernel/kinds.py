"""Functions that floats, arrays and balls have under different names."""

from __future__ import annotations

import math
from typing import Any, TypeAlias

Number: TypeAlias = Any


def logarithm(number: Number) -> Number:
    """Return the natural logarithm of a float, a float64 array or a ball."""
    if isinstance(number, (int, float)):
        return math.log(number)
    if hasattr(number, "log"):
        return number.log()
    import numpy as np

    return np.log(number)


def larger(one: Number, other: Number) -> Number:
    """Return the larger of two numbers of a kind; of balls that overlap, one that holds either."""
    if isinstance(one, (int, float)) and isinstance(other, (int, float)):
        return max(one, other)
    for first, second in ((one, other), (other, one)):
        if hasattr(first, "union"):
            return first.max(second)
    import numpy as np

    return np.maximum(one, other)


def smaller(one: Number, other: Number) -> Number:
    """Return the smaller of two numbers of a kind; of balls that overlap, one that holds either."""
    return -larger(-one, -other)
