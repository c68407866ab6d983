"""What drives with loads have at arrays of angles: the same bits by numba, and none of it left to NumPy."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import kurbel
from kurbel.exact.bulk import AngleColumn, evaluate
from kurbel.kernel.loops import traceable
from kurbel.motion.bulk import on_floats

MOVED = {"stroke": "600mm", "speed": "300/min"}
LOADED = MOVED | {
    "force": "10kN",
    "reciprocating": "200kg",
    "rod_mass": "120kg",
    "centre": "0,35",
    "gyration": "0,4",
    "slope": "vertical",
}
FORCES = (
    *("rod_force_n", "guide_force_return_n", "radial_force_n", "crank_pin_force_n", "bearing_force_return_n"),
    *("torque_nm", "crosshead_load_n", "inertia_force_n"),
)
MOTION = ("x_mm", "c_mps", "p_return_mps2", "psi", "rod_acceleration_return_radps2")
DRIVES: list[tuple[Any, dict[str, Any], tuple[str, ...]]] = [
    (kurbel.forces, {"ratio": "1:4", **LOADED}, FORCES),
    (kurbel.forces, {"ratio": "1:4", "offset": "0,3", **LOADED}, FORCES),
    (kurbel.table, {"ratio": "1:3,5", "offset": "-0,2", **MOVED}, MOTION),
    (kurbel.table, {"ratio": "1:4", "acceleration": "50rad/s²", **MOVED}, MOTION),
]


def columns_of(page: Any, given: dict[str, Any], columns: tuple[str, ...]) -> list[Any]:
    question = page.question(**given, columns=columns)
    (crank,) = question.cranks
    assert len(question.page_columns) == len(columns)
    return [on_floats(column, crank) for column in question.page_columns]


@pytest.mark.parametrize(("page", "given", "columns"), DRIVES)
def test_no_column_is_left_to_numpy(page: Any, given: dict[str, Any], columns: Any) -> None:
    for one in columns_of(page, given, columns):
        assert not isinstance(one, AngleColumn)
        assert traceable(one)


@pytest.mark.slow
@pytest.mark.parametrize(("page", "given", "columns"), DRIVES)
def test_every_column_has_the_bits_of_arrays(page: Any, given: dict[str, Any], columns: Any) -> None:
    degrees = np.concatenate([np.linspace(-90, 450, 2161), np.random.default_rng(3).uniform(0, 360, 5000)])
    functions = columns_of(page, given, columns)
    fast, plain = (evaluate(functions, degrees, fast=one) for one in (True, False))
    np.testing.assert_array_equal(fast.view(np.int64), plain.view(np.int64))
