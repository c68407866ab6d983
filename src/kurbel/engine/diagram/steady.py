"""The speed of a flywheel over a cycle in steady state, from the energy that swings.

Given is the mean speed, ω = ½ (ω_max + ω_min), so that ω_max - ω_min = ΔW/(J ω) and the speed where the
excess energy is W is the root of ω_max² - 2 (W_max - W)/J, exactly. Re-derived.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Protocol

from kurbel.engine.diagram.fluctuation import Fluctuation
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, balls
from kurbel.reading.notation import about
from kurbel.reading.units import Speed


class Swinging(Fluctuation, Protocol):
    """A fluctuation whose excess energies count from a point of their own."""

    def extreme_energy(self, kind: Kind, *, greatest: bool) -> Any:
        """Return the greatest or the least excess energy in J."""


@dataclass(frozen=True)
class Steady:
    """A flywheel by its moment of inertia in kg m² and its mean speed, under an energy that swings."""

    swinging: Swinging
    inertia: Fraction
    speed: Speed

    def __post_init__(self) -> None:
        if float(self.irregularity(balls()).mid()) >= 2:
            raise ProblemError(
                f"a flywheel of J = {about(self.inertia)} kg m² comes to rest: the energy swings by more than"
                " twice J ω²; give a heavier one, or more speed"
            )

    def mean(self, kind: Kind) -> Any:
        """Return ω in 1/s."""
        value = kind.of(self.speed.value)
        return value * 2 * kind.pi if self.speed.turns else value

    def irregularity(self, kind: Kind) -> Any:
        """Return δ = (ω_max - ω_min)/ω = ΔW/(J ω²)."""
        mean = self.mean(kind)
        return self.swinging.swing(kind) / (kind.of(self.inertia) * mean * mean)

    def greatest(self, kind: Kind) -> Any:
        """Return ω_max in 1/s."""
        return self._beyond(kind, 1)

    def least(self, kind: Kind) -> Any:
        """Return ω_min in 1/s."""
        return self._beyond(kind, -1)

    def _beyond(self, kind: Kind, sign: int) -> Any:
        mean = self.mean(kind)
        half = self.swinging.swing(kind) / (kind.of(2 * self.inertia) * mean)
        return mean + half if sign > 0 else mean - half

    def at(self, energy: Any, kind: Kind) -> Any:
        """Return ω in 1/s where the excess energy is this, in J."""
        greatest = self.greatest(kind)
        lacking = self.swinging.extreme_energy(kind, greatest=True) - energy
        return (greatest * greatest - 2 * lacking / kind.of(self.inertia)) ** 0.5
