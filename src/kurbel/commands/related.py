"""Pages of sums and of relations, computed a second time: rotors, locomotives, balance, power, flywheels.

What is asked for, masses, places, sizes, is read as kurbel reads it; what follows is `kurbel.verify`'s.
Keys are without their unit, values in that of the SI, angles in degrees and speeds in turns a second.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.commands.recomputed import nearest, of_harmonics
from kurbel.engine.diagram.excess import ExcessTorque
from kurbel.engine.diagram.fluctuation import Areas, Fluctuation
from kurbel.errors import ProblemError
from kurbel.reading.units import MassFlow, Speed
from kurbel.verify import Number, Value, drive, harmonics
from kurbel.verify.diagram import Diagram, swing
from kurbel.verify.numbers import heading, number, pi
from kurbel.verify.plane import Arrow
from kurbel.verify.relations import ENGINE, completed, flywheel, staged
from kurbel.verify.shaft import PlanarVector, Slide, held, moment, parts, ray, together

if TYPE_CHECKING:
    from kurbel.balancing.locomotive import Crank
    from kurbel.commands.recomputed import Row
    from kurbel.commands.second import SecondComputation
    from kurbel.engine.power.duty import Duty
    from kurbel.engine.power.source import ActingPressure

# What is printed of a vector.
Printed = Callable[[Arrow], Number]


def _omega(speed: Speed) -> Number:
    return number(speed.value) * (2 * pi() if speed.turns else 1)


def _one() -> Number:
    return number(1)


def of_rotor(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    """A mass as it is given, what all leave together, and what balances or holds them in two planes."""
    request = second.question
    rotor, places, line = request.rotor, request.places, row["line"]
    if any(None in (one.mass, one.radius, one.angle, one.plane) for one in rotor.masses):
        raise ProblemError("masses that are asked for are not computed a second time")
    name, _, count = line.rpartition("_") if line[-1].isdigit() else (line, "", "0")
    index = int(count) - 1

    def pulls() -> list[PlanarVector]:
        return [
            PlanarVector(ray(one.mass * one.radius, one.angle), number(one.plane or 0))
            for one in rotor.masses
        ]

    def pull() -> PlanarVector:
        if name == "mass":
            return pulls()[index]
        planes = places.balance if name == "balance" else places.bearings
        found = held(_left(), planes)[index]
        return PlanarVector(found.times(number(-1 if name == "balance" else 1)), number(planes[index]))

    def _left() -> list[PlanarVector]:
        if name.startswith("second"):
            # What goes to and fro turns twice as fast in the second order.
            return [
                PlanarVector(ray(one.mass * one.radius * rotor.ratio, 2 * one.angle), number(one.plane or 0))
                for one in rotor.masses
            ]
        found = pulls()
        if places.balance and name != "balance":
            against = zip(held(found, places.balance), places.balance, strict=True)
            found += [PlanarVector(one.times(number(-1)), number(plane)) for one, plane in against]
        return found

    def vector() -> Arrow:
        if name.endswith("unbalance"):
            return together(one.arrow for one in (_left() if "_" in name else pulls()))
        if name.endswith("couple"):
            return moment(_left() if "_" in name else pulls(), rotor.about)
        return pull().arrow

    if key == "plane":
        return Value(lambda: pull().place)
    given = rotor.masses[index] if name == "mass" else None
    radius = given.radius if given else places.radii[index] if name == "balance" else None
    if radius is None and key in ("radius", "mass"):
        raise ProblemError(f"{line} has no radius on such a page")
    if key == "radius":
        return Value(lambda: number(radius or 0))
    if key == "angle" and given is not None:
        return Value(lambda: number(given.angle))
    if key == "angle":
        return Value(lambda: heading(*vector()))
    if key == "mass":
        return Value(lambda: vector().size() / radius)
    arm = _one
    if key.startswith("moment") and not name.endswith("couple"):

        def arm() -> Number:
            found: Number = pull().place - rotor.about
            return found

    squared = key in ("unbalance_n", "moment_nm")
    return Value(
        lambda: vector().size() * arm() * (_omega(request.speed).power(Fraction(2)) if squared else 1)
    )


def of_locomotive(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    """Of the shares that are balanced the wheels' masses and blows; the rest pulls, and sways the frame."""
    request = second.question
    loco, run = request.engine, request.run
    share = nearest(row["share"], request.shares)
    planes = (-loco.gauge / 2, loco.gauge / 2)

    def pulls(mass: Callable[[Crank], Fraction]) -> list[PlanarVector]:
        return [
            PlanarVector(ray(mass(one) * loco.radius, one.angle), number(one.place)) for one in loco.cranks
        ]

    def blows(part: Fraction) -> tuple[Arrow, ...]:
        return held(pulls(lambda one: part / loco.axles * one.reciprocating), planes)

    def blow(part: Fraction) -> Number:
        return max((one.size() for one in blows(part)), key=float, default=number(0))

    def balance(side: int) -> Arrow:
        found = held(pulls(lambda one: one.revolving + share / loco.axles * one.reciprocating), planes)
        return found[side].times(number(-1))

    def rest() -> list[PlanarVector]:
        return pulls(lambda one: (1 - share) * one.reciprocating)

    def omega() -> Number:
        return _omega(run.speed) if run.speed is not None else number(2 * run.velocity / run.wheel)

    def square() -> Number:
        return omega() * omega()

    def lifting() -> Number:
        return (number(run.load) / blow(share)).root()

    side = int("right" in key)
    wheel = (run.wheel or Fraction(0)) / 2

    def upright(arrow: Arrow) -> Number:
        """The crank angle at which the vector lies along the slides."""
        found = heading(arrow.x, -arrow.y)
        return found

    known: Mapping[str, Callable[[], Number]] = {
        "speed": lambda: omega() / (2 * pi()),
        "velocity": lambda: omega() * wheel,
        "velocity_kmh": lambda: omega() * wheel,
        "balance": lambda: balance(side).size(),
        "mass": lambda: balance(side).size() / run.radius,
        "angle": lambda: heading(*balance(side)),
        "blow": lambda: blows(share)[side].size() * square(),
        "load_least": lambda: run.load - blow(share) * square(),
        "load_greatest": lambda: run.load + blow(share) * square(),
        "lift_speed": lambda: lifting() / (2 * pi()),
        "lift_velocity": lambda: lifting() * wheel,
        "pull": lambda: together(one.arrow for one in rest()).size() * square(),
        "pull_phi": lambda: upright(together(one.arrow for one in rest())),
        "sway": lambda: moment(rest()).size() * square(),
        "sway_phi": lambda: upright(moment(rest())),
        "share_most": lambda: (
            number(run.load if run.limit is None else run.limit) / (blow(Fraction(1)) * square())
        ),
    }
    stem = key.replace("_left", "").replace("_right", "")
    for ending in ("", "_n", "_nm", "_mps"):
        if (found := known.get(stem.removesuffix(ending) if ending else stem)) is not None:
            return Value(found)
    raise LookupError(key)


