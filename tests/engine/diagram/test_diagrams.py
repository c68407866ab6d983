"""Turning-moment diagrams by formula, points, areas and triangles: by quadrature and by hand."""

from __future__ import annotations

import re
from collections.abc import Callable
from math import cos, pi, radians, sin, sqrt
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from cli import column, printed, records
from drawings import drawn
from hypothesis import given, settings
from hypothesis import strategies as st
from places import ROOT
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq, minimize_scalar

import kurbel

TORQUE, LOAD = "5000 + 1500 sin(3φ)", "5000 + 600 sin φ"
WHEEL = ("--inertia=800kgm2", "--speed=300/min")
TRIANGLE = "0:0; 60:90; 180:0; 360:0"
SEVEN = "+52;−124;+92;-140;+85;-72;+107"


def page(*words: str) -> str:
    """Return the page in one line."""
    return " ".join(printed("turning", *words, "--lang=en").out.split())


def places(*words: str) -> tuple[list[float], list[float]]:
    """Return the angles at which the speed is greatest and least, as the page says them."""
    found = re.search(r"speed greatest at ([^a-z]*), least at ([-\d.°; ]*)", page(*words))
    assert found
    greatest, least = ([float(one) for one in re.findall(r"[\d.]+(?=°)", part)] for part in found.groups())
    return greatest, least


def swing(*words: str, digits: int = 9) -> str:
    heavy = ("--inertia=1e9kgm2", "--speed=100/s", "--columns=swing")
    return column("swing", "flywheel", *words, *heavy, f"--digits={digits}")[0]


@pytest.mark.parametrize(
    ("text", "python"),
    [
        ("5000 + 1500 sin(3φ)", lambda t: 5000 + 1500 * sin(3 * t)),
        ("5000 − 600·sin θ N m", lambda t: 5000 - 600 * sin(t)),
        ("(12,5 + 3 cos 2φ) kN m", lambda t: 12500 + 3000 * cos(2 * t)),
        ("200 sin² φ cos(φ + 30°)", lambda t: 200 * sin(t) ** 2 * cos(t + pi / 6)),
        ("-4 sin^3(2(phi - 120)) + 7/2", lambda t: -4 * sin(2 * (t - 2 * pi / 3)) ** 3 + 3.5),
        ("(sin φ + 2cos(φ/2))² / 4", lambda t: (sin(t) + 2 * cos(t / 2)) ** 2 / 4),
        ("30 (2 - sin(π/5 - φ·3)) cos θ", lambda t: 30 * (2 - sin(pi / 5 - 3 * t)) * cos(t)),
        ("(7 - 3 sin(4φ + 211)) (5 cos φ - 2)^2",
         lambda t: (7 - 3 * sin(4 * t + radians(211))) * (5 * cos(t) - 2) ** 2),
    ],
)  # fmt: skip
def test_a_formula_is_what_it_says_and_its_energy_is_the_integral(
    text: str, python: Callable[[float], float]
) -> None:
    turns = 2 if "φ/2" in text else 1
    mean = quad(python, 0, 2 * pi * turns, epsabs=1e-11)[0] / (2 * pi * turns)
    for row in records("turning", f"--torque={text}", "--angle=0;37;105.5;299", "--digits=7"):
        at = radians(float(row["phi"]))
        assert float(row["torque"]) == pytest.approx(python(at), abs=6e-8)
        assert float(row["excess_energy"]) == pytest.approx(quad(python, 0, at)[0] - mean * at, abs=2e-6)


def sampled(torque: Callable[[Any], Any], degrees: float) -> float:
    """Return the swing of the energy of a torque by the trapezoidal rule over 200,000 angles."""
    angles = np.linspace(0.0, radians(degrees), 200_001)
    values = torque(angles)
    energy = np.concatenate([[0.0], np.cumsum((values[1:] + values[:-1]) / 2 * np.diff(angles))])
    energy -= energy[-1] * angles / angles[-1]
    return float(energy.max() - energy.min())


