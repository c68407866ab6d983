"""Long columns of an engine: its turn, and its run with a flywheel, in floats with bounds."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache
from typing import Any

from kurbel.engine.long.turn import EnclosedRun, EnclosedTurn
from kurbel.engine.quantities import Where, value
from kurbel.engine.request import EngineRequest
from kurbel.engine.speed.run import Run, run_of
from kurbel.engine.turn import Turn
from kurbel.motion.long import LongColumns, Places
from kurbel.page.axes import Place
from kurbel.page.quantity import Column

# What is a number of each crank angle, of a turn and of its run with a flywheel, and what of the whole turn.
AT_ANGLES, AT_SPEED, OF_TURN = ("angle", "crank"), "speed", "turn"
# It is an integral, of which floats know no bound.
TIME = "time"
KEPT_TURNS = 16


class EngineColumns(LongColumns):
    """The columns of a question about an engine."""

    def __init__(self, request: EngineRequest) -> None:
        super().__init__(request)
        self.turn = lru_cache(KEPT_TURNS)(self._turn)

    def is_constant(self, one: Column) -> bool:
        return one.quantity.of == OF_TURN

    def starts(self) -> Iterator[Fraction]:
        for part in self.question.first.parts:
            yield from part.starts

    def drives(self) -> Iterator[Any]:
        yield from self.question.drives
        for part in self.question.first.parts:
            yield part.drive

    def value(self, one: Column, place: Place, places: Places) -> Any:
        asked = self._asked(one, place)
        where = Where(half_turns=places)
        return NotImplemented if asked is None else value(one.quantity, asked, where)

    def _asked(self, one: Column, place: Place) -> Any:
        """Return what a column is asked of, None of what has no formulas on enclosures."""
        quantity = one.quantity
        turn = self.turn(place["expansion"], place["ratio"], one.methods[0])
        if turn is None or quantity.of in AT_ANGLES:
            return turn
        if quantity.of != AT_SPEED or quantity.key == TIME or self.question.wheel is None:
            return None
        run = run_of(turn.turn, self.question.wheel)
        return EnclosedRun(run, turn) if type(run) is Run else None

    def _turn(self, steam: int, drive: int, method: str) -> EnclosedTurn | None:
        turn = self.question.turn(steam, drive, method)
        return EnclosedTurn(turn) if type(turn) is Turn else None
