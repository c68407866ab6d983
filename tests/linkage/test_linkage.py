"""The arc crank against links closed by mpmath and the crank drive that it becomes; the parallel crank."""

from __future__ import annotations

import cmath
import functools
import math
from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from links import CRANKS, DIGITS, FLOATS, arc_crank, links, of_stroke, shown
from mpmath import mp
from numpy.testing import assert_allclose, assert_array_equal

from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.kind import balls
from kurbel.kernel import kinematics
from kurbel.kernel import linkage as kernel
from kurbel.kernel.circle import Circle, circle
from kurbel.kernel.parallel import coupler
from kurbel.linkage.arc.crank import ArcCrank
from kurbel.linkage.arc.quantities import arc_registry
from kurbel.linkage.linkage import certified, value
from kurbel.linkage.parallel import CHANGE_POINTS
from kurbel.linkage.quantities import FORCE
from kurbel.motion.evaluation import OUT, RETURN

MOTIONS = tuple(
    key for key, one in arc_registry().items() if one.stroke == OUT and one.of != FORCE and not one.needs
)


@pytest.mark.parametrize("crank", CRANKS, ids=shown)
@pytest.mark.parametrize("key", MOTIONS)
def test_every_digit_is_that_of_the_closed_links(key: str, crank: ArcCrank) -> None:
    with mp.workdps(DIGITS):
        for stroke, degrees in ((OUT, "0"), (OUT, "73.1"), (OUT, "251"), (RETURN, "38.5"), (RETURN, "-77")):
            expected = links(crank).value(key, stroke, Fraction(degrees))
            found = certified(of_stroke(key, stroke), crank, Fraction(degrees), 12)
            off = found - expected * 10**12
            # Angles are known but for whole turns.
            turns = 360 * mp.mpf(10) ** 12 if key in ("rocker", "rod") else mp.inf
            off = off - turns * mp.nint(off / turns) if mp.isfinite(turns) else off
            assert abs(off) <= mp.mpf("0.501"), f"{degrees}°, stroke {stroke}: {found}e-12, not {expected}"


@pytest.mark.parametrize("crank", CRANKS, ids=shown)
def test_dead_centres_stop_the_rocker_and_bound_its_path(crank: ArcCrank) -> None:
    machine = links(crank)
    centres = [crank.dead_angle(stroke, FLOATS) for stroke in (OUT, RETURN)]
    for found, (phi, _) in zip((centres[0], centres[1] + 180), (machine.inner, machine.outer), strict=True):
        assert_allclose(math.remainder(found - math.degrees(phi), 360), 0, rtol=0, atol=1e-11)
    at_dead = circle(np.array([centres[0], centres[1] + 180]))
    travel = crank.arc_stroke(FLOATS)
    assert_allclose(value(of_stroke("velocity", OUT), crank, at_dead, FLOATS), 0, rtol=0, atol=1e-13)
    # At links that nearly come into line the path is steep and floats lose two digits.
    assert_allclose(value(of_stroke("path", OUT), crank, at_dead, FLOATS), [0, travel], rtol=0, atol=1e-12)
    turn = circle(np.linspace(0, 360, 5001))
    path = value(of_stroke("path", OUT), crank, turn, FLOATS)
    assert path.min() >= 0
    assert path.max() <= travel + 1e-12
    assert_allclose(path.max(), travel, rtol=1e-5, atol=0)
    # No other standstill: the velocity changes its sign twice.
    assert (np.diff(np.sign(value(of_stroke("velocity", OUT), crank, turn, FLOATS))) != 0).sum() == 2


@pytest.mark.parametrize("crank", CRANKS, ids=shown)
def test_swing_times_and_transmission_are_those_of_a_scan(crank: ArcCrank) -> None:
    machine = links(crank)
    cranks = np.linspace(0, 2 * np.pi, 100_001)
    ends = machine.guess(cranks)
    rocker = np.unwrap(np.angle(ends - complex(machine.pivot)))
    assert_allclose(crank.swing(FLOATS), np.degrees(np.ptp(rocker)), rtol=1e-7, atol=0)
    assert_allclose(crank.arc_stroke(FLOATS), float(crank.rocker) * np.ptp(rocker), rtol=1e-7, atol=0)
    inner, outer = np.abs(ends).argmax(), np.abs(ends).argmin()
    outstroke = (cranks[outer] - cranks[inner]) % (2 * np.pi)
    assert_allclose(crank.lead(FLOATS), np.degrees(outstroke) - 180, rtol=0, atol=0.01)
    assert_allclose(crank.time_ratio(FLOATS), outstroke / (2 * np.pi - outstroke), rtol=3e-4, atol=0)
    between = np.angle((ends - np.exp(1j * cranks)) / (ends - complex(machine.pivot)))
    lines = np.degrees(np.arcsin(np.abs(np.sin(between))))
    assert_allclose(crank.least_transmission(FLOATS), lines.min(), rtol=1e-4, atol=0)


