"""The pages of an engine with a given flywheel: its speed over the turn, and how even it is."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TypeAlias

from kurbel.engine.digits import Asked, error_number, estimate, estimated, settled
from kurbel.engine.page import ERROR, IRREGULARITY, TURNING
from kurbel.engine.request import EngineRequest
from kurbel.engine.speed.captions import notes
from kurbel.engine.speed.quantities import evenness_registry, of_runs, speed_registry
from kurbel.engine.speed.run import run_of
from kurbel.page.axes import Place
from kurbel.page.quantity import Column, Quantity
from kurbel.page.table import Value

Listed: TypeAlias = Iterable[tuple[str, Quantity]]


def _number(request: EngineRequest, column: Column, place: Place, times: int) -> Value:
    """The printed number at a place, of a run or of its turn."""
    if column.quantity.key not in of_runs():
        return TURNING.number(request, column, place, times)
    assert request.wheel is not None
    turns = [request.turn(place["expansion"], place["ratio"], method) for method in column.methods]
    asked = Asked(column, [run_of(turn, request.wheel) for turn in turns], request.where(place), times)
    if column.key.endswith(ERROR):
        return error_number(estimate(asked).error)
    return estimated(asked, request.rounding) if request.carded else settled(asked, request.rounding)


def _listed(command: str, registry: Callable[[], Mapping[str, Quantity]]) -> Callable[[], Listed]:
    return lambda: [(command, one) for key, one in registry().items() if key in of_runs()]


SPEED = TURNING._replace(
    key="speed",
    layout="speed",
    command="turning --flywheel 50",
    quantities=speed_registry,
    number=_number,
    notes=notes,
    of=(),
    listed=_listed("turning --flywheel 50", speed_registry),
)
EVENNESS = IRREGULARITY._replace(
    key="evenness",
    layout="delta-flywheel",
    command="delta --flywheel 50",
    quantities=evenness_registry,
    number=_number,
    notes=notes,
    of=(),
    listed=_listed("delta --flywheel 50", evenness_registry),
)
