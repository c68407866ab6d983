"""Columns of the motion over arrays and long progressions of angles: floats with bounds, else balls."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import product
from math import lcm
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kurbel.drive.at import At, known
from kurbel.drive.crank import Crank
from kurbel.drive.moved import DeadCentres
from kurbel.exact.bulk import Integers, evaluate
from kurbel.exact.enclosure import ENCLOSURES, UNIT, Enclosure, half_turn_circle, is_worth, settled
from kurbel.exact.enclosure import column as enclosed_column
from kurbel.exact.kind import floats
from kurbel.exact.numerals import Number
from kurbel.kernel.circle import Circle, Numeric
from kurbel.motion.bulk import CHUNK, Chunk, RecordRows, integer_angles
from kurbel.motion.evaluation import MOST_DECIMALS, kernel_of
from kurbel.motion.motion_quantities import registry
from kurbel.page.axes import Axis, Place
from kurbel.page.quantity import Column, Of, Quantity
from kurbel.page.table import Value
from kurbel.reading.notation import Progression

Floats = NDArray[np.float64]
# The formulas take the ratio from elsewhere.
NO_RATIO = Crank(Fraction(0))


def motion(
    keys: Sequence[str],
    degrees: ArrayLike,
    ratio: ArrayLike,
    method: str = "exact",
    *,
    fast: bool | None = None,
) -> list[Floats]:
    """Return each quantity of the straight crank as an array of the common shape of angles and ratios.

    `keys` are of quantities of which nothing but the ratio need be known, on either stroke; ratios are R:L,
    at least 0 and below 1, and not checked. On all cores, by numba where it is installed and worth it
    (`fast` as in `exact.bulk.evaluate`); the bits are those of `kurbel.compute` at each ratio alone.
    """
    angles, ratios = np.asarray(degrees, np.float64), np.asarray(ratio, np.float64)
    shape = np.broadcast_shapes(angles.shape, ratios.shape)
    columns = [_of_ratio(registry()[key], method) for key in keys]
    inputs = [np.broadcast_to(one, shape).ravel() for one in (angles, ratios)]
    return [row.reshape(shape) for row in evaluate(columns, *inputs, fast=fast)]


def _of_ratio(quantity: Quantity, method: str) -> Callable[[Circle[Numeric], Numeric], Numeric]:
    kernel, numbers, stroke = kernel_of(quantity, method, NO_RATIO), floats(), quantity.stroke
    scale = quantity.scale(NO_RATIO, numbers) if quantity.scale else None

    def column(circle: Circle[Numeric], ratio: Numeric) -> Numeric:
        # An infinite rod has no ratio, and the return stroke the other sign.
        signed = 0.0 if method == "infinite" else ratio if stroke > 0 else -ratio
        found = kernel(At(circle, NO_RATIO, numbers, stroke, signed, None, method == "series"))
        return found if scale is None else found * scale

    return column


# Columns at so many places tell whether floats settle nearly all digits.
PROBES = 1024
# Half turns and their denominator are floats, and so is a sum of some of them.
LARGEST_NUMERATOR = 2**50
# With a rod that comes nearer to the square of its guide, in degrees, numbers may grow between two probes by
# more than a million times, for which integers of 64 bits have room.
LEAST_TRANSMISSION = 1.0


class Angle(Enclosure):
    """Half turns whose circle is computed once for all that is asked of them."""

    __slots__ = ("__dict__",)

    @cached_property
    def circle(self) -> Circle[Enclosure]:
        return half_turn_circle(self)


class Places:
    """A run of crank angles, as exact half turns: integers over one denominator. What is asked of them more
    than once is `kept`."""

    def __init__(self, angles: Progression) -> None:
        numerators, denominator = integer_angles(angles)
        self.numerators, self.denominator = numerators, 180 * denominator
        self.kept: dict[tuple[object, ...], Any] = {}

    def __len__(self) -> int:
        return len(self.numerators)

    @property
    def half_turns(self) -> Enclosure:
        return quotient(self.numerators, self.denominator)

    @cached_property
    def angle(self) -> Angle:
        """The half turns within a turn."""
        found = quotient(*self.since(Fraction(0), 2))
        return Angle(found.value, found.error)

    def since(self, start: Fraction, cycle: int) -> tuple[Integers, int]:
        """Return the half turns since a start, within a cycle, as numerators and their denominator."""
        denominator = lcm(self.denominator, start.denominator)
        gone = self.numerators * (denominator // self.denominator) - int(start * denominator)
        return gone % (cycle * denominator), denominator


def quotient(numerators: Integers, denominator: int) -> Enclosure:
    """Return exact fractions; both are below 2**53, so that the division alone rounds."""
    value = numerators / denominator
    return Enclosure(value, abs(value) * UNIT)


class LongColumns(ABC):
    """The columns of a question over a long progression of angles, at each place on its other axes."""

    def __init__(self, question: Any) -> None:
        self.question = question
        self.columns = {one.key: one for one in question.page_columns}
        self._whole: dict[tuple[int, ...], dict[str, Integers]] = {}

    @abstractmethod
    def value(self, one: Column, place: Place, places: Places) -> Any:
        """Return a column at a run of angles, NotImplemented where it has no formulas on enclosures."""

    @abstractmethod
    def starts(self) -> Iterator[Fraction]:
        """Yield half turns that are taken off the angles."""

    @abstractmethod
    def drives(self) -> Iterator[DeadCentres]:
        """Yield all crank drives."""

    def is_constant(self, one: Column) -> bool:
        """Whether a column is one number of the whole turn."""
        return False

    @property
    def others(self) -> Sequence[Place]:
        """The places on the other axes, in the order of records."""
        axes = self.question.axes
        names = [name for name in axes if name not in ("angle", "column")]
        every = product(*(range(axes[name].count) for name in names))
        return [dict(zip(names, indices, strict=True)) for indices in every]

    def is_worth(self) -> bool:
        """Whether nearly all cells are settled in floats."""
        angles = self.question.angles
        if not isinstance(angles, Progression) or not self._is_exact(angles):
            return False
        if any(map(_is_steep, self.drives())):
            return False
        probes = Places(angles[:: max(1, len(angles) // PROBES)])
        return all([self._is_worth(one, probes) for one in self.columns.values()])

    def _is_exact(self, angles: Progression) -> bool:
        """Whether all half turns are exact in integers."""
        steps = 180 * angles.start.denominator, 180 * angles.step.denominator
        denominator = lcm(*steps, *(start.denominator for start in self.starts()))
        largest: Fraction = max(abs(angles[0]), abs(angles[-1]))
        return (largest / 180 + 8) * denominator < LARGEST_NUMERATOR

    def _is_worth(self, one: Column, probes: Places) -> bool:
        if self.is_constant(one):
            return not one.least
        if one.decimals is None or one.decimals > MOST_DECIMALS or one.least or len(one.methods) > 1:
            return False
        found = (self._enclosed(one, place, probes) for place in self.others)
        return all(own is not None and is_worth(own, one.places) for own in found)

    def _enclosed(self, one: Column, place: Place, places: Places) -> Enclosure | None:
        return enclosed_column(lambda: self.value(one, place, places), len(places))

    def number(self, column: Column, place: Place) -> Number | None:
        """Return a number of a page, of which all over the angle is computed at the first; None of the whole
        turn's."""
        if self.is_constant(column) or self.columns.get(column.key) is not column:
            return None
        engine = tuple(index for name, index in place.items() if name not in ("angle", "column"))
        if engine not in self._whole:
            self._whole[engine] = self.scaled(place, 0, len(self.question.angles))
        return Number(int(self._whole[engine][column.key][place["angle"]]), column.places)

    def scaled(self, place: Place, start: int, size: int) -> dict[str, Integers]:
        """Return the scaled digits of every column by its key, at so many angles from one on."""
        places = Places(self.question.angles[start : start + size])
        return {key: self._scaled(one, place, start, places) for key, one in self.columns.items()}

    def _scaled(self, one: Column, place: Place, start: int, places: Places) -> Integers:
        def exactly(row: int) -> int:
            return self.exactly(one, place, start + row).scaled

        if self.is_constant(one):
            return np.full(len(places), exactly(0))
        found = known(self._enclosed(one, place, places))
        return settled(found, one.places, self.question.rounding, exactly)

    def exactly(self, one: Column, place: Place, angle: int) -> Number:
        """Return a number in balls."""
        found = self.question.subject.number(self.question, one, {**place, "angle": angle}, 1)
        assert isinstance(found, Number)
        return found

    def decimals(self, one: Column, place: Place) -> int:
        """Return the decimals of a column, of what is one number of the turn those that it has."""
        return self.exactly(one, place, 0).decimals if self.is_constant(one) else one.places


