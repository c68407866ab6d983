"""The work that a load does, and what follows from it: mean pressure, indicated power, delivered volume.

Of a driven machine the work is negative, for the shaft does it; mean pressures and powers are positive.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import inf
from typing import Any

from kurbel.drive.load import CARD, STEAM
from kurbel.engine.cylinder import AnyTurn
from kurbel.engine.engine import Engine
from kurbel.exact.certify import NEVER_TIES, TieBits
from kurbel.exact.kind import Kind, bounds
from kurbel.kernel.circle import Number


def work(turn: AnyTurn, where: Any) -> Number:
    """Return the work of all cylinders in a turn, in Q R, positive as done on the cranks."""
    return (
        2 * turn.pi * turn.mean_force()
        if len(turn.engine.parts) > 1
        else _work(turn.engine.parts[0], _own(turn))
    )


def mean_pressure(turn: AnyTurn, where: Any) -> Number:
    """Return the mean pressure of an end of a cylinder that works, in units of the pressure that Q is of."""
    return abs(_mean_pressure(turn.engine.parts[0], _own(turn)))


def power(turn: AnyTurn, where: Any) -> Number:
    """Return the indicated power of all cylinders in Q R ω, positive."""
    return abs(turn.mean_force())


def kilowatts(turn: AnyTurn) -> Number:
    """Return Q R ω in kW."""
    speed = turn.engine.crank.speed
    assert speed is not None
    return turn.torque_unit() * _angular(turn, speed.value, speed.turns) / 1000


def kilopascals(turn: AnyTurn) -> Number:
    """Return the pressure that Q is of, in kPa."""
    pressure = turn.engine.pressure
    assert pressure is not None
    return turn.of(pressure / 1000)


def volumetric_efficiency(turn: AnyTurn, where: Any) -> Number:
    """Return the share of the stroke on which a compressor sucks air."""
    load: Any = turn.engine.steam
    return load.volumetric_efficiency(turn.cylinder.kind)


def delivered(turn: AnyTurn, where: Any) -> Number:
    """Return the volume that a stroke delivers, in the state of suction, as a share of the swept one."""
    load: Any = turn.engine.steam
    return load.delivered(turn.cylinder.kind)


def flow(turn: AnyTurn, where: Any) -> Number:
    """Return what all cylinders deliver in m³/min, in the state of suction."""
    engine, speed = turn.engine.parts[0], turn.engine.crank.speed
    assert engine.load is not None
    assert engine.crank.radius is not None
    assert speed is not None
    # π/4 d² times the stroke, both 2 R long and counted in R.
    swept = turn.of(engine.load.bore**2 / 4 * engine.crank.radius) * turn.pi * turn.cylinder.drive.length
    strokes = turn.of(ends(engine) * len(engine.starts) * 60 * speed.value)
    turns = strokes if speed.turns else strokes / (2 * turn.pi)
    return delivered(turn, where) * swept * turns


def efficiency(turn: AnyTurn, where: Any) -> Number:
    """Return the share of the heat that becomes work in an ideal gas cycle."""
    load: Any = turn.engine.steam
    return load.efficiency(turn.cylinder.kind)


def work_ties(turn: AnyTurn, half_turns: Fraction) -> TieBits | None:
    """Return how near the work of a turn can come to a boundary."""
    return _ties(turn, _work)


def mean_pressure_ties(turn: AnyTurn, half_turns: Fraction) -> TieBits | None:
    """Return the same of the mean pressure."""
    return _ties(turn, _mean_pressure)


def load_ties(name: str, turn: AnyTurn, half_turns: Fraction) -> TieBits:
    """Return the same of an algebraic value that a load has by itself."""
    value = getattr(turn.engine.steam, name)(bounds())
    return lambda boundary: float((value - _bound(boundary)).bits())


def ends(engine: Engine) -> Fraction:
    """Return how many ends of a cylinder work in a turn."""
    return Fraction(4 if engine.double else 2, getattr(engine.steam, "strokes_of_cycle", 2))


def _own(turn: AnyTurn) -> tuple[Kind, Number]:
    """The kind of number of a turn, and the length of the stroke in R."""
    return turn.cylinder.kind, turn.cylinder.drive.length


def _work(engine: Engine, own: tuple[Kind, Any]) -> Any:
    kind, length = own
    strokes = engine.steam.strokes(kind, engine.double)
    cycle = sum(one.work(kind.of(Fraction(1))) for one in strokes)
    return cycle * length * kind.of(Fraction(2 * len(engine.starts), len(strokes)))


def _mean_pressure(engine: Engine, own: tuple[Kind, Any]) -> Any:
    kind, _ = own
    return _work(engine, (kind, 1)) / kind.of(ends(engine) * len(engine.starts))


def _ties(turn: AnyTurn, value: Callable[[Engine, tuple[Kind, Any]], Any]) -> TieBits | None:
    engine = turn.engine.parts[0]
    if len(turn.engine.parts) > 1 or engine.steam.name == CARD:
        return NEVER_TIES
    if not _algebraic(engine.steam):
        return lambda boundary: inf
    on = bounds()
    if not turn.cylinder.drive.algebraic:
        return NEVER_TIES
    length = engine.drive.moved(on, turn.method).length
    return lambda boundary: float((value(engine, (on, length)) - _bound(boundary)).bits())


def _algebraic(load: Any) -> bool:
    """Whether the work has no logarithm; a logarithm of a ratio other than 1 leaves it transcendental."""
    exponents = [getattr(load, name, None) for name in ("exponent", "expansion_exponent")]
    return 1 not in exponents or (load.name == STEAM and load.expansion == 1)


def _bound(boundary: Fraction) -> Any:
    return bounds().of(boundary)


def _angular(turn: AnyTurn, value: Fraction, turns: bool) -> Number:
    return turn.of(2 * value) * turn.pi if turns else turn.of(value)
