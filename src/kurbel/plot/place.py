"""Where a label has room: the place farthest from all lines and other labels. Lengths in mm on the page."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

Points: TypeAlias = NDArray[np.float64]

Chosen: TypeAlias = NDArray[np.bool_]

# Left, bottom, right, top.
Box: TypeAlias = tuple[float, float, float, float]

# How far a label stands from its own line, and at least from anything.
GAP, CLEAR = 0.8, 0.6


class Clearance(NamedTuple):
    """The least distance from what is not a label's own; and so much that more is not better."""

    least: float
    ample: float


# Beside a line its label must be nearer to it than to any other; around a point no other can be meant.
BESIDE, AROUND = Clearance(GAP + CLEAR, 5.0), Clearance(CLEAR, 1.2)
# Where a label may be around a point: in so many directions, and so much farther than touching it.
DIRECTIONS, DISTANCES = 32, (0.0, 0.8, 1.6, 3.0)
# Degrees of free room around a label, and so much that it covers nothing but that from a line.
ROOMY, TIGHT = (1.4, 0.9, 0.5), 0.35
# Where a label that has no room may be moved to, the nearest first.
_SHIFTS = np.arange(-2.5, 2.6, 0.25)
_AROUND = np.stack(np.meshgrid(_SHIFTS, _SHIFTS), axis=-1).reshape(-1, 2)
_AROUND = _AROUND[np.hypot(*_AROUND.T).argsort(kind="stable")]


class Ink(NamedTuple):
    """Points on all that is drawn, and how much it counts that a label covers each."""

    points: Points
    weights: Points

    def more(self, points: Points, weight: float) -> Ink:
        weights = np.full(len(points), weight)
        return Ink(np.concatenate((self.points, points)), np.concatenate((self.weights, weights)))


class Labelled(NamedTuple):
    """Points on what a label belongs to, and how far it stands from them at least."""

    points: Points
    clear: float

    def without(self, ink: Ink) -> Ink:
        """Return the other ink: all that the label could touch only if it came too near to its own."""
        low, high = self.points.min(axis=0) - self.clear, self.points.max(axis=0) + self.clear
        rows = np.flatnonzero(((ink.points > low) & (ink.points < high)).all(axis=1))
        away = _distances(ink.points[rows], np.zeros(2), self.points)
        kept = np.ones(len(ink.points), bool)
        kept[rows[away < self.clear - 0.05]] = False
        return Ink(ink.points[kept], ink.weights[kept])


class LabelPlace(NamedTuple):
    """The centre of a label, the group of places it is from, and whether its box covers a line there."""

    centre: Points
    group: int
    covers: bool


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
    """Return the centres of a box of this size that touches a line, at both sides of every point.

    At first those on the left as the line goes.
    """
    slope = np.gradient(line, axis=0)
    length = np.hypot(*slope.T)[:, None]
    normal = np.stack((-slope[:, 1], slope[:, 0]), axis=1) / np.where(length, length, 1)
    return np.concatenate([line + side * normal * _reach(normal, size) for side in (1, -1)])


def around(point: Points, size: tuple[float, float], outward: Points) -> Points:
    """Return the centres of a box of this size near a point, the nearest first, in every direction.

    They begin in the direction outward and go on to both sides of it.
    """
    direction = _directions(outward)
    return np.concatenate([point + direction * (_reach(direction, size) + more) for more in DISTANCES])


def touching(point: Points, size: tuple[float, float], outward: Points, distances: Sequence[float]) -> Points:
    """Return the centres of a box of this size that comes so near to a point, likewise.

    Other than in `around` the box slides along the point: a long text may have its end there as well.
    """
    direction = _directions(outward)
    square = direction / np.abs(direction).max(axis=1)[:, None]
    half = np.asarray(size) / 2
    return np.concatenate([point + square * (half + GAP + more) for more in distances])


def _directions(outward: Points) -> Points:
    """Return directions of length 1, at first outward and on to both sides of it."""
    step = 2 * np.pi / DIRECTIONS
    turns = np.arange(DIRECTIONS) * step * np.resize((1, -1), DIRECTIONS)
    angles = np.arctan2(outward[1], outward[0]) + np.cumsum(turns)
    return np.stack((np.cos(angles), np.sin(angles)), axis=1)


def _reach(direction: Points, size: tuple[float, float]) -> Points:
    """Return how far the centre of a box must be from a line square to the direction."""
    return np.asarray((np.abs(direction) @ np.asarray(size) / 2 + GAP)[..., None])


