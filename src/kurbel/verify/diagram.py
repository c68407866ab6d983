"""Torques over the crank angle: waves a cos(kφ + α) and straight lines, with their antiderivatives."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from kurbel.verify.extremes import Sloping, greatest
from kurbel.verify.numbers import Number, number, pi, sine_cosine, spread
from kurbel.verify.zeros import Place

# Amplitude, order and phase in degrees; from one angle to another the first value and the slope per degree.
Wave = tuple[Fraction, Fraction, Fraction]
Straight = tuple[Fraction, Fraction, Fraction, Fraction]


@dataclass(frozen=True)
class Diagram:
    """Over a cycle in degrees, behind which all comes again."""

    waves: tuple[Wave, ...]
    lines: tuple[Straight, ...]
    cycle: Fraction

    def value(self, degrees: Fraction) -> Number:
        """The torque, where it leaps that behind."""
        at = degrees % self.cycle
        start, _, first, slope = [one for one in self.lines if one[0] <= at][-1]
        return self._waves(Place(at)) + first + slope * (at - start)

    def bounds(self, cell: Place) -> Number:
        """All torques over a cell of the cycle."""
        low, high = cell.degrees - cell.reach, cell.degrees + cell.reach
        ends = [
            first + slope * (min(max(at, start), end) - start)
            for start, end, first, slope in self.lines
            if start <= high and end >= low
            for at in (low, high)
        ]
        return self._waves(cell) + spread(min(ends), max(ends))

    def _waves(self, place: Place) -> Number:
        return sum(
            (sine_cosine(k * place.degrees + phase, k * place.reach)[1] * a for a, k, phase in self.waves),
            number(0),
        )

    def integral(self, degrees: Fraction) -> Number:
        """From 0, by the angle in degrees; of waves by that in radians."""
        turns, at = divmod(degrees, self.cycle)
        return self._below(at) + (self._below(self.cycle) * turns if turns else 0)

    def _below(self, at: Fraction) -> Number:
        total = number(0)
        for a, k, phase in self.waves:
            begin, end = (sine_cosine(k * one + phase) for one in (Fraction(0), at))
            total += (end[0] - begin[0]) * (a / k) * 180 / pi() if k else begin[1] * a * at
        for start, stop, first, slope in self.lines:
            along = min(max(at - start, Fraction(0)), stop - start)
            total = total + along * (first + slope * along / 2)
        return total

    @property
    def mean(self) -> Number:
        return self._below(self.cycle) / self.cycle


def swing(drive: Diagram, load: Diagram) -> Number:
    """The work from the least energy to the greatest, by the angle in degrees."""

    def energy(sign: int) -> Sloping:
        def of(place: Place, more: int) -> Number:
            if more:
                return (drive.bounds(place) - load.bounds(place)) * (180 * sign) / pi()
            return (drive.integral(place.degrees) - load.integral(place.degrees)) * sign

        return of

    return sum((greatest(energy(sign), Fraction(0), drive.cycle) for sign in (1, -1)), number(0))
