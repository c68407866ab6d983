"""The motion by powers of λ against Taylor's coefficients of the exact path, by mpmath, and their slopes."""

from __future__ import annotations

from fractions import Fraction
from random import Random
from typing import Any

import numpy as np
import pytest
from mpmath import mp
from numpy.testing import assert_allclose

from kurbel import KurbelError, certified, compute, table, typeset

Real = Any


def real(number: Fraction) -> Real:
    return mp.mpf(number.numerator) / number.denominator


def path(angle: Real, ratio: Real) -> Real:
    """The crosshead from the triangle of crank and rod, with the rod's versine as a quotient for λ = 0."""
    across = mp.sin(angle) ** 2
    return 1 - mp.cos(angle) + ratio * across / (1 + mp.sqrt(1 - ratio**2 * across))


def truncated(angle: Real, ratio: Real, order: int) -> Real:
    """Return the path with all powers of λ up to one."""
    powers = mp.taylor(lambda one: path(angle, one), 0, order)
    return mp.fsum(power * ratio**exponent for exponent, power in enumerate(powers))


@pytest.mark.parametrize("order", range(1, 10))
def test_path_and_its_slopes_are_those_of_taylors_polynomial(order: int) -> None:
    random = Random(order)
    ratio, degrees = Fraction(random.randint(101, 700), 1009), Fraction(random.randint(1, 35_999), 100)
    with mp.workdps(60):
        angle = real(degrees) * mp.pi / 180
        for slopes, key in enumerate(("x", "c", "p")):
            true = mp.diff(lambda one: truncated(one, real(ratio), order), angle, slopes)
            found = certified(key, ratio, degrees, digits=20, method="series", order=order)
            assert abs(real(Fraction(found)) - true) < mp.mpf("0.51e-20"), key


@pytest.mark.parametrize("order", [1, 4, 7])
def test_the_rod_turns_by_taylors_polynomial_of_its_angle(order: int) -> None:
    def angle(at: Real, ratio: Real) -> Real:
        powers = mp.taylor(lambda one: mp.asin(one * mp.sin(at)), 0, order)
        return mp.fsum(power * ratio**exponent for exponent, power in enumerate(powers))

    with mp.workdps(60):
        at = mp.mpf("71.3") * mp.pi / 180
        for slopes, key in enumerate(("rod_velocity", "rod_acceleration"), 1):
            true = mp.diff(lambda one: angle(one, mp.mpf(3) / 7), at, slopes)
            found = certified(key, "3:7", "71.3", digits=20, method="series", order=order)
            assert abs(real(Fraction(found)) - true) < mp.mpf("0.51e-20"), key


@pytest.mark.parametrize("order", [3, 9])
def test_floats_of_long_columns_are_as_near_as_stated(order: int) -> None:
    # Angles and ratios that floats hold exactly.
    angles = np.random.default_rng(order).integers(0, 360 * 64, 60) / 64
    keys = ("x", "x_return", "fd", "c", "c_return", "p", "p_return", "rod_velocity", "rod_acceleration")
    for ratio in (0.3125, 0.203125):
        found = compute(angles, ratio, keys, method="series", order=order)
        for key in keys:
            true = [
                float(certified(key, ratio, Fraction(angle), digits=40, method="series", order=order))
                for angle in angles
            ]
            floor = 0.0 if key[0] in "xcf" else 3 * 2.0**-53
            assert_allclose(found[key], true, rtol=2.8 * 2.0**-52, atol=floor, err_msg=key)


def test_even_orders_print_what_the_odd_ones_below_them_do() -> None:
    for even in (2, 4, 8):
        pages = [typeset(table("1:4", method="series", order=order)) for order in (even, even - 1)]
        assert pages[0] == pages[1]
    assert typeset(table("1:4", method="series")) == typeset(table("1:4", method="series", order=2))


def test_the_first_term_that_blau_leaves_out_is_an_eighth_of_the_third_power() -> None:
    # His 1/8 R⁴/L⁴ sin⁴ α, times L.
    for angle, sine_square in ((30, Fraction(1, 4)), (45, Fraction(1, 2)), (90, Fraction(1))):
        ratio = Fraction(1, 5)
        first, third = (
            certified("fd", ratio, angle, digits=30, method="series", order=order) for order in (1, 3)
        )
        assert Fraction(third) - Fraction(first) == ratio**3 * sine_square**2 / 8


@pytest.mark.parametrize(("method", "order"), [("exact", None), ("series", 7)])
def test_fd_is_what_the_paths_of_the_strokes_differ_by_from_the_infinite_rod(
    method: str, order: int | None
) -> None:
    def at(key: str, angle: str) -> Fraction:
        return Fraction(certified(key, "1:3.7", angle, digits=40, method=method, order=order))

    for angle in ("17.3", "123", "301"):
        plain = Fraction(certified("x", "1:3.7", angle, digits=40, method="infinite"))
        fd = at("fd", angle)
        assert abs(at("x", angle) - plain - fd) <= Fraction(3, 2 * 10**40)
        assert abs(plain - at("x_return", angle) - fd) <= Fraction(3, 2 * 10**40)


def test_a_tie_of_the_third_order_is_proved() -> None:
    # At 90° x = 1 + λ/2 + λ³/8: for λ = 1:2 that is 1.265625.
    found = [
        certified("x", "1:2", 90, digits=5, method="series", order=3, rounding=one)
        for one in ("half-away", "half-even")
    ]
    assert [str(one) for one in found] == ["1.26563", "1.26562"]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"order": 3}, r"add method=\"series\""),
        ({"order": 3, "method": "infinite"}, r"add method=\"series\""),
        ({"order": 0, "method": "series"}, "order 0 is not"),
        ({"order": "2.5", "method": "series"}, "from 1 to 9"),
        ({"order": "1;3", "method": "series"}, "a page is of one order, and 2 were given"),
        ({"order": 3, "method": "series", "offset": "0.2"}, "no formulas for an offset crank"),
    ],
)
def test_orders_that_say_nothing_are_refused(options: dict[str, Any], said: str) -> None:
    with pytest.raises(KurbelError, match=said):
        table("1:5", **options)
