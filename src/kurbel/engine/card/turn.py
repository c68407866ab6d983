"""A turn of an engine whose piston force comes from an indicator card: in floats, with an error estimate.

What the points of a card do not say, no arithmetic knows. The same turn is therefore computed from every
second point, twice; by how far those results differ from the result of all points tells how many digits the
card supports.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from operator import methodcaller
from typing import Any

import numpy as np

from kurbel.drive.at import CrankForce
from kurbel.engine.arrays import FloatTurn
from kurbel.engine.card.card import Diagram
from kurbel.engine.engine import Assembly, Engine
from kurbel.errors import CardError, ProblemError

# Of a stroke.
SAMPLES = 721
LEAST_FORCE = 1e-9
# Cubics gain a factor of 16 with twice the points; noise may seem to gain 8 by chance.
MOST_GAIN = 8.0
NOTHING = 1e-300
# Half turns over which a slope is taken.
BESIDE = 1e-3


class CardTurn(FloatTurn):
    """One turn by a method: exact or series kinematics."""

    def __init__(self, engine: Engine | Assembly, method: str) -> None:
        if method == "weisbach":
            raise ProblemError(
                'method "weisbach" has no equations for an indicator card; use exact or series'
            )
        super().__init__(engine, method)
        self.diagrams = tuple(part.steam for part in engine.parts if isinstance(part.steam, Diagram))
        self.diagram = self.diagrams[0]
        mean = round(float(self.mean_force()) / len(engine.cranks), 12) + 0.0
        # Half a card, in the unit of the whole, may well do no work.
        if self.diagram.unit is None and abs(mean) < LEAST_FORCE:
            raise CardError(
                f"{self.diagram.card.name} does no work: the mean tangential force is {mean:.3g} Q,"
                " and it must be above 0, or below where the shaft drives the piston; p_forward drives it,"
                " p_return resists it"
            )

    @cached_property
    def coarser(self) -> tuple[CardTurn, ...]:
        """The turns of the cards that have every second point of these, in the same Q."""
        return tuple(CardTurn(engine, self.method) for engine in self._halves())

    def _halves(self) -> Iterator[Engine | Assembly]:
        parts = [
            [replace(part, steam=half) for half in part.steam.halves()]
            if isinstance(part.steam, Diagram)
            else [part, part]
            for part in self.engine.parts
        ]
        for half in zip(*parts, strict=True):
            yield half[0] if len(half) == 1 else Assembly(half)

    @cached_property
    def gain(self) -> float:
        """How many times nearer to the truth twice the points have come; 1 for noise."""
        before = max(half.work_apart for half in self.coarser)
        return min(max(before / (self.work_apart + NOTHING), 1.0), MOST_GAIN)

    @cached_property
    def work_apart(self) -> float:
        """The greatest difference of work from the coarser cards', at any share of the strokes, in 2 Q R."""
        return max(float(abs(one).max()) for one in self._apart("work"))

    @cached_property
    def force_apart(self) -> float:
        """The mean difference of force from the coarser cards', and the step of the pressures, in Q."""
        return float(np.sqrt(np.mean(np.square(self._apart("force"))))) + self.step

    def _apart(self, name: str) -> list[Any]:
        """The differences of a value over the strokes from those of the coarser cards."""
        value = methodcaller(name, np.linspace(0, 1, SAMPLES))
        return [
            (value(own) - value(other)) * (1.0 if mine.unit is None else mine.unit)
            for half in self.coarser
            for part, mine, coarse in zip(self.engine.parts, self.cylinders, half.cylinders, strict=True)
            if part.carded
            for own, other in zip(mine.strokes, coarse.strokes, strict=True)
        ]

    @property
    def step(self) -> float:
        """The last place of the pressures as written, in Q."""
        return max(one.card.resolution / one.pressure for one in self.diagrams)

    def place_error(self, greatest: bool, stroke: int | None) -> float:
        """How far the place of an extreme may be off, in half turns.

        Where the tangential force passes its mean at a small angle, little of it moves the place far.
        """
        place = float(self.peaks(greatest, stroke)[0].place)
        slope = (self.excess(place + BESIDE) - self.excess(place - BESIDE)) / (2 * BESIDE)
        halves = (half.peaks(greatest, stroke)[0].place for half in self.coarser)
        apart = max(abs(place - half) for half in halves)
        return float(max(apart, 2 * self.force_apart / (abs(slope) + NOTHING)))

    def excess(self, half_turns: float) -> float:
        """The power of all cranks less its mean."""
        return float(self.power(Fraction(half_turns)) - self.mean_force())

    def crank_force_error(self, force: CrankForce, half_turns: Fraction) -> float:
        """How far such a force may be off, in Q: as far as the net pressure there, by the rod's slant."""
        _, stroke, angle = self.first(half_turns)
        circle = self.cylinder.circle(angle)
        share = self.cylinder.share(stroke, circle)
        own = self.cylinder.strokes[stroke].force(share)
        apart = max(abs(float(own - half.cylinder.strokes[stroke].force(share))) for half in self.coarser)
        return max(apart, self.force_apart) * abs(float(self.cylinder.drive.bare(force, stroke % 2, circle)))
