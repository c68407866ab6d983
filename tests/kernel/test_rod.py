"""Inertia of the rod: against bodies of point masses whose positions are differentiated in mpmath."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import flint
import numpy as np
import pytest
from bodies import Body, Drive, Mass, Real, energy, few, of_body, point_on_circle, reactions, spread
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp
from numpy.testing import assert_allclose

from kurbel.drive.crank import Crank
from kurbel.drive.rod import (
    MODELS,
    Rod,
    Section,
    rod_of_sections,
)
from kurbel.drive.rod_file import read_rod
from kurbel.errors import MissingExtraError, ProblemError, RodError
from kurbel.exact import certify
from kurbel.kernel import forces
from kurbel.kernel import rod as kernel
from kurbel.kernel.circle import circle
from kurbel.kernel.rod import Loaded, Masses
from kurbel.motion.evaluation import OFFSET, OUT, RETURN, At, certified
from kurbel.page.quantity import Formula, Quantity
from kurbel.reading import units
from kurbel.reading.csv_file import shown


def force(name: str) -> Callable[..., Any]:
    """Return a force of circle, ratio, masses, offset and piston force."""
    return lambda *state: getattr(Loaded(*state), name)()


FORCES: dict[str, Callable[..., Any]] = {
    "guide": force("guide_force"),
    "along": force("pin_force_along"),
    "across": force("pin_force_across"),
    "pin": force("pin_force"),
    "torque": force("torque"),
}


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    before = flint.ctx.prec
    flint.ctx.prec = 200
    with mp.workdps(50):
        yield
    flint.ctx.prec = before


def close(found: Real, true: Real, within: float = 1e-13) -> bool:
    return bool(abs(found - true) < within * max(1, abs(true)))


times = st.floats(-7, 7, allow_subnormal=False).map(mp.mpf)


@st.composite
def drives(draw: st.DrawFn) -> Drive:
    ratio = mp.mpf(draw(st.floats(0.02, 0.7)))
    return Drive(ratio, draw(st.floats(-0.8, 0.8)) * (1 / ratio - 1))


@st.composite
def bodies(draw: st.DrawFn) -> Body:
    """Three to five points of mass 1 together, some beyond the pins and two beside the rod's line."""
    places = draw(st.lists(st.floats(-0.4, 1.4), min_size=2, max_size=4))
    weights = [mp.mpf(draw(st.floats(0.1, 1))) for _ in places]
    aside, pair = mp.mpf(draw(st.floats(0, 0.3))), mp.mpf(draw(st.floats(0, 1)))
    weights += [pair / 2, pair / 2]
    points = [Mass(mp.mpf(place), weight) for place, weight in zip(places, weights, strict=False)]
    middle = mp.mpf(draw(st.floats(0, 1)))
    points += [Mass(middle, pair / 2, aside), Mass(middle, pair / 2, -aside)]
    whole = sum(point.mass for point in points)
    return [point._replace(mass=point.mass / whole) for point in points]


# Ensslin's parts.


@few
@given(drive=drives(), time=times, share=st.floats(-0.3, 1.3))
def test_every_point_has_the_common_part_and_its_share_of_the_others(
    drive: Drive, time: Real, share: float
) -> None:
    line = drive.ratio * drive.rod(time)
    square = mp.matrix([line[1], -line[0]])
    for half_turn, sign in ((mp.mpf(0), 1), (mp.pi, -1)):
        # On the return stroke the frame is turned, which the second sign undoes; along and across the rod
        # are taken in the frame, where ψ is the same.
        point = point_on_circle(time - half_turn)
        common, turning, stretching = kernel.parts(point, sign * drive.ratio, sign * drive.offset)
        built = mp.matrix([-common, 0]) + (1 - share) * (turning * square + stretching * line)
        assert mp.norm(sign * built - drive.acceleration(time, share)) < 1e-13 * (1 + mp.norm(built))


def test_common_part_is_that_of_the_crosshead_and_stretching_points_to_it() -> None:
    for ratio in (0.3, -0.3):
        point = circle(np.array([3.0, 61.0, 118.0, 176.0]))
        assert (np.sign(kernel.parts(point, ratio).stretching) == np.sign(ratio)).all()
        assert (kernel.parts(point, ratio).turning > 0).all()


# Forces at the pins.


