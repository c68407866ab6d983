"""Forces of one piston force: the exercise, floats, arrays and balls; tests/verify asks the equilibrium."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from numpy.testing import assert_allclose

from kurbel import certified
from kurbel.exact import certify
from kurbel.kernel import forces
from kurbel.kernel.circle import circle

FORMULAS = {
    "rod": forces.rod_force,
    "guide": forces.guide_force,
    "tangential": forces.tangential_force,
    "radial": forces.radial_force,
}
each_formula = pytest.mark.parametrize("name", FORMULAS)


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    with flint.ctx.workprec(200):
        yield


def test_dead_centres_load_the_shaft_and_nothing_else() -> None:
    for ratio in (0.25, -0.25):
        for degrees, radial in ((0.0, 1), (180.0, -1)):
            values = [formula(circle(degrees), ratio) for formula in FORMULAS.values()]
            assert values == [1, 0, 0, radial]
            assert all(value or math.copysign(1, value) == 1 for value in values), "a zero has a sign"


# The exercise: F_S = F √((r/l)² + 1), F_Q = F r/l, M_K = F r √((r/l)² + 1).


@pytest.mark.parametrize("ratio", [0.75, 0.2, 1 / 4.5, -0.3])
def test_the_square_position_is_that_of_the_exercise(ratio: float) -> None:
    point: Any = forces.square_position(ratio)
    assert_allclose([point.sine**2 + point.cosine**2, point.versine + point.cosine], 1, rtol=1e-15, atol=0)
    exercise = math.sqrt(ratio**2 + 1)
    assert_allclose(float(forces.square_rod_force(ratio)), exercise, rtol=3e-16, atol=0)
    assert_allclose(float(forces.rod_force(point, ratio)), exercise, rtol=1e-15, atol=0)
    assert_allclose(float(forces.tangential_force(point, ratio)), exercise, rtol=1e-15, atol=0)
    assert_allclose(float(forces.guide_force(point, ratio)), ratio, rtol=1e-15, atol=0)
    assert_allclose(float(forces.radial_force(point, ratio)), 0, rtol=0, atol=3e-16)


def test_crank_of_three_and_rod_of_four_make_a_rod_force_of_five_fourths() -> None:
    assert forces.square_rod_force(0.75) == 1.25
    assert_allclose([*map(float, forces.square_position(0.75))], [0.8, 0.6, 0.4, 0, 0], rtol=1e-15, atol=0)


def test_square_position_runs_on_balls() -> None:
    point = forces.square_position(certify.ball(Fraction(3, 7)))
    radial: Any = forces.radial_force(point, certify.ball(Fraction(3, 7)))
    assert radial.contains(0)
    assert abs(radial) < 1e-50


# Kinds of number.

SAMPLED = np.concatenate([np.arange(0, 361, 5.0), np.random.default_rng(5).uniform(0, 360, 300)])
# Least magnitude of which an ulp is meant, bound for |λ| <= 1/3, for |λ| <= 0.99.
BOUNDS = {"rod": (1e-50, 1.5, 3), "guide": (1e-50, 1.5, 3), "tangential": (1, 2, 3), "radial": (1, 2, 5)}


def in_ulp(name: str, ratio: float, offset: float | None, floor: float) -> float:
    """Return the greatest error of the floats, against the same formula in balls."""
    crank = [certify.ball(Fraction(number)) for number in (ratio, offset) if number is not None]
    floats: Any = FORMULAS[name](
        circle(SAMPLED), *(number for number in (ratio, offset) if number is not None)
    )
    worst = 0.0
    for degrees, value in zip(SAMPLED.tolist(), floats.tolist(), strict=True):
        true = FORMULAS[name](certify.ball_circle(Fraction(degrees)), *crank)
        unit = math.ulp(max(abs(float(true)), floor))
        worst = max(worst, float(abs(certify.ball(Fraction(value)) - true)) / unit)
    return worst


@each_formula
@pytest.mark.parametrize("sign", [1, -1])
def test_floats_are_within_their_bound(name: str, sign: int) -> None:
    floor, usual, short = BOUNDS[name]
    for ratio in (1 / 3, 0.2, 1 / 4.5, 0.0123):
        assert in_ulp(name, sign * ratio, None, floor) <= usual
    for ratio in (0.6, 0.9, 0.99):
        assert in_ulp(name, sign * ratio, None, floor) <= short


@each_formula
def test_floats_of_an_offset_crank_are_within_their_bound(name: str) -> None:
    for ratio, offset, bound in ((0.25, 0.9, 3), (-0.2, 1.45, 3), (0.3, 1.9, 12), (-0.55, 0.6, 12)):
        assert in_ulp(name, ratio, offset, 1.0) <= bound


@each_formula
def test_arrays_give_the_bits_of_scalars(name: str) -> None:
    for crank in ((0.2345,), (-0.2345,), (0.2345, 0.67)):
        values = FORMULAS[name](circle(SAMPLED), *crank)
        np.testing.assert_array_equal(
            values, [FORMULAS[name](circle(degrees), *crank) for degrees in SAMPLED.tolist()]
        )


def test_an_infinite_rod_hands_on_the_piston_force() -> None:
    point = circle(SAMPLED)
    np.testing.assert_array_equal(forces.rod_force(point, 0.0), 1)
    np.testing.assert_array_equal(forces.guide_force(point, 0.0), 0)
    np.testing.assert_array_equal(forces.tangential_force(point, 0.0), point.sine)
    np.testing.assert_array_equal(forces.radial_force(point, 0.0), point.cosine)


# At 90° and λ = 3/5 cos ψ is 4/5 and tan ψ is 3/4; with the offset 1/5 and λ = 3/4 likewise.
@pytest.mark.parametrize(
    ("key", "offset", "away", "even"),
    [
        ("rod_force", "0", "1.3", "1.2"), ("rod_force_return", "0", "1.3", "1.2"),
        ("guide_force_return", "0", "-0.8", "-0.8"), ("radial_force", "0", "-0.8", "-0.8"),
        ("rod_force", "1/5", "1.3", "1.2"), ("guide_force", "1/5", "0.8", "0.8"),
    ],
)  # fmt: skip
def test_ties_are_proved(key: str, offset: str, away: str, even: str) -> None:
    ratio = "3:5" if offset == "0" else "3:4"
    for rounding, shown in (("half-away", away), ("half-even", even)):
        assert str(certified(key, ratio, 90, digits=1, offset=offset, rounding=rounding)) == shown
