"""Conditions on the forces of an engine and on forces in newtons, against quadrature and closed forms."""

from __future__ import annotations

import math
import random
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from cli import column, printed, records
from machines import machine
from numpy.testing import assert_allclose
from places import ROOT
from verified import verified, words

from kurbel.verify import CONFIRMED

CSV = ("-f", "csv")
SIZE = ("--bore=300mm", "--pressure=8bar", "--stroke=600mm")
# A hundredth of a degree apart.
DEGREES, GRID = np.linspace(0, 360, 36_001), 2e-5


def _engines() -> list[dict[str, Any]]:
    rng = random.Random(13)
    return [
        {
            "eps": f"{rng.randint(12, 60) / 10}", "ratio": f"{rng.randint(10, 40) / 100}",
            "back": f"{rng.randint(2, 12) / 100}", "exponent": f"{rng.choice([100, 113, 130]) / 100}",
            "clearance": f"{rng.randint(0, 8) / 100}", "single_acting": rng.random() >= 0.7,
            "cranks": "0;90" if rng.random() < 0.5 else "0",
        }
        for _ in range(6)
    ]  # fmt: skip


def _force(options: dict[str, Any]) -> np.ndarray[Any, Any]:
    found: np.ndarray[Any, Any] = machine(**options).force(DEGREES)
    return found


@pytest.mark.parametrize("options", _engines(), ids=lambda one: one["eps"])
def test_all_angles_are_those_at_which_a_fine_grid_crosses_the_value(options: dict[str, Any]) -> None:
    force = _force(options)
    value = round(float(force.max()) * 0.6, 3)
    apart = force - value
    crossed = np.flatnonzero(np.sign(apart[:-1]) * np.sign(apart[1:]) < 0)
    wanted = DEGREES[crossed] + DEGREES[1] * apart[crossed] / (apart[crossed] - apart[crossed + 1])
    asked = ("solve", *words(options), "--columns=phi", f"--where=tangential={value}", "--digits=7")
    assert_allclose([float(one) for one in column("phi", *asked)], wanted, rtol=0, atol=GRID * 10)


@pytest.mark.parametrize("options", _engines()[:3], ids=lambda one: one["eps"])
def test_the_energy_is_greatest_and_the_torque_least_where_they_truly_are(options: dict[str, Any]) -> None:
    columns = "--columns=condition,phi,energy,tangential"
    asked = ("solve", *words(options), columns, "--digits=7", "--where=energy=max", "--where=torque=min")
    found = records(*asked)
    (energy,) = (one for one in found if one["condition"] == "energy = max")
    torque = [one for one in found if one["condition"] == "torque = min"]
    turn = verified(**options)
    assert turn.value("v_max").confirms(energy["energy"]) == CONFIRMED
    assert turn.value("alpha_max").confirms(energy["phi"]) == CONFIRMED
    assert_allclose(float(torque[0]["tangential"]), _force(options).min(), rtol=0, atol=1e-6)


def test_at_an_angle_of_many_digits_the_force_is_the_value() -> None:
    options = {"eps": "3", "ratio": "1:4", "back": "0.1"}
    turn = verified(**options)
    for one in records(
        "solve", *words(options), "--columns=phi,energy", "--digits=28", "--where=tangential=0.3"
    ):
        # The angle is rounded, and the force there by its slope.
        assert abs(turn.value("tangential", one["phi"]).near() - Fraction("0.3")) < Fraction(1, 10**27)
        assert abs(turn.value("energy", one["phi"]).near() - Fraction(one["energy"])) < Fraction(1, 10**27)


def test_a_torque_in_newton_metres_is_that_of_the_forces_times_the_crank() -> None:
    found = printed("solve", "--eps=4", *SIZE, "--where=torque=5kNm", *CSV).records()
    unit = math.pi / 4 * 0.3**2 * 800_000 * 0.3
    shares = printed("solve", "--eps=4", f"--where=tangential={5000 / unit:.12f}", *CSV).records()
    assert [one["phi"] for one in found] == [one["phi"] for one in shares]
    assert {one["torque_nm"] for one in found} == {"5000.0"}
    assert len(found) == 4


