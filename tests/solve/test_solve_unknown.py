"""Numbers other than the angle: by the textbook's formulas in mpmath the condition holds with them."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import mpmath as mp
import pytest
from cli import printed, refusal

RATIO, STROKE = mp.mpf(1) / 4, mp.mpf("0.4")
DRIVE = ("--ratio=1:4", "--stroke=400mm")
PISTON = (*DRIVE, "--reciprocating=100kg")
STEAM = ("--eps=4", "--bore=300mm", "--back=1.1bar")


def solutions(*words: str) -> list[float]:
    rows = printed("solve", *words, "--digits=9", "-f", "csv").records()
    return [float([*row.values()][1]) for row in rows]


def path(phi: mp.mpf, ratio: mp.mpf = RATIO) -> mp.mpf:
    """x/R."""
    return 1 - mp.cos(phi) + (1 - mp.sqrt(1 - (ratio * mp.sin(phi)) ** 2)) / ratio


def effort(phi: mp.mpf) -> mp.mpf:
    """T/F, for a force on the piston."""
    psi = mp.asin(RATIO * mp.sin(phi))
    return mp.sin(phi + psi) / mp.cos(psi)


def inertia(phi: mp.mpf, turns: mp.mpf, mass: float = 100, stroke: mp.mpf = STROKE) -> mp.mpf:
    """The force that accelerates a mass on the piston at so many turns a second."""
    return mass * stroke / 2 * (2 * mp.pi * turns) ** 2 * mp.diff(path, phi, 2)


def torque(force: mp.mpf, stroke: mp.mpf = STROKE) -> mp.mpf:
    """The torque at 60° of a force on the piston."""
    return force * effort(at(60)) * stroke / 2


def steam_force(phi: mp.mpf, pressure: float, bore: float = 0.3) -> mp.mpf:
    share = path(phi) / 2
    return mp.pi / 4 * bore**2 * (pressure * min(mp.mpf(1), mp.mpf("0.25") / share) - mp.mpf(110_000))


def at(degrees: float) -> mp.mpf:
    return mp.radians(mp.mpf(degrees))


def test_speed_at_which_the_load_on_the_gudgeon_pin_reverses() -> None:
    for angle in (10, 30):
        words = (*STEAM, "--pressure=8bar", *PISTON, "--unknown=speed", f"--angle={angle}")
        (speed,) = solutions(*words, "--where=crosshead_load=0")
        force = steam_force(at(angle), 8e5)
        assert float(inertia(at(angle), mp.mpf(speed) / 60) / force) == pytest.approx(1, abs=1e-9)


# Of each what the page finds and the force or torque by the textbook at that value.
CASES: list[tuple[tuple[str, ...], float, Callable[[mp.mpf], mp.mpf]]] = [
    (
        ("--unknown=pressure", *STEAM, *PISTON, "--speed=300/min", "--where=torque = 5 kN m"), 5000,
        lambda bar: torque(steam_force(at(60), bar * 10**5) - inertia(at(60), mp.mpf(5))),
    ),
    (
        ("--unknown=bore", "--pressure=8bar", "--eps=4", "--back=1.1bar", *PISTON, "--speed=300/min",
         "--where=torque = 5 kN m"), 5000,
        lambda mm: torque(steam_force(at(60), 8e5, mm / 1000) - inertia(at(60), mp.mpf(5))),
    ),
    (
        ("--unknown=force", *DRIVE, "--where=torque = 500 N m"), 500,
        torque,
    ),
    (
        ("--unknown=reciprocating", "--force=10kN", *DRIVE, "--speed=300/min", "--where=torque = 0.5kN m"),
        500,
        lambda mass: torque(10_000 - inertia(at(60), mp.mpf(5), mass)),
    ),
    (
        ("--unknown=stroke", "--force=10kN", "--ratio=1:4", "--reciprocating=30kg", "--speed=300/min",
         "--where=torque = 300 N m"), 300,
        lambda mm: torque(10_000 - inertia(at(60), mp.mpf(5), 30, mm / 1000), mm / 1000),
    ),
    (
        ("--unknown=speed", "--force=10kN", *PISTON, "--where=crank_pin_force = 20kN"), 20_000,
        lambda turns: abs(10_000 - inertia(at(60), turns / 60)) / mp.cos(mp.asin(RATIO * mp.sin(at(60)))),
    ),
]  # fmt: skip


@pytest.mark.parametrize(("words", "value", "textbook"), CASES)
def test_the_condition_holds_with_what_is_found(
    words: tuple[str, ...], value: float, textbook: Callable[[mp.mpf], mp.mpf]
) -> None:
    found = solutions(*words, "--angle=60")
    # The torque of the stroke is greatest between two of them.
    assert len(found) == (2 if words[0] == "--unknown=stroke" else 1)
    for one in found:
        assert float(textbook(mp.mpf(one))) == pytest.approx(value, rel=1e-8)


def test_speed_at_which_the_greatest_velocity_is_so_high() -> None:
    (speed,) = solutions("--unknown=speed", *DRIVE, "--angle=c=max", "--where=c = 10 m/s")
    greatest = max(mp.diff(path, at(angle / 100)) for angle in range(7000, 8500))
    assert float(STROKE / 2 * 2 * mp.pi * speed / 60 * greatest) == pytest.approx(10, abs=1e-6)


def test_without_a_ratio_the_greatest_velocity_is_that_of_the_usual_one() -> None:
    words = ("solve", "--unknown=speed", "--stroke=600mm", "--angle=c=max", "--where=c = 4 m/s")
    assert printed(*words).out == printed(*words, "--ratio=1:5").out


def test_ratios_of_a_condition() -> None:
    first, last = solutions("--unknown=ratio", "--angle=80", "--where=c=max")
    for ratio in (first, last):
        assert abs(mp.diff(lambda phi, ratio=ratio: path(phi, mp.mpf(ratio)), at(80), 2)) < 1e-4
    # Of neither sign of the bend in between is there another.
    signs = [
        mp.sign(mp.diff(lambda phi, one=one: path(phi, mp.mpf(one) / 200), at(80), 2))
        for one in range(1, 200)
    ]
    assert [one for one, other in pairwise(signs) if one != other] == [1]
    (by_rod,) = solutions("--unknown=ratio", "--angle=90", "--where=psi=15")
    assert by_rod == pytest.approx(float(mp.sin(at(15))), abs=1e-9)


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--where=torque=0",), "--unknown asks for a number with which a condition holds at a crank angle;"),
        (
            ("--angle=30", "--where=torque=5"),
            'condition "torque = 5" needs a unit, for what is',
        ),
        (("--angle=30", "--where=torque=max"), 'condition "torque = max" has no value; --unknown needs one'),
        (
            ("--angle=30", "--where=torque=0", "--speed=3/min"),
            "--speed is given and asked for, as",
        ),
        (("--angle=30", "--where=torque=0", "--mechanism=arc", "--rocker=6"), "--unknown is of the straight"),
        (("--angle=0", "--where=torque=5 N m"), "the condition does not depend on what is asked for;"),
        (("--angle=30", "--where=torque=9 kN m"), "torque = 9 kN m is reached with no speed above 0"),
    ],
)
def test_what_tells_no_number_is_refused(words: tuple[str, ...], sentence: str) -> None:
    given = ("--unknown=speed", "--force=10kN", *PISTON, *words)
    code = 1 if "reached with no" in sentence else 2
    assert refusal("solve", *given, code=code).removeprefix("kurbel: ").startswith(sentence)


def test_angles_of_the_greatest_torque_with_masses_under_a_force() -> None:
    words = (*PISTON, "--force=40kN", "--speed=250/min", "--where=torque=max", "--columns=phi_turn,torque_nm")
    rows = printed("solve", *words, "--digits=6", "-f", "csv").records()
    turns = mp.mpf(250) / 60

    def torque_at(phi: mp.mpf) -> mp.mpf:
        # On the return stroke the force acts in its direction, against the outstroke.
        force = 40_000 if phi < mp.pi else -40_000
        return (force - inertia(phi, turns)) * effort(phi) * STROKE / 2

    for row, (low, high) in zip(rows, ((0, 180), (180, 360)), strict=True):
        greatest = max(torque_at(at(low + (high - low) * one / 4000)) for one in range(1, 4000))
        angle, value = (float(row[key]) for key in ("phi_turn", "torque_nm"))
        assert value == pytest.approx(float(greatest), rel=1e-6)
        assert float(torque_at(at(angle))) == pytest.approx(value, rel=1e-9)
