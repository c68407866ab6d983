"""Loops of numba: the bits of the formulas on arrays, whichever columns, order and block."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from kurbel.exact import bulk
from kurbel.exact.bulk import evaluate
from kurbel.kernel import forces, kinematics, linkage, loops
from kurbel.kernel.circle import circle
from kurbel.kernel.loops import traceable, written
from kurbel.kernel.trace import UntraceableError

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
    lambda point, ratio: -linkage.coupler_place(point).across,
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


def paths(places: NDArray[np.float64], fast: bool) -> NDArray[np.float64]:
    return evaluate([lambda point: kinematics.piston_path(point, 0.25)], places, fast=fast).ravel()


def test_bits_depend_neither_on_the_threads_nor_on_who_else_computes(monkeypatch: pytest.MonkeyPatch) -> None:
    places = np.linspace(0, 360, 700_001)
    monkeypatch.setattr(bulk, "cores", lambda: 1)
    alone = paths(places, fast=True)
    monkeypatch.setattr(bulk, "cores", lambda: 3)
    with ThreadPoolExecutor(4) as pool:
        for found in pool.map(lambda _: paths(places, fast=True), range(4)):
            assert same_bits(found, alone)


def test_arrays_that_cannot_be_written_to_or_lie_apart_are_read() -> None:
    places = np.linspace(0, 360, 1001)
    places.flags.writeable = False
    assert same_bits(paths(places[::2], fast=True), paths(places, fast=False)[::2].copy())


def test_numba_is_taken_once_arrays_have_taken_as_long_as_loading_it(monkeypatch: pytest.MonkeyPatch) -> None:
    sine, cells = (lambda point: point.sine), 60_000
    monkeypatch.setattr(loops, "_done", Counter())
    monkeypatch.setattr(loops, "_is_loaded", lambda: False)
    monkeypatch.setattr(loops, "LOADING", 3 * cells)
    monkeypatch.setattr(loops, "COMPILING", 2 * cells)
    taken = [loops.chosen([sine], 0, cells, None) is not None for _ in range(5)]
    assert taken == [False, False, False, True, True]
    assert loops.chosen([sine], 0, loops.FEWEST - 1, None) is None
    assert loops.chosen([sine], 0, 1, True) is not None
    assert loops.chosen([sine], 0, 10**9, False) is None
    assert [loops.pays("a loop", 1, fast) for fast in (True, False, None)] == [True, False, False]


def broken() -> Any:
    raise ImportError("Numba needs NumPy 2.3 or less")


def old() -> Any:
    return SimpleNamespace(version_info=SimpleNamespace(short=(0, 60)))


def switched_off() -> Any:
    new, config = SimpleNamespace(short=(0, 99)), SimpleNamespace(DISABLE_JIT=1)
    return SimpleNamespace(version_info=new, config=config)


@pytest.mark.parametrize("numba", [broken, old, switched_off])
def test_without_a_numba_that_works_arrays_do_it(
    numba: Callable[[], Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(loops, "_numba", numba)
    monkeypatch.setattr(loops, "installed", loops.installed.__wrapped__)
    places = np.linspace(0, 360, 101)
    assert same_bits(paths(places, fast=True), paths(places, fast=False))


def test_without_a_place_for_the_cache_a_loop_is_compiled_all_the_same(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from numba.core.caching import CacheImpl

    monkeypatch.setattr(CacheImpl, "_locator_classes", [])
    loops.compiled.cache_clear()
    places = np.linspace(0, 360, 101)
    assert same_bits(paths(places, fast=True), paths(places, fast=False))