@pytest.mark.parametrize(("rod", "offset"), [("5", "0"), ("4.5", "0"), ("3.2", "0.9"), ("2.5", "-1.1")])
@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("stroke", [OUT, RETURN])
def test_a_long_rocker_gives_the_straight_and_the_offset_crank(
    rod: str, offset: str, side: int, stroke: int
) -> None:
    rocker = Fraction(10**9 - 10)
    crank = ArcCrank(Crank(1 / Fraction(rod)), rocker, None, Fraction(offset) + side * rocker)
    turn = circle(np.arange(0, 360, 3.7))
    ratio, e = stroke / float(Fraction(rod)), stroke * float(Fraction(offset))
    numbers = {
        "path": kinematics.offset_path,
        "chord": kinematics.offset_path,
        "slide_path": kinematics.offset_path,
        "velocity": kinematics.offset_velocity,
        "acceleration": kinematics.offset_acceleration,
    }
    for key, formula in numbers.items():
        found = value(of_stroke(key, stroke), crank, turn, FLOATS)
        assert_allclose(found, formula(turn, ratio, e), rtol=0, atol=2e-8, err_msg=key)
    slant = np.degrees(np.arcsin(kinematics.rod_sine(turn, ratio, e)))
    for key in ("slant", "rod"):
        assert_allclose(value(of_stroke(key, stroke), crank, turn, FLOATS), slant, rtol=0, atol=1e-6)
    inner = math.degrees(math.asin(kinematics.dead_centre_sine(ratio, e)))
    assert_allclose(crank.dead_angle(stroke, FLOATS), inner, rtol=0, atol=1e-6)
    travel = kinematics.stroke(ratio, e)
    assert_allclose(crank.arc_stroke(FLOATS), travel, rtol=1e-8, atol=0)


ANGLES = np.arange(0, 360, 2.9)


@pytest.mark.parametrize(("ratio", "offset"), [(0.2, 0.0), (0.31, 0.8), (-0.31, -0.8), (0.0, 0.4)])
@pytest.mark.parametrize("shift", [0.0, 0.3])
def test_an_arc_without_curvature_is_the_slide(ratio: float, offset: float, shift: float) -> None:
    arc = kernel.arc(ratio, 0.0, offset, shift)
    place = kernel.place(kernel.from_dead_centre(circle(ANGLES), arc), arc)
    turn = circle(ANGLES)
    for formula in (kernel.chord, kernel.slide_path):
        assert_allclose(formula(place, arc), kinematics.offset_path(turn, ratio, offset), rtol=0, atol=4e-15)
    velocity = kinematics.offset_velocity(turn, ratio, offset)
    assert_allclose(kernel.velocity(place, arc), velocity, rtol=0, atol=4e-15)
    acceleration = kinematics.offset_acceleration(turn, ratio, offset)
    assert_allclose(kernel.acceleration(place, arc), acceleration, rtol=0, atol=4e-15)
    assert_allclose(kernel.rise(place, arc), 0, rtol=0, atol=2e-15)


@pytest.mark.parametrize("height", [None, Fraction(7, 3), Fraction(-5, 4)])
def test_an_infinite_rod_moves_the_rocker_by_the_versine_along_the_slide(height: Fraction | None) -> None:
    crank = ArcCrank(Crank(Fraction(0)), Fraction(13, 10), None, height)
    found = value(of_stroke("slide_path", OUT), crank, circle(ANGLES), FLOATS)
    assert_allclose(found, circle(ANGLES).versine, rtol=0, atol=2e-15)
    assert_allclose(crank.swing(FLOATS), 2 * math.degrees(math.asin(10 / 13)), rtol=1e-14, atol=0)


def test_a_chord_through_the_shaft_makes_the_strokes_equal() -> None:
    # Rocker 5/3, chord 2 and their distance 4/3 from the pivot: G² = L² + B² - R².
    central = arc_crank("5", "5/3", ("5", "4/3"))
    for stroke in (OUT, RETURN):
        assert_allclose(central.dead_angle(stroke, FLOATS), 0, rtol=0, atol=1e-14)
    assert_allclose(central.swing(FLOATS), 2 * math.degrees(math.asin(3 / 5)), rtol=1e-15, atol=0)
    assert_allclose(central.time_ratio(FLOATS), 1, rtol=1e-15, atol=0)
    assert certified(of_stroke("chord", OUT), central, Fraction(180), 30) == 2 * 10**30


