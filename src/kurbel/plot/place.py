"""Where a label has room: the place farthest from all lines and other labels. Lengths in mm on the page."""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

Points: TypeAlias = NDArray[np.float64]

# Left, bottom, right, top.
Box: TypeAlias = tuple[float, float, float, float]

# How far a label stands from its own line, and at least from anything.
GAP, CLEAR = 0.8, 0.6


class Wish(NamedTuple):
    """The least distance from what is not a label's own; and so much that more is not better."""

    least: float
    ample: float


# Beside a line its label must be nearer to it than to any other; around a point no other can be meant.
BESIDE, AROUND = Wish(GAP + CLEAR, 5.0), Wish(CLEAR, 1.2)
# Where a label may be around a point: in so many directions, and so much farther than touching it.
DIRECTIONS, DISTANCES = 32, (0.0, 0.8, 1.6, 3.0)


def densely(points: Points, spacing: float = 0.5) -> Points:
    """Return points on the line through the given ones, about so far apart; gaps (NaN) are left out."""
    pieces = [np.empty((0, 2))]
    for start, end in pairwise(points):
        length = float(np.hypot(*(end - start)))
        if np.isfinite(length):
            share = np.linspace(0, 1, 1 + int(length / spacing), endpoint=False)[:, None]
            pieces.append(start + share * (end - start))
    dense = np.concatenate(pieces)
    # Of points closer than that, as of a long series, one in each stretch: memory grows with their square.
    way = np.cumsum(np.hypot(*np.diff(dense, axis=0, prepend=dense[:1]).T))
    return dense[np.unique(np.floor(way / spacing), return_index=True)[1]]


def beside(line: Points, size: tuple[float, float]) -> Points:
    """Return the centres of a box of this size that touches a line, at both sides of every point."""
    slope = np.gradient(line, axis=0)
    length = np.hypot(*slope.T)[:, None]
    normal = np.stack((-slope[:, 1], slope[:, 0]), axis=1) / np.where(length, length, 1)
    return np.concatenate([line + side * normal * _reach(normal, size) for side in (1, -1)])


def around(point: Points, size: tuple[float, float], outward: Points) -> Points:
    """Return the centres of a box of this size near a point, the nearest first, in every direction.

    They begin in the direction outward and go on to both sides of it.
    """
    step = 2 * np.pi / DIRECTIONS
    turns = np.arange(DIRECTIONS) * step * np.resize((1, -1), DIRECTIONS)
    angles = np.arctan2(outward[1], outward[0]) + np.cumsum(turns)
    direction = np.stack((np.cos(angles), np.sin(angles)), axis=1)
    return np.concatenate([point + direction * (_reach(direction, size) + more) for more in DISTANCES])


def _reach(direction: Points, size: tuple[float, float]) -> Points:
    """Return how far the centre of a box must be from a line square to the direction."""
    return np.asarray((np.abs(direction) @ np.asarray(size) / 2 + GAP)[..., None])


def freest(
    centres: Points, size: tuple[float, float], own: Points, others: Points, frame: Box, wish: Wish
) -> Points | None:
    """Return the centre whose box has most room, the first of several, or None if none has enough.

    own is the line to which the label belongs: it may be near, but not within the box.
    """
    half = np.asarray(size) / 2
    edges = np.minimum(centres - half - np.asarray(frame[:2]), np.asarray(frame[2:]) - centres - half)
    clear = np.minimum(edges.min(axis=1), _distances(centres, half, others))
    clear[_distances(centres, half, own) < CLEAR] = 0
    # Differences below a tenth of a millimetre are none: then the first is taken, on every machine.
    clear = np.round(np.minimum(clear, wish.ample), 1)
    best = int(clear.argmax())
    return np.asarray(centres[best]) if clear[best] >= wish.least else None


def _distances(centres: Points, half: Points, points: Points) -> Points:
    """Return how far the nearest of the points is from each box."""
    away = np.maximum(np.abs(centres[:, None] - points[None]) - half, 0)
    return np.asarray(np.hypot(away[..., 0], away[..., 1]).min(axis=1, initial=np.inf))


def box_points(centre: Points, size: tuple[float, float], spacing: float = 1.0) -> Points:
    """Return points all over a box, about so close together, which then is taken."""
    across, up = (np.linspace(-side / 2, side / 2, 2 + int(side / spacing)) for side in size)
    grid = np.stack(np.meshgrid(across, up), axis=-1).reshape(-1, 2)
    return np.asarray(centre + grid)
