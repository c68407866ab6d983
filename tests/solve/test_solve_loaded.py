"""Conditions on the forces of an engine and on forces in newtons, against quadrature and closed forms."""

from __future__ import annotations

import math
import random
from fractions import Fraction

import numpy as np
import pytest
from cli import printed, refusal
from energy_curve import Curve, Exact, Plant
from mpmath import mp
from numpy.testing import assert_allclose
from places import CARDS, ROOT

CSV = ("-f", "csv")
SIZE = ("--bore=300mm", "--pressure=8bar", "--stroke=600mm")
# Of a grid of a hundredth of a degree.
GRID = 2e-5


def _words(plant: Plant) -> tuple[str, ...]:
    words = [
        f"--eps={float(plant.expansion)}",
        f"--ratio={float(plant.ratio)}",
        f"--back={float(plant.back or 0)}",
        f"--exponent={float(plant.exponent)}",
        f"--clearance={float(plant.clearance)}",
        f"--cranks={';'.join(map(str, plant.cranks))}",
    ]
    return ("solve", *words, *(() if plant.double else ("--single-acting",)), "--columns=phi", *CSV)


def _plants() -> list[Plant]:
    rng = random.Random(13)
    return [
        Plant(
            Fraction(rng.randint(12, 60), 10),
            Fraction(rng.randint(10, 40), 100),
            Fraction(rng.randint(2, 12), 100),
            Fraction(rng.choice([100, 113, 130]), 100),
            Fraction(rng.randint(0, 8), 100),
            rng.random() < 0.7,
            (Fraction(0), Fraction(90)) if rng.random() < 0.5 else (Fraction(0),),
        )
        for _ in range(6)
    ]


@pytest.mark.parametrize("plant", _plants(), ids=lambda one: f"{one.expansion}")
def test_all_angles_are_those_at_which_a_fine_grid_crosses_the_value(plant: Plant) -> None:
    curve = Curve(plant)
    force = curve.excess + curve.mean_force
    value = round(float(force.max()) * 0.6, 3)
    apart = force - value
    crossed = np.flatnonzero(np.sign(apart[:-1]) * np.sign(apart[1:]) < 0)
    wanted = curve.angles[crossed] + curve.step * apart[crossed] / (apart[crossed] - apart[crossed + 1])
    found = printed(*_words(plant), f"--where=tangential={value}", "--digits=7").records()
    assert_allclose([float(one["phi"]) for one in found], wanted, rtol=0, atol=GRID * 10)


@pytest.mark.parametrize("plant", _plants()[:3], ids=lambda one: f"{one.expansion}")
def test_the_energy_is_greatest_and_the_torque_least_where_a_fine_grid_has_them(plant: Plant) -> None:
    curve = Curve(plant)
    words = (*_words(plant), "--columns=condition,phi,energy,tangential", "--digits=7")
    found = printed(*words, "--where=energy=max", "--where=torque=min").records()
    energy = [one for one in found if one["condition"] == "energy = max"]
    torque = [one for one in found if one["condition"] == "torque = min"]
    place = int(curve.energy.argmax())
    assert_allclose(float(energy[0]["energy"]), curve.energy[place], rtol=0, atol=1e-6)
    assert_allclose(float(energy[0]["phi"]), curve.angles[place], rtol=0, atol=curve.step)
    least = float((curve.excess + curve.mean_force).min())
    assert_allclose(float(torque[0]["tangential"]), least, rtol=0, atol=1e-6)


def test_many_digits_of_an_angle_are_those_of_mpmath() -> None:
    words = ("solve", "--eps=3", "--ratio=1:4", "--back=0.1", "--columns=phi,energy", "--digits=28", *CSV)
    found = printed(*words, "--where=tangential=0.3").records()
    with mp.workdps(40):
        exact = Exact(Plant(Fraction(3), Fraction(1, 4), Fraction(1, 10)))
        for one in found:
            near = mp.mpf(one["phi"]) * mp.pi / 180
            angle = mp.findroot(lambda at: exact.force(at) - mp.mpf("0.3"), (near, near + mp.mpf("1e-9")))
            assert mp.almosteq(angle * 180 / mp.pi, mp.mpf(one["phi"]), abs_eps=mp.mpf("1e-27"))
            assert mp.almosteq(exact.energy(angle), mp.mpf(one["energy"]), abs_eps=mp.mpf("1e-26"))


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


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (
            ("--compression=8", "--heat=5", "--mechanism=beam", "--beam=4", "--where=rod_force=0"),
            "rod_force = 0 holds at every crank angle from 180.91° to 360.61°",
        ),
        (("--eps=4", "--where=tangential=2"), "tangential lies between 0.0000 and 0.6883 Q"),
        (("--eps=4", *SIZE, "--where=torque=20kNm"), "torque lies between 0.0 and 11676"),
        (("--eps=4", "--where=piston_force=0.75"), "holds at every crank angle from 0.00° to 55.38°"),
        (("--eps=4", "--where=torque=3kNm"), 'condition "torque = 3 kNm" is in kNm: column torque_nm needs'),
        (("--eps=4", "--where=energy=3J"), "which only torque and the forces of the crank drive can have"),
        (("--eps=4", "--where=x=1"), "--eps is for conditions on the forces of an engine"),
        (("--eps=4",), "no condition was given; write one as --where torque=max"),
        (
            ("--card", str(CARDS / "ideal-2.csv"), "--where=torque=max"),
            "between its points nothing is proved",
        ),
        (("--eps=4", "--force=1kN", "--where=energy=0"), "--force does not go with the load of an engine"),
        (
            ("--bore=300mm", "--where=p=0"),
            "--bore is for conditions on the forces of an engine",
        ),
        (("--where=torque=3kNm",), 'condition "torque = 3 kNm" is in kNm and needs --force and --stroke'),
    ],
)
def test_what_is_not_solved_is_refused_in_a_sentence(words: tuple[str, ...], sentence: str) -> None:
    code = 1 if "lies between" in sentence else 2
    assert sentence in refusal("solve", *words, code=code)


def test_a_force_that_is_constant_over_a_stroke_is_greatest_at_both_of_its_ends() -> None:
    words = ("solve", "--pump", "--where=piston_force=max", "--columns=phi,piston_force", *CSV)
    assert printed(*words).records() == [
        {"phi": "180.0000", "piston_force": "1.0000"},
        {"phi": "360.0000", "piston_force": "1.0000"},
    ]


def test_the_torque_of_two_cranks_is_greatest_where_a_fine_grid_has_it() -> None:
    words = ("solve", "--eps=4", "--cranks=0;100", "--where=torque=max", "--columns=phi,tangential", *CSV)
    curve = Curve(Plant(Fraction(4), Fraction(1, 5), Fraction(1, 4), cranks=(Fraction(0), Fraction(100))))
    found = printed(*words, "--digits=6").records()
    greatest = float((curve.excess + curve.mean_force).max())
    # The torque is greatest in a corner, which the grid may miss by its step times the slope there.
    assert_allclose([float(one["tangential"]) for one in found], [greatest], rtol=0, atol=2e-4)


def test_a_machine_with_steam_still_has_conditions_on_its_motion() -> None:
    words = ("--machine", str(ROOT / "examples" / "engine.toml"), "--where=p=0", "--columns=stroke,phi", *CSV)
    assert printed("solve", *words).records() == printed("solve", "--ratio=1:5", *words[2:]).records()
