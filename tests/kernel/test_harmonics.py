"""Harmonics against Fourier integrals of kurbel.verify's motion, and the sums against the motion itself."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp
from numpy.testing import assert_allclose
from pace import within

from kurbel import verify
from kurbel.balancing.harmonics import HARMONICS, MOST_ORDERS, certified, rational, series
from kurbel.drive.crank import Crank
from kurbel.exact import certify
from kurbel.kernel import kinematics
from kurbel.kernel.circle import circle
from kurbel.kernel.harmonics import path_coefficient, path_series

KEYS = ("x", "c", "p")
BITS = 250
STEPS = 200
"""The integrals are sums of so many values: their error is e^(-a (STEPS - k)) with cosh a = 1/λ, 10^-36 at
λ = 0.9 and k = 20."""


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    with mp.workprec(BITS):
        yield


def real(ratio: Fraction) -> Any:
    return mp.mpf(ratio.numerator) / ratio.denominator


@pytest.mark.parametrize("key", KEYS)
@pytest.mark.parametrize("ratio", [Fraction(7, 100), Fraction(9, 10)], ids=str)
def test_coefficients_are_the_fourier_integrals_of_the_motion(key: str, ratio: Fraction) -> None:
    drive, half = verify.drive(ratio), STEPS // 2
    # The other half of the turn is its mirror image.
    values = [real(drive.value(key, Fraction(180 * step, half)).near(130)) for step in range(half + 1)]
    wave, sign = (mp.sin, -1) if key == "c" else (mp.cos, 1)
    turn = [*values, *(sign * value for value in values[-2:0:-1])]
    for order in range(21):
        waves = (value * wave(2 * mp.pi * order * step / STEPS) for step, value in enumerate(turn))
        coefficient = mp.fsum(waves) * (2 if order else 1) / STEPS
        found = certified(HARMONICS[key], order, Crank(ratio), 30).scaled
        assert found == int(mp.nint(coefficient * 10**30)), order


@pytest.mark.parametrize("key", KEYS)
@pytest.mark.parametrize("sign", [1, -1], ids=["outstroke", "return"])
@pytest.mark.parametrize("ratio", [0.0, 1e-7, 0.21, 0.5, 0.8])
def test_sums_converge_to_the_motion(key: str, sign: int, ratio: float) -> None:
    formula = {
        "x": kinematics.piston_path,
        "c": kinematics.piston_velocity,
        "p": kinematics.piston_acceleration,
    }
    degrees = np.linspace(0.0, 360.0, 97)
    wave = np.sin if HARMONICS[key].wave == "sin" else np.cos
    total = sum(
        HARMONICS[key].value(order, sign * ratio) * wave(order * np.radians(degrees)) for order in range(101)
    )
    motion: Any = formula[key](circle(degrees), sign * ratio)
    assert_allclose(total, motion, rtol=0, atol=1e-12)


@settings(max_examples=60, deadline=None)
@given(ratio=st.floats(-0.999, 0.999).filter(lambda ratio: abs(ratio) > 1e-12), order=st.integers(0, 100))
def test_floats_are_close_to_balls(ratio: float, order: int) -> None:
    with flint.ctx.workprec(300):
        true: Any = path_coefficient(order, certify.ball(Fraction(ratio)))
        assert true.rel_accuracy_bits() > 150 or not true
        assert_allclose(float(path_coefficient(order, ratio)), float(true), rtol=1e-12, atol=1e-300)


@pytest.mark.parametrize("order", [2, 4, 20, 100])
def test_a_rod_as_long_as_the_crank_is_the_limit(order: int) -> None:
    # cos ψ is then |cos φ|, whose coefficient of cos 2mφ is (-1)^(m + 1) 4/π/(4m² - 1).
    half = order // 2
    limit = (-1) ** half * 4 / mp.pi / (4 * half**2 - 1)
    with within(30):
        scaled = certified(HARMONICS["x"], order, Crank(1 - Fraction(1, 10**40)), 30).scaled
    assert abs(scaled - limit * 10**30) < 10**15


@pytest.mark.parametrize("ratio", [Fraction(1, 10**9), Fraction(1, 5), Fraction(999, 1000)])
def test_mean_path_is_an_elliptic_integral(ratio: Fraction) -> None:
    lam = real(ratio)
    expected = 1 + (1 - 2 * mp.ellipe(lam**2) / mp.pi) / lam
    assert certified(HARMONICS["x"], 0, Crank(ratio), 40).scaled == int(mp.nint(expected * 10**40))


@pytest.mark.parametrize("half", [1, 2, 7, 30])
def test_even_orders_follow_from_two_of_them(half: int) -> None:
    ratio = Fraction(3, 4)
    before, this, after = (
        real(Fraction(certified(HARMONICS["x"], 2 * m, Crank(ratio), 60).scaled, 10**60))
        for m in (half - 1, half, half + 1)
    )
    if half == 1:
        before = -4 * mp.ellipe(real(ratio**2)) / mp.pi / real(ratio)
    step = 4 * half * (1 - 2 / real(ratio**2)) * this
    assert abs((2 * half + 3) * after + (2 * half - 3) * before - step) < mp.mpf(10) ** -55


@pytest.mark.parametrize(
    ("key", "order", "count", "printed"),
    [
        ("p", 1, 3, "1 λ^0"),
        ("p", 2, 3, "1 λ^1 + 1/4 λ^3 + 15/128 λ^5"),
        ("p", 4, 2, "-1/4 λ^3 + -3/16 λ^5"),
        ("p", 6, 1, "9/128 λ^5"),
        ("p", 0, 3, ""),
        ("p", 5, 3, ""),
        ("x", 0, 2, "1 λ^0 + 1/4 λ^1"),
        ("x", 0, 1, "1 λ^0"),
        ("x", 1, 2, "-1 λ^0"),
        ("c", 2, 1, "1/2 λ^1"),
    ],
)
def test_first_powers_of_the_ratio_are_those_of_the_books(
    key: str, order: int, count: int, printed: str
) -> None:
    terms = series(HARMONICS[key], order, count)
    assert " + ".join(f"{one.coefficient} λ^{one.power}" for one in terms) == printed


@settings(max_examples=60, deadline=None)
@given(
    key=st.sampled_from(KEYS),
    ratio=st.fractions(Fraction(1, 1000), Fraction(1, 4), max_denominator=1000),
    order=st.integers(0, 30),
)
def test_powers_of_the_ratio_add_up_to_the_coefficient(key: str, ratio: Fraction, order: int) -> None:
    terms = series(HARMONICS[key], order, 30)
    total = sum((one.coefficient * ratio**one.power for one in terms), Fraction(0))
    # Sixty powers of λ² <= 1/16 later; the factor is at most k² = 900.
    scaled = certified(HARMONICS[key], order, Crank(ratio), 40).scaled
    assert abs(total * 10**40 - scaled) < Fraction(1, 2) + 2 * 900 * Fraction(10**40, 16**30)


@pytest.mark.parametrize("order", [0, 2, 4, 40])
def test_terms_of_a_power_series_have_one_sign(order: int) -> None:
    # On this rests that no coefficient of even order is 0 and hence that none ties.
    signs = {one.coefficient > 0 for one in path_series(order, 50) if one.power}
    assert len(signs) == 1


@pytest.mark.parametrize("decimals", [0, 30])
@pytest.mark.parametrize("ratio", [Fraction(0), Fraction(1, 5), 1 - Fraction(1, 10**30)])
def test_what_no_rod_changes_is_exact(ratio: Fraction, decimals: int) -> None:
    crank, one = Crank(ratio), 10**decimals
    for key, first in (("x", -one), ("c", one), ("p", one)):
        assert certified(HARMONICS[key], 1, crank, decimals).scaled == first
        for order in (3, 5, 99):
            assert certified(HARMONICS[key], order, crank, decimals).scaled == 0
    for key in ("c", "p"):
        assert certified(HARMONICS[key], 0, crank, decimals).scaled == 0
        assert str(HARMONICS[key].value(0, 0.5)) == "0.0"


@pytest.mark.parametrize("crank", [Crank(Fraction(0)), Crank(Fraction(1, 3))])
def test_an_infinite_rod_leaves_the_first_order_alone(crank: Crank) -> None:
    values = [rational(HARMONICS["p"], order, crank, "infinite") for order in range(8)]
    assert values == [0, 1, 0, 0, 0, 0, 0, 0]
    assert rational(HARMONICS["x"], 0, crank, "infinite") == 1
    if not crank.ratio:
        assert certified(HARMONICS["x"], 0, crank, 3).scaled == 1000


def test_first_order_formulas_have_two_harmonics() -> None:
    crank = Crank(Fraction(1, 8))
    values = [rational(HARMONICS["p"], order, crank, "series") for order in range(7)]
    assert values == [0, 1, Fraction(1, 8), 0, 0, 0, 0]
    assert rational(HARMONICS["c"], 2, crank, "series") == Fraction(1, 16)
    path = [rational(HARMONICS["x"], order, crank, "series") for order in range(5)]
    assert path == [1 + Fraction(1, 32), -1, -Fraction(1, 32), 0, 0]
    assert rational(HARMONICS["p"], 2, crank) is None


def test_a_tie_of_the_first_order_is_rounded_as_asked() -> None:
    crank, acceleration = Crank(Fraction(1, 8)), HARMONICS["p"]
    assert certified(acceleration, 2, crank, 2, "series").scaled == 13
    assert certified(acceleration, 2, crank, 2, "series", "half-even").scaled == 12
    assert certified(acceleration, 2, crank, 2, rounding="half-even").scaled == 13


def test_fifty_digits_of_a_hundred_orders_take_no_time() -> None:
    with within(30):
        for ratio in (Fraction(1, 5), Fraction(999, 1000)):
            for order in range(MOST_ORDERS + 1):
                certified(HARMONICS["p"], order, Crank(ratio), 50)