@pytest.mark.parametrize("name", FORCES)
@few
@given(drive=drives(), time=times, body=bodies())
def test_reactions_obey_newton(name: str, drive: Drive, time: Real, body: Body) -> None:
    masses, formula = of_body(body), FORCES[name]
    bent = formula(point_on_circle(time), drive.ratio, masses, drive.offset)
    assert close(bent, reactions(drive, body, time)[name])
    straight = formula(point_on_circle(time), drive.ratio, masses)
    assert close(straight, reactions(drive._replace(offset=mp.mpf(0)), body, time)[name])


@pytest.mark.parametrize("name", FORCES)
@few
@given(drive=drives(), time=times, body=bodies())
def test_a_negative_ratio_is_the_return_stroke(name: str, drive: Drive, time: Real, body: Body) -> None:
    sign = 1 if name in ("torque", "pin") else -1
    crank = (-drive.ratio, of_body(body), -drive.offset, mp.mpf("0.7"))
    found = FORCES[name](point_on_circle(time), *crank)
    assert close(found, sign * reactions(drive, body, time + mp.pi, mp.mpf("-0.7"))[name])


@few
@given(drive=drives(), time=times, body=bodies())
def test_torque_is_what_the_kinetic_energy_loses(drive: Drive, time: Real, body: Body) -> None:
    loss = -mp.diff(lambda at: energy(drive, body, at), time)
    found = Loaded(point_on_circle(time), drive.ratio, of_body(body), drive.offset).torque()
    assert abs(found - loss) < 1e-12 * abs(loss) + 1e-17


@pytest.mark.parametrize("offset", [None, 0.9])
def test_inertia_does_no_work_in_a_whole_turn(offset: float | None) -> None:
    # Of a periodic function the mean of equal steps is the integral, but for harmonics above 720.
    torque = Loaded(circle(np.arange(720) / 2), 0.31, Masses(0.58, 0.42, -0.09), offset).torque()
    assert np.ptp(torque) > 0.3
    assert abs(torque.mean()) < 1e-14


@few
@given(drive=drives(), time=times, body=bodies(), piston=st.floats(-4, 4), heavy=st.floats(0.1, 3))
def test_piston_force_and_reciprocating_mass_join_the_rod(
    drive: Drive, time: Real, body: Body, piston: float, heavy: float
) -> None:
    rod, crosshead = mp.mpf("1.7"), mp.mpf(heavy)
    whole = [point._replace(mass=rod * point.mass) for point in body] + [Mass(mp.mpf(1), crosshead)]
    true = reactions(drive, whole, time, mp.mpf(piston))
    masses = kernel.joined(of_body(body), rod, crosshead)
    for name, formula in FORCES.items():
        found = formula(point_on_circle(time), drive.ratio, masses, drive.offset, mp.mpf(piston))
        assert close(found, true[name], 1e-12), name


@few
@given(drive=drives(), time=times, body=bodies(), balance=st.floats(-2, 2))
def test_main_bearing_holds_the_crank_and_its_counterweight_too(
    drive: Drive, time: Real, body: Body, balance: float
) -> None:
    true = reactions(drive, body, time, mp.mpf(2))
    # The crank's own mass at R has the acceleration of the pin.
    bearing = mp.matrix([true["along"], true["across"]]) + mp.mpf(balance) * drive.acceleration(time, 0)
    masses = kernel.with_crank(of_body(body), mp.mpf(balance))
    crank = (point_on_circle(time), drive.ratio, masses, drive.offset, mp.mpf(2))
    assert close(Loaded(*crank).pin_force_along(), bearing[0])
    assert close(Loaded(*crank).pin_force_across(), bearing[1])
    assert close(Loaded(*crank).pin_force(), mp.norm(bearing))
    assert close(Loaded(*crank).guide_force(), true["guide"])
    assert close(Loaded(*crank).torque(), true["torque"])


def test_without_masses_the_piston_force_alone_acts() -> None:
    point, none = circle(np.arange(0.0, 360, 7)), Masses(0.0, 0.0, 0.0)
    for crank in ((0.23,), (-0.23,), (0.23, 0.8)):
        ratio, offset = crank[0], crank[1] if len(crank) > 1 else None
        state = (point, ratio, none, offset, 3.0)
        guide = forces.guide_force(point, *crank)
        assert_allclose(Loaded(*state).guide_force(), 3 * guide, rtol=1e-15, atol=1e-15)
        assert_allclose(Loaded(*state).pin_force(), 3 * forces.rod_force(point, *crank), rtol=1e-15, atol=0)
        assert_allclose(
            Loaded(*state).torque(), 3 * forces.tangential_force(point, *crank), rtol=1e-15, atol=0
        )
        assert (Loaded(*state).pin_force_along() == 3).all()


