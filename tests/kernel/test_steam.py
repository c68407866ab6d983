"""Steam over the stroke: pressure, work and cut-off against `kurbel.verify`, in floats, arrays and balls."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp
from numpy.testing import assert_allclose

from kurbel import verify
from kurbel.exact.certify import ball
from kurbel.kernel import forces, steam
from kurbel.kernel.circle import circle
from kurbel.kernel.kinematics import piston_path, piston_path_first_order
from kurbel.kernel.law import Constant, Stroke
from kurbel.kernel.steam import larger, logarithm, smaller
from kurbel.verify import enclose, loads
from kurbel.verify.numbers import number

Kind = Callable[[Fraction], Any]

SHARES = tuple(Fraction(count, 97) for count in (1, 19, 40, 41, 42, 43, 60, 96, 97))
CASES = (
    # Cut-off, back pressure, exponent, clearance.
    (Fraction(3, 7), Fraction(1, 9), Fraction(1), Fraction(0)),
    (Fraction(3, 7), Fraction(2, 9), Fraction(1), Fraction(1, 13)),
    (Fraction(3, 7), Fraction(0), Fraction(13, 10), Fraction(1, 20)),
    (Fraction(1, 50), Fraction(1, 100), Fraction(1, 2), Fraction(3, 10)),
    (Fraction(1, 50), Fraction(1, 100), Fraction(2), Fraction(0)),
    (Fraction(1), Fraction(1, 3), Fraction(1), Fraction(1, 13)),
)
each_case = pytest.mark.parametrize("case", CASES, ids=lambda case: "-".join(map(str, case)))


def expansion(case: tuple[Fraction, ...], of: Kind) -> Any:
    return steam.Expansion(*(of(number) for number in case))


def stroke(case: tuple[Fraction, ...], of: Kind) -> Any:
    numbers = expansion(case, of)
    return Stroke(numbers, Constant(numbers.back))


def true_of(case: tuple[Fraction, ...]) -> loads.Stroke:
    cut_off, back, exponent, clearance = case
    return verify.steam(1 / cut_off, back=back, exponent=exponent, clearance=clearance)()[0]


@each_case
def test_net_pressure_work_and_slope_are_those_of_the_expansion(case: tuple[Fraction, ...]) -> None:
    of_floats = stroke(case, float)
    with enclose.working(140), flint.ctx.workprec(150):
        true = true_of(case)
        for share in SHARES:
            force, work = true.force(number(share)), true.work(number(share))
            assert math.isclose(of_floats.force(float(share)), float(force), rel_tol=0, abs_tol=4e-16)
            assert math.isclose(of_floats.work(float(share)), float(work), rel_tol=1e-14, abs_tol=1e-16)
            found = stroke(case, ball).work(ball(share))
            assert found.overlaps(ball(work.low).union(ball(work.high)))
            assert found.rad() < arb("1e-40")
            if share > case[0]:
                slope = float(true.slope(number(share)))
                assert math.isclose(
                    expansion(case, float).expansion_slope(float(share)), slope, rel_tol=1e-14
                )


@each_case
def test_best_back_pressure_is_the_steam_at_the_end_of_the_stroke(case: tuple[Fraction, ...]) -> None:
    cut_off, _, exponent, clearance = (float(one) for one in case)
    best = steam.best_back(cut_off, exponent, clearance)
    with enclose.working(80):
        end = true_of((case[0], Fraction(0), *case[2:])).force(number(1))
    assert math.isclose(best, float(end), rel_tol=1e-15)
    assert abs(expansion(case, float).pressure(1.0) - best) < 1e-15


FORMULAS = ("pressure", "expansion_slope", "work")


@each_case
@pytest.mark.parametrize("name", FORMULAS)
def test_floats_arrays_and_balls_agree(name: str, case: tuple[Fraction, ...]) -> None:
    formula, of_balls = (getattr(expansion(case, of), name) for of in (float, ball))
    floats = [formula(float(share)) for share in SHARES]
    array = formula(np.array([float(share) for share in SHARES]))
    balls = [float(of_balls(ball(share))) for share in SHARES]
    assert array.shape == (len(SHARES),)
    assert_allclose(array, floats, rtol=1e-14, atol=1e-16)
    assert_allclose(floats, balls, rtol=1e-13, atol=1e-16)


@each_case
def test_ball_over_the_cut_off_holds_both_periods(case: tuple[Fraction, ...]) -> None:
    over = ball(case[0]).union(ball(case[0] * Fraction(3, 2)))
    numbers = stroke(case, ball)
    for share in (case[0], case[0] * Fraction(5, 4), case[0] * Fraction(3, 2)):
        for formula in (numbers.force, numbers.work):
            assert formula(over).contains(formula(ball(share)))


@pytest.mark.parametrize("beside", [Fraction(1, 10**4), Fraction(-1, 10**4), Fraction(1, 10**7)])
def test_exponent_next_to_one_gives_next_to_the_work_of_mariotte(beside: Fraction) -> None:
    at_one = expansion(CASES[1], float)
    next_to_it = at_one._replace(exponent=1 + float(beside))
    # ∂W/∂n stays below (ln growth)²/2 < 1.
    assert abs(next_to_it.work(1.0) - at_one.work(1.0)) < abs(float(beside))


def test_work_is_exact_for_exponents_as_close_to_one_as_the_precision_allows() -> None:
    with flint.ctx.workprec(400):
        at_one = expansion(CASES[1], ball)
        next_to_it = at_one._replace(exponent=1 + ball(Fraction(1, 10**30)))
        difference = abs(next_to_it.work(arb(1)) - at_one.work(arb(1)))
        assert difference < arb("1e-30")
        assert difference > arb("1e-32")


PATHS: dict[str, Any] = {
    "exact": (steam.crank_versine, piston_path),
    "first order": (steam.crank_versine_first_order, piston_path_first_order),
}


@pytest.mark.parametrize("name", PATHS)
@settings(max_examples=100, deadline=None)
@given(degrees=st.floats(0.01, 179.99), ratio=st.floats(-0.95, 0.95))
def test_cut_off_versine_inverts_the_path(name: str, degrees: float, ratio: float) -> None:
    versine_of, path_of = PATHS[name]
    at = circle(degrees)
    # As the ratio nears 1 the versine changes 1/(1 - |λ|) times as fast as the path.
    assert math.isclose(versine_of(path_of(at, ratio), ratio), at.versine, rel_tol=1e-13)


@pytest.mark.parametrize("name", PATHS)
@pytest.mark.parametrize("ratio", [Fraction(0), Fraction(2, 9), Fraction(-2, 9), Fraction(-9, 10)])
def test_cut_off_versine_of_the_whole_stroke_is_two(name: str, ratio: Fraction) -> None:
    versine_of, _ = PATHS[name]
    assert versine_of(2.0, float(ratio)) == pytest.approx(2, rel=1e-15)
    assert versine_of(0.0, float(ratio)) == 0
    assert versine_of(arb(2), ball(ratio)).overlaps(arb(2))


@pytest.mark.parametrize("name", PATHS)
def test_cut_off_versine_takes_arrays(name: str) -> None:
    versine_of, _ = PATHS[name]
    paths = np.array([0.3, 1.1, 1.9])
    assert_allclose(
        versine_of(paths, -0.2), [versine_of(float(path), -0.2) for path in paths], rtol=1e-15, atol=0
    )


def relation_slope(angle: Any, ratio: float, loss: float, gain: float) -> tuple[Any, Any]:
    at = circle(math.degrees(angle))
    half = math.sin(angle / 2), math.cos(angle / 2)
    return steam.weisbach_maximum(half, at, ratio, loss, gain, math.pi)


@settings(max_examples=100, deadline=None)
@given(st.floats(0.1, 3), st.floats(-0.5, 0.5), st.floats(0, 2), st.floats(0.2, 3))
def test_weisbach_relation_and_its_slope(angle: float, ratio: float, loss: float, gain: float) -> None:
    def printed(x: Any) -> Any:
        """π [...] cos α/2 - gain sin α/2, upper sign as printed: r/l is the negative ratio."""
        rod, square = -ratio, mp.sin(x / 2) ** 2
        bracket = 1 + rod * square - loss * square * (1 - rod * mp.cos(x))
        return mp.pi * bracket * mp.cos(x / 2) - gain * mp.sin(x / 2)

    value, slope = relation_slope(angle, ratio, loss, gain)
    assert math.isclose(value, float(printed(mp.mpf(angle))), rel_tol=1e-12, abs_tol=1e-13)
    with mp.workdps(30):
        assert math.isclose(slope, float(mp.diff(printed, mp.mpf(angle))), rel_tol=1e-12, abs_tol=1e-12)


def test_larger_and_smaller_of_each_kind() -> None:
    assert (larger(0.3, 1), smaller(0.3, 1)) == (1, 0.3)
    assert np.asarray(larger(np.array([0.3, 2.0]), 1)).tolist() == [1.0, 2.0]
    assert np.asarray(smaller(0.5, np.array([0.3, 2.0]))).tolist() == [0.3, 0.5]
    assert (larger(arb(3), 1), larger(1, arb(3)), smaller(arb(3), 1)) == (arb(3), arb(3), arb(1))
    wide = arb(0).union(arb(2))
    assert all(ball(larger(wide, arb(1))).contains(value) for value in (1, 2))
    assert all(ball(smaller(wide, arb(1))).contains(value) for value in (0, 1))


def test_logarithm_of_each_kind() -> None:
    assert logarithm(3) == logarithm(3.0) == math.log(3)
    found: Any = logarithm(np.array([3.0, 7.0]))
    assert_allclose(found, [math.log(3), math.log(7)], rtol=1e-15, atol=0)
    of_ball: Any = logarithm(arb(3))
    assert of_ball.overlaps(arb(3).log())
    assert logarithm(np.float64(3)) == pytest.approx(math.log(3), rel=1e-15)


def test_flywheel_keeps_the_irregularity() -> None:
    # ½ J (ω₁² - ω₂²) = ΔW with ω₁, ω₂ = ω (1 ± δ/2), in whole numbers: ΔW = J ω² δ.
    swing = forces.energy_swing(1.5, 700.0)
    inertia = forces.moment_of_inertia(swing, 0.04, 30.0)
    fastest, slowest = 30.0 * 1.02, 30.0 * 0.98
    assert inertia / 2 * (fastest**2 - slowest**2) == pytest.approx(1.5 * 700.0, rel=1e-13)