waves = st.lists(st.tuples(st.integers(-9, 9), st.integers(1, 6), st.integers(0, 71)), min_size=1, max_size=4)


@settings(max_examples=8, deadline=None)
@given(waves, st.integers(1, 5))
def test_random_waves_swing_as_they_do_when_sampled(parts: list[tuple[int, int, int]], load: int) -> None:
    text = " ".join(f"{a:+d} sin({order}φ + {5 * phase})" for a, order, phase in parts)

    def torque(angles: Any) -> Any:
        sines = (a * np.sin(order * angles + np.radians(5 * phase)) for a, order, phase in parts)
        return sum(sines) - load * np.cos(angles)

    found = swing(f"--torque=40 {text}", f"--load-torque=40 + {load} cos φ")
    assert float(found) == pytest.approx(sampled(torque, 360), rel=1e-7, abs=1e-7)


@settings(max_examples=8, deadline=None)
@given(st.lists(st.integers(-20, 90), min_size=3, max_size=8), st.sampled_from([0, 12]))
def test_random_lines_swing_as_they_do_when_sampled(levels: list[int], load: int) -> None:
    levels = [levels[0], levels[0] + 30, *levels]
    angles = [720 * number // (len(levels) - 1) for number in range(len(levels))]
    drive = "; ".join(f"{angle}:{level}" for angle, level in zip(angles, levels, strict=True))
    # In half newton metres and degrees, so that the mean is a fraction as it is typed.
    area = sum((levels[n] + levels[n + 1]) * (angles[n + 1] - angles[n]) for n in range(len(levels) - 1))
    found = swing(f"--torque={drive}", f"--load-torque={area}/1440 + {load} sin 2φ")

    def torque(at: Any) -> Any:
        return np.interp(np.degrees(at), angles, levels) - load * np.sin(2 * at)

    assert float(found) == pytest.approx(sampled(torque, 720), rel=1e-6)


@pytest.mark.parametrize(
    ("words", "expected", "greatest", "least"),
    [
        # One sine over its mean swings by twice its amplitude over its order.
        (("--torque=5000 + 1500 sin(3φ)",), 1000, [60, 180, 300], [0, 120, 240]),
        # Three triangles sum up to 45 to 90 N m about their mean 67.5: 60° and 22.5 N m above it.
        ((f"--torque={TRIANGLE}", "--cranks=0;120;240"), 22.5 * pi / 6, [90, 210, 330], [30, 150, 270]),
        # A punch takes 10 kN m over a tenth of a turn, of which the motor gives the mean all the time.
        (("--load-torque=0:10kNm; 36:10kNm; 36:0; 360:0",), 1800 * pi, [0], [36]),
        # 1 - sin φ is 0 twice at 90°, beside cos φ: E = sin φ - ½ sin² φ, from -3/2 to 1/2.
        (("--torque=cos φ - cos φ sin φ + 5",), 2, [90], [270]),
        # 1 - cos φ is 0 twice at 0°, beside sin φ: E = ½ (1 - cos φ)², from 0 to 2.
        (("--torque=sin φ (1 - cos φ) + 5",), 2, [180], [0]),
        # cos 36° - cos 72° is ½, of which neither part is rational.
        (("--torque=cos 36 - cos 72 + sin φ", "--load-torque=1/2 - sin φ"), 4, [180], [0]),
        # Waves of cranks that come to nothing are left out.
        (("--torque=sin φ + 3 sin 3φ + 9", "--cranks=0;120;240"), 6, [60, 180, 300], [0, 120, 240]),
    ],
)  # fmt: skip
def test_swings_and_places_are_those_by_hand(
    words: tuple[str, ...], expected: float, greatest: list[float], least: list[float]
) -> None:
    assert float(swing(*words)) == pytest.approx(expected, abs=6e-10)
    assert places(*words) == (greatest, least)


def test_brackets_beside_each_other_are_not_within_each_other() -> None:
    # At 90° the sine of φ, 5φ … is 1, that of 3φ, 7φ … is -1, and the others are nothing: one is left of 41.
    formula = "1000 + " + " + ".join(f"10 sin({order}φ)" for order in range(1, 42))
    assert column("torque", "turning", f"--torque={formula}", "--angle=90", "--columns=torque") == ["1010.0"]


def test_a_tie_at_an_angle_that_is_no_rational_number_is_one() -> None:
    """E = -(a/2) cos 2φ - b cos φ is least at 0°, greatest at cos φ = -b/2a: the swing of a = 10, b = 1 is
    a + b + b²/4a = 11.025, a tie at two decimals, which a bisection of digits never ends."""
    assert swing("--torque=10 sin 2φ + sin φ + 5", digits=2) == "11.03"
    assert swing("--torque=10 sin 2φ + sin φ + 5", "--rounding=half-even", digits=2) == "11.02"


def test_the_swing_between_two_sines_is_that_of_mpmath() -> None:
    """sin φ (1500 (3 - 4 sin² φ) - 600) is 0 at sin² φ = 13/20; the work from there to 180° less it."""
    with mpmath.workdps(40):
        turn = mpmath.asin(mpmath.sqrt(mpmath.mpf(13) / 20))
        work = mpmath.quad(lambda t: 1500 * mpmath.sin(3 * t) - 600 * mpmath.sin(t), [mpmath.pi - turn, turn])
        found = mpmath.mpf(swing(f"--torque={TORQUE}", f"--load-torque={LOAD}", digits=25))
        assert abs(found - work) < mpmath.mpf("0.51e-25")


def test_points_without_the_ends_of_the_cycle_are_joined_across_them() -> None:
    """From 350° with 10 N m to 10° with 30 of the next turn: 20 N m at 0°."""
    words = ("--torque=10:30; 100:0; 200:0; 300:5; 350:10", "--turns=1", "--angle=0;355")
    assert [float(one) for one in column("torque", "turning", *words)] == [20, 15]


def excess(at: float) -> float:
    return 1500 * sin(3 * at) - 600 * sin(at)


def test_the_speed_is_that_of_the_equation_of_motion() -> None:
    """J ω dω/dφ = T - T_L, step by step from the speed at 0° whose extremes have the mean 300/min."""
    angles = [radians(degrees / 20) for degrees in range(7201)]

    def turned(begun: float) -> Any:
        return solve_ivp(
            lambda at, y: [excess(at) / (800 * y[0])], (0, 2 * pi), [begun], "DOP853", dense_output=True,
            rtol=1e-10, atol=1e-10,
        ).sol  # fmt: skip

    def off(begun: float) -> float:
        speeds = turned(begun)(angles)[0]
        return float(max(speeds) + min(speeds)) / 2 - 10 * pi

    solved = turned(brentq(off, 31, 32, xtol=1e-8))
    words = (f"--torque={TORQUE}", f"--load-torque={LOAD}", *WHEEL, "--step=45", "--digits=4")
    for row in records("turning", *words):
        at = radians(float(row["phi"]))
        true = float(solved(at)[0])
        assert float(row["omega"]) == pytest.approx(true, abs=1e-4)
        assert float(row["rpm"]) == pytest.approx(30 * true / pi, abs=1e-3)
        assert float(row["angular_acceleration"]) == pytest.approx(excess(at) / 800, abs=1e-4)
        assert float(row["excess_energy"]) == pytest.approx(quad(excess, 0, at)[0], abs=1e-4)
    # Of half the swing either way; 10000 π J and 50000 π W.
    turn, mean, said = radians(53.7288015618), 10 * pi, page(*words)
    whole = quad(excess, pi - turn, turn)[0]
    assert (
        "mean torque 5000.0 N m, work of a cycle 31.416 kJ, energy swing ΔW = 1656.5 J, power 157.080 kW"
        in said
    )
    assert f"δ = ΔW/(J ω²) = {whole / (800 * mean**2):.7f}" in said
    assert f"nₘₐₓ = {30 / pi * (mean + whole / (1600 * mean)):.2f} min⁻¹" in said
    assert places(*words) == ([53.729, 306.271], [126.271, 233.729])


def accelerations(*words: str) -> tuple[float, list[float], float, list[float]]:
    """Return the greatest acceleration, its angles, the least and its angles."""
    text = " ".join(printed(*words, "--lang=en").out.split()).replace("−", "-")
    found = re.search(r"T_L\)/J greatest (\S+) rad/s² at (.*?), least (\S+) rad/s² at ([-\d.°; to]+)", text)
    assert found
    most, high, least, low = found.groups()
    one, other = ([float(at) for at in re.findall(r"[\d.]+(?=°)", part)] for part in (high, low))
    return float(most), one, float(least), other


def test_waves_are_steepest_where_the_excess_is_greatest() -> None:
    def own(angle: float) -> float:
        return 600 * sin(2 * angle) - 500 * sin(angle)

    top = minimize_scalar(lambda angle: -own(angle), bounds=(pi, 1.5 * pi), options={"xatol": 1e-12})
    words = ("--torque=5000 + 600 sin 2φ", "--load-torque=5000 + 500 sin φ", "--mass=500kg", "--radius=0.4m")
    most, high, least, low = accelerations("flywheel", *words, "--speed=150/min")
    assert (most, least) == pytest.approx((own(top.x) / 80, -own(top.x) / 80), abs=6e-4)
    assert high + low == pytest.approx([top.x * 180 / pi, 360 - top.x * 180 / pi], abs=6e-4)


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ((f"--torque={TRIANGLE}", "--cranks=0;120;240", "--inertia=0.0768kgm2"),
         (292.97, [60, 180, 300], -292.97, [0, 120, 240])),
        (("--torque=0:100;180:100;180:0;360:0", "--inertia=2kgm2"), (25, [0, 180], -25, [180, 360])),
        (("--torque=5000 + 1500 sin 3φ", "--inertia=200kgm2"), (7.5, [30, 150, 270], -7.5, [90, 210, 330])),
        # 8 kJ in two turns: 2000/π N m below the peak of 12 kJ of a triangle over half a turn, 24000/π N m.
        (("--triangles=0;-1;3;0", "--turns=2", "--power=20kW", "--speed=300/min", "--inertia=100kgm2"),
         (70.028, [450], -31.831, [270])),
    ],
)  # fmt: skip
def test_lines_and_waves_have_their_accelerations_at_rational_angles(
    words: tuple[str, ...], expected: tuple[float, list[float], float, list[float]]
) -> None:
    assert accelerations("turning", *words) == expected


