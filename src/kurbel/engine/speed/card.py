"""The speed over the turn of an engine whose piston force comes from an indicator card: floats with an error.

The error comes from the work that the card supports, as that of its turn does (`engine/digits.py`).
"""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kurbel.drive.wheel import Wheel
from kurbel.engine.card.force import CardTurn
from kurbel.engine.cylinder import Cylinder
from kurbel.engine.speed.run import SAMPLES, AnyRun, Run, SampledRun, top
from kurbel.kernel.circle import Numeric

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

    def turned(self, half_turns: Fraction) -> Numeric:
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
        nodes = np.array(self._edges())
        elapsed = self._elapsed(nodes[:-1], nodes[1:])
        return nodes, np.concatenate([[0.0], np.cumsum(elapsed)])

    def _edges(self) -> list[float]:
        """The cells of equal width and all dead centres, over the cycle."""
        turn = self.turn
        turns, first = turn.cycle // 2, float(turn.cylinder.drive.dead_centre(0))
        dead_centres = {
            (float(start + stroke) + float(cylinder.drive.dead_centre(stroke % 2)) - first) % turn.cycle
            + first
            for start, cylinder in turn.cranks()
            for stroke in range(turn.cycle)
        }
        return sorted(dead_centres | {first + 2 * index / CELLS for index in range(turns * CELLS + 1)})

    def _elapsed(self, starts: Floats, ends: Floats) -> Floats:
        """The time from each place to another in the same cell."""
        half = (ends - starts) / 2
        places = starts[:, None] + half[:, None] * (1 + POINTS)
        return np.asarray(half * (SHARES / self.speeds(places)).sum(axis=1))

    def speeds(self, places: Floats) -> Floats:
        """Return v/v₁ at an array of half turns."""
        return np.asarray(self.speed_of(self.turn.energies(places)))


class HeavyCardRun(CardRun):
    """A turn by a card with moving masses against a constant torque."""

    acceleration = AnyRun.acceleration

    def __init__(self, turn: CardTurn, wheel: Wheel) -> None:
        # Without masses, whether it comes to rest is known by the excess alone.
        AnyRun.__init__(self, turn, wheel)
        self._begun = sum(turn.cylinders[part].still.energy(*one) for part, *one in turn.begun())
        mean, first = abs(float(turn.mean_force())), float(turn.kinetic_energy_begun())
        half = float(self.at_mean if wheel.number is None else wheel.number) * mean / 2
        self._degrees = 180 * float(turn.cylinder.drive.dead_centre(0))
        places = self._degrees / 180 + 2 * np.arange(turn.cycle // 2 * SAMPLES) / SAMPLES
        works, energies = self._courses(places)
        self._sampled = SampledRun(works.tolist(), energies.tolist(), half, first, wheel.number is not None)

    @cached_property
    def start(self) -> float:
        """u, the square of ω₁/ω_m."""
        return self._sampled.start(self, self._degrees)

    @property
    def number(self) -> Numeric:
        if self.wheel.number is not None:
            return float(self.wheel.number)
        return float(self.at_mean) * self.start

    @property
    def first_omega(self) -> Numeric:
        return self.mean_omega * float(self.start**0.5)

    def speed(self, half_turns: Fraction) -> Numeric:
        return float(self.speeds(np.array([float(half_turns)]))[0])

    def speeds(self, places: Floats) -> Floats:
        works, energies = self._courses(places)
        own = self._sampled.half / (self.start if self._sampled.by_number else 1)
        level = (own + self._sampled.first) * self.start
        return np.sqrt((level + works) / (own + energies) / self.start)

    def extreme_speed(self, greatest: bool) -> Numeric:
        squares = self._sampled.squares(self.start)
        found = top(squares) if greatest else -top([-one for one in squares])
        return float((found / self.start) ** 0.5)

    def extreme_place(self, greatest: bool) -> Numeric:
        squares = self._sampled.squares(self.start)
        index = squares.index(max(squares) if greatest else min(squares))
        return self._degrees / 180 + 2 * index / SAMPLES

    def place_error(self, greatest: bool, stroke: int | None) -> float:
        return max(super().place_error(greatest, stroke), 1 / SAMPLES)

    def _courses(self, places: Floats) -> tuple[Floats, Floats]:
        """Work and energy at an array of half turns."""

        def work(one: Cylinder, stroke: int, angle: Floats) -> Floats:
            return np.asarray(one.still.energy(stroke, angle))

        total = self.turn.total
        return total(work, places, -float(self._begun)), total(Cylinder.kinetic_energy, places, 0.0)
