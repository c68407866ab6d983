"""The turning of an engine whose piston works at a rocker's end, by brute force on a fine grid.

The links are closed by the two circles of their lengths; work is force times way, added up; velocities of
the masses are differences of their places. Nothing of kurbel's formulas is used.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from links import Floats, Links, links
from numpy.typing import NDArray

from kurbel.linkage.arc.rocker import RockerCrank


class Steam(NamedTuple):
    """Ideal steam by Mariotte's law, in units of Q; the work up to a share of the stroke."""

    expansion: float
    back: float

    def force(self, share: Floats) -> Floats:
        return np.minimum(1, 1 / self.expansion / np.maximum(share, 1e-9)) - self.back

    def work(self, share: Floats) -> Floats:
        """∫ of the force by hand, as § 150 has it."""
        cut_off = 1 / self.expansion
        beyond = np.maximum(share, cut_off)
        return np.minimum(share, cut_off) + cut_off * np.log(beyond / cut_off) - self.back * share


class Weights(NamedTuple):
    """Masses in units of Q/(R ω²): at the rocker's end, J/B², and a rod by its points: share, aside, mass."""

    end: float = 0.0
    rocker: float = 0.0
    rod: tuple[tuple[float, float, float], ...] = ()


MASSLESS = Weights()


class Curve:
    """One turn from φ = 0 in equal steps: share of the stroke, tangential force, energy since the inner dead
    centre. Of masses places are differentiated twice, for which steps must not be too short."""

    def __init__(
        self, crank: RockerCrank, steam: Steam, weights: Weights = MASSLESS, cells: int = 720_000
    ) -> None:
        machine: Links = links(crank)
        self.angles = np.linspace(0, 2 * np.pi, cells + 1)
        self.ends = machine.guess(self.angles)
        way = float(machine.rocker) * np.unwrap(np.angle(self.ends - complex(machine.pivot)))
        inner, outer = (float(dead[0]) % (2 * np.pi) for dead in (machine.inner, machine.outer))
        begin, end = np.interp([inner, outer], self.angles, way)
        self.length = abs(end - begin)
        since = (self.angles - inner) % (2 * np.pi)
        is_out = since < (outer - inner) % (2 * np.pi)
        self.share = share = np.abs(way - np.where(is_out, begin, end)) / self.length
        stroke = self.length * float(steam.work(np.array(1.0)))
        self.mean = 2 * stroke / (2 * np.pi)
        kinetic = self._kinetic(weights)
        work = np.where(is_out, 0, stroke) + self.length * steam.work(share)
        before = np.interp(inner, self.angles, kinetic)
        self.energy: NDArray[np.float64] = work - (kinetic - before) - self.mean * since
        self.force = steam.force(share) * np.abs(self.slope(way)) - self.slope(kinetic)

    @property
    def irregularity(self) -> float:
        return float(np.ptp(self.energy) / self.mean)

    def slope(self, values: Any) -> Any:
        """The slope of what comes again after a turn, by differences of the fourth order."""
        step, turn = self.angles[1], values[-1] - values[0]
        wide = np.concatenate([values[-3:-1] - turn, values, values[1:3] + turn])
        return (8 * (wide[3:-1] - wide[1:-3]) - (wide[4:] - wide[:-4])) / (12 * step)

    def at(self, values: Any, degrees: float) -> float:
        return float(np.interp(np.radians(degrees), self.angles, values))

    def _kinetic(self, weights: Weights) -> Any:
        pins = np.exp(1j * self.angles)

        def square(place: Any) -> Any:
            return np.abs(self.slope(place.real) + 1j * self.slope(place.imag)) ** 2

        total = (weights.end + weights.rocker) * square(self.ends) / 2
        for share, aside, mass in weights.rod:
            total = total + mass * square(pins + (share + 1j * aside) * (self.ends - pins)) / 2
        return total
