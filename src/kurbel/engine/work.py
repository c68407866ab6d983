"""The work that a load does in a turn, and what follows from it: mean pressure, power, volume, the flywheel.

Of a driven machine the work is negative, for the shaft does it; mean pressures and powers are positive. A
kernel takes the turn and where in it, of which those of flywheels ask the flywheel.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.drive.at import known
from kurbel.kernel import forces

if TYPE_CHECKING:
    from kurbel.engine.cylinder import AnyTurn, TurnPlace
    from kurbel.engine.engine import Engine
    from kurbel.exact.kind import Kind
    from kurbel.kernel.circle import Numeric
    from kurbel.kernel.steam import Expansion


def work(turn: AnyTurn, where: TurnPlace) -> Numeric:
    """Return the work of all cylinders in a turn, in Q R, positive as done on the cranks."""
    return 2 * turn.pi * turn.indicated_force()


def mean_pressure(turn: AnyTurn, where: TurnPlace) -> Numeric:
    """Return the mean pressure of an end of a cylinder that works, in units of the pressure that Q is of."""
    return abs(mean_pressure_of(turn.part, turn.cylinder.kind))


def power(turn: AnyTurn, where: TurnPlace) -> Numeric:
    """Return the indicated power of all cylinders in Q R ω, positive."""
    return abs(turn.indicated_force())


def kilowatts(turn: AnyTurn) -> Numeric:
    """Return Q R ω in kW."""
    return turn.torque_unit() * known(turn.engine.crank.speed).omega(turn) / 1000


def kilopascals(turn: AnyTurn) -> Numeric:
    """Return the pressure that Q is of, in kPa."""
    return turn.of(known(turn.part.pressure) / 1000)


def flow(turn: AnyTurn, where: TurnPlace) -> Numeric:
    """Return what all cylinders deliver in m³/min, in the state of suction."""
    engine, speed = turn.part, known(turn.engine.crank.speed)
    bore, radius = known(engine.load).bore, known(engine.crank.radius)
    # π/4 d² times the stroke, both 2 R long and counted in R.
    swept = turn.of(bore**2 / 4 * radius) * turn.pi * turn.cylinder.drive.length
    strokes = turn.of(ends(engine) * len(engine.starts) * 60 * speed.value)
    turns = strokes if speed.turns else strokes / (2 * turn.pi)
    return of_load("delivered", turn, where) * swept * turns


def of_load(name: str, turn: AnyTurn, where: TurnPlace) -> Numeric:
    """Return what the load has by a name: the volumetric efficiency of a compressor, the share of its heat
    that an ideal gas cycle makes work."""
    found: Numeric = getattr(turn.part.steam, name)(turn.cylinder.kind)
    return found


def ends(engine: Engine) -> Fraction:
    """Return how many ends of a cylinder work in a turn."""
    return Fraction(4 if engine.double else 2, getattr(engine.steam, "strokes_of_cycle", 2))


def mean_pressure_of(engine: Engine, kind: Kind) -> Numeric:
    """Return the mean pressure in each end of a cylinder that works, on a kind of number; negative where the
    shaft drives the piston."""
    strokes = engine.steam.strokes(kind, engine.double)
    cycle: Numeric = sum(one.work(kind.of(Fraction(1))) for one in strokes)
    return cycle * kind.of(2 / (len(strokes) * ends(engine)))


def stage_work(key: str, turn: AnyTurn, where: TurnPlace) -> Numeric:
    """Return the work of a stage in Q R, a fraction where it is rational; A₁ + A₂ - A₃ is that of a stroke.

    A₁ = 2/ε, A₂ = 2 ln ε/ε, A₃ = 2 b of a straight crank by Mariotte's law. Source: Weisbach-Herrmann,
    § 150; the exponent, the clearance and other strokes than 2 R are ours.
    """
    kind, steam = turn.cylinder.kind, turn.part.ideal
    length = turn.cylinder.drive.length
    exact = isinstance(length, int) and steam.exponent.denominator == 1
    rational = exact and (key != "expansion_work" or steam.exponent != 1)
    numbers = steam.numbers(*((_itself, _itself) if rational else (kind.of, kind.exponent)))
    return length * _STAGES[key](numbers, Fraction(1) if rational else kind.of(Fraction(1)))


def _itself(value: Fraction) -> Fraction:
    return value


_STAGES: dict[str, Callable[[Expansion, Numeric], Numeric]] = {
    "full_pressure_work": lambda steam, whole: steam.cut_off * whole,
    "expansion_work": lambda steam, whole: steam.work(whole) - steam.cut_off * whole,
    "back_work": lambda steam, whole: steam.back * whole,
}


def mean_torque(turn: AnyTurn, where: TurnPlace) -> Numeric:
    """|P| r in N m: of the power, rational where the speed is given in radians, or of the load."""
    wheel = known(where.flywheel)
    if wheel.power is None:
        return abs(turn.mean_force()) * turn.torque_unit()
    turns = wheel.power / wheel.speed.value
    return turn.of(turns / 2) / turn.pi if wheel.speed.turns else turns


def power_of(turn: AnyTurn, where: TurnPlace) -> Numeric:
    """The power in W, as it is given or of the steam."""
    given = known(where.flywheel).power
    return mean_torque(turn, where) * _number(turn, speed(turn, where)) if given is None else given


def turns_a_minute(turn: AnyTurn, where: TurnPlace) -> Numeric:
    """n in 1/min."""
    given = known(where.flywheel).speed
    return 60 * given.value if given.turns else turn.of(30 * given.value) / turn.pi


def speed(turn: AnyTurn, where: TurnPlace) -> Numeric:
    """ω in 1/s."""
    given = known(where.flywheel).speed
    return given.omega(turn) if given.turns else given.value


def swing(turn: AnyTurn, where: TurnPlace) -> Numeric:
    return forces.energy_swing(turn.irregularity(), _number(turn, mean_torque(turn, where)))


def inertia(turn: AnyTurn, where: TurnPlace) -> Numeric:
    irregularity = turn.of(known(where.flywheel).irregularity)
    return forces.moment_of_inertia(swing(turn, where), irregularity, _number(turn, speed(turn, where)))


def mass(turn: AnyTurn, where: TurnPlace) -> Numeric:
    radius = known(known(where.flywheel).radius)
    return inertia(turn, where) / turn.of(radius * radius)


def _number(turn: AnyTurn, value: Numeric) -> Numeric:
    return turn.of(value) if isinstance(value, Fraction) else value


def true_inertia(turn: AnyTurn, where: TurnPlace) -> Numeric:
    """J in kg m² with which the speed of the machine with its masses keeps within ω(1 ± δ/2), exactly.

    Where the speed is greatest, the energy of the load less that of the masses at that speed is greatest,
    and least where it is least at that; the inertia of the masses in the dead centre where energies begin
    does not count. Re-derived.
    """
    wheel = known(where.flywheel)
    high, low = (turn.at_speed(1 + sign * wheel.irregularity / 2) for sign in (1, -1))
    swung = high.extreme(greatest=True).energy - low.extreme(greatest=False).energy
    moment, omega = _number(turn, turn.torque_unit()), _number(turn, speed(turn, where))
    beyond = forces.moment_of_inertia(swung * moment, turn.of(wheel.irregularity), omega)
    return beyond - 2 * turn.kinetic_energy_begun() * moment / (omega * omega)
