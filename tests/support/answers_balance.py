"""Problems on balance: masses as complex vectors, forces of cylinders sampled over a turn."""

from __future__ import annotations

from collections.abc import Sequence

from mpmath import acos, arg, cos, degrees, exp, mpc, mpf, pi, radians, sin
from problem_answers import Rows, solution


def turned(length: mpf, angle: mpf) -> mpc:
    return length * exp(1j * radians(angle))


def polar(vector: mpc) -> tuple[mpf, mpf]:
    return abs(vector), degrees(arg(vector)) % 360


@solution
def static_balance(masses: Sequence[mpf], radii: Sequence[mpf], angles: Sequence[mpf], at: mpf) -> Rows:
    left = sum(turned(m * r, a) for m, r, a in zip(masses, radii, angles, strict=True))
    mass, angle = polar(-left / at)
    return [{"mass_kg": mass, "angle": angle}, *({} for _ in masses), {"unbalance_kgm": 0}]


@solution
def balance_in_two_planes(
    masses: Sequence[mpf], radii: Sequence[mpf], angles: Sequence[mpf], planes: Sequence[mpf], balance:
    Sequence[mpf], at: mpf,
) -> Rows:  # fmt: skip
    vectors = [turned(m * r / 1000, a) for m, r, a in zip(masses, radii, angles, strict=True)]
    couple = sum(vector * plane for vector, plane in zip(vectors, planes, strict=True))
    first, second = balance
    # first + second = −force, first · z₁ + second · z₂ = −couple
    right = (first * sum(vectors) - couple) / (second - first)
    left = -sum(vectors) - right
    found = [dict(zip(("mass_kg", "angle"), polar(one / at), strict=True)) for one in (left, right)]
    return [*({} for _ in masses), {}, {}, *found, {"unbalance_kgm": 0}, {"moment_kgm2": 0}]


@solution
def complete_balance(masses: Sequence[mpf], radii: mpf, planes: Sequence[mpf]) -> Rows:
    two, three, four = (m * z for m, z in zip(masses, planes[1:], strict=True))
    apart = degrees(acos((four**2 - two**2 - three**2) / (2 * two * three)))
    solved = []
    for third in (360 - apart, apart):
        fourth = polar(-two - turned(three, third))[1]
        rest = masses[0] + turned(masses[1], third) + turned(masses[2], fourth)
        mass, first = polar(-rest)
        rows = [{"mass_kg": mass, "angle": first}, {"angle": 0}, {"angle": third}, {"angle": fourth}]
        solved += [*rows, {"unbalance_kgm": 0}, {"moment_kgm2": 0}]
    return solved


@solution
def inner_cranks(
    mass: mpf, crank: mpf, apart: mpf, planes: Sequence[mpf], ratio: mpf, speed: mpf
) -> Rows:  # fmt: skip
    outer = [turned(mass, mpf(0)), turned(mass, apart)]
    first, second, third, last = (plane / 1000 for plane in planes)
    right = -(outer[0] * (first - second) + outer[1] * (last - second)) / (third - second)
    cranks = [outer[0], -sum(outer) - right, right, outer[1]]
    doubled = [one**2 / abs(one) * ratio * crank * speed**2 for one in cranks]
    arms = (first, second, third, last)
    couple, angle = polar(sum(one * arm for one, arm in zip(doubled, arms, strict=True)))
    force = {"unbalance_n": abs(sum(doubled))}
    rows = [dict(zip(("mass_kg", "angle"), polar(one), strict=True)) for one in cranks]
    return [*rows, {"unbalance_n": 0}, {"moment_nm": 0}, force, {"moment_nm": couple, "angle": angle}]


@solution
def five_cranks(mass: mpf, crank: mpf, ratio: mpf, speed: mpf, spacing: mpf) -> Rows:
    rows = []
    for levers in ((1, 1, 1, 1, 1), (-2, -1, 0, 1, 2)):
        for order, share in ((1, mpf(1)), (2, ratio)):
            angles = (0, 144, 288, 72, 216)
            whole = sum(turned(mpf(z), mpf(order * a)) for z, a in zip(levers, angles, strict=True))
            arm = 1 if levers[0] == 1 else spacing
            force = abs(whole) * share * mass * crank * speed**2 * arm
            rows.append({"greatest_n": 0 if levers[0] == 1 else force})
    return rows


def resultants(banks: Sequence[mpf], order: int) -> list[mpf]:
    """How large the sum of cos(k(φ − β)) along the cylinders' directions β is, over a turn."""
    sizes = []
    for step in range(72):
        phi = 2 * pi * step / 72
        along = [cos(order * (phi - radians(bank))) for bank in banks]
        x = sum(one * cos(radians(bank)) for one, bank in zip(along, banks, strict=True))
        y = sum(one * sin(radians(bank)) for one, bank in zip(along, banks, strict=True))
        sizes.append((x**2 + y**2) ** mpf("0.5"))
    return sizes


