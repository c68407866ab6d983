"""Balance of engines: against the summed accelerations of all pistons, and what textbooks say."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from time import process_time

import flint
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from numpy.typing import NDArray

from kurbel.balance import harmonics
from kurbel.balance.arrangement import (
    Arrangement,
    Cylinder,
    Residual,
    factor,
    force,
    moment,
    row,
    usual,
    vee,
)
from kurbel.balance.lengths import LENGTHS, certified_length
from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact import certify
from kurbel.exact.numerals import nearest, number_text
from kurbel.kernel.balance import Star
from kurbel.kernel.circle import circle

HALF = Fraction(1, 2)
ONE_SECOND = 1.0
STEPS = 512
TURN = 2 * np.pi * np.arange(STEPS) / STEPS


def textbook_acceleration(phi: NDArray[np.float64], ratio: float) -> NDArray[np.float64]:
    return np.cos(phi) + ratio * (np.cos(2 * phi) + ratio**2 * np.sin(phi) ** 4) / (
        (1 - (ratio * np.sin(phi)) ** 2) ** 1.5
    )


def pushed(
    arrangement: Arrangement, ratio: float, weigh: Callable[[Cylinder], float]
) -> NDArray[np.complex128]:
    """Return the force of all pistons and counterweights on the frame over a turn, as x + iy."""
    total = np.zeros(STEPS, complex)
    for cylinder in arrangement.cylinders:
        slide, pin = math.radians(cylinder.bank), TURN + math.radians(cylinder.crank)
        piston = textbook_acceleration(pin - slide, ratio) * np.exp(1j * slide)
        moved, turned = float(cylinder.mass), float(cylinder.revolving)
        pinned = (turned - moved * float(arrangement.share)) * np.exp(1j * pin)
        total += weigh(cylinder) * (moved * piston + pinned)
    return total


def vector(star: Star) -> complex:
    return complex(*star.point(lambda degrees: circle(float(degrees)), float))


ANGLES = st.one_of(
    st.integers(-360, 720).map(Fraction),
    st.sampled_from([0, 60, 72, 90, 120, 144, 180, 240, 270]).map(Fraction),
    st.fractions(-360, 360, max_denominator=60),
)
MASSES = st.one_of(st.just(Fraction(1)), st.fractions(0, 3, max_denominator=4))
CYLINDERS = st.builds(
    Cylinder, ANGLES, st.fractions(-4, 4, max_denominator=6), ANGLES, mass=MASSES, revolving=MASSES
)
ARRANGEMENTS = st.builds(
    lambda cylinders, share: Arrangement(tuple(cylinders), share),
    st.lists(CYLINDERS, min_size=1, max_size=12, unique_by=lambda one: (one.position, one.bank % 360)),
    st.fractions(0, 1, max_denominator=20),
)
RESIDUALS = st.builds(
    lambda arrangement, order, what: what(arrangement, order),
    ARRANGEMENTS,
    st.integers(1, 6),
    st.sampled_from([force, moment]),
)


@settings(max_examples=60, deadline=None)
@given(arrangement=ARRANGEMENTS, ratio=st.floats(0.01, 0.8), order=st.integers(1, 8))
def test_residuals_are_the_fourier_analysis_of_what_the_pistons_push(
    arrangement: Arrangement, ratio: float, order: int
) -> None:
    size = abs(harmonics.HARMONICS["p"].value(order, ratio))
    for residual, weigh in (
        (force(arrangement, order), lambda cylinder: 1.0),
        (moment(arrangement, order), lambda cylinder: float(cylinder.position)),
    ):
        total = pushed(arrangement, ratio, weigh)
        forward, backward = ((total * np.exp(turn * order * TURN)).mean() for turn in (-1j, 1j))
        assert abs(size * vector(residual.forward) - forward) < 1e-11
        assert abs(size * vector(residual.backward) - backward) < 1e-11


def over_the_turn(residual: Residual) -> NDArray[np.complex128]:
    wave = np.exp(1j * TURN)
    return np.asarray(vector(residual.forward) * wave + vector(residual.backward) / wave)


@settings(max_examples=60, deadline=None)
@given(residual=RESIDUALS)
def test_lengths_are_the_extremes_of_the_turn(residual: Residual) -> None:
    forward, backward = vector(residual.forward), vector(residual.backward)
    # What cos φ and sin φ are multiplied by; the matrix turns the unit circle into the ellipse.
    columns = np.array([forward + backward, 1j * (forward - backward)])
    greatest, least = np.linalg.svd(np.array([columns.real, columns.imag]), compute_uv=False)
    expected = {
        "along": np.hypot(*columns.real),
        "across": np.hypot(*columns.imag),
        "forward": abs(forward),
        "backward": abs(backward),
        "greatest": greatest,
        "least": least,
    }
    assert list(expected) == list(LENGTHS)
    for key, length in LENGTHS.items():
        assert_allclose(certified_length(length, residual, 9).scaled / 1e9, expected[key], rtol=0, atol=1e-9)
    assert abs(over_the_turn(residual)).max() == pytest.approx(greatest, rel=1e-4)


@settings(max_examples=40, deadline=None)
@given(residual=RESIDUALS, degrees=ANGLES)
def test_a_component_is_that_of_the_turning_vectors(residual: Residual, degrees: Fraction) -> None:
    star = residual.component(degrees)
    along = (over_the_turn(residual) * np.exp(-1j * math.radians(degrees))).real
    assert_allclose(along, (vector(star) * np.exp(1j * TURN)).real, rtol=0, atol=1e-12)


def printed(length: str, residual: Residual, decimals: int = 3) -> str:
    return number_text(certified_length(LENGTHS[length], residual, decimals))


# Primary and secondary forces and moments in units of m R ω² and λ m R ω², of the distance of neighbours.
# The free moments of three and five cylinders are the tables' 1.732, 0.449 and 4.980.
@pytest.mark.parametrize(
    ("name", "forces", "moments"),
    [
        ("inline-1", ("1.000", "1.000"), ("0.000", "0.000")),
        ("inline-2-360", ("2.000", "2.000"), ("0.000", "0.000")),
        ("inline-2-180", ("0.000", "2.000"), ("1.000", "0.000")),
        ("inline-3", ("0.000", "0.000"), ("1.732", "1.732")),
        ("inline-4", ("0.000", "4.000"), ("0.000", "0.000")),
        ("inline-5", ("0.000", "0.000"), ("0.449", "4.980")),
        ("inline-6", ("0.000", "0.000"), ("0.000", "0.000")),
        ("v2-90", ("1.000", "1.414"), ("0.000", "0.000")),
        ("v6-90", ("0.000", "0.000"), ("1.732", "2.449")),
        ("v8-90", ("0.000", "0.000"), ("3.162", "0.000")),
        ("v12-60", ("0.000", "0.000"), ("0.000", "0.000")),
        ("boxer-2", ("0.000", "0.000"), ("1.000", "1.000")),
        ("boxer-4", ("0.000", "0.000"), ("0.000", "2.000")),
    ],
)
def test_usual_engines_have_the_residuals_of_the_textbooks(
    name: str, forces: tuple[str, str], moments: tuple[str, str]
) -> None:
    arrangement = usual()[name]
    assert tuple(printed("greatest", force(arrangement, order)) for order in (1, 2)) == forces
    assert tuple(printed("greatest", moment(arrangement, order)) for order in (1, 2)) == moments


def test_every_usual_engine_has_its_textbook() -> None:
    tables = test_usual_engines_have_the_residuals_of_the_textbooks.pytestmark  # type: ignore[attr-defined]
    assert {case[0] for case in tables[0].args[1]} == set(usual())


@pytest.mark.parametrize(
    ("name", "firing"),
    [
        ("inline-3", (1, 3, 2)),
        ("inline-4", (1, 3, 4, 2)),
        ("inline-5", (1, 2, 4, 5, 3)),
        ("inline-6", (1, 5, 3, 6, 2, 4)),
    ],
)
def test_pistons_reach_the_dead_centre_in_the_order_of_firing(name: str, firing: tuple[int, ...]) -> None:
    cylinders = usual()[name].cylinders
    for stroke, number in enumerate(firing):
        turned = Fraction(720 * stroke, len(firing))
        assert (cylinders[number - 1].crank + turned) % 360 == 0


def test_six_cylinders_first_fail_in_the_sixth_order() -> None:
    # The odd orders above 1 have no force at all.
    for order in (1, *range(2, 13, 2)):
        expected = "0.000" if order % 6 else "6.000"
        assert printed("along", force(usual()["inline-6"], order)) == expected
        assert printed("along", moment(usual()["inline-6"], order)) == "0.000"


def test_a_v_of_90_degrees_is_balanced_by_one_reciprocating_mass_a_pin() -> None:
    assert {printed(key, force(vee((0,), 90, HALF), 1)) for key in LENGTHS} == {"0.000"}
    assert printed("forward", force(vee((0,), 90), 1)) == "1.000"
    assert printed("backward", force(vee((0,), 90), 1)) == "0.000"
    assert printed("forward", force(vee((0,), 90, Fraction(1)), 1)) == "1.000"
    assert {printed(key, moment(vee((0, 90, 270, 180), 90, HALF), 1)) for key in LENGTHS} == {"0.000"}
    # The second order of the V is square to its middle line, √2 λ.
    secondary = force(vee((0,), 90, HALF), 2)
    assert printed("along", secondary) == "0.000"
    assert printed("across", secondary, 30) == "1.414213562373095048801688724210"


@given(share=st.fractions(0, 1, max_denominator=64))
def test_a_counterweight_turns_its_share_across_the_slide(share: Fraction) -> None:
    residual = force(row((0,), share=share), 1)
    assert printed("along", residual, 6) == number_text(nearest(1 - share, 6))
    assert printed("across", residual, 6) == number_text(nearest(share, 6))
    assert printed("greatest", residual, 6) == number_text(nearest(max(share, 1 - share), 6))
    assert printed("least", residual, 6) == number_text(nearest(min(share, 1 - share), 6))
    assert force(row((0,), share=share), 2) == force(row((0,)), 2)


def test_residuals_times_the_harmonics_are_forces() -> None:
    crank, four = Crank(Fraction(1, 5)), usual()["inline-4"]

    def along(order: int, method: str) -> str:
        scale = factor(order, crank, method)
        return number_text(certified_length(LENGTHS["along"], force(four, order), 12, scale))

    acceleration = textbook_acceleration(TURN, 0.2)
    for order in (2, 4, 6):
        expected = 4 * 2 * (acceleration * np.cos(order * TURN)).mean()
        assert_allclose(float(along(order, "exact")), abs(expected), rtol=0, atol=1e-12)
    assert along(2, "series") == "0.800000000000"
    assert along(4, "series") == along(3, "exact") == along(1, "exact") == "0.000000000000"
    assert along(2, "infinite") == "0.000000000000"


SIXTY = force(row((0, 60)), 1)
"""|1 + e^60°i| = √3, half of it along either vector."""


@pytest.mark.parametrize(
    ("residual", "length", "scale", "decimals", "away", "even"),
    [
        (force(row((0,)), 1), "forward", Fraction(1), 0, 1, 0),
        (force(row((0, 120)), 1), "along", Fraction(1, 8), 2, 13, 12),
        (force(row((0, 120)), 1), "greatest", Fraction(1, 8), 2, 13, 12),
        (force(row((0,), share=Fraction(1, 8)), 1), "least", Fraction(1), 2, 13, 12),
        (force(row((0,), share=Fraction(1, 8)), 1), "greatest", Fraction(1), 2, 88, 88),
        (force(vee((0,), 60, Fraction(1, 4)), 1), "greatest", Fraction(1), 0, 1, 1),
        (SIXTY, "along", Fraction(1), 3, 1732, 1732),
        (moment(usual()["v8-90"], 1), "greatest", Fraction(1), 3, 3162, 3162),
    ],
)
def test_ties_are_recognised(
    residual: Residual, length: str, scale: Fraction, decimals: int, away: int, even: int
) -> None:
    assert certified_length(LENGTHS[length], residual, decimals, scale).scaled == away
    assert certified_length(LENGTHS[length], residual, decimals, scale, "half-even").scaled == even


def test_an_axis_is_not_taken_for_the_other() -> None:
    # One cylinder with 1/8 balanced: half axes 7/8 and 1/8, whose squares solve the same equation.
    residual = force(row((0,), share=Fraction(1, 8)), 1)
    for key, own, other in (("greatest", 7, 1), ("least", 1, 7)):
        assert LENGTHS[key].equals(residual, Fraction(own, 8))
        assert not LENGTHS[key].equals(residual, Fraction(other, 8))
        assert not LENGTHS[key].equals(residual, Fraction(3, 8))


SMALL = st.sampled_from([Fraction(1), Fraction(-1), Fraction(1, 10**12)])


@st.composite
def stars(draw: st.DrawFn) -> Star:
    """Regular polygons, which vanish, turned and weighed, often with a ray too many."""
    star = Star()
    for _ in range(draw(st.integers(1, 3))):
        corners = draw(st.sampled_from([2, 3, 4, 5, 6, 7, 9, 11]))
        turn, length = draw(st.fractions(0, 1, max_denominator=30)), draw(st.integers(1, 3))
        star += Star.of((turn + Fraction(one, corners), Fraction(length)) for one in range(corners))
    if draw(st.booleans()):
        star += Star.of(draw(st.lists(st.tuples(st.fractions(0, 1, max_denominator=30), SMALL), max_size=2)))
    return star


@settings(max_examples=100, deadline=None)
@given(star=st.one_of(stars(), st.tuples(stars(), stars()).map(lambda two: two[0] * two[1])))
def test_a_star_vanishes_where_its_sum_is_zero(star: Star) -> None:
    before = flint.ctx.prec
    flint.ctx.prec = 3000
    try:
        x, y = star.point(certify.ball_circle, certify.ball)
        assert star.vanishes() == (abs(x) + abs(y) < flint.arb(2) ** -2900)
    finally:
        flint.ctx.prec = before


def test_famous_sums_of_roots_of_unity_vanish() -> None:
    # cos 36° - cos 72° = ½, and Conway and Jones: cos π/7 - cos 2π/7 + cos 3π/7 = ½.
    half = Star.ray(Fraction(0), HALF)

    def cosine(degrees: Fraction) -> Star:
        return (Star.ray(degrees) + Star.ray(-degrees)) * HALF

    assert (cosine(Fraction(36)) - cosine(Fraction(72)) - half).vanishes()
    seventh = Fraction(180, 7)
    sevenths = cosine(seventh) - cosine(2 * seventh) + cosine(3 * seventh) - half
    assert sevenths.vanishes()
    assert not (sevenths + Star.ray(seventh, Fraction(1, 10**60))).vanishes()
    assert Star().vanishes()


def test_angles_of_thirty_digits_take_no_time() -> None:
    before = process_time()
    odd = [Fraction(360 * number**7 + 1, 10**30 + number) for number in range(24)]
    for residual in (force(row(odd), 1), moment(row(odd), 2)):
        for length in LENGTHS.values():
            certified_length(length, residual, 30)
    assert process_time() - before < ONE_SECOND


@settings(max_examples=30, deadline=None)
@given(arrangement=ARRANGEMENTS)
def test_forces_do_not_know_where_the_cylinders_lie(arrangement: Arrangement) -> None:
    moved = [one._replace(position=one.position + 7) for one in arrangement.cylinders]
    other = Arrangement(tuple(moved), arrangement.share)
    assert force(other, 2) == force(arrangement, 2)
    seven = force(arrangement, 2).forward * 7
    assert moment(other, 2).forward == moment(arrangement, 2).forward + seven


def sentence(make: Callable[[], object]) -> str:
    with pytest.raises(ProblemError) as raised:
        make()
    return str(raised.value)


def test_engines_that_cannot_be_built_are_refused() -> None:
    zero = Fraction(0)
    assert sentence(lambda: row(())) == "0 cylinders were given; an engine has 1 to 24"
    assert sentence(lambda: row([0] * 25)) == "25 cylinders were given; an engine has 1 to 24"
    for share in (Fraction(-1, 10), Fraction(11, 10)):
        assert sentence(lambda share=share: row((0,), share=share)).startswith(  # type: ignore[misc]
            f"share of the counterweights is {float(share):g}; it must lie within 0..1"
        )
    twins = (Cylinder(zero), Cylinder(zero, Fraction(1, 2)), Cylinder(zero, zero, Fraction(-360)))
    assert sentence(lambda: Arrangement(twins)) == (
        "cylinders 1 and 3 are both at position 0 in the bank at -360°; they must differ in one of the two"
    )
    assert sentence(lambda: row((0, 10**7), (0, 0))) == (
        "crank angle of cylinder 2 is beyond 1000000°; give it within one turn, 0..360"
    )
    assert sentence(lambda: row((0,), (-(10**7),))) == (
        "bank angle of cylinder 1 is beyond 1000000°; give it within one turn, 0..360"
    )
    assert sentence(lambda: Arrangement((Cylinder(zero, Fraction(10**7)),))) == (
        "cylinder 1 lies beyond 1000000; take a larger unit of length"
    )


@pytest.mark.parametrize("order", [0, -1, 101])
def test_orders_without_free_forces_are_refused(order: int) -> None:
    said = f"free forces of order {order} were asked for; orders 1 to 100 are given"
    assert sentence(lambda: force(row((0,)), order)) == said
    assert sentence(lambda: factor(order, Crank(Fraction(1, 5)))) == said


def test_an_offset_crank_has_no_factor() -> None:
    offset = Crank(Fraction(1, 5), Fraction(1, 10))
    assert sentence(lambda: factor(2, offset)).startswith("the crank is offset; harmonics are known for")


@pytest.mark.parametrize("count", [2, 3, 5, 8, 15, 24])
def test_equally_turned_cranks_balance_all_orders_but_multiples_of_their_number(count: int) -> None:
    engine = row([Fraction(360 * number, count) for number in range(count)])
    for order in range(1, count + 2):
        expected = f"{count}.000" if order % count == 0 else "0.000"
        assert printed("along", force(engine, order)) == expected
