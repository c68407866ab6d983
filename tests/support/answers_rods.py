"""Problems on the connecting rod: point masses that stand in for it; Newton and Euler."""

from __future__ import annotations

from mpmath import asin, cos, diff, mpf, pi, radians, sin, sqrt
from newton_euler import Drive
from problem_answers import Rows, solution


def equivalent(mass: mpf, centre: mpf, apart: mpf) -> dict[str, mpf]:
    """Two masses so far apart, one at the crosshead pin, with the rod's centre of mass."""
    return {
        "crosshead_mass_kg": mass * (apart - centre) / apart,
        "crank_mass_kg": mass * centre / apart,
        "crank_place_mm": apart * 1000,
    }


@solution
def equivalent_masses(rod: mpf, mass: mpf, centre: mpf, gyration: mpf) -> Rows:
    pins = equivalent(mass, centre, rod)
    inertia = pins["crosshead_mass_kg"] * centre**2 + pins["crank_mass_kg"] * (rod - centre) ** 2
    pins["lacking_inertia_kgm2"] = mass * gyration**2 - inertia
    # m₁ a² + m₂ b² = m k² with m₁ a = m₂ b makes a b = k².
    return [pins, equivalent(mass, centre, centre + gyration**2 / centre), {}, {}]


@solution
def rod_as_a_pendulum(rod: mpf, mass: mpf, centre: mpf, time: mpf) -> Rows:
    simple = mpf("9.81") * (time / (2 * pi)) ** 2
    return [equivalent(mass, centre, rod), equivalent(mass, centre, simple), {}, {}]


@solution
def moving_rod(crank: mpf, rod: mpf, speed: mpf, mass: mpf, centre: mpf, gyration: mpf, angle: mpf) -> Rows:
    drive = Drive(crank, rod, speed, rod_mass=mass, centre=centre, gyration=gyration)
    forces = drive.forces(angle, 0)
    return [
        {
            "inertia_guide_n": forces["guide_force_n"],
            "inertia_pin_n": forces["crank_pin_force_n"],
            "inertia_torque_nm": forces["torque_nm"],
        }
    ]


@solution
def crank_slows_down(crank: mpf, rod: mpf, speed: mpf, slowing: mpf, angle: mpf) -> Rows:
    def crank_at(time: mpf) -> mpf:
        return radians(angle) + speed * time + slowing * time**2 / 2

    def lean(time: mpf) -> mpf:
        return asin(crank * sin(crank_at(time)) / rod)

    def gone(time: mpf) -> mpf:
        return -crank * cos(crank_at(time)) - sqrt(rod**2 - (crank * sin(crank_at(time))) ** 2)

    return [{"p_mps2": diff(gone, 0, 2), "rod_acceleration_radps2": diff(lean, 0, 2)}]