# Two masses in place of the rod.


@few
@given(drive=drives(), time=times, share=st.floats(0.05, 0.95))
def test_two_masses_are_exact_if_k_squared_is_a_b(drive: Drive, time: Real, share: float) -> None:
    centre = mp.mpf(share)
    true = reactions(drive, spread(centre, centre * (1 - centre)), time)
    for name, formula in FORCES.items():
        found = formula(point_on_circle(time), drive.ratio, kernel.two_masses(centre), drive.offset)
        assert close(found, true[name]), name


@few
@given(drive=drives(), time=times, body=bodies())
def test_two_masses_have_the_forces_along_the_slide_and_lack_a_couple(
    drive: Drive, time: Real, body: Body
) -> None:
    masses, true = of_body(body), reactions(drive, body, time)
    point, two = point_on_circle(time), kernel.two_masses(masses.crosshead)
    assert close(Loaded(point, drive.ratio, two, drive.offset).pin_force_along(), true["along"])
    # M (k² - a b) ψ̈ turns with ψ, against the counter-clockwise moments; over L, and L/R is 1/λ.
    spin = mp.diff(lambda at: mp.asin(drive.ratio * (mp.sin(at) - drive.offset)), time, 2)
    couple = Loaded(point, drive.ratio, masses, drive.offset).couple()
    assert close(couple, -masses.couple * spin / drive.ratio)
    guide = Loaded(point, drive.ratio, two, drive.offset).guide_force()
    across = Loaded(point, drive.ratio, two, drive.offset).pin_force_across()
    extra = couple / (drive.ratio * drive.rod(time)[0])
    assert close(true["guide"] - guide, extra)
    assert close(true["across"] - across, -extra)
    torque = Loaded(point, drive.ratio, two, drive.offset).torque()
    assert close(true["torque"] - torque, extra * mp.cos(time))


@few
@given(drive=drives(), time=times)
def test_railway_rule_is_six_tenths_at_the_pin_and_four_at_the_crosshead(drive: Drive, time: Real) -> None:
    masses = Rod(Fraction(1, 3), Fraction(1, 9)).masses("railway", float)
    assert masses == (0.6, 0.4, 0, 0)
    true = reactions(drive, [Mass(mp.mpf(0), mp.mpf("0.6")), Mass(mp.mpf(1), mp.mpf("0.4"))], time)
    for name, formula in FORCES.items():
        found = formula(point_on_circle(time), drive.ratio, Masses(*map(mp.mpf, masses)), drive.offset)
        assert close(found, true[name]), name


# Limits and kinds of number.

SAMPLED = np.concatenate([np.arange(0, 361, 15.0), np.random.default_rng(8).uniform(0, 360, 100)])
ROD = Fraction(37, 100), Fraction(9, 100)
FLOATS = kernel.rod_masses(*map(float, ROD))


@pytest.mark.parametrize("name", FORCES)
def test_a_vanishing_offset_leaves_the_straight_crank(name: str) -> None:
    for ratio in (0.27, -0.27):
        straight = FORCES[name](circle(SAMPLED), ratio, FLOATS)
        assert_allclose(FORCES[name](circle(SAMPLED), ratio, FLOATS, 1e-13), straight, rtol=0, atol=2e-12)


def test_an_infinite_rod_swings_without_turning_the_force_along() -> None:
    point = circle(SAMPLED)
    assert_allclose(Loaded(point, 0.0, FLOATS).pin_force_along(), -point.cosine, rtol=1e-15, atol=1e-16)
    share = 0.63 + float(FLOATS.couple)
    assert_allclose(
        Loaded(point, 0.0, FLOATS).pin_force_across(), -share * point.sine, rtol=1e-15, atol=1e-16
    )
    for formula in FORCES.values():
        assert_allclose(formula(point, 1e-9, FLOATS), formula(point, 0.0, FLOATS), rtol=0, atol=1e-8)


