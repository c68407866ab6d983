"""Every cell that kurbel prints of a drive, at the door, against its geometry enclosed."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import pytest
from cli import printed

from kurbel import KurbelError, verify
from kurbel.verify import CONFIRMED, WRONG, Bodies, Drive

BOTH = ("", "_return")
SLIDE = ("x", "c", "p", "psi", "rod_velocity", "rod_acceleration")
FORCES = ("rod_force", "guide_force", "tangential_force", "radial_force", "torque")
ARC = (
    *("path", "velocity", "acceleration", "rocker", "rod", "slant", "turn", "turn_velocity"),
    *("turn_acceleration", "rod_velocity", "rod_acceleration", *FORCES),
)
CHORDS = ("chord", "slide_path", "rise")
COUPLER = ("path", "velocity", "acceleration", "rise", "rise_velocity", "rise_acceleration")


def keys(*names: str, alone: tuple[str, ...] = (), unit: str = "") -> str:
    """Return the columns of both strokes, and those that only one has."""
    both = [f"{name}{end}{unit}" for name in names for end in BOTH]
    return "--columns=" + ",".join(["phi", *both, *alone]).replace("torque_n,", "torque_nm,").replace(
        "torque_return_n,", "torque_return_nm,"
    )


def confirm(of: Drive | Bodies, words: list[str], **how: Any) -> int:
    """Confirm all cells of a page, and return how many."""
    count = 0
    for row in printed(*words, "-f", "csv").records():
        for key in row.keys() - {"ratio", "phi", "point"}:
            shown = row[key]
            assert of.value(key, row.get("phi", "0"), **how).confirms(shown) == CONFIRMED, (words, row, key)
            count += 1
    return count


def angles(chance: random.Random) -> str:
    drawn = [f"{chance.uniform(0, 180):.{chance.randint(0, 6)}f}" for _ in range(2)]
    return "--angle=" + ";".join(["0", "90", *drawn, "180"])


def digits(chance: random.Random) -> str:
    return f"--digits={chance.choice([0, 3, 12, 30])}"


@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.slow)])
def test_slides(seed: int) -> None:
    chance = random.Random(seed)
    rod = Fraction(chance.randint(105, 900), 100)
    room = f"{float(rod - 1) * chance.uniform(-0.9, 0.9):.3f}"
    ratio, run = f"1:{float(rod)}", [angles(chance), digits(chance)]
    assert confirm(
        verify.drive(1 / rod),
        ["table", f"--ratio={ratio}", *run, keys(*SLIDE, *FORCES, alone=("fd", "x_return_percent"))],
    )
    offset = verify.drive(1 / rod, room)
    crank = [f"--ratio={ratio}", f"--offset={room}"]
    assert confirm(offset, ["table", *crank, *run, keys(*SLIDE, *FORCES)])
    assert confirm(offset, ["deadcentres", *crank])
    for method, order in (("series", "1"), ("series", "7"), ("infinite", "")):
        asked = ["table", f"--ratio={ratio}", f"--method={method}", *([f"--order={order}"] if order else [])]
        named = f"{method}-{order}".removesuffix("-")
        columns = keys("x", "c", "p", "psi", "rod_velocity", "rod_acceleration")
        assert confirm(verify.drive(1 / rod), [*asked, *run, columns], method=named)


def test_units_and_times() -> None:
    drive = verify.drive("1:4", "-0.7", radius="0.15", speed="5", turns=True, force=1250)
    size = ["--stroke=300mm", "--ratio=1:4", "--offset=-0.7", "--speed=300/min", "--step=22.5"]
    columns = "--columns=phi,x_mm,c_mps,p_return_mps2,time,time_return,rod_velocity_radps,x_percent"
    assert confirm(drive, ["table", *size, columns])
    columns = "--columns=phi,rod_force_n,guide_force_return_n,torque_nm,torque_return_nm"
    assert confirm(drive, ["forces", *size[:3], "--force=1250N", columns])


ROCKERS: list[tuple[dict[str, Any], list[str]]] = [
    ({"rocker": "6"}, ["--rocker=6"]),
    ({"rocker": "7", "offset": "0.7"}, ["--rocker=7", "--offset=0.7"]),
    ({"rocker": "9", "pivot": ("3.7", "-9.2")}, ["--rocker=9", "--pivot=3.7;-9.2"]),
    ({"rocker": "4.5", "pivot": ("6", "0"), "circuit": -1}, ["--rocker=4.5", "--pivot=6;0", "--circuit=-1"]),
    ({"beam": "3"}, ["--beam=3"]),
]


@pytest.mark.parametrize(("given", "typed"), ROCKERS, ids=[words[0] for _, words in ROCKERS])
def test_rockers(given: dict[str, Any], typed: list[str]) -> None:
    drive, words = verify.drive("1:5", **given), ["--ratio=1:5", *typed]
    decimals = (0, 12, 3, 30, 30)[ROCKERS.index((given, typed))]
    run = [angles(random.Random(str(typed))), f"--digits={decimals}"]
    beam = "beam" in given
    words += [f"--mechanism={'beam' if beam else 'arc'}"]
    assert confirm(drive, ["table", *words, *run, keys(*ARC, *(() if beam else CHORDS))])
    point = ["--point=0.4,0.1", "--angle=17;200", "--digits=20"]
    assert confirm(drive, ["table", *words, *point], point=("0.4", "0.1"))
    if not beam:
        assert confirm(drive, ["deadcentres", *words])


def test_parallel_cranks_and_points_of_rods() -> None:
    names = [f"coupler_{one}" for one in COUPLER]
    coupler = keys(alone=(*names, "tangential_force", "radial_force", "torque"))
    run = ["--step=36", "--digits=9"]
    assert confirm(verify.drive(parallel=True), ["table", "--mechanism=parallel", *run, coupler])
    for offset in ("0", "-0.8"):
        words = ["table", "--ratio=2:7", *([f"--offset={offset}"] if offset != "0" else []), *run]
        drive = verify.drive("2:7", offset)
        for point in (("0.5", "0"), ("-0.2", "0.3"), ("1.0", "0.0")):
            assert confirm(drive, [*words, "--point=" + ",".join(point)], point=point)


# Bodies.

PINS = (
    *("guide_force", "rod_force", "crosshead_pin_force", "crank_pin_force", "torque", "radial_force"),
    *("tangential_force", "bearing_along", "bearing_across", "bearing_force"),
)
ALONG = ("piston_force", "inertia_force", "crosshead_load")
MASSES = {"reciprocating": 120, "rod_mass": "80", "centre": "0.4", "gyration": "0.3", "rotating": "25"}
WEIGHED = ["--reciprocating=120kg", "--rod-mass=80kg", "--centre=40%", "--gyration=30%", "--rotating=25kg"]
SIZE = ["--ratio=1:4", "--speed=180/min"]


@pytest.mark.parametrize("offset", ["0", "0.6"])
def test_masses_weight_friction_and_an_accelerated_crank(offset: str) -> None:
    drive = verify.drive("1:4", offset, radius="0.3", speed="3", turns=True)
    crank = ["forces", "--stroke=600mm", *SIZE, *WEIGHED, *([f"--offset={offset}"] if offset != "0" else [])]
    run = [angles(random.Random(offset)), "--units=N;N m", "--digits=3"]
    heavy = verify.bodies(drive, slope=20, force=5000, **MASSES)
    columns = keys(*PINS, *ALONG, "weight_force", unit="_n")
    assert confirm(heavy, [*crank, "--slope=20", "--force=5kN", *run, columns])
    quick = verify.bodies(drive, acceleration=40, **MASSES)
    assert confirm(quick, [*crank, "--acceleration=40rad/s2", *run, keys(*PINS, unit="_n")])


@pytest.mark.parametrize(
    ("given", "typed", "inertia"),
    [(*rocker, inertia) for rocker, inertia in zip(ROCKERS, ("70", "0", "70"), strict=False)],
    ids=[words[0] for _, words in ROCKERS[:3]],
)
def test_masses_of_a_rocker(given: dict[str, Any], typed: list[str], inertia: str) -> None:
    drive = verify.drive("1:4", **given, radius="0.3", speed="3", turns=True)
    heavy = verify.bodies(drive, force=5000, inertia=inertia, **MASSES)
    crank = ["forces", "--mechanism=arc", "--stroke=crank:300mm", *SIZE, *typed, *WEIGHED, "--force=5kN"]
    crank += [f"--rocker-inertia={inertia}kg m2"] if inertia != "0" else []
    assert confirm(
        heavy, [*crank, "--angle=0;33;151.7", "--units=N;N m", "--digits=3", keys(*PINS, unit="_n")]
    )


def test_rods_of_two_masses() -> None:
    """With k² = a b a rod is two masses at its pins; by the railway rule 4/10 of it goes with the piston."""
    drive = verify.drive("1:4", radius="0.3", speed="3", turns=True)
    rod = {"rod_mass": 80, "centre": "0.2"}
    models = {
        "": verify.bodies(drive, gyration="0.3", **rod),
        "_two_mass": verify.bodies(drive, gyration="0.4", **rod),
        "_railway": verify.bodies(drive, reciprocating=32),
    }
    words = ["inertia", "--stroke=600mm", *SIZE, "--rod-mass=80kg", "--centre=0.2", "--gyration=0.3"]
    asked = [f"inertia_{one}" for model in models for one in (f"guide{model}_n", f"torque{model}_nm")]
    for row in printed(*words, "--angle=17;95;260", keys(alone=tuple(asked)), "-f", "csv").records():
        for model, heavy in models.items():
            for ours, theirs in (("guide", "guide_force_n"), ("torque", "torque_nm")):
                shown = row[f"inertia_{ours}{model}_{theirs.rpartition('_')[2]}"]
                assert heavy.value(theirs, row["phi"]).confirms(shown) == CONFIRMED, (model, ours, row)


@pytest.mark.parametrize("offset", ["0", "0.6"])
def test_the_torque_of_the_masses_is_what_their_energy_loses(offset: str) -> None:
    """By the slope of the energy, of which Newton and Euler know nothing."""
    drive = verify.drive("1:4", offset, radius="0.3", speed="7")
    heavy = verify.bodies(drive, **MASSES | {"rotating": 0})
    step = Fraction(1, 10**6)
    after, before = (heavy.value("kinetic_energy_j", 40 + side * step).near() for side in (1, -1))
    slope = float((after - before) / (2 * step)) * 57.29577951308232
    assert float(heavy.value("torque_nm", 40)) == pytest.approx(-slope, rel=1e-9)


def test_a_digit_changed_by_hand_is_found_wrong() -> None:
    drive = verify.drive("1:5")
    for row in printed("table", "--ratio=1:5", "--angle=17;122", "--digits=8", "-f", "csv").records():
        for key in ("x", "c_return", "p"):
            shown, value = row[key], drive.value(key, row["phi"])
            assert value.confirms(shown) == CONFIRMED
            for place in (place for place, sign in enumerate(shown) if sign.isdigit()):
                changed = shown[:place] + str((int(shown[place]) + 1) % 10) + shown[place + 1 :]
                assert value.confirms(changed) == WRONG


@pytest.mark.parametrize("rocker", ["5.000000000000000000123", "4.999999999999999999877"])
def test_the_greater_of_two_numbers_alike_in_floats_is_proved(rocker: str) -> None:
    """With a rocker of 5 the rod leans alike at both ends of the line of centres."""
    drive = verify.drive("1:5", rocker=rocker, pivot=("7", "0"))
    words = ["deadcentres", "--mechanism=arc", "--ratio=1:5", f"--rocker={rocker}", "--pivot=7;0"]
    words += ["--digits=30"]
    assert confirm(drive, words)
    assert verify.drive("1:5", rocker="5", pivot=("7", "0")).value("transmission").digits(3) == "73.740"


def test_what_cannot_be_verified_is_said() -> None:
    for ask in (
        lambda: verify.drive("1:5").value("nothing"),
        lambda: verify.drive("1:5").value("x", 1, "guess"),
        lambda: verify.drive("1:2", 3),
        lambda: verify.drive("1:5", 4),
        lambda: verify.bodies(verify.drive("1:5")).value("x_mm", 3),
        lambda: verify.drive("1:5").value("x", 1).confirms("1e-4"),
        lambda: verify.drive("1:5").value("x", 1).digits(3, "half-up"),
    ):
        with pytest.raises(KurbelError):
            ask()
