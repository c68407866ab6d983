"""The work that a load does, and what follows from it: mean pressure, indicated power, delivered volume.

Of a driven machine the work is negative, for the shaft does it; mean pressures and powers are positive.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from typing import Any

from kurbel.engine.cylinder import AnyTurn
from kurbel.engine.engine import Engine
from kurbel.engine.loads import stages
from kurbel.exact.kind import Kind
from kurbel.kernel.circle import Number
from kurbel.page.quantity import Quantity, words


def work(turn: AnyTurn, where: Any) -> Number:
    """Return the work of all cylinders in a turn, in Q R, positive as done on the cranks."""
    return (
        2 * turn.pi * turn.indicated_force()
        if len(turn.engine.parts) > 1
        else _on_areas(turn.engine.parts[0], _own(turn))
    )


def mean_pressure(turn: AnyTurn, where: Any) -> Number:
    """Return the mean pressure of an end of a cylinder that works, in units of the pressure that Q is of."""
    return abs(_mean_pressure(turn.engine.parts[0], _own(turn)))


def power(turn: AnyTurn, where: Any) -> Number:
    """Return the indicated power of all cylinders in Q R ω, positive."""
    return abs(turn.indicated_force())


def kilowatts(turn: AnyTurn) -> Number:
    """Return Q R ω in kW."""
    speed = turn.engine.crank.speed
    assert speed is not None
    return turn.torque_unit() * _angular(turn, speed.value, speed.turns) / 1000


def kilopascals(turn: AnyTurn) -> Number:
    """Return the pressure that Q is of, in kPa."""
    return turn.of(_pressure(turn.engine.parts[0]) / 1000)


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


def ends(engine: Engine) -> Fraction:
    """Return how many ends of a cylinder work in a turn."""
    return Fraction(4 if engine.double else 2, getattr(engine.steam, "strokes_of_cycle", 2))


def _pressure(engine: Engine) -> Fraction:
    assert engine.pressure is not None
    return engine.pressure


def _own(turn: AnyTurn) -> tuple[Kind, Number]:
    """The kind of number of a turn, and the length of the stroke in R."""
    return turn.cylinder.kind, turn.cylinder.drive.length


def _work(engine: Engine, own: tuple[Kind, Any]) -> Any:
    kind, length = own
    strokes = engine.steam.strokes(kind, engine.double)
    cycle = sum(one.work(kind.of(Fraction(1))) for one in strokes)
    return cycle * length * kind.of(Fraction(2 * len(engine.starts), len(strokes)))


def _on_areas(engine: Engine, own: tuple[Kind, Any]) -> Any:
    """The same on the piston's areas: in each end the load does as much as on the bore's, less the rod's."""
    effort, whole = engine.crank.effort, _work(engine, own)
    if effort is None or effort.areas is None:
        return whole
    return whole * own[0].of((effort.areas.head + effort.areas.crank) / 2)


def _mean_pressure(engine: Engine, own: tuple[Kind, Any]) -> Any:
    kind, _ = own
    return _work(engine, (kind, 1)) / kind.of(ends(engine) * len(engine.starts))


def mean_pressure_of(engine: Engine, kind: Kind) -> Any:
    """Return the mean pressure in each end of a cylinder that works, on a kind of number; negative where the
    shaft drives the piston."""
    return _mean_pressure(engine, (kind, 1))


def _angular(turn: AnyTurn, value: Fraction, turns: bool) -> Number:
    return turn.of(2 * value) * turn.pi if turns else turn.of(value)


def entries(entry: Callable[..., Quantity]) -> Iterator[Quantity]:
    """Yield the quantities of all this, each made by a function of key, name, symbol, unit and so on."""
    yield entry("work", "Arbeit einer Umdrehung|Work of a turn", "$A$", "$Q r$", "turn", 4, work)  # fmt: skip
    for key, name, letter in stages.NAMES:
        yield entry(key, name, letter, "$Q r$", "turn", None, partial(stages.work, key), needs="steam")
    per_area = "$Q$ je Kolbenfläche|$Q$ per piston area"
    heading = "|".join(f"$p_m$ in {unit}" for unit in per_area.split("|"))
    mean = entry("mean_pressure", "mittlerer Druck|Mean pressure", "$p_m$", per_area, "turn", 4,
                  mean_pressure, heading=heading)  # fmt: skip
    yield mean
    yield mean._replace(
        key="mean_pressure_kpa", unit=words("kPa"), decimals=1, heading=words("$p_m$ in kPa"),
        scale=kilopascals, needs="load",
    )  # fmt: skip
    yield entry("indicated_power", "indizierte Leistung|Indicated power", "$N_i$", "kW", "turn", None,
                 power, scale=kilowatts, needs="power")  # fmt: skip
    yield entry("volumetric_efficiency", "volumetrischer Wirkungsgrad|Volumetric efficiency", "$η_v$", "",
                 "turn", 4, volumetric_efficiency, needs="compressor")  # fmt: skip
    yield entry("delivered", "Fördervolumen|Delivered volume", "$V/V_h$", "", "turn", 4,
                 delivered, needs="compressor")  # fmt: skip
    yield entry("delivery", "Fördermenge|Delivery", "$V$", "m³/min", "turn", None, flow,
                 needs="flow")  # fmt: skip
    yield entry("efficiency", "idealer Wirkungsgrad|Ideal efficiency", "$η$", "", "turn", 4,
                 efficiency, needs="heat")  # fmt: skip
