"""A cycle of an engine at a long run of exact crank angles, in floats with bounds."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from kurbel.drive.crank_forces import CrankForce
from kurbel.engine.cylinder import AnyTurn, Cylinder, Peak, Standing
from kurbel.engine.speed.run import Run
from kurbel.engine.turn import Turn
from kurbel.exact.bulk import Integers
from kurbel.exact.enclosure import ENCLOSURES, Enclosure, Floats, enclosed, half_turn_circle
from kurbel.kernel.circle import Circle
from kurbel.motion.long import Angle, Places, quotient

Value = Callable[[Cylinder, int, Any], Any]


class OnStroke(NamedTuple):
    """The angles at which a crank is in one of its strokes: which of the run, and the half turns there."""

    stroke: int
    rows: Any
    angle: Angle


class EnclosedTurn(AnyTurn):
    """The cycle of a turn in balls, whose quantities of a crank angle are those of `Places`.

    In which stroke a crank is, is decided exactly. Beside a dead centre that is no rational number of half
    turns floats may not tell; there nothing is known.
    """

    def __init__(self, turn: Turn) -> None:
        super().__init__(turn.engine, turn.method)
        self.turn = turn

    @cached_property
    def cylinders(self) -> tuple[Cylinder, ...]:
        return self.cylinders_on(ENCLOSURES, _circle)

    def of(self, value: Any) -> Any:
        return value.half_turns if isinstance(value, Places) else super().of(value)

    def tangential_force(self, half_turns: Any) -> Any:
        return self._total(Cylinder.effort, half_turns)

    def energy_at(self, half_turns: Any) -> Any:
        return self._total(Cylinder.energy, half_turns) - self.begun_energy

    @cached_property
    def begun_energy(self) -> Enclosure:
        return enclosed(self.turn.energy_begun)

    def crank_force(self, force: CrankForce, half_turns: Any) -> Any:
        def of_first(cylinder: Cylinder, stroke: int, angle: Any) -> Any:
            return cylinder.force(force, stroke, angle)

        part, start = next(self._cranks())
        return self._on_strokes(of_first, half_turns, part, start)

    def _total(self, value: Value, places: Places) -> Any:
        return sum(self._on_strokes(value, places, *one) for one in self._cranks())

    def _cranks(self) -> Iterator[tuple[int, Fraction]]:
        """Yield the part of each crank, and by how many half turns it follows."""
        for number, part in enumerate(self.engine.parts):
            for start in part.starts:
                yield number, start

    def _on_strokes(self, value: Value, places: Places, part: int, start: Fraction) -> Enclosure:
        """Return what a crank has at each of the places."""
        # Of unlike turns of one question the dead centres may lie elsewhere.
        key = self, part, start
        if key not in places.kept:
            places.kept[key] = list(self._strokes(places, part, start))
        found = Enclosure(np.empty(len(places)), np.empty(len(places)))
        for stroke, rows, angle in places.kept[key]:
            own = Enclosure.of(value(self.cylinders[part], stroke, angle))
            found.value[rows], found.error[rows] = own.value, own.error
        return found

    def _strokes(self, places: Places, part: int, start: Fraction) -> Iterator[OnStroke]:
        one = self.cylinders[part]
        cycle = len(one.strokes)
        since, denominator = places.since(start, cycle)
        strokes, doubtful = since // denominator, np.zeros(len(since), bool)
        if not one.drive.regular:
            strokes, since, doubtful = self._beside_dead_centres(one, since, denominator)
        for stroke in range(cycle):
            rows = (strokes == stroke).nonzero()[0]
            if len(rows):
                angle = quotient(since[rows] - stroke * denominator, denominator)
                error = np.where(doubtful[rows], np.inf, angle.error)
                yield OnStroke(stroke, rows, Angle(angle.value, error))

    def _beside_dead_centres(
        self, one: Cylinder, since: Integers, denominator: int
    ) -> tuple[Integers, Integers, Floats]:
        """Return the strokes, the half turns since the first began, and where neither is known."""
        cycle, whole = len(one.strokes), len(one.strokes) * denominator
        at, doubtful = quotient(since, denominator), np.zeros(len(since), bool)

        def reached(stroke: int) -> Floats:
            beyond = at - stroke - one.drive.dead_centre(stroke % 2)
            doubtful[~(abs(beyond.value) > beyond.error)] = True
            return beyond.value >= 0

        since = np.where(reached(0), np.where(reached(cycle), since - whole, since), since + whole)
        at = quotient(since, denominator)
        strokes = sum(reached(stroke).astype(np.int64) for stroke in range(1, cycle))
        return strokes, since, doubtful

    def has_reached(self, since: Fraction, part: int, stroke: int) -> bool:
        return self.turn.has_reached(since, part, stroke)

    def begun(self) -> Sequence[Standing]:
        return self.turn.begun()

    def peaks(self, greatest: bool, stroke: int | None = None) -> Sequence[Peak]:
        raise AssertionError("a crank angle has no extremes")


class EnclosedRun:
    """A run of the engine with its flywheel, whose speeds are those at `Places`."""

    def __init__(self, run: Run, turn: EnclosedTurn) -> None:
        self.run, self.turn, self.method = run, turn, run.method

    @cached_property
    def number(self) -> Enclosure:
        return enclosed(lambda: self.run.number)

    @cached_property
    def first_omega(self) -> Enclosure:
        return enclosed(lambda: self.run.first_omega)

    def speed(self, places: Any) -> Any:
        return self.run.law(self.turn.energy_at(places) / abs(self.turn.mean_force()), self.number)


def _circle(half_turns: Any) -> Circle[Enclosure]:
    return half_turns.circle if isinstance(half_turns, Angle) else half_turn_circle(half_turns)
