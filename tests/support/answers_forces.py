"""Problems on forces: Newton and Euler as kurbel.verify solves them, or a triangle where that is all."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from mpmath import atan2, cos, degrees, mpf, pi, radians, sign, sin, sqrt
from mpmath.libmp import to_rational
from problem_answers import Rows, solution

from kurbel import verify

KEYS = ("rod_force_n", "guide_force_n", "torque_nm")
G = mpf("9.81")
Forces = Callable[..., dict[str, mpf]]


def exact(value: mpf | int) -> Fraction:
    return Fraction(*map(int, to_rational(mpf(value)._mpf_)))


def real(value: verify.Value) -> mpf:
    """Return a value to more digits than are compared."""
    found = value.near(120)
    return mpf(found.numerator) / found.denominator


def forces(crank: mpf, rod: mpf, angle: mpf, speed: mpf | int = 1, **bodies: mpf | int | None) -> Forces:
    """Return what gives some forces at an angle, by their keys; a length of the rod counts in m."""
    shares = {name: value / rod for name in ("centre", "gyration") if (value := bodies.pop(name, None))}
    numbers = {name: exact(value) for name, value in (bodies | shares).items() if value is not None}
    drive = verify.drive(exact(crank / rod), radius=exact(crank), speed=exact(speed))
    there = verify.bodies(drive, **numbers)

    def some(*keys: str) -> dict[str, mpf]:
        return {key: real(there.value(key, exact(angle))) for key in keys}

    return some


@solution
def rod_touches_the_crank_circle(crank: mpf, rod: mpf, force: mpf) -> Rows:
    long = sqrt(rod**2 + crank**2)
    found = {"phi": degrees(atan2(rod, crank)), "rod_force_n": force * long / rod}
    return [{**found, "guide_force_n": force * crank / rod, "torque_nm": force * long / rod * crank}]


@solution
def forces_at_an_angle(crank: mpf, rod: mpf, force: mpf, angle: mpf) -> Rows:
    return [forces(crank, rod, angle, force=force)(*KEYS, "tangential_force_n", "radial_force_n")]


@solution
def pull_on_the_piston(crank: mpf, rod: mpf, force: mpf, angle: mpf) -> Rows:
    return [forces(crank, rod, angle, force=-force)(*KEYS)]


@solution
def masses_in_the_dead_centre(crank: mpf, rod: mpf, speed: mpf, mass: mpf) -> Rows:
    return [forces(crank, rod, at, speed, reciprocating=mass)("rod_force_n") for at in (0, 180)]


@solution
def first_order_inertia(crank: mpf, rod: mpf, speed: mpf, mass: mpf, force: mpf, angle: mpf) -> Rows:
    return [forces(crank, rod, angle, force=force - mass * to_first_order(crank, rod, speed, angle))(*KEYS)]


def to_first_order(crank: mpf, rod: mpf, speed: mpf, angle: mpf) -> mpf:
    """The acceleration of the piston towards the shaft."""
    phi = radians(angle)
    return crank * speed**2 * (cos(phi) + crank / rod * cos(2 * phi))


@solution
def vertical_engine(stroke: mpf, rod: mpf, speed: mpf, mass: mpf, force: mpf, angle: mpf) -> Rows:
    standing = {"reciprocating": mass, "slope": 90, "gravity": G, "force": force}
    return [forces(stroke / 2, rod, angle, speed, **standing)(*KEYS)]


@solution
def heavy_rod(
    crank: mpf, rod: mpf, speed: mpf, mass: mpf, heavy: mpf, centre: mpf, gyration: mpf, force: mpf,
    angle: mpf,
) -> Rows:  # fmt: skip
    weights = {"reciprocating": mass, "rod_mass": heavy, "centre": centre, "gyration": gyration}
    there = forces(crank, rod, angle, speed, force=force, **weights)
    return [there("guide_force_n", "crank_pin_force_n", "torque_nm")]


@solution
def heavy_rod_and_weight(
    crank: mpf, rod: mpf, speed: mpf, mass: mpf, heavy: mpf, centre: mpf, gyration: mpf, slope: mpf,
    angle: mpf,
) -> Rows:  # fmt: skip
    weights = {"reciprocating": mass, "rod_mass": heavy, "centre": centre, "gyration": gyration}
    there = forces(crank, rod, angle, speed, slope=slope, gravity=G, **weights)
    return [there("guide_force_n", "torque_nm")]


@solution
def pressure_on_both_sides(
    stroke: mpf, rod: mpf, bore: mpf, thick: mpf, cover: mpf, under: mpf, mass: mpf, speed: mpf, friction:
    mpf, angle: mpf,
) -> Rows:  # fmt: skip
    steam = pi / 4 * (cover * bore**2 - under * (bore**2 - thick**2))
    # It is against the motion, which turns back at half a turn.
    force = steam - friction * sign(sin(radians(angle)))
    there = forces(stroke / 2, rod, angle, speed, reciprocating=mass, slope=90, gravity=G, force=force)
    return [there("crosshead_load_n", "guide_force_n", "torque_nm")]


@solution
def petrol_engine(stroke: mpf, rod: mpf, bore: mpf, pressure: mpf, mass: mpf, speed: mpf, angle: mpf) -> Rows:
    gas, inertia = pressure * pi / 4 * bore**2, mass * to_first_order(stroke / 2, rod, speed, angle)
    found = {"crosshead_load_n": gas - inertia, "reversing_speed": speed * sqrt(gas / inertia) * 30 / pi}
    return [{**found, **forces(stroke / 2, rod, angle, force=gas - inertia)(*KEYS)}]


@solution
def load_reverses(stroke: mpf, rod: mpf, mass: mpf, force: mpf, angle: mpf) -> Rows:
    inertia = forces(stroke / 2, rod, angle, reciprocating=mass)("inertia_force_n")["inertia_force_n"]
    return [{"speed": sqrt((force + mass * G) / -inertia) * 30 / pi}]
