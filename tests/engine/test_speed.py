"""The speed over the turn with a given flywheel, against an integrated equation of motion."""

from __future__ import annotations

import math
from fractions import Fraction

import flint
import numpy as np
import pytest
from cli import kurbel, printed, refusal
from equation_of_motion import Masses, Motion, Shaft
from numpy.testing import assert_allclose
from places import CARDS

from kurbel.drive.crank import Crank
from kurbel.drive.rod import Moving, Rod
from kurbel.drive.wheel import Wheel
from kurbel.engine.engine import Engine, Load, Steam
from kurbel.engine.speed.quantities import of_runs
from kurbel.engine.speed.run import run_of
from kurbel.engine.turn import turn_of
from kurbel.page.layouts import layout
from kurbel.page.subject import subject
from kurbel.reading.units import Speed

PLANTS = [
    (Fraction(4), Fraction(1, 5), Fraction(0), True, (0,), 3),
    (Fraction(5, 2), Fraction(2, 7), Fraction(0), False, (0, 90), 20),
    (Fraction(3), Fraction(1, 4), Fraction(1, 5), True, (0, 140), 2),
]
RADIUS, BORE, PRESSURE, TURNS = Fraction(3, 10), Fraction(3, 10), 800_000, Fraction(2)
MACHINE = (
    "--stroke 600mm --bore 300mm --pressure 8bar --speed 120/min --reciprocating 300kg --rod-mass 150kg"
    " --centre 0.6 --gyration 0.3"
)
ANGLES = np.radians([7, 61, 103, 170, 203, 259, 341])
BITS = 100


@pytest.mark.parametrize(("expansion", "ratio", "offset", "double", "cranks", "number"), PLANTS)
def test_speed_and_time_are_those_of_the_equation_of_motion(
    expansion: Fraction, ratio: Fraction, offset: Fraction, double: bool, cranks: tuple[int, ...], number: int
) -> None:
    back = Fraction(1, 7)
    shaft = Shaft(1.0, float(expansion), float(back), float(1 / ratio), float(offset), double, cranks)
    motion = Motion(shaft)
    # With J = 1 the speed at the dead centre follows from J ω²/P; the other one is 5π.
    first = math.sqrt(number * motion.mean)
    speeds, times = motion.turn(first, ANGLES)
    least, greatest = motion.extremes(first)
    steam = Steam(expansion, back)
    engine = Engine(Crank(ratio, offset), steam, double, tuple(map(Fraction, cranks)))
    run = run_of(turn_of(engine, "exact"), Wheel(Fraction(number), speed=Speed(Fraction(5, 2))))
    unit = 5 * math.pi / (greatest + least) * 2
    places = [Fraction(round(math.degrees(one))) / 180 for one in ANGLES] + [Fraction(2)]
    with flint.ctx.workprec(BITS):
        found = [(float(run.speed(one)), float(run.time(one))) for one in places[:-1]]
        assert_allclose(float(run.extreme_speed(greatest=True)), greatest / first, rtol=1e-10)
        assert_allclose(float(run.extreme_speed(greatest=False)), least / first, rtol=1e-10)
        assert_allclose(float(run.irregularity()), 2 * (greatest - least) / (greatest + least), rtol=1e-9)
        assert_allclose(float(run.time(Fraction(7, 3)) - run.time(Fraction(1, 3))), times[-1] / unit)
    assert_allclose([one for one, _ in found], speeds[:-1] / first, rtol=1e-10)
    assert_allclose([one for _, one in found], times[:-1] / unit, rtol=1e-10)


def rows(command: str) -> list[dict[str, float]]:
    lines = printed(*command.split(), "-f", "csv").records()
    return [{key: float(value) for key, value in one.items() if _is_number(value)} for one in lines]


def _is_number(text: str) -> bool:
    return text[-1:].isdigit() and ":" not in text


def test_flywheel_and_delta_are_inverse() -> None:
    about = "--eps 3 --power 50kW --speed 120/min"
    (wheel,) = rows(f"flywheel {about} --delta 1:37 --columns inertia --digits 20")
    (page,) = rows(
        f"delta {about} --inertia {wheel['inertia']!r}kgm2 --columns one_to_mean,number --digits 9"
    )
    assert_allclose(page["one_to_mean"], 37, rtol=1e-12)
    # A wheel given by its number has the speeds of the one that has this number.
    (by_number,) = rows(f"delta --eps 3 --flywheel {page['number']!r} --columns one_to_mean --digits 9")
    assert_allclose(by_number["one_to_mean"], 37, rtol=1e-9)


