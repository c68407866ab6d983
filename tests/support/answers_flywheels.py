"""Problems on flywheels: energies of a wheel at two speeds, and the volume of a rim."""

from __future__ import annotations

from mpmath import mpf, pi, quad, sqrt
from problem_answers import Rows, solution


def per_minute(speed: mpf) -> mpf:
    return speed * 30 / pi


def wheel(swing: mpf, speed: mpf, delta: mpf) -> dict[str, mpf]:
    """The wheel whose energies at both ends of the range around a mean speed differ by the swing."""
    high, low = speed * (1 + delta / 2), speed * (1 - delta / 2)
    inertia = 2 * swing / (high**2 - low**2)
    return {"inertia": inertia, "greatest_speed": per_minute(high), "least_speed": per_minute(low)}


def range_of(inertia: mpf, swing: mpf, speed: mpf) -> dict[str, mpf]:
    """The speeds ω(1 ± δ/2) at which the energies of a wheel differ by the swing."""
    delta = swing / (inertia * speed**2)
    ends = per_minute(speed * (1 + delta / 2)), per_minute(speed * (1 - delta / 2))
    return {"delta": delta, "greatest_speed": ends[0], "least_speed": ends[1]}


@solution
def wheel_from_the_swing(swing: mpf, speed: mpf, delta: mpf, radius: mpf) -> Rows:
    found = wheel(swing, speed, delta)
    return [{**found, "mass": found["inertia"] / radius**2}]


@solution
def speeds_of_a_wheel(mass: mpf, radius: mpf, swing: mpf, speed: mpf) -> Rows:
    return [range_of(mass * radius**2, swing, speed)]


@solution
def coefficient_of_energy(power: mpf, speed: mpf, share: mpf, delta: mpf, radius: mpf) -> Rows:
    swing = share * power * 2 * pi / speed
    return [{"swing": swing, "mass": wheel(swing, speed, delta)["inertia"] / radius**2}]


@solution
def rim_by_hoop_stress(
    swing: mpf, speed: mpf, delta: mpf, stress: mpf, density: mpf, share: mpf, section: mpf
) -> Rows:
    velocity = sqrt(stress / density)
    inertia = wheel(swing, speed, delta)["inertia"]
    radius = velocity / speed
    mass = share * inertia / radius**2
    thickness = sqrt(mass / (2 * pi * radius * density * section))
    found = {"rim_diameter": 2 * radius}
    return [{**found, "rim_mass": mass, "thickness": thickness * 1000, "breadth": section * thickness * 1000}]


@solution
def rim_of_given_diameter(
    power: mpf, speed: mpf, share: mpf, delta: mpf, diameter: mpf, rim: mpf, density: mpf
) -> Rows:
    inertia = wheel(share * power * 2 * pi / speed, speed, delta)["inertia"]
    mass = rim * inertia / (diameter / 2) ** 2
    found = {"rim_mass": mass, "section": mass / (density * pi * diameter) * 10**4}
    return [{**found, "hoop_stress": density * (speed * diameter / 2) ** 2 / 10**6}]


@solution
def punching_press(work: mpf, strokes: mpf, share: mpf, low: mpf, high: mpf, radius: mpf) -> Rows:
    power = work * strokes / (2 * pi)
    inertia = 2 * work * (1 - share) / (high**2 - low**2) * (30 / pi) ** 2
    return [{"power": power, "mass": inertia / radius**2}]


@solution
def one_blow(inertia: mpf, energy: mpf, speed: mpf) -> Rows:
    return [{"least_speed": per_minute(sqrt(speed**2 - 2 * energy / inertia))}]


@solution
def given_rim(swing: mpf, speed: mpf, diameter: mpf, breadth: mpf, thickness: mpf, density: mpf) -> Rows:
    mass = density * breadth * thickness * pi * diameter
    found = range_of(mass * diameter**2 / 4, swing, speed)
    stress = density * (speed * diameter / 2) ** 2 / 10**6
    return [{**found, "rim_mass": mass, "hoop_stress": stress}]


