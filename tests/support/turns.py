"""A cycle of a machine by quadrature: energies and their extremes, harmonics, and the speed of a flywheel."""

from __future__ import annotations

import math
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import ArrayLike
from scipy.optimize import brentq
from strokes import Grid

if TYPE_CHECKING:
    from machines import Machine

NODES, WEIGHTS = legendre.leggauss(12)
# From values at the nodes to the coefficients of their polynomial.
PARTS = np.linalg.inv(legendre.legvander(NODES, 11))


class Extreme(NamedTuple):
    """A place at which the excess changes its sign: the speed is least where it rises."""

    degrees: float
    energy: float
    rising: bool


class Turn:
    """A cycle from the first crank's inner dead centre: forces and energies in cells between all corners."""

    def __init__(self, machine: Machine, cells: int = 180) -> None:
        begin, cycle = machine.dead_centres[0], machine.cycle
        corners = [machine.angles_of(index, one.corners) for index, one in enumerate(machine.strokes)]
        turned = [np.asarray(machine.dead_centres) + turn for turn in range(0, cycle, 360)]
        own = np.concatenate([*corners, *turned])
        kinks = np.concatenate([np.mod(own + crank - begin, cycle) for crank in machine.cranks])
        edges = np.unique(np.concatenate([np.linspace(0, cycle, cells + 1), kinks]))
        edges = edges[np.diff(edges, prepend=-1) > 1e-9]
        edges[-1] = cycle
        self.machine, self.edges = machine, begin + edges
        self.half = np.radians(np.diff(edges)) / 2
        self.angles = begin + (edges[:-1] + edges[1:])[:, None] / 2 + np.degrees(self.half)[:, None] * NODES
        self.force, power = machine.force(self.angles), machine.power(self.angles)
        self.mean = float((self.half * (power @ WEIGHTS)).sum() / math.radians(cycle))
        self.excess = power - self.mean
        self.energy, self.sums = self.integral(self.excess)

    def integral(self, values: Grid) -> tuple[Grid, Grid]:
        """Return the integral from the beginning to the nodes of the cells and to their edges."""
        parts = self.half[:, None] * (values @ PARTS.T)
        inside = legendre.legval(NODES, legendre.legint(parts, axis=1, lbnd=-1).T)
        sums = np.concatenate([[0.0], np.cumsum(self.half * (values @ WEIGHTS))])
        return sums[:-1, None] + inside, sums

    def at(self, values: Grid, degrees: ArrayLike) -> Grid:
        """Return values of the nodes at other angles of this cycle."""
        begin, cycle = self.edges[0], self.machine.cycle
        angles = np.atleast_1d(begin + np.mod(np.asarray(degrees, dtype=float) - begin, cycle))
        cells = np.clip(np.searchsorted(self.edges, angles, side="right") - 1, 0, len(self.half) - 1)
        inside = np.radians(angles - self.edges[cells]) / self.half[cells] - 1
        parts = values[cells] @ PARTS.T
        return np.einsum("ij,ij->i", legendre.legvander(inside, 11), parts)

    @cached_property
    def extremes(self) -> list[Extreme]:
        """All places at which the speed is stationary, in order."""
        parts = self.excess @ PARTS.T
        places = np.array([-1.0, *NODES, 1.0])
        heights = legendre.legval(places, parts.T)
        # The end of the cell before, for a force may leap at an edge.
        heights = np.column_stack([np.roll(heights[:, -1], 1), heights])
        found = []
        for cell, index in np.argwhere(heights[:, :-1] * heights[:, 1:] < 0):
            part, half, root = parts[cell], self.half[cell], -1.0
            if index:
                root = brentq(legendre.legval, *places[index - 1 : index + 1], args=(part,), xtol=1e-14)
            work = legendre.legval(root, legendre.legint(half * part, lbnd=-1))
            degrees = self.edges[cell] + math.degrees(half * (root + 1))
            rising = bool(heights[cell, index + 1] > 0)
            found.append(Extreme(float(degrees), float(self.sums[cell] + work), rising))
        return found

    def extreme(self, greatest: bool) -> Extreme:
        """The place of the greatest or the least speed of the cycle."""
        return (max if greatest else min)(self.extremes, key=lambda one: one.energy)

    @property
    def swing(self) -> float:
        return self.extreme(True).energy - self.extreme(False).energy

    @property
    def delta(self) -> float:
        """δ in units of |P| r/(m₁ v₁²)."""
        return self.swing / abs(self.mean)

    def harmonic(self, order: float) -> complex:
        """Return a_k - i b_k of the tangential force, angles from the slide direction of the first crank."""
        wave = self.force * np.exp(-1j * order * np.radians(self.angles))
        return complex(2 * (self.half * (wave @ WEIGHTS)).sum() / math.radians(self.machine.cycle))


