"""The points of a sweep at which its condition holds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kurbel.errors import ProblemError
from kurbel.reading.given import meant
from kurbel.sweeps.axes import values_at
from kurbel.sweeps.columns import key_of
from kurbel.sweeps.measures import exact_at
from kurbel.sweeps.only import Condition
from kurbel.sweeps.plan import Axis, Plan

Places = NDArray[np.int64]
# Combinations of the options in the condition and of those before them: some seconds, some hundred megabytes.
MOST_TRIED = 5 * 10**7
BLOCK = 1 << 20
# The group of options that do not vary.
FIXED = -1


@dataclass(frozen=True)
class Kept:
    """The places on the axes up to the last one of the condition, and how many points each of them has."""

    places: Places
    each: int

    def __len__(self) -> int:
        return len(self.places) * self.each

    def points(self, numbers: Places) -> Places:
        """Return the points on the whole grid by their numbers among those that are left."""
        places, within = np.divmod(numbers, self.each)
        return self.places[places] * self.each + within


def kept_of(plan: Plan) -> Kept:
    """Return the points at which the condition of the plan holds. Raises KurbelError."""
    condition = Condition(plan.only)
    axes = named_axes(plan, condition)
    last = max(group for group, _ in axes.values())
    sizes = plan.sizes[: last + 1]
    count = prod(sizes)
    if count > MOST_TRIED:
        raise ProblemError(
            f"the condition {plan.only} is tried at {count} combinations of the options that it names and of"
            " those before them, and at most 5*10^7 are tried; write these options first"
        )
    found = []
    for start in range(0, count, BLOCK):
        block = np.arange(start, min(start + BLOCK, count))
        found.append(block[_holds(plan, condition, axes, sizes, block)])
    kept = np.concatenate(found)
    if not len(kept):
        raise ProblemError(f"the condition {plan.only} holds at no combination; nothing is left to compute")
    return Kept(kept, prod(plan.sizes[last + 1 :]))


def named_axes(plan: Plan, condition: Condition) -> Mapping[str, tuple[int, Axis]]:
    """Return the axes that a condition names, by their options or columns, each with its group."""
    axes = {axis.option: (place, axis) for place, group in enumerate(plan.groups) for axis in group}
    # What is the same everywhere may be named, too.
    axes |= {name: (FIXED, Axis(name, (_one(given),))) for name, given in plan.given.items()}
    axes |= {key_of(option): found for option, found in axes.items()}
    if not condition.names:
        raise ProblemError(
            f"the condition {plan.only} names no option; choose from {', '.join(sorted(plan.varied))}"
        )
    return {name: axes[meant(name, axes, "option of the sweep")] for name in condition.names}


def _one(given: Any) -> Any:
    """Return the value of an option that may be repeated and was not."""
    return given[0] if isinstance(given, list | tuple) and len(given) == 1 else given


def _holds(
    plan: Plan,
    condition: Condition,
    axes: Mapping[str, tuple[int, Axis]],
    sizes: tuple[int, ...],
    block: Places,
) -> NDArray[np.bool_]:
    places = {
        name: np.zeros_like(block) if place == FIXED else block // prod(sizes[place + 1 :]) % sizes[place]
        for name, (place, _) in axes.items()
    }
    values = {name: values_at(plan, axis, places[name]) for name, (_, axis) in axes.items()}
    floats = {name: np.array(one, object) if isinstance(one, list) else one for name, one in values.items()}

    def exact(row: int) -> Mapping[str, Any]:
        return {name: exact_at(plan, axis, int(places[name][row])) for name, (_, axis) in axes.items()}

    return condition.holds(floats, exact, len(block))