@pytest.mark.parametrize("crank", CRANKS, ids=shown)
def test_the_formulas_for_ties_give_the_same_numbers(crank: ArcCrank) -> None:
    with flint.ctx.workprec(300):
        kind = balls()
        for key in (key for key in MOTIONS if not arc_registry()[key].is_arc):
            for stroke in (OUT, RETURN):
                turn = kind.circle(Fraction("34.7"))
                direct, usual = (
                    value(of_stroke(key, stroke), crank, turn, kind, direct) for direct in (True, False)
                )
                assert abs(direct - usual) < flint.arb(2) ** -250, key


@pytest.mark.parametrize(
    ("rod", "decimals", "away", "even"), [("5", 0, 2, 2), ("10/3", 2, 163, 162), ("25", 0, 1, 1)]
)
def test_ties_of_the_acceleration_at_a_dead_centre(rod: str, decimals: int, away: int, even: int) -> None:
    # Where crank and rod are in line p is (1 + λ)/cos ψ, and the rocker leans by asin 3/5 from the slide's
    # perpendicular: 1.25 (1 + λ) is 1.5, 1.625 and, no tie, 1.3.
    central = arc_crank(rod, "5/3", (rod, "4/3"))
    assert certified(of_stroke("acceleration", OUT), central, Fraction(0), decimals) == away
    assert certified(of_stroke("acceleration", OUT), central, Fraction(0), decimals, "half-even") == even


def test_a_rod_angle_of_whole_degrees_prints_as_such() -> None:
    # Pin at (0, 1), pivot at (1.5, 6), their distance² 27.25 = L² + B² - 2 L B sin 30°.
    crank = arc_crank("2.5", "6", ("1.5", "6"))
    assert certified(of_stroke("slant", OUT), crank, Fraction(90), 12) == 30 * 10**12


def random_crank(random: np.random.Generator) -> ArcCrank:
    while True:
        rod, rocker, distance, height = random.integers(105, 800, 4)
        lengths = [Fraction(int(each), 100) for each in (rod, rocker, distance, height)]
        sides = random.choice([1, -1], 2)
        try:
            return ArcCrank(
                Crank(1 / lengths[0]), lengths[1], lengths[2], lengths[3] * int(sides[0]), int(sides[1])
            )
        except ProblemError:
            continue


FIELDS = [kernel.chord, kernel.slide_path, kernel.rise, kernel.velocity, kernel.acceleration]
FIELDS += [kernel.path_half_sine, kernel.rod_velocity, kernel.rod_acceleration]


def of_place(formula: Any) -> Any:
    """A force, which takes no dead centre, called as the others are."""
    return functools.wraps(formula)(lambda place, arc: formula(place))


FIELDS += map(of_place, (kernel.rod_force, kernel.rocker_force, kernel.radial_force))


@pytest.mark.parametrize(("steepest", "bound"), [(0.7, 12), (0.95, 60)])
def test_floats_are_within_the_stated_bound(steepest: float, bound: float) -> None:
    random = np.random.default_rng(5)
    cranks = (random_crank(random) for _ in iter(int, 1))
    fitting = (
        crank
        for crank in cranks
        if 90 - crank.least_transmission(FLOATS) <= math.degrees(math.asin(steepest))
    )
    for _ in range(30):
        crank = next(fitting)
        angles = random.uniform(0, 360, 10)
        inputs = [float(each) for each in (crank.crank.ratio, crank.curvature, crank.offset, crank.shift)]
        arc = kernel.arc(*inputs)
        place = kernel.place(kernel.from_dead_centre(circle(angles), arc), arc)
        with flint.ctx.workprec(300):
            kind = balls()
            true_arc = kernel.arc(*(kind.of(Fraction(each)) for each in inputs))
            for row, angle in enumerate(angles):
                turn = kernel.from_dead_centre(kind.circle(Fraction(float(angle))), true_arc)
                true_place = kernel.place(turn, true_arc)
                for formula in FIELDS:
                    true = formula(true_place, true_arc)
                    error = abs(kind.of(Fraction(float(formula(place, arc)[row]))) - true)
                    ulp = math.ulp(max(abs(float(true.mid())), 1))
                    assert float(error.mid()) / ulp <= bound, f"{formula.__name__} {crank} {angle!r}°"