@pytest.mark.parametrize("name", FORCES)
def test_floats_are_within_their_bound(name: str) -> None:
    cases = (
        ((1 / 3, None), 2), ((-0.21, None), 2), ((0.01, None), 2), ((0.9, None), 16), ((-0.99, None), 16),
        ((0.25, 0.9), 3), ((-0.2, 1.45), 3), ((0.3, 1.9), 12), ((-0.55, 0.6), 12),
    )  # fmt: skip
    for (ratio, offset), bound in cases:
        for masses in (FLOATS, Masses(0.6, 0.4, 0.0), Masses(0.31, 0.69, -0.21), Masses(0.5, 0.5, 0.3)):
            exact = None if offset is None else certify.ball(Fraction(offset))
            balls = Masses(*(certify.ball(Fraction(mass)) for mass in masses))
            values = FORCES[name](circle(SAMPLED), ratio, masses, offset)
            for degrees, value in zip(SAMPLED.tolist(), values.tolist(), strict=True):
                point = certify.ball_circle(Fraction(degrees))
                true = FORCES[name](point, certify.ball(Fraction(ratio)), balls, exact)
                error = float(abs(certify.ball(Fraction(value)) - true))
                assert error <= bound * math.ulp(max(1, abs(value))), (name, ratio, offset, degrees)


@pytest.mark.parametrize("name", FORCES)
def test_arrays_give_the_bits_of_scalars(name: str) -> None:
    for ratio, offset in ((0.2345, None), (-0.2345, None), (0.2345, 0.67)):
        values = FORCES[name](circle(SAMPLED), ratio, FLOATS, offset, 0.3)
        scalars = [FORCES[name](circle(degrees), ratio, FLOATS, offset, 0.3) for degrees in SAMPLED.tolist()]
        np.testing.assert_array_equal(values, scalars)


def test_no_zero_has_a_sign() -> None:
    for degrees in (0.0, 90.0, 180.0, 360.0):
        for ratio in (0.2, -0.2, 0.0):
            point = circle(degrees)
            values = [formula(point, ratio, FLOATS) for formula in FORCES.values()]
            values += [Loaded(point, ratio, FLOATS).couple(), *kernel.parts(point, ratio)]
            assert all(value or math.copysign(1, value) == 1 for value in values), (degrees, ratio)


def test_magnitude_of_balls_that_hold_zero_is_a_ball_about_zero() -> None:
    third = certify.ball(Fraction(1, 3))
    masses = Masses(third, third, 0)
    balanced = third + third * (1 + third)
    value = Loaded(certify.ball_circle(Fraction(0)), third, masses, None, balanced).pin_force()
    assert value.contains(0)
    assert value < 1e-50


def quantity(name: str, stroke: int, masses: tuple[Fraction, Fraction, Fraction]) -> Quantity:
    def kernel(at: At) -> Any:
        return FORCES[name](at.circle, at.ratio, Masses(*map(at.numbers.of, masses)), at.offset)

    formulas = {"exact": Formula(kernel), OFFSET: Formula(kernel)}
    return Quantity(name, {}, "", {}, 2, formulas, {}, stroke=stroke)


TENTHS = Fraction(3, 5), Fraction(2, 5), Fraction(-1, 10)


# At 90° and λ = 3/5: cos ψ = 4/5, tan ψ = 3/4, p = -3/4, c = 1, L ψ̈ = 5/4 in magnitude.
@pytest.mark.parametrize(
    ("name", "masses", "angle", "exact", "decimals", "away", "even"),
    [
        ("guide", (Fraction(3, 5), Fraction(2, 5), Fraction(0)), 90, "0.225", 2, 23, 22),
        ("guide", TENTHS, 90, "0.06875", 4, 688, 688),
        ("across", (Fraction(3, 5), Fraction(2, 5), Fraction(0)), 90, "-0.825", 2, -83, -82),
        ("torque", (Fraction(13, 20), Fraction(7, 20), Fraction(-1, 9)), 90, "0.2625", 3, 263, 262),
        ("along", (Fraction(1, 4), Fraction(3, 4), Fraction(-1, 9)), 0, "-1.45", 1, -15, -14),
        ("pin", (Fraction(1, 4), Fraction(3, 4), Fraction(-1, 9)), 0, "1.45", 1, 15, 14),
    ],
)
def test_ties_are_proved(
    name: str,
    masses: tuple[Fraction, Fraction, Fraction],
    angle: int,
    exact: str,
    decimals: int,
    away: int,
    even: int,
) -> None:
    assert (Fraction(exact) * 10**decimals).denominator == 2
    for rounding, expected in (("half-away", away), ("half-even", even)):
        found = certified(
            quantity(name, OUT, masses), "exact", Crank(Fraction(3, 5)), Fraction(angle), decimals, rounding
        )
        assert found == expected


