"""Random problems of every kind, each answered by kurbel and by a computation of another kind.

By hand: .venv/bin/python tests/support/random_problems.py --count 200 --seed 7
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable, Sequence
from decimal import Decimal
from random import Random
from typing import Any

from answers_balance import polar, turned
from answers_diagrams import formula, points_of, swing_of, swing_of_points
from answers_flywheels import range_of
from answers_motion import path, place
from answers_power import mean_pressure, swept, turns
from cli import printed
from mpmath import cos, mp, mpc, mpf, pi, quad, radians
from newton_euler import Drive
from problem_answers import Rows, in_si

Asked = tuple[list[str], Rows]
KINDS: dict[str, Callable[[Random], Asked]] = {}


def kind(draw: Callable[[Random], Asked]) -> Callable[[Random], Asked]:
    KINDS[draw.__name__] = draw
    return draw


def number(random: Random, low: float, high: float, figures: int = 3) -> str:
    """A number as a problem has it, of a few figures."""
    return f"{Decimal(f'{random.uniform(low, high):.{figures}g}'):f}"


def si(value: str) -> mpf:
    one = in_si(value)
    assert isinstance(one, mpf)
    return one


def crank_drive(random: Random) -> tuple[list[str], mpf, mpf, mpf]:
    """Options of a crank drive, and its crank, rod and speed."""
    crank = number(random, 40, 400)
    rod = number(random, 2.2 * float(crank), 6 * float(crank), 4)
    speed = number(random, 60, 1500)
    words = ["--crank", f"{crank}mm", "--rod", f"{rod}mm", "--speed", f"{speed}/min"]
    return words, mpf(crank) / 1000, mpf(rod) / 1000, si(f"{speed}/min")


@kind
def motion(random: Random) -> Asked:
    words, crank, rod, speed = crank_drive(random)
    angle = number(random, 5, 175)
    columns = ["--angle", angle, "--columns", "phi,x_mm,c_mps,p_mps2", "--digits", "6"]
    return ["table", *words, *columns], [place(mpf(angle), crank, rod, speed)]


@kind
def forces(random: Random) -> Asked:
    """Newton and Euler, the weights at any slope of the slide."""
    words, crank, rod, speed = crank_drive(random)
    piston, heavy = number(random, 1, 300), number(random, 1, 200)
    centre, gyration = number(random, 0.4, 0.8), number(random, 0.2, 0.5)
    slope, angle = str(random.randrange(-180, 181, 5)), number(random, 3, 177)
    force = number(random, 1, 60)
    drive = Drive(
        crank,
        rod,
        speed,
        mpf(piston),
        mpf(heavy),
        mpf(centre) * rod,
        mpf(gyration) * rod,
        mpf(slope),
        mpf("9.81"),
    )
    found = drive.forces(mpf(angle), mpf(force) * 1000)
    masses = ["--reciprocating", f"{piston}kg", "--rod-mass", f"{heavy}kg"]
    masses += ["--centre", centre, "--gyration", gyration, "--slope", slope, "--gravity", "9.81"]
    columns = ["guide_force_n", "crank_pin_force_n", "torque_nm"]
    asked = ["--force", f"{force}kN", "--angle", angle, "--columns", ",".join(columns), "--digits", "3"]
    return ["forces", *words, *masses, *asked], [{key: found[key] for key in columns}]


@kind
def effort(random: Random) -> Asked:
    """Pressures on both sides, piston rod, friction and weight of a vertical engine, on either stroke."""
    words, crank, rod, speed = crank_drive(random)
    bore, thick = number(random, 150, 500), number(random, 20, 90)
    cover, under = number(random, 0.5, 9), number(random, 0.1, 5)
    mass, friction = number(random, 5, 300), number(random, 50, 900)
    angle = random.choice((number(random, 3, 177), number(random, 183, 357)))
    steam = mpf(10) ** 5 * pi / 4 / 10**6
    steam *= mpf(cover) * mpf(bore) ** 2 - mpf(under) * (mpf(bore) ** 2 - mpf(thick) ** 2)
    against = mpf(friction) if mpf(angle) < 180 else -mpf(friction)
    drive = Drive(crank, rod, speed, mpf(mass), slope=mpf(90), gravity=mpf("9.81"))
    found = drive.forces(mpf(angle), steam - against)
    words += ["--bore", f"{bore}mm", "--piston-rod", f"{thick}mm", "--head-pressure", f"{cover}bar"]
    words += ["--crank-pressure", f"{under}bar", "--reciprocating", f"{mass}kg", "--friction", f"{friction}N"]
    columns = ["guide_force_n", "torque_nm"]
    asked = [
        "--vertical",
        "--gravity",
        "9.81",
        "--angle",
        angle,
        "--columns",
        ",".join(columns),
        "--digits",
        "3",
    ]
    return ["forces", *words, *asked], [{key: found[key] for key in columns}]


@kind
def steam_engine(random: Random) -> Asked:
    """A double-acting engine at any angle: expansion on either side, piston rods, friction, weight."""
    words, crank, rod, speed = crank_drive(random)
    bore, thick, tail = number(random, 200, 600), number(random, 20, 90), number(random, 20, 90)
    pressure, back = number(random, 5, 14), number(random, 0.3, 1.6)
    expansion, clearance = mpf(number(random, 1.5, 6, 2)), mpf(number(random, 1, 12, 2)) / 100
    mass, friction = number(random, 20, 300), number(random, 50, 900)
    angle = random.choice((number(random, 3, 177), number(random, 183, 357)))
    going_out = mpf(angle) < 180
    gone = path(radians(mpf(angle)), crank, rod) / (2 * crank)
    share = gone if going_out else 1 - gone
    behind = mpf(pressure) * min(mpf(1), (1 / expansion + clearance) / (share + clearance))
    cover, under = (mpf(bore) ** 2 - mpf(one) ** 2 for one in (tail, thick))
    force = behind * cover - mpf(back) * under if going_out else mpf(back) * cover - behind * under
    force *= pi / 40
    force -= mpf(friction) if going_out else -mpf(friction)
    found = Drive(crank, rod, speed, mpf(mass), slope=mpf(90), gravity=mpf("9.81")).forces(mpf(angle), force)
    words += ["--bore", f"{bore}mm", "--piston-rod", f"{thick}mm", "--tail-rod", f"{tail}mm"]
    words += ["--pressure", f"{pressure}bar", "--back", f"{back}bar", "--eps", mp.nstr(expansion, 6)]
    words += [
        "--clearance",
        mp.nstr(clearance, 6),
        "--reciprocating",
        f"{mass}kg",
        "--friction",
        f"{friction}N",
    ]
    columns = ["guide_force_n", "torque_nm"]
    words += ["--vertical", "--gravity", "9.81", "--columns", ",".join(columns), "--digits", "3"]
    return ["forces", *words, "--angle", angle], [{key: found[key] for key in columns}]


@kind
def rotor(random: Random) -> Asked:
    count = random.randint(1, 5)
    masses, radii = ([number(random, 1, 30) for _ in range(count)] for _ in "mr")
    angles = [str(random.randrange(0, 360, 5)) for _ in range(count)]
    places = [str(random.randrange(0, 1000, 10)) for _ in range(count)]
    left, right = 100, random.randrange(300, 900, 10)
    vectors = [turned(mpf(m) * mpf(r) / 1000, mpf(a)) for m, r, a in zip(masses, radii, angles, strict=True)]
    couple = sum((one * mpf(z) for one, z in zip(vectors, places, strict=True)), mpc(0))
    whole = sum(vectors, mpc(0))
    second = (left * whole - couple) / (right - left)
    found = [polar(one / mpf("0.1"))[0] for one in (-whole - second, second)]
    words = [
        "--masses",
        ";".join(masses) + "kg",
        "--radii",
        ";".join(radii) + "mm",
        "--angles",
        ";".join(angles),
    ]
    words += ["--planes", ";".join(places) + "mm", "--balance-planes", f"{left};{right}mm"]
    rows = [*({} for _ in range(count + 2)), *({"mass_kg": one} for one in found), {}, {}]
    return ["rotor", *words, "--balance-radii", "100mm"], rows


@kind
def in_line(random: Random) -> Asked:
    """Forces and couples of the first two orders, the harmonics by a numerical Fourier integral."""
    count = random.randint(2, 6)
    cranks = [random.randrange(0, 360, 15) for _ in range(count)]
    places = sorted(random.sample(range(-6, 7), count))
    rod, mass = mpf(number(random, 2.5, 6)), number(random, 0.5, 20)
    radius, speed = number(random, 30, 200), number(random, 300, 3000)
    pull = mpf(mass) * mpf(radius) / 1000 * si(f"{speed}/min") ** 2
    middle = mpf(places[0] + places[-1]) / 2
    rows: list[dict[str, mpf]] = []
    for arms in ([mpf(1)] * count, [one - middle for one in places]):
        for order in (1, 2):
            whole = sum(
                (turned(arm, mpf(order * crank)) for arm, crank in zip(arms, cranks, strict=True)), mpc(0)
            )
            size = abs(whole) * harmonic(order, rod) * pull
            rows.append({"greatest_n": size if abs(whole) > mpf("1e-20") else mpf(0)})
    words = ["--cranks", ";".join(map(str, cranks)), "--positions", ";".join(map(str, places))]
    words += ["--reciprocating", f"{mass}kg", "--crank", f"{radius}mm", "--ratio", f"1:{mp.nstr(rod, 10)}"]
    return ["balance", *words, "--speed", f"{speed}/min", "--spacing", "1m"], rows


def harmonic(order: int, rod: mpf) -> mpf:
    """The coefficient of cos kφ in the acceleration of the piston: k² times that of its path."""
    wave = quad(lambda phi: path(phi, mpf(1), rod) * cos(order * phi), [0, pi / 2, pi])
    return -(order**2) * wave * 2 / pi


@kind
def steam(random: Random) -> Asked:
    pressure, back = number(random, 4, 16), number(random, 0.2, 1.5)
    expansion, clearance = number(random, 1.5, 6, 2), number(random, 1, 12, 2)
    bore, stroke = number(random, 150, 600), number(random, 200, 900)
    speed = number(random, 60, 300)
    mean = mean_pressure(mpf(pressure), mpf(back), mpf(expansion), mpf(clearance) / 100)
    volume = swept(mpf(bore) / 1000, mpf(stroke) / 1000)
    power = 2 * mean * 10**5 * volume * turns(si(f"{speed}/min")) / 1000
    words = ["--pressure", f"{pressure}bar", "--back", f"{back}bar", "--eps", expansion]
    words += ["--clearance", f"{clearance}%", "--bore", f"{bore}mm", "--stroke", f"{stroke}mm"]
    return ["power", *words, "--speed", f"{speed}/min"], [{"mean_pressure": mean, "indicated_power": power}]


@kind
def diagram_by_formula(random: Random) -> Asked:
    def wave() -> str:
        terms = [
            f" {random.choice('+-')} {random.randint(100, 900)} {random.choice(('sin', 'cos'))}({order}φ)"
            for order in random.sample(range(1, 5), random.randint(1, 3))
        ]
        return "".join(terms)

    mean, speed, inertia = random.randint(1000, 5000), number(random, 60, 600), number(random, 50, 900)
    drive, load = f"{mean}{wave()}", f"{mean}{wave()}"
    curves = formula(drive), formula(load)
    if drive == load:
        return diagram_by_formula(random)
    swing = swing_of(lambda phi: curves[0](phi) - curves[1](phi))
    words = ["--torque", drive, "--load-torque", load, "--inertia", f"{inertia}kgm2"]
    delta = range_of(mpf(inertia), swing, si(f"{speed}/min"))["delta"]
    return ["flywheel", *words, "--speed", f"{speed}/min"], [{"swing": swing, "delta": delta}]


@kind
def diagram_by_points(random: Random) -> Asked:
    count = random.choice((1, 2, 3))
    inner = sorted(random.sample(range(10, 360 * count, 10), random.randint(1, 8)))
    first = random.randint(0, 2000)
    corners = [(0, first), *((a, random.randint(-500, 3000)) for a in inner), (360 * count, first)]
    text = ";".join(f"{angle}:{torque}" for angle, torque in corners)
    mean, work, swing = swing_of_points(points_of(text))
    speed = number(random, 60, 600)
    if mean <= 0:
        return diagram_by_points(random)
    words = ["--torque", text, "--turns", str(count), "--speed", f"{speed}/min", "--delta", "2%"]
    row = {"swing": swing, "mean_torque": mean, "power": mean * si(f"{speed}/min"), "work": work}
    return ["flywheel", *words], [row]


@kind
def locomotive(random: Random) -> Asked:
    """Two cylinders at any places, their cranks at any angle: balancing masses, hammer blow, forces."""
    spacing, gauge = number(random, 400, 2200), number(random, 1000, 1600)
    crank, at, speed = number(random, 200, 400), number(random, 400, 900), number(random, 100, 400)
    mass, turning = number(random, 80, 400), number(random, 50, 400)
    share, angle = number(random, 0.1, 0.95, 2), random.randrange(60, 121, 5)
    arm, half = mpf(spacing) / 2, mpf(gauge) / 2
    omega2 = si(f"{speed}/min") ** 2
    pins = (mpc(1), turned(mpf(1), mpf(angle)))

    def left_wheel(size: mpf) -> mpc:
        return -size * (pins[0] * (half + arm) + pins[1] * (half - arm)) / (2 * half)

    weight, lifting = mpf(turning) + mpf(share) * mpf(mass), mpf(share) * mpf(mass)
    pull = (1 - mpf(share)) * mpf(mass) * mpf(crank) / 1000 * omega2
    row = {
        "mass_left_kg": abs(left_wheel(weight)) * mpf(crank) / mpf(at),
        "angle_left": polar(left_wheel(weight))[1],
        "blow_left_n": abs(left_wheel(lifting)) * mpf(crank) / 1000 * omega2,
        "pull_n": abs(pins[0] + pins[1]) * pull,
        "sway_nm": abs(pins[0] - pins[1]) * pull * arm / 1000,
    }
    words = ["--spacing", f"{spacing}mm", "--gauge", f"{gauge}mm", "--crank", f"{crank}mm"]
    words += ["--revolving", f"{turning}kg", "--reciprocating", f"{mass}kg", "--share", share]
    words += ["--cranks", f"0;{angle}", "--balance-radius", f"{at}mm", "--speed", f"{speed}/min"]
    return ["locomotive", *words], [row]


@kind
def compressor(random: Random) -> Asked:
    """Work by integrals of the pressure over the volume on both strokes."""
    ratio, exponent = mpf(number(random, 1.5, 9, 2)), mpf(number(random, 1.05, 1.4))
    clearance = mpf(number(random, 1, 8, 2))
    bore, stroke, speed = number(random, 80, 400), number(random, 80, 400), number(random, 100, 600)
    whole, rest = 1 + clearance / 100, clearance / 100
    work = sum(
        turn * quad(lambda v, mass=mass: (mass / v) ** exponent, ends)
        for turn, mass, ends in (
            (1, whole, [whole / ratio ** (1 / exponent), whole]),
            (-1, rest * ratio ** (1 / exponent), [rest, rest * ratio ** (1 / exponent)]),
        )
    )
    work += ratio * (whole / ratio ** (1 / exponent) - rest) - (whole - rest * ratio ** (1 / exponent))
    volume = swept(mpf(bore) / 1000, mpf(stroke) / 1000)
    power = work * volume * turns(si(f"{speed}/min")) * 100
    words = ["--pressure-ratio", mp.nstr(ratio, 6), "--exponent", mp.nstr(exponent, 6), "--single-acting"]
    words += ["--clearance", f"{mp.nstr(clearance, 6)}%", "--suction-pressure", "1bar"]
    words += ["--bore", f"{bore}mm", "--stroke", f"{stroke}mm", "--speed", f"{speed}/min"]
    return ["power", *words], [{"indicated_power": power}]


def assert_digits(name: str, rows: Sequence[dict[str, Any]], expected: Rows) -> None:
    """Assert that the rows print what is expected, to half a unit of the last decimal."""
    assert len(rows) == len(expected), name
    for row, wanted in zip(rows, expected, strict=True):
        for key, value in wanted.items():
            unit = mpf(10) ** row[key].as_tuple().exponent
            assert abs(mpf(str(row[key])) - value) <= unit * mpf("0.500001"), (name, key, row[key], value)


def compare(words: Sequence[str], solve: Callable[[], Rows]) -> None:
    """Assert that a command prints the digits of a solution computed with 30."""
    answered = printed(*words, "-f", "json", KURBEL_LANG="en").out
    rows = json.loads(answered, parse_float=Decimal, parse_int=Decimal)["rows"]
    with mp.workdps(30):
        assert_digits(" ".join(words), rows, solve())


def check(name: str, seed: str) -> None:
    """Draw a problem of a kind and compare."""
    with mp.workdps(30):
        words, rows = KINDS[name](Random(seed))
    compare(words, lambda: rows)


def main() -> None:
    options = argparse.ArgumentParser()
    options.add_argument("--count", type=int, default=100)
    options.add_argument("--seed", default="1")
    given = options.parse_args()
    for name in KINDS:
        for index in range(given.count):
            check(name, f"{given.seed} {index}")
        print(f"{given.count} of {name}: every digit as computed")


if __name__ == "__main__":
    main()
