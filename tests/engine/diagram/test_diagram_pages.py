"""What `kurbel turning` and `kurbel plot --turning` make of diagrams: pages, speeds, files and refusals."""

from __future__ import annotations

from math import pi, radians, sin, sqrt
from pathlib import Path
from typing import Any

import pytest
from cli import kurbel as run
from cli import printed
from places import ROOT
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq

import kurbel

TORQUE, LOAD = "5000 + 1500 sin(3φ)", "5000 + 600 sin φ"
WHEEL = ("--inertia=800kgm2", "--speed=300/min")


def records(*words: str) -> list[dict[str, str]]:
    return printed("turning", *words, "-f", "csv").records()


def said(*words: str) -> str:
    """Return the page in one line."""
    return " ".join(printed("turning", *words, "--lang=en").out.split())


def refused(*words: str) -> str:
    result = run("turning", *words)
    assert result.code and not result.out
    return result.err


def excess(at: float) -> float:
    return 1500 * sin(3 * at) - 600 * sin(at)


def test_the_speed_is_that_of_the_equation_of_motion() -> None:
    """J ω dω/dφ = T - T_L, step by step from the speed at 0° whose extremes have the mean 300/min."""
    places = [radians(degrees / 20) for degrees in range(7201)]

    def turned(begun: float) -> Any:
        return solve_ivp(
            lambda at, y: [excess(at) / (800 * y[0])], (0, 2 * pi), [begun], "DOP853", dense_output=True,
            rtol=1e-10, atol=1e-10,
        ).sol  # fmt: skip

    def off(begun: float) -> float:
        speeds = turned(begun)(places)[0]
        return float(max(speeds) + min(speeds)) / 2 - 10 * pi

    solved = turned(brentq(off, 31, 32, xtol=1e-8))
    for row in records(f"--torque={TORQUE}", f"--load-torque={LOAD}", *WHEEL, "--step=45", "--digits=4"):
        at = radians(float(row["phi"]))
        true = float(solved(at)[0])
        assert float(row["omega"]) == pytest.approx(true, abs=1e-4)
        assert float(row["rpm"]) == pytest.approx(30 * true / pi, abs=1e-3)
        assert float(row["angular_acceleration"]) == pytest.approx(excess(at) / 800, abs=1e-4)
        assert float(row["excess_energy"]) == pytest.approx(quad(excess, 0, at)[0], abs=1e-4)


def test_a_page_says_what_follows_of_the_cycle() -> None:
    page = said(f"--torque={TORQUE}", f"--load-torque={LOAD}", *WHEEL)
    for part in (
        # 10000 π J and 50000 π W.
        "mean torque 5000.0 N m, work of a cycle 31.416 kJ, energy swing ΔW = 1656.5 J, power 157.080 kW",
        "speed greatest at 53.729°; 306.271°, least at 126.271°; 233.729°",
    ):
        assert part in page
    # By the speeds at both extremes, of half the swing either way.
    turn = radians(53.7288015618)
    swing = quad(excess, pi - turn, turn)[0]
    mean = 10 * pi
    assert f"δ = ΔW/(J ω²) = {swing / (800 * mean**2):.7f}" in page
    assert f"nₘₐₓ = {30 / pi * (mean + swing / (1600 * mean)):.2f} min⁻¹" in page


def test_the_speeds_at_the_ends_of_areas() -> None:
    rows = records("--areas=30J;-70J;40J", "--inertia=2kgm2", "--speed=20rad/s", "--digits=6")
    assert [row["point"] for row in rows] == ["a", "b", "c"]
    assert [float(row["excess_energy"]) for row in rows] == [0, 30, -40]
    # ω_max + ω_min = 40, J/2 (ω_max² - ω_min²) = 70.
    most, least = 20 + 70 / 80, 20 - 70 / 80
    speeds = [sqrt(most**2 - 30), most, least]
    assert [float(row["omega"]) for row in rows] == pytest.approx(speeds, abs=1e-6)


def test_triangles_of_strokes_have_their_areas() -> None:
    """Of each 3 J an area; the mean of 3900 J over 4π cuts the first triangle, of the height 2 · 10650/π, and
    leaves (1 - mean/height)² of its area above."""
    words = ("--triangles=+3550;-500;-350;-1400", "--area-scale=3J", "--turns=2")
    height, mean = 2 * 10650 / pi, 3900 / (4 * pi)
    page = said(*words, "--speed=150/min")
    assert f"mean torque {mean:.2f} N m, work of a cycle 3900.0 J" in page
    assert f"ΔW = {10650 * (1 - mean / height) ** 2:.1f} J, power {3900 * 150 / 120:.1f} W" in page
    rows = records(*words, "--angle=0;90;180;720", "--digits=3")
    assert [float(row["torque"]) for row in rows] == pytest.approx([0, height, 0, 0], abs=6e-4)
    assert [float(row["excess_energy"]) for row in rows] == [0, 5325 - 487.5, 10650 - 975, 0]