def of_balance(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    """Free forces and moments of an engine by orders: amplitudes, what turns, half axes of the ellipse; at
    angles, and the greatest over the turn."""
    request = second.question
    if key == "factor":
        return of_harmonics(second, "value", method, row)
    ratio, order = second.drive(row).ratio, row["order"]
    arm = row["residual"] == "moment"
    exact = method == "exact"
    slides = [
        Slide(one.crank, one.bank, one.position, one.mass, one.revolving)
        for one in request.arrangement.cylinders
    ]
    if arm:
        slides = [one._replace(moved=one.moved * one.place, turned=one.turned * one.place) for one in slides]
    share = request.arrangement.share

    def harmonic(k: int) -> Number:
        if method == "infinite" or (method == "series" and k > 2):
            return number(int(k == 1))
        return number({1: Fraction(1), 2: ratio}[k]) if not exact else harmonics.of_acceleration(ratio, k)

    def of_order(k: int) -> tuple[Arrow, Arrow]:
        return parts(slides, k, harmonic(k), share)

    orders = [int(order)] if order.isdecimal() else list(request.orders)
    if not {*orders} <= {*request.orders}:
        raise ProblemError(f"{order} is no order of such a page")

    def at(degrees: Fraction) -> Arrow:
        """The vector at an angle of the shaft; of all orders that of the motion itself."""
        if not order.isdecimal() and exact:
            return _exactly(ratio, slides, share, degrees)
        found = ((sense * k, one) for k in orders for sense, one in zip((1, -1), of_order(k), strict=True))
        return together(one.rotated(ray(Fraction(1), k * degrees)) for k, one in found)

    times: Callable[[], Number] = _one
    name = key.removesuffix("_n")
    if key.endswith("_n"):
        weighed = request.weighed
        lever = weighed.spacing or (Fraction(1) if request.metres else None) if arm else Fraction(1)

        def times() -> Number:
            if lever is None:
                raise ProblemError("moments of unknown places, but for those that are zero, are not computed")
            mass: Fraction = weighed.crank.radius * weighed.mass * lever
            return _omega(weighed.crank.speed).power(Fraction(2)) * mass

    def weighed_by(found: Callable[[], Number]) -> Value:
        return Value(lambda: one if (one := found()).is_zero else one * times())

    if (angles := getattr(request, "angles", None)) is not None:
        if "phi" not in row and len(angles) > 1:
            raise ProblemError("the row does not say its crank angle; add phi to the columns")
        place = nearest(row["phi"], angles) if "phi" in row else angles[0]
        return weighed_by(lambda: _AT[name](at(place)))
    if not order.isdecimal() or name == "greatest_phi":
        raise ProblemError(f"{name} over the turn is not computed a second time")
    return weighed_by(lambda: _OF_ORDER[name](*of_order(int(order))))


def _exactly(ratio: Fraction, slides: Sequence[Slide], share: Fraction, degrees: Fraction) -> Arrow:
    moved = (
        ray(drive(ratio).value("p", (degrees + one.crank - one.bank) % 360).recipe() * one.moved, one.bank)
        for one in slides
    )
    turned = (ray(one.turned - share * one.moved, one.crank + degrees) for one in slides)
    return together((*moved, *turned))


_AT: Mapping[str, Printed] = {
    "along": lambda arrow: arrow.x,
    "across": lambda arrow: arrow.y,
    "magnitude": lambda arrow: arrow.size(),
    "direction": lambda arrow: heading(*arrow),
}
_OF_ORDER: Mapping[str, Callable[[Arrow, Arrow], Number]] = {
    "along": lambda f, b: Arrow(f.x + b.x, f.y - b.y).size(),
    "across": lambda f, b: Arrow(f.x - b.x, f.y + b.y).size(),
    "forward": lambda f, b: f.size(),
    "backward": lambda f, b: b.size(),
    "greatest": lambda f, b: f.size() + b.size(),
    "least": lambda f, b: abs(f.size() - b.size()),
}


def of_power(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    """Mean pressure, size, power and steam: each follows from the others."""
    request = second.question
    duty, asked = request.duty, second.asked
    source = request.sources[0]
    if source.sought is not None:
        raise ProblemError("numbers of a load that are asked for are not computed a second time")

    def found() -> dict[str, Number]:
        known = {
            name: number(value)
            for name, value in (
                ("bore", duty.bore), ("stroke", duty.stroke), ("indicated_power", duty.power),
                ("brake_power", duty.brake_power), ("pressure", duty.pressure),
                ("stroke_bore", duty.stroke_bore), ("piston_speed", duty.piston_speed),
                ("specific_volume", duty.specific_volume), ("open", duty.open_area),
                ("strokes", source.strokes * duty.cylinders), ("mean_torque", duty.brake_torque),
                ("heating_value", duty.heating_value), ("swept_volume", duty.swept_volume),
                ("brake_thermal" if duty.shafted else "indicated_thermal", duty.thermal_efficiency),
            )
            if value is not None
        }  # fmt: skip
        if not duty.factor_asked:
            known["diagram_factor"] = number(duty.diagram_factor)
        if isinstance(duty.delivery, MassFlow):
            known["air_mass"] = number(duty.delivery.mass)
        elif duty.delivery is not None:
            known["free_delivery" if duty.free_air else "delivery"] = number(duty.delivery)
        if duty.consumption is not None:
            per = "_per_brake" if duty.shafted else "_per"
            known[f"consumption{per * duty.consumption.of_work}"] = number(duty.consumption.mass)
        if duty.suction_temperature is not None and duty.pressure is not None:
            known["density"] = number(duty.pressure / duty.suction_temperature / 287)
            free, warm = duty.free_air or (duty.pressure, duty.suction_temperature)
            known["freed"] = number(duty.pressure * warm / (free * duty.suction_temperature))
            known["suction_temperature"] = number(duty.suction_temperature)
        if duty.speed is not None:
            known["speed"] = _omega(duty.speed) / (2 * pi())
        if duty.efficiency is not None:
            known["at_shaft"] = number(1 / duty.efficiency if source.driven else duty.efficiency)
        if duty.ends:
            areas = [(duty.bore or 1) ** 2 - (rod or 0) ** 2 for rod in (duty.tail_rod, duty.piston_rod)]
            areas = areas[: len(duty.ends)]
            weighed = sum((one * area for one, area in zip(duty.ends, areas, strict=True)), Fraction(0))
            acting = hasattr(source, "load")
            known["mean_pressure" if acting else "pressure"] = number(weighed / sum(areas))
        if duty.ends and not acting:
            known["relative_pressure"] = number(1)
        else:
            known |= _of_load(second, source, duty.open_area, row)
            if asked.says("card"):
                known["pressure"] = number(Fraction(second.card.admission))
        if duty.compound is not None:
            epsilon, back = second.of_row(row, "epsilon", asked.eps), source.load.back
            known |= _of_compound(duty, number(epsilon), number(1 if back is None else epsilon * back))
        found = completed(known, ENGINE)
        shaft = found.get("at_shaft", number(1))
        if (
            duty.bore is None
            and "bore" in found
            and (rods := [rod for rod in (duty.piston_rod, duty.tail_rod) if rod is not None])
        ):
            found["bore"] = (found["bore"] * found["bore"] + number(sum(rod**2 for rod in rods) / 2)).root()
        return {**found, "efficiency": 1 / shaft if source.driven else shaft}

    stem = re.sub("_(mps|nm|mm)$", "", key)
    return Value(lambda: second.once(row, found)[stem])


def _of_load(
    second: SecondComputation, source: ActingPressure, area: Fraction, row: Row
) -> dict[str, Number]:
    """The mean pressure that a load makes in its own, and what it takes of steam or delivers."""
    asked, strokes = second.asked, second.load(row)()
    work = abs(sum((one.work(number(1)) for one in strokes), number(0)))
    known = {"relative_pressure": work / (source.strokes * Fraction(len(strokes), 2) * area)}
    if asked.says("eps"):
        steam = strokes[0].sides[1][1].value(number(0))
        room, power = asked.clearance or Fraction(0), asked.exponent or Fraction(1)
        left = (1 - (asked.cushioned() or Fraction(1)) + room) * steam.power(1 / power)
        known["taken"] = 1 / second.of_row(row, "epsilon", asked.eps) + room - left
    if asked.says("pump"):
        known["delivered"] = number(1)
    if asked.says("pressure_ratio"):
        load, exponent, expanding = source.load, asked.exponent or Fraction(1), asked.expansion_exponent
        inlet = 1 - (asked.suction_loss or Fraction(0))
        ratio = number(second.of_row(row, "pressure_ratio", asked.pressure_ratio))
        between = None if load.between is None else number(load.between)
        apart, room = (1 + (asked.delivery_loss or 0)) / inlet, asked.clearance or Fraction(0)
        known |= staged(ratio, exponent, load.stages, between, load.cooled, apart, room)
        if load.stages > 1:
            known["relative_pressure"] = known["whole_work"] * known["volumetric_efficiency"] * inlet
        if expanding is not None:
            known["volumetric_efficiency"] = 1 + room - (ratio * apart).power(1 / expanding) * room
        known["inlet"] = number(inlet)
    return known


def _of_compound(duty: Duty, epsilon: Number, lost: Number) -> dict[str, Number]:
    """How far the steam expands in the high-pressure cylinder, and its share in the work."""
    assert duty.compound is not None
    way, value = duty.compound
    if way == "work":
        # Of ln R = ½ (1 + ln ε - b ε).
        expansion = ((1 + epsilon.log() - lost) / 2).exp()
    elif way == "load":
        left = 1 - lost
        expansion = (left + (left * left + 4 * epsilon).root()) / 2
    elif way == "bore":
        expansion = epsilon * (number(value) / (duty.bore or 1)).power(Fraction(2))
    else:
        expansion = number(value) if way == "expansion" else (duty.pressure or 1) / number(value)
    high = number(Fraction(1, 2)) if way == "work" else expansion.log() / (1 + epsilon.log() - lost)
    found = {"high_expansion": expansion, "low_cut_off": expansion / epsilon}
    return {**found, "high_share": high, "low_share": 1 - high}


def of_flywheel(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    """What is given of power, speed, swing, irregularity, wheel and rim finds the rest."""
    from kurbel.commands.flywheel import FlywheelOptions

    options = FlywheelOptions(second.values())
    targets = options.delta or ()
    target = nearest(row["target"], targets) if "target" in row else targets[0] if len(targets) == 1 else None
    if target is None and targets:
        raise ProblemError("the row does not say its irregularity; add target to the columns")

    def found() -> dict[str, Number]:
        figures = list(options.figures())
        if not options.is_engine():
            figures += options.of_press()
        known = {
            {"motor": "motor_power"}.get(name, name): number(one.value.base) * pi().power(one.value.pi)
            for name, one in figures
        }
        known.pop("hoop_stress", None)
        if target is not None:
            known["delta"] = number(target)
        if options.is_engine():
            if "card" in second.options:
                raise ProblemError("flywheels by indicator cards are not computed a second time")
            turn = second.turn(method, row)
            known["swing_share"] = turn.known.delta()
            if "power" not in known:
                known["mean_torque"] = abs(turn.known.mean) * second.torque(turn)
        elif options.is_diagram():
            known |= _of_diagram(options.fluctuation())
        elif share := options.share_of(dict(figures)):
            known["energy_fluctuation"] = number(share.rest.base)
        whole = flywheel(known)
        for taken in ("turns", "rim_share"):
            if taken not in whole:
                whole = flywheel({taken: number(1), **whole})
        return whole

    if key == "angular_acceleration":
        excess, at = options.excess(), options.angle or Fraction(0)
        return Value(lambda: _torque(excess, at, 1, -1) / second.once(row, found)["inertia"])
    stem = re.sub("_nm$", "", _STEM.get(key, key))
    return Value(lambda: second.once(row, found)[stem] / (2 * pi() if key in _TURNS else 1))


def _of_diagram(fluctuation: Fluctuation) -> dict[str, Number]:
    """The swing of a turning moment diagram, its mean torque and its turns."""
    if isinstance(fluctuation, Areas):
        known = {"swing": _of_areas(fluctuation, max(fluctuation.levels) - min(fluctuation.levels))}
    else:
        assert isinstance(fluctuation, ExcessTorque)
        driving, load = diagrams(fluctuation)
        unit = number(1) if fluctuation.by_degree else pi() / 180
        known = {"swing": swing(driving, load) * unit}
        if float(mean := driving.mean * unit * 180 / pi()) > 0:
            known["mean_torque"] = mean
    if fluctuation.turns is not None:
        known["turns"] = number(fluctuation.turns)
    return known


def _of_areas(areas: Areas, level: Fraction) -> Number:
    return number(level * areas.scale.energy) * (pi() if areas.scale.of_pi else 1)


def diagrams(excess: ExcessTorque) -> tuple[Diagram, Diagram]:
    """The torques of the drive and of the load as they are described."""
    driving, load = (
        Diagram(tuple(one.waves.parts), tuple(one.lines), one.cycle) for one in (excess.drive, excess.load)
    )
    return driving, load


def _torque(excess: ExcessTorque, at: Fraction, *shares: int) -> Number:
    """So many times the torque of the drive and that of the load at a crank angle."""
    total = sum(
        (one.value(at) * share for one, share in zip(diagrams(excess), shares, strict=True)), number(0)
    )
    return total * 180 / pi() if excess.by_degree else total


def of_diagram(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    """Turning moment diagrams: torques, and the work above the mean since 0°, by closed antiderivatives."""
    request = second.question
    if "point" in row:
        areas = request.areas
        level = areas.levels[areas.letters.index(row["point"])]
        values = {"level": lambda: number(level), "excess_energy": lambda: _of_areas(areas, level)}
    else:
        excess, at = request.excess, nearest(row["phi"], request.angles)
        driving, load = diagrams(excess)
        values = {
            "torque": lambda: _torque(excess, at, 1, 0),
            "load_torque": lambda: _torque(excess, at, 0, 1),
            "excess_torque": lambda: _torque(excess, at, 1, -1),
            "angular_acceleration": lambda: _torque(excess, at, 1, -1) / (second.asked.inertia or 0),
            "excess_energy": lambda: (
                (driving.integral(at) - load.integral(at)) * (number(1) if excess.by_degree else pi() / 180)
            ),
        }
    return Value(values[key.removesuffix("_nm")])


def of_masses(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    """Masses in place of the rod, with its mass and its centre; but for those at the pins with its moment of
    inertia. Of two about a pin at the distance a of the centre the other is (a² + k²)/a from there."""
    question = second.question
    printed = [one.key for one in question.page_columns if one.key.startswith(key)]
    if len(printed) != 1:
        raise ProblemError("shares beside kilograms are not told apart")
    part, _, what = key.partition("_")
    # A column without a unit of its own has shares of the rod's mass and length.
    whole, long = (printed != [key] or part == "correction"), question.length

    def found() -> Number:
        rod, first, second_moment = second.rod(long, "", row, whole)()
        size, near = number(long if whole and long else 1), first / rod
        square, far = second_moment / rod - near * near, 1 - near
        places = {"crosshead": number(0), "centre": near, "crank": number(1)}
        if row["model"] == "crosshead":
            places["crank"] = near + square / near
        elif row["model"] == "crank":
            places["crosshead"] = near - square / far
        span = places["crank"] - places["crosshead"]
        masses = {"crosshead": (places["crank"] - near) / span, "crank": (near - places["crosshead"]) / span}
        if row["model"] == "three":
            masses = {"crosshead": square / near, "crank": square / far}
            masses["centre"] = 1 - masses["crosshead"] - masses["crank"]
        if part in ("lacking", "correction"):
            for one, mass in masses.items():
                square = square - mass * (places[one] - near) * (places[one] - near)
            return square * rod * size * size * (1 if part == "lacking" else question.acceleration)
        return masses[part] * rod if what == "mass" else places[part] * size

    return Value(found)


_TURNS = ("greatest_speed", "least_speed", "speed_drop")
_STEM = {"speed_drop": "drop", "greatest_speed": "omega_max", "least_speed": "omega_min", "strokes": "cycles"}

# Where a command is that is not called as its module.
MODULES = {"table": "motion", "locomotive": "rotor", "turning": "engine"}
# By commands, and of turning moment diagrams by their layouts.
SUMMED: Mapping[str, Callable[[SecondComputation, str, str, Row], Value]] = {
    "rotor": of_rotor, "locomotive": of_locomotive, "balance": of_balance, "power": of_power,
    "flywheel": of_flywheel, "torques": of_diagram, "areas": of_diagram,
    "rod-masses": of_masses,
}  # fmt: skip