def test_digits_of_the_return_stroke_are_those_of_the_outstroke_half_a_turn_on() -> None:
    for name in FORCES:
        sign = 1 if name in ("torque", "pin") else -1
        crank = Crank(Fraction(2, 7), Fraction(1, 3))
        back = certified(quantity(name, RETURN, TENTHS), "exact", crank, Fraction(41), 30)
        assert back == sign * certified(quantity(name, OUT, TENTHS), "exact", crank, Fraction(221), 30)


# The rod as it is given.


def sentence(make: Callable[[], Any], error: type[Exception] = ProblemError) -> str:
    with pytest.raises(error) as raised:
        make()
    said = str(raised.value)
    assert len(said) < 300
    assert ". " not in said
    assert not said.endswith(".")
    return said


HALF, THIRD = Fraction(1, 2), Fraction(1, 3)


@pytest.mark.parametrize(
    ("centre", "square", "mass", "said"),
    [
        (
            Fraction(-1, 10),
            THIRD,
            None,
            "centre of mass is -0.1 L from the crank pin; it must lie within 0..1",
        ),
        (
            Fraction(11, 10),
            THIRD,
            None,
            "centre of mass is 1.1 L from the crank pin; it must lie within 0..1",
        ),
        (THIRD, Fraction(0), None, "k² is 0 L²; it must be above 0"),
        (
            HALF,
            Fraction(101, 100),
            None,
            "with the centre of mass 0.5 L from the crank pin it must be at most 1",
        ),
        (Fraction(0), Fraction(4, 5), None, "0 L from the crank pin it must be at most 0.75 L²"),
        (HALF, THIRD, Fraction(0), "the rod's mass is 0 kg; it must be above 0 and at most 10^9 kg"),
        (HALF, THIRD, Fraction(10) ** 10, "the rod's mass is 10000000000 kg"),
        (HALF, Fraction(10) ** 900, None, "k² is 1e+900 L²"),
    ],
)
def test_impossible_rods_are_refused(
    centre: Fraction, square: Fraction, mass: Fraction | None, said: str
) -> None:
    assert said in sentence(lambda: Rod(centre, square, mass))


def test_rods_beyond_their_pins_are_allowed() -> None:
    assert Rod(HALF, Fraction(1)).couple == Fraction(3, 4)
    assert Rod(HALF, Fraction(1, 12)).couple == Fraction(-1, 6)
    assert Rod(THIRD, Fraction(2, 9)).couple == 0


def test_gyration_is_squared() -> None:
    assert Rod.from_crosshead(1 - THIRD, HALF, Fraction(7)) == Rod(THIRD, Fraction(1, 4), Fraction(7))
    assert "k is -0.5 L; it must be above 0" in sentence(lambda: Rod.from_crosshead(THIRD, -HALF))


def test_models_share_out_the_mass() -> None:
    rod = Rod(THIRD, Fraction(1, 9))
    as_fraction: Callable[[Fraction], Fraction] = Fraction
    assert rod.masses("exact", as_fraction) == (Fraction(2, 3), THIRD, Fraction(-1, 9), 0)
    assert rod.masses("two-mass", as_fraction) == (Fraction(2, 3), THIRD, 0, 0)
    assert set(MODELS) == {"exact", "two-mass", "railway"}


def test_uniform_rod_has_a_twelfth_of_its_length_squared() -> None:
    whole = rod_of_sections([Section(Fraction(0), Fraction(1), Fraction(5))], kilograms=True)
    assert whole == Rod(HALF, Fraction(1, 12), Fraction(5))
    ends = [Fraction(0), Fraction(1, 5), Fraction(2, 3), Fraction(1)]
    parts = [Section(one, other, other - one) for one, other in pairwise(ends)]
    assert rod_of_sections(parts) == Rod(HALF, Fraction(1, 12))