def test_values_at_equal_steps_are_points() -> None:
    spaced = records("--torque=every 30°: 0; 45; 90; 67.5; 45; 22.5; 0", "--turns=1/2", "--step=20")
    assert spaced == records("--torque=0:0; 60:90; 180:0", "--turns=1/2", "--step=20")


def test_a_diagram_of_half_a_turn_has_pages_of_half_a_turn() -> None:
    rows = records("--torque=0:0; 60:90; 180:0", "--turns=1/2", "--step=30")
    assert [row["phi"] for row in rows] == ["0", "30", "60", "90", "120", "150", "180"]
    assert rows[1]["torque"] == "45.000"


def test_files_are_points(tmp_path: Path) -> None:
    points = "torque [kN m];angle [°];remark\n0,03;0;\n0,09;60;peak\n0;180;\n0;360;\n"
    (tmp_path / "t.csv").write_text(points, encoding="utf-8")
    from_file = records(f"--torque-file={tmp_path / 't.csv'}", "--step=20")
    assert from_file == records("--torque=0:30; 60:90; 180:0; 360:0", "--step=20")
    (tmp_path / "t.csv").write_text("angle;moment\n0;1\n", encoding="utf-8")
    assert "there is no column torque" in refused(f"--torque-file={tmp_path / 't.csv'}")


@pytest.mark.parametrize(
    ("words", "why"),
    [
        ("--torque=5+sinφ --eps=4", "--eps describes an engine, and --torque a diagram without one"),
        ("--turns=2 --eps=4", "--turns is for a diagram without an engine; add --torque"),
        ("--area-scale=4J", "--area-scale is for --areas or --triangles; add these"),
        ("--areas=5J;-5J --torque=5", "--areas is a whole diagram, and --torque says of another one"),
        ("--areas=5J;-5J --step=4", "--step is of crank angles, which areas do not have"),
        ("--areas=5J;-5J --columns=level", "these are energies, add --area-scale"),
        (
            "--triangles=3J;-1J --turns=2 --power=2kW",
            "--power gives the scale of triangles, and these have one",
        ),
        ("--triangles=3J;-1J", "--triangles need the turns of their cycle; add --turns 2"),
        ("--triangles=3J;-1J --turns=2 --load-torque=5", "--triangles are against a constant load"),
        ("--triangles=3J;-1J --torque=5", "--torque and --triangles give the torque twice"),
        ("--triangles=3;-1 --turns=2 --area-scale=3Nm;6°", "would make one with π, write the angle in rad"),
        ("--layout=areas", "no areas were given; add --areas"),
        ("--layout=torques", "no torque was given; add --torque"),
        ("--torque=x.csv", "--torque x.csv is a file; name it as --torque-file"),
        ("--torque=5 --torque-file=x.csv", "--torque and --torque-file give the torque twice"),
        ("--load-torque=5+sinφ --cranks=0;90", "--cranks are those of the drive; add its --torque"),
        ("--torque=5+sinφ --columns=rpm", "column rpm needs --inertia and --speed"),
        ("--torque=5+sinφ --inertia=0.01kgm2 --speed=1/min", "comes to rest"),
        ("--torque=5+sinφ --turns=0", "a cycle of 0 turns was given; it must be above 0 and at most 100"),
        ("--torque=5+sinφ --angle=3 --step=4", "use one or the other"),
    ],
)
def test_what_contradicts_is_refused(words: str, why: str) -> None:
    assert why in refused(*words.split())


def test_a_machine_gives_way_to_a_diagram() -> None:
    """Steam and masses of its file say nothing of a diagram; its speed does."""
    page = said(f"--machine={ROOT / 'examples' / 'engine.toml'}", "--torque=100 + 20 cos 2φ")
    assert "energy swing ΔW = 20.000 J" in page


def test_drawings_have_the_corners_of_both_torques() -> None:
    figure = kurbel.plot_turning(
        torque="0:0; 61:90; 180:0; 360:0", load_torque="0:30; 135:30; 135:0; 225:0; 225:30; 360:30",
        inertia=5, speed=1, step=90, lang="en",
    ).figure  # fmt: skip
    torques, energy, speed = figure.axes
    drawn = [[*map(float, line.get_xdata())] for line in torques.get_lines()]
    assert [0.0, 61.0, 90.0, 180.0, 270.0, 360.0] in drawn
    assert any({135.0, 225.0} <= {*angles} and 61.0 not in angles for angles in drawn)
    assert len(energy.get_lines()) and len(speed.get_lines())
