"""Problems on the connecting rod: point masses that stand in for it, and the bodies of kurbel.verify."""

from __future__ import annotations

from answers_forces import exact, forces, real
from mpmath import mpf, pi
from problem_answers import Rows, solution

from kurbel import verify


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
    there = forces(crank, rod, angle, speed, rod_mass=mass, centre=centre, gyration=gyration)
    found = there("guide_force_n", "crank_pin_force_n", "torque_nm")
    return [dict(zip(("inertia_guide_n", "inertia_pin_n", "inertia_torque_nm"), found.values(), strict=True))]


@solution
def crank_slows_down(crank: mpf, rod: mpf, speed: mpf, slowing: mpf, angle: mpf) -> Rows:
    """x'' ω² + x' α of the slopes by the crank angle."""
    drive = verify.drive(exact(crank / rod))

    def over_time(key: str, slope: str) -> mpf:
        bend, first = (real(drive.value(one, exact(angle))) for one in (key, slope))
        return bend * speed**2 + first * slowing

    return [
        {
            "p_mps2": crank * over_time("p", "c"),
            "rod_acceleration_radps2": over_time("rod_acceleration", "rod_velocity"),
        }
    ]
