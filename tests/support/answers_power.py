"""Problems on power: the diagram of pressure over volume, integrated numerically."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from mpmath import diff, findroot, log, mpf, pi, quad, sqrt
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


def sizes(volume: mpf, shape: mpf) -> dict[str, mpf]:
    """The cylinder of a swept volume whose stroke is so many bores."""
    bore = (volume / (pi / 4 * shape)) ** (mpf(1) / 3)
    return {"bore": bore * 1000, "stroke": shape * bore * 1000}


@solution
def mean_pressure_of_steam(pressure: mpf, back: mpf, expansion: mpf) -> Rows:
    return [{"mean_pressure": mean_pressure(pressure, back, expansion) / BAR}]


@solution
def clearance_and_factor(
    pressure: mpf, back: mpf, expansion: mpf, clearance: mpf, factor: mpf, bore: mpf, stroke: mpf, speed: mpf
) -> Rows:
    ideal = mean_pressure(pressure, back, expansion, clearance)
    power = 2 * factor * ideal * swept(bore, stroke) * turns(speed) / 1000
    mean = {"theoretical_pressure": ideal / BAR, "mean_pressure": factor * ideal / BAR}
    return [{**mean, "indicated_power": power}]


@solution
def cylinder_for_a_power(
    pressure: mpf, back: mpf, expansion: mpf, factor: mpf, power: mpf, shape: mpf, speed: mpf
) -> Rows:
    real = factor * mean_pressure(pressure, back, expansion)
    return [{**sizes(power / (2 * real * turns(speed)), shape), "mean_pressure": real / BAR}]


@solution
def sizes_by_piston_speed(
    pressure: mpf, back: mpf, expansion: mpf, factor: mpf, efficiency: mpf, power: mpf, velocity: mpf,
    shape: mpf,
) -> Rows:  # fmt: skip
    real = factor * mean_pressure(pressure, back, expansion)
    inside = power / efficiency
    bore = (inside / (real * velocity * pi / 4)) ** mpf("0.5")
    speed = velocity / (2 * shape * bore)
    sized = {"bore": bore * 1000, "stroke": shape * bore * 1000, "speed": speed * 60}
    return [{**sized, "indicated_power": inside / 1000, "mean_torque": power / (2 * pi * speed)}]


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
    power = cylinders * work * turns(speed) / 2 / 1000
    return [{"mean_pressure": work / swept(bore, stroke) / BAR, "indicated_power": power}]


@solution
def air_compressor(
    ratio: mpf, suction: mpf, exponent: mpf, clearance: mpf, bore: mpf, stroke: mpf, speed: mpf
) -> Rows:
    return compressor_by_its_volume(ratio, suction, exponent, clearance, swept(bore, stroke) / 2, speed)


@solution
def power_from_the_mean_pressure(
    pressure: mpf, strokes: mpf, bore: mpf, stroke: mpf, speed: mpf, efficiency: mpf
) -> Rows:
    power = pressure * swept(bore, stroke) * strokes * turns(speed)
    shaft = {"brake_power": efficiency * power / 1000, "mean_torque": efficiency * power / speed}
    return [{"indicated_power": power / 1000, **shaft}]


def bisected(function: Callable[[mpf], mpf], low: mpf, high: mpf) -> mpf:
    """The zero between two places at which a function has unlike signs."""
    falls = function(low) > 0
    for _ in range(110):
        middle = (low + high) / 2
        low, high = (middle, high) if (function(middle) > 0) == falls else (low, middle)
    return low


@solution
def cut_off_for_a_power(
    pressure: mpf, back: mpf, factor: mpf, bore: mpf, stroke: mpf, speed: mpf, power: mpf
) -> Rows:
    wanted = power / (2 * factor * swept(bore, stroke) * turns(speed)) + back

    def lacking(share: mpf) -> mpf:
        # The antiderivative of p share/x: without clearance the logarithm.
        return pressure * share * (1 - log(share)) - wanted

    return [{"cut_off": bisected(lacking, mpf("0.001"), mpf(1)), "indicated_power": power / 1000}]


@solution
def steam_pressure_for_a_power(
    expansion: mpf, back: mpf, clearance: mpf, bore: mpf, stroke: mpf, speed: mpf, power: mpf
) -> Rows:
    whole = mean_pressure(mpf(1), mpf(0), expansion, clearance)
    wanted = power / (2 * swept(bore, stroke) * turns(speed))
    return [{"steam_pressure": (wanted + back) / whole / BAR, "mean_pressure": wanted / BAR}]


def compressor_work(ratio: mpf, exponent: mpf, clearance: mpf) -> mpf:
    """Work of the swept volume 1 at suction pressure 1: of the polytrope, p^(-1/n) over the pressure."""
    part = 1 - 1 / exponent
    return (1 + clearance - clearance * ratio ** (1 / exponent)) * (ratio**part - 1) / part


@solution
def compressor_for_a_delivery(
    ratio: mpf, suction: mpf, exponent: mpf, clearance: mpf, delivery: mpf, shape: mpf, speed: mpf,
    efficiency: mpf,
) -> Rows:  # fmt: skip
    sucked = 1 + clearance - clearance * ratio ** (1 / exponent)
    volume = delivery / turns(speed) / sucked
    power = suction * volume * compressor_work(ratio, exponent, clearance) * turns(speed) / 1000
    return [{**sizes(volume, shape), "indicated_power": power, "brake_power": power / efficiency}]


@solution
def pressure_ratio_for_a_power(
    suction: mpf, exponent: mpf, clearance: mpf, bore: mpf, stroke: mpf, speed: mpf, power: mpf
) -> Rows:
    wanted = power / (swept(bore, stroke) * turns(speed) * suction)

    def apart(ratio: mpf) -> mpf:
        return compressor_work(ratio, exponent, clearance) - wanted

    most = ((1 + clearance) / clearance) ** exponent
    top = findroot(lambda at: diff(apart, at), (mpf(2) + most) / 4)
    return [{"pressure_ratio": bisected(apart, *ends)} for ends in ((mpf(1), top), (top, most))]


@solution
def diagram_factor_of_cards(
    expansion: mpf, pressure: mpf, back: mpf, cards: Sequence[mpf], bore: mpf, stroke: mpf, speed: mpf
) -> Rows:
    mean = sum(cards) / 2
    power = 2 * mean * swept(bore, stroke) * turns(speed) / 1000
    return [{"diagram_factor": mean / mean_pressure(pressure, back, expansion), "indicated_power": power}]


@solution
def cushioned_steam(
    pressure: mpf, back: mpf, expansion: mpf, clearance: mpf, release: mpf, cushion: mpf, lead: mpf,
    factor: mpf, bore: mpf, stroke: mpf, speed: mpf,
) -> Rows:  # fmt: skip
    cut_off, closed = 1 / expansion, 1 - cushion + clearance

    def expanded(gone: mpf) -> mpf:
        return pressure * (cut_off + clearance) / (gone + clearance)

    def compressed(left: mpf) -> mpf:
        return back * closed / (left + clearance)

    # Where a port has opened, the mean of both ends.
    driving = pressure * cut_off + quad(expanded, [cut_off, release])
    driving += (1 - release) * (expanded(release) + back) / 2
    resisting = back * cushion + quad(compressed, [lead, 1 - cushion])
    resisting += lead * (compressed(lead) + pressure) / 2
    mean = factor * (driving - resisting)
    power = 2 * mean * swept(bore, stroke) * turns(speed)
    return [{"mean_pressure": mean / BAR, "indicated_power": power / 1000}]


def raised(low: mpf, high: mpf, exponent: mpf) -> mpf:
    """Work on what fills the volume 1 at the lower pressure: the volume over the pressure."""
    return quad(lambda at: (low / at) ** (1 / exponent), [low, high])


@solution
def drive_of_a_compressor(
    ratio: mpf, suction: mpf, exponent: mpf, delivery: mpf, shape: mpf, speed: mpf, efficiency: mpf
) -> Rows:
    work, least = raised(suction, ratio * suction, exponent), raised(suction, ratio * suction, mpf(1))
    adiabatic = raised(suction, ratio * suction, mpf("1.4"))
    power = {"brake_power": work * delivery / efficiency / 1000}
    against = {"isothermal_efficiency": least / work, "adiabatic_efficiency": adiabatic / work}
    return [{**sizes(delivery / turns(speed), shape), **against, **power}]


@solution
def free_air(
    ratio: mpf, suction: mpf, warm: mpf, free: mpf, cold: mpf, exponent: mpf, clearance: mpf, bore: mpf,
    stroke: mpf, speed: mpf,
) -> Rows:  # fmt: skip
    room = clearance * swept(bore, stroke)
    sucked = swept(bore, stroke) + room - room * ratio ** (1 / exponent)
    # In units of R: the mass of a stroke, and its volume as free air.
    mass = suction * sucked / warm
    volume, whole = mass * cold / free, swept(bore, stroke)
    hot = suction * ratio * (1 / ratio) ** (1 / exponent) / (suction / warm)
    shares = {"volumetric_efficiency": sucked / whole, "free_efficiency": volume / whole}
    return [{**shares, "free_delivery": 2 * volume * turns(speed) * 60, "end_temperature": hot}]


@solution
def two_stages(
    ratio: mpf, suction: mpf, exponent: mpf, clearance: mpf, own: mpf, delivery: mpf, shape: mpf, speed: mpf,
    warm: mpf,
) -> Rows:  # fmt: skip
    part = 1 - 1 / exponent

    def both(between: mpf) -> mpf:
        # Cooled to its first temperature the air fills the volume suction/between.
        return between**part + (ratio / between) ** part

    least = findroot(lambda at: diff(both, at), ratio ** mpf("0.45"))
    high = ratio * suction
    work = raised(suction, least * suction, exponent) + raised(least * suction, high, exponent) / least
    sucked, later = (1 + room - room * least ** (1 / exponent) for room in (clearance, own))
    sized = sizes(delivery / turns(speed) / sucked, shape)
    return [
        {
            "bore": sized["bore"],
            "second_bore": sized["bore"] * (sucked / later / least) ** mpf("0.5"),
            "second_cylinder_volume": 1000 * (1 + own) * delivery / turns(speed) / least / later,
            "intermediate_pressure": least * suction / BAR,
            "indicated_power": work * delivery / 1000,
            "isothermal_efficiency": raised(suction, high, mpf(1)) / work,
            "end_temperature": warm * least**part,
        }
    ]


@solution
def diagram_factor_of_an_area(
    expansion: mpf, pressure: mpf, back: mpf, area: mpf, length: mpf, scale: mpf
) -> Rows:
    mean = area / length * scale / mpf("0.01")
    return [{"mean_pressure": mean / BAR, "diagram_factor": mean / mean_pressure(pressure, back, expansion)}]


@solution
def compressed_to_a_pressure(pressure: mpf, back: mpf, expansion: mpf, clearance: mpf, end: mpf) -> Rows:
    closed = end * clearance / back - clearance
    resisting = back * (1 - closed)
    resisting += quad(lambda left: end * clearance / (left + clearance), [0, closed])
    return [{"mean_pressure": (mean_pressure(pressure, mpf(0), expansion, clearance) - resisting) / BAR}]


@solution
def both_ends_in_four_strokes(
    cover: mpf, crank: mpf, bore: mpf, rod: mpf, stroke: mpf, speed: mpf, load: mpf, spring: mpf, arm: mpf
) -> Rows:
    work = cover * swept(bore, stroke) + crank * (swept(bore, stroke) - swept(rod, stroke))
    inside, shaft = work * turns(speed) / 2, (load - spring) * arm * speed
    return [{"indicated_power": inside / 1000, "brake_power": shaft / 1000, "efficiency": shaft / inside}]


@solution
def fuel_of_an_engine(
    pressure: mpf, strokes: mpf, cylinders: mpf, power: mpf, efficiency: mpf, shape: mpf, speed: mpf,
    thermal: mpf, heat: mpf,
) -> Rows:  # fmt: skip
    volume = power / efficiency / (pressure * strokes * cylinders * turns(speed))
    return [{**sizes(volume, shape), "consumption": power * 3600 / thermal / heat}]


@solution
def heat_of_the_steam(
    expansion: mpf, pressure: mpf, back: mpf, factor: mpf, efficiency: mpf, power: mpf, shape: mpf,
    speed: mpf, thermal: mpf, heat: mpf,
) -> Rows:  # fmt: skip
    real = factor * mean_pressure(pressure, back, expansion)
    [found] = fuel_of_an_engine(real, mpf(1), mpf(1), power, efficiency, shape, speed, thermal, heat)
    taken = mpf(3600 * 1000) / (thermal * heat)
    return [{**found, "consumption_per_brake_kwh": taken, "consumption_per_kwh": taken * efficiency}]


@solution
def speed_for_a_mass_of_air(
    ratio: mpf, suction: mpf, warm: mpf, exponent: mpf, clearance: mpf, bore: mpf, stroke: mpf, mass: mpf,
    efficiency: mpf,
) -> Rows:  # fmt: skip
    sucked = 1 + clearance - clearance * ratio ** (1 / exponent)
    volume = mass * 287 * warm / suction
    power = raised(suction, ratio * suction, exponent) * volume / efficiency / 1000
    rate = volume / (sucked * swept(bore, stroke)) * 60
    return [{"volumetric_efficiency": sucked, "speed": rate, "brake_power": power}]


@solution
def warm_between_the_stages(
    ratio: mpf, suction: mpf, warm: mpf, between: mpf, exponent: mpf, delivery: mpf
) -> Rows:
    stage = raised(suction, suction * sqrt(ratio), exponent)
    whole = stage * (1 + between / warm)
    shares = {"perfect_against_one": 2 * stage / raised(suction, suction * ratio, exponent)}
    return [{"indicated_power": whole * delivery / 1000, **shares, "against_perfect": whole / (2 * stage)}]


@solution
def given_intermediate_pressure(
    ratio: mpf, suction: mpf, warm: mpf, between: mpf, middle: mpf, exponent: mpf, bore: mpf, stroke: mpf,
    speed: mpf,
) -> Rows:  # fmt: skip
    cooled = suction / middle * between / warm
    work = raised(suction, middle, exponent) + raised(middle, ratio * suction, exponent) * cooled
    hot = between * (ratio * suction / middle) ** (1 - 1 / exponent)
    power = work * swept(bore, stroke) * turns(speed) / 1000
    return [{"indicated_power": power, "second_bore": bore * sqrt(cooled) * 1000, "end_temperature": hot}]


@solution
def compressor_for_free_air(
    ratio: mpf, suction: mpf, warm: mpf, free: mpf, cold: mpf, delivery: mpf, clearance: mpf, exponent: mpf,
    cylinders: mpf, shape: mpf, speed: mpf,
) -> Rows:  # fmt: skip
    share = (1 + clearance - clearance * ratio ** (1 / exponent)) * suction / warm * cold / free
    efficiency = raised(mpf(1), ratio, mpf(1)) / raised(mpf(1), ratio, exponent)
    sized = sizes(delivery / share / (2 * cylinders * turns(speed)), shape)
    return [{**sized, "free_efficiency": share, "isothermal_efficiency": efficiency}]


@solution
def three_stages(
    ratio: mpf, suction: mpf, warm: mpf, exponent: mpf, clearance: mpf, bore: mpf, stroke: mpf, speed: mpf
) -> Rows:
    step = ratio ** (mpf(1) / 3)
    work = 3 * raised(mpf(1), step, exponent) * 287 * warm / 1000
    hot, share = warm * step ** (1 - 1 / exponent), 1 + clearance - clearance * step ** (1 / exponent)
    volume = swept(bore, stroke) * 1000
    of_stage = {"intermediate_pressure": step * suction / BAR, "swept_volume": volume, "work_per_mass": work}
    rate = share * volume * turns(speed) * suction / (287 * warm) / 1000
    cooler = rate * mpf("3.5") * 287 * (hot - warm) / 1000
    heats = {"cooler_heat": cooler, "compression_heat": rate * work / 3 - cooler}
    out = {"delivered_volume": share * volume * hot / warm / ratio, "end_temperature": hot}
    return [{**of_stage, **heats, **out, "volumetric_efficiency": share}]


@solution
def compressor_by_piston_speed(
    ratio: mpf, suction: mpf, warm: mpf, free: mpf, cold: mpf, delivery: mpf, clearance: mpf, exponent: mpf,
    velocity: mpf, speed: mpf, efficiency: mpf,
) -> Rows:  # fmt: skip
    sucked = delivery * free / cold * warm / suction
    stroke = velocity / 2 / turns(speed)
    volume = sucked / (1 + clearance - clearance * ratio ** (1 / exponent)) / 2 / turns(speed)
    power = raised(suction, ratio * suction, exponent) * sucked / efficiency / 1000
    bore = sqrt(volume / (pi / 4 * stroke)) * 1000
    return [{"stroke": stroke * 1000, "bore": bore, "brake_power": power}]


@solution
def engine_by_its_peak_pressure(
    compression: mpf, exponent: mpf, expansion: mpf, suction: mpf, peak: mpf, power: mpf, efficiency: mpf,
    shape: mpf, speed: mpf,
) -> Rows:  # fmt: skip
    least = 1 / (compression - 1)
    ends = [least, 1 + least]
    mean = quad(lambda v: peak * (least / v) ** expansion - suction * (ends[1] / v) ** exponent, ends)
    sized = sizes(power / efficiency / (mean * turns(speed) / 2), shape)
    return [{**sized, "mean_pressure": mean / BAR}]


@solution
def pressure_with_a_diagram_factor(
    expansion: mpf, back: mpf, factor: mpf, bore: mpf, stroke: mpf, speed: mpf, power: mpf
) -> Rows:
    [found] = steam_pressure_for_a_power(expansion, back, mpf(0), bore, stroke, speed, power / factor)
    return [{**found, "mean_pressure": found["mean_pressure"] * factor}]


@solution
def diesel_by_its_cut_off(compression: mpf, exponent: mpf, share: mpf, suction: mpf) -> Rows:
    least = 1 / (compression - 1)
    high, fed = suction * compression**exponent, least + share
    work = high * share + quad(lambda v: high * (fed / v) ** exponent, [fed, 1 + least])
    work -= quad(lambda v: suction * ((1 + least) / v) ** exponent, [least, 1 + least])
    return [{"mean_pressure": work / BAR}]


@solution
def bore_with_a_piston_rod(
    expansion: mpf, clearance: mpf, pressure: mpf, back: mpf, factor: mpf, efficiency: mpf, power: mpf,
    velocity: mpf, speed: mpf, rod: mpf,
) -> Rows:  # fmt: skip
    real = factor * mean_pressure(pressure, back, expansion, clearance)
    # Of the mean area of both ends.
    area = power / efficiency / (real * velocity) + pi / 8 * rod**2
    return [{"bore": sqrt(area * 4 / pi) * 1000, "stroke": velocity / 2 / turns(speed) * 1000}]


@solution
def compressor_by_its_volume(
    ratio: mpf, suction: mpf, exponent: mpf, clearance: mpf, volume: mpf, speed: mpf
) -> Rows:
    share = 1 + clearance - clearance * ratio ** (1 / exponent)
    rate = 2 * share * volume * turns(speed)
    power = raised(suction, ratio * suction, exponent) * rate / 1000
    return [{"volumetric_efficiency": share, "delivery": rate * 60, "indicated_power": power}]


@solution
def air_left_in_the_clearance(
    ratio: mpf, suction: mpf, exponent: mpf, back: mpf, clearance: mpf, delivery: mpf, speed: mpf,
    efficiency: mpf,
) -> Rows:  # fmt: skip
    high, whole = ratio * suction, 1 + clearance
    end, start = whole * ratio ** (-1 / exponent), clearance * ratio ** (1 / back)
    # Up to the delivery, the delivery itself, back to suction: the volume in that of a stroke.
    work = quad(lambda v: suction * (whole / v) ** exponent, [end, whole]) + high * (end - clearance)
    work -= quad(lambda v: high * (clearance / v) ** back, [clearance, start]) + suction * (whole - start)
    swept = delivery / (whole - start) / (2 * speed / (2 * pi))
    power = work * delivery / (whole - start) / 1000
    bore = 1000 * (4 * swept / pi) ** (mpf(1) / 3)
    rows = {"volumetric_efficiency": whole - start, "bore": bore, "indicated_power": power}
    return [{**rows, "brake_power": power / efficiency}]