@solution
def v_twin(half: mpf, mass: mpf, stroke: mpf, ratio: mpf, speed: mpf) -> Rows:
    unit = mass * stroke / 2 * speed**2
    first, second = (resultants((-half, half), order) for order in (1, 2))
    once = {"greatest_n": max(first) * unit, "least_n": min(first) * unit}
    return [once, {"greatest_n": max(second) * unit * ratio}, {"greatest_n": 0}, {"greatest_n": 0}]


@solution
def radial_three(mass: mpf, stroke: mpf, ratio: mpf, speed: mpf) -> Rows:
    unit = mass * stroke / 2 * speed**2
    first, second = (resultants((mpf(0), mpf(120), mpf(240)), order) for order in (1, 2))
    return [
        {"greatest_n": max(first) * unit, "least_n": min(first) * unit},
        {"greatest_n": max(second) * unit * ratio, "least_n": min(second) * unit * ratio},
        {"greatest_n": 0},
        {"greatest_n": 0},
    ]


@solution
def partly_balanced_cylinder(
    mass: mpf, turning: mpf, share: mpf, crank: mpf, speed: mpf, at: mpf, angle: mpf
) -> Rows:
    """The counterweight itself, at its radius, stands opposite the crank."""
    counterweight = (turning + share * mass) * crank / at
    phi = radians(angle)
    along = (mass + turning) * crank * cos(phi) - counterweight * at * cos(phi)
    across = turning * crank * sin(phi) - counterweight * at * sin(phi)
    force = abs(mpc(along, across)) * speed**2
    return [{"magnitude_n": force}, {}, {"magnitude_n": force}, {}, {}, {}]


def wheels_of(spacing: mpf, gauge: mpf, mass: mpf) -> tuple[mpc, mpc]:
    """The masses at the crank radius in the planes of the wheels that balance two cranks at 90°."""
    first, second = mpc(mass), mpc(0, mass)
    left = -(first * (gauge + spacing) / 2 + second * (gauge - spacing) / 2) / gauge
    return left, -first - second - left


@solution
def inside_cylinders(
    crank: mpf, spacing: mpf, gauge: mpf, turning: mpf, mass: mpf, share: mpf, at: mpf, speed: mpf
) -> Rows:
    left, right = wheels_of(spacing, gauge, turning + share * mass)
    lifting = abs(wheels_of(spacing, gauge, share * mass)[0])
    pull = (1 - share) * mass * crank * speed**2
    # The cylinders pull with cos φ and cos(φ + 90°), each at its own side of the middle.
    both = [(cos(pi * step / 180), -sin(pi * step / 180)) for step in range(360)]
    most, sway = (max(abs(one + sign * other) for one, other in both) * pull for sign in (1, -1))
    masses = {"mass_left_kg": abs(left) * crank / at, "mass_right_kg": abs(right) * crank / at}
    forces = {"blow_left_n": lifting * crank * speed**2, "pull_n": most, "sway_nm": sway * spacing / 2}
    return [{**masses, "angle_left": polar(left)[1], "angle_right": polar(right)[1], **forces}]


@solution
def wheels_lift(
    crank: mpf, spacing: mpf, gauge: mpf, turning: mpf, mass: mpf, share: mpf, at: mpf, wheel: mpf, load: mpf
) -> Rows:
    lifting = abs(wheels_of(spacing, gauge, share * mass)[0]) * crank
    speed = (load / lifting) ** mpf("0.5")
    weight = abs(wheels_of(spacing, gauge, turning + share * mass)[0]) * crank / at
    found = {"mass_left_kg": weight}
    return [{**found, "lift_speed": speed * 30 / pi, "lift_velocity_kmh": speed * wheel / 2 * mpf("3.6")}]


@solution
def share_by_the_hammer_blow(
    crank: mpf, spacing: mpf, gauge: mpf, mass: mpf, share: mpf, wheel: mpf, velocity: mpf, blow: mpf
) -> Rows:
    speed = velocity / (wheel / 2)
    one = abs(wheels_of(spacing, gauge, mass)[0]) * crank * speed**2
    # At 45° both cranks pull together, or apart.
    pull = (1 - share) * mass * crank * speed**2 * mpf(2) ** mpf("0.5")
    sway = pull * spacing / 2
    return [{"share_most": blow / one, "blow_left_n": share * one, "pull_n": pull, "sway_nm": sway}]
