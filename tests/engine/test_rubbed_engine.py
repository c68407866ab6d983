"""Engines with friction and piston rods: against bodies, sums over small steps and pressures times areas."""

from __future__ import annotations

import csv
import io
import re
from dataclasses import replace
from math import pi
from pathlib import Path
from typing import Any

import pytest
from machines import Machine, Slide
from planar import drawn

import kurbel
from kurbel.errors import ProblemError

Q = 0.3**2 / 4 * pi * 6e5
STEAM: dict[str, Any] = {"eps": 3, "back": "0.1", "bore": "300mm", "pressure": "6bar"}
PARTS = "phi,piston_force_n,friction_force_n,weight_force_n,crosshead_load_n,guide_force_n,torque_nm"


def rows_of(page: Any) -> list[dict[str, float]]:
    rows = csv.DictReader(io.StringIO(kurbel.typeset(page, "csv")))
    return [{key: float(value) for key, value in row.items()} for row in rows]


@pytest.mark.parametrize("seed", (21, 22))
def test_forces_of_an_engine_are_those_of_bodies_with_friction_and_weight(seed: int) -> None:
    drive = replace(drawn(seed), friction=2500.0)
    page = kurbel.forces_table(
        **drive.options, **STEAM, friction="2500N", angle=(40, 155, 230, 310), columns=PARTS, digits=4
    )
    for row in rows_of(page):
        true = replace(drive, force=row["piston_force_n"]).forces(row["phi"])
        for key in PARTS.split(",")[1:]:
            assert row[key] == pytest.approx(true[key], abs=2e-4), (seed, row["phi"], key)


@pytest.mark.parametrize("offset", (0.0, 0.7))
def test_the_turn_with_rods_and_friction_is_the_sum_over_small_steps(offset: float) -> None:
    head, crank, friction = 1 - (40 / 300) ** 2, 1 - (90 / 300) ** 2, 1800 / Q

    def pressure(share: Any) -> Any:
        return (1 / 3) / share.clip(1 / 3)

    forces = (
        lambda share: head * pressure(share) - crank * 0.1 - friction,
        lambda share: crank * pressure(share) - head * 0.1 - friction,
    )
    # Of a piston rod the strokes are unlike.
    machine = Machine(Slide(4.0, offset), forces, {})
    page = kurbel.delta_table(
        **STEAM, ratio="1:4", offset=str(offset), friction="1800N", piston_rod="90mm", tail_rod="40mm",
        columns="mean_force,delta", digits=5,
    )  # fmt: skip
    values = kurbel.typeset(page, "csv").split()[-1].split(",")
    mean, delta = machine.turned(200_000)
    assert float(values[-2]) == pytest.approx(mean, abs=1.1e-5)
    assert float(values[-1]) == pytest.approx(delta, abs=2e-5)


def test_a_card_presses_on_the_areas_that_the_piston_rod_leaves(tmp_path: Path) -> None:
    card = tmp_path / "card.csv"
    lines = [f"{position / 20},5,{1 + position / 40}" for position in range(21)]
    card.write_text("position,p_forward [bar],p_return [bar]\n" + "\n".join(lines) + "\n")
    page = kurbel.forces_table(
        "1:∞", card=str(card), bore="200mm", piston_rod="80mm", angle=(60, 240), columns="piston_force_n"
    )
    out, back = (row["piston_force_n"] for row in rows_of(page))
    area, ring = 0.2**2 / 4 * pi, (0.2**2 - 0.08**2) / 4 * pi
    # A quarter of the stroke is gone; the other end gives the same card from its own dead centre.
    other = 1e5 * (1 + 0.75 / 2)
    assert out == pytest.approx(area * 5e5 - ring * other, abs=6)
    assert back == pytest.approx(-(ring * 5e5 - area * other), abs=6)


def test_indicated_power_is_that_of_the_steam_and_the_mean_torque_is_less() -> None:
    asked: dict[str, Any] = {
        **STEAM, "stroke": "600mm", "speed": "10rad/s", "columns": "indicated_power,mean_force"
    }  # fmt: skip
    values = [
        [float(one) for one in kurbel.typeset(page, "csv").split()[-1].split(",")[-2:]]
        for page in (
            kurbel.delta_table(**asked, digits=6),
            kurbel.delta_table(**asked, digits=6, friction="2kN"),
        )
    ]
    assert values[0][0] == values[1][0]
    # Friction takes 2 kN over four crank radii in a turn.
    assert values[0][1] - values[1][1] == pytest.approx(2000 * 4 / (2 * pi) / Q, abs=1.1e-6)


def test_a_torque_of_weight_alone_may_be_a_tie() -> None:
    page = kurbel.forces_table(
        **STEAM, stroke="450mm", rod="1200mm", rod_mass="100kg", centre="0.6", gyration="0.3",
        speed="250/min", slope=0, gravity="9.81", angle=180, columns="torque_nm", digits=2,
    )  # fmt: skip
    # 60 kg of the rod hang at the crank pin: 132.435 N m.
    assert kurbel.typeset(page, "csv").split()[-1] == "132.44"


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"friction": "1kN"}, "--friction is weighed against the load by the bore; add --bore"),
        ({**STEAM, "friction": "99kN"}, "the friction of 99000 N takes all that the load gives"),
        (
            {**STEAM, "piston_rod": "5cm", "single_acting": True},
            "are for double-acting cylinders under steam",
        ),
        ({**STEAM, "friction": 9, "method": "weisbach"}, 'method "weisbach" has no equations for friction'),
    ],
)
def test_friction_and_rods_that_no_engine_has_are_refused(options: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ProblemError, match=re.escape(sentence)):
        kurbel.delta_table(**{"eps": 3, **options})


def test_no_atmosphere_acts_on_the_section_of_the_piston_rod_as_pages_say() -> None:
    engine = {**STEAM, "stroke": "600mm", "ratio": "1:5", "piston_rod": "60mm", "angle": (20, 200)}
    page = kurbel.forces_table(**engine, columns="piston_force_n", digits=3)
    whole, ring, steam = 0.3**2 / 4 * pi, (0.3**2 - 0.06**2) / 4 * pi, 6e5
    # Towards the shaft, before the cut-off of either stroke: pressures times areas and nothing else.
    expected = [steam * (whole - 0.1 * ring), steam * (0.1 * whole - ring)]
    assert [row["piston_force_n"] for row in rows_of(page)] == pytest.approx(expected, abs=1e-3)
    for lang, sentence in (("de", "auch nicht der der Luft"), ("en", "not even that of the atmosphere")):
        said = kurbel.typeset(kurbel.forces_table(**engine, columns="piston_force_n", lang=lang), "text")
        assert sentence in " ".join(said.split())