class AngleColumns(LongColumns):
    """The columns of a question about drives over the crank angle."""

    def starts(self) -> Iterator[Fraction]:
        yield Fraction(0)

    def drives(self) -> Iterator[DeadCentres]:
        yield from self.question.drives

    def value(self, one: Column, place: Place, places: Places) -> Any:
        if one.quantity.of is Of.DIRECTION:
            return NotImplemented
        return self.question.value(one, place, places.angle.circle, ENCLOSURES)


def _is_steep(drive: DeadCentres) -> bool:
    return bool(drive.least_transmission(floats()) < LEAST_TRANSMISSION)


class LongRows(RecordRows):
    """The records of a question with long columns."""

    bulk = True

    @property
    def stub_values(self) -> Sequence[Value]:
        return [value for place in self.question.long.others for value in self._values(place).values()]

    def chunks(self) -> Iterator[Chunk]:
        angles, long = self.question.angles, self.question.long
        for place in long.others:
            others = self._values(place)
            decimals = {key: long.decimals(one, place) for key, one in self.columns.items()}
            for start in range(0, len(angles), CHUNK):
                part = angles[start : start + CHUNK]
                yield Chunk(others, part, long.scaled(place, start, len(part)), decimals)

    def _values(self, place: Place) -> Mapping[str, Value]:
        axes = (self.question.axes[name] for name in place)
        return {axis.key: axis.value(place) for axis in axes if isinstance(axis, Axis)}
