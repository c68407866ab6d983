"""Forces of an engine with its masses, against Newton's and Euler's equations of its bodies."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from cli import printed
from drawn_machines import Draw
from figures import figures, rows
from machines import machine
from mpmath import mp
from numpy.testing import assert_allclose
from places import CARDS
from strokes import number, pressure_of

import kurbel
from kurbel import verify

FORCES = (
    "piston_force", "rod_force", "guide_force", "crosshead_pin_force", "crank_pin_force", "tangential_force",
    "radial_force", "bearing_along", "bearing_across", "bearing_force",
)  # fmt: skip
ANGLES = (12.5, 75, 140, 203, 266.4, 331)
# Between the dead centres of an offset drive, and half a turn on, too.
BETWEEN = (60, 95.5, 140)
DIGITS = 7
WEIGHTS = ("reciprocating", "rod_mass", "centre", "gyration", "rotating", "slope")
SIZES = ("stroke", "speed", *WEIGHTS)


def heavy(mechanism: str, load: str, seed: int) -> dict[str, Any]:
    """Return the options of one cylinder with masses, a counterweight and on every second one its weight."""
    draw = Draw(seed)
    options = draw.machine(mechanism, load)
    options |= draw.masses(load, options) | {"rotating": draw.number(-80, 90, 1) + "kg"}
    options.pop("cranks", None)
    return options | ({"slope": draw.number(-180, 180, 0)} if seed % 2 else {})


def bodies(options: dict[str, Any], force: str) -> verify.Bodies:
    """Return the drive and the masses of these options under a force on the piston in N."""
    bare = {key: Fraction(str(one).rstrip("kgmrad/s")) for key, one in options.items() if key in SIZES}
    drive = verify.drive(
        options["ratio"], options.get("offset", "0"), rocker=options.get("rocker"), beam=options.get("beam"),
        radius=bare["stroke"] / 2, speed=bare["speed"],
    )  # fmt: skip
    return verify.bodies(drive, force=force, **{key: bare[key] for key in WEIGHTS if key in bare})


@pytest.mark.parametrize("load", ["steam", "compressor", "gas"])
@pytest.mark.parametrize(
    ("mechanism", "seed"), [("straight", 4), ("straight", 5), ("offset", 6), ("offset", 7), ("arc", 8)]
)
def test_forces_are_those_of_the_equations_of_motion(mechanism: str, load: str, seed: int) -> None:
    options = heavy(mechanism, load, seed)
    one = machine(**options)
    whole = math.pi / 4 * number(options["bore"]) ** 2 * pressure_of(options)
    keys = [*(f"{key}_n" for key in FORCES), "torque_nm"]
    page = kurbel.forces(**options, angle=ANGLES, columns=["phi", *keys], digits=DIGITS)
    pushed = kurbel.forces(**options, angle=ANGLES, columns="piston_force_n", digits=25)
    assert_allclose(
        figures(pushed, ["piston_force_n"])[:, 0], one.rod(ANGLES)["piston_force"] * whole, rtol=1e-11
    )
    # What the pins take is then settled to the last digit.
    for row, push in zip(rows(page), rows(pushed), strict=True):
        there = bodies(options, push["piston_force_n"])
        for key in keys:
            value = there.value(key, row["phi"])
            assert value.confirms(row[key]) == verify.CONFIRMED, (row["phi"], key)


@pytest.mark.parametrize(("mechanism", "seed"), [("offset", 1), ("offset", 2), ("arc", 4)])
def test_a_piston_force_solves_the_equations_of_motion_on_both_strokes(mechanism: str, seed: int) -> None:
    options = heavy(mechanism, "steam", seed)
    kept = ("mechanism", "rocker", "ratio", "offset", *SIZES)
    weights = {key: options[key] for key in kept if key in options}
    keys = [f"{key}{back}_n" for key in FORCES[1:] for back in ("", "_return")]
    page = kurbel.forces(
        **weights, force=4321, angle=BETWEEN, columns=["phi", *keys], digits=DIGITS, rounding="half-even"
    )
    there = bodies(options, "4321")
    for row in rows(page):
        for key in keys:
            value = there.value(key, row["phi"])
            assert value.confirms(row[key], "half-even") == verify.CONFIRMED, (row["phi"], key)


# Forces of the return stroke end at 180°.
@pytest.mark.parametrize(
    ("unit", "guide", "step"),
    [("120/min", "guide_force_return_n", "0.01"), ("12.5rad/s", "guide_force_n", "0.02")],
)
def test_long_columns_of_loaded_forces_have_the_digits_of_balls(unit: str, guide: str, step: str) -> None:
    rod = ("--rod-mass=60kg", "--centre=0.6", "--gyration=0.4")
    masses = ("--reciprocating=100kg", *rod, "--rotating=-20kg")
    drive = ("--ratio=1:3", "--stroke=600mm", f"--speed={unit}", "--force=1kN")
    words = ("forces", *drive, *masses, "-f", "csv", "--digits=3")
    keys = ("rod_force_n", guide, "crank_pin_force_n", "bearing_across_n", "torque_nm")
    columns = "--columns=phi," + ",".join(keys)
    long = printed(*words, columns, f"--step={step}").records()
    assert len(long) == 18001
    few = {record["phi"]: record for record in printed(*words, columns, "--step=3.7").records()}
    same = [record for record in long if record["phi"].rstrip("0").rstrip(".") in
            {phi.rstrip("0").rstrip(".") for phi in few}]  # fmt: skip
    assert len(same) >= 48
    by_angle = {Fraction(phi): record for phi, record in few.items()}
    for record in same:
        short = by_angle[Fraction(record["phi"])]
        assert {key: record[key] for key in keys} == {key: short[key] for key in keys}


def test_units_of_the_steam_force_and_newtons_are_the_same_forces() -> None:
    options = heavy("straight", "steam", 4)
    whole = math.pi / 4 * number(options["bore"]) ** 2 * pressure_of(options)
    for unit, scale in (("", 1.0), ("_n", whole)):
        columns = [f"{key}{unit}" for key in FORCES if key != "bearing_force"]
        page = kurbel.forces(**options, angle="40;200.5", columns=columns, digits=9)
        true = machine(**options).rod([40, 200.5])
        wanted = np.column_stack([true[key] for key in FORCES if key != "bearing_force"])
        found = figures(page, columns) / scale
        assert_allclose(found, wanted, rtol=0, atol=1e-9)


SIZE = ("--stroke=600mm", "--bore=300mm", "--pressure=8bar")
MACHINE = ("--ratio=1:4", *SIZE, "--speed=12.5rad/s")


def test_a_tie_is_settled_where_the_masses_press_alone() -> None:
    # m R ω² (1 - λ) = 316.8 · 0.3 · 12.5² · 3/4 at the outer dead centre, where the piston idles.
    words = ("forces", *MACHINE, "--eps=3", "--single-acting", "--angle=180")
    columns = ("--columns=rod_force_n,radial_force_n,bearing_force_n", "--digits=0", "-f", "csv")
    (record,) = printed(*words, *columns, "--reciprocating=316.8kg").records()
    assert record == {"rod_force_n": "11138", "radial_force_n": "-11138", "bearing_force_n": "11138"}
    (even,) = printed(*words, *columns, "--reciprocating=316.7715555555555kg").records()
    assert even["radial_force_n"] == "-11136"


def test_a_mass_that_only_rotates_leaves_the_ties_of_the_steam() -> None:
    # At full pressure and with an infinite rod the crank takes (1 - b) sin 30° of Q, which is 0.25.
    words = ("--eps=1", "--back=0.5", "--ratio=1:∞", *SIZE, "--speed=120/min", "--rotating=-40kg")
    at = ("--angle=30", "--columns=tangential_force", "--digits=1", "-f", "csv")
    assert printed("forces", *words, *at).records() == [{"tangential_force": "0.3"}]
    assert printed("forces", *words, *at, "--rounding=half-even").records() == [{"tangential_force": "0.2"}]


TIES = ("--bore=300mm", "--pressure=8bar", "--stroke=600mm", "--reciprocating=300kg")


@pytest.mark.parametrize(
    ("words", "value"),
    [
        # The torque of the masses is 0 at 90° of an infinite rod, and of two cranks at right angles always.
        ("turning --eps=4 --back=0.05 --ratio=1:∞ --angle=90 --columns=tangential --speed=2/s", "0.5"),
        ("turning --eps=1 --back=0.75 --ratio=1:∞ --angle=0 --cranks=0;90 --columns=tangential --speed=2/s",
         "0.3"),
        # The masses move as fast at 180° as at 0°.
        ("turning --eps=1 --back=0.05 --single-acting --angle=180 --columns=energy --speed=2/s", "1.0"),
        # The crank's counterweight holds the piston: (1 + λ) 300 kg.
        ("forces --eps=4 --back=0.25 --rotating=-360kg --angle=0 --columns=bearing_along --speed=2/s", "0.8"),
        ("forces --eps=4 --back=0.25 --rotating=-360kg --angle=0 --columns=bearing_along --speed=9rad/s",
         "0.8"),
    ],
)  # fmt: skip
def test_ties_are_settled_where_the_masses_cancel(words: str, value: str) -> None:
    out = printed(*words.split(), *TIES, "--digits=1", "-f", "csv").out
    assert out.splitlines()[1] == value


def test_a_tie_is_settled_where_the_steam_is_in_balance_within_the_stroke() -> None:
    # At 90° of R:L = 3:5 the piston is at 2/3 of its stroke, where the steam of ε = 4 has 3/8 of its
    # pressure; m R ω² λ²/√(1 - λ²) · tan ψ = 4 · 0.3 · 100 · 0.75 · 0.75.
    words = ("--eps=4", "--back=0.375", "--ratio=3:5", "--angle=90", "--speed=10rad/s", *SIZE)
    at = ("--reciprocating=4kg", "--columns=guide_force_n", "--digits=0", "-f", "csv")
    assert printed("forces", *words, *at).records() == [{"guide_force_n": "68"}]


@pytest.mark.parametrize(
    ("words", "force", "expected"),
    [
        # Two masses are k² = a b, and every error is a share of the force itself: (0.4 - 0.488)/0.488...
        ("--centre=0.36 --gyration=0.48 --columns=error_percent --digits=0", "guide", ["", "0", "38"]),
        ("--ratio=1:∞ --centre=0.6 --gyration=0.3 --columns=greatest --digits=2", "torque", ["0.28"]),
    ],
)
def test_ties_of_the_greatest_errors_are_settled(words: str, force: str, expected: list[str]) -> None:
    found = printed("inertia", "--layout=inertia-errors", *words.split(), "-f", "csv").records()
    last = [[*one.values()][-1] for one in found if one["force"] == force]
    assert last[: len(expected)] == expected


def test_pressures_are_exact() -> None:
    words = ("--eps=4", "--bore=300mm", "--pressure=812345.67Pa", "--angle=0", "--digits=25", "-f", "csv")
    (record,) = printed("forces", *words, "--columns=piston_force_n").records()
    with mp.workdps(50):
        true = mp.mpf("812345.67") * mp.pi / 4 * mp.mpf("0.09") * mp.mpf("0.75")
        assert mp.almosteq(mp.mpf(record["piston_force_n"]), true, rel_eps=1e-29)


def test_several_cranks_have_one_torque_together() -> None:
    words = ("--eps=4", "--ratio=1:5", "--cranks=0;90", *SIZE, "--angle=30", "--digits=6", "-f", "csv")
    (one,) = printed("forces", *words, "--columns=tangential_force,tangential,torque_nm").records()
    (turning,) = printed("turning", *words[:3], "--angle=30", "--digits=6", "-f", "csv").records()
    assert one["tangential"] == turning["tangential"] != one["tangential_force"]
    whole = math.pi / 4 * 0.09 * 8e5 * 0.3
    assert math.isclose(float(one["torque_nm"]), whole * float(one["tangential"]), rel_tol=1e-5)


def test_a_card_weighs_the_masses_by_its_own_pressure() -> None:
    card = CARDS / "ideal-2.csv"
    size = ("--stroke=600mm", "--bore=300mm", "--speed=240/min", "--reciprocating=300kg", "--ratio=1:5")
    words = ("--columns=piston_force_n,guide_force_n,torque_nm", "--angle=20;75;200;290", "--digits=2")
    measured = printed("forces", f"--card={card}", *size, *words, "-f", "csv").records()
    ideal = printed("forces", "--eps=2", "--pressure=8bar", *size, *words, "-f", "csv").records()
    for one, other in zip(measured, ideal, strict=True):
        for key in ("piston_force_n", "guide_force_n", "torque_nm"):
            assert math.isclose(float(one[key]), float(other[key]), rel_tol=1e-4, abs_tol=1), key
            assert abs(float(one[key]) - float(other[key])) <= float(one[f"{key}_error"]) + 0.5
