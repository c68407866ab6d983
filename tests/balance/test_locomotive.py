"""Locomotives: against the forces of cranks and wheels that are turned, and a textbook's example."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from cli import printed
from hypothesis import given, settings
from hypothesis import strategies as st

import kurbel

Row = dict[str, str]
RADIUS, GAUGE, TURNS = 0.31, 1.53, 4
SQUARE = (2 * math.pi * TURNS) ** 2
PHI = np.radians(np.arange(0, 360, 0.25))


def page(*words: str, digits: str = "--digits=6") -> list[Row]:
    return printed("locomotive", *words, digits, "--format=csv").records()


CRANKS = st.lists(
    st.tuples(st.integers(0, 359), st.integers(-1200, 1200), st.integers(50, 400), st.integers(1, 200)),
    min_size=1,
    max_size=4,
)


@settings(max_examples=12, deadline=None)
@given(cranks=CRANKS, percent=st.integers(0, 100))
def test_wheels_and_frame_bear_what_the_turned_masses_do(
    cranks: list[tuple[int, int, int, int]], percent: int
) -> None:
    angle, place, moved, turned = (";".join(map(str, one)) for one in zip(*cranks, strict=True))
    (row,) = page(
        f"--cranks={angle}", f"--positions={place}mm", f"--reciprocating={moved}kg",
        f"--revolving={turned}kg",
        f"--share={percent}%", f"--stroke=crank:{RADIUS}m", f"--gauge={GAUGE}m", f"--speed={TURNS}/s",
        "--wheel=1.7m", "--wheel-load=61kN", "--balance-radius=0.59m",
    )  # fmt: skip
    wheels = [
        (
            float(row[f"mass_{side}_kg"]) * 0.59,
            math.radians(float(row[f"angle_{side}"] or 0)),
            sign * GAUGE / 2,
        )
        for side, sign in (("left", -1), ("right", 1))
    ]
    # Along the slides, and upwards, at the places across the engine.
    pulls = [((m + t) * RADIUS * np.cos(PHI + math.radians(a)), z / 1000) for a, z, m, t in cranks] + [
        (mass * np.cos(PHI + at), z) for mass, at, z in wheels
    ]
    along = SQUARE * sum(pull for pull, _ in pulls)
    sway = SQUARE * sum(pull * z for pull, z in pulls)
    assert float(row["pull_n"]) == pytest.approx(np.max(along), rel=1e-4, abs=1e-2)
    assert float(row["sway_nm"]) == pytest.approx(np.max(sway), rel=1e-4, abs=1e-2)
    for found, curve, unit in ((row["pull_phi"], along, "pull_n"), (row["sway_phi"], sway, "sway_nm")):
        if float(row[unit]) > 1:
            there = np.interp(math.radians(float(found)), PHI, curve)
            assert there == pytest.approx(np.max(curve), rel=1e-4)
    # Upwards the cranks have what turns, and the wheels all of theirs; the moment about either wheel's plane
    # is borne by the other one.
    upright = [(t * RADIUS * np.sin(PHI + math.radians(a)), z / 1000) for a, z, _, t in cranks]
    upright += [(mass * np.sin(PHI + at), z) for mass, at, z in wheels]
    blows = []
    for side, sign in (("left", -1), ("right", 1)):
        other = -sign * GAUGE / 2
        borne = SQUARE * sum(pull * (z - other) for pull, z in upright) / (sign * GAUGE)
        blows.append(np.max(np.abs(borne)))
        assert float(row[f"blow_{side}_n"]) == pytest.approx(blows[-1], rel=1e-4, abs=1e-2)
    assert float(row["load_least_n"]) == pytest.approx(61_000 - max(blows), rel=1e-4, abs=2)
    if row["lift_speed"]:
        lifted = (float(row["lift_speed"]) / 60 / TURNS) ** 2 * max(blows)
        assert lifted == pytest.approx(61_000, rel=1e-4)
        train = float(row["lift_speed"]) / 60 * math.pi * 1.7 * 3.6
        assert float(row["lift_velocity_kmh"]) == pytest.approx(train, abs=1e-5)
        most = float(row["share_most"]) * max(blows) / (percent / 100)
        assert most == pytest.approx(61_000, rel=1e-4)


def test_cranks_at_right_angles_have_the_textbook_s_formulas() -> None:
    words = ("--spacing=0.7m", "--gauge=1.5m", "--stroke=60cm", "--reciprocating=300kg", "--velocity=72km/h")
    (row,) = page(*words, "--wheel=1.6m", "--share=2/3", "--hammer-blow=10kN")
    omega = 20 / 0.8
    whole = 300 * 0.3 * omega**2
    assert float(row["pull_n"]) == pytest.approx(math.sqrt(2) * whole / 3, abs=1e-6)
    assert float(row["sway_nm"]) == pytest.approx(whole / 3 * 0.7 / math.sqrt(2), abs=1e-6)
    assert (row["pull_phi"], row["sway_phi"]) == ("315.000000", "225.000000")
    inner, outer = 1.1 / 1.5, 0.4 / 1.5
    assert float(row["blow_left_n"]) == pytest.approx(2 / 3 * whole * math.hypot(inner, outer), abs=1e-6)
    assert float(row["share_most"]) == pytest.approx(1e4 / whole / math.hypot(inner, outer), abs=1e-6)
    (coupled,) = page(*words, "--wheel=1.6m", "--share=2/3", "--axles=3", "--revolving=150kg")
    assert float(coupled["blow_left_n"]) == pytest.approx(float(row["blow_left_n"]) / 3, abs=1e-6)
    assert coupled["pull_n"] == row["pull_n"]
    at_pins = (150 + 300 * 2 / 9) * 0.3 * math.hypot(inner, outer)
    assert float(coupled["balance_left_kgm"]) == pytest.approx(at_pins, abs=1e-6)
    assert float(row["angle_left"]) == pytest.approx(180 + math.degrees(math.atan(outer / inner)), abs=1e-6)
    assert float(row["speed"]) == pytest.approx(omega * 30 / math.pi, abs=1e-6)


def test_what_is_balanced_wholly_or_not_at_all_is_nought() -> None:
    words = ("--spacing=2m", "--gauge=1.5m", "--stroke=60cm", "--reciprocating=300kg", "--speed=20rad/s")
    none, whole = page(*words, "--share=0;1", digits="--lang=de")
    assert (none["blow_left_n"], none["balance_left_kgm"], none["angle_left"]) == ("0", "0", "")
    assert (whole["pull_n"], whole["sway_nm"], whole["pull_phi"]) == ("0", "0", "")


def test_a_machine_gives_what_it_says_of_a_locomotive_and_its_cranks(tmp_path: Path) -> None:
    machine = tmp_path / "engine.toml"
    machine.write_text(
        '[crank]\nstroke = "60cm"\nspeed = "5/s"\nangles = [0, 90]\n[masses]\nreciprocating = "300kg"\n',
        "utf-8",
    )
    wheels = ("--spacing", "0.7m", "--gauge", "1.5m", "-f", "csv")
    typed = ("--stroke", "60cm", "--speed", "5/s", "--cranks", "0;270", "--reciprocating", "300kg")
    assert (
        printed("locomotive", "--machine", str(machine), *wheels).out
        == printed("locomotive", *typed, *wheels).out
    )
    found = kurbel.locomotive(machine=str(machine), spacing=0.7, gauge=1.5)
    assert kurbel.typeset(found, "csv") == printed("locomotive", *typed, *wheels).out
    # A crank of a machine follows the first by its angle, so that it lies so far behind it.
    firing = printed("firing", "--machine", str(machine), "-f", "csv").out
    assert firing == printed("firing", "--cranks", "0;270", "-f", "csv").out
    forces = ("balance", "--ratio", "1:4", "--angle", "20;75", "-f", "csv")
    followed = printed(*forces, "--machine", str(machine), "--reciprocating", "2kg").out
    assert (
        followed
        == printed(
            *forces, "--cranks", "0;270", "--stroke", "60cm", "--speed", "5/s", "--reciprocating", "2kg"
        ).out
    )
    masses = ("--masses", "3;4kg", "--radii", "100mm", "--angles", "0;90", "-f", "csv")
    rotor = printed("rotor", "--machine", str(machine), *masses).out
    assert rotor == printed("rotor", *masses, "--speed", "5/s").out
