"""Forces of one piston force: against the equilibrium of crosshead and pin in mpmath, and the exercise."""

from __future__ import annotations

import math
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

from kurbel.drive.crank import Crank
from kurbel.exact import certify
from kurbel.kernel import forces
from kurbel.kernel.circle import Circle, circle
from kurbel.motion.evaluation import OFFSET, OUT, RETURN, At, certified
from kurbel.page.quantity import Formula, Quantity

# mpmath has no types.
Real = Any

FORMULAS = {
    "rod": forces.rod_force,
    "guide": forces.guide_force,
    "tangential": forces.tangential_force,
    "radial": forces.radial_force,
}
each_formula = pytest.mark.parametrize("name", FORMULAS)


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    before = flint.ctx.prec
    flint.ctx.prec = 200
    with mp.workdps(40):
        yield
    flint.ctx.prec = before


class Linkage:
    """Shaft at the origin, slide along X at Y = e, in R; crosshead on the far side, as on the outstroke."""

    def __init__(self, degrees: float, ratio: float, offset: float = 0.0) -> None:
        phi, self.offset, self.rod = mp.mpf(degrees) * mp.pi / 180, mp.mpf(offset), 1 / mp.mpf(ratio)
        self.phi = phi
        self.pin = mp.matrix([mp.cos(phi), mp.sin(phi)])
        self.crosshead = mp.matrix([self.place(phi), self.offset])

    def place(self, phi: Real) -> Real:
        return mp.cos(phi) + mp.sqrt(self.rod**2 - (mp.sin(phi) - self.offset) ** 2)

    def forces(self, direction: int) -> dict[str, Real]:
        """Solve the equilibrium of the crosshead and resolve the rod's force on the pin.

        The piston force is 1 towards the shaft (direction 1) or away from it (-1).
        """
        push = (self.pin - self.crosshead) / mp.norm(self.pin - self.crosshead)
        # Along the slide the rod's force on the crosshead, against its push, balances the piston force.
        thrust = -direction / push[0]
        radial, tangential = -self.pin, mp.matrix([-self.pin[1], self.pin[0]])
        return {
            "rod": direction * thrust,
            "guide": direction * thrust * push[1],
            "tangential": thrust * mp.fdot(push, tangential),
            "radial": thrust * mp.fdot(push, radial),
        }


angles = st.floats(-360, 360, allow_subnormal=False)
ratios = st.floats(0.01, 0.8)
shares = st.floats(-0.9, 0.9)


def offset_of(ratio: float, share: float) -> float:
    """Return a share of the greatest e/R with which the crank turns."""
    return share * (1 / ratio - 1)


@each_formula
@settings(max_examples=60, deadline=None)
@given(degrees=angles, ratio=ratios, share=shares)
def test_forces_hold_crosshead_and_pin_in_equilibrium(
    name: str, degrees: float, ratio: float, share: float
) -> None:
    offset = offset_of(ratio, share)
    scale = 1e-13 / (1 - (ratio * (1 + abs(offset))) ** 2) ** 2
    point = circle(degrees)
    straight = Linkage(degrees, ratio).forces(1)[name]
    assert abs(FORMULAS[name](point, ratio) - straight) < scale
    bent = Linkage(degrees, ratio, offset).forces(1)[name]
    assert abs(FORMULAS[name](point, ratio, offset) - bent) < scale * max(1, abs(bent))


@each_formula
@settings(max_examples=60, deadline=None)
@given(degrees=angles, ratio=ratios, share=shares)
def test_a_negative_ratio_is_the_return_stroke_in_a_frame_turned_round(
    name: str, degrees: float, ratio: float, share: float
) -> None:
    offset = offset_of(ratio, share)
    scale = 1e-13 / (1 - (ratio * (1 + abs(offset))) ** 2) ** 2
    true = Linkage(degrees + 180, ratio, offset).forces(-1)[name]
    assert abs(FORMULAS[name](circle(degrees), -ratio, -offset) - true) < scale * max(1, abs(true))


@settings(max_examples=40, deadline=None)
@given(degrees=angles, ratio=ratios, share=shares)
def test_torque_does_the_work_of_the_piston_force(degrees: float, ratio: float, share: float) -> None:
    linkage = Linkage(degrees, ratio, offset_of(ratio, share))
    virtual = -mp.diff(linkage.place, linkage.phi)
    found = forces.tangential_force(circle(degrees), ratio, offset_of(ratio, share))
    assert abs(found - virtual) < 1e-11 * max(1, abs(virtual))


@settings(max_examples=40, deadline=None)
@given(degrees=angles, ratio=ratios)
def test_rod_force_has_its_components_along_and_across_slide_and_crank(degrees: float, ratio: float) -> None:
    found = {name: formula(circle(degrees), ratio) for name, formula in FORMULAS.items()}
    assert math.isclose(math.hypot(1, found["guide"]), found["rod"], rel_tol=1e-14)
    assert math.isclose(math.hypot(found["tangential"], found["radial"]), found["rod"], rel_tol=1e-13)


def test_crosshead_of_a_driven_crank_lies_against_one_face_on_both_strokes() -> None:
    for degrees in (12.0, 77.0, 151.0):
        out, back = (forces.guide_force(circle(degrees), ratio) for ratio in (0.23, -0.23))
        assert out > 0.01
        assert -back == out