@pytest.mark.parametrize("crank", CRANKS[:4], ids=shown)
def test_the_path_keeps_its_digits_beside_the_dead_centre(crank: ArcCrank) -> None:
    arc = crank.dead_centre(OUT, FLOATS)
    for angle in (1e-3, 1e-8):
        found = kernel.chord(kernel.place(circle(angle), arc), arc)
        with flint.ctx.workprec(300):
            kind = balls()
            true_arc = crank.dead_centre(OUT, kind)
            place = kernel.place(kind.circle(Fraction(angle)), true_arc)
            assert abs(kind.of(Fraction(found)) / kernel.chord(place, true_arc) - 1) < 3e-15


@pytest.mark.parametrize("crank", CRANKS[:4], ids=shown)
def test_the_path_keeps_its_place_beside_a_dead_centre_at_any_angle(crank: ArcCrank) -> None:
    angle = crank.dead_angle(OUT, FLOATS) + 1e-5
    found = value(of_stroke("chord", OUT), crank, circle(angle), FLOATS)
    with flint.ctx.workprec(300):
        kind = balls()
        true = value(of_stroke("chord", OUT), crank, kind.circle(Fraction(angle)), kind)
        # The path is 1e-14; from 1 - cos χ it would be known to 1e-16.
        assert abs(kind.of(Fraction(found)) - true) < 3e-22


@pytest.mark.parametrize("formula", FIELDS)
def test_arrays_give_the_bits_of_scalars(formula: Any) -> None:
    arc = CRANKS[2].dead_centre(OUT, FLOATS)

    def at(angles: Any) -> Any:
        return formula(kernel.place(kernel.from_dead_centre(circle(angles), arc), arc), arc)

    assert_array_equal(at(ANGLES), [at(float(angle)) for angle in ANGLES])


def turns_and_swings(rod: float, rocker: float, pivot: complex) -> bool:
    """Whether the links close at every crank angle and the rocker comes back instead of going round."""
    cranks = np.linspace(0, 2 * np.pi, 2881) + cmath.phase(pivot)
    pins = np.exp(1j * cranks)
    apart = pivot - pins
    cosine = (rocker**2 + np.abs(apart) ** 2 - rod**2) / (2 * rocker * np.abs(apart))
    if (np.abs(cosine) >= 1).any():
        return False
    turn = np.unwrap(np.angle(-apart) + np.arccos(cosine))
    return bool(abs(turn[-1] - turn[0]) < 1)


TENTHS = st.integers(3, 80)


@settings(max_examples=300, deadline=None)
@given(rod=TENTHS, rocker=TENTHS, distance=TENTHS, height=st.integers(-80, 80))
def test_the_drive_is_built_if_and_only_if_it_turns_and_swings(
    rod: int, rocker: int, distance: int, height: int
) -> None:
    pivot = complex(distance, height) / 10
    # Links that come into line, and a pivot on the crank circle, are refused without a scan in floats.
    shortest, *others, longest = sorted((1, rod / 10, rocker / 10, abs(pivot)))
    assume(abs(shortest + longest - sum(others)) > 1e-9)
    assume(abs(abs(pivot) - 1) > 1e-9)
    given_lengths = Fraction(rocker, 10), Fraction(distance, 10), Fraction(height, 10)
    if turns_and_swings(rod / 10, rocker / 10, pivot):
        assert ArcCrank(Crank(Fraction(10, rod)), *given_lengths)
    else:
        with pytest.raises(ProblemError):
            ArcCrank(Crank(Fraction(10, rod)), *given_lengths)


@settings(max_examples=200, deadline=None)
@given(rod=st.integers(11, 80), rocker=st.integers(11, 80), distance=TENTHS, height=st.integers(-80, 80))
def test_the_message_names_a_change_that_will_do(rod: int, rocker: int, distance: int, height: int) -> None:
    lengths = [Fraction(each, 10) for each in (rod, rocker, distance, height)]
    try:
        built(lengths)
    except ProblemError as error:
        said = str(error)
    else:
        assume(False)
    if "pivot left in place" not in said:
        assert "farther than the crank radius" in said
        return
    change = Fraction(said.rsplit(" by ", 1)[1].removesuffix(" R"))
    if "too far" in said:
        changes = [(0, change), (1, change)]
    else:
        longer = 0 if "rod longer" in said else 1
        changes = [(longer, change), (1 - longer, -change)]
    for place, by in changes:
        changed = list(lengths)
        changed[place] += by
        assert built(changed)
        # No less than the message says, but for its rounding.
        changed[place] -= by / abs(by) * Fraction(4, 10**6)
        with pytest.raises(ProblemError):
            built(changed)