def test_heavy_flywheel_has_the_irregularity_of_first_order() -> None:
    (page,) = rows("delta --eps 4 --flywheel 1e9 --columns delta_mean,delta_first,delta --digits 18")
    assert_allclose([page["delta_mean"] * 1e9, page["delta_first"] * 1e9], page["delta"], rtol=1e-8)


def test_weisbachs_speed_is_one_and_his_work_over_the_number() -> None:
    for row in rows("turning --eps 2 --flywheel 7 --method weisbach --columns phi,energy,speed --digits 12"):
        mean = 2 / math.pi * math.log(2) / 2
        assert_allclose(row["speed"], 1 + row["energy"] / mean / 7, atol=3e-12)
    (page,) = rows("delta --eps 2 --flywheel 7 --method weisbach --columns delta,delta_first --digits 12")
    assert_allclose(page["delta_first"], page["delta"] / 7, rtol=1e-11)


def test_card_of_the_ideal_engine_has_its_speed_and_time() -> None:
    asked = "--flywheel 3 --speed 120/min --angle 0;30;215;360;400 --columns phi,speed,rpm,time --digits 6"
    by_card = rows(f"turning --card {CARDS / 'ideal-2.csv'} {asked}")
    for card, ideal in zip(by_card, rows(f"turning --eps 2 --back 0.5 {asked}"), strict=True):
        assert_allclose([card[key] for key in ideal], [*ideal.values()], atol=1.1e-6)
        assert card["time_error"] < 1e-8


@pytest.mark.parametrize(
    ("command", "said"),
    [
        (
            "turning --eps 4 --flywheel 0.1",
            "the flywheel of m₁v₁²/(P r) = 0.1 is too light to pass the turn: at φ = 3.2° it would come to"
            " rest; m₁v₁²/(P r) must be above 0.369",
        ),
        (
            "delta --eps 4 --inertia 17kgm2 --power 50kW --speed 120/min",
            "the flywheel of J = 17 kg m² is too light to pass the turn: at φ = 201.2° it would come to rest;"
            " J must be above 18 kg m²",
        ),
        (
            f"delta --eps 4 --inertia 5kgm2 {MACHINE}",
            "at φ = 201° it would come to rest; J must be above 5.77 kg m²",
        ),
        ("turning --eps 4 --layout speed", "of an engine with its flywheel; give that as --flywheel"),
        ("turning --flywheel 50 --columns phi,energy", "--flywheel says nothing on this page; add a column"),
        ("turning --flywheel 50 --layout turning", "leave --layout turning or the flywheel out"),
        ("turning --eps 4 --flywheel 50 --columns omega", "column omega needs the mean speed, --speed"),
        ("delta --flywheel 50 --detail", "leave --detail or the flywheel out"),
        ("delta --flywheel 50 --inertia 9kgm2 --speed 2/s", "both describe the flywheel; leave one out"),
        ("delta --inertia 9kgm2", "--inertia needs the mean speed; add --speed"),
        ("delta --inertia 9kgm2 --speed 2/s", "--inertia needs the mean torque that it takes up"),
        ("delta --inertia 9kg --speed 2/s --power 5kW", "is in kilogram; it must be a moment of inertia"),
        ("delta --power 50kW", "--power is for --inertia"),
        ("delta --resistance square", "--resistance is for a flywheel; add --flywheel or --inertia"),
        ("delta --flywheel 9 --resistance cube", "choose from constant, square"),
        (
            "delta --pressure-ratio 3 --flywheel 9 --resistance square",
            "the speed of a driven machine is computed against a constant torque; leave --resistance out",
        ),
        (
            "delta --eps 4 --inertia 5kgm2 --power 50kW --speed 2/s --resistance square",
            "as if there were none; J must be above 5.76 kg m²",
        ),
        ("turning --eps 4 --flywheel 9 --columns time", "column time needs the mean speed, --speed;"),
        ("delta --flywheel 0", "is 0; it must lie within 10^-9 and 10^12"),
        ("turning --flywheel 50 --bore 300mm", "--bore is for moving masses"),
    ],
)  # fmt: skip
def test_a_flywheel_that_will_not_do_is_one_sentence(command: str, said: str) -> None:
    assert said in refusal(*command.split())


def test_bounds_of_the_flywheel_are_where_the_speed_vanishes() -> None:
    # The bound is rounded up to three figures, so that 0.3 % less will not do.
    for flywheel, passes in (("0.369", True), ("0.3679", False)):
        result = kurbel(*f"turning --eps 4 --flywheel {flywheel} --columns phi,speed".split())
        assert (result.code == 0) is passes


