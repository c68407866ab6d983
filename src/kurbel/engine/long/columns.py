"""Long columns of an engine over the crank angle: in floats with bounds, the doubtful cells in balls."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from math import lcm
from typing import Any

import numpy as np

from kurbel.engine.long.turn import EnclosedRun, EnclosedTurn, Places
from kurbel.engine.quantities import Where, value
from kurbel.engine.request import EngineRequest
from kurbel.engine.speed.run import Run, run_of
from kurbel.engine.turn import Turn
from kurbel.exact.bulk import Integers
from kurbel.exact.enclosures.digits import column as enclosed_column
from kurbel.exact.enclosures.digits import is_worth, settled
from kurbel.exact.numerals import Number
from kurbel.motion.evaluation import MOST_DECIMALS
from kurbel.motion.page import CHUNK, Chunk, RecordRows
from kurbel.page.axes import Place
from kurbel.page.quantity import Column
from kurbel.page.table import Value
from kurbel.reading.notation import Progression

# What is a number of each crank angle, of a turn and of its run with a flywheel, and what of the whole turn.
AT_ANGLES, AT_SPEED, OF_TURN = ("angle", "crank"), "speed", "turn"
# It is an integral, of which floats know no bound.
TIME = "time"
# Of slides and others the columns at so many places tell whether floats settle nearly all digits.
PROBES = 1024
# Half turns and their denominator are floats, and so is a sum of some of them.
LARGEST_NUMERATOR = 2**50
# Nearer to 1 forces grow between two probes by more than integers of 64 bits hold.
LARGEST_RATIO = Fraction(9999, 10000)
KEPT_TURNS = 16


class LongColumns:
    """The columns of a question about an engine over a long progression of angles."""

    def __init__(self, request: EngineRequest) -> None:
        self.request = request
        self.turn = lru_cache(KEPT_TURNS)(self._turn)
        self._columns = {one.key: one for one in request.page_columns}
        self._whole: dict[tuple[int, int], dict[str, Integers]] = {}

    def _turn(self, steam: int, drive: int, method: str) -> EnclosedTurn | None:
        """Return the turn on enclosures, None of one that has no formulas on them."""
        turn = self.request.turn(steam, drive, method)
        return EnclosedTurn(turn) if type(turn) is Turn else None

    def is_worth(self) -> bool:
        """Whether nearly all cells are settled in floats."""
        request, angles = self.request, self.request.angles
        if not isinstance(angles, Progression) or not _is_exact(request, angles):
            return False
        probes = Places(angles[:: max(1, len(angles) // PROBES)])
        return all(
            self._is_constant(one) or self._is_worth(one, steam, drive, probes)
            for one in request.page_columns
            for steam in range(len(request.steams))
            for drive in range(len(request.drives))
        )

    def _is_constant(self, one: Column) -> bool:
        return one.quantity.of == OF_TURN and not one.least

    def _is_worth(self, one: Column, steam: int, drive: int, probes: Places) -> bool:
        if one.decimals is None or one.decimals > MOST_DECIMALS or one.least or len(one.methods) > 1:
            return False
        asked = self._asked(one, steam, drive)
        return asked is not None and is_worth(_values(one, asked, probes), one.decimals)

    def _asked(self, one: Column, steam: int, drive: int) -> EnclosedTurn | EnclosedRun | None:
        """Return what a column is asked of."""
        quantity, turn = one.quantity, self.turn(steam, drive, one.methods[0])
        if turn is None or quantity.of in AT_ANGLES:
            return turn
        if quantity.of != AT_SPEED or quantity.key == TIME or self.request.wheel is None:
            return None
        run = run_of(turn.turn, self.request.wheel)
        return EnclosedRun(run, turn) if type(run) is Run else None

    def number(self, column: Column, place: Place) -> Number | None:
        """Return a number of a page, of which all over the angle is computed at the first; None of the whole
        turn's."""
        if self._is_constant(column) or self._columns.get(column.key) is not column:
            return None
        engine = place["expansion"], place["ratio"]
        if engine not in self._whole:
            self._whole[engine] = self.scaled(*engine, 0, len(self.request.angles))
        return Number(int(self._whole[engine][column.key][place["angle"]]), column.places)

    def scaled(self, steam: int, drive: int, start: int, size: int) -> dict[str, Integers]:
        """Return the scaled digits of every column by its key, at so many angles from one on."""
        angles = self.request.angles
        assert isinstance(angles, Progression)
        places = Places(angles[start : start + size])
        return {one.key: self._scaled(one, steam, drive, start, places) for one in self.request.page_columns}

    def _scaled(self, one: Column, steam: int, drive: int, start: int, places: Places) -> Integers:
        def exactly(row: int) -> int:
            return self.exactly(one, steam, drive, start + row).scaled

        if self._is_constant(one):
            return np.full(len(places), exactly(0))
        found = _values(one, self._asked(one, steam, drive), places)
        return settled(found, one.places, self.request.rounding, exactly)

    def exactly(self, one: Column, steam: int, drive: int, angle: int) -> Number:
        """Return a number in balls."""
        place = {"expansion": steam, "ratio": drive, "angle": angle}
        found = self.request.subject.number(self.request, one, place, 1)
        assert isinstance(found, Number)
        return found

    def decimals(self, one: Column, steam: int, drive: int) -> int:
        """Return the decimals of a column, of what is one number of the turn those that it has."""
        return self.exactly(one, steam, drive, 0).decimals if self._is_constant(one) else one.places


class EngineRows(RecordRows):
    """The records of an engine, load by load, drive by drive."""

    bulk = True

    @property
    def said(self) -> Sequence[Value]:
        return [value for place in self._others() for value in self._values(place).values()]

    def chunks(self) -> Iterator[Chunk]:
        request, long = self.question, self.question.long
        for place in self._others():
            others, engine = self._values(place), (place["expansion"], place["ratio"])
            decimals = {key: long.decimals(one, *engine) for key, one in self.columns.items()}
            for start in range(0, len(request.angles), CHUNK):
                part = request.angles[start : start + CHUNK]
                yield Chunk(others, part, long.scaled(*engine, start, len(part)), decimals)

    def _others(self) -> Iterator[dict[str, int]]:
        for steam in range(len(self.question.steams)):
            for drive in range(len(self.question.drives)):
                yield {"expansion": steam, "ratio": drive}

    def _values(self, place: Mapping[str, int]) -> dict[str, Value]:
        axes = (self.question.axes[name] for name in ("expansion", "ratio"))
        return {axis.key: axis.value(place) for axis in axes}


def _values(one: Column, asked: Any, places: Places) -> Any:
    where = Where(half_turns=places)  # type: ignore[arg-type]
    return enclosed_column(lambda: value(one.quantity, asked, where), len(places))


def _is_exact(request: EngineRequest, angles: Progression) -> bool:
    """Whether all half turns are exact in integers, and forces do not leap between two probes."""
    starts = (start.denominator for part in request.first.parts for start in part.starts)
    denominator = lcm(180 * angles.start.denominator, 180 * angles.step.denominator, *starts)
    half_turns = max(abs(angles[0]), abs(angles[-1]), 720) / 180 + 4
    steep = any(part.crank.ratio > LARGEST_RATIO for part in request.first.parts)
    steep = steep or any(drive.crank.ratio > LARGEST_RATIO for drive in request.drives)
    return half_turns * denominator < LARGEST_NUMERATOR and not steep
