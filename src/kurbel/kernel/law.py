"""The pressure in one end of a cylinder over the share of the stroke: constant, p V^n = const, or of cubics.

Pressures are in any one unit, work in that unit times the whole stroke. The share counts from the dead centre
at which the stroke begins, 0 to 1, whichever end it is: the volume of the end that the piston leaves grows as
clearance + share, that of the other shrinks as clearance + 1 - share. Numbers are floats, arrays, balls or
what compares as they do; a ball that lies over a corner gives one that holds both sides.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from functools import reduce
from typing import Any, NamedTuple, Protocol, TypeAlias

from kurbel.kernel.circle import Numeric
from kurbel.kernel.steam import Expansion, expansion_work, larger, power, smaller


class Piece(Protocol):
    """A pressure between two corners or over the whole stroke, and its work up to a share from another on."""

    def pressure(self, share: Numeric) -> Numeric: ...

    def work(self, share: Numeric, start: Numeric = 0) -> Numeric: ...

    def slope(self, share: Numeric) -> Numeric: ...


class Constant(NamedTuple):
    """A pressure that does not change."""

    level: Numeric

    def pressure(self, share: Numeric) -> Numeric:
        return self.level

    def work(self, share: Numeric, start: Numeric = 0) -> Numeric:
        return self.level * (share - start)

    def slope(self, share: Numeric) -> Numeric:
        return 0 * self.level


class Line(NamedTuple):
    """A pressure that changes evenly from one share of the stroke to another."""

    first: Numeric
    last: Numeric
    start: Numeric
    end: Numeric

    def pressure(self, share: Numeric) -> Numeric:
        return self.first + self._rise() * (share - self.start)

    def work(self, share: Numeric, start: Numeric = 0) -> Numeric:
        return (self.pressure(start) + self.pressure(share)) / 2 * (share - start)

    def slope(self, share: Numeric) -> Numeric:
        return self._rise() + 0 * share

    def _rise(self) -> Numeric:
        return (self.last - self.first) / (self.end - self.start)


class Polytrope(NamedTuple):
    """p V^n = const through a pressure at a volume, where V is the first volume plus or minus the share.

    Volumes are shares of the volume swept in a stroke; `growing` is 1 or -1. n = 1 is Mariotte's law.
    """

    level: Numeric
    volume: Numeric
    exponent: Numeric
    first: Numeric
    growing: int

    def pressure(self, share: Numeric) -> Numeric:
        return self.level * power(self.volume / self._filled(share), self.exponent)

    def work(self, share: Numeric, start: Numeric = 0) -> Numeric:
        """Return the work on the piston as it moves on; that of a shrinking volume is the pressure's own."""
        begun = self._filled(start)
        gain = expansion_work(self._filled(share) / begun, self.exponent)
        return self.pressure(start) * begun * self.growing * gain

    def slope(self, share: Numeric) -> Numeric:
        return -self.exponent * self.growing * self.pressure(share) / self._filled(share)

    def _filled(self, share: Numeric) -> Numeric:
        return self.first + self.growing * share


class Law(NamedTuple):
    """The pieces of a stroke in their order, and the shares of the corners at which they meet.

    At a corner the pressure is continuous, unless two pieces have another there; then a float or an array has
    the pressure before it.
    """

    pieces: tuple[Piece, ...]
    corners: tuple[Numeric, ...] = ()

    def pressure(self, share: Numeric) -> Numeric:
        """Return the pressure at a share of the stroke."""
        return self._at(share, lambda index, at: self.pieces[index].pressure(at))

    def work(self, share: Numeric) -> Numeric:
        """Return ∫ of the pressure over the share from the dead centre on."""
        return self._at(share, self._work)

    def slope(self, share: Numeric) -> Numeric:
        """Return the change of the pressure with the share."""
        return self._at(share, lambda index, at: self.pieces[index].slope(at))

    def whole(self) -> Numeric:
        """Return the work of the whole stroke, on numbers that need not compare."""
        ends = zip(self.pieces, (0, *self.corners), (*self.corners, 1), strict=True)
        return sum(piece.work(end, start) for piece, start, end in ends)

    def around(self, share: Numeric) -> tuple[int, ...]:
        """Return the pieces on which a float or a ball lies: at a corner those on both sides."""
        last = len(self.corners)
        return tuple(
            index
            for index in range(last + 1)
            if not (index and share < self.corners[index - 1])
            and not (index < last and share > self.corners[index])
        )

    def _at(self, share: Numeric, value: Callable[[int, Numeric], Numeric]) -> Numeric:
        if not self.corners:
            return value(0, share)
        if hasattr(share, "shape"):
            return self._of_array(share, value)
        if hasattr(share, "piecewise"):
            every = [value(index, self._within(index, share)) for index in range(len(self.pieces))]
            return share.piecewise(self.corners, every)
        return _either([value(index, self._within(index, share)) for index in self.around(share)])

    def _of_array(self, share: Any, value: Callable[[int, Numeric], Numeric]) -> Numeric:
        import numpy as np

        every = [value(index, self._within(index, share)) + 0 * share for index in range(len(self.pieces))]
        return np.select([share <= corner for corner in self.corners], every[:-1], every[-1])

    def _within(self, index: int, share: Numeric) -> Numeric:
        """Return the share as far as it lies on a piece: beyond it the volume may be nothing."""
        if index:
            share = larger(share, self.corners[index - 1])
        return smaller(share, self.corners[index]) if index < len(self.corners) else share

    def _work(self, index: int, share: Numeric) -> Numeric:
        starts = (0 * share, *self.corners)
        before = (self.pieces[one].work(starts[one + 1], starts[one]) for one in range(index))
        return sum(before, self.pieces[index].work(share, starts[index]))