@pytest.mark.parametrize(("command", "page"), [("turning", "speed"), ("delta", "delta-flywheel")])
@pytest.mark.parametrize("lang", ["de", "en"])
def test_every_column_of_a_flywheel_is_printed(command: str, page: str, lang: str) -> None:
    wheel = ["--inertia", "900kgm2", "--power", "50kW", "--speed", "120/min", "--eps", "3", "--lang"]
    for key in of_runs() & {*subject(layout(page).subject).quantities()}:
        result = printed(command, *wheel, lang, "--columns", key)
        assert len(result.out.splitlines()) > 5


HEAVY = [
    (Fraction(1, 5), Fraction(0), (0,), Wheel(inertia=Fraction(150), speed=Speed(TURNS))),
    (Fraction(2, 7), Fraction(1, 5), (0, 100), Wheel(inertia=Fraction(60), speed=Speed(TURNS))),
    (Fraction(1, 4), Fraction(0), (0,), Wheel(number=Fraction(5), speed=Speed(TURNS))),
]


@pytest.mark.parametrize(("ratio", "offset", "cranks", "wheel"), HEAVY)
def test_masses_have_the_speed_of_their_equation_of_motion(
    ratio: Fraction, offset: Fraction, cranks: tuple[int, ...], wheel: Wheel
) -> None:
    rod = Rod.from_crosshead(Fraction(6, 10), Fraction(3, 10), Fraction(150))
    crank = Crank(ratio, offset, RADIUS, Speed(TURNS), moving=Moving(Fraction(300), rod))
    load = Load(BORE, Fraction(PRESSURE))
    engine = Engine(crank, Steam(Fraction(4), Fraction(1, 7)), True, tuple(map(Fraction, cranks)), load)
    force, radius = math.pi / 4 * float(BORE) ** 2 * PRESSURE, float(RADIUS)
    with flint.ctx.workprec(BITS):
        run = run_of(turn_of(engine, "exact"), wheel)
        first = float(run.first_omega)
        inertia = float(run.number * run.mean_torque / run.first_omega**2)
        if wheel.inertia is not None:
            assert_allclose(inertia, float(wheel.inertia), rtol=1e-12)
        masses = Masses(300 * radius / force, 150 * radius / force, 0.6, 0.3)
        shaft = Shaft(
            inertia / (force * radius), 4.0, 1 / 7, float(1 / ratio), float(offset), True, cranks, masses
        )
        motion = Motion(shaft)
        speeds, times = motion.turn(first, ANGLES)
        least, greatest = motion.extremes(first)
        # That the turn closes, and that the mean of the extremes is the speed that was given.
        assert_allclose([speeds[-1], (least + greatest) / 2], [first, 4 * math.pi], rtol=1e-9)
        assert_allclose(float(run.irregularity()), 2 * (greatest - least) / (greatest + least), rtol=1e-7)
        places = [Fraction(round(math.degrees(one))) / 180 for one in ANGLES]
        assert_allclose([float(run.speed(one)) for one in places], speeds[:-1] / first, rtol=1e-10)
        assert_allclose([float(run.time(one)) for one in places], times[:-1], rtol=1e-10)


def test_masses_of_next_to_nothing_alter_nothing() -> None:
    engine = "--eps 4 --inertia 60kgm2 --speed 120/min --stroke 600mm --bore 300mm --pressure 8bar"
    asked = "--angle 0;40;200;300 --columns speed,rpm,time --digits 9"
    light = rows(f"turning {engine} --reciprocating 0.000001kg {asked}")
    (swing,) = rows(f"delta {engine} --reciprocating 0.000001kg --columns delta_mean --digits 9")
    mean = 2 / math.pi * math.log(4) / 4 * math.pi / 4 * 0.3**2 * 8e5 * 0.3
    power = f"--power {mean * 4 * math.pi!r}W"
    bare = rows(f"turning --eps 4 --inertia 60kgm2 --speed 120/min {power} {asked}")
    (delta,) = rows(f"delta --eps 4 --inertia 60kgm2 --speed 120/min {power} --columns delta_mean --digits 9")
    assert_allclose([[*one.values()] for one in light], [[*one.values()] for one in bare], atol=2e-6)
    assert_allclose(swing["delta_mean"], delta["delta_mean"], rtol=1e-6)