def built(lengths: list[Fraction]) -> ArcCrank:
    rod, rocker, distance, height = lengths
    return ArcCrank(Crank(1 / rod), rocker, distance, height)


def sentence(*given: Any, **more: Any) -> str:
    with pytest.raises(ProblemError) as raised:
        ArcCrank(*given, **more)
    said = str(raised.value)
    assert ". " not in said
    assert not said.endswith(".")
    return said


def test_impossible_lengths_are_refused_with_the_length_to_change() -> None:
    rod3 = Crank(Fraction(1, 3))
    assert sentence(rod3, Fraction(2), Fraction(5), Fraction(0)) == (
        "the pivot is G = 5 R from the shaft, too far for L = 3 R and B = 2 R; the crank turns with G below"
        " L + B - R = 4 R or, the pivot left in place, with a rod or rocker longer by 1.000001 R"
    )
    assert sentence(rod3, Fraction(5), Fraction(2), Fraction(2)) == (
        "the pivot is G = 2.828427 R from the shaft, too near for L = 3 R and B = 5 R; the crank turns with G"
        " above R + |L - B| = 3 R or, the pivot left in place, with the rod longer or the rocker shorter by"
        " 0.171575 R"
    )
    assert sentence(rod3, Fraction(3), Fraction(1, 2), Fraction(1, 2)) == (
        "the pivot is G = 0.707106 R from the shaft; it must be farther than the crank radius R, and for"
        " L = 3 R and B = 3 R farther than R + |L - B| = 1 R, or the rocker is carried round"
    )
    assert sentence(rod3, Fraction(1)) == (
        "rocker length B is 1 R; it must be longer than the crank radius R, or the crank cannot turn while"
        " the rocker swings"
    )
    assert "must be above 0, counted along the slide" in sentence(rod3, Fraction(4), Fraction(-3))
    assert "straight crank" in sentence(rod3, Fraction(10**10))
    assert "rod is infinite" in sentence(Crank(Fraction(0)), Fraction(4), Fraction(3))
    assert "height is e + B" in sentence(Crank(Fraction(1, 3), Fraction(1)), Fraction(4), height=Fraction(4))
    assert "1 or -1" in sentence(rod3, Fraction(4), circuit=0)


def parallel_rod(phi: float, apart: float, share: float) -> complex:
    """A point of the rod that joins two equal cranks at the same angle."""
    first, second = cmath.exp(1j * phi), apart + cmath.exp(1j * phi)
    assert_allclose(abs(second - first), apart, rtol=1e-14, atol=0)
    return first + share * (second - first)


@pytest.mark.parametrize(("apart", "share"), [(4.3, 0.0), (4.3, 0.7), (2.2, 1.4)])
def test_all_points_of_the_parallel_crank_move_as_its_pin(apart: float, share: float) -> None:
    step = 1e-4
    for degrees in (12.3, 101.7, 255.5):
        motion = coupler(circle(degrees))
        phi = math.radians(degrees)
        start, before, here, after = (
            parallel_rod(angle, apart, share) for angle in (0, phi - step, phi, phi + step)
        )
        assert_allclose([motion.path, motion.rise], [(start - here).real, (here - start).imag], rtol=1e-13)
        velocity = (after - before) / (2 * step)
        assert_allclose([motion.velocity, motion.rise_velocity], [-velocity.real, velocity.imag], rtol=1e-7)
        bent = (after - 2 * here + before) / step**2
        assert_allclose([motion.acceleration, motion.rise_acceleration], [-bent.real, bent.imag], rtol=1e-5)


def test_the_parallel_crank_can_fold_at_its_change_points_alone() -> None:
    apart, angles = 3.0, np.arange(0, 360, 5)
    pins = np.exp(1j * np.radians(angles))
    diagonal = apart - pins
    # The second crank's pin mirrored at the diagonal closes the links as well.
    second = apart + pins
    mirrored = pins + np.conj((second - pins) / diagonal) * diagonal
    assert_allclose(abs(mirrored - pins), apart, rtol=1e-14)
    assert_allclose(abs(mirrored - apart), 1, rtol=1e-14)
    meeting = angles[np.abs(mirrored - second) < 1e-12]
    assert tuple(meeting) == CHANGE_POINTS


def test_certified_digits_of_the_parallel_crank() -> None:
    with flint.ctx.workprec(200):
        motion = coupler(balls().circle(Fraction(60)))
        assert motion.path == flint.arb(0.5)
    assert coupler(Circle(0.6, 0.8, 0.2)) == (0.2, 0.6, 0.6, 0.8, 0.8, -0.6)
