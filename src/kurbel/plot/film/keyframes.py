"""The fewest places of a way from which straight lines lead back to it."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from kurbel.plot.film.model import Way
from kurbel.plot.place import Points


def keyframes(way: Way, scale: Points, tolerance: float) -> Way:
    """Return the rows of a way between which a straight line, evenly run through, leaves it by so little.

    Each number counts by its scale. Both rows of a jump are kept.
    """
    rows = way.rows * scale
    jumps = np.flatnonzero(np.diff(way.angles) == 0)
    ends = sorted({0, len(rows) - 1, *jumps.tolist(), *(jumps + 1).tolist()})
    kept, open_ = set(ends), list(pairwise(ends))
    while open_:
        begin, end = open_.pop()
        if end - begin < 2:
            continue
        angles = way.angles[begin + 1 : end]
        share = (angles - way.angles[begin]) / (way.angles[end] - way.angles[begin])
        line = rows[begin] + share[:, None] * (rows[end] - rows[begin])
        away = np.abs(rows[begin + 1 : end] - line).max(axis=1)
        if away.max() > tolerance:
            middle = begin + 1 + int(away.argmax())
            kept.add(middle)
            open_ += [(begin, middle), (middle, end)]
    order = sorted(kept)
    return Way(way.angles[order], way.rows[order])
