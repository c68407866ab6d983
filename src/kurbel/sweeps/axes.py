"""The values of axes in rows: which place each row has on each of them, and what stands there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kurbel.exact.numerals import exact_text
from kurbel.motion.bulk import float_angles
from kurbel.reading.notation import Progression
from kurbel.sweeps.measures import measured
from kurbel.sweeps.plan import Axis, Plan

Places = NDArray[np.int64]


def places_of(plan: Plan, points: Places) -> list[Places]:
    """Return the places of points on each group of axes."""
    found: list[Places] = []
    for size in reversed(plan.sizes):
        points, places = np.divmod(points, size)
        found.append(places)
    return found[::-1]


def coordinates(plan: Plan, points: Places) -> Mapping[str, Any]:
    """Return the values of each axis at these points: an array of floats, or a list of texts."""
    return {
        axis.option: values_at(plan, axis, places)
        for group, places in zip(plan.groups, places_of(plan, points), strict=True)
        for axis in group
    }


def values_at(plan: Plan, axis: Axis, places: Places) -> Any:
    """Return the values of an axis at these places."""
    numbers = measured(plan.asking.parameters[plan.parameter(axis.option)], axis.values)
    if numbers is None:
        return [text_of(axis.values[place]) for place in places.tolist()]
    values, factor, _ = numbers
    first, last = int(places.min()), int(places.max()) + 1
    floats = np.array(_floats(values[first:last]))
    if factor != 1:
        # As one number each, not as a product of two roundings.
        floats = np.array([float(one * factor) for one in values[first:last]])
    return floats[places - first]


def _floats(values: Sequence[Any]) -> Any:
    return float_angles(values) if isinstance(values, Progression) else [float(one) for one in values]


def text_of(value: Any) -> str:
    """Return a value of an axis as text that the command line takes."""
    return (
        str(value) if isinstance(value, str | bool) or not hasattr(value, "numerator") else exact_text(value)
    )
