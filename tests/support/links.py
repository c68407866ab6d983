"""The arc crank and the beam engine as links that mpmath closes."""

from __future__ import annotations

import cmath
import math
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
from mpmath import mp
from numpy.typing import NDArray

from kurbel.drive.crank import Crank
from kurbel.exact.kind import Kind
from kurbel.kernel.circle import arcsine, circle
from kurbel.linkage.arc.crank import ArcCrank
from kurbel.linkage.arc.quantities import arc_registry
from kurbel.linkage.arc.rocker import RockerCrank
from kurbel.linkage.beam.crank import BeamCrank
from kurbel.motion.evaluation import OUT
from kurbel.page.quantity import Quantity

# mpmath has no types.
Real = Any
Floats = NDArray[np.float64]
DIGITS = 50


def arc_crank(
    rod: str, rocker: str, pivot: tuple[str, str] | None = None, circuit: int = 1, offset: str = "0"
) -> ArcCrank:
    distance, height = (None, None) if pivot is None else map(Fraction, pivot)
    return ArcCrank(Crank(1 / Fraction(rod), Fraction(offset)), Fraction(rocker), distance, height, circuit)


# A rocker in place of a slide, with an offset, on either side; shaft and pivot in a line with φ = 0, in both
# circuits; a rocker shorter than the rod and a rod shorter than the rocker, each swinging far; a pivot
# below, assembled both ways; links nearly in line.
CRANKS = [
    arc_crank("5", "6"),
    arc_crank("4.5", "7", offset="0.7"),
    arc_crank("3.5", "9", ("3.7", "-9.2")),
    arc_crank("3", "2.5", ("4", "0")),
    arc_crank("3", "2.5", ("4", "0"), -1),
    arc_crank("6.1", "1.3", ("6.2", "0.3")),
    arc_crank("1.4", "5.2", ("2.1", "4.9"), -1),
    arc_crank("2.3", "3.1", ("0.6", "-2.7")),
    arc_crank("2.3", "3.1", ("0.6", "-2.7"), -1),
    arc_crank("4", "3", ("0.1", "5.99")),
]


def shown(crank: ArcCrank) -> str:
    rod = 1 / float(crank.crank.ratio)
    distance = rod if crank.distance is None else float(crank.distance)
    lengths = rod, float(crank.rocker), distance, float(crank.pivot_height), crank.circuit
    return ",".join(f"{length:g}" for length in lengths)


