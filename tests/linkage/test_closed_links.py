"""Arc crank and beam engine against their links enclosed: motion, forces, dead centres, floats, ties."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from cli import records
from drives import ARCS, BEAMS, Drive, confirm, of_size
from numpy.testing import assert_allclose

import kurbel
from kurbel.verify import CONFIRMED

EACH = pytest.mark.parametrize("drive", [*ARCS, *BEAMS], ids=str)
MOTIONS = (
    "path", "velocity", "acceleration", "turn", "turn_velocity", "turn_acceleration", "rocker", "rod",
    "rod_velocity", "rod_acceleration", "slant",
)  # fmt: skip
OF_ARCS = ("chord", "slide_path", "rise")
FORCES = ("rod_force", "guide_force", "tangential_force", "radial_force", "torque")


@EACH
def test_every_digit_of_motion_and_forces_is_that_of_the_closed_links(drive: Drive) -> None:
    motions = MOTIONS if "--mechanism=beam" in drive.words else (*MOTIONS, *OF_ARCS)
    for end, angles in (("", "--angle=0;251"), ("_return", "--angle=38.5;180")):
        for command, names in (("table", motions), ("forces", FORCES)):
            keys = [f"{name}{end}" for name in names]
            asked = (*drive.words, angles, "--digits=12", f"--columns=phi,{','.join(keys)}")
            confirm(drive.true, records(command, *asked), keys)


@EACH
def test_dead_centres_bound_the_way_and_are_where_the_links_rest(drive: Drive) -> None:
    keys = {key: key for key in ("phi_i", "phi_o", "lead", "time_ratio", "swing", "stroke", "transmission")}
    keys |= {"v_mps": "v_mps", "c_m_mps": "c_m_mps", "v_c_m": "v_c_m", "outstroke_time": "outstroke_time"}
    sized = (*drive.words, "--stroke=2m", "--speed=3rad/s", "--digits=12", f"--columns={','.join(keys)}")
    (found,) = records("deadcentres", *sized)
    for key in keys:
        assert of_size(drive, "1", "3").true.value(key).confirms(found[key]) == CONFIRMED, key
    curves = kurbel.compute(np.linspace(0, 360, 2001), columns="path,velocity", **drive.options)
    assert curves["path"].min() >= 0
    assert curves["path"].max() <= float(found["stroke"]) + 2e-12
    # No other standstill: the velocity changes its sign twice.
    assert (np.diff(np.sign(curves["velocity"])) != 0).sum() == 2


# Far from symmetry conditions are solved about another angle than 90°.
@EACH
def test_conditions_hold_where_the_links_say(drive: Drive) -> None:
    begin, end = (float(drive.true.value(f"phi_{side}")) for side in "io")
    middle = f"{drive.true.value('rocker', 90).digits(2)}"
    for key, aim, most in (("acceleration", "0", 6), ("velocity", "0.25", 4), ("rocker", middle, 2)):
        asked = ("--where", f"{key}={aim}", "--columns=phi_turn", "--digits=9")
        rows = records("solve", *drive.words, *asked)
        assert 2 <= len(rows) <= most, key
        for row in rows:
            degrees = Fraction(row["phi_turn"])
            # On the return a velocity counts in its direction.
            out = (float(degrees) - begin) % 360 < end - begin
            found = (
                drive.true.value(key, degrees) if out else drive.true.value(f"{key}_return", degrees - 180)
            )
            assert float(found) == pytest.approx(float(aim), abs=2e-8), (key, degrees)


@pytest.mark.parametrize("drive", ARCS[:4], ids=str)
def test_floats_keep_their_place_beside_a_dead_centre(drive: Drive) -> None:
    angle = float(drive.true.value("phi_i")) + 1e-5
    (found,) = kurbel.compute([angle], columns="chord", **drive.options)["chord"]
    page = (*drive.words, f"--angle={Fraction(angle)}", "--columns=chord", "--digits=40")
    # The path is some 1e-14; from 1 - cos χ it would be known to 1e-16.
    assert abs(found - float(records("table", *page)[0]["chord"])) < 3e-22


@pytest.mark.parametrize(("ratio", "offset"), [("1:5", "0"), ("2:7", "0.7"), ("2:7", "-0.7")])
@pytest.mark.parametrize("side", [1, -1])
def test_a_long_rocker_prints_the_pages_of_the_slide_digit_for_digit(
    ratio: str, offset: str, side: int
) -> None:
    rocker = 10**9 - 10
    rod = {"1:5": "5", "2:7": "3.5"}[ratio]
    pivot = ("--pivot", f"{rod};{Fraction(offset) + side * rocker}") if side < 0 else (f"--offset={offset}",)
    arc = (f"--ratio={ratio}", "--mechanism=arc", f"--rocker={rocker}", *pivot, "--step=15", "--to=180")
    slide = (f"--ratio={ratio}", f"--offset={offset}", "--step=15", "--to=180")
    motion = {"path": "x", "velocity": "c", "acceleration": "p", "rod": "psi"}
    forces = ("rod_force", "guide_force", "tangential_force", "radial_force")
    for command, pairs in (("table", motion), ("forces", dict(zip(forces, forces, strict=True)))):
        names = [[f"{key}{end}" for key in one for end in ("", "_return")] for one in (pairs, pairs.values())]
        found, true = (
            [[row[key] for key in keys] for row in records(command, *words, "--columns", ",".join(keys))]
            for words, keys in zip((arc, slide), names, strict=True)
        )
        assert len(found) == 13
        assert found == true


def test_a_chord_through_the_shaft_makes_the_strokes_equal() -> None:
    # Rocker 5/3, chord 2 and their distance 4/3 from the pivot: G² = L² + B² - R².
    central = ("--mechanism=arc", "--ratio=1:5", "--rocker=5/3", "--pivot=5;4/3")
    (row,) = records("deadcentres", *central, "--digits=9")
    assert (row["phi_i"], row["phi_o"], row["time_ratio"]) == ("0.000000000", "180.000000000", "1.000000000")
    assert float(row["swing"]) == pytest.approx(2 * math.degrees(math.asin(3 / 5)), abs=1e-9)
    (row,) = records("table", *central, "--angle=180", "--columns=chord", "--digits=30")
    assert row == {"chord": "2." + 30 * "0"}


# Where crank and rod are in line p is (1 + λ)/cos ψ, and the rocker leans by asin 3/5 from the slide's
# perpendicular: 1.25 (1 + λ) is 1.5, 1.625 and, no tie, 1.3; S is 1.25.
IN_LINE = "--ratio=1:{0} --rocker=5/3 --pivot={0};4/3 --angle=0"
# The rod's end moves along (5, -12)/13 where the rod lies along (4, 3)/5: (4/5) · 65/16 at 90°.
STEEP = "--ratio=1:5 --rocker=4 --pivot=4/13;32/13 --angle={}"
# From (3.25, 0) to (0, 1.25), the outer dead centre at 270°.
RIGHT = "--ratio=4:9 --rocker=485/236 --pivot=291/236;-93/236 --angle={}"


@pytest.mark.parametrize(
    ("drive", "key", "digits", "away", "even"),
    [
        (IN_LINE.format("5"), "acceleration", 0, "2", "2"),
        (IN_LINE.format("10/3"), "acceleration", 2, "1.63", "1.62"),
        (IN_LINE.format("25"), "acceleration", 0, "1", "1"),
        (IN_LINE.format("5"), "rod_force", 1, "1.3", "1.2"),
        (IN_LINE.format("5"), "rod_force", 2, "1.25", "1.25"),
        (STEEP.format("90"), "velocity", 1, "3.3", "3.2"),
        (STEEP.format("90.0001"), "velocity", 1, "3.3", "3.3"),
        (RIGHT.format("270"), "slide_path", 1, "3.3", "3.2"),
        (RIGHT.format("270"), "rise", 1, "1.3", "1.2"),
        (RIGHT.format("270.001"), "slide_path", 1, "3.2", "3.2"),
        (RIGHT.format("270.001"), "rise", 1, "1.3", "1.3"),
    ],
)
def test_ties_are_told(drive: str, key: str, digits: int, away: str, even: str) -> None:
    command = "forces" if key == "rod_force" else "table"
    for rounding, expected in (("half-away", away), ("half-even", even)):
        asked = (*drive.split(), f"--columns={key}", f"--digits={digits}", f"--rounding={rounding}")
        assert records(command, "--mechanism=arc", *asked) == [{key: expected}]


def test_a_rod_angle_of_whole_degrees_prints_as_such() -> None:
    # Pin at (0, 1), pivot at (1.5, 6), their distance² 27.25 = L² + B² - 2 L B sin 30°.
    words = ("--mechanism=arc", "--ratio=1:2.5", "--rocker=6", "--pivot=1.5;6", "--angle=90", "--digits=12")
    assert records("table", *words, "--columns=slant") == [{"slant": "30." + 12 * "0"}]


@pytest.mark.parametrize("offset", ["0", "31/30", "-51/20"])
def test_an_infinite_rod_moves_the_rocker_by_the_versine_along_the_slide(offset: str) -> None:
    words = ("--mechanism=arc", "--ratio=1:∞", "--rocker=13/10", f"--offset={offset}", "--digits=12")
    rows = records("table", *words, "--step=20", "--to=360", "--columns=phi,slide_path")
    for row in rows:
        versine = 1 - math.cos(math.radians(float(row["phi"])))
        assert float(row["slide_path"]) == pytest.approx(versine, abs=2e-12)
    (row,) = records("deadcentres", *words, "--columns=swing")
    assert_allclose(float(row["swing"]), 2 * math.degrees(math.asin(10 / 13)), rtol=0, atol=1e-11)


def test_an_infinite_rod_of_a_beam_stays_vertical() -> None:
    words = ("--mechanism=beam", "--beam=3", "--ratio=1:∞", "--digits=9")
    rows = records("table", *words, "--angle=0;180", "--columns=phi,path,velocity")
    ends = ["0.000000000", f"{6 * math.asin(1 / 3):.9f}"]
    assert [row["path"] for row in rows] == ends
    assert [row["velocity"] for row in rows] == 2 * ["0.000000000"]
    # Its dead centres and the zero of its acceleration are at quarters of the turn.
    found = records("solve", *words, "--where", "p=0", "--columns=phi_turn")
    assert [row["phi_turn"] for row in found] == ["90.000000000", "270.000000000"]