@pytest.mark.parametrize(
    ("scale", "unit"),
    [
        ("500 N m; 6°", 500 * pi / 30),
        ("52,5J", 52.5),
        ("1mm = 105 N m; 0.5 rad", 52.5),
        ("0.0525 kN m", 52.5),
    ],
)
def test_the_swing_of_areas_is_the_range_of_their_sums(scale: str, unit: float) -> None:
    """Sums 0, 52, -72, 20, -120, -35, -107: from +52 to -120, 172 mm²."""
    assert float(swing(f"--areas={SEVEN}", f"--area-scale={scale}")) == pytest.approx(172 * unit, abs=6e-10)
    assert "speed greatest at b, least at e" in page(f"--areas={SEVEN}", f"--area-scale={scale}")


def test_areas_have_units_speeds_and_letters() -> None:
    assert float(swing("--areas=35J;-410J;0.285kJ;90 N m")) == 410
    rows = records("turning", "--areas=30J;-70J;40J", "--inertia=2kgm2", "--speed=20rad/s", "--digits=6")
    assert [float(row["excess_energy"]) for row in rows] == [0, 30, -40]
    # ω_max + ω_min = 40, J/2 (ω_max² - ω_min²) = 70.
    most, least = 20 + 70 / 80, 20 - 70 / 80
    speeds = [sqrt(most**2 - 30), most, least]
    assert [float(row["omega"]) for row in rows] == pytest.approx(speeds, abs=1e-6)
    # Levels that are reached twice are named twice, and letters go on after z.
    assert "speed greatest at b; d, least at a; c" in page("--areas=3;-3;3;-3", "--area-scale=1J")
    words = (f"--areas={'1;-1;' * 13}2;-2", "--area-scale=1J")
    assert column("point", "turning", *words)[25:] == ["z", "a₁", "b₁"]
    assert "greatest at b₁, least at a; c;" in page(*words)


