"""Lines with gaps where something stands before them: no ground is painted, so the page shows through."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from kurbel.plot.place import Points

# In mm. The ends of lines are found as exactly as that, within the outline that is before them.
STEP = 0.02


class Hole(NamedTuple):
    """What hides lines below its level: a disc, or a box, by its centre and half its sides."""

    centre: Points
    half: Points
    is_round: bool
    level: float

    def hides(self, points: Points) -> Points:
        away = np.abs(points - self.centre)
        if self.is_round:
            return np.asarray(np.hypot(*away.T) < self.half[0] - STEP / 2)
        return np.asarray((away < self.half - STEP / 2).all(axis=1))


def cut(line: Points, holes: Sequence[Hole]) -> Points | None:
    """Return a line with gaps (NaN) where holes hide it, or None if none does."""
    low, high = line.min(axis=0), line.max(axis=0)
    near = [one for one in holes if ((one.centre + one.half > low) & (one.centre - one.half < high)).all()]
    if not near:
        return None
    dense, is_corner = _dense(line)
    hidden = np.logical_or.reduce([one.hides(dense) for one in near])
    if not hidden.any():
        return None
    # Of what is seen the corners stay, and both ends of each piece.
    ends = np.diff(hidden.astype(int), prepend=1, append=1)
    kept = ~hidden & (is_corner | (ends[:-1] == -1) | (ends[1:] == 1))
    dense[hidden & (ends[:-1] == 1)] = np.nan
    kept |= np.isnan(dense).any(axis=1)
    return dense[kept] if kept.any() else np.full((1, 2), np.nan)


def _dense(line: Points) -> tuple[Points, Points]:
    """Return points so close together on a line, and which of them are its own."""
    lengths = np.hypot(*np.diff(line, axis=0).T)
    pieces, corners = [], []
    for start, end, length in zip(line[:-1], line[1:], lengths, strict=True):
        share = np.linspace(0, 1, max(2, int(length / STEP)), endpoint=False)[:, None]
        pieces.append(start + share * (end - start))
        corners.append(share[:, 0] == 0)
    return np.concatenate([*pieces, line[-1:]]), np.concatenate([*corners, [True]])