@solution
def holes_in_a_plate(
    hole: str, strength: mpf, strokes: mpf, share: mpf, efficiency: mpf, speed: mpf, diameter: mpf, delta:
    mpf, rim: mpf, density: mpf,
) -> Rows:  # fmt: skip
    wide, thick = (mpf(one) / 1000 for one in hole.replace("mm", "").split(" x "))
    work = strength * pi * wide * thick * thick / 2
    inertia = wheel(work * (1 - share), speed, delta)["inertia"]
    mass = rim * inertia / (diameter / 2) ** 2
    thickness = sqrt(mass / (density * pi * diameter * 2))
    power = work * strokes / (2 * pi) / efficiency
    return [{"motor_power": power, "thickness": thickness * 1000, "breadth": thickness * 2000}]


@solution
def riveting_machine(work: mpf, power: mpf, time: mpf, inertia: mpf, speed: mpf) -> Rows:
    after = sqrt(speed**2 - 2 * (work - power * time) / inertia)
    return [{"least_speed": per_minute(after), "strokes": power / work * 60}]


@solution
def rim_by_shares(
    swing: mpf, speed: mpf, delta: mpf, density: mpf, share: mpf, breadth: mpf, thickness: mpf
) -> Rows:
    # Of a rim with a mean diameter of 1 m: its mass at half of that.
    unit = density * breadth * thickness * pi / 4
    diameter = (share * wheel(swing, speed, delta)["inertia"] / unit) ** mpf("0.2")
    found = {"rim_diameter": diameter, "breadth": breadth * diameter * 1000}
    return [{**found, "thickness": thickness * diameter * 1000, "rim_mass": 4 * unit * diameter**3}]


@solution
def disc_by_its_shape(swing: mpf, speed: mpf, delta: mpf, density: mpf, thickness: mpf) -> Rows:
    mass = density * thickness * pi / 4
    diameter = (wheel(swing, speed, delta)["inertia"] / (mass / 8)) ** mpf("0.2")
    found = {"disc_diameter": diameter}
    return [{**found, "disc_thickness": thickness * diameter * 1000, "mass": mass * diameter**3}]


@solution
def flywheel_runs_up(mass: mpf, radius: mpf, speed: mpf, moment: mpf) -> Rows:
    gain = moment / (mass * radius**2)
    time = speed / gain
    found = {"run_up_time": time, "run_up_turns": quad(lambda t: gain * t, [0, time]) / (2 * pi)}
    found |= {"run_up_acceleration": gain, "run_up_energy": quad(lambda t: moment * gain * t, [0, time])}
    return [{**found, "slip_energy": quad(lambda t: moment * (speed - gain * t), [0, time])}]


@solution
def stress_of_a_disc(
    low: mpf, high: mpf, speed: mpf, delta: mpf, thickness: mpf, density: mpf, poisson: mpf
) -> Rows:
    # A quarter of the turn rising, half of it on top; the mean leaves a quarter of the height above it.
    swing = (high - low) / 4 * (pi + pi / 4 / 2)
    inertia = wheel(swing, speed, delta)["inertia"]
    radius = (2 * inertia / (pi * density * thickness)) ** mpf("0.25")
    # From the edge, free of stress: dσ/dr = -(3 + ν)/4 ρ ω² r, of the radial stress.
    stress = quad(lambda r: (3 + poisson) / 4 * density * speed**2 * r, [0, radius])
    return [{"inertia": inertia, "disc_diameter": 2 * radius, "disc_stress": stress / 10**6}]


@solution
def strips_of_a_press(
    energy: mpf, broad: mpf, thick: mpf, strokes: mpf, speed: mpf, slow: mpf, radius: mpf
) -> Rows:
    inertia = 2 * energy * broad * thick / (speed**2 - slow**2)
    torque = inertia * (speed - slow) * strokes / (2 * pi)
    return [{"mass": inertia / radius**2, "mean_torque": torque}]


@solution
def riveting(
    moment: mpf, turning: mpf, lasts: mpf, strokes: mpf, speed: mpf, delta: mpf, density: mpf
) -> Rows:  # fmt: skip
    work = moment * turning * lasts
    swing = work - work * lasts * strokes / (2 * pi)
    # 90 % of it is of the ring ρ π D (D/10) (D/20) at D/2.
    diameter = (mpf("0.9") * swing / (delta * speed**2) * 800 / (pi * density)) ** mpf("0.2")
    return [{"work": work, "swing": swing, "rim_diameter": diameter, "thickness": diameter * 50}]
