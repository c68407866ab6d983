"""Pressures by pieces: the ends of a compressor from `kurbel.verify`, on all numbers."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from flint import arb
from numpy.testing import assert_allclose

from kurbel import verify
from kurbel.exact.certify import at_bits, ball
from kurbel.kernel.law import Constant, Cubics, Law, Polytrope, Stroke
from kurbel.verify import enclose
from kurbel.verify.numbers import number

SHARES = tuple(Fraction(count, 97) for count in (0, 1, 3, 19, 40, 55, 60, 71, 80, 96, 97))
CASES = (
    # Delivery pressure in suction pressures, exponent, clearance.
    (Fraction(3), Fraction(1), Fraction(1, 20)),
    (Fraction(7, 2), Fraction(7, 5), Fraction(1, 12)),
    (Fraction(5, 3), Fraction(6, 5), Fraction(0)),
    (Fraction(9), Fraction(1, 2), Fraction(1, 90)),
)
each_case = pytest.mark.parametrize("case", CASES, ids=lambda case: "-".join(map(str, case)))


def stroke(case: tuple[Fraction, ...], of: Any, exponent_of: Any = None) -> Any:
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
    return Stroke(leaving, coming)


@each_case
def test_force_work_and_slope_are_those_of_air_between_suction_and_delivery(
    case: tuple[Fraction, ...],
) -> None:
    ratio, exponent, clearance = case
    true, of_floats = verify.compressor(ratio, exponent=exponent, clearance=clearance), stroke(case, float)
    with enclose.working(140), flint.ctx.workprec(150):
        (acting, _) = true()
        for share in SHARES:
            force, work = acting.force(number(share)), acting.work(number(share))
            assert of_floats.force(float(share)) == pytest.approx(float(force), rel=1e-14, abs=1e-14)
            assert of_floats.work(float(share)) == pytest.approx(float(work), rel=1e-13, abs=1e-14)
            found = stroke(case, ball).work(ball(share))
            assert found.overlaps(ball(work.low).union(ball(work.high)))
            assert found.rad() < arb("1e-38")
        for share in SHARES[1:-1]:
            slope = float(acting.slope(number(share)))
            assert of_floats.slope(float(share)) == pytest.approx(slope, rel=1e-13, abs=1e-13)
        expected = [float(acting.force(number(share))) for share in SHARES]
    at_once = of_floats.force(np.array([float(one) for one in SHARES]))
    assert_allclose(at_once, expected, rtol=1e-14, atol=1e-14)


@each_case
def test_a_ball_over_a_corner_holds_both_sides(case: tuple[Fraction, ...]) -> None:
    acting = stroke(case, ball)
    for corner in acting.corners:
        wide = corner.union(corner + ball(Fraction(1, 50))).union(corner - ball(Fraction(1, 200)))
        for near in (corner - ball(Fraction(1, 300)), corner, corner + ball(Fraction(1, 60))):
            if near > 0:
                for value in (acting.force, acting.work, acting.slope):
                    assert value(wide).contains(value(near).mid())


def test_the_whole_stroke_is_one_ball() -> None:
    for case in CASES:
        acting, whole = stroke(case, ball), ball(0).union(ball(1))
        assert acting.force(whole).is_finite()
        assert acting.work(whole).is_finite()


def test_a_cubic_has_the_slope_and_the_area_of_itself_beyond_the_bits_of_its_coefficients() -> None:
    random = np.random.default_rng(7)
    cubics = Cubics(np.array([0.0, 0.3, 1.0]), random.uniform(-1, 1, (4, 2)))
    with at_bits(400):
        near = arb(10) ** -30
        for place in map(arb, (0.1, 0.25, 0.4, 0.9)):
            for value, slope in ((cubics.pressure, cubics.slope), (cubics.work, cubics.pressure)):
                found = (value(place + near) - value(place - near)) / (2 * near) - slope(place)
                assert abs(found) < arb(10) ** -55
