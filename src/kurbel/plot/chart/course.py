"""The way of a curve over its axis, with gaps where it is not finite, and its jumps."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kurbel.plot.chart.model import Curve
from kurbel.plot.place import Points


class Course(NamedTuple):
    """The angles and values of a curve, with NaN for what is not finite."""

    angles: Points
    values: Points

    @classmethod
    def of(cls, curve: Curve) -> Course:
        values = np.asarray(curve.values, float)
        return cls(np.asarray(curve.angles, float), np.where(np.isfinite(values), values, np.nan))

    @classmethod
    def level(cls, span: tuple[float, float], value: float = 0.0) -> Course:
        """Return one and the same value all over a span."""
        return cls(np.asarray(span), np.full(2, value))

    def broken(self) -> Course:
        """Return the course with a gap in every jump."""
        after = self._after_jumps()
        gaps = np.insert(self.values, after, np.nan)
        return Course(np.insert(self.angles, after, self.angles[after]), gaps)

    def jumps(self) -> Course:
        """Return the jumps alone, with gaps between them."""
        after = self._after_jumps()
        ends = (self.values[after - 1], self.values[after], np.full(len(after), np.nan))
        return Course(np.repeat(self.angles[after], 3), np.stack(ends, axis=1).ravel())

    def at(self, angles: Points) -> Points:
        """Return the values at angles, NaN beyond its ends."""
        return np.asarray(np.interp(angles, self.angles, self.values, left=np.nan, right=np.nan))

    def _after_jumps(self) -> NDArray[np.intp]:
        """Return the numbers of the points after jumps, at the angles of those before."""
        return np.flatnonzero(np.diff(self.angles) == 0) + 1
