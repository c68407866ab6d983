"""What moves in a drawing over a run of crank angles. A film is drawn as it stands at one of them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kurbel.plot.place import Chosen, Points

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

# A turn in so many steps: between two of them a joint leaves a straight way by less than 0.001 mm.
STEPS = 720


class Way(NamedTuple):
    """Numbers at rising angles, a row for each; where an angle comes twice they jump."""

    angles: Points
    rows: Points

    def at(self, angle: float) -> Points:
        """Return the numbers at an angle, on the way between two rows; at a jump those before it."""
        return np.asarray([np.interp(angle, self.angles, column) for column in self.rows.T])


class Part(NamedTuple):
    """Artists of one axes that move as one, without a change of size.

    The way has the place of one of their points, in values of the axes, and by how many degrees they have
    turned, counter-clockwise; so many mm they reach beyond the point.
    """

    name: str
    artists: tuple[Artist, ...]
    axes: Axes
    way: Way
    reach: float = 0.0


class Grown(NamedTuple):
    """A line of which a share from its beginning is seen."""

    name: str
    line: Any
    axes: Axes
    way: Way

    def points_at(self, angle: float) -> Points:
        """Return the points of what is seen of the whole line at an angle."""
        points = np.asarray(self.line.get_xydata())
        lengths = np.concatenate(((0,), np.hypot(*np.diff(points, axis=0).T).cumsum()))
        end = float(self.way.at(angle)[0]) * lengths[-1]
        tip = [np.interp(end, lengths, column) for column in points.T]
        return np.vstack((points[lengths < end], tip))


class Seen(NamedTuple):
    """Artists that are seen where their way is 1 and not where it is 0, which it becomes by jumps alone."""

    name: str
    artists: tuple[Artist, ...]
    way: Way


class Film(NamedTuple):
    """A run from one crank angle to another in so many seconds, over and over, drawn as it stands `at` one.

    `above` are artists that stand still before what moves.
    """

    first: float
    last: float
    at: float
    seconds: float
    parts: tuple[Part, ...] = ()
    grown: tuple[Grown, ...] = ()
    seen: tuple[Seen, ...] = ()
    above: tuple[Artist, ...] = ()

    def share(self, angle: float) -> float:
        """Return the share of the run at an angle."""
        return (angle - self.first) / (self.last - self.first)


def straight_way(first: float, last: float, rows: tuple[tuple[float, ...], tuple[float, ...]]) -> Way:
    """Return the way that goes evenly from one row to another."""
    return Way(np.asarray((first, last)), np.asarray(rows))


def crossing(angles: Points, other: Chosen, first: Points, second: Points) -> tuple[Points, Points]:
    """Return the angles and the rows of what has the first rows, or where it is so the second ones; it jumps
    where that changes."""
    changes = np.flatnonzero(np.diff(other.astype(int))) + 1
    order = np.sort(np.concatenate((np.arange(len(angles)), changes)))
    is_other = other[order]
    # Of the two rows at a change the first has what was before.
    before = np.flatnonzero(np.diff(order) == 0)
    is_other[before] = ~is_other[before]
    return angles[order], np.where(is_other[:, None], second[order], first[order])


def toggled(angles: Points, seen: Chosen) -> Way:
    """Return the way of what is seen at some angles: it jumps at each of them where that changes."""
    unseen = np.zeros((len(angles), 1))
    return Way(*crossing(angles, seen, unseen, unseen + 1))


@contextmanager
def as_it_stands(film: Film) -> Iterator[None]:
    """Draw what is seen of a film where it stands: the shares of lines, and nothing that is unseen there."""
    whole = [(grown.line, np.array(grown.line.get_xydata())) for grown in film.grown]
    unseen = {one for seen in film.seen if not seen.way.at(film.at)[0] for one in seen.artists}
    try:
        for grown in film.grown:
            grown.line.set_data(*grown.points_at(film.at).T)
        for one in unseen:
            one.set_visible(False)
        yield
    finally:
        for line, points in whole:
            line.set_data(*points.T)
        for one in unseen:
            one.set_visible(True)
