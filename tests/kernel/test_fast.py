"""Loops of numba: the bits of the formulas on arrays, whichever columns, order and block."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from kurbel.exact.bulk import evaluate
from kurbel.kernel import forces, kinematics
from kurbel.kernel.circle import circle
from kurbel.kernel.fast.trace import UntraceableError
from kurbel.kernel.fast.written import traceable, written

RANDOM = np.random.default_rng(1781)

FORMULAS: list[Callable[[Any, Any], Any]] = [
    lambda point, ratio: point.cosine,
    lambda point, ratio: point.versine_tail,
    kinematics.piston_path,
    kinematics.piston_velocity,
    kinematics.piston_acceleration,
    kinematics.rod_acceleration,
    lambda point, ratio: kinematics.offset_path(point, ratio, 0.1),
    forces.rod_force,
    forces.guide_force,
    forces.radial_force,
]


def angles() -> NDArray[np.float64]:
    """Return angles at random and in order, beside and at the quarters, tiny, huge and without a sign."""
    beside = np.add.outer([0, 1e-13, -1e-13, 1e-9, -1e-5], np.arange(-450, 451, 45.0))
    return np.concatenate(
        [
            RANDOM.uniform(-1e6, 1e6, 20_000),
            RANDOM.uniform(0, 360, 20_000),
            np.linspace(0, 360, 20_001),
            10.0 ** -RANDOM.uniform(0, 135, 1_000),
            beside.ravel(),
            [-0.0, 2.0**49 + 0.125],
        ]
    )


def same_bits(one: NDArray[np.float64], other: NDArray[np.float64]) -> bool:
    return bool((one.view(np.int64) == other.view(np.int64)).all())


def test_a_compiled_loop_gives_the_bits_of_arrays() -> None:
    places = angles()
    ratios = RANDOM.uniform(-0.9, 0.9, len(places))
    plain = evaluate(FORMULAS, places, ratios, fast=False)
    for fast, row in zip(evaluate(FORMULAS, places, ratios, fast=True), plain, strict=True):
        assert same_bits(fast, row)


def test_a_formula_that_asks_what_a_number_is_stays_with_arrays() -> None:
    def choosing(point: Any) -> Any:
        return np.where(point.sine < 0, -point.versine, point.versine)

    assert not traceable(choosing)
    with pytest.raises(UntraceableError, match="not known yet"):
        written([choosing])
    places = angles()
    both = evaluate([lambda point: point.sine, choosing], places, fast=True)
    point = circle(places)
    assert same_bits(both[0], point.sine)
    assert same_bits(both[1], choosing(point))


def test_formulas_that_differ_by_a_ratio_are_one_loop() -> None:
    one, other = (written([lambda point, r=r: kinematics.piston_path(point, r)]) for r in (0.2, 0.3))
    assert one.name == other.name
    assert one.constants != other.constants