def test_series_and_infinite_rod_have_a_speed() -> None:
    # With an infinite rod both strokes are alike, and all extremes come twice.
    for row, again in zip(
        rows("turning --eps 4 --ratio 1:∞ --flywheel 2 --angle 33;90;151 --columns speed"),
        rows("turning --eps 4 --ratio 1:∞ --flywheel 2 --angle 213;270;331 --columns speed --method series"),
        strict=True,
    ):
        assert row["speed"] == again["speed"]
    (page,) = rows(f"delta --eps 4 --ratio 1:∞ --inertia 40kgm2 {MACHINE}")
    assert page["one_to_mean"] > 1


@pytest.mark.parametrize(
    "command",
    [
        "--pressure-ratio 3 --clearance 5% --mechanism arc --rocker 6 --ratio 1:4 --cranks 0;70",
        "--compression 8 --peak-pressure 30 --ratio 1:4 --offset 0.1",
        "--eps 4 --exponent 1.13 --clearance 5% --method series --cranks 0;35",
        "--pump double --cranks 0;90",
    ],
)
def test_time_is_the_integral_of_the_slowness(command: str) -> None:
    # Simpson's rule over the printed speeds, which no continuation into the complex plane has seen.
    low, high, cells = 37, 55, 24
    asked = f"turning {command} --flywheel 3 --speed 120/min --digits 12 --columns"
    page = rows(f"{asked} omega --angle {low}..{high}:{(high - low) / cells}")
    slow = 1 / np.array([row["omega"] for row in page])
    step = math.radians((high - low) / cells)
    elapsed = step / 3 * (slow[0] + 4 * slow[1::2].sum() + 2 * slow[2:-1:2].sum() + slow[-1])
    start, end = rows(f"{asked} time --angle {low};{high}")
    assert_allclose(end["time"] - start["time"], elapsed, rtol=1e-8)


@pytest.mark.parametrize(
    ("expansion", "ratio", "offset", "cranks", "resistance"),
    [
        (Fraction(4), Fraction(1, 5), Fraction(0), (0,), 0.12),
        (Fraction(3), Fraction(1, 4), Fraction(1, 5), (0,), 0.1),
    ],
)
def test_against_the_square_of_the_speed_it_is_that_of_the_equation_of_motion(
    expansion: Fraction, ratio: Fraction, offset: Fraction, cranks: tuple[int, ...], resistance: float
) -> None:
    back = Fraction(1, 7)
    shaft = Shaft(1.0, float(expansion), float(back), float(1 / ratio), float(offset), True, cranks)
    motion = Motion(shaft, resistance)
    first = motion.steady()
    speeds, times = motion.turn(first, ANGLES)
    least, greatest = motion.extremes(first)
    number = first**2 / motion.mean
    engine = Engine(Crank(ratio, offset), Steam(expansion, back), True, tuple(map(Fraction, cranks)))
    turn, square = turn_of(engine, "exact"), "square"
    at_mean = number * ((least + greatest) / 2 / first) ** 2
    inertia = Wheel(None, Fraction(100), Speed(TURNS), Fraction(100 * (4 * math.pi) ** 3 / at_mean), square)
    places = [Fraction(round(math.degrees(one))) / 180 for one in ANGLES]
    with flint.ctx.workprec(70):
        run = run_of(turn, inertia if offset else Wheel(Fraction(number), resistance=square))
        assert_allclose(float(run.number), number, rtol=1e-8)
        assert_allclose([float(run.speed(one)) for one in places], speeds[:-1] / first, rtol=1e-9)
        turned = [float(run.turned(one)) * math.pi for one in places]
        assert_allclose(turned, times[:-1] * first, rtol=1e-9)
        extremes = [float(run.extreme_speed(one)) * first for one in (False, True)]
        assert_allclose(extremes, [least, greatest], rtol=1e-8)


@pytest.mark.parametrize("wheel", ["--inertia 20kgm2", "--flywheel 3"])
def test_masses_by_the_card_of_the_ideal_engine_have_its_speed(wheel: str) -> None:
    card = f"--card {CARDS / 'ideal-2.csv'}"
    by_card, ideal = MACHINE.replace("--pressure 8bar", card), f"--eps 2 --back 0.5 {MACHINE}"
    asked = f"{wheel} --angle 0;30;215;400 --columns phi,speed,rpm,time --digits 5"
    for one, true in zip(rows(f"turning {by_card} {asked}"), rows(f"turning {ideal} {asked}"), strict=True):
        assert_allclose([one[key] for key in true], [*true.values()], rtol=1e-6, atol=1.1e-5)
    (page,), (true,) = rows(f"delta {by_card} {wheel} --digits 6"), rows(f"delta {ideal} {wheel} --digits 6")
    for key in ("speed_min", "speed_max", "delta_mean", "delta_first"):
        assert_allclose(page[key], true[key], atol=1.1e-6)