def rod_of(points: list[tuple[Fraction, Fraction]], kilograms: bool = False) -> Rod:
    """Return the rod of masses at positions, (position, mass) each."""
    return rod_of_sections([Section(place, place, mass) for place, mass in points], kilograms)


places = st.fractions(-HALF, Fraction(3, 2), max_denominator=50)
between = st.fractions(0, 1, max_denominator=50)
weights = st.fractions(Fraction(1, 9), 9, max_denominator=9)


@settings(max_examples=40, deadline=None)
@given(st.lists(st.tuples(between, weights), min_size=2, max_size=6, unique_by=lambda point: point[0]))
def test_points_between_the_pins_have_k_squared_of_at_most_a_b(
    points: list[tuple[Fraction, Fraction]],
) -> None:
    rod = rod_of(points)
    assert rod.couple <= 0
    whole = sum(mass for _, mass in points)
    assert rod.centre == sum(mass * place for place, mass in points) / whole
    assert rod.gyration_square == sum(mass * (place - rod.centre) ** 2 for place, mass in points) / whole
    assert (rod.couple == 0) == all(place in (0, 1) for place, _ in points)


@settings(max_examples=40, deadline=None)
@given(st.lists(st.tuples(places, weights), min_size=2, max_size=6, unique_by=lambda point: point[0]))
def test_no_points_within_reach_are_refused_but_for_their_centre(
    points: list[tuple[Fraction, Fraction]],
) -> None:
    try:
        rod = rod_of(points, kilograms=True)
    except ProblemError as error:
        assert "centre of mass" in str(error)
    else:
        assert rod.mass == sum(mass for _, mass in points)


@pytest.mark.parametrize(
    ("sections", "said"),
    [
        ([], "masses are given at 0 of the rod's places; at least 2 are needed"),
        ([Section(HALF, HALF, Fraction(1))], "masses are given at 1 of the rod's places"),
        ([Section(HALF, THIRD, Fraction(1))], "the section runs from 0.5 L to 0.333333333333333 L; its end"),
        ([Section(HALF, Fraction(2), Fraction(1))], "position 2 L is outside -0.5..1.5"),
        ([Section(THIRD, HALF, Fraction(0))], "mass 0 must be above 0"),
    ],
)
def test_impossible_sections_are_refused(sections: list[Section], said: str) -> None:
    assert said in sentence(lambda: rod_of_sections(sections))


# The rod in a file.

SECTIONS = rod_of_sections(
    [
        Section(Fraction(-1, 10), Fraction(1, 8), Fraction(42, 5)),
        Section(Fraction(1, 8), Fraction(9, 10), Fraction(61, 10)),
        Section(Fraction(9, 10), Fraction(21, 20), Fraction(33, 10)),
    ],
    kilograms=True,
)
METRIC = "from [mm];to [mm];mass [kg]\n-60;75;8,4\n75;540;6,1\n540;630;3,3\n"
SHARES = "from,to,mass\n-0.1,0.125,84\n0.125,0.9,61\n0.9,1.05,33\n"


def written(folder: Path, text: str | bytes) -> Path:
    path = folder / "rod.csv"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return path


@pytest.mark.parametrize(
    "text",
    [
        METRIC,
        METRIC.replace("\n", "\r\n"),
        "\ufeff# weighed\n\n" + METRIC.replace("\n75", "\n\n # shank\n75") + ";;\n",
        "mass (kg)\tto/cm\tfrom in mm\tnote\n8,4\t7,5\t-60\ta\n6,1\t54\t75\t\n3,3\t63\t540\tb\n",
        'from;to;mass\n-60 mm;7,5cm;8400 g\n75mm;0,9 L;"6,1 kg"\n90 %;0,63 m;3,3 kg\n',
        "from [%],to [%],mass [kg]\n−10,12.5,8.4\n12.5,90,6.1\n90,105,3.3\n",
    ],
)
def test_a_rod_is_read_however_it_is_written(text: str, tmp_path: Path) -> None:
    assert read_rod(written(tmp_path, text), Fraction(6, 10)) == SECTIONS


def test_masses_without_a_unit_are_shares(tmp_path: Path) -> None:
    rod = read_rod(written(tmp_path, SHARES))
    assert rod == Rod(SECTIONS.centre, SECTIONS.gyration_square)


