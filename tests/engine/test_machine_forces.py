"""Forces of an engine with its masses, against Newton's and Euler's equations of its bodies.

Crosshead, rod and crank are free bodies in a fixed frame, X in the direction of the outstroke and Y towards
the side on which the crank pin then runs. Their places are written down as geometry says, differentiated by
mpmath, and the equations of motion solved for all forces at once.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from typing import Any, NamedTuple

import pytest
from cli import printed, refusal
from mpmath import mp
from places import CARDS

import kurbel
from kurbel.drive.crank_forces import CRANK_FORCES
from kurbel.errors import ProblemError

DIGITS = 9
Real = Any


class Machine(NamedTuple):
    """A machine in SI units; `centre` and `gyration` in rod lengths, the centre from the crosshead pin."""

    stroke: Fraction
    rod: Fraction
    speed: Fraction
    bore: Fraction
    pressure: Fraction
    expansion: Fraction
    back: Fraction
    reciprocating: Fraction
    mass: Fraction
    centre: Fraction
    gyration: Fraction
    rotating: Fraction
    double: bool

    def words(self) -> list[str]:
        ratio = self.stroke / 2 / self.rod
        lengths = {"stroke": self.stroke, "bore": self.bore}
        masses = {"reciprocating": self.reciprocating, "rod-mass": self.mass, "rotating": self.rotating}
        numbers = {"eps": self.expansion, "back": self.back, "centre": self.centre, "gyration": self.gyration}
        units = {"m": lengths, "kg": masses, "": numbers, "/s": {"speed": self.speed}}
        units["Pa"] = {"pressure": self.pressure}
        texts = [f"--{name}={float(one)}{unit}" for unit, all_ in units.items() for name, one in all_.items()]
        words = [f"--ratio={ratio.numerator}/{ratio.denominator}", *texts]
        return words if self.double else [*words, "--single-acting"]


def machines() -> Iterator[Machine]:
    dice = random.Random(1907)

    def between(low: float, high: float) -> Fraction:
        return Fraction(f"{dice.uniform(low, high):.4g}")

    for number in range(6):
        stroke = between(0.2, 1.2)
        yield Machine(
            stroke=stroke,
            rod=Fraction(f"{float(stroke) / 2 * dice.uniform(2.5, 7):.4g}"),
            speed=between(1, 9),
            bore=between(0.1, 0.6),
            pressure=between(3e5, 2e6),
            expansion=between(1.5, 7),
            back=between(0.02, 0.2),
            reciprocating=between(20, 500),
            mass=between(10, 300),
            centre=between(0.3, 0.9),
            gyration=between(0.2, 0.5),
            rotating=between(-80, 90),
            double=number % 2 == 0,
        )


def gas_force(machine: Machine, phi: Real) -> Real:
    """The force of the steam on the piston in the direction of the outstroke."""
    radius, rod = mp.mpf(machine.stroke.numerator) / machine.stroke.denominator / 2, _real(machine.rod)
    slant = mp.asin(radius / rod * mp.sin(phi))
    share = (radius * (1 - mp.cos(phi)) + rod * (1 - mp.cos(slant))) / (2 * radius)
    out = phi < mp.pi
    if not out and not machine.double:
        return mp.mpf(0)
    travelled = share if out else 1 - share
    cut_off = 1 / _real(machine.expansion)
    net = (1 if travelled <= cut_off else cut_off / travelled) - _real(machine.back)
    whole = mp.pi / 4 * _real(machine.bore) ** 2 * _real(machine.pressure)
    return net * whole * (1 if out else -1)


def _real(value: Fraction) -> Real:
    return mp.mpf(value.numerator) / value.denominator


def solved(
    machine: Machine, degrees: Fraction, force: Callable[[Machine, Real], Real] = gas_force, offset: Real = 0
) -> Mapping[str, Real]:
    """Return all forces in N and the torque in N m under this force on the piston, offset in m."""
    radius, length = _real(machine.stroke) / 2, _real(machine.rod)
    omega, phi = 2 * mp.pi * _real(machine.speed), _real(degrees) * mp.pi / 180

    def slant(at: Real) -> Real:
        return mp.asin((radius * mp.sin(at) - offset) / length)

    def head(at: Real) -> Real:
        return -radius * mp.cos(at) - length * mp.cos(slant(at))

    def centre(at: Real) -> tuple[Real, Real]:
        share = _real(machine.centre)
        across = offset * (1 - share) + radius * mp.sin(at) * share
        return head(at) * (1 - share) - radius * mp.cos(at) * share, across

    def twice(place: Callable[[Real], Real]) -> Real:
        return omega**2 * mp.diff(place, phi, 2)

    gas, inertia = force(machine, phi), _real(machine.mass) * (_real(machine.gyration) * length) ** 2
    rod, crank = _real(machine.mass), _real(machine.rotating)
    a_head, a_centre = twice(head), (twice(lambda at: centre(at)[0]), twice(lambda at: centre(at)[1]))
    # The rod turns against the slant, which grows as its crank-pin end rises; counted from X to Y.
    turning = twice(slant)
    at_centre, pin = centre(phi), (-radius * mp.cos(phi), radius * mp.sin(phi))
    to_head = (head(phi) - at_centre[0], offset - at_centre[1])
    to_pin = (pin[0] - at_centre[0], pin[1] - at_centre[1])
    a_pin = (omega**2 * radius * mp.cos(phi), -(omega**2) * radius * mp.sin(phi))
    # Unknown: B on the rod (x, y), N on the crosshead, A on the rod (x, y), bearing on the crank (x, y), and
    # the torque of what the engine drives.
    rows = [
        ([-1, 0, 0, 0, 0, 0, 0, 0], _real(machine.reciprocating) * a_head - gas),
        ([0, -1, 1, 0, 0, 0, 0, 0], mp.mpf(0)),
        ([1, 0, 0, 1, 0, 0, 0, 0], rod * a_centre[0]),
        ([0, 1, 0, 0, 1, 0, 0, 0], rod * a_centre[1]),
        ([-to_head[1], to_head[0], 0, -to_pin[1], to_pin[0], 0, 0, 0], inertia * turning),
        ([0, 0, 0, -1, 0, 1, 0, 0], crank * a_pin[0]),
        ([0, 0, 0, 0, -1, 0, 1, 0], crank * a_pin[1]),
        ([0, 0, 0, pin[1], -pin[0], 0, 0, 1], mp.mpf(0)),
    ]
    b_x, b_y, guide, a_x, a_y, h_x, h_y, load = mp.lu_solve(
        mp.matrix([row for row, _ in rows]), mp.matrix([right for _, right in rows])
    )
    along = (mp.cos(slant(phi)), mp.sin(slant(phi)))
    # The crank turns from -X towards Y, clockwise: its torque is that against the load.
    return {
        "piston_force_n": gas,
        "rod_force_n": b_x * along[0] + b_y * along[1],
        "guide_force_n": guide,
        "crosshead_pin_force_n": mp.hypot(b_x, b_y),
        "crank_pin_force_n": mp.hypot(a_x, a_y),
        "tangential_force_n": -a_x * mp.sin(phi) - a_y * mp.cos(phi),
        "radial_force_n": -a_x * mp.cos(phi) + a_y * mp.sin(phi),
        "bearing_along_n": -h_x,
        "bearing_across_n": -h_y,
        "bearing_force_n": mp.hypot(h_x, h_y),
        "torque_nm": load,
    }


ANGLES = [Fraction(text) for text in ("7.5", "40", "98", "133", "171", "200.5", "246", "290", "352")]


@pytest.mark.parametrize("machine", list(machines()), ids=lambda one: f"{one.speed}")
def test_every_force_solves_the_equations_of_motion(machine: Machine) -> None:
    angles = ";".join(str(float(angle)) for angle in ANGLES)
    keys = list(solved(machine, ANGLES[0]))
    words = ("forces", *machine.words(), f"--angle={angles}", f"--digits={DIGITS}", "-f", "csv")
    records = printed(*words, f"--columns=phi,{','.join(keys)}").records()
    with mp.workdps(40):
        for record, degrees in zip(records, ANGLES, strict=True):
            for key, value in solved(machine, degrees).items():
                assert mp.almosteq(mp.mpf(record[key]), value, rel_eps=1e-14, abs_eps=0.6 * 10**-DIGITS), key


def opposite(keys: Mapping[str, Real]) -> dict[str, Real]:
    """Forces with a direction, in the frame of the return stroke, where a rod that is pulled counts as S."""
    turned = ("rod_force_n", "guide_force_n", "bearing_along_n", "bearing_across_n")
    return {key: -value if key in turned else value for key, value in keys.items()}


@pytest.mark.parametrize("machine", list(machines())[:4], ids=lambda one: f"{one.speed}")
def test_a_piston_force_and_an_offset_solve_the_equations_of_motion_too(machine: Machine) -> None:
    angles = [Fraction(text) for text in ("12.5", "75", "140")]
    newtons, share = 4321, Fraction(3, 10)
    offset = _real(share * machine.stroke / 2)
    forces = [key for key in solved(machine, angles[0]) if key not in ("piston_force_n", "torque_nm")]
    columns = [key.replace("_n", f"{back}_n") for key in forces for back in ("", "_return")]
    steam = ("--eps", "--back", "--bore", "--pressure")
    words = [word for word in machine.words() if not word.startswith(steam)]
    words = [word for word in words if word != "--single-acting"]
    records = printed(
        "forces", *words, f"--force={newtons}N", f"--offset={float(share)}", f"--digits={DIGITS}",
        "--angle=" + ";".join(str(float(angle)) for angle in angles),
        "--columns=" + ",".join([*columns, "torque_nm", "torque_return_nm"]), "-f", "csv",
    ).records()  # fmt: skip
    with mp.workdps(40):
        for record, angle in zip(records, angles, strict=True):
            out = solved(machine, angle, lambda machine, phi: mp.mpf(newtons), offset)
            back = opposite(solved(machine, angle + 180, lambda machine, phi: -mp.mpf(newtons), offset))
            for key in (*forces, "torque_nm"):
                stem, _, unit = key.rpartition("_")
                for value, column in ((out[key], key), (back[key], f"{stem}_return_{unit}")):
                    found = mp.mpf(record[column])
                    assert mp.almosteq(found, value, rel_eps=1e-14, abs_eps=0.6 * 10**-DIGITS), column


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
    machine = next(machines())
    keys = ",".join(key for force in CRANK_FORCES for key in (force, f"{force}_n"))
    words = ("forces", *machine.words(), "--angle=40;200.5", "--digits=12", "-f", "csv", f"--columns={keys}")
    whole = math.pi / 4 * float(machine.bore) ** 2 * float(machine.pressure)
    for record in printed(*words).records():
        for force in CRANK_FORCES:
            assert math.isclose(float(record[force]) * whole, float(record[f"{force}_n"]), rel_tol=1e-9), (
                force
            )


def test_without_rotating_mass_the_bearing_is_pressed_as_the_pin_is() -> None:
    machine = next(machines())._replace(rotating=Fraction(0))
    words = ("forces", *machine.words(), "--step=30", "-f", "csv")
    for record in printed(*words, "--columns=crank_pin_force_n,bearing_force_n").records():
        assert record["crank_pin_force_n"] == record["bearing_force_n"]


def test_the_mean_torque_is_that_of_the_steam_alone() -> None:
    machine = next(machines())
    words = ("forces", *machine.words(), "--from=0", "--to=359", "--step=1", "--digits=6", "-f", "csv")
    torques = [float(record["torque_nm"]) for record in printed(*words, "--columns=torque_nm").records()]
    whole = math.pi / 4 * float(machine.bore) ** 2 * float(machine.pressure)
    cut_off, stroke = 1 / float(machine.expansion), float(machine.stroke)
    work = 2 * whole * stroke * (cut_off * (1 - math.log(cut_off)) - float(machine.back))
    # The kinks at cut-off are what 360 equal steps do not see.
    assert math.isclose(math.fsum(torques) / 360, work / (2 * math.pi), rel_tol=2e-4)


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
    records = printed("inertia", "--layout=inertia-errors", *words.split(), "-f", "csv").records()
    found = [[*one.values()][-1] for one in records if one["force"] == force]
    assert found[: len(expected)] == expected


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


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ("--eps 4 --reciprocating 3kg --speed 1/s --stroke 1m", "--reciprocating needs --bore, --pressure"),
        ("--eps 4 --bore 1m", "newtons need the bore and the steam pressure; add --pressure"),
        ("--eps 4 --pressure 1bar", "newtons need the bore and the steam pressure; add --bore"),
        ("--bore 1m", "--bore is for the steam of an engine; add --eps or --card"),
        ("--rod-mass 1kg", "--rod-mass needs --stroke, --speed to become a force"),
        ("--speed 120/min", "--speed is for moving masses; add --reciprocating or a rod, --rod-mass"),
        ("--eps 4 --speed 120/min", "--speed is for moving masses; add --reciprocating or a rod"),
        ("--eps 4 --stroke 1m", "--stroke makes newton metres of the steam only with --bore; add that"),
        ("--back 0.1", "--back is for the steam of an engine; add --eps or --card"),
        ("--compression 6 --exponent 1.3 --layout forces", "--compression says nothing on layout forces"),
        ("--layout engine-forces", "layout engine-forces is of a steam engine; add --eps or --card"),
        ("--eps 4 --layout machine-forces", "layout machine-forces is of an engine with its masses; give"),
        ("--eps 4 --force 1kN", "--force does not go with the steam of an engine, --eps or --card; leave"),
        ("--eps 4 --offset 4", "offset e = 4 R is too large for R:L = 1:5; the crank turns only if |e| < L"),
        ("--at tangent --eps 4", "--eps does not go with --at tangent, a position under one piston force"),
        ("--eps 4 --columns torque_nm", "column torque_nm needs --stroke, --bore and, but for a card"),
        ("--eps 4 --bore 1m --pressure 1m", 'pressure "1m" is in meter; it must be a pressure'),
        ("--eps 4 --bore 1m --pressure=-1bar", "the pressure is -100000 Pa; it must be above 0"),
    ],
)
def test_wrong_usage_is_answered_with_a_sentence(words: str, sentence: str) -> None:
    assert refusal("forces", *words.split()).startswith(sentence)


SCALE: dict[str, Any] = {"speed": 2, "bore": 1, "pressure": 1, "stroke": 1}


@pytest.mark.parametrize(
    ("choices", "sentence"),
    [
        (
            {"reciprocating": 3},
            "--reciprocating needs --stroke, --speed, --bore, --pressure to become a force",
        ),
        ({"reciprocating": 3, "speed": 2}, "--reciprocating needs --stroke, --bore, --pressure to become"),
        (
            {"reciprocating": 3, "speed": 2, "stroke": 1},
            "--reciprocating needs --bore, --pressure to become a force",
        ),
        ({"bore": 1}, "newtons need the bore and the steam pressure; add --pressure"),
        ({"bore": 0, "pressure": 1}, "the bore is 0 m; it must be above 0"),
        ({"reciprocating": -1, **SCALE}, "the reciprocating mass is -1 kg; it must lie within 0..10^9 kg"),
        ({"rotating": 1e10, **SCALE}, "the rotating mass is 10000000000 kg; it must lie within -10^9..10^9"),
        (
            {"rod_mass": 1, "centre": "1.2", "gyration": 1, **SCALE},
            "the rod's centre of mass is 1.2 L from the crosshead pin; it must lie within 0..1",
        ),
        ({"centre": "0.5", "gyration": "0.3", **SCALE}, "the rod's masses are shares; add its mass in kg"),
    ],
)
def test_impossible_masses_are_answered_with_a_sentence(choices: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ProblemError) as raised:
        kurbel.forces_table(eps=4, layout="engine-forces", **choices)
    assert str(raised.value).startswith(sentence)