def test_triangles_of_strokes_have_their_areas() -> None:
    """Of each 3 J an area; the mean of 3900 J over 4π cuts the first triangle, of the height 2 · 10650/π, and
    leaves (1 - mean/height)² of its area above."""
    words = ("--triangles=+3550;-500;-350;-1400", "--area-scale=3J", "--turns=2")
    height, mean = 2 * 10650 / pi, 3900 / (4 * pi)
    said = page(*words, "--speed=150/min")
    assert f"mean torque {mean:.2f} N m, work of a cycle 3900.0 J" in said
    assert f"ΔW = {10650 * (1 - mean / height) ** 2:.1f} J, power {3900 * 150 / 120:.1f} W" in said
    rows = records("turning", *words, "--angle=0;90;180;720", "--digits=3")
    assert [float(row["torque"]) for row in rows] == pytest.approx([0, height, 0, 0], abs=6e-4)
    assert [float(row["excess_energy"]) for row in rows] == [0, 5325 - 487.5, 10650 - 975, 0]


def test_points_may_be_of_equal_steps_of_half_a_turn_and_in_a_file(tmp_path: Path) -> None:
    half = ("turning", "--torque=0:0; 60:90; 180:0", "--turns=1/2")
    spaced = records(
        "turning", "--torque=every 30°: 0; 45; 90; 67.5; 45; 22.5; 0", "--turns=1/2", "--step=30"
    )
    assert spaced == records(*half, "--step=30")
    assert [row["phi"] for row in spaced] == ["0", "30", "60", "90", "120", "150", "180"]
    assert spaced[1]["torque"] == "45.000"
    points = "torque [kN m];angle [°];remark\n0,03;0;\n0,09;60;peak\n0;180;\n0;360;\n"
    (tmp_path / "t.csv").write_text(points, encoding="utf-8")
    from_file = records("turning", f"--torque-file={tmp_path / 't.csv'}", "--step=20")
    assert from_file == records("turning", "--torque=0:30; 60:90; 180:0; 360:0", "--step=20")


def test_a_machine_gives_way_to_a_diagram() -> None:
    """Steam and masses of its file say nothing of a diagram; its speed does."""
    said = page(f"--machine={ROOT / 'examples' / 'engine.toml'}", "--torque=100 + 20 cos 2φ")
    assert "energy swing ΔW = 20.000 J" in said


def test_drawings_have_the_corners_of_both_torques() -> None:
    figure = drawn(
        kurbel.turning,
        torque="0:0; 61:90; 180:0; 360:0", load_torque="0:30; 135:30; 135:0; 225:0; 225:30; 360:30",
        inertia=5, speed=1, step=90, lang="en",
    ).figure  # fmt: skip
    torques, energy, speed = figure.axes
    curves = [[*map(float, line.get_xdata())] for line in torques.get_lines()]
    assert any(angles.count(135.0) == angles.count(61.0) == 1 for angles in curves)
    assert any(angles.count(135.0) == angles.count(225.0) == 3 for angles in curves)
    assert len(energy.get_lines()) and len(speed.get_lines())
