"""Columns of the motion at arrays of angles and ratios at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kurbel.drive.at import At
from kurbel.drive.crank import Crank
from kurbel.exact.bulk import evaluate
from kurbel.exact.kind import floats
from kurbel.motion.evaluation import kernel_of
from kurbel.motion.quantities import registry
from kurbel.page.quantity import Quantity

Floats = NDArray[np.float64]
# The formulas take the ratio from elsewhere.
NO_RATIO = Crank(Fraction(0))


def motion(
    keys: Sequence[str],
    degrees: ArrayLike,
    ratio: ArrayLike,
    method: str = "exact",
    *,
    fast: bool | None = None,
) -> list[Floats]:
    """Return each quantity of the straight crank as an array of the common shape of angles and ratios.

    `keys` are of quantities of which nothing but the ratio need be known, on either stroke; ratios are R:L,
    at least 0 and below 1, and not checked. On all cores, by numba where it is installed and worth it
    (`fast` as in `exact.bulk.evaluate`); the bits are those of `kurbel.compute` at each ratio alone.
    """
    angles, ratios = np.asarray(degrees, np.float64), np.asarray(ratio, np.float64)
    shape = np.broadcast_shapes(angles.shape, ratios.shape)
    columns = [_of_ratio(registry()[key], method) for key in keys]
    inputs = [np.broadcast_to(one, shape).ravel() for one in (angles, ratios)]
    return [row.reshape(shape) for row in evaluate(columns, *inputs, fast=fast)]


def _of_ratio(quantity: Quantity, method: str) -> Callable[[Any, Any], Any]:
    kernel, numbers, stroke = kernel_of(quantity, method, NO_RATIO), floats(), quantity.stroke
    scale = quantity.scale(NO_RATIO, numbers) if quantity.scale else None

    def column(circle: Any, ratio: Any) -> Any:
        # An infinite rod has no ratio, and the return stroke the other sign.
        signed = 0.0 if method == "infinite" else ratio if stroke > 0 else -ratio
        found = kernel(At(circle, NO_RATIO, numbers, stroke, signed, None, method == "series"))
        return found if scale is None else found * scale

    return column