def test_dead_centres_load_the_shaft_and_nothing_else() -> None:
    for ratio in (0.25, -0.25):
        for degrees, radial in ((0.0, 1), (180.0, -1)):
            values = [formula(circle(degrees), ratio) for formula in FORMULAS.values()]
            assert values == [1, 0, 0, radial]
            assert all(value or math.copysign(1, value) == 1 for value in values), "a zero has a sign"


# The exercise: F_S = F √((r/l)² + 1), F_Q = F r/l, M_K = F r √((r/l)² + 1).


@pytest.mark.parametrize("ratio", [0.75, 0.2, 1 / 4.5, -0.3])
def test_the_square_position_is_that_of_the_exercise(ratio: float) -> None:
    point = forces.square_position(ratio)
    assert_allclose([point.sine**2 + point.cosine**2, point.versine + point.cosine], 1, rtol=1e-15, atol=0)
    exercise = math.sqrt(ratio**2 + 1)
    assert_allclose(forces.square_rod_force(ratio), exercise, rtol=3e-16, atol=0)
    assert_allclose(forces.rod_force(point, ratio), exercise, rtol=1e-15, atol=0)
    assert_allclose(forces.tangential_force(point, ratio), exercise, rtol=1e-15, atol=0)
    assert_allclose(forces.guide_force(point, ratio), ratio, rtol=1e-15, atol=0)
    assert_allclose(forces.radial_force(point, ratio), 0, rtol=0, atol=3e-16)


def test_crank_of_three_and_rod_of_four_make_a_rod_force_of_five_fourths() -> None:
    assert forces.square_rod_force(0.75) == 1.25
    assert_allclose(forces.square_position(0.75), [0.8, 0.6, 0.4, 0, 0], rtol=1e-15, atol=0)


def test_square_position_runs_on_balls() -> None:
    point = forces.square_position(certify.ball(Fraction(3, 7)))
    assert forces.radial_force(point, certify.ball(Fraction(3, 7))).contains(0)
    assert abs(forces.radial_force(point, certify.ball(Fraction(3, 7)))) < 1e-50


# Kinds of number.

SAMPLED = np.concatenate([np.arange(0, 361, 5.0), np.random.default_rng(5).uniform(0, 360, 300)])
# Least magnitude of which an ulp is meant, bound for |λ| <= 1/3, for |λ| <= 0.99.
BOUNDS = {"rod": (1e-50, 1.5, 3), "guide": (1e-50, 1.5, 3), "tangential": (1, 2, 3), "radial": (1, 2, 5)}


def in_ulp(name: str, ratio: float, offset: float | None, floor: float) -> float:
    """Return the greatest error of the floats, against the same formula in balls."""
    crank = [certify.ball(Fraction(number)) for number in (ratio, offset) if number is not None]
    floats = FORMULAS[name](circle(SAMPLED), *(number for number in (ratio, offset) if number is not None))
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


@each_formula
def test_a_vanishing_offset_leaves_the_straight_crank(name: str) -> None:
    for ratio in (0.27, -0.27):
        straight = FORMULAS[name](circle(SAMPLED), ratio)
        assert_allclose(FORMULAS[name](circle(SAMPLED), ratio, 1e-13), straight, rtol=0, atol=1e-12)


def test_an_infinite_rod_hands_on_the_piston_force() -> None:
    point = circle(SAMPLED)
    np.testing.assert_array_equal(forces.rod_force(point, 0.0), 1)
    np.testing.assert_array_equal(forces.guide_force(point, 0.0), 0)
    np.testing.assert_array_equal(forces.tangential_force(point, 0.0), point.sine)
    np.testing.assert_array_equal(forces.radial_force(point, 0.0), point.cosine)


def quantity(name: str, stroke: int) -> Quantity:
    def kernel(at: At) -> Any:
        return FORMULAS[name](at.circle, at.ratio, at.offset)

    return Quantity(name, {}, "", {}, 1, dict.fromkeys(("exact", OFFSET), Formula(kernel)), {}, stroke=stroke)


# At 90° and λ = 3/5 cos ψ is 4/5 and tan ψ is 3/4; with the offset 1/5 and λ = 3/4 likewise.
@pytest.mark.parametrize(
    ("name", "stroke", "offset", "decimals", "away", "even"),
    [
        ("rod", OUT, 0, 1, 13, 12),
        ("rod", RETURN, 0, 1, 13, 12),
        ("guide", OUT, 0, 1, 8, 8),
        ("guide", RETURN, 0, 1, -8, -8),
        ("radial", OUT, 0, 1, -8, -8),
        ("radial", RETURN, 0, 1, 8, 8),
        ("tangential", OUT, 0, 1, 10, 10),
        ("rod", OUT, Fraction(1, 5), 1, 13, 12),
        ("guide", OUT, Fraction(1, 5), 1, 8, 8),
    ],
)
def test_ties_are_proved(
    name: str, stroke: int, offset: Fraction, decimals: int, away: int, even: int
) -> None:
    crank = Crank(Fraction(3, 4), offset) if offset else Crank(Fraction(3, 5))
    for rounding, expected in (("half-away", away), ("half-even", even)):
        found = certified(quantity(name, stroke), "exact", crank, Fraction(90), decimals, rounding)
        assert found == expected


def test_a_circle_of_balls_gives_balls() -> None:
    point: Circle[Any] = certify.ball_circle(Fraction(739, 10))
    for formula in FORMULAS.values():
        value = formula(point, certify.ball(Fraction(1, 4)), certify.ball(Fraction(1, 3)))
        assert float(value.rad()) < 1e-50
