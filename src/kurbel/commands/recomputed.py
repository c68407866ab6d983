"""What each page asks the second computation for: a column by its key becomes one value.

A page is of a command; its function takes what was asked for, the key of a column in the unit of the second
computation, its method and the row.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial, reduce
from math import atan, degrees
from operator import add
from typing import TYPE_CHECKING, TypeAlias

from kurbel import verify
from kurbel.errors import ProblemError
from kurbel.motion.point_quantities import points_registry
from kurbel.reading.given import as_places
from kurbel.reading.notation import number
from kurbel.verify import Number, Value, harmonics
from kurbel.verify.bodies import Force
from kurbel.verify.drives import Degrees, place_of
from kurbel.verify.extremes import Summit, summits, where
from kurbel.verify.jets import Jet
from kurbel.verify.loads import Piece, Stroke, disc
from kurbel.verify.numbers import degrees_of, largest, pi, sine_cosine
from kurbel.verify.numbers import number as exactly
from kurbel.verify.plane import Arrow
from kurbel.verify.reversal import PULL, THRUST, RodLoad
from kurbel.verify.turn import Running, star
from kurbel.verify.zeros import FoundAngle, Place, around, between, root

if TYPE_CHECKING:
    from kurbel.commands.second import SecondComputation

# A row without what it has nothing of.
Row: TypeAlias = Mapping[str, str]
RETURN = "_return"
# Farther no axis goes.
FARTHEST = 10**12


def of_drive(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    """Motion and forces at a crank angle, over the path, or where the rod is square to the crank."""
    if "end" in row:
        return _of_rod_load(second, key, method, row)
    tangent = "at" in second.options or second.key == "forces-tangent"
    if "share" not in row and not tangent:
        return at_angle(second, key, method, second.place(row), row)
    drive = second.pushed(row)
    if tangent:
        near = Fraction(degrees(atan(1 / drive.ratio)))
        place = second.spot(drive, lambda: root(lambda at: _square(drive, at), near))
    else:
        place = _at_share(second, drive, method, row, RETURN in key)
    if key.removesuffix(RETURN) == "phi":
        return place.value
    return at_angle(second, key, method, place, row)


def at_angle(second: SecondComputation, key: str, method: str, at: Degrees, row: Row) -> Value:
    """Motion and forces at a crank angle."""
    if second.asked.is_engine():
        return of_engine(second, key, method, at, row)
    drive = second.pushed(row)
    return _coupled(second, drive, key, row) if "axle" in row else _moved(second, drive, key, method, at, row)


def _moved(
    second: SecondComputation, drive: verify.Drive, key: str, method: str, at: Degrees, row: Row
) -> Value:
    asked = second.asked
    if "rubbing" in key:
        pin, _, side = key.removesuffix("_mps").partition("_rubbing")
        turned = drive.value(f"rod_velocity{side}", at, method)
        own, of_rod = {"crosshead_pin": (0, 1), "crank_pin": (1, 1), "shaft": (1, 0)}[pin]
        rim: Fraction = getattr(asked, pin) / 2
        return Value(lambda: (own + of_rod * turned.recipe()) * drive.omega * rim)
    if asked.is_heavy() or asked.has_parts():
        heavy = weighed(second, drive, second.push(), method, row)
        if heavy.knows(key):
            return heavy.value(key, at)
        if key.startswith("angular_acceleration"):
            side = key.removeprefix("angular_acceleration")
            torque = heavy.value(f"{'net_' if asked.pin_friction else ''}torque{side}_nm", at)
            power, inertia = asked.power or 0, asked.inertia or 1
            return Value(
                lambda: (torque.recipe() - (exactly(power) / drive.omega if power else 0)) / exactly(inertia)
            )
    if "point" not in second.options or key not in points_registry():
        return drive.value(key, at, method)
    if method != "exact" or drive.parallel:
        raise ProblemError("points of such a rod are not known to the second computation")
    # That of one point is in its caption.
    share, _, beside = (row.get("point") or second.question.points[0].text).partition(",")
    return drive.value(key, at, method, point=(number(share), number(beside or "0")))


def weighed(
    second: SecondComputation, drive: verify.Drive, force: Fraction | Force, method: str, row: Row
) -> verify.Bodies:
    return replace(second.bodies(drive, force, row), method=method)


def of_engine(second: SecondComputation, key: str, method: str, at: Degrees, row: Row) -> Value:
    """A force where the load of an engine acts on the piston of the first crank."""
    if key.startswith("torque") and second.asked.says("cranks"):
        return _of_all(second, second.turn(method, row), key == "torque_nm", at)
    turn = second.turn(method, row, alone=True)
    bore, pressure = second.unit()

    def push(place: Place) -> Number:
        found: Number = turn.known.crank.push(place).value
        return found if pressure is None else found * disc(bore) * pressure

    there = weighed(second, turn.drive, push, method, row)
    if there.knows(key):
        return there.value(key, at)
    newtons = there.value(f"{key}_n", at)
    if pressure is None:
        return newtons
    return Value(lambda: newtons.recipe() / (disc(bore) * pressure))


def _of_all(second: SecondComputation, turn: verify.Turn, in_newtons: bool, at: Degrees) -> Value:
    """The torque of all cranks."""
    found = turn.value("tangential", at)
    return Value(lambda: found.recipe() * second.torque(turn)) if in_newtons else found


def _of_rod_load(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    """The greatest loads along the rod at one of its ends, where they are, and its reversal."""
    turn, end, (bore, pressure) = second.turn(method, row, alone=True), _ENDS[row["end"]], second.unit()

    def unit() -> Number:
        return exactly(1) if pressure is None else disc(bore) * pressure

    def found() -> RodLoad:
        crank, area = turn.known.crank, unit()

        def load(of: Place, at: Place, order: int) -> Jet:
            pushed = replace(still, force=lambda place: crank.push(place, 2, of) * area)
            return pushed.course(end, at, 1, order)

        still = weighed(second, turn.drive, Fraction(0), method, row)
        return RodLoad(crank, load)

    def load() -> RodLoad:
        known: RodLoad = second.once(row, found, method, end)
        return known

    sign = PULL if "pull" in key else THRUST
    known: Mapping[str, Callable[[], Number]] = {
        "n": lambda: load().size(sign),
        "angle": lambda: load().over(sign),
        "thrust": lambda: load().size(sign) / unit(),
        "phi_thrust": lambda: where(load().greatest(sign)),
        "reversal_angle": lambda: load().least(load().over),
        "reversal_unbroken": lambda: load().least(load().unbroken),
        "reversal_share": lambda: (
            load().least(load().size) * 100 / largest([load().size(1), load().size(-1)])
        ),
    }
    stem = key.replace("pull", "thrust").removeprefix("thrust_")
    return Value(known[stem])


def _square(drive: verify.Drive, at: Place) -> Number:
    pin, end = drive.placed(at, 0)
    found: Number = pin.dot(pin.minus(end)).value
    return found


def _coupled(second: SecondComputation, drive: verify.Drive, key: str, row: Row) -> Value:
    """Each axle takes its share; a coupling rod carries those of the axles beyond it."""
    weights = as_places(second.options.get("axles", "2"), "weight on an axle")
    weights = [Fraction(1)] * int(weights[0]) if len(weights) == 1 else weights
    driven = int(number(str(second.options.get("driven", 1))))
    axle, whole = int(number(row["axle"])), sum(weights)
    if key.startswith("coupling_force"):
        share = Fraction(sum(weights[:axle] if axle < driven else weights[axle:])) / whole
        return Value(lambda: drive.unit(key.removeprefix("coupling_force")[1:]) * share)
    return drive.value(key, second.place(row)) * (weights[axle - 1] / whole)


def _at_share(
    second: SecondComputation, drive: verify.Drive, method: str, row: Row, back: bool
) -> FoundAngle:
    """Where B has gone a share of a stroke, on which it goes one way."""
    shares = second.asked.shares() if second.command != "pressures" else second.shares
    share, key = nearest(row["share"], shares), "x_stroke" if drive.rocker is None else "path_stroke"
    course = drive.over(key, method, back=back)

    def found() -> FoundAngle:
        if share in (0, 1):
            return FoundAngle(lambda: around(dead(drive, bool(share) != back, back)))
        low, high = (Fraction(float(dead(drive, outer, back))) for outer in (back, not back))
        return FoundAngle(lambda: between(lambda at: course.value(at) - share, low, high))

    return second.spot((course, share), found)


def dead(drive: verify.Drive, outer: bool, back: bool) -> Number:
    angle = drive.dead_degrees(-1 if outer else 1)
    return angle - 180 if back and outer else angle + 180 if back else angle


def _off_vertical(ratio: Fraction, arm: Fraction, side: int) -> Number:
    """R²/(4 a (L ± R)) = λ/(4 a (1 ± λ)) in degrees."""
    return exactly(ratio / (4 * arm * (1 + side * ratio))) * 180 / pi()


def of_dead_centres(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    """Of a beam engine the angles at which its dead centres lie off the vertical, and the beam's paths from
    there; by Weisbach R²/(4 a (L ± R)) in radians, and R (1 - cos) of them."""
    name, _, number_of = key.partition("_")
    has_beam = "arm" in row or second.arms or second.asked.says("beam")
    drive = second.drive(row) if has_beam else None
    if drive is None or not (name in ("mu", "nu") or number_of in ("1", "2")):
        return of_drive(second, key, method, row)
    arm = nearest(row["arm"], ()) if "arm" in row else drive.rocker or number(second.arms[0])
    rough = method == "approximate" or not drive.ratio
    if rough:
        angles = [Value(partial(_off_vertical, drive.ratio, arm, side)) for side in (1, -1)]
    else:
        beam = verify.drive(drive.ratio, beam=arm)
        angles = [Value(lambda: abs(beam.dead_degrees(1))), Value(lambda: abs(beam.dead_degrees(-1) - 180))]
    if name in ("mu", "nu"):
        return angles[name == "nu"]
    if name == "distance":
        apart = angles[1] - angles[0]
        return Value(lambda: 180 + apart.recipe() * (1 if number_of == "1" else -1))
    if not rough:
        return beam.value("path" if number_of == "1" else "path_return")
    angle = angles[number_of == "2"]
    return Value(lambda: 1 - sine_cosine(*around(angle.recipe()))[1])


def of_turn(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    if " - " in method:
        one, other = (of_turn(second, "delta", each, row) for each in method.split(" - "))
        return one - other
    turn, at = second.turn(method, row), second.place(row)
    if key in _OF_LOAD:
        return Value(lambda: _OF_LOAD[key](second, turn, second.load(row)()))
    if key == "torque_nm":
        return _of_all(second, turn, True, at)
    if key in ("exponent", "clearance"):
        given = getattr(second.asked, key)
        return Value(lambda: exactly(Fraction(key == "exponent") if given is None else given))
    if second.asked.says("flywheel", "inertia") and key in _RUNNING:
        return Value(lambda: _RUNNING[key](second.running(turn), at))
    return turn.value(key, at, stroke=row.get("stroke", "turn"))


def _ends(second: SecondComputation) -> int:
    """How many ends of a cylinder work."""
    asked = second.asked
    single = (
        asked.single_acting
        or asked.says("compression", "other_side")
        or asked.pump in ("single", "differential")
    )
    return 1 if single else 2


def _mean_pressure(second: SecondComputation, strokes: Sequence[Stroke]) -> Number:
    if second.asked.says("piston_rod", "tail_rod"):
        raise ProblemError("mean pressures beside piston rods are not computed a second time")
    return abs(sum((one.work(exactly(1)) for one in strokes), exactly(0))) / _ends(second)


def _pascals(second: SecondComputation) -> Fraction:
    _, pressure = second.unit()
    if pressure is None:
        raise ProblemError("pressures need what Q is in N")
    return pressure


def _efficiency(second: SecondComputation, turn: verify.Turn, strokes: Sequence[Stroke]) -> Number:
    """Work over heat: at one volume V Δp/(γ - 1), at one pressure γ p ΔV/(γ - 1) of it."""
    power, pressures = second.asked.exponent or Fraction(7, 5), strokes[0].sides[0][1]
    expanding = pressures.pieces[-1][1]
    assert isinstance(expanding, Piece)
    top, pressed = pressures.value(exactly(0)), strokes[-1].sides[-1][1].value(exactly(1))
    burnt = pressures.pieces[0][0] if len(pressures.pieces) > 1 else exactly(0)
    heat = ((top - pressed) * expanding.room + top * burnt * power) / (power - 1)
    return (strokes[0].work(exactly(1)) + strokes[-1].work(exactly(1))) / heat


def _sucked(strokes: Sequence[Stroke]) -> Number:
    """The share of a stroke on which air comes in, behind what expands of the clearance."""
    leaving = strokes[0].sides[0][1].pieces
    return 1 - leaving[0][0] if len(leaving) > 1 else exactly(1)


def _delivered(second: SecondComputation, strokes: Sequence[Stroke]) -> Number:
    return _sucked(strokes) * (1 - (second.asked.suction_loss or 0))


def _delivery(second: SecondComputation, turn: verify.Turn, strokes: Sequence[Stroke]) -> Number:
    drive, turns = turn.drive, turn.drive.omega / (2 * pi())
    swept = disc(second.asked.bore or 1) * drive.stroke * drive.radius
    return _delivered(second, strokes) * swept * turns * (_ends(second) * len(turn.cranks))


# Of a turn under a load, by what was asked for, the turn and the strokes of its load.
_OF_LOAD: Mapping[str, Callable[[SecondComputation, verify.Turn, Sequence[Stroke]], Number]] = {
    "back": lambda _, __, strokes: strokes[0].sides[1][1].value(exactly(0)),
    "work": lambda _, turn, __: turn.known.mean * 2 * pi(),
    "mean_pressure": lambda second, _, strokes: _mean_pressure(second, strokes),
    "mean_pressure_pa": lambda second, _, strokes: _mean_pressure(second, strokes) * _pascals(second),
    "indicated_power": lambda second, turn, _: abs(turn.known.mean) * second.torque(turn) * turn.drive.omega,
    "volumetric_efficiency": lambda _, __, strokes: _sucked(strokes),
    "delivered": lambda second, _, strokes: _delivered(second, strokes),
    "delivery": _delivery,
    "efficiency": _efficiency,
}


def _apart(run: Running) -> Number:
    return run.extreme(True) - run.extreme(False)


_RUNNING: dict[str, Callable[[Running, Degrees], Number]] = {
    "speed": lambda run, at: run.speed(run.turn.known.energy(place_of(at))),
    "speed_min": lambda run, _: run.extreme(False),
    "speed_max": lambda run, _: run.extreme(True),
    "delta_mean": lambda run, _: _apart(run) * 2 / (run.extreme(True) + run.extreme(False)),
    "one_to_mean": lambda run, _: (run.extreme(True) + run.extreme(False)) / (2 * _apart(run)),
    "delta_first": lambda run, _: _apart(run),
    "one_to_first": lambda run, _: 1 / _apart(run),
    "number": lambda run, _: run.times,
}


def of_pressures(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    """Over the stroke or the angle: what presses on the piston, and what the masses take, both per area."""
    drive, key = second.drive(row), key.removesuffix("_pa")
    if "phi" in row:
        # A dead centre is of the stroke that begins there.
        angle = second.degrees(row)
        ends = (
            [exactly(0), exactly(180)] if method == "series" else [drive.dead_degrees(one) for one in (1, -1)]
        )
        index = sum(int((angle % 360 - one).sign() >= 0) for one in ends) - 1 + 2 * int(angle // 360)
        place = FoundAngle(lambda: Place(angle - 180 * (index % 2)))
        share = drive.value("x_stroke", place, method, stroke="return" if index % 2 else None)
        if key == "x_stroke":
            return share
    else:
        index = int(number(row["stroke"])) - 1
        place = _at_share(second, drive, method, row, index % 2 == 1)
        share = Value(lambda: exactly(nearest(row["share"], second.shares)))
    if key == "crank_angle":
        return Value(lambda: place().angle + 180 * index)
    if key == "left_pressure":
        gas, inertia = (
            of_pressures(second, one, method, row) for one in ("gas_pressure", "inertia_pressure")
        )
        return gas - inertia
    if key == "gas_pressure":
        (_, pressure), load = second.unit(), second.load(row)
        return Value(lambda: load()[index % len(load())].force(share.recipe()) * (pressure or 1))
    if key != "inertia_pressure":
        raise ProblemError(f"{key} is not computed a second time")
    heavy, bore = second.bodies(drive, Fraction(0), row), second.asked.bore or 1
    return Value(lambda: -heavy.at("inertia_force", place(), (-1) ** index) / disc(bore))


def of_inertia(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    """Forces of a rod, of two masses at its pins, and of 6/10 and 4/10 of it there."""
    if "force" in row:
        return _of_peak(second, key, row)
    drive = second.drive(row)
    if key == "inertia_arm_mm":
        return of_inertia(second, "inertia_arm", method, row) * (1000 * drive.radius / drive.ratio)
    name = key.removeprefix("inertia_")
    unit = next((one for one in ("_nm", "_n", "_mps2") if key.endswith(one)), "")
    name = name.removesuffix(unit)
    model = next((one for one in ("two_mass", "railway") if name.endswith(one)), "")
    force = _OF_ROD.get(name.removesuffix(f"_{model}").removesuffix(RETURN))
    if force is None or (not unit and "acceleration" in second.options):
        return drive.value(key, second.place(row), method)
    rod = second.rod(drive.rod_length, model, row, unit in ("_n", "_nm"))
    if not unit:
        drive = replace(drive, radius=Fraction(1), speed=Fraction(1), turns=False)
    heavy = replace(verify.bodies(drive, rod=rod, acceleration=second.gain if unit else 0), method=method)
    return heavy.value(f"{force}_n", second.place(row), stroke="return" if RETURN in key else None)


def _of_peak(second: SecondComputation, key: str, row: Row) -> Value:
    """The greatest of a force over the turn and where it is; the same of its errors by other masses, in % of
    the greatest exact one. Of the straight crank half a turn is as the other."""
    drive, name = second.drive(row), row["force"]
    whole = Fraction(360 if drive.offset or drive.rocker else 180)
    at_rest = replace(drive, radius=Fraction(1), speed=Fraction(1), turns=False)
    names = ["pin_x", "pin_y"] if name == "pin" else [_OF_ROD[name]]

    def found(*signed: tuple[str, int]) -> list[Summit]:
        def rod() -> Sequence[Number]:
            rods = [[a * sign for a in second.rod(drive.rod_length, model, row)()] for model, sign in signed]
            return [sum(one, exactly(0)) for one in zip(*rods, strict=True)]

        heavy = verify.bodies(at_rest, rod=rod)

        def square(at: Place, order: int) -> Jet:
            forces = (heavy.course(one, at, 1, order) for one in names)
            return reduce(add, (one * one for one in forces))

        places: list[Summit] = second.once(row, lambda: summits(square, Fraction(0), whole), name, signed)
        return places

    def value(*signed: tuple[str, int]) -> Number:
        return largest([one.value for one in found(*signed)]).root()

    def newtons() -> Number:
        mass = second.rod(drive.rod_length, "", row, True)()[0]
        return drive.omega * drive.omega * (mass * drive.radius ** (2 if name == "torque" else 1))

    itself = row["model"].replace("exact", "").replace("-", "_"), 1
    error = ("", 1), (itself[0], -1)
    known: Mapping[str, Callable[[], Number]] = {
        "greatest": lambda: value(itself),
        "greatest_n": lambda: value(itself) * newtons(),
        "greatest_phi": lambda: where(found(itself)),
        "error": lambda: value(*error),
        "error_percent": lambda: 100 * value(*error) / value(("", 1)),
        "error_phi": lambda: where(found(*error)),
    }
    return Value(known[key])


def of_harmonics(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    """The harmonics of the straight crank: B_k of the acceleration, of which the velocity has 1/k and the
    path -1/k²; by first order B_1 = 1 and B_2 = λ."""
    if key not in ("value", "factor"):
        return _of_wave(second, key, method, row)
    quantity = str(second.options.get("quantity", "p"))
    order = int(number(row["order"])) if row["order"].isdecimal() else 0
    share = {"acceleration": 0, "p": 0, "velocity": 1, "c": 1, "path": 2, "x": 2}.get(quantity)
    if key not in ("value", "factor") or share is None or not order or "offset" in second.options:
        raise ProblemError(f"{key} of such a page is not computed a second time")
    ratio = Fraction(0) if method == "infinite" else second.drive(row).ratio
    by_order = Fraction((-1) ** (share // 2), order**share)
    if method == "series":
        return Value(lambda: exactly({1: Fraction(1), 2: ratio}.get(order, Fraction(0)) * by_order))
    return Value(lambda: harmonics.of_acceleration(ratio, order) * by_order)


def _of_wave(second: SecondComputation, key: str, method: str, row: Row) -> Value:
    """The harmonics of the torque T = P + Σ (a cos kφ + b sin kφ) = P + Σ c cos (kφ + ψ)."""
    turn, order, cylinder = second.turn(method, row), number(row["order"]), row.get("cylinder", "all")
    cranks = turn.cranks if cylinder == "all" else (turn.cranks[int(number(cylinder)) - 1],)
    if key in ("frequency", "omega_k"):
        return Value(lambda: turn.drive.omega * order / (2 * pi() if key == "frequency" else 1))
    if key == "star":
        return Value(lambda: star(cranks, order).size())
    name = key.removesuffix("_nm")
    found = Value(lambda: _WAVE[name](turn.known.harmonic(order, cranks)))
    return found if name == key else Value(lambda: found.recipe() * second.torque(turn))


_WAVE: Mapping[str, Callable[[Arrow], Number]] = {
    "cosine": lambda wave: wave.x,
    "sine": lambda wave: wave.y,
    "amplitude": lambda wave: wave.size(),
    "phase": lambda wave: degrees_of(wave.x, -wave.y),
    "phase_rad": lambda wave: degrees_of(wave.x, -wave.y) * pi() / 180,
}
_ENDS = {"slide": "crosshead_load", "crosshead": "rod_force", "crank": "pin_rod_force"}
_OF_ROD = {
    "guide": "guide_force", "pin": "crank_pin_force", "pin_x": "pin_x", "pin_y": "pin_y", "torque": "torque",
    "resultant": "rod_inertia", "arm": "rod_arm",
    **{
        f"{one}_acceleration{part}": f"{one}_acceleration{part}"
        for one in ("pin", "common", "replaced", "turning", "stretching")
        for part in ("", "_along", "_across")
    },
}  # fmt: skip


def nearest(printed: str, asked: Sequence[Fraction]) -> Fraction:
    """Return what was asked for and is printed so; where nothing was listed, what is printed. Raises
    KurbelError."""
    shown = number(printed)
    half = Fraction(1, 2 * 10 ** len(printed.partition(".")[2]))
    found = {one for one in asked if abs(one - shown) <= half} if asked else {shown}
    found = {shown} if shown in found else found
    if len(found) != 1 or abs(shown) > FARTHEST:
        raise ProblemError(f"{printed[:40]} is not what was asked for")
    return found.pop()


PAGES: Mapping[str, Callable[[SecondComputation, str, str, Row], Value]] = {
    "table": of_drive, "forces": of_drive, "deadcentres": of_dead_centres,
    "turning": of_turn, "delta": of_turn, "pressures": of_pressures, "inertia": of_inertia,
    "harmonics": of_harmonics, "balance": of_harmonics,
}  # fmt: skip
