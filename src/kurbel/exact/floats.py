"""Floats rounded to scaled integers, with a mask of those that are in doubt."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Integers: TypeAlias = NDArray[np.int64]

# 2**-53 is the rounding of a product, relative to it; a little more covers the rounding of the test itself.
PRODUCT_ERROR = 1.2e-16
LARGEST = 2.0**52


def nearest(
    values: NDArray[np.float64],
    decimals: int,
    bound: float | NDArray[np.float64],
    half_even: bool = False,
) -> tuple[Integers, NDArray[np.bool_]]:
    """Return values * 10**decimals rounded to the nearest integer, and where that is doubtful.

    Every value lies within `bound` of the true one. Where the mask is False the integer is certainly the
    true value rounded; where it is True a rounding boundary lies within reach, and the integer is that of
    the float (half away from zero, or half to even). Beyond 2**52, where floats have no halves, and for
    infinities and NaN the integer is 0 and doubtful. decimals: 0 to 18.
    """
    scale = float(10**decimals)
    with np.errstate(over="ignore"):
        product = values * scale
    magnitude = np.abs(product)
    beyond = ~(magnitude < LARGEST)
    if beyond.any():
        product[beyond] = magnitude[beyond] = 0
    rounded = np.rint(product)
    # How far the half-integers are: exact, both numbers being multiples of the product's last place.
    distance = np.abs(product - rounded)
    np.subtract(0.5, distance, out=distance)
    magnitude *= PRODUCT_ERROR
    magnitude += np.multiply(bound, scale * (1 + 1e-15))
    doubtful = ~(distance > magnitude)
    doubtful |= beyond
    if not half_even:
        ties = np.flatnonzero(doubtful)
        ties = ties[distance.flat[ties] == 0]
        rounded.flat[ties] = product.flat[ties] + np.copysign(0.5, product.flat[ties])
    return rounded.astype(np.int64), doubtful