class Cubics:
    """A pressure by cubics between rising knots, on floats, arrays and balls; beyond the knots it stays.

    Of the four rows of `powers` each has a coefficient of all pieces, the cube's first, of the share since
    the knot where a piece begins. They are float64 arrays. At the `corners` the slope jumps.
    """

    def __init__(self, knots: Any, powers: Any, corners: Sequence[float] = ()) -> None:
        begun = 0.0 * knots[1:]
        begun[1:] = _work((*powers, 0.0), knots[1:] - knots[:-1])[:-1].cumsum()
        self.knots, self.powers, self.corners = knots, powers, tuple(corners)
        self._places: list[float] = knots.tolist()
        self._rows = (*powers, begun)
        self._pieces = [*zip(*(row.tolist() for row in self._rows), strict=True)]

    def pressure(self, share: Numeric) -> Numeric:
        """Return the pressure at a share of the stroke."""
        return self._at(share, _pressure)

    def work(self, share: Numeric) -> Numeric:
        """Return ∫ of the pressure over the share from the first knot on, exact for the cubics."""
        return self._at(share, _work)

    def slope(self, share: Numeric) -> Numeric:
        """Return the change of the pressure with the share; of a ball over a knot that on both sides."""
        return self._at(share, _slope)

    def _at(self, share: Any, value: Callable[[Sequence[Numeric], Numeric], Numeric]) -> Numeric:
        if hasattr(share, "shape"):
            within = share.clip(self.knots[0], self.knots[-1])
            index = self.knots[1:-1].searchsorted(within, "right")
            return value([row[index] for row in self._rows], within - self.knots[index])
        low, high = (share.lower(), share.upper()) if hasattr(share, "union") else (share, share)
        first, last = (bisect_right(self._places, end, 1, len(self._places) - 1) - 1 for end in (low, high))
        return _either([self._piece(index, share, value) for index in range(first, last + 1)])

    def _piece(
        self, index: int, share: Numeric, value: Callable[[Sequence[Numeric], Numeric], Numeric]
    ) -> Numeric:
        """Return the value on a piece, at the share as far as it lies on that."""
        begin, end = self._places[index : index + 2]
        return value(self._pieces[index], smaller(larger(share, begin), end) - begin)


# Of a cubic at a share since its knot. No coefficient is multiplied before: in floats that would be rounded,
# and the slope would be that of another cubic.
def _pressure(piece: Sequence[Numeric], at: Numeric) -> Numeric:
    cube, square, line, level, _ = piece
    return ((cube * at + square) * at + line) * at + level


def _slope(piece: Sequence[Numeric], at: Numeric) -> Numeric:
    cube, square, line, _, _ = piece
    return (3 * (cube * at) + 2 * square) * at + line


def _work(piece: Sequence[Numeric], at: Numeric) -> Any:
    cube, square, line, level, begun = piece
    return (((0.75 * (cube * at) + square) * at / 3 + line / 2) * at + level) * at + begun


Side: TypeAlias = Piece | Law | Cubics | Expansion
"""What the pressure in one end of a cylinder is; a piece alone fills the stroke."""


class Stroke(NamedTuple):
    """A stroke of the piston between two ends of a cylinder: the law behind it less the law before it.

    `areas` are those of the piston behind and before it as shares of the bore's, None without rods. What the
    `friction` takes is a pressure on the bore, too. Of pressures that do not change an array has the one.
    """

    behind: Side
    before: Side
    areas: tuple[Numeric, Numeric] | None = None
    friction: Numeric | None = None

    def force(self, share: Numeric) -> Numeric:
        """Return the net pressure in the direction of the stroke."""
        found = self._net(self.behind.pressure(share), self.before.pressure(share))
        return found if self.friction is None else found - self.friction

    def work(self, share: Numeric) -> Numeric:
        """Return the work done on the piston from the dead centre to a share of the stroke."""
        found = self._net(self.behind.work(share), self.before.work(share))
        return found if self.friction is None else found - self.friction * share

    def slope(self, share: Numeric) -> Numeric:
        """Return the change of the force with the share."""
        return self._net(self.behind.slope(share), self.before.slope(share))

    @property
    def corners(self) -> tuple[Numeric, ...]:
        """The shares within the stroke at which the force has a corner or jumps, in no order."""
        sides = (self.behind, self.before)
        return tuple(corner for side in sides for corner in getattr(side, "corners", ()))

    def _net(self, behind: Numeric, before: Numeric) -> Numeric:
        if self.areas is None:
            return behind - before
        return self.areas[0] * behind - self.areas[1] * before


def _either(values: Sequence[Any]) -> Numeric:
    """Return what holds all values; of floats, which meet at the corner, the first."""
    return reduce(lambda one, other: one.union(other), values) if hasattr(values[0], "union") else values[0]
