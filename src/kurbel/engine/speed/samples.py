"""Functions over a cycle of the engine in floats: of turns by a card, and nearly those of turns in balls."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import pi
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kurbel.engine.cylinder import Cylinder

if TYPE_CHECKING:
    from kurbel.engine.card.force import CardTurn

Floats: TypeAlias = NDArray[np.float64]
# In a turn; a multiple of all that cranks are usually apart. So many times as many tell an integral.
SAMPLES, FINER = 720, 8
# About an extreme so many steps to both sides, each time as much finer.
NEAR, NARROWINGS = 16, 5


class Samples:
    """A function at equal steps of a cycle from the first crank's dead centre on, in half turns, and at any
    place where it has `values`."""

    def __init__(
        self, samples: ArrayLike, start: float, cycle: int, values: Callable[[Floats], Floats] | None = None
    ) -> None:
        self.samples, self.start, self.cycle = np.asarray(samples, float), start, cycle
        self._values = values

    @classmethod
    def of(cls, values: Callable[[Floats], Floats], start: float, cycle: int) -> Samples:
        return cls(values(_places(start, cycle)), start, cycle, values)

    @property
    def first(self) -> float:
        return float(self.samples[0])

    def at(self, half_turns: Fraction | float) -> float:
        return float(self.over(np.array([float(half_turns)]))[0])

    def over(self, places: Floats) -> Floats:
        """Return the function at each of the places."""
        assert self._values is not None
        return self._values(places)

    def in_floats(self) -> Samples:
        """Return the samples alone."""
        return Samples(self.samples, self.start, self.cycle)

    def __add__(self, other: Samples | float) -> Samples:
        return self._with(other, np.add)

    def __truediv__(self, other: Samples | float) -> Samples:
        return self._with(other, np.divide)

    def power(self, exponent: Fraction) -> Samples:
        return self._with(float(exponent), np.power)

    def _with(self, other: Samples | float, combined: Callable[[Floats, Any], Floats]) -> Samples:
        def over(places: Floats) -> Floats:
            return combined(self.over(places), other.over(places) if isinstance(other, Samples) else other)

        samples = combined(self.samples, other.samples if isinstance(other, Samples) else other)
        return Samples(samples, self.start, self.cycle, self._values and over)

    def sum(self) -> Samples:
        """Return the integral from the dead centre on, by the spline through finer samples."""
        from scipy.interpolate import CubicSpline

        nodes = _places(self.start, self.cycle, FINER, ends=True)
        own = CubicSpline(nodes, self.over(nodes)).antiderivative()

        def total(places: Floats) -> Floats:
            cycles, rest = np.divmod(places - self.start, self.cycle)
            found: Floats = cycles * own(nodes[-1]) + own(self.start + rest)
            return found

        return Samples.of(total, self.start, self.cycle)

    def lagging(self, rate: float) -> Samples:
        """Return y of the cycle after which it comes again, where y' = -rate (f + y) of the function f: of
        each of its waves, and with values the spline through these."""
        waves = np.fft.rfft(self.samples)
        rates = 2j * pi / self.cycle * np.arange(len(waves))
        found = np.fft.irfft(-rate * waves / (rate + rates), len(self.samples))
        if self._values is None:
            return Samples(found, self.start, self.cycle)
        from scipy.interpolate import CubicSpline

        nodes = _places(self.start, self.cycle, ends=True)
        spline = CubicSpline(nodes, np.append(found, found[0]), bc_type="periodic")
        return Samples(found, self.start, self.cycle, spline)

    def turnings(self) -> tuple[float, float]:
        """Return where the function is greatest, and where least."""
        found = []
        for sign in (1, -1):
            step = 2 / SAMPLES
            place = self.start + step * int((sign * self.samples).argmax())
            for _ in range(NARROWINGS):
                near = place + step * np.arange(-NEAR, NEAR + 1) / NEAR
                place, step = near[(sign * self.over(near)).argmax()], step / NEAR
            found.append(float(self.start + (place - self.start) % self.cycle))
        return found[0], found[1]

    def extreme(self, greatest: bool, turnings: Sequence[float] = ()) -> tuple[float, float]:
        """Return where the function is greatest or least, and what it is there.

        Where that is not known it is a sample, and the value that of the parabola through those about it.
        """
        if turnings:
            place = turnings[0 if greatest else 1]
            return place, self.at(place)
        sign = 1 if greatest else -1
        samples = sign * self.samples
        # Of cranks alike the first.
        highest = int(samples.round(12).argmax())
        before, most, after = np.take(samples, (highest - 1, highest, highest + 1), mode="wrap")
        bend = before - 2 * most + after
        most -= (after - before) ** 2 / (8 * bend) if bend else 0
        return self.start + 2 * highest / SAMPLES, float(sign * most)


def _places(start: float, cycle: int, times: int = 1, *, ends: bool = False) -> Floats:
    """Return the half turns at which samples are, of `times` SAMPLES a turn, with the end or without."""
    return start + 2 * np.arange(cycle // 2 * times * SAMPLES + ends) / (times * SAMPLES)


def energies_of_card(turn: CardTurn) -> tuple[Samples, Samples]:
    """Return the work of the pressure above its mean since the dead centre, and the energy of the masses at
    the mean speed, as far as it changes, in Q R."""
    begun = sum(turn.cylinders[part].still.energy(*one) for part, *one in turn.begun())
    start = float(turn.cylinder.drive.dead_centre(0))

    def work(one: Cylinder, stroke: int, angle: Floats) -> Floats:
        return np.asarray(one.still.energy(stroke, angle))

    return (
        Samples.of(lambda where: turn.total(work, where, -float(begun)), start, turn.cycle),
        Samples.of(lambda where: turn.total(Cylinder.kinetic_energy, where, 0.0), start, turn.cycle),
    )
