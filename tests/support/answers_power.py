"""Problems on power: the diagram of pressure over volume, integrated numerically."""

from __future__ import annotations

from mpmath import mpf, pi, quad
from problem_answers import Rows, solution

BAR = mpf(10) ** 5


def mean_pressure(pressure: mpf, back: mpf, expansion: mpf, clearance: mpf | int = 0) -> mpf:
    """Steam admitted up to 1/expansion of the stroke, then expanding by Mariotte's law, over the stroke."""
    cut_off = 1 / expansion
    grown = quad(lambda gone: pressure * (cut_off + clearance) / (gone + clearance), [cut_off, 1])
    return pressure * cut_off + grown - back


def turns(speed: mpf) -> mpf:
    return speed / (2 * pi)


def swept(bore: mpf, stroke: mpf) -> mpf:
    return pi / 4 * bore**2 * stroke


@solution
def mean_pressure_of_steam(pressure: mpf, back: mpf, expansion: mpf) -> Rows:
    return [{"mean_pressure": mean_pressure(pressure, back, expansion) / BAR}]


@solution
def clearance_and_factor(
    pressure: mpf, back: mpf, expansion: mpf, clearance: mpf, factor: mpf, bore: mpf, stroke: mpf, speed: mpf
) -> Rows:
    ideal = mean_pressure(pressure, back, expansion, clearance)
    power = 2 * factor * ideal * swept(bore, stroke) * turns(speed)
    return [
        {
            "theoretical_pressure": ideal / BAR,
            "mean_pressure": factor * ideal / BAR,
            "indicated_power": power / 1000,
        }
    ]


@solution
def cylinder_for_a_power(
    pressure: mpf, back: mpf, expansion: mpf, factor: mpf, power: mpf, shape: mpf, speed: mpf
) -> Rows:
    real = factor * mean_pressure(pressure, back, expansion)
    # power = 2 · real · π/4 · shape · bore³ · turns
    bore = (power / (2 * real * pi / 4 * shape * turns(speed))) ** (mpf(1) / 3)
    return [{"bore": bore * 1000, "stroke": shape * bore * 1000, "mean_pressure": real / BAR}]


@solution
def sizes_by_piston_speed(
    pressure: mpf,
    back: mpf,
    expansion: mpf,
    factor: mpf,
    efficiency: mpf,
    power: mpf,
    velocity: mpf,
    shape: mpf,
) -> Rows:
    real = factor * mean_pressure(pressure, back, expansion)
    inside = power / efficiency
    bore = (inside / (real * velocity * pi / 4)) ** mpf("0.5")
    speed = velocity / (2 * shape * bore)
    return [
        {
            "bore": bore * 1000,
            "stroke": shape * bore * 1000,
            "speed": speed * 60,
            "indicated_power": inside / 1000,
            "mean_torque": power / (2 * pi * speed),
        }
    ]


@solution
def steam_an_hour(
    pressure: mpf, back: mpf, expansion: mpf, bore: mpf, stroke: mpf, speed: mpf, volume: mpf
) -> Rows:
    power = 2 * mean_pressure(pressure, back, expansion) * swept(bore, stroke) * turns(speed)
    steam = 2 * swept(bore, stroke) / expansion * turns(speed) / volume * 3600
    return [{"indicated_power": power / 1000, "steam": steam, "steam_per_kwh": steam / (power / 1000)}]


@solution
def otto_cycle(
    compression: mpf, heat: mpf, suction: mpf, cylinders: mpf, bore: mpf, stroke: mpf, speed: mpf
) -> Rows:
    # A charge of the whole volume at suction pressure has p V = m R T₁; so much times `heat` is supplied.
    whole = swept(bore, stroke) * compression / (compression - 1)
    work = heat * suction * whole * (1 - compression ** mpf("-0.4"))
    return [
        {
            "mean_pressure": work / swept(bore, stroke) / BAR,
            "indicated_power": cylinders * work * turns(speed) / 2 / 1000,
        }
    ]


@solution
def air_compressor(
    ratio: mpf, suction: mpf, exponent: mpf, clearance: mpf, bore: mpf, stroke: mpf, speed: mpf
) -> Rows:
    whole = 1 + clearance
    delivered = whole / ratio ** (1 / exponent)
    expanded = clearance * ratio ** (1 / exponent)
    driven = quad(lambda v: suction * (whole / v) ** exponent, [delivered, whole])
    driven += ratio * suction * (delivered - clearance)
    returned = quad(lambda v: ratio * suction * (clearance / v) ** exponent, [clearance, expanded])
    returned += suction * (whole - expanded)
    work = (driven - returned) * swept(bore, stroke)
    return [
        {
            "indicated_power": work * turns(speed) / 1000,
            "delivery": (whole - expanded) * swept(bore, stroke) * turns(speed) * 60,
        }
    ]


@solution
def power_from_the_mean_pressure(
    pressure: mpf, strokes: mpf, bore: mpf, stroke: mpf, speed: mpf, efficiency: mpf
) -> Rows:
    power = pressure * swept(bore, stroke) * strokes * turns(speed)
    return [
        {
            "indicated_power": power / 1000,
            "brake_power": efficiency * power / 1000,
            "mean_torque": efficiency * power / speed,
        }
    ]