def test_points_are_read_without_pint(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def missing() -> Any:
        raise MissingExtraError("no pint")

    monkeypatch.setattr(units, "registry", missing)
    path = written(tmp_path, "position;mass\n0;5\n0,5;3\n1;2\n")
    assert read_rod(path) == Rod(Fraction(35, 100), Fraction(275, 1000) - Fraction(35, 100) ** 2)
    assert read_rod(written(tmp_path, METRIC), Fraction(1)).mass is not None
    with pytest.raises(MissingExtraError):
        read_rod(written(tmp_path, METRIC.replace("kg", "slug")), Fraction(1))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "rod.csv is empty; a rod starts with its heads, from, to, mass or position, mass"),
        ("from,to,mass\n", "rod.csv: masses are given at 0 of the rod's places; at least 2 are needed"),
        ("position,mass\n0.4,2\n", "rod.csv: masses are given at 1 of the rod's places"),
        ("place,weight\n0,1\n", "rod.csv, line 1: the heads are place, weight; a rod has either position"),
        (
            "position,from,to,mass\n",
            "rod.csv, line 1: the heads are position, from, to, mass; a rod has either",
        ),
        ("from,mass,mass\n", "rod.csv, line 1: 2 columns are headed mass; a rod has one"),
        (SHARES + "1,2\n", "rod.csv, line 5: the row has 2 fields where the head has 3; with decimal commas"),
        (SHARES + "1,1.1,x\n", 'rod.csv, line 5: mass "x" is not a number; write it as 8.4'),
        ('from,to,mass\n"0,9",1,4\n', 'rod.csv, line 2: from "0,9" is not a number; write it as 8.4'),
        (SHARES + '"0.9,1,4\n', "rod.csv, line 5: the quotes do not match (unexpected end of data)"),
        (SHARES + "1,1.6,4\n", "rod.csv, line 5: position 1.6 L is outside -0.5..1.5"),
        (SHARES + "1,0.9,4\n", "rod.csv, line 5: the section runs from 1 L to 0.9 L"),
        (SHARES + "1,1.1,-4\n", "rod.csv, line 5: mass -4 must be above 0"),
        (SHARES + "1,1.1,4kg\n", "rod.csv, line 5: some masses have a unit and some have none"),
        (
            "from;to;mass [kg]\n0;1;3 kg\n",
            'rod.csv, line 2: mass "3 kg" has a unit behind the value and one in the head',
        ),
        ("from;to;mass\n0;0,5;3\n0.5;1;3\n", "rod.csv, line 3: decimal points and decimal commas are mixed"),
        ("from [kg];to;mass\n0;1;1\n", 'rod.csv, line 2: the position has the unit "kg", which is no length'),
        ("from;to;mass [xx]\n0;1;1\n", 'rod.csv, line 2: the mass has the unit "xx", which is no mass'),
        ("from;to;mass [9**9]\n0;1;1\n", 'rod.csv, line 2: the mass has the unit "9**9", which is no mass'),
        ("from;to;mass [L]\n0;1;1\n", 'rod.csv, line 2: the mass has the unit "L", which is no mass'),
        (METRIC, "rod.csv, line 2: the position is in mm and the rod's length is not known; give the length"),
        (SHARES.encode() + b"\xff\n", "rod.csv, line 5: the byte 0xff is not UTF-8"),
        (SHARES + "\0\n", "rod.csv, line 5: the character U+0000 is in no text file"),
        ("position,mass\n1,1\n1.2,1\n", "rod.csv: the rod's centre of mass is 1.1 L from the crank pin"),
    ],
)
def test_files_that_hold_no_rod_are_refused(text: str | bytes, said: str, tmp_path: Path) -> None:
    path = written(tmp_path, text)
    found = sentence(lambda: read_rod(path), RodError).replace(shown(path), "rod.csv")
    assert said in found


def test_what_is_no_file_is_refused(tmp_path: Path) -> None:
    assert "No such file" in sentence(lambda: read_rod(tmp_path / "none.csv"), RodError)
    assert "it is a directory; name a CSV file in it" in sentence(lambda: read_rod(tmp_path), RodError)
    assert "no file can have that name" in sentence(lambda: read_rod("a\0b"), RodError)
    large = written(tmp_path, b"#")
    os.truncate(large, 2 * 10**8)
    assert "it has 200 MB; a rod has at most 100 MB" in sentence(lambda: read_rod(large), RodError)
