"""Engines with friction and piston rods: against bodies, sums over small steps and pressures times areas."""

from __future__ import annotations

from math import pi
from pathlib import Path
from typing import Any

import pytest
from drawn_machines import compared
from figures import rows
from machines import machine

import kurbel

Q = 0.3**2 / 4 * pi * 6e5
STEAM: dict[str, Any] = {"eps": 3, "back": "0.1", "bore": "300mm", "pressure": "6bar"}
PARTS = "phi,piston_force_n,friction_force_n,weight_force_n,crosshead_load_n,guide_force_n,torque_nm"


def rows_of(page: Any) -> list[dict[str, float]]:
    return [{key: float(value) for key, value in row.items()} for row in rows(page)]


@pytest.mark.parametrize("slope", ("25", "-110"))
def test_forces_of_an_engine_are_those_of_bodies_with_friction_and_weight(slope: str) -> None:
    options = {
        **STEAM, "stroke": "600mm", "speed": "14rad/s", "reciprocating": "230kg", "rod_mass": "120kg",
        "centre": "0.62", "gyration": "0.29", "rotating": "40kg", "slope": slope, "friction": "2500N",
    }  # fmt: skip
    angles = (40, 155, 230, 310)
    true = machine(**options).rod(angles)
    true["torque"] = true["tangential_force"] * 0.3
    for number, row in enumerate(rows_of(kurbel.forces(**options, angle=angles, columns=PARTS, digits=4))):
        rubbing = 2500 if row["phi"] > 180 else -2500
        assert row["friction_force_n"] == rubbing
        assert row["piston_force_n"] + rubbing == pytest.approx(true["piston_force"][number] * Q, abs=2e-4)
        for key in ("crosshead_load_n", "guide_force_n", "torque_nm"):
            assert row[key] == pytest.approx(true[key.rpartition("_")[0]][number] * Q, abs=2e-4), key


@pytest.mark.parametrize("offset", (0.0, 0.7))
def test_the_turn_with_rods_and_friction_is_the_sum_over_small_steps(offset: float) -> None:
    options = {
        **STEAM, "ratio": "1:4", "offset": str(offset), "friction": "1800N", "piston_rod": "90mm",
        "tail_rod": "40mm",
    }  # fmt: skip
    assert compared(options) < 0.51


def test_a_card_presses_on_the_areas_that_the_piston_rod_leaves(tmp_path: Path) -> None:
    card = tmp_path / "card.csv"
    lines = [f"{position / 20},5,{1 + position / 40}" for position in range(21)]
    card.write_text("position,p_forward [bar],p_return [bar]\n" + "\n".join(lines) + "\n")
    page = kurbel.forces(
        "1:∞", card=str(card), bore="200mm", piston_rod="80mm", angle=(60, 240), columns="piston_force_n"
    )
    out, back = (row["piston_force_n"] for row in rows_of(page))
    area, ring = 0.2**2 / 4 * pi, (0.2**2 - 0.08**2) / 4 * pi
    # A quarter of the stroke is gone; the other end gives the same card from its own dead centre.
    other = 1e5 * (1 + 0.75 / 2)
    assert out == pytest.approx(area * 5e5 - ring * other, abs=6)
    assert back == pytest.approx(-(ring * 5e5 - area * other), abs=6)


def test_friction_takes_its_work_of_a_card(tmp_path: Path) -> None:
    card = tmp_path / "card.csv"
    lines = [f"{position / 20},5.0000,{1 + position / 40}" for position in range(21)]
    card.write_text("position,p_forward [bar],p_return [bar]\n" + "\n".join(lines) + "\n")
    alone, rubbed = (
        float(rows(kurbel.delta(card=str(card), columns="mean_force", **more))[-1]["mean_force"])
        for more in ({}, {"bore": "200mm", "friction": "1200N"})
    )
    # Against both strokes, two diameters, along the circle of π.
    assert alone - rubbed == pytest.approx(2 * 1200 / pi / (0.2**2 / 4 * pi * 5e5), abs=1.01e-4)


def test_indicated_power_is_that_of_the_steam_and_the_mean_torque_is_less() -> None:
    asked: dict[str, Any] = {
        **STEAM, "stroke": "600mm", "speed": "10rad/s", "columns": "indicated_power,mean_force"
    }  # fmt: skip
    values = [
        [float(one) for one in kurbel.typeset(page, "csv").split()[-1].split(",")[-2:]]
        for page in (kurbel.delta(**asked, digits=6), kurbel.delta(**asked, digits=6, friction="2kN"))
    ]
    assert values[0][0] == values[1][0]
    # Friction takes 2 kN over four crank radii in a turn.
    assert values[0][1] - values[1][1] == pytest.approx(2000 * 4 / (2 * pi) / Q, abs=1.1e-6)


def test_a_torque_of_weight_alone_may_be_a_tie() -> None:
    page = kurbel.forces(
        **STEAM, stroke="450mm", rod="1200mm", rod_mass="100kg", centre="0.6", gyration="0.3",
        speed="250/min", slope=0, gravity="9.81", angle=180, columns="torque_nm", digits=2,
    )  # fmt: skip
    # 60 kg of the rod hang at the crank pin: 132.435 N m.
    assert kurbel.typeset(page, "csv").split()[-1] == "132.44"


def test_no_atmosphere_acts_on_the_section_of_the_piston_rod_as_pages_say() -> None:
    engine = {**STEAM, "stroke": "600mm", "ratio": "1:5", "piston_rod": "60mm", "angle": (20, 200)}
    page = kurbel.forces(**engine, columns="piston_force_n", digits=3)
    whole, ring, steam = 0.3**2 / 4 * pi, (0.3**2 - 0.06**2) / 4 * pi, 6e5
    # Towards the shaft, before the cut-off of either stroke: pressures times areas and nothing else.
    expected = [steam * (whole - 0.1 * ring), steam * (0.1 * whole - ring)]
    assert [row["piston_force_n"] for row in rows_of(page)] == pytest.approx(expected, abs=1e-3)
    for lang, sentence in (("de", "auch nicht der der Luft"), ("en", "not even that of the atmosphere")):
        said = kurbel.typeset(kurbel.forces(**engine, columns="piston_force_n", lang=lang), "text")
        assert sentence in " ".join(said.split())
