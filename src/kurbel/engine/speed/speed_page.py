"""The pages of an engine with a given flywheel: its speed over the turn, and how even it is.

The kernel of each quantity takes the run of an engine with its flywheel and where in the turn, as those of
`engine/engine_quantities.py` take a turn. What needs the "turns" has no value of a flywheel without a speed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cache
from typing import TypeAlias

from kurbel.drive.at import known
from kurbel.drive.wheel import SQUARE, Wheel
from kurbel.engine import notes
from kurbel.engine.digits import CellValue, printed
from kurbel.engine.engine_page import IRREGULARITY, TURNING
from kurbel.engine.engine_quantities import EXTREMES, Needs, engine_registry, row
from kurbel.engine.request import EngineRequest
from kurbel.engine.speed.run import Run, run_of
from kurbel.exact.numerals import Label, exact_text
from kurbel.motion.notes import turns_label
from kurbel.page.axes import Place
from kurbel.page.quantity import Column, Of, Quantity, Texts, words
from kurbel.page.table import Note, Value
from kurbel.reading.amounts import amount

OF_SPEED = Texts("engine", "of_speed")

# What these are of: a crank angle under a flywheel, or the whole turn under one.
AT_SPEED, OF_EVENNESS = Of.SPEED, Of.EVENNESS
Listed: TypeAlias = Iterable[tuple[str, Quantity]]


@cache
def speed_registry() -> Mapping[str, Quantity]:
    """Return what stands beside the turning effort, with that itself."""
    effort = (one for one in engine_registry().values() if one.of in (Of.ANGLE, Of.TURN))
    return {one.key: one for one in (*effort, *_speed_entries())}


@cache
def evenness_registry() -> Mapping[str, Quantity]:
    """Return what stands beside the degree of irregularity of an engine, with that itself."""
    turn = (one for one in engine_registry().values() if one.of in (Of.TURN, *EXTREMES))
    return {one.key: one for one in (*turn, *_evenness_entries())}


def _speed_entries() -> Iterator[Quantity]:
    turns = {"needs": (Needs.TURNS,)}
    yield row("speed", "Kurbelgeschwindigkeit|Crank-pin velocity", "$v/v_1$", "", AT_SPEED, 4,
              lambda run, where: run.speed(where.half_turns))  # fmt: skip
    yield row("omega", "Winkelgeschwindigkeit|Angular velocity", "$ω$", "rad/s", AT_SPEED, 3,
              lambda run, where: run.first_omega * run.speed(where.half_turns), **turns)  # fmt: skip
    yield row("rpm", "Drehzahl|Speed", "$n$", '$"min"^(-1)$', AT_SPEED, 2,
              lambda run, where: 30 * run.first_omega * run.speed(where.half_turns) / run.turn.pi,
              **turns)  # fmt: skip
    yield row("angular_acceleration", "Winkelbeschleunigung|Angular acceleration", "$α$", "rad/s²",
              AT_SPEED, 3, lambda run, where: run.acceleration(where.half_turns), **turns)  # fmt: skip
    yield row("time", "Zeit|Time", "$t$", "s", AT_SPEED, 5,
              lambda run, where: run.time(where.half_turns),
              direction=words("$t$ seit dem inneren Totpunkt der ersten Kurbel"
                              "|$t$ since the inner dead centre of the first crank"), **turns)  # fmt: skip


def _evenness_entries() -> Iterator[Quantity]:
    yield row("number", "Schwungradzahl|Number of the flywheel", "$(m_1 v_1^2)/(P r)$", "", OF_EVENNESS,
              None, lambda run, where: run.number, needs=(Needs.INERTIA,))  # fmt: skip
    for index, of, name in (
        ("min", Of.LEAST, "kleinste Geschwindigkeit|Least speed"),
        ("max", Of.GREATEST, "größte Geschwindigkeit|Greatest speed"),
    ):
        greatest = EXTREMES[of]
        de, en = name.split("|")
        yield row(
            f"phi_{index}", f"{de} bei|{en} at", f'$φ_"{index}"$', "°", of, 3,
            lambda run, where, greatest=greatest: 180 * run.extreme_place(greatest), minutes=True,
        )  # fmt: skip
        yield row(
            f"speed_{index}", name, f'$v_"{index}"/v_1$', "", OF_EVENNESS, 4,
            lambda run, where, greatest=greatest: run.extreme_speed(greatest),
        )  # fmt: skip
    for suffix, name, symbol, value in (
        (
            "mean",
            "Ungleichförmigkeitsgrad, auf das Mittel bezogen|Degree of irregularity by the mean speed",
            "δ_m",
            Run.irregularity,
        ),
        (
            "first",
            "Ungleichförmigkeitsgrad nach Weisbach|Degree of irregularity by Weisbach's definition",
            "δ_1",
            Run.first_irregularity,
        ),
    ):
        yield row(f"delta_{suffix}", name, f"${symbol}$", "", OF_EVENNESS, 5,
                  lambda run, where, value=value: value(run))  # fmt: skip
        yield row(f"one_to_{suffix}", name, f"$1/{symbol}$", "", OF_EVENNESS, 1,
                  lambda run, where, value=value: 1 / value(run))  # fmt: skip


@cache
def of_runs() -> frozenset[str]:
    """Return the keys of what is asked of runs, not of turns."""
    return frozenset(one.key for one in (*_speed_entries(), *_evenness_entries()))


def _notes(request: EngineRequest) -> Iterator[Label | Note]:
    """Yield the lines below the table: the law of the speed, the flywheel, the definitions, the engine."""
    lang = request.lang
    methods = dict.fromkeys(method for column in request.page_columns for method in column.methods)
    laws = dict.fromkeys("first_order" if one == "weisbach" else "root" for one in methods)
    heavy, wheel = request.first.crank.moving is not None, known(request.wheel)
    others = {"masses": heavy, "square_law": wheel.resistance == SQUARE}
    own = [law for law, holds in others.items() if holds]
    yield "; ".join([OF_SPEED[law][lang] for law in own or laws])
    yield OF_SPEED["letters"][lang].format(at_radius=notes.at_radius(request))
    if heavy:
        yield OF_SPEED["even"][lang]
    keys = {column.key.rpartition("_")[2] for column in request.page_columns if "_" in column.key}
    yield from (OF_SPEED[f"delta_{one}"][lang] for one in ("mean", "first") if one in keys)
    yield "; ".join(_wheel(request, wheel, lang))
    yield from notes.notes(request)


def _wheel(request: EngineRequest, wheel: Wheel, lang: str) -> Iterator[Label]:
    if wheel.number is not None:
        yield f"$(m_1 v_1^2)/(P r) = {exact_text(wheel.number)}$"
    if wheel.inertia is not None:
        yield f"$J = {amount(wheel.inertia, 'kg m²', exact_text)}$"
    if wheel.speed is not None:
        yield f"{turns_label(wheel.speed)}, {OF_SPEED['mean'][lang]}"
    if wheel.power is not None and wheel.inertia is not None:
        yield f"$N = {amount(wheel.power, 'W', exact_text)}$"
    yield OF_SPEED["constant_driven" if request.driven else wheel.resistance][lang]


def _number(request: EngineRequest, column: Column, place: Place, times: int) -> Value:
    """The printed number at a place, of a run or of its turn."""
    if column.quantity.key not in of_runs():
        return TURNING.number(request, column, place, times)
    turns = [request.turn(place["expansion"], place["ratio"], method) for method in column.methods]
    asked = CellValue(
        column, [run_of(turn, known(request.wheel)) for turn in turns], request.where(place), times
    )
    return printed(asked, request.rounding, request.carded)


def _listed(command: str, registry: Callable[[], Mapping[str, Quantity]]) -> Callable[[], Listed]:
    return lambda: [
        (command + " --speed" * (Needs.TURNS in one.needs), one)
        for key, one in registry().items()
        if key in of_runs()
    ]


SPEED = TURNING._replace(
    key="speed",
    layout="speed",
    command="turning --flywheel 50",
    quantities=speed_registry,
    number=_number,
    notes=_notes,
    of=(),
    listed=_listed("turning --flywheel 50", speed_registry),
)


EVENNESS = IRREGULARITY._replace(
    key="evenness",
    layout="delta-flywheel",
    command="delta --flywheel 50",
    quantities=evenness_registry,
    number=_number,
    notes=_notes,
    of=(),
    listed=_listed("delta --flywheel 50", evenness_registry),
)
