"""Pressures by pieces: the ends of a compressor from the textbook's definition in mpmath, on all numbers."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from energy_curve import real
from flint import arb
from mpmath import mp
from numpy.testing import assert_allclose

from kurbel.exact.certify import ball
from kurbel.exact.separation import Separation
from kurbel.kernel.law import Between, Constant, Law, Polytrope

SHARES = tuple(Fraction(count, 97) for count in (0, 1, 3, 19, 40, 55, 60, 71, 80, 96, 97))
CASES = (
    # Delivery pressure in suction pressures, exponent, clearance.
    (Fraction(3), Fraction(1), Fraction(1, 20)),
    (Fraction(7, 2), Fraction(7, 5), Fraction(1, 12)),
    (Fraction(5, 3), Fraction(6, 5), Fraction(0)),
    (Fraction(9), Fraction(1, 2), Fraction(1, 90)),
)
each_case = pytest.mark.parametrize("case", CASES, ids=lambda case: "-".join(map(str, case)))


def stroke(case: tuple[Fraction, ...], of: Any, exponent_of: Any = None) -> Between:
    """The stroke of a compressor: its air expands and is sucked behind the piston, compressed before it."""
    ratio, exponent, clearance = of(case[0]), (exponent_of or of)(case[1]), of(case[2])
    root = ratio ** (1 / exponent)
    suction = Constant(of(Fraction(1)))
    leaving = Law((suction,))
    if case[2]:
        expanding = Polytrope(ratio, clearance, exponent, clearance, 1)
        leaving = Law((expanding, suction), (clearance * (root - 1),))
    coming = Law(
        (Polytrope(of(Fraction(1)), 1 + clearance, exponent, 1 + clearance, -1), Constant(ratio)),
        ((1 + clearance) * (1 - 1 / root),),
    )
    return Between(leaving, coming)


def pressures(case: tuple[Fraction, ...], share: Any) -> tuple[Any, Any]:
    """Behind and before the piston: the air never falls below suction nor rises above delivery."""
    ratio, exponent, clearance = map(real, case)
    left = max(mp.mpf(1), ratio * (clearance / (clearance + share)) ** exponent) if clearance else mp.mpf(1)
    room = clearance + 1 - share
    right = min(ratio, ((1 + clearance) / room) ** exponent) if room else ratio
    return left, right


def force_of(case: tuple[Fraction, ...], share: Any) -> Any:
    behind, before = pressures(case, share)
    return behind - before


def work_of(case: tuple[Fraction, ...], share: Fraction) -> Any:
    ratio, exponent, clearance = map(real, case)
    root = ratio ** (1 / exponent)
    corners = [clearance * (root - 1), (1 + clearance) * (1 - 1 / root)]
    ends = sorted({mp.mpf(0), real(share), *(min(one, real(share)) for one in corners)})
    return mp.quad(lambda place: force_of(case, place), ends)


@each_case
def test_force_is_that_of_air_between_suction_and_delivery(case: tuple[Fraction, ...]) -> None:
    of_floats = stroke(case, float)
    expected = [float(force_of(case, real(share))) for share in SHARES]
    assert_allclose([of_floats.force(float(one)) for one in SHARES], expected, rtol=1e-14, atol=1e-14)
    at_once = of_floats.force(np.array([float(one) for one in SHARES]))
    assert_allclose(at_once, expected, rtol=1e-14, atol=1e-14)


@each_case
def test_work_is_the_integral_of_the_force(case: tuple[Fraction, ...]) -> None:
    with mp.workdps(40):
        for share in SHARES:
            expected = work_of(case, share)
            assert_allclose(stroke(case, float).work(float(share)), float(expected), rtol=1e-13, atol=1e-14)
            with flint.ctx.workprec(150):
                found = stroke(case, ball).work(ball(share))
                assert found.overlaps(arb(f"{mp.nstr(expected, 38)} +/- 1e-35"))
                assert found.rad() < arb("1e-38")


@each_case
def test_slope_is_that_of_the_force(case: tuple[Fraction, ...]) -> None:
    for share in SHARES[1:-1]:
        expected = mp.diff(lambda at: force_of(case, at), real(share))
        assert_allclose(stroke(case, float).slope(float(share)), float(expected), rtol=1e-9, atol=1e-9)


@each_case
def test_a_ball_over_a_corner_holds_both_sides(case: tuple[Fraction, ...]) -> None:
    acting = stroke(case, ball)
    for corner in acting.corners:
        wide = corner.union(corner + ball(Fraction(1, 50))).union(corner - ball(Fraction(1, 200)))
        for near in (corner - ball(Fraction(1, 300)), corner, corner + ball(Fraction(1, 60))):
            if near > 0:
                for value in (Between.force, Between.work, Between.slope):
                    assert value(acting, wide).contains(value(acting, near).mid())


def test_the_whole_stroke_is_one_ball() -> None:
    for case in CASES:
        acting, whole = stroke(case, ball), ball(0).union(ball(1))
        assert acting.force(whole).is_finite()
        assert acting.work(whole).is_finite()


@each_case
def test_bounds_of_the_pieces_that_are_known_hold_the_value(case: tuple[Fraction, ...]) -> None:
    """A value that is not zero is at least as large as they say, near a zero of the force, too."""
    bounds = stroke(case, Separation.rational, Fraction)
    for share in SHARES[1:]:
        near = ball(share)
        kept = stroke(case, ball).behind.around(near), stroke(case, ball).before.around(near)
        bits = bounds.only(*kept).force(Separation.rational(share)).bits()
        value = abs(float(stroke(case, float).force(float(share))))
        assert value < 1e-15 or value >= 2.0**-bits
        assert bounds.force(Separation.rational(share)).bits() >= bits
