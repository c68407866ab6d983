"""What pages show of the speed over the turn: at a crank angle, and how even it is over the whole turn.

The kernel of each takes the run of an engine with its flywheel and where in the turn, as those of
`engine/quantities.py` take a turn. What needs the "turns" has no value of a flywheel without a speed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache
from typing import Any

from kurbel.engine.quantities import ENGINE_METHODS, EXTREMES, engine_registry
from kurbel.engine.speed.run import Run
from kurbel.exact.numerals import Label
from kurbel.kernel.circle import Number
from kurbel.page.quantity import Formula, Quantity, entry, words

# What these are of: a crank angle under a flywheel, or the whole turn under one.
AT_SPEED, EVENNESS = "speed", "evenness"


@cache
def speed_registry() -> Mapping[str, Quantity]:
    """Return what stands beside the turning effort, with that itself."""
    effort = (one for one in engine_registry().values() if one.of in ("angle", "turn"))
    return {one.key: one for one in (*effort, *_speed_entries())}


@cache
def evenness_registry() -> Mapping[str, Quantity]:
    """Return what stands beside the degree of irregularity of an engine, with that itself."""
    turn = (one for one in engine_registry().values() if one.of in ("turn", *EXTREMES))
    return {one.key: one for one in (*turn, *_evenness_entries())}


def _entry(
    key: str, name: str, symbol: Label, unit: Label, of: str, decimals: int | None,
    kernel: Callable[..., Number], **rest: Any,
) -> Quantity:  # fmt: skip
    formulas = dict.fromkeys(ENGINE_METHODS, Formula(kernel))
    return entry(key, name, symbol, unit, decimals, formulas, spanners=(words(name),), of=of, **rest)


def _speed_entries() -> Iterator[Quantity]:
    turns = {"needs": "turns"}
    yield _entry("speed", "Kurbelgeschwindigkeit|Crank-pin velocity", "$v/v_1$", "", AT_SPEED, 4,
                 lambda run, where: run.speed(where.half_turns))  # fmt: skip
    yield _entry("omega", "Winkelgeschwindigkeit|Angular velocity", "$ω$", "rad/s", AT_SPEED, 3,
                 lambda run, where: run.first_omega * run.speed(where.half_turns), **turns)  # fmt: skip
    yield _entry("rpm", "Drehzahl|Speed", "$n$", '$"min"^(-1)$', AT_SPEED, 2,
                 lambda run, where: 30 * run.first_omega * run.speed(where.half_turns) / run.turn.pi,
                 **turns)  # fmt: skip
    yield _entry("time", "Zeit|Time", "$t$", "s", AT_SPEED, 5,
                 lambda run, where: run.time(where.half_turns),
                 direction=words("$t$ seit dem inneren Totpunkt der ersten Kurbel"
                                 "|$t$ since the inner dead centre of the first crank"), **turns)  # fmt: skip


def _evenness_entries() -> Iterator[Quantity]:
    yield _entry("number", "Schwungradzahl|Number of the flywheel", "$(m_1 v_1^2)/(P r)$", "", EVENNESS, None,
                 lambda run, where: run.number, needs="inertia")  # fmt: skip
    for index, of, name in (
        ("min", "least", "kleinste Geschwindigkeit|Least speed"),
        ("max", "greatest", "größte Geschwindigkeit|Greatest speed"),
    ):
        greatest = EXTREMES[of]
        de, en = name.split("|")
        yield _entry(
            f"phi_{index}", f"{de} bei|{en} at", f'$φ_"{index}"$', "°", of, 3,
            lambda run, where, greatest=greatest: 180 * run.extreme_place(greatest), minutes=True,
        )  # fmt: skip
        yield _entry(
            f"speed_{index}", name, f'$v_"{index}"/v_1$', "", EVENNESS, 4,
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
        yield _entry(f"delta_{suffix}", name, f"${symbol}$", "", EVENNESS, 5,
                     lambda run, where, value=value: value(run))  # fmt: skip
        yield _entry(f"one_to_{suffix}", name, f"$1/{symbol}$", "", EVENNESS, 1,
                     lambda run, where, value=value: 1 / value(run))  # fmt: skip


@cache
def of_runs() -> frozenset[str]:
    """Return the keys of what is asked of runs, not of turns."""
    return frozenset(one.key for one in (*_speed_entries(), *_evenness_entries()))
