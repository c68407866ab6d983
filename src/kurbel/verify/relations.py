"""Quantities bound by products of powers, all of those found that follow from others.

A law 1 = c Π x^a is linear in the logarithms, so unknown quantities are eliminated as from linear equations.
Units are those of the SI, and turns a second.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import NamedTuple

from kurbel.verify.numbers import Number, number, pi

# The indicated power of so many working strokes in a turn, of all cylinders.
ENGINE = """
    indicated_power = strokes mean_pressure swept_volume speed;
    swept_volume = 1/4 pi open bore^2 stroke;
    piston_speed = 2 stroke speed; stroke = bore stroke_bore;
    theoretical_pressure = relative_pressure pressure; stroke_work = mean_pressure swept_volume;
    mean_pressure = theoretical_pressure diagram_factor;
    brake_power = indicated_power at_shaft; brake_pressure = mean_pressure at_shaft;
    brake_power = 2 pi speed mean_torque; steam = taken strokes swept_volume speed specific_volume^-1;
    steam = steam_per indicated_power; steam = steam_per_brake brake_power;
    receiver_pressure = pressure high_expansion^-1; high_bore = bore low_cut_off^1/2;
    high_power = indicated_power high_share; low_power = indicated_power low_share;
    high_mean_pressure = mean_pressure high_share low_cut_off^-1; low_mean_pressure = mean_pressure low_share;
    indicated_power = consumption heating_value indicated_thermal;
    brake_power = consumption heating_value brake_thermal; consumption = consumption_per indicated_power;
    consumption = consumption_per_brake brake_power; air_mass = delivery density;
    indicated_power = air_mass work_per_mass; delivery = delivered strokes swept_volume speed;
    free_delivery = delivery freed; free_efficiency = delivered freed;
    delivered = volumetric_efficiency inlet; end_temperature = suction_temperature heated;
    delivered_volume = swept_volume delivered heated ratio^-1;
    isothermal_power = isothermal pressure delivery;
    isothermal_efficiency = isothermal pressure delivered mean_pressure^-1;
    adiabatic_efficiency = adiabatic pressure delivered mean_pressure^-1;
    compression_heat = compressed_heat pressure delivery; cooler_heat = cooled_heat pressure delivery;
    intermediate_pressure = stage_ratio pressure; second_bore = bore second_area^1/2"""
# Cycles a second of so many turns; a thin rim of mean diameter D, or a solid disc.
FLYWHEEL = """
    swing = inertia omega^2 delta; inertia = mass radius^2; stored = 1/2 inertia omega^2;
    swing = energy_fluctuation work; swing = swing_share mean_torque; power = work cycles;
    power = motor_power efficiency; power = mean_torque omega; omega = 2 pi cycles turns; omega = 2 pi speed;
    omega_max = omega above; omega_min = omega below; drop = omega delta; 1 = delta steadiness;
    rim_speed = 1/2 omega rim_diameter; hoop_stress = density rim_speed^2; section = breadth thickness;
    rim_mass = pi rim_diameter density section; breadth = proportion thickness;
    breadth = breadth_share rim_diameter; thickness = thickness_share rim_diameter;
    rim_inertia = 1/4 rim_mass rim_diameter^2; rim_inertia = inertia rim_share"""
DISC = """
    inertia = 1/8 mass disc_diameter^2; mass = 1/4 pi density disc_diameter^2 disc_thickness;
    disc_thickness = disc_share disc_diameter;
    disc_stress = 1/4 disc_bulge density omega^2 disc_diameter^2"""


# The exponent of air without heat.
AIR = Fraction(7, 5)


def staged(
    ratio: Number, exponent: Fraction, stages: int, between: Number | None, cooled: Fraction, apart: Fraction,
    room: Fraction,
) -> dict[str, Number]:  # fmt: skip
    """What the stages of a compressor take, by air of volume and pressure 1 at suction that is cooled between
    them to so many times its first temperature. The pressures in a cylinder are `apart` times as far apart as
    outside; `between` is the first stage's ratio, else that of all alike.

    The work of a stage is n/(n - 1) V (Π^((n - 1)/n) - 1), or V log Π; the heat of compression that less what
    warms the air, and that of a cooler what cools it, both by c_p/R = γ/(γ - 1).
    """
    first = ratio.power(Fraction(1, stages)) if between is None else between
    last = first if between is None else ratio / between

    def work(times: Number, power: Fraction) -> Number:
        return times.log() if power == 1 else (times.power(1 - 1 / power) - 1) / (1 - 1 / power)

    def all_stages(one: Number, other: Number, warm: Fraction) -> Number:
        return work(one * apart, exponent) + work(other * apart, exponent) * (warm * (stages - 1))

    alike = ratio.power(Fraction(1, stages))
    whole, best = all_stages(first, last, cooled), all_stages(alike, alike, Fraction(1))
    single, hot = work(ratio * apart, exponent), (first * apart).power(1 - 1 / exponent)
    sucked, later = (1 + room - (one * apart).power(1 / exponent) * room for one in (first, last))
    return {
        "ratio": ratio, "whole_work": whole, "volumetric_efficiency": sucked, "stage_ratio": first,
        "against_one_stage": whole / single, "against_perfect": whole / best,
        "perfect_against_one": best / single, "isothermal": ratio.log(), "adiabatic": work(ratio, AIR),
        "heated": (last * apart).power(1 - 1 / exponent) * (cooled if stages > 1 else 1),
        "compressed_heat": work(first * apart, exponent) - (hot - 1) / (1 - 1 / AIR),
        "cooled_heat": (hot - cooled) / (1 - 1 / AIR), "second_area": cooled * sucked / (later * first),
    }  # fmt: skip


class Law(NamedTuple):
    """What is 1: a factor times powers of quantities."""

    factor: Number
    powers: Mapping[str, Fraction]

    def put(self, name: str, value: Law) -> Law:
        """The same with a quantity said by others."""
        if name not in self.powers:
            return self
        power = self.powers[name]
        powers = dict(self.powers)
        for other, own in (*value.powers.items(), (name, Fraction(-1))):
            powers[other] = powers.get(other, Fraction(0)) + own * power
        return Law(self.factor * value.factor.power(power), {key: own for key, own in powers.items() if own})


def laws(text: str) -> Iterator[Law]:
    for line in text.split(";"):
        left, _, right = line.partition("=")
        found = Law(number(1), {})
        for word, sign in (*((one, 1) for one in right.split()), (left.strip(), -1)):
            name, _, power = word.partition("^")
            if name[0].isdigit() or name == "pi":
                times = pi() if name == "pi" else number(name)
                found = found._replace(factor=found.factor * times.power(Fraction(sign)))
            else:
                found = found._replace(powers={**found.powers, name: Fraction(power or 1) * sign})
        yield found


def completed(known: Mapping[str, Number], text: str) -> dict[str, Number]:
    """Return what is known with what follows; positive numbers."""
    rows, found, said = list(laws(text)), dict(known), dict[str, Law]()
    for name, value in known.items():
        rows = [one.put(name, Law(value, {})) for one in rows]
    while rows := [one for one in rows if one.powers]:
        row = min(rows, key=lambda one: len(one.powers))
        name, power = next(iter(row.powers.items()))
        rest = {other: -one / power for other, one in row.powers.items() if other != name}
        said[name] = Law(row.factor.power(-1 / power), rest)
        rows = [one.put(name, said[name]) for one in rows if one is not row]
    # Those that were said last are said by the fewest others.
    for name, own in reversed(said.items()):
        if own.powers.keys() <= found.keys():
            for other in own.powers:
                own = own.put(other, Law(found[other], {}))
            found[name] = own.factor
    return found


def flywheel(known: Mapping[str, Number]) -> dict[str, Number]:
    """Return what follows of a flywheel, with δ = (ω_max - ω_min)/ω and ω their mean."""
    text = FLYWHEEL + (f";{DISC}" if any(name.startswith("disc") for name in known) else "")
    found, before = dict(known), 0
    while len(found) > before:
        before, found = len(found), completed(found, text)
        high, low, mean, delta, inertia, swing = map(
            found.get, ("omega_max", "omega_min", "omega", "delta", "inertia", "swing")
        )
        if delta is not None:
            found["above"], found["below"] = 1 + delta / 2, 1 - delta / 2
        elif high is not None and low is not None:
            found["omega"] = (high + low) / 2
            found["delta"] = (high - low) / found["omega"]
        elif mean is not None and high is not None:
            found["delta"] = 2 * (high - mean) / mean
        elif mean is not None and low is not None:
            found["delta"] = 2 * (mean - low) / mean
        elif inertia is not None and swing is not None and high is not None:
            found["omega_min"] = (high * high - 2 * swing / inertia).root()
        elif inertia is not None and swing is not None and low is not None:
            found["omega_max"] = (low * low + 2 * swing / inertia).root()
    return found
