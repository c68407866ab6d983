"""The speed over the turn with moving masses by an indicator card: in floats what solved.py does in balls."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property

import numpy as np

from kurbel.drive.wheel import Wheel
from kurbel.engine.card.turn import CardTurn
from kurbel.engine.cylinder import Cylinder
from kurbel.engine.speed.card import CardRun, Floats
from kurbel.engine.speed.run import AnyRun
from kurbel.engine.speed.samples import SAMPLES, Sampled, top
from kurbel.kernel.circle import Number


class HeavyCardRun(CardRun):
    """A turn by a card with moving masses against a constant torque."""

    def __init__(self, turn: CardTurn, wheel: Wheel) -> None:
        # Without masses, whether it comes to rest is known by the excess alone.
        AnyRun.__init__(self, turn, wheel)
        self._begun = sum(turn.cylinders[part].still.energy(*one) for part, *one in turn.begun())
        mean, first = abs(float(turn.mean_force())), float(turn.kinetic_energy_begun())
        half = float(self.at_mean if wheel.number is None else wheel.number) * mean / 2
        self._degrees = 180 * float(turn.cylinder.drive.dead_centre(0))
        places = self._degrees / 180 + 2 * np.arange(turn.cycle // 2 * SAMPLES) / SAMPLES
        works, energies = self._courses(places)
        self._sampled = Sampled(works.tolist(), energies.tolist(), half, first, wheel.number is not None)

    @cached_property
    def start(self) -> float:
        """u, the square of ω₁/ω_m."""
        return self._sampled.start(self, self._degrees)

    @property
    def number(self) -> Number:
        if self.wheel.number is not None:
            return float(self.wheel.number)
        return float(self.at_mean) * self.start

    @property
    def first_omega(self) -> Number:
        return self.mean_omega * self.start**0.5

    def speed(self, half_turns: Fraction) -> Number:
        return float(self.speeds(np.array([float(half_turns)]))[0])

    def speeds(self, places: Floats) -> Floats:
        works, energies = self._courses(places)
        own = self._sampled.half / (self.start if self._sampled.by_number else 1)
        level = (own + self._sampled.first) * self.start
        found: Floats = np.sqrt((level + works) / (own + energies) / self.start)
        return found

    def extreme_speed(self, greatest: bool) -> Number:
        squares = self._sampled.squares(self.start)
        found = top(squares) if greatest else -top([-one for one in squares])
        return (found / self.start) ** 0.5

    def extreme_place(self, greatest: bool) -> Number:
        squares = self._sampled.squares(self.start)
        index = squares.index(max(squares) if greatest else min(squares))
        return self._degrees / 180 + 2 * index / SAMPLES

    def place_error(self, greatest: bool, stroke: int | None) -> float:
        return max(super().place_error(greatest, stroke), 1 / SAMPLES)

    def _courses(self, places: Floats) -> tuple[Floats, Floats]:
        """Work and energy at an array of half turns."""

        def work(one: Cylinder, stroke: int, angle: Floats) -> Floats:
            found: Floats = one.still.energy(stroke, angle)
            return found

        total = self.turn.total
        return total(work, places, -float(self._begun)), total(Cylinder.kinetic_energy, places, 0.0)
