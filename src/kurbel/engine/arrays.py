"""Cycles of engines at arrays of crank angles, in floats, and long columns of them, in floats with bounds.

Of a long column balls settle the doubtful cells.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kurbel.drive.at import CrankForce
from kurbel.drive.crank import Crank
from kurbel.drive.moved import DeadCentres
from kurbel.engine.cylinder import AnyTurn, CrankPosition, Cylinder, Peak, TurnPlace, cranks_of
from kurbel.engine.engine_quantities import value
from kurbel.engine.irregularity import enclosed_delta
from kurbel.engine.loads.ideal import Steam
from kurbel.engine.request import EngineRequest
from kurbel.engine.speed.run import Run, run_of
from kurbel.engine.turn import Turn
from kurbel.errors import ProblemError
from kurbel.exact.bulk import Integers, nearest
from kurbel.exact.certify import at_bits
from kurbel.exact.enclosure import ENCLOSURES, Enclosure, Floats, enclosed, half_turn_circle
from kurbel.exact.kind import floats
from kurbel.exact.numerals import Number
from kurbel.exact.search import ISOLATING_BITS
from kurbel.kernel.circle import Circle, Numeric, circle
from kurbel.motion.evaluation import MOST_DECIMALS
from kurbel.motion.long import Angle, LongColumns, Places, quotient
from kurbel.page.axes import Place
from kurbel.page.quantity import Column, Of, Quantity

# Half turns by which a float may lie before a dead centre that it is in.
ZERO_TOLERANCE = 1e-13
# What is a number of each crank angle.
AT_ANGLES = (Of.ANGLE, Of.CRANK)
OnAngle = Callable[[Cylinder, int, Any], Any]
# What is a number of each crank angle, of a turn and of its run with a flywheel, and what of the whole turn.
AT_SPEED, OF_TURN = Of.SPEED, Of.TURN
# It is an integral, of which floats know no bound.
TIME = "time"
KEPT_TURNS = 16
KEY, SUBJECT = "delta", "irregularity"


class FloatTurn(AnyTurn):
    """One cycle by a method, in floats; where its speed is least or greatest, balls have proved."""

    @cached_property
    def cylinders(self) -> tuple[Cylinder, ...]:
        return self.cylinders_on(floats(), _circle)

    def total(self, value: OnAngle, places: Floats, first: float) -> Floats:
        """Return the sum of a number and of what each crank has at an array of half turns."""
        total = np.full_like(places, first)
        for part, start in cranks_of(self.engine):
            total += _on_strokes(self.cylinders[part], start, value, places)
        return total

    def energies(self, places: Floats) -> Floats:
        """Return the excess work since the inner dead centre at an array of half turns."""
        return self.total(Cylinder.energy, places, -float(self.energy_begun()))

    def has_reached(self, since: Fraction, part: int, stroke: int) -> bool:
        begun = stroke + self.cylinders[part].drive.dead_centre(stroke % 2)
        return bool(float(since) - begun >= -ZERO_TOLERANCE)

    def begun(self) -> list[CrankPosition]:
        return [*self.positions(Fraction(float(self.cylinder.drive.dead_centre(0))))]

    @cached_property
    def _proved(self) -> Turn:
        return Turn(self.engine, self.method)

    def peaks(self, greatest: bool, stroke: int | None = None) -> list[Peak]:
        with at_bits(ISOLATING_BITS):
            found = self._proved.peaks(greatest, stroke)
            return [Peak(float(one.place), float(one.energy), one.stroke) for one in found]


class ArrayTurn(FloatTurn):
    """The same, whose quantities of a crank angle are those of an array of half turns."""

    def of(self, value: Any) -> Any:
        return value if isinstance(value, np.ndarray) else super().of(value)

    def tangential_force(self, half_turns: Numeric) -> Floats:
        return self.total(Cylinder.effort, half_turns, 0.0)

    def energy_at(self, half_turns: Any) -> Floats:
        return self.energies(half_turns)

    def crank_force(self, force: CrankForce, half_turns: Numeric) -> Floats:
        def of_first(cylinder: Cylinder, stroke: int, angle: Numeric) -> Numeric:
            return cylinder.force(force, stroke, angle)

        return _on_strokes(self.cylinder, self.part.starts[0], of_first, half_turns)


def at_angles(request: EngineRequest, quantity: Quantity, method: str, degrees: Floats) -> list[Floats]:
    """Return a quantity of a crank angle at an array of angles, for each load and each drive in turn.

    Raises ProblemError for a quantity that is not of a crank angle.
    """
    if quantity.of not in AT_ANGLES:
        raise ProblemError(
            f"{quantity.key} is one number of a turn and has no array over the crank angle; print it, with"
            " kurbel.delta"
        )
    # Kernels hand the place on to the turn, and that of arrays takes an array.
    where = TurnPlace(half_turns=degrees / 180)
    return [
        np.broadcast_to(np.asarray(value(quantity, ArrayTurn(engine, method), where)), degrees.shape)
        for engine in (
            request.engine(steam, drive)
            for steam in range(len(request.steams))
            for drive in range(len(request.drives))
        )
    ]


def _on_strokes(cylinder: Cylinder, start: Fraction, value: OnAngle, places: Floats) -> Floats:
    """Return what a crank has that follows the first by so many half turns, at each of the places."""
    begins = [
        stroke + float(cylinder.drive.dead_centre(stroke % 2)) for stroke in range(len(cylinder.strokes))
    ]
    since = (places - float(start) - begins[0]) % len(begins) + begins[0]
    strokes = np.searchsorted(begins, since, side="right") - 1
    found = np.empty_like(places)
    for stroke in range(len(begins)):
        here = strokes == stroke
        found[here] = value(cylinder, stroke, since[here] - stroke)
    return found


def _circle(half_turns: Any) -> Circle[Numeric]:
    """Return the circle of exact half turns, or of floats."""
    return circle(180.0 * (float(half_turns) if isinstance(half_turns, Fraction) else half_turns))


class StrokeAngles(NamedTuple):
    """The angles at which a crank is in one of its strokes: which of the run, and the half turns there."""

    stroke: int
    rows: Integers
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
        return self.cylinders_on(ENCLOSURES, _enclosed_circle)

    def of(self, value: Any) -> Any:
        return value.half_turns if isinstance(value, Places) else super().of(value)

    def tangential_force(self, half_turns: Any) -> Numeric:
        found: Numeric = self._total(Cylinder.effort, half_turns)
        return found

    def energy_at(self, half_turns: Any) -> Any:
        return self._total(Cylinder.energy, half_turns) - self.begun_energy

    @cached_property
    def begun_energy(self) -> Enclosure:
        return enclosed(self.turn.energy_begun)

    def crank_force(self, force: CrankForce, half_turns: Any) -> Any:
        def of_first(cylinder: Cylinder, stroke: int, angle: Numeric) -> Numeric:
            return cylinder.force(force, stroke, angle)

        return self._on_strokes(of_first, half_turns, *cranks_of(self.engine)[0])

    def _total(self, value: OnAngle, places: Places) -> Any:
        return sum(self._on_strokes(value, places, *crank) for crank in cranks_of(self.engine))

    def _on_strokes(self, value: OnAngle, places: Places, part: int, start: Fraction) -> Enclosure:
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

    def _strokes(self, places: Places, part: int, start: Fraction) -> Iterator[StrokeAngles]:
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
                yield StrokeAngles(stroke, rows, Angle(angle.value, error))

    def _beside_dead_centres(
        self, one: Cylinder, since: Integers, denominator: int
    ) -> tuple[Integers, Integers, Floats]:
        """Return the strokes, the half turns since the first began, and where neither is known."""
        cycle, whole = len(one.strokes), len(one.strokes) * denominator
        at, doubtful = quotient(since, denominator), np.zeros(len(since), bool)

        def reached(stroke: int) -> Floats:
            beyond: Any = at - stroke - one.drive.dead_centre(stroke % 2)
            doubtful[~(abs(beyond.value) > beyond.error)] = True
            return beyond.value >= 0

        since = np.where(reached(0), np.where(reached(cycle), since - whole, since), since + whole)
        at = quotient(since, denominator)
        strokes = sum(reached(stroke).astype(np.int64) for stroke in range(1, cycle))
        return strokes, since, doubtful

    def has_reached(self, since: Fraction, part: int, stroke: int) -> bool:
        return self.turn.has_reached(since, part, stroke)

    def begun(self) -> Sequence[CrankPosition]:
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


def _enclosed_circle(half_turns: Any) -> Circle[Enclosure]:
    return half_turns.circle if isinstance(half_turns, Angle) else half_turn_circle(half_turns)


class EngineColumns(LongColumns):
    """The columns of a question about an engine."""

    def __init__(self, request: EngineRequest) -> None:
        super().__init__(request)
        self.turn = lru_cache(KEPT_TURNS)(self._turn)

    def is_constant(self, one: Column) -> bool:
        return one.quantity.of == OF_TURN

    def starts(self) -> Iterator[Fraction]:
        return (crank.start for crank in cranks_of(self.question.first))

    def drives(self) -> Iterator[DeadCentres]:
        yield from self.question.drives
        for part in self.question.first.parts:
            yield part.drive

    def value(self, one: Column, place: Place, places: Places) -> Any:
        asked = self._asked(one, place)
        where = TurnPlace(half_turns=places)
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


class Irregularities:
    """The column δ of a question about all engines of some expansion and crank ratios."""

    def __init__(self, request: EngineRequest) -> None:
        self.request = request
        self._digits = lru_cache(8)(self._nearest)

    def is_worth(self) -> bool:
        """Whether all are plain engines, of which floats have a bound."""
        return self.request.subject.key == SUBJECT and plain_steam(self.request, "exact") is not None

    def number(self, column: Column, place: Place) -> Number | None:
        """Return the number of an engine, None where balls must settle it."""
        few = column.decimals is not None and column.decimals <= MOST_DECIMALS
        if column.quantity.key != KEY or len(column.methods) > 1 or column.least or not few:
            return None
        scaled, doubtful = self._digits(column.method, column.places)
        engine = place["expansion"] * len(self.request.drives) + place["ratio"]
        return None if doubtful[engine] else Number(int(scaled[engine]), column.places)

    def _nearest(self, method: str, decimals: int) -> tuple[Integers, NDArray[np.bool_]]:
        steams, ratios = self.request.steams, [float(one) for one in self.request.ratios]
        steam = plain_steam(self.request, method)
        if steam is None:
            every = len(steams) * len(ratios)
            return np.zeros(every, np.int64), np.ones(every, bool)
        given: dict[str, Any] = {
            "eps": np.repeat([float(one.expansion) for one in steams if isinstance(one, Steam)], len(ratios)),
            "ratio": np.tile(ratios, len(steams)),
            "back": None if steam.back is None else float(steam.back),
            "clearance": float(steam.clearance),
            "exponent": float(steam.exponent),
        }
        found, bounds = enclosed_delta(given, method)
        return nearest(found, decimals, bounds, half_even=self.request.rounding == "half-even")


def plain_steam(request: EngineRequest, method: str) -> Steam | None:
    """Return the first steam of plain engines, straight and double-acting with one crank and no masses; None
    of others, of those that the method does not have, and where more than ε differs from one steam to the
    next."""
    first, *others = request.steams
    if not isinstance(first, Steam) or request.mechanism.name != "straight":
        return None
    if not request.double or len(request.cranks) != 1 or request.assembly is not None:
        return None
    if any(drive.crank != Crank(drive.crank.ratio) for drive in request.drives):
        return None
    if not first.plain or (method == "weisbach" and (first.clearance or first.exponent != 1)):
        return None
    kept = first.back, first.exponent, first.clearance
    alike = all(isinstance(one, Steam) and (one.back, one.exponent, one.clearance) == kept for one in others)
    return first if alike else None
