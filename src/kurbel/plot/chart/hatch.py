"""Hatching between two courses: lines of one slope where the first is above, of the other where below."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kurbel.plot.chart.course import Course
from kurbel.plot.place import Box, Points

# In mm: the lines are so far apart, and their ends are found to such a step.
SPACING, STEP = 1.3, 0.03
# What is left free around a label.
MARGIN = 0.5

Taken: TypeAlias = NDArray[np.bool_]


def hatching(
    courses: Sequence[Course], size: tuple[float, float], rising: bool, free: Iterable[Box] = ()
) -> Course:
    """Return lines over the area in which the first course is above the second, or below if not `rising`.

    The courses are in mm on the panel of this size. Lines are at 45°, rising or falling from left to right,
    with gaps between them; the boxes stay free.
    """
    width, height = size
    side = STEP / math.sqrt(2)
    along = np.arange(0, width + height, side)
    pieces = [np.empty((0, 2))]
    for start in np.arange(-height, width, SPACING * math.sqrt(2)):
        across = start + along
        up = along if rising else height - along
        within = (across >= 0) & (across <= width) & (up >= 0) & (up <= height)
        line = np.stack((across[within], up[within]), axis=1)
        pieces.extend(_runs(line, _inside(line, courses, rising) & _outside(line, free)))
    dots = np.concatenate(pieces)
    return Course(dots[:, 0], dots[:, 1])


def _inside(line: Points, courses: Sequence[Course], above: bool) -> Taken:
    first, second = (course.at(line[:, 0]) for course in courses)
    low, high = (second, first) if above else (first, second)
    return (line[:, 1] > low) & (line[:, 1] < high)


def _outside(line: Points, boxes: Iterable[Box]) -> Taken:
    free = np.full(len(line), True)
    for left, bottom, right, top in boxes:
        across = (line[:, 0] > left - MARGIN) & (line[:, 0] < right + MARGIN)
        free &= ~(across & (line[:, 1] > bottom - MARGIN) & (line[:, 1] < top + MARGIN))
    return free


def _runs(line: Points, taken: Taken) -> Iterable[Points]:
    """Yield both ends of each stretch of a line that is taken, and a gap."""
    edges = np.diff(np.concatenate(([0], taken.astype(int), [0])))
    for begin, end in zip(np.flatnonzero(edges == 1), np.flatnonzero(edges == -1) - 1, strict=True):
        if end > begin:
            yield np.stack((line[begin], line[end], np.full(2, np.nan)))