def freest(
    centres: Points, size: tuple[float, float], own: Points, others: Points, frame: Box, wish: Clearance
) -> Points | None:
    """Return the centre whose box has most room, the first of several, or None if none has enough.

    own is the line to which the label belongs: it may be near, but not within the box.
    """
    half = np.asarray(size) / 2
    clear = np.minimum(_inside(centres, half, frame), _distances(centres, half, others))
    clear[_distances(centres, half, own) < CLEAR] = 0
    # Differences below a tenth of a millimetre are none: then the first is taken, on every machine.
    clear = np.round(np.minimum(clear, wish.ample), 1)
    best = int(clear.argmax())
    return np.asarray(centres[best]) if clear[best] >= wish.least else None


def nearest_to(point: Points, rivals: Points, centres: Points, size: tuple[float, float]) -> Points:
    """Return the centres whose boxes are nearer to a point than to each of its rivals."""
    half = np.asarray(size) / 2
    away = _distances(centres, half, rivals) if len(rivals) else np.full(len(centres), np.inf)
    return np.asarray(centres[_distances(centres, half, point[None]) < away])


def spot(
    groups: Sequence[Points],
    size: tuple[float, float],
    own: Labelled,
    ink: Ink,
    frame: Box,
    allowed: Callable[[Points], Chosen],
) -> LabelPlace | None:
    """Return where a label stands: at the first free place of the first group that has one.

    Of the allowed places of a group those with more room are better, by the degrees of ROOMY. Where no group
    has a free place the label covers as little ink as it can. None is for a label too large for the frame.
    """
    search = _Search(np.asarray(size) / 2, own, own.without(ink), frame, allowed)
    crowded = []
    for number, centres in enumerate(map(search.possible, groups)):
        place = search.free(centres)
        if place is not None:
            return LabelPlace(place, number, False)
        if len(centres):
            weight, place = search.least(centres)
            crowded.append((weight, number, place))
    if not crowded:
        return None
    weight, number, centre = min(crowded, key=lambda one: one[:2])
    place = search.free(search.possible(centre + _AROUND))
    return LabelPlace(centre, number, weight > 0) if place is None else LabelPlace(place, number, False)


class _Search(NamedTuple):
    """Half the size of a box, what it belongs to, the ink of all else, and where it may be."""

    half: Points
    own: Labelled
    ink: Ink
    frame: Box
    allowed: Callable[[Points], Chosen]

    def possible(self, centres: Points) -> Points:
        inside = (_inside(centres, self.half, self.frame) >= 0) & self.allowed(centres)
        apart = _distances(centres, self.half, self.own.points) >= self.own.clear
        return np.asarray(centres[inside & apart])

    def free(self, centres: Points) -> Points | None:
        """Return the first centre of those with most room, if any has enough."""
        room = _distances(centres, self.half, self._near(centres).points)
        found = [centres[int((room >= least).argmax())] for least in ROOMY if (room >= least).any()]
        return np.asarray(found[0]) if found else None

    def least(self, centres: Points) -> tuple[float, Points]:
        """Return the least weight of ink in a box, and its centre."""
        near = self._near(centres)
        within = (np.abs(centres[:, None] - near.points[None]) - self.half < TIGHT).all(axis=2)
        covered = np.round(within @ near.weights, 2)
        return float(covered.min()), np.asarray(centres[int(covered.argmin())])

    def _near(self, centres: Points) -> Ink:
        """Return the ink that any of the boxes is near to: the rest costs time and alters nothing."""
        low = (centres - self.half).min(axis=0, initial=np.inf) - ROOMY[0]
        high = (centres + self.half).max(axis=0, initial=-np.inf) + ROOMY[0]
        kept = ((self.ink.points >= low) & (self.ink.points <= high)).all(axis=1)
        return Ink(self.ink.points[kept], self.ink.weights[kept])


def _inside(centres: Points, half: Points, frame: Box) -> Points:
    """Return how far each box is inside of the frame."""
    edges = np.minimum(centres - half - np.asarray(frame[:2]), np.asarray(frame[2:]) - centres - half)
    return np.asarray(edges.min(axis=1))


def _distances(centres: Points, half: Points, points: Points) -> Points:
    """Return how far the nearest of the points is from each box."""
    # By coordinates, and a root for each box alone: a third of the time of hypot for each pair.
    across, up = (
        np.maximum(np.abs(centres[:, None, axis] - points[None, :, axis]) - half[axis], 0) for axis in (0, 1)
    )
    return np.asarray(np.sqrt((across**2 + up**2).min(axis=1, initial=np.inf)))


def box_points(centre: Points, size: tuple[float, float], spacing: float = 1.0) -> Points:
    """Return points all over a box, about so close together, which then is taken."""
    across, up = (np.linspace(-side / 2, side / 2, 2 + int(side / spacing)) for side in size)
    grid = np.stack(np.meshgrid(across, up), axis=-1).reshape(-1, 2)
    return np.asarray(centre + grid)
