"""What a table of an engine can show: each quantity with its symbol, unit and evaluation.

Each is a number of a turn: of a stroke of it, of the whole turn, at a crank angle, or of a flywheel.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple, Protocol

from kurbel.drive.crank_forces import CRANK_FORCES, CrankForce
from kurbel.drive.flywheel import Flywheel
from kurbel.exact.numerals import Label
from kurbel.kernel import turning
from kurbel.kernel.kinds import Number

# The spans of a turn that have extremes of their own.
OUTSTROKE, RETURN_STROKE, WHOLE = 0, 1, None
SPANS: Mapping[int | None, tuple[str, Mapping[str, str]]] = {
    OUTSTROKE: ("outstroke", {"de": "Hingang", "en": "Outstroke"}),
    RETURN_STROKE: ("return", {"de": "Rückgang", "en": "Return"}),
    WHOLE: ("turn", {"de": "Umdrehung", "en": "Whole turn"}),
}


class Peak(NamedTuple):
    """Where the speed is least or greatest, in half turns, and its excess energy there, in Q R."""

    place: Number
    energy: Number


class AnyTurn(Protocol):
    """A turn of an engine, in balls or, of an indicator card, in floats with an error."""

    @property
    def pi(self) -> Number: ...
    def of(self, value: Fraction) -> Number: ...
    def mean_force(self) -> Number: ...
    def irregularity(self) -> Number: ...
    def extreme(self, greatest: bool, stroke: int | None = None) -> Peak: ...
    def tangential_force(self, half_turns: Fraction) -> Number: ...
    def crank_force(self, force: CrankForce, half_turns: Fraction) -> Number: ...
    def force_unit(self) -> Number: ...
    def radius(self) -> Number: ...
    def energy_at(self, half_turns: Fraction) -> Number: ...


class Where(NamedTuple):
    """What a quantity is asked for: a span of the turn, a crank angle in half turns, a flywheel."""

    stroke: int | None = WHOLE
    half_turns: Fraction = Fraction(0)
    flywheel: Flywheel | None = None


# What is of a crank angle has no least and no greatest place.
AT_ANGLE = ("angle", "crank")
# Which command prints the quantities of a scope.
COMMANDS_OF = {
    "turn": "delta",
    "span": "delta",
    "stroke": "delta --detail",
    "angle": "turning",
    "crank": "forces",
    "flywheel": "flywheel",
}
Value = Callable[[AnyTurn, Where], Any]


class EngineQuantity(NamedTuple):
    """An entry of the registry. `scope` says of what it is: turn, stroke, span (both), angle (of
    all cranks), crank (the first one, at an angle) or flywheel.

    `arc` is an angle in degrees, printed in degrees and minutes; `decimals` None prints five figures. `needs`
    names what must be known: an ideal card, "steam", or the "radius" of the flywheel. `greatest` is True for
    the greatest and False for the least speed. The value is a number of the turn's kind or, where it is
    rational, a fraction.
    """

    key: str
    name: Mapping[str, str]
    symbol: Label
    unit: Label
    scope: str
    decimals: int | None
    value: Value
    arc: bool = False
    needs: str = ""
    greatest: bool | None = None

    def applies(self, where: Where) -> bool:
        if self.scope == "stroke":
            return where.stroke is not WHOLE
        return where.stroke is WHOLE or self.scope == "span"


# What makes newtons of a force in Q, and newton metres of its moment about the shaft.
SCALES: Mapping[str, Callable[[AnyTurn], Number]] = {
    "N": lambda turn: turn.force_unit(),
    "N m": lambda turn: turn.force_unit() * turn.radius(),
}


def _force(key: str, unit: str = "") -> Value:
    def value(turn: AnyTurn, where: Where) -> Number:
        force = turn.crank_force(CRANK_FORCES[key], where.half_turns)
        return force * SCALES[unit](turn) if unit else force

    return value


def _degrees(half_turns: Number) -> Number:
    return 180 * half_turns


def _mean_torque(turn: AnyTurn, where: Where) -> Any:
    """P r in N m: of the power, rational where the speed is given in radians, or of the steam."""
    wheel = _flywheel(where)
    if wheel.power is None:
        return turn.mean_force() * SCALES["N m"](turn)
    turns = wheel.power / wheel.speed.value
    return turn.of(turns / 2) / turn.pi if wheel.speed.turns else turns


def _power(turn: AnyTurn, where: Where) -> Any:
    """The power in W, as it is given or of the steam."""
    power = _flywheel(where).power
    return _mean_torque(turn, where) * _number(turn, _speed(turn, where)) if power is None else power


def _turns_a_minute(turn: AnyTurn, where: Where) -> Any:
    """n in 1/min."""
    speed = _flywheel(where).speed
    return 60 * speed.value if speed.turns else turn.of(30 * speed.value) / turn.pi


def _speed(turn: AnyTurn, where: Where) -> Any:
    """ω in 1/s."""
    speed = _flywheel(where).speed
    return turn.of(2 * speed.value) * turn.pi if speed.turns else speed.value


def _swing(turn: AnyTurn, where: Where) -> Number:
    return turning.energy_swing(turn.irregularity(), _number(turn, _mean_torque(turn, where)))


def _inertia(turn: AnyTurn, where: Where) -> Number:
    irregularity = turn.of(_flywheel(where).irregularity)
    return turning.moment_of_inertia(_swing(turn, where), irregularity, _number(turn, _speed(turn, where)))


def _mass(turn: AnyTurn, where: Where) -> Number:
    radius = _flywheel(where).radius
    assert radius is not None
    return _inertia(turn, where) / turn.of(radius * radius)


def _number(turn: AnyTurn, value: Any) -> Number:
    return turn.of(value) if isinstance(value, Fraction) else value


def _flywheel(where: Where) -> Flywheel:
    assert where.flywheel is not None
    return where.flywheel


_QR = "$(Q r)/(m_1 v_1^2)$"
_ROWS: tuple[tuple[Any, ...], ...] = (
    ("delta", "Ungleichförmigkeitsgrad|Degree of irregularity", "$δ$", "$(P r)/(m_1 v_1^2)$", "turn", 3,
     lambda turn, where: turn.irregularity()),
    ("mean_force", "mittlere Umfangskraft|Mean tangential force", "$P$", "$Q$", "turn", 5,
     lambda turn, where: turn.mean_force()),
    ("back", "Gegendruck|Back pressure", "$R_b$", "$Q$", "turn", 4, lambda turn, where: turn.back(),
     False, "steam"),
    ("exponent", "Exponent der Expansion|Exponent of the expansion", "$n$", "", "turn", None,
     lambda turn, where: turn.engine.ideal.exponent, False, "steam"),
    ("clearance", "schädlicher Raum|Clearance", "$κ$", "", "turn", None,
     lambda turn, where: turn.engine.ideal.clearance, False, "steam"),
    ("alpha_cutoff", "Absperrung bei|Cut-off at", "$α_ε$", "°", "stroke", 3,
     lambda turn, where: _degrees(turn.cut_off(where.stroke)), True, "steam"),
    ("alpha_min", "kleinste Geschwindigkeit bei|Least speed at", "$α_1$", "°", "span", 3,
     lambda turn, where: _degrees(turn.extreme(False, where.stroke).place), True, "", False),
    ("v_min", "kleinste Geschwindigkeit|Least speed", '$v_"min"/v_1 - 1$', _QR, "span", 4,
     lambda turn, where: turn.extreme(False, where.stroke).energy, False, "", False),
    ("alpha_max", "größte Geschwindigkeit bei|Greatest speed at", "$α_2$", "°", "span", 3,
     lambda turn, where: _degrees(turn.extreme(True, where.stroke).place), True, "", True),
    ("v_max", "größte Geschwindigkeit|Greatest speed", '$v_"max"/v_1 - 1$', _QR, "span", 4,
     lambda turn, where: turn.extreme(True, where.stroke).energy, False, "", True),
    ("tangential", "Tangentialkraft|Tangential force", "$T$", "$Q$", "angle", 4,
     lambda turn, where: turn.tangential_force(where.half_turns)),
    ("tangential_excess", "Überschuss über die mittlere|Excess over the mean", "$T - P$", "$Q$", "angle", 4,
     lambda turn, where: turn.tangential_force(where.half_turns) - turn.mean_force()),
    ("energy", "Überschussarbeit|Excess energy", "$W$", "$Q r$", "angle", 4,
     lambda turn, where: turn.energy_at(where.half_turns)),
    ("power", "Leistung|Power", "$N$", "W", "flywheel", None, _power),
    ("speed", "Drehzahl|Speed", "$n$", '$"min"^(-1)$', "flywheel", None, _turns_a_minute),
    ("omega", "Winkelgeschwindigkeit|Angular velocity", "$ω$", "rad/s", "flywheel", None, _speed),
    ("mean_torque", "mittleres Drehmoment|Mean torque", "$P r$", "N m", "flywheel", None, _mean_torque),
    ("swing_share", "Arbeitsüberschuss|Energy swing", "$(ΔW)/(P r)$", "", "flywheel", 4,
     lambda turn, where: turn.irregularity()),
    ("swing", "Arbeitsüberschuss|Energy swing", "$ΔW$", "J", "flywheel", None, _swing),
    ("inertia", "Trägheitsmoment|Moment of inertia", "$J$", "kg m²", "flywheel", None, _inertia),
    ("mass", "Schwungmasse am Halbmesser|Mass at the radius", "$J/ρ^2$", "kg", "flywheel", None, _mass,
     False, "radius"),
)  # fmt: skip


@cache
def engine_registry() -> Mapping[str, EngineQuantity]:
    """Return every quantity by its key, in the order in which `kurbel quantities` lists them."""
    entries = {}
    for key, name, *rest in _ROWS:
        de, en = name.split("|")
        entries[key] = EngineQuantity(key, {"de": de, "en": en}, *rest)
    return entries | {entry.key: entry for entry in _force_entries()}


_FORCE_NAMES = {
    "piston_force": ("Kolbenkraft|Piston force", "F"),
    "rod_force": ("Stangenkraft|Rod force", "S"),
    "guide_force": ("Führungsdruck|Guide force", "N"),
    "crosshead_pin_force": ("Kraft am Kreuzkopfzapfen|Crosshead-pin force", "B"),
    "crank_pin_force": ("Kraft am Kurbelzapfen|Crank-pin force", "K"),
    "tangential_force": ("Tangentialkraft|Tangential force", "T"),
    "radial_force": ("Radialkraft|Radial force", "Z"),
    "bearing_along": ("Lagerkraft längs|Bearing force along", "H_x"),
    "bearing_across": ("Lagerkraft quer|Bearing force across", "H_y"),
    "bearing_force": ("Lagerkraft|Bearing force", "H"),
}


def _force_entries() -> Iterator[EngineQuantity]:
    for key, (name, letter) in _FORCE_NAMES.items():
        de, en = name.split("|")
        names, symbol = {"de": de, "en": en}, f"${letter}$"
        yield EngineQuantity(key, names, symbol, "$Q$", "crank", 4, _force(key))
        yield EngineQuantity(f"{key}_n", names, symbol, "N", "crank", 1, _force(key, "N"), needs="load")
    names = {"de": "Drehmoment", "en": "Torque"}
    yield EngineQuantity("torque_nm", names, "$M_d$", "N m", "angle", 1, _torque, needs="torque")


def _torque(turn: AnyTurn, where: Where) -> Number:
    """The torque of all cranks on the shaft."""
    return turn.tangential_force(where.half_turns) * SCALES["N m"](turn)