def test_a_rod_force_in_newtons_is_had_where_the_rod_stands_so_steep() -> None:
    words = ("solve", "--ratio=1:4", "--force=10kN", "--where=rod_force=10.2kN", "--columns=stroke,phi", *CSV)
    steep = math.degrees(math.asin(4 * math.sqrt(1 - (10 / 10.2) ** 2)))
    found = [float(one["phi"]) for one in printed(*words).records()]
    assert_allclose(found, [steep, 180 - steep] * 2, rtol=0, atol=5.1e-5)


@pytest.mark.parametrize(
    ("magnitude", "signed"), [("min", ["=0"]), ("0", ["=0"]), ("0.1", ["=0.1", "=-0.1"])]
)
def test_a_magnitude_is_had_where_its_force_has_it_with_either_sign(
    magnitude: str, signed: list[str]
) -> None:
    words = ("solve", "--eps=4", "--clearance=5%", "--back=0.3", "--columns=phi", "--digits=6", *CSV)
    found = printed(*words, f"--where=bearing_force={magnitude}").records()
    either = [one for sign in signed for one in printed(*words, f"--where=rod_force{sign}").records()]
    assert_allclose(
        [float(one["phi"]) for one in found], sorted(float(one["phi"]) for one in either), 0, 1e-7
    )


def test_masses_on_the_beam_engine_move_the_greatest_torque_to_where_the_turning_effort_has_it() -> None:
    masses = (
        "--beam=3",
        "--reciprocating=80kg",
        "--speed=200/min",
        *SIZE,
        "--eps=2",
        "--mechanism=beam",
        *CSV,
    )
    found = printed("solve", *masses, "--where=torque=max", "--columns=phi,torque_nm").records()
    run = printed("turning", *masses, "--step=0.5", "--columns=phi,torque_nm").records()
    highest = max(run, key=lambda row: float(row["torque_nm"]))
    assert_allclose(float(found[0]["phi"]), float(highest["phi"]), rtol=0, atol=0.5)
    # The corner at cut-off lies between two angles of the run.
    assert_allclose(float(found[0]["torque_nm"]), float(highest["torque_nm"]), rtol=1e-3, atol=0)


@pytest.mark.parametrize(("back", "away", "even"), [("0.375", "0.63", "0.62"), ("0.37501", "0.62", "0.62")])
def test_a_force_half_way_at_a_dead_centre_is_rounded_as_one(back: str, away: str, even: str) -> None:
    words = ("solve", "--eps=4", f"--back={back}", "--where=tangential=0", "--digits=2", *CSV)
    for rounding, force in (("half-away", away), ("half-even", even)):
        found = printed(*words, "--columns=phi,rod_force,radial_force", f"--rounding={rounding}").records()
        # There the rod has the force of the piston, 1 less the back pressure.
        dead = [row for row in found if row["phi"] in ("0.00", "180.00")]
        assert [[row["rod_force"], row["radial_force"]] for row in dead] == [
            [force, force],
            [f"-{force}", force],
        ]


def test_a_force_that_is_constant_over_a_stroke_is_greatest_at_both_of_its_ends() -> None:
    words = ("solve", "--pump", "--where=piston_force=max", "--columns=phi,piston_force", *CSV)
    assert printed(*words).records() == [
        {"phi": "180.0000", "piston_force": "1.0000"},
        {"phi": "360.0000", "piston_force": "1.0000"},
    ]


def test_the_torque_of_two_cranks_is_greatest_where_a_fine_grid_has_it() -> None:
    words = ("solve", "--eps=4", "--cranks=0;100", "--where=torque=max", "--columns=phi,tangential", *CSV)
    found = printed(*words, "--digits=6").records()
    greatest = _force({"eps": "4", "cranks": "0;100"}).max()
    assert (
        printed(*words[:3], "--where=|torque|=max", *words[4:], "--digits=6").records()[0]["phi"]
        == found[0]["phi"]
    )
    # The torque is greatest in a corner, which the grid may miss by its step times the slope there.
    assert_allclose([float(one["tangential"]) for one in found], [greatest], rtol=0, atol=2e-4)


def test_a_machine_with_steam_still_has_conditions_on_its_motion() -> None:
    words = ("--machine", str(ROOT / "examples" / "engine.toml"), "--where=p=0", "--columns=stroke,phi", *CSV)
    assert printed("solve", *words).records() == printed("solve", "--ratio=1:5", *words[2:]).records()
