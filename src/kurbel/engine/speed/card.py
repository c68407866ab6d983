"""The speed over the turn of an engine whose piston force comes from an indicator card: floats with an error.

The error comes from the work that the card supports, as that of its turn does (`engine/digits.py`).
"""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kurbel.engine.card.turn import CardTurn
from kurbel.engine.speed.run import Run
from kurbel.kernel.circle import Number

Floats: TypeAlias = NDArray[np.float64]

# Cells of the turn, over each of which three points of Gauss give the time.
CELLS = 1440
POINTS, SHARES = np.polynomial.legendre.leggauss(3)


class CardRun(Run):
    """The run of a turn by a card."""

    turn: CardTurn

    @cached_property
    def coarser(self) -> tuple[CardRun, ...]:
        """The runs by the two cards that have every second point."""
        return tuple(type(self)(half, self.wheel) for half in self.turn.coarser)

    @property
    def gain(self) -> float:
        return self.turn.gain

    @property
    def step(self) -> float:
        return self.turn.step

    @property
    def work_apart(self) -> float:
        return self.turn.work_apart

    def place_error(self, greatest: bool, stroke: int | None) -> float:
        return self.turn.place_error(greatest, stroke)

    def sensitivity(self, key: str, value: float, swing: float) -> float:
        """How far a quantity is off where the work of a stroke is off by 1, and the energy swing by so much.

        By that much an excess is off at most, as the difference of two of them is.
        """
        least = float(self.extreme_speed(greatest=False))
        # By inertia the number is off as well, by twice the swing of which the speed takes a share δ.
        of_speed = swing * (1 + 3 * float(self.irregularity())) / (float(self.number) * least * least)
        match key.partition("_")[0]:
            case "number":
                return 0.0 if self.wheel.number is not None else 2 * swing
            case "speed" | "delta":
                return of_speed
            case "one":
                return of_speed * value * value
        # The speed at the angle and at the dead centre.
        return 2 * of_speed * value

    def turned(self, half_turns: Fraction) -> Number:
        """Return the time in half turns at v₁."""
        nodes, times = self._course
        before, rest = divmod(float(half_turns) - nodes[0], self.turn.cycle)
        place = nodes[0] + rest
        index = int(np.searchsorted(nodes, place, side="right")) - 1
        begun = times[index] + self._elapsed(nodes[index : index + 1], np.array([place]))[0]
        return float(before * times[-1] + begun)

    @cached_property
    def _course(self) -> tuple[Floats, Floats]:
        """The bounds of the cells and the time there; dead centres are bounds."""
        nodes = np.array(self.turn.samples(CELLS))
        elapsed = self._elapsed(nodes[:-1], nodes[1:])
        return nodes, np.concatenate([[0.0], np.cumsum(elapsed)])

    def _elapsed(self, starts: Floats, ends: Floats) -> Floats:
        """The time from each place to another in the same cell."""
        half = (ends - starts) / 2
        places = starts[:, None] + half[:, None] * (1 + POINTS)
        elapsed: Floats = half * (SHARES / self.speeds(places)).sum(axis=1)
        return elapsed

    def speeds(self, places: Floats) -> Floats:
        """Return v/v₁ at an array of half turns."""
        found: Floats = self.speed_of(self.turn.energies(places))
        return found