class Speed:
    """The speed over the cycle, whose extremes have the mean 1, and the time since the inner dead centre."""

    def __init__(self, machine: Machine, inertia: float | None, number: float, square: bool) -> None:
        self.turn = machine.turn
        if square:
            self._against_its_square(number)
        else:
            self._against_a_constant(machine, inertia, number)
        self.least, self.greatest = _range(self.omega)
        self.time, _ = self.turn.integral(1 / self.omega)

    def _against_a_constant(self, machine: Machine, inertia: float | None, number: float) -> None:
        """½ (J + m) ω² is its beginning and the work of load and weight."""
        turn, angles, masses = self.turn, np.radians(self.turn.angles), machine.masses
        begin = np.radians(turn.edges[:1])
        # What of the rod turns evenly with the crank pin is in the flywheel.
        even = masses.rod * masses.centre * len(machine.cranks)
        moving, first = (2 * machine.kinetic(one) - even for one in (angles, begin))
        work = turn.energy + machine.kinetic(angles) - machine.kinetic(begin)

        def speeds(begun: float) -> Grid:
            own = inertia if inertia is not None else number * abs(turn.mean) / begun**2
            return np.sqrt(np.maximum(0, ((own + first[0]) * begun**2 + 2 * work) / (own + moving)))

        self.first = float(brentq(lambda begun: sum(_range(speeds(begun))) - 2, 0.5, 2, xtol=1e-14))
        self.omega = speeds(self.first)

    def _against_its_square(self, number: float) -> None:
        """y = ½ J ω² has y' = T - k y, and comes again after the cycle."""
        turn = self.turn
        since, span = np.radians(turn.angles - turn.edges[0]), math.radians(turn.machine.cycle)

        def energies(factor: float) -> tuple[Grid, float]:
            nodes, sums = turn.integral(np.exp(factor * (since - span)) * turn.force)
            begun = sums[-1] / (1 - math.exp(-factor * span))
            return np.exp(factor * (span - since)) * nodes + np.exp(-factor * since) * begun, float(begun)

        wanted = number * turn.mean / 2
        ends = 0.01 / number, min(10 / number, 60)
        factor = brentq(lambda factor: energies(factor)[1] - wanted, *ends, xtol=1e-15)
        speeds, begun = energies(factor)
        mean = sum(_range(np.sqrt(speeds))) / 2
        self.omega, self.first = np.sqrt(speeds) / mean, math.sqrt(begun) / mean

    @property
    def delta(self) -> float:
        return self.greatest - self.least

    def at(self, degrees: ArrayLike) -> tuple[Grid, Grid]:
        """Return speed and time at angles."""
        return self.turn.at(self.omega, degrees), self.turn.at(self.time, degrees)


def _range(speeds: Grid) -> tuple[float, float]:
    """Return the least and the greatest speed, of parabolas through the nodes."""
    return -_top(-speeds), _top(speeds)


def _top(values: Grid) -> float:
    part = PARTS @ values[np.unravel_index(values.argmax(), values.shape)[0]]
    heights = legendre.legval(np.linspace(-1, 1, 2001), part)
    place = int(heights.argmax())
    if not 0 < place < 2000:
        return float(heights[place])
    before, at, after = heights[place - 1 : place + 2]
    return float(at - (after - before) ** 2 / (8 * (before - 2 * at + after)))