class Links:
    """Shaft at 0, pivot, rod and rocker as lengths; every position is closed by Newton's method."""

    def __init__(self, crank: ArcCrank) -> None:
        self.rod = 1 / real(crank.crank.ratio)
        self.rocker = real(crank.rocker)
        distance = self.rod if crank.distance is None else real(crank.distance)
        self.pivot = mp.mpc(distance, real(crank.pivot_height))
        # Seen from the crank pin, the rod's end lies to the right of the pivot, or to the left.
        self.right = crank.circuit if self.pivot.imag >= 0 else -crank.circuit
        self.inner, self.outer = self._dead(1), self._dead(-1)

    def guess(self, cranks: Floats) -> NDArray[np.complex128]:
        """Where two circles meet, in floats."""
        rod, rocker, pivot = float(self.rod), float(self.rocker), complex(self.pivot)
        pins = np.exp(1j * cranks)
        apart = pivot - pins
        along = (rod**2 - rocker**2 + np.abs(apart) ** 2) / (2 * np.abs(apart))
        across = np.sqrt(rod**2 - along**2)
        return np.asarray(pins + apart / np.abs(apart) * (along - 1j * self.right * across))

    def angles(self, phi: Real) -> tuple[Real, Real]:
        """Rod and rocker, from the slide direction, so that crank and rod end where the rocker ends."""
        end = self.guess(np.array([float(phi)]))[0]
        start = cmath.phase(end - cmath.exp(1j * float(phi))), cmath.phase(end - complex(self.pivot))
        rod, rocker = mp.findroot(lambda *angles: self._open(phi, *angles), start)
        return rod, rocker

    def _open(self, phi: Real, rod: Real, rocker: Real) -> list[Real]:
        gap = pointer(phi) + self.rod * pointer(rod) - self.pivot - self.rocker * pointer(rocker)
        return [gap.real, gap.imag]

    def _dead(self, side: int) -> tuple[Real, Real]:
        """Crank angle and rocker where crank and rod are in line, stretched or folded."""
        cranks = np.linspace(0, 2 * np.pi, 3601)
        ends = self.guess(cranks)
        row = (side * np.abs(ends)).argmax()

        def misses(phi: Real, rocker: Real) -> list[Real]:
            end = self.pivot + self.rocker * pointer(rocker)
            gap = end - (self.rod + side) * side * pointer(phi)
            return [gap.real, gap.imag]

        start = cranks[row], cmath.phase(ends[row] - complex(self.pivot))
        phi, rocker = mp.findroot(misses, start)
        return phi, rocker

    def end(self, rocker: Real) -> Real:
        return self.pivot + self.rocker * pointer(rocker)

    def value(self, key: str, stroke: int, degrees: Fraction) -> Real:
        phi = mp.radians(real(degrees)) + (0 if stroke == OUT else mp.pi)
        dead = (self.inner if stroke == OUT else self.outer)[1]
        rod, rocker = self.angles(phi)
        # The rocker's turn on the outstroke, made positive by the circuit.
        turned = -stroke * self.right * wrapped(rocker - dead)
        moved = (self.end(dead) - self.end(rocker)) * stroke
        inward = stroke * self.right
        slope = {
            "turn": lambda angle: -inward * self.angles(angle)[1],
            "rod": lambda angle: -self.angles(angle)[0],
        }
        square = mp.pi / 2 if self.right < 0 else -mp.pi / 2
        tangent = -1j * self.right * pointer(rocker)
        return {
            "path": lambda: self.rocker * turned,
            "chord": lambda: abs(moved),
            "slide_path": lambda: moved.real,
            "rise": lambda: -moved.imag,
            "velocity": lambda: self.rocker * mp.diff(slope["turn"], phi),
            "acceleration": lambda: self.rocker * mp.diff(slope["turn"], phi, 2),
            "turn": lambda: mp.degrees(turned),
            "turn_velocity": lambda: mp.diff(slope["turn"], phi),
            "turn_acceleration": lambda: mp.diff(slope["turn"], phi, 2),
            "rocker": lambda: mp.degrees(wrapped(rocker - square)),
            "rod": lambda: mp.degrees(wrapped(-rod)),
            "rod_velocity": lambda: mp.diff(slope["rod"], phi),
            "rod_acceleration": lambda: mp.diff(slope["rod"], phi, 2),
            "slant": lambda: -mp.degrees(mp.arg(-pointer(rod) / tangent)),
        }[key]()


class BeamLinks(Links):
    """The links of a beam engine: its pivot stands where the beam's end swings from q above to q below, the
    vertical through the shaft halving the sagitta of this arc."""

    def __init__(self, drive: BeamCrank) -> None:
        self.rod, self.rocker = 1 / real(drive.crank.ratio), real(drive.arm)
        self.right = 1

        def misses(chord: Real, height: Real) -> list[Real]:
            aside = self._half_sagitta(chord) ** 2
            return [
                (height + chord) ** 2 + aside - (self.rod + 1) ** 2,
                (height - chord) ** 2 + aside - (self.rod - 1) ** 2,
            ]

        chord, height = mp.findroot(misses, (mp.mpf(1), self.rod))
        self.pivot = mp.mpc(height, self.rocker - self._half_sagitta(chord))
        self.inner, self.outer = self._dead(1), self._dead(-1)

    def _half_sagitta(self, chord: Real) -> Real:
        return (self.rocker - mp.sqrt(self.rocker**2 - chord**2)) / 2


def pointer(angle: Real) -> Real:
    return mp.mpc(mp.cos(angle), mp.sin(angle))


def real(number: Fraction) -> Real:
    return mp.mpf(number.numerator) / number.denominator


def wrapped(angle: Real) -> Real:
    return angle - 2 * mp.pi * mp.nint(angle / (2 * mp.pi))


@cache
def links(drive: RockerCrank) -> Links:
    with mp.workdps(DIGITS):
        if isinstance(drive, BeamCrank):
            return BeamLinks(drive)
        assert isinstance(drive, ArcCrank)
        return Links(drive)


def of_stroke(key: str, stroke: int) -> Quantity:
    """Return the entry of a quantity on a stroke."""
    return arc_registry()[key if stroke == OUT else f"{key}_return"]


FLOATS = Kind(float, lambda degrees: circle(float(degrees)), arcsine, math.pi)
