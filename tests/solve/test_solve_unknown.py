"""Numbers other than the angle: with what is found the bodies of kurbel.verify fulfil the condition."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import pi, radians, sin
from typing import Any

import numpy as np
import pytest
from cli import printed
from courses import course, slide

from kurbel import verify

RATIO, STROKE = "1:4", 0.4
DRIVE = ("--ratio=1:4", "--stroke=400mm")
PISTON = (*DRIVE, "--reciprocating=100kg")
STEAM = ("--eps=4", "--bore=300mm", "--back=1.1bar")


def solutions(*words: str) -> list[float]:
    rows = printed("solve", *words, "--digits=9", "-f", "csv").records()
    return [float([*row.values()][1]) for row in rows]


def forces(
    force: float, degrees: int = 60, mass: float = 100, turns: float = 5, stroke: float = STROKE
) -> Callable[[str], float]:
    """Return by its key what a force on the piston and a mass that goes with it make at an angle."""
    drive = verify.drive(RATIO, radius=str(stroke / 2), speed=str(turns), turns=True)
    there = verify.bodies(drive, reciprocating=str(mass), force=str(force))
    return lambda key: float(there.value(key, degrees))


def steam_force(degrees: int, pressure: float, bore: float = 0.3) -> float:
    share = float(verify.drive(RATIO).value("x_stroke", degrees))
    return pi / 4 * bore**2 * (pressure * min(1, 0.25 / share) - 110_000)


def test_speed_at_which_the_load_on_the_gudgeon_pin_reverses() -> None:
    # At 120° the force and the masses act in one direction, and the load does not reverse.
    words = (*STEAM, "--pressure=8bar", *PISTON, "--unknown=speed", "--angle=10;30;120")
    rows = printed("solve", *words, "--where=crosshead_load=0", "--digits=9", "-f", "csv").records()
    assert [row["phi"] for row in rows] == ["10", "30"]
    for row in rows:
        angle = int(row["phi"])
        force = steam_force(angle, 8e5)
        load = forces(force, angle, turns=float(row["speed"]) / 60)("crosshead_load_n")
        assert load / force == pytest.approx(0, abs=1e-9)


# Of each what the page finds and the force or torque by the textbook at that value.
CASES: list[tuple[tuple[str, ...], float, Callable[[float], float]]] = [
    (
        ("--unknown=pressure", *STEAM, *PISTON, "--speed=300/min", "--where=torque = 5 kN m"), 5000,
        lambda bar: forces(steam_force(60, bar * 1e5))("torque_nm"),
    ),
    (
        ("--unknown=bore", "--pressure=8bar", "--eps=4", "--back=1.1bar", *PISTON, "--speed=300/min",
         "--where=torque = 5 kN m"), 5000,
        lambda mm: forces(steam_force(60, 8e5, mm / 1000))("torque_nm"),
    ),
    (
        ("--unknown=force", *DRIVE, "--where=torque = 500 N m"), 500,
        lambda force: forces(force, mass=0)("torque_nm"),
    ),
    (
        ("--unknown=reciprocating", "--force=10kN", *DRIVE, "--speed=300/min", "--where=torque = 0.5kN m"),
        500,
        lambda mass: forces(10_000, mass=mass)("torque_nm"),
    ),
    (
        ("--unknown=stroke", "--force=10kN", "--ratio=1:4", "--reciprocating=30kg", "--speed=300/min",
         "--where=torque = 300 N m"), 300,
        lambda mm: forces(10_000, mass=30, stroke=mm / 1000)("torque_nm"),
    ),
    (
        ("--unknown=speed", "--force=10kN", *PISTON, "--where=crank_pin_force = 20kN"), 20_000,
        lambda turns: forces(10_000, turns=turns / 60)("crank_pin_force_n"),
    ),
]  # fmt: skip


@pytest.mark.parametrize(("words", "value", "true"), CASES)
def test_the_condition_holds_with_what_is_found(
    words: tuple[str, ...], value: float, true: Callable[[float], float]
) -> None:
    found = solutions(*words, "--angle=60")
    # The torque of the stroke is greatest between two of them.
    assert len(found) == (2 if words[0] == "--unknown=stroke" else 1)
    for one in found:
        assert true(one) == pytest.approx(value, rel=1e-8)


def test_speed_at_which_the_greatest_velocity_is_so_high() -> None:
    (speed,) = solutions("--unknown=speed", *DRIVE, "--angle=c=max", "--where=c = 10 m/s")
    greatest = max(course(slide(0.25), "c")(np.radians(np.arange(70, 85, 0.01))))
    assert STROKE / 2 * 2 * pi * speed / 60 * greatest == pytest.approx(10, abs=1e-6)


def test_without_a_ratio_the_greatest_velocity_is_that_of_the_usual_one() -> None:
    words = ("solve", "--unknown=speed", "--stroke=600mm", "--angle=c=max", "--where=c = 4 m/s")
    assert printed(*words).out == printed(*words, "--ratio=1:5").out


def test_ratios_of_a_condition() -> None:
    def bend(ratio: float) -> float:
        return float(course(slide(ratio), "p")(np.radians(80)))

    found = solutions("--unknown=ratio", "--angle=80", "--where=c=max")
    assert [bend(ratio) for ratio in found] == pytest.approx([0, 0], abs=1e-4)
    # Of neither sign of the bend in between is there another.
    signs = [bend(one / 200) > 0 for one in range(1, 200)]
    assert [one for one, other in pairwise(signs) if one != other] == [True]
    (by_rod,) = solutions("--unknown=ratio", "--angle=90", "--where=psi=15")
    assert by_rod == pytest.approx(sin(radians(15)), abs=1e-9)


def test_angles_of_the_greatest_torque_with_masses_under_a_force() -> None:
    words = (*PISTON, "--force=40kN", "--speed=250/min", "--where=torque=max", "--columns=phi_turn,torque_nm")
    rows = printed("solve", *words, "--digits=6", "-f", "csv").records()
    velocity, bend = (course(slide(0.25), key) for key in ("c", "p"))

    def torque_at(phi: Any) -> Any:
        # On the return stroke the force acts in its direction, against the outstroke.
        force = np.where(phi < np.pi, 40_000, -40_000)
        return (force - 100 * 0.2 * (2 * pi * 250 / 60) ** 2 * bend(phi)) * velocity(phi) * 0.2

    for row, low in zip(rows, (0, np.pi), strict=True):
        greatest = max(torque_at(low + np.pi * np.arange(1, 40_000) / 40_000))
        angle, value = (float(row[key]) for key in ("phi_turn", "torque_nm"))
        assert value == pytest.approx(float(greatest), rel=1e-7)
        assert float(torque_at(np.radians(angle))) == pytest.approx(value, rel=1e-9)
