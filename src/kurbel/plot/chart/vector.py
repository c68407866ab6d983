"""The force on a pin over its angles, and what of it lies within strokes."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, floor
from typing import NamedTuple

import numpy as np

from kurbel.exact.numerals import Label
from kurbel.plot.chart.model import Strokes
from kurbel.plot.place import Points
from kurbel.plot.ticks import power_of_thousand

MARK_STEP = 30


class Vector(NamedTuple):
    """The components of a force at rising angles in degrees; a value that is no finite number is a gap.

    Where an angle comes twice the force jumps, from the first of its values to the second.
    """

    angles: Sequence[float]
    across: Sequence[float]
    up: Sequence[float]


class PinForce(NamedTuple):
    """The force on a pin: the names of its components, across and up, their unit, and the strokes; `ways` are
    the directions of its axes, by themselves those of the crank."""

    vector: Vector
    names: tuple[Label, Label]
    unit: Label
    strokes: Strokes | None = None
    ways: tuple[Label, Label] | None = None

    @property
    def power(self) -> int:
        """The power of ten that is taken out of the numbers of its components."""
        numbers = np.asarray((self.vector.across, self.vector.up), float)
        return power_of_thousand(numbers[np.isfinite(numbers)])


class Piece(NamedTuple):
    """The heads of the vectors at rising angles, without a jump between them."""

    angles: Points
    path: Points

    def within(self, begin: float, end: float) -> Points:
        """Return the heads from an angle to another."""
        ends = [one for one in (begin, end) if self.angles[0] < one < self.angles[-1]]
        angles = np.union1d(self.angles, ends)
        angles = angles[(angles >= begin) & (angles <= end)]
        return np.stack([np.interp(angles, self.angles, component) for component in self.path.T], axis=1)

    def at(self, angle: float) -> Points:
        """Return the head at an angle; between two given ones, on the line between their heads."""
        return np.asarray([np.interp(angle, self.angles, component) for component in self.path.T])

    def marked(self) -> range:
        """Return the angles every 30° within it."""
        first, last = ceil(self.angles[0] / MARK_STEP), floor(self.angles[-1] / MARK_STEP)
        return range(MARK_STEP * first, MARK_STEP * last + 1, MARK_STEP)


def with_gaps(paths: Sequence[Points]) -> Points:
    gap = np.full((1, 2), np.nan)
    return np.concatenate([row for path in paths for row in (gap, path)][1:])
