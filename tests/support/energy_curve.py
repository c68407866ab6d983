"""The turning of a steam engine by brute force: force, energy and speed, without kurbel's formulas.

The kinematics are the textbook's, x = 1 - cos φ + (1 - cos ψ)/λ and its slope over the whole turn; the return
stroke is the same path seen from its other end. Energy is the force on the piston times this slope,
integrated over the angle, never a formula for the work. Lengths are in R, forces in the piston force Q before
cut-off. `Curve` walks a fine grid in NumPy, `Exact` works in mpmath at the precision in force.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from itertools import accumulate, pairwise
from typing import Any, NamedTuple

import numpy as np
from mpmath import mp
from numpy.typing import NDArray

# mpmath has no types.
Real = Any


class Plant(NamedTuple):
    """A steam engine; `back` None is the pressure of the steam at the end of the stroke."""

    expansion: Fraction
    ratio: Fraction
    back: Fraction | None = None
    exponent: Fraction = Fraction(1)
    clearance: Fraction = Fraction(0)
    double: bool = True
    cranks: tuple[Fraction, ...] = (Fraction(0),)
    method: str = "exact"


class Grid(NamedTuple):
    """The places, as angles in degrees, at which the speed is least or greatest, and their energies."""

    least: float
    greatest: float
    place_of_least: float
    place_of_greatest: float


class Curve:
    """One turn from the first crank's inner dead centre in equal steps; energies are Simpson's sums."""

    def __init__(self, plant: Plant, cells: int = 36_000) -> None:
        self.plant = plant
        self.step = 360 / cells
        halves = np.linspace(0, 360, 2 * cells + 1)
        force = np.zeros_like(halves)
        for crank in plant.cranks:
            force += _grid_force(plant, np.mod(halves - float(crank), 360))
        width = np.radians(self.step)
        work = np.concatenate([[0], np.cumsum(force[:-2:2] + 4 * force[1::2] + force[2::2]) * width / 6])
        self.angles = halves[::2]
        self.mean_force = float(work[-1] / (2 * np.pi))
        self.excess: NDArray[np.float64] = force[::2] - self.mean_force
        self.energy: NDArray[np.float64] = work - self.mean_force * np.radians(self.angles)

    @property
    def irregularity(self) -> float:
        """δ in units of P R/(m₁ v₁²)."""
        return float(np.ptp(self.energy)) / self.mean_force

    def stationary(self) -> list[tuple[float, bool]]:
        """Return the degrees at which the excess changes its sign, and whether it rises there."""
        changes = np.flatnonzero(np.sign(self.excess[:-1]) != np.sign(self.excess[1:]))
        left, right = self.excess[changes], self.excess[changes + 1]
        degrees = self.angles[changes] + self.step * left / (left - right)
        return list(zip(degrees.tolist(), (right > left).tolist(), strict=True))


def _grid_force(plant: Plant, degrees: NDArray[np.float64]) -> NDArray[np.float64]:
    angle = np.radians(degrees)
    path, velocity = _path(plant, angle), _velocity(plant, angle)
    shares = np.where(degrees < 180, path, 2 - path) / 2
    cut_off, clearance = 1 / float(plant.expansion), float(plant.clearance)
    volume = np.maximum(shares, cut_off) + clearance
    exponent = float(plant.exponent)
    back = ((cut_off + clearance) / (1 + clearance)) ** exponent if plant.back is None else float(plant.back)
    force = (((cut_off + clearance) / volume) ** exponent - back) * np.abs(velocity)
    return force if plant.double else np.where(degrees < 180, force, 0)


def _path(plant: Plant, angle: NDArray[np.float64]) -> NDArray[np.float64]:
    ratio = float(plant.ratio)
    far: NDArray[np.float64] = 1 - np.cos(angle)
    if plant.method == "series" or not ratio:
        return far + ratio * np.sin(angle) ** 2 / 2
    rod: NDArray[np.float64] = np.sqrt(1 - (ratio * np.sin(angle)) ** 2)
    return far + (1 - rod) / ratio


def _velocity(plant: Plant, angle: NDArray[np.float64]) -> NDArray[np.float64]:
    half = float(plant.ratio) * np.sin(2 * angle) / 2
    if plant.method != "series":
        half = half / np.sqrt(1 - (float(plant.ratio) * np.sin(angle)) ** 2)
    velocity: NDArray[np.float64] = np.sin(angle) + half
    return velocity


def real(number: Fraction | int) -> Real:
    exact = Fraction(number)
    return mp.mpf(exact.numerator) / exact.denominator


class Exact:
    """The same in mpmath, at the precision in force when it is made; angles are radians."""

    def __init__(self, plant: Plant) -> None:
        self.plant = plant
        self.cut_off = 1 / real(plant.expansion)
        self.clearance = real(plant.clearance)
        self.exponent = real(plant.exponent)
        self.back = self._steam(mp.mpf(1)) if plant.back is None else real(plant.back)
        self.starts = [real(crank) * mp.pi / 180 for crank in plant.cranks]
        self.ratio = real(plant.ratio)

    def pressure(self, share: Real) -> Real:
        """The net pressure at a share of the stroke."""
        return self._steam(share) - self.back

    def _steam(self, share: Real) -> Real:
        if share <= self.cut_off:
            return mp.mpf(1)
        return ((self.cut_off + self.clearance) / (share + self.clearance)) ** self.exponent

    def force(self, angle: Real) -> Real:
        """The tangential force of all cranks: of the force on the piston, at the angle ψ of the rod."""
        return mp.fsum(
            self._pressure_of_one(one) * mp.sin(one + rod) / mp.cos(rod)
            for one in (angle - start for start in self.starts)
            for rod in [mp.asin(self.ratio * mp.sin(one))]
        )

    def power(self, angle: Real) -> Real:
        """The work of all cranks over the angle: of the force on the piston, over its path."""
        return mp.fsum(self._power_of_one(angle - start) for start in self.starts)

    def _power_of_one(self, angle: Real) -> Real:
        return self._pressure_of_one(angle) * self._motion(angle)[1]

    def _pressure_of_one(self, angle: Real) -> Real:
        """The force on the piston in the direction of the outstroke."""
        angle = angle - 2 * mp.pi * mp.floor(angle / (2 * mp.pi))
        if angle <= mp.pi:
            return self.pressure(self._motion(angle)[0] / 2)
        return -self.pressure(1 - self._motion(angle)[0] / 2) if self.plant.double else mp.mpf(0)

    def _motion(self, angle: Real) -> tuple[Real, Real]:
        """Path and velocity, from one sine and one cosine."""
        cosine, sine = mp.cos_sin(angle)
        rise = self.ratio * sine
        if self.plant.method == "series" or not rise:
            return 1 - cosine + rise * sine / 2, sine + rise * cosine
        rod = mp.sqrt(1 - rise * rise)
        return 1 - cosine + (1 - rod) / self.ratio, sine + rise * cosine / rod

    @cached_property
    def mean_force(self) -> Real:
        """The power integrated over the turn, divided by the turn."""
        return self.integral(mp.mpf(0), 2 * mp.pi) / (2 * mp.pi)

    def integral(self, start: Real, end: Real) -> Real:
        """∫ of the power, crank by crank."""
        return mp.fsum(
            self._work_of_one(end - crank) - self._work_of_one(start - crank) for crank in self.starts
        )

    def _work_of_one(self, angle: Real) -> Real:
        """∫ of one crank's power since its dead centre, to a corner and on from there."""
        turns = mp.floor(angle / (2 * mp.pi))
        angle -= 2 * mp.pi * turns
        below = max(place for place, (corner, _) in enumerate(self._corners) if corner <= angle)
        corner, work = self._corners[below]
        return turns * self._corners[-1][1] + work + mp.quad(self._power_of_one, (corner, angle))

    @cached_property
    def _corners(self) -> list[tuple[Real, Real]]:
        """One crank's dead centres and cut-offs, from 0 to a turn, and the work up to each."""
        places = [mp.mpf(0), mp.pi, 2 * mp.pi]
        if self.plant.expansion > 1:
            places += [self.cut_off_angle(False), mp.pi + self.cut_off_angle(True)]
        places.sort()
        spans = [mp.quad(self._power_of_one, span) for span in pairwise(places)]
        return list(zip(places, accumulate(spans, initial=mp.mpf(0)), strict=True))

    def cut_off_angle(self, returning: bool) -> Real:
        """The angle at cut-off from the dead centre of the stroke, found by halving."""

        def short(angle: Real) -> Real:
            path, _ = self._motion(angle + mp.pi if returning else angle)
            return (2 - path if returning else path) - 2 * self.cut_off

        return mp.findroot(short, (mp.mpf(0), mp.pi), solver="anderson", tol=mp.eps, verify=False)

    def stationary(self, near: float) -> Real:
        """The angle near some degrees at which the power is its mean."""
        start = mp.mpf(near) * mp.pi / 180
        around = (start - mp.mpf("1e-6"), start + mp.mpf("1e-6"))
        return mp.findroot(lambda angle: self.power(angle) - self.mean_force, around, verify=False)

    def energy(self, angle: Real) -> Real:
        """The work of the excess since the first crank's inner dead centre."""
        return self.integral(mp.mpf(0), angle) - self.mean_force * angle
