"""The slotted lever against its links enclosed, and the Scotch yoke: motion, forces, conditions."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from cli import printed, records, refusal
from drives import Drive, confirm, of_size, typed

import kurbel
from kurbel import verify
from kurbel.verify import CONFIRMED


def lever(pivot: str, arm: str, rod: str = "", offset: str = "", circuit: int = 1) -> Drive:
    options: dict[str, Any] = {"rocker": arm, "rod": rod, "offset": offset, "circuit": circuit}
    words = typed(
        {"mechanism": "slotted", "pivot": pivot, **{key: one for key, one in options.items() if one}}
    )
    height = Fraction(pivot) + Fraction(offset) if offset else Fraction(0)
    true = verify.SlottedLever(
        Fraction(0), pivot_below=Fraction(pivot), arm=Fraction(arm), ram_rod=Fraction(rod) if rod else None,
        height=height, circuit=circuit,
    )  # fmt: skip
    return Drive(words, true)


# A lever that swings and one that is carried round, without a rod and with one on either side, off its line.
LEVERS = [
    lever("1.7", "3"),
    lever("2.3", "3.1", "5", "0.9"),
    lever("1.3", "2.9", "4.4", "0.7", -1),
    lever("0.3", "1.2"),
    lever("0.7", "1.9", "5.3"),
    lever("0.7", "1.9", "5.3", "0.2", -1),
]
MOTIONS = (
    "lever", "lever_velocity", "lever_acceleration", "block_velocity", "coriolis", "path", "path_stroke",
    "velocity", "acceleration", "rod_velocity", "rod_acceleration",
)  # fmt: skip
FORCES = ("rod_force", "guide_force", "block_force", "tangential_force", "radial_force", "torque")
DEAD = ("phi_i", "phi_o", "lead", "time_ratio", "stroke", "transmission", "outstroke_time", "v_c_m")


@pytest.mark.parametrize("drive", LEVERS, ids=str)
def test_every_digit_is_that_of_the_closed_links(drive: Drive) -> None:
    for command, keys in (("table", MOTIONS), ("forces", FORCES)):
        asked = (*drive.words, "--angle=0;38.5;251", "--digits=12", f"--columns=phi,{','.join(keys)}")
        confirm(drive.true, records(command, *asked), keys)
    sized = of_size(drive, "1", "3").true
    (found,) = records(
        "deadcentres",
        *drive.words,
        "--stroke=2m",
        "--speed=3rad/s",
        "--digits=12",
        f"--columns={','.join(DEAD)}",
    )
    for key in DEAD:
        assert sized.value(key).confirms(found[key]) == CONFIRMED, key
    floats = kurbel.compute([38.5, 251], columns=",".join(MOTIONS), **drive.options)
    for key in MOTIONS:
        for angle, value in zip((38.5, 251), floats[key], strict=True):
            assert abs(value - float(drive.true.value(key, str(angle)))) <= 1e-13 * max(1, abs(value)), key


def test_a_lever_that_is_carried_round_counts_its_angle_over_the_turn() -> None:
    options: dict[str, Any] = {"mechanism": "slotted", "pivot": "0.5"}
    page = records("table", "--mechanism=slotted", "--pivot=0.5", "--angle=0;90;270;300", "--columns=lever")
    # With the pin at (cos φ, D + sin φ) from the pivot, 1/2 below the shaft.
    true = [-63.43495, 0, 180, 233.79397]
    assert [float(row["lever"]) for row in page] == pytest.approx(true, abs=6e-4)
    assert kurbel.compute([0, 90, 270, 300], columns="lever", **options)["lever"] == pytest.approx(true)


@pytest.mark.parametrize("drive", LEVERS[1::3], ids=str)
def test_conditions_hold_where_the_links_say(drive: Drive) -> None:
    turning = drive.true.value("lever_velocity", 50).digits(2)
    for key, aim, most in (
        ("path_stroke", "0.25", 2),
        ("acceleration", "0", 4),
        ("lever_velocity", turning, 4),
        ("rod_velocity", "0", 4),
    ):
        where = "s=25%" if key == "path_stroke" else f"{key}={aim}"
        rows = records("solve", *drive.words, "--where", where, "--columns=phi_turn", "--digits=9")
        for row in rows:
            stroke = "return" if row["stroke"] == "return" and key != "lever_velocity" else None
            turn = Fraction(row["phi_turn"])
            found = drive.true.value(key, turn - 180 if stroke else turn, stroke=stroke)
            assert float(found) == pytest.approx(float(aim), abs=2e-8), (key, turn)
        assert 2 <= len(rows) <= most, key


def test_the_yoke_moves_as_a_piston_with_an_infinite_rod() -> None:
    size = ("--stroke=310mm", "--speed=95/min", "--step=40", "--digits=9")
    yoke = records("table", "--mechanism=yoke", *size, "--columns=path_mm,velocity_mps,acceleration_mps2")
    piston = records("table", "--method=infinite", *size, "--columns=x_mm,c_mps,p_mps2")
    assert [[*row.values()] for row in yoke] == [[*row.values()] for row in piston]
    sweep = records(
        "sweep", "forces", "--mechanism=yoke", "--force=3kN", "--stroke=200;400mm", "--angle=30", "-o-"
    )
    assert [float(row["torque_nm"]) for row in sweep] == [150, 300]


def test_levers_that_do_not_move_their_ram_to_and_fro_are_refused() -> None:
    for words, sentence in (
        (("--pivot=1",), "meets it"),
        (("--pivot=2", "--rod=5"), "add --offset"),
        (("--pivot=2", "--offset=1"), "add --rod"),
        (("--pivot=2", "--rocker=3", "--rod=2", "--offset=-2"), "does not move the ram once to and fro"),
        (("--pivot=0.5", "--rocker=3", "--rod=2.5"), "is not carried round"),
        ((), "add --pivot"),
    ):
        assert sentence in refusal("table", "--mechanism=slotted", *words)
    assert "Kreuzschubkurbel" in printed("table", "--mechanism=yoke", "--step=90").out
