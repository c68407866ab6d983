"""Pressures on both sides of the piston, its rods and friction: against the bodies of kurbel.verify."""

from __future__ import annotations

from fractions import Fraction
from math import pi
from random import Random
from typing import Any

import pytest
from figures import rows

import kurbel
from kurbel import verify

PARTS = "piston_force_n,inertia_force_n,weight_force_n,friction_force_n,crosshead_load_n"
FORCES = f"phi,{PARTS},rod_force_n,guide_force_n,crank_pin_force_n,torque_nm,radial_force_n,bearing_along_n"
PRESSED: dict[str, Any] = {
    "bore": "300mm", "piston_rod": "50mm", "tail_rod": "40mm", "head_pressure": "1.2bar",
    "crank_pressure": "0.3bar",
}  # fmt: skip
PUSH = pi / 4 * ((0.3**2 - 0.04**2) * 1.2e5 - (0.3**2 - 0.05**2) * 0.3e5)


def rows_of(**asked: Any) -> list[dict[str, float]]:
    found = rows(kurbel.forces(**asked))
    return [{key: float(value) for key, value in row.items() if key != "ratio"} for row in found]


@pytest.mark.parametrize("seed", range(10, 14))
def test_forces_are_those_of_the_bodies_under_pressure_and_friction(seed: int) -> None:
    chance = Random(seed)

    def number(low: float, high: float, places: int = 2) -> str:
        return f"{chance.uniform(low, high):.{places}f}"

    radius, share = number(0.1, 0.4), number(2.5, 5)
    offset = chance.choice(["0", number(-0.3, 0.3)])
    speed, slope, gravity = number(5, 30), number(-180, 180, 0), number(9.7, 9.9)
    weights = {"reciprocating": number(50, 400), "rod_mass": number(40, 200), "rotating": number(-50, 80)}
    rod = {"centre": number(0.3, 0.8), "gyration": number(0.2, 0.4), "slope": slope, "gravity": gravity}
    drive = verify.drive(f"1:{share}", offset, radius=radius, speed=speed)
    # The pressures push towards the shaft, whatever the stroke is.
    bodies = verify.bodies(drive, force=Fraction(PUSH), friction=1234, **weights, **rod)
    asked = {
        "ratio": f"1:{share}", "offset": offset, "stroke": f"{2 * float(radius):.2f}m",
        "speed": f"{speed}rad/s", **{key: f"{value}kg" for key, value in weights.items()}, **rod,
        **PRESSED, "friction": "1234N",
    }  # fmt: skip
    for row in rows(
        kurbel.forces(**asked, angle=(33, 141, 199, 318), digits=5, columns=f"{FORCES},reversing_speed")
    ):
        held = float(row["crosshead_load_n"]) - float(row["inertia_force_n"])
        assert (not row["reversing_speed"]) is (held * float(row["inertia_force_n"]) > 0)
        for key in [key for key, value in row.items() if key != "phi" and value]:
            value = bodies.value(key, row["phi"])
            assert value.confirms(row[key]) == verify.CONFIRMED, (seed, row["phi"], key)


def test_a_torque_less_that_of_a_power_accelerates_the_shaft() -> None:
    # Khurmi and Gupta, example 15.12, of first order: (3929 N m - 20 kW/ω)/J.
    asked = dict(stroke="400mm", rod="600mm", bore="250mm", piston_rod="50mm", head_pressure="550kPa")
    asked |= dict(crank_pressure="70kPa", reciprocating="60kg", speed="120/min", inertia="21.6kgm2")
    columns = "torque_nm,angular_acceleration"
    (row,) = rows_of(**asked, power="20kW", angle=45, method="series", columns=columns)
    assert row["torque_nm"] == pytest.approx(3929.03, abs=0.05)
    assert row["angular_acceleration"] == pytest.approx((3929.026 - 20000 / (4 * pi)) / 21.6, abs=0.006)


def test_the_return_stroke_has_the_pressures_against_it_and_friction_too() -> None:
    columns = "piston_force_return_n,friction_force_return_n,crosshead_load_return_n"
    (row,) = rows_of(ratio="1:4", **PRESSED, friction=70, angle=50, columns=columns, digits=4)
    assert row["piston_force_return_n"] == pytest.approx(-PUSH, abs=6e-5)
    assert row["friction_force_return_n"] == -70
    assert row["crosshead_load_return_n"] == pytest.approx(-PUSH - 70, abs=6e-5)


def test_columns_of_the_outstroke_say_so_at_angles_of_the_return() -> None:
    # The pressures push towards the shaft, in the direction of the outstroke, on the return, too.
    for angle, beyond in ((210, True), (570, True), (150, False)):
        asked: dict[str, Any] = {"stroke": "1m", "ratio": "1:4", **PRESSED, "angle": angle, "digits": 3}
        assert rows_of(**asked, columns="piston_force_n")[0]["piston_force_n"] == pytest.approx(
            PUSH, abs=6e-4
        )
        text = " ".join(kurbel.typeset(kurbel.forces(**asked, lang="en"), "text").split())
        assert ("beyond the outer dead centre directions remain those of the outstroke" in text) == beyond


def test_friction_at_a_dead_centre_is_that_of_the_stroke_which_begins_there() -> None:
    # sin φ_i = e/(L + R) = 1/2, which no ball tells from the dead centre.
    lengths: dict[str, Any] = {"stroke": "crank:0.1m", "rod": "0.4m", "offset": "0.25m"}
    asked = {**lengths, "force": 1, "friction": 9}
    angles = {30: -9, "29.99999999999999999999": 9, "30.00000000000000000001": -9, 180: -9}
    found = [rows_of(**asked, angle=angle, columns="friction_force_n")[0] for angle in angles]
    assert [row["friction_force_n"] for row in found] == [*angles.values()]
    straight = rows_of(ratio="1:4", force=1, friction=9, angle=(0, 180, 360), columns="friction_force_n")
    assert [row["friction_force_n"] for row in straight] == [-9, 9, -9]
    arrays = kurbel.compute([0, 179, 180, 360], "1:4", ["friction_force_n"], force=1, friction=9)
    assert arrays["friction_force_n"].tolist() == [-9, -9, 9, -9]


def test_a_sum_half_way_between_two_printed_numbers_is_a_tie() -> None:
    asked: dict[str, Any] = {"ratio": "1:4", "force": 1000, "friction": "499.75N", "angle": 90}
    (row,) = rows_of(**asked, columns="crosshead_load_n", rounding="half-even")
    assert row["crosshead_load_n"] == 500.2
