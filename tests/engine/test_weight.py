"""The weight of piston, crosshead and rod against Newton's and Euler's equations of the links."""

from __future__ import annotations

import csv
import io
import re
from dataclasses import replace
from typing import Any

import pytest
from mpmath import mp
from planar import drawn

import kurbel
from kurbel.errors import ProblemError

HEAVY = {"reciprocating": "9kg", "speed": "120/min"}
ANGLES = (17, 158, 241, 322)
STEAM: dict[str, Any] = {"eps": 3, "bore": "300mm", "pressure": "6bar"}
Q = 0.3**2 / 4 * mp.pi * 6e5


def row_of(page: Any) -> list[dict[str, float]]:
    rows = csv.DictReader(io.StringIO(kurbel.typeset(page, "csv")))
    return [{key: float(value) for key, value in row.items() if key not in ("ratio",)} for row in rows]


@pytest.mark.parametrize("seed", range(3))
def test_forces_are_those_of_two_bodies_under_gravity(seed: int) -> None:
    drive = replace(drawn(seed), force=12500.0)
    page = kurbel.forces_table(
        **drive.options, force=12500, angle=ANGLES,
        columns="phi,guide_force_n,rod_force_n,crosshead_pin_force_n,crank_pin_force_n,torque_nm,"
        "radial_force_n,bearing_along_n,bearing_across_n",
        digits=5,
    )  # fmt: skip
    for row in row_of(page):
        true = drive.forces(row["phi"])
        for key in row.keys() - {"phi"}:
            assert row[key] == pytest.approx(true[key], abs=6e-6), (seed, row["phi"], key)


def test_return_stroke_has_the_forces_of_the_other_half_turn() -> None:
    drive = drawn(3)
    columns = "phi,torque_return_nm,guide_force_return_n,bearing_along_return_n"
    (row,) = row_of(kurbel.forces_table(**drive.options, angle=63, columns=columns, digits=5))
    true = drive.forces(243)
    assert row["torque_return_nm"] == pytest.approx(true["torque_nm"], abs=6e-6)
    for key in ("guide_force", "bearing_along"):
        assert row[f"{key}_return_n"] == pytest.approx(-true[f"{key}_n"], abs=6e-6)


@pytest.mark.parametrize("seed", (0, 2))
def test_the_turn_of_an_engine_lifts_and_drops_its_masses(seed: int) -> None:
    drive = drawn(seed)
    asked: dict[str, Any] = {
        **STEAM, "angle": ANGLES, "columns": "phi,energy,tangential,torque_nm", "digits": 7
    }  # fmt: skip
    options = {name: value for name, value in drive.options.items() if name != "rotating"}
    heavy = kurbel.turning_table(**options, **asked)
    lengths: dict[str, Any] = {
        name: options[name] for name in ("stroke", "rod", "offset", "speed") if name in options
    }
    light = kurbel.turning_table(**lengths, reciprocating="0.0000001kg", **asked)
    # Work counts from the inner dead centre.
    dead = mp.asin(drive.offset / (drive.rod + drive.radius))
    for with_masses, without in zip(row_of(heavy), row_of(light), strict=True):
        gained = drive.energy(mp.radians(with_masses["phi"])) - drive.energy(dead)
        energy = without["energy"] - gained / (Q * drive.radius)
        assert with_masses["energy"] == pytest.approx(float(energy), abs=2e-7)
        own = drive.forces(with_masses["phi"])["torque_nm"]
        assert with_masses["torque_nm"] - without["torque_nm"] == pytest.approx(own, abs=1e-5)


def test_the_speed_over_the_turn_has_the_weight_in_its_work() -> None:
    drive, inertia = drawn(2), 900
    options = {name: value for name, value in drive.options.items() if name != "rotating"}
    lengths: dict[str, Any] = {
        name: options[name] for name in ("stroke", "rod", "offset", "speed") if name in options
    }
    asked: dict[str, Any] = {**STEAM, "angle": (0, *ANGLES), "digits": 9}
    page = kurbel.turning_table(**options, inertia=f"{inertia}kgm2", columns="phi,rpm", **asked)
    works = row_of(
        kurbel.turning_table(**lengths, reciprocating="0.0000001kg", columns="phi,energy", **asked)
    )
    still = replace(drive, slope=None)

    def held(row: dict[str, float]) -> Any:
        """The energy of flywheel and masses at the true speed, and of height."""
        angle, omega = mp.radians(row["phi"]), row["rpm"] * mp.pi / 30
        # What turns evenly is in the flywheel.
        even = drive.mass * drive.centre * drive.radius**2 / 2
        moving = still.energy(angle) / drive.omega**2 - even
        height = drive.energy(angle) - still.energy(angle)
        return (mp.mpf(inertia) / 2 + moving) * omega**2 + height

    first, *others = zip(row_of(page), works, strict=True)
    for row, work in others:
        gained = (work["energy"] - first[1]["energy"]) * Q * drive.radius
        assert float(held(row) - held(first[0])) == pytest.approx(float(gained), abs=1e-4)


def test_a_bank_leans_by_its_angle_from_the_slope() -> None:
    one, whole = drawn(4), {"gravity": "9.81", "angle": "25;140", "digits": 4}
    options: dict[str, Any] = {key: one.options[key] for key in ("stroke", "rod", "speed", "reciprocating")}
    common: dict[str, Any] = {**STEAM, **options, **whole, "columns": "torque_nm"}
    both = kurbel.turning_table(**common, vertical=True, cylinder=["angle=0", "bank=60"])
    first = kurbel.turning_table(**common, vertical=True)
    # The crank reaches the leaning axis by 60° later.
    late = {**common, "angle": "325;80"}
    second = kurbel.turning_table(**late, slope=150)
    torques = [[row["torque_nm"] for row in row_of(page)] for page in (both, first, second)]
    for total, *parts in zip(*torques, strict=True):
        assert total == pytest.approx(sum(parts), abs=1.1e-4)


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"vertical": True}, "--vertical is for the weight of moving masses; add --reciprocating"),
        ({**HEAVY, "gravity": 9.81}, "--gravity is for weights; add --vertical or --slope"),
        (
            {**HEAVY, "vertical": True, "slope": 30},
            "--vertical is a slope of 90, and --slope says 30; leave one of the two out",
        ),
        ({**HEAVY, "slope": 200}, "the slope is 200°; it must lie within -180..180"),
        (
            {**HEAVY, "slope": 20, "mechanism": "arc", "rocker": 6},
            "the arc crank with the weight of its masses is not computed",
        ),
    ],
)
def test_a_weight_that_says_nothing_is_refused(options: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ProblemError, match=re.escape(sentence)):
        kurbel.forces_table("1:5", stroke="600mm", **options)
