"""Problems on turning-moment diagrams: the energy between the roots of the excess torque, numerically."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from itertools import accumulate, pairwise

from answers_flywheels import range_of, rim_by_hoop_stress, wheel
from mpmath import cos, findroot, mpf, pi, quad, radians, sin
from problem_answers import Rows, solution

Torque = Callable[[mpf], mpf]
Points = Sequence[tuple[mpf, mpf]]


def formula(text: str) -> Torque:
    """A sum such as 500 + 200 sin(2φ) − 90 cos(3φ) as a function of φ in radians."""
    found = re.findall(r"([+-]?)\s*(\d+)(?:\s*(sin|cos)\((\d*)φ\))?", text)
    assert found, text
    waves: dict[str, Torque] = {"sin": sin, "cos": cos, "": lambda _: mpf(1)}
    terms = [
        (mpf(f"{sign}{size}"), waves[function], int(order or 1)) for sign, size, function, order in found
    ]

    def torque(phi: mpf) -> mpf:
        return sum((size * wave(order * phi) for size, wave, order in terms), mpf(0))

    return torque


def swing_of(excess: Torque) -> mpf:
    """How far the integral of an excess torque varies over a turn, by its roots."""
    steps = [2 * pi * step / 120 + mpf("1e-9") for step in range(121)]
    signs = [excess(step) > 0 for step in steps]
    roots = [
        findroot(excess, ends, solver="anderson")
        for ends, (before, after) in zip(pairwise(steps), pairwise(signs), strict=True)
        if before != after
    ]
    energies = list(accumulate((quad(excess, list(ends)) for ends in pairwise(roots)), initial=mpf(0)))
    return max(energies) - min(energies)


def swing_of_points(points: Points) -> tuple[mpf, mpf, mpf]:
    """Return mean torque, work and energy swing of a diagram of straight lines, with a trapezium a line."""
    radian = radians(mpf(1))
    work = sum((after - before) * (m + n) / 2 for (before, m), (after, n) in pairwise(points))
    mean = work / (points[-1][0] - points[0][0])
    energy, energies = mpf(0), [mpf(0)]
    for (before, m), (after, n) in pairwise(points):
        if (m - mean) * (n - mean) < 0:
            crossing = before + (mean - m) / (n - m) * (after - before)
            energies.append(energy + (crossing - before) * (m - mean) / 2)
        energy += (after - before) * ((m + n) / 2 - mean)
        energies.append(energy)
    return mean, work * radian, (max(energies) - min(energies)) * radian


def points_of(text: str) -> Points:
    pairs = (point.split(":") for point in text.split(";"))
    return [(mpf(angle), mpf(torque)) for angle, torque in pairs]


@solution
def areas_of_a_diagram(areas: str, scale: str, speed: mpf, delta: mpf, radius: mpf) -> Rows:
    torque, angle = re.findall(r"\d+", scale)
    sums = list(accumulate((mpf(area) for area in areas.split(";")), initial=mpf(0)))
    swing = (max(sums) - min(sums)) * mpf(torque) * radians(mpf(angle))
    return [{"swing": swing, "mass": wheel(swing, speed, delta)["inertia"] / radius**2}]


@solution
def torque_by_a_formula(torque: str, speed: mpf, delta: mpf) -> Rows:
    curve = formula(torque)
    mean = quad(curve, [0, pi, 2 * pi]) / (2 * pi)
    swing = swing_of(lambda phi: curve(phi) - mean)
    inertia = wheel(swing, speed, delta)["inertia"]
    return [{"power": mean * speed, "swing": swing, "inertia": inertia}]


@solution
def load_that_varies(torque: str, load: str, inertia: mpf, speed: mpf) -> Rows:
    drive, driven = formula(torque), formula(load)
    swing = swing_of(lambda phi: drive(phi) - driven(phi))
    return [{"swing": swing, "delta": range_of(inertia, swing, speed)["delta"]}]


@solution
def two_triangles(points: str, speed: mpf, delta: mpf, radius: mpf) -> Rows:
    _, work, swing = swing_of_points(points_of(points))
    mass = wheel(swing, speed, delta)["inertia"] / radius**2
    return [{"energy_fluctuation": swing / work, "swing": swing, "mass": mass}]


@solution
def three_cranks(points: str, speed: mpf, mass: mpf, radius: mpf) -> Rows:
    one = points_of(points)

    def at(angle: int) -> mpf:
        place = mpf(angle % 360)
        for (before, m), (after, n) in pairwise(one):
            if before <= place <= after:
                return m + (n - m) * (place - before) / (after - before)
        raise AssertionError(angle)

    # Every corner of the three lies at a multiple of 60°.
    whole = [(mpf(a), at(a) + at(a - 120) + at(a - 240)) for a in range(0, 361, 60)]
    mean, _, swing = swing_of_points(whole)
    delta = range_of(mass * radius**2, swing, speed)["delta"]
    return [{"power": mean * speed, "swing": swing, "delta": delta}]


@solution
def load_over_three_turns(points: str, speed: mpf, mass: mpf, radius: mpf) -> Rows:
    mean, _, swing = swing_of_points(points_of(points))
    return [{"power": mean * speed, **range_of(mass * radius**2, swing, speed)}]


@solution
def four_strokes(areas: str, scale: mpf, speed: mpf, delta: mpf) -> Rows:
    works = [mpf(area) * scale for area in areas.split(";")]
    mean = sum(works) / (4 * pi)
    peak = 2 * works[2] / pi
    # The part above the line has the height peak − mean, and a width in the same ratio.
    swing = works[2] * ((peak - mean) / peak) ** 2
    inertia = wheel(swing, speed, delta)["inertia"]
    return [{"mean_torque": mean, "power": mean * speed, "swing": swing, "inertia": inertia}]


@solution
def acceleration_of_the_shaft(torque: str, load: str, inertia: mpf, speed: mpf, angle: mpf) -> Rows:
    excess = formula(torque)(radians(angle)) - formula(load)(radians(angle))
    assert speed > 0
    return [{"excess_torque": excess, "angular_acceleration": excess / inertia}]


@solution
def rim_of_a_gas_engine(
    tips: str, unit: mpf, speed: mpf, delta: mpf, stress: mpf, density: mpf, section: mpf
) -> Rows:
    [found] = four_strokes(tips, unit, speed, delta)
    [rim] = rim_by_hoop_stress(found["swing"], speed, delta, stress, density, mpf(1), section)
    return [{**rim, "inertia": found["inertia"]}]
