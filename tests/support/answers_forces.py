"""Problems on forces: Newton and Euler, or a triangle where that is all."""

from __future__ import annotations

from mpmath import atan2, cos, degrees, mpf, pi, radians, sqrt
from newton_euler import Drive
from problem_answers import Rows, solution

KEYS = ("rod_force_n", "guide_force_n", "torque_nm")
G = mpf("9.81")


def some(forces: dict[str, mpf], *keys: str) -> Rows:
    return [{key: forces[key] for key in keys}]


@solution
def rod_touches_the_crank_circle(crank: mpf, rod: mpf, force: mpf) -> Rows:
    long = sqrt(rod**2 + crank**2)
    return [
        {
            "phi": degrees(atan2(rod, crank)),
            "rod_force_n": force * long / rod,
            "guide_force_n": force * crank / rod,
            "torque_nm": force * long / rod * crank,
        }
    ]


@solution
def forces_at_an_angle(crank: mpf, rod: mpf, force: mpf, angle: mpf) -> Rows:
    forces = Drive(crank, rod, mpf(1)).forces(angle, force)
    return some(forces, *KEYS, "tangential_force_n", "radial_force_n")


@solution
def masses_in_the_dead_centre(crank: mpf, rod: mpf, speed: mpf, mass: mpf) -> Rows:
    pull = mass * crank * speed**2
    return [{"rod_force_n": -pull * (1 + crank / rod)}, {"rod_force_n": pull * (1 - crank / rod)}]


@solution
def first_order_inertia(crank: mpf, rod: mpf, speed: mpf, mass: mpf, force: mpf, angle: mpf) -> Rows:
    phi = radians(angle)
    towards_the_shaft = crank * speed**2 * (cos(phi) + crank / rod * cos(2 * phi))
    return some(Drive(crank, rod, speed).forces(angle, force - mass * towards_the_shaft), *KEYS)


@solution
def vertical_engine(stroke: mpf, rod: mpf, speed: mpf, mass: mpf, force: mpf, angle: mpf) -> Rows:
    drive = Drive(stroke / 2, rod, speed, mass, slope=mpf(90), gravity=G)
    return some(drive.forces(angle, force), *KEYS)


@solution
def heavy_rod(
    crank: mpf,
    rod: mpf,
    speed: mpf,
    mass: mpf,
    heavy: mpf,
    centre: mpf,
    gyration: mpf,
    force: mpf,
    angle: mpf,
) -> Rows:
    drive = Drive(crank, rod, speed, mass, heavy, centre, gyration)
    return some(drive.forces(angle, force), "guide_force_n", "crank_pin_force_n", "torque_nm")


@solution
def heavy_rod_and_weight(
    crank: mpf,
    rod: mpf,
    speed: mpf,
    mass: mpf,
    heavy: mpf,
    centre: mpf,
    gyration: mpf,
    slope: mpf,
    angle: mpf,
) -> Rows:
    drive = Drive(crank, rod, speed, mass, heavy, centre, gyration, slope, G)
    return some(drive.forces(angle, 0), "guide_force_n", "torque_nm")


@solution
def pressure_on_both_sides(
    stroke: mpf,
    rod: mpf,
    bore: mpf,
    thick: mpf,
    cover: mpf,
    under: mpf,
    mass: mpf,
    speed: mpf,
    friction: mpf,
    angle: mpf,
) -> Rows:
    steam = pi / 4 * (cover * bore**2 - under * (bore**2 - thick**2))
    drive = Drive(stroke / 2, rod, speed, mass, slope=mpf(90), gravity=G)
    forces = drive.forces(angle, steam - friction)
    # A rod without mass: the load at the crosshead is what its thrust has along the slide.
    load = forces["rod_force_n"] * cos(drive.lean(radians(angle)))
    return [{"crosshead_load_n": load, **some(forces, "guide_force_n", "torque_nm")[0]}]


@solution
def petrol_engine(stroke: mpf, rod: mpf, bore: mpf, pressure: mpf, mass: mpf, speed: mpf, angle: mpf) -> Rows:
    crank, phi = stroke / 2, radians(angle)
    towards_the_shaft = crank * speed**2 * (cos(phi) + crank / rod * cos(2 * phi))
    load = pressure * pi / 4 * bore**2 - mass * towards_the_shaft
    return [{"crosshead_load_n": load, **some(Drive(crank, rod, speed).forces(angle, load), *KEYS)[0]}]


@solution
def load_reverses(stroke: mpf, rod: mpf, mass: mpf, force: mpf, angle: mpf) -> Rows:
    drive = Drive(stroke / 2, rod, mpf(1))
    at_one = -drive.acceleration(drive.crosshead, radians(angle))
    speed = sqrt((force + mass * G) / (mass * at_one))
    return [{"speed": speed * 30 / pi}]
