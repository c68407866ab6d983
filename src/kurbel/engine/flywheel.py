"""What a flywheel's page can show: the power and the speed, the energy swing, and the moment of inertia.

A kernel takes the turn and where in it, of which it asks the flywheel.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from kurbel.drive.wheel import Flywheel
from kurbel.engine.cylinder import AnyTurn
from kurbel.kernel import turning
from kurbel.kernel.circle import Number

if TYPE_CHECKING:
    from kurbel.engine.quantities import Where


def mean_torque(turn: AnyTurn, where: Where) -> Any:
    """|P| r in N m: of the power, rational where the speed is given in radians, or of the load."""
    wheel = _flywheel(where)
    if wheel.power is None:
        return abs(turn.mean_force()) * turn.torque_unit()
    turns = wheel.power / wheel.speed.value
    return turn.of(turns / 2) / turn.pi if wheel.speed.turns else turns


def _power(turn: AnyTurn, where: Where) -> Any:
    """The power in W, as it is given or of the steam."""
    power = _flywheel(where).power
    return mean_torque(turn, where) * _number(turn, _speed(turn, where)) if power is None else power


def _turns_a_minute(turn: AnyTurn, where: Where) -> Any:
    """n in 1/min."""
    speed = _flywheel(where).speed
    return 60 * speed.value if speed.turns else turn.of(30 * speed.value) / turn.pi


def _speed(turn: AnyTurn, where: Where) -> Any:
    """ω in 1/s."""
    speed = _flywheel(where).speed
    return turn.of(2 * speed.value) * turn.pi if speed.turns else speed.value


def _swing(turn: AnyTurn, where: Where) -> Number:
    return turning.energy_swing(turn.irregularity(), _number(turn, mean_torque(turn, where)))


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


def _true_inertia(turn: AnyTurn, where: Where) -> Number:
    """J in kg m² with which the speed of the machine with its masses keeps within ω(1 ± δ/2), exactly.

    Where the speed is greatest, the energy of the load less that of the masses at that speed is greatest,
    and least where it is least at that; the inertia of the masses in the dead centre where energies begin
    does not count. Re-derived.
    """
    wheel = _flywheel(where)
    high, low = (turn.at_speed(1 + sign * wheel.irregularity / 2) for sign in (1, -1))
    swing = high.extreme(greatest=True).energy - low.extreme(greatest=False).energy
    moment, speed = _number(turn, turn.torque_unit()), _number(turn, _speed(turn, where))
    beyond = turning.moment_of_inertia(swing * moment, turn.of(wheel.irregularity), speed)
    return beyond - 2 * turn.kinetic_energy_begun() * moment / (speed * speed)


_SWING = "Arbeitsüberschuss|Energy swing"
ENTRIES: tuple[tuple[str, str, str, str, int | None, Callable[..., Any], str], ...] = (
    ("power", "Leistung|Power", "$N$", "W", None, _power, ""),
    ("speed", "Drehzahl|Speed", "$n$", '$"min"^(-1)$', None, _turns_a_minute, ""),
    ("omega", "Winkelgeschwindigkeit|Angular velocity", "$ω$", "rad/s", None, _speed, ""),
    ("mean_torque", "mittleres Drehmoment|Mean torque", "$P r$", "N m", None, mean_torque, ""),
    ("swing_share", _SWING, "$(ΔW)/(P r)$", "", 4, lambda turn, where: turn.irregularity(), ""),
    ("swing", _SWING, "$ΔW$", "J", None, _swing, ""),
    ("inertia", "Trägheitsmoment|Moment of inertia", "$J$", "kg m²", None, _inertia, ""),
    (
        "inertia_true",
        "Trägheitsmoment, Massen bei wahrer Geschwindigkeit|Moment of inertia, masses at their true speed",
        "$J_δ$", "kg m²", None, _true_inertia, "masses",
    ),
    ("mass", "Schwungmasse am Halbmesser|Mass at the radius", "$J/ρ^2$", "kg", None, _mass, "radius"),
)  # fmt: skip
