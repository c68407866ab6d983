"""The values of axes in rows: which place each row has on each of them, and what stands there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kurbel.motion.bulk import float_angles
from kurbel.reading.notation import Progression
from kurbel.sweeps.measures import measured
from kurbel.sweeps.plan import Axis, Plan, text_of
from kurbel.sweeps.ways.way import Points

Places = NDArray[np.int64]
# Shorter runs of equal values cost more than a division.
LEAST_RUN = 64


@dataclass(frozen=True)
class Coordinates:
    """The axes of a plan, as columns have them: in units by their options, or in those of the SI."""

    plan: Plan
    units: Mapping[str, str] = field(default_factory=dict)

    def at(self, points: Points) -> Mapping[str, Any]:
        """Return the values of each axis at these points: an array of floats, or a list of texts."""
        last = len(self.plan.groups) - 1
        found: dict[str, Any] = {}
        repeated, places = 1, points.places
        for number in range(last, -1, -1):
            group, size = self.plan.groups[number], self.plan.sizes[number]
            runs = points.first is not None and repeated >= LEAST_RUN
            if runs and points.first is not None:
                for axis in group:
                    found[axis.option] = self._in_runs(axis, points.first, len(points), repeated)
            else:
                own = (places // repeated) % size if repeated > 1 else places % size
                for axis in group:
                    found[axis.option] = self.along(axis, own)
            repeated *= size
        return found

    def along(self, axis: Axis, places: Places) -> Any:
        """Return the values at places of an axis: an array of floats, or a list of texts."""
        return self._known[axis.option].at(places)

    def _in_runs(self, axis: Axis, start: int, count: int, repeated: int) -> Any:
        """Return the values of an axis on which so many rows stand at each place."""
        first, last = start // repeated, (start + count - 1) // repeated + 1
        places = np.arange(first, last) % len(axis.values)
        lengths = np.full(last - first, repeated)
        lengths[0] -= start - first * repeated
        lengths[-1] -= last * repeated - (start + count)
        values = self.along(axis, places)
        if isinstance(values, list):
            return np.repeat(np.array(values, object), lengths).tolist()
        return np.repeat(values, lengths)

    @cached_property
    def _known(self) -> Mapping[str, _Values]:
        axes = [axis for group in self.plan.groups for axis in group]
        return {axis.option: _Values.of(self.plan, axis, self.units.get(axis.option, "")) for axis in axes}


def values_at(plan: Plan, axis: Axis, places: Places, unit: str = "") -> Any:
    """Return the values of an axis at these places, in this unit or that of the SI: an array of floats, or a
    list of texts."""
    return _Values.of(plan, axis, unit).at(places)


@dataclass(frozen=True)
class _Values:
    """The values of an axis: of a range they are made where they are wanted."""

    # A range, or an array of floats; None of texts.
    numbers: Any
    factor: Any
    texts: Sequence[Any]

    @classmethod
    def of(cls, plan: Plan, axis: Axis, unit: str) -> _Values:
        found = measured(plan.asking.parameters[plan.parameter(axis.option)], axis.values, unit)
        if found is None:
            return cls(None, 1, axis.values)
        numbers, factor, _ = found
        if isinstance(numbers, Progression):
            return cls(numbers, factor, ())
        exact = numbers if factor == 1 else [one * factor for one in numbers]
        return cls(np.array([float(one) for one in exact]), factor, ())

    def at(self, places: Places) -> Any:
        """Return the values at these places."""
        if self.numbers is None:
            return [text_of(self.texts[place]) for place in places.tolist()]
        if not isinstance(self.numbers, Progression):
            return self.numbers[places]
        first, last = int(places.min()), int(places.max()) + 1
        within = self.numbers[first:last]
        if self.factor != 1:
            # One number each, not the product of two roundings.
            return np.array([float(one * self.factor) for one in within])[places - first]
        return float_angles(within)[places - first]
