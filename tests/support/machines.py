"""Machines of every drive under every load, turned in steps: force and energy without kurbel's formulas.

The driven end of a mechanism is found from the lengths of its links, its velocity from their constraints, the
dead centres where that is zero. Loads are the pressures of the textbooks' diagrams at a share of the stroke;
the tangential force follows by virtual work, the energy as its sum over the steps, that of the masses from
the velocities of two points of the rod. Lengths are in R.

python tests/support/machines.py [--machines N] [--samples N] [--seed N]

compares so many random machines, each in so many steps, with what kurbel prints.
"""

from __future__ import annotations

import argparse
import math
import random
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

Grid = NDArray[np.float64]
# From the share of the stroke gone to the net force in its direction, on the outstroke and the return, or on
# the four strokes of a cycle of two turns; in units of Q.
Forces = tuple[Callable[[Grid], Grid], ...]
Pair = tuple[float, float]
# Steps that are summed at once.
BLOCK = 250_000


class Motion(NamedTuple):
    """The driven end at crank angles in radians: its place, and its velocity over R ω as a vector."""

    place: Grid
    speed: Grid
    across: Grid
    along: Grid


class Slide:
    """A piston on a straight slide that passes the shaft at `offset`."""

    def __init__(self, length: float, offset: float = 0.0) -> None:
        self.length, self.offset = length, offset

    def motion(self, angle: Grid) -> Motion:
        """Return the way from the far end of the slide, counted towards the shaft."""
        rise = np.sin(angle) - self.offset
        reach = np.sqrt(self.length**2 - rise**2)
        speed = np.sin(angle) + rise * np.cos(angle) / reach
        return Motion(-(np.cos(angle) + reach), speed, np.zeros_like(angle), -speed)


class Rocker:
    """A piston at the end of a rocker of length B whose pivot lies at (x, y) from the shaft."""

    def __init__(self, length: float, rocker: float, pivot: tuple[float, float]) -> None:
        self.length, self.rocker, self.pivot = length, rocker, pivot

    def motion(self, angle: Grid) -> Motion:
        """Return the way along the arc, counted so that it grows as the end comes nearer to the shaft."""
        pin = np.cos(angle), np.sin(angle)
        reach = self.pivot[0] - pin[0], self.pivot[1] - pin[1]
        span = np.hypot(*reach)
        # The angle at the pivot in the triangle of rocker, rod and the line to the crank pin.
        opening = np.arccos((self.rocker**2 + span**2 - self.length**2) / (2 * self.rocker * span))
        towards = np.arctan2(-reach[1], -reach[0]) + opening
        radius = self.rocker * np.cos(towards), self.rocker * np.sin(towards)
        end = self.pivot[0] + radius[0], self.pivot[1] + radius[1]
        rod = end[0] - pin[0], end[1] - pin[1]
        # The end moves square to the rocker, and as fast along the rod as the pin does.
        square = radius[1] / self.rocker, -radius[0] / self.rocker
        pull = rod[0] * -np.sin(angle) + rod[1] * np.cos(angle)
        speed = pull / (rod[0] * square[0] + rod[1] * square[1])
        return Motion(-self.rocker * towards, speed, speed * square[1], speed * square[0])


class Rod(NamedTuple):
    """Moving masses in units of Q/(R ω²): reciprocating, the rod, its a/L from the crank pin and its k/L."""

    reciprocating: float = 0.0
    rod: float = 0.0
    centre: float = 0.5
    gyration: float = 0.3

    def energy(self, angle: Grid, motion: Motion, length: float) -> Grid:
        pin = -np.sin(angle), np.cos(angle)
        end = motion.along, motion.across
        middle = [(1 - self.centre) * one + self.centre * other for one, other in zip(pin, end, strict=True)]
        turning = sum((one - other) ** 2 for one, other in zip(pin, end, strict=True)) / length**2
        own = middle[0] ** 2 + middle[1] ** 2 + (self.gyration * length) ** 2 * turning
        whole: Grid = (self.reciprocating * motion.speed**2 + self.rod * own) / 2
        return whole


@dataclass(frozen=True)
class Machine:
    """Pistons alike, each on a drive of this kind; `options` are kurbel's for the same."""

    drive: Slide | Rocker
    forces: Forces
    options: Mapping[str, Any]
    cranks: tuple[float, ...] = (0.0,)
    masses: Rod = field(default_factory=Rod)

    @cached_property
    def dead_centres(self) -> tuple[float, float]:
        """Return the crank angles in radians at which the outstroke and the return begin."""

        def speed(angle: float) -> float:
            return float(self.drive.motion(np.array([angle])).speed[0])

        coarse = np.linspace(0, math.tau, 721) - 3
        grows = self.drive.motion(coarse).speed > 0
        roots = {
            bool(grows[index + 1]): brentq(speed, coarse[index], coarse[index + 1], xtol=1e-15)
            for index in np.flatnonzero(grows[1:] != grows[:-1])
        }
        outer = float(roots[False])
        return float(roots[True]), outer if outer > roots[True] else outer + math.tau

    def torque(self, shaft: Grid) -> Grid:
        """Return the tangential force of the load at angles of the first crank, all cranks, in Q."""
        inner, outer = self.dead_centres
        ends = self.drive.motion(np.array([inner, outer])).place
        total = np.zeros_like(shaft)
        for crank in self.cranks:
            angle = shaft - math.radians(crank)
            motion = self.drive.motion(angle)
            turns = len(self.forces) // 2
            since = np.mod(angle - inner, math.tau * turns)
            stroke = 2 * np.floor(since / math.tau).astype(int) + (np.mod(since, math.tau) >= outer - inner)
            gone = (motion.place - ends[0]) / (ends[1] - ends[0])
            share = np.clip(np.where(stroke % 2, 1 - gone, gone), 0, 1)
            force = np.select(
                [stroke == index for index in range(2 * turns)], [one(share) for one in self.forces]
            )
            total += force * np.abs(motion.speed)
        return total

    def energy(self, shaft: Grid) -> Grid:
        """Return the kinetic energy of all masses, in Q R."""
        total = np.zeros_like(shaft)
        for crank in self.cranks:
            angle = shaft - math.radians(crank)
            total += self.masses.energy(angle, self.drive.motion(angle), self.drive.length)
        return total

    def turned(self, samples: int) -> tuple[float, float]:
        """Return the mean tangential force in Q and δ, in units of |P| r/(m₁ v₁²), from so many steps."""
        span = math.pi * len(self.forces)
        step, begun = span / samples, self.dead_centres[0]
        work, blocks = 0.0, []
        for first in range(0, samples, BLOCK):
            count = min(BLOCK, samples - first)
            edges: Grid = begun + step * np.arange(first, first + count + 1, dtype=np.float64)
            # Simpson's rule in each step.
            ends, middles = self.torque(edges), self.torque(edges[:-1] + step / 2)
            done = work + np.cumsum((ends[:-1] + 4 * middles + ends[1:]) * step / 6)
            work = float(done[-1])
            blocks.append((edges[1:], done - self.energy(edges[1:])))
        mean = work / span
        excess = [energy - mean * (angles - begun) for angles, energy in blocks]
        most, least = max(float(one.max()) for one in excess), min(float(one.min()) for one in excess)
        return mean, (most - least) / abs(mean)


def steam(expansion: float, back: float, exponent: float, clearance: float, double: bool) -> Forces:
    """Return the forces of steam: full pressure up to the cut-off, then p V^n = const."""
    cut_off = 1 / expansion

    def acting(share: Grid) -> Grid:
        full = (cut_off + clearance) / (np.maximum(share, cut_off) + clearance)
        return full**exponent - back

    return acting, acting if double else np.zeros_like


def compressor(ratio: float, exponent: float, clearance: float, losses: Pair, double: bool) -> Forces:
    """Return the forces of a compressor: expansion of what is left, suction, compression, delivery."""
    low, high = 1 - losses[0], ratio * (1 + losses[1])

    def leaving(share: Grid) -> Grid:
        if not clearance:
            return np.full_like(share, low)
        return np.maximum(low, high * (clearance / (clearance + share)) ** exponent)

    def coming(share: Grid) -> Grid:
        whole = 1 + clearance
        with np.errstate(divide="ignore"):
            return np.minimum(high, low * (whole / (whole - share)) ** exponent)

    if double:
        both: Callable[[Grid], Grid] = lambda share: leaving(share) - coming(share)  # noqa: E731
        return both, both
    return (lambda share: leaving(share) - 1), (lambda share: 1 - coming(share))


def pump(kind: str, suction: float, small: float = 0.5) -> Forces:
    """Return the forces of a pump by its two faces, in the delivery pressure less the suction pressure."""
    delivery, full = suction + 1, np.ones_like
    if kind == "double":
        return (lambda share: (suction - delivery) * full(share),) * 2
    other = small * delivery if kind == "differential" else 0.0
    return (lambda share: (suction - other) * full(share)), (lambda share: (other - delivery) * full(share))


def gas(compression: float, peak: float, cut_off: float, exponents: Pair, exhaust: float) -> Forces:
    """Return the forces of the dual cycle in four strokes, from the expansion on; other faces at suction."""
    clearance = 1 / (compression - 1)
    volume = clearance * cut_off

    def expansion(share: Grid) -> Grid:
        return peak * (volume / np.maximum(clearance + share, volume)) ** exponents[1] - 1

    def compressed(share: Grid) -> Grid:
        whole = 1 + clearance
        return 1 - (whole / (whole - share)) ** exponents[0]

    return expansion, lambda share: 1 - exhaust + np.zeros_like(share), np.zeros_like, compressed


def text(value: float, places: int = 3) -> str:
    """Return a number as it is typed, of which kurbel and the model take the same value."""
    return f"{value:.{places}f}"


class Draw:
    """Random machines. Numbers are as they are typed: floats of few decimals."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)

    def number(self, low: float, high: float, places: int = 3) -> float:
        return round(self.random.uniform(low, high), places)

    def machine(self, mechanism: str, load: str) -> Machine:
        """Return a machine of this drive under this load."""
        drive, options = getattr(self, f"_{mechanism}")()
        double = self.random.random() < 0.6
        forces, acting = getattr(self, f"_{load}")(double)
        options |= acting
        cranks = self.random.choice(((0.0,), (0.0,), (0.0, 90.0), (0.0, 120.0, 240.0), (0.0, 77.5)))
        if len(cranks) > 1:
            options["cranks"] = ";".join(text(one, 1) for one in cranks)
        masses = Rod()
        if self.random.random() < 0.4:
            masses, more = self._masses(load, options)
            options |= more
        elif options.get("pump") == "double":
            # Without a bore nothing is counted in them.
            del options["suction_pressure"], options["delivery_pressure"]
        return Machine(drive, forces, options, cranks, masses)

    def _straight(self) -> tuple[Slide, dict[str, Any]]:
        length = self.number(2.2, 8)
        return Slide(length), {"ratio": f"1:{text(length)}"}

    def _offset(self) -> tuple[Slide, dict[str, Any]]:
        length, offset = self.number(3, 8), self.number(-1.6, 1.6)
        return Slide(length, offset), {"ratio": f"1:{text(length)}", "offset": text(offset)}

    def _arc(self) -> tuple[Rocker, dict[str, Any]]:
        length, rocker, offset = self.number(3, 6), self.number(3, 9), self.number(-0.8, 0.8)
        drive = Rocker(length, rocker, (length, offset + rocker))
        return drive, {
            "mechanism": "arc", "ratio": f"1:{text(length)}", "rocker": text(rocker), "offset": text(offset),
        }  # fmt: skip

    def _beam(self) -> tuple[Rocker, dict[str, Any]]:
        length, arm = self.number(4, 8), self.number(2, 6)
        return beam(arm, length), {"mechanism": "beam", "ratio": f"1:{text(length)}", "beam": text(arm)}

    def _steam(self, double: bool) -> tuple[Forces, dict[str, Any]]:
        expansion, exponent = self.number(1.1, 6, 2), self.random.choice((1.0, 1.0, 1.13, 1.3))
        clearance, back = self.number(0, 0.1, 2), self.number(0, 0.12, 2)
        given = {
            "eps": text(expansion, 2), "back": text(back, 2), "exponent": text(exponent, 2),
            "clearance": text(clearance, 2), "single_acting": not double,
        }  # fmt: skip
        return steam(expansion, back, exponent, clearance, double), given

    def _compressor(self, double: bool) -> tuple[Forces, dict[str, Any]]:
        ratio, exponent = self.number(1.5, 6, 2), self.random.choice((1.0, 1.2, 1.35))
        clearance = self.random.choice((0.0, self.number(0.01, 0.1, 2)))
        losses = self.random.choice(((0.0, 0.0), (self.number(0, 0.1, 2), self.number(0, 0.1, 2))))
        given = {
            "pressure_ratio": text(ratio, 2), "exponent": text(exponent, 2), "clearance": text(clearance, 2),
            "suction_loss": text(losses[0], 2), "delivery_loss": text(losses[1], 2),
            "single_acting": not double,
        }  # fmt: skip
        return compressor(ratio, exponent, clearance, losses, double), given

    def _pump(self, double: bool) -> tuple[Forces, dict[str, Any]]:
        kind = self.random.choice(("double", "single", "differential"))
        suction, delivery, small = self.number(-0.6, 0.6, 2), self.number(1, 9, 2), self.number(0.2, 0.7, 2)
        given = {
            "pump": kind, "suction_pressure": f"{text(suction, 2)}bar",
            "delivery_pressure": f"{text(delivery, 2)}bar",
        }  # fmt: skip
        if kind == "differential":
            given["small_area"] = text(small, 2)
        return pump(kind, suction / (delivery - suction), small), given

    def _gas(self, double: bool) -> tuple[Forces, dict[str, Any]]:
        compression, exponents = self.number(4, 9, 1), (self.number(1.2, 1.4, 2), self.number(1.15, 1.4, 2))
        cut_off, exhaust = self.number(1, 2, 2), self.number(1, 1.2, 2)
        peak = round(compression ** exponents[0] * self.number(1.5, 3), 1)
        given = {
            "compression": text(compression, 1), "cycle": "dual", "peak_pressure": text(peak, 1),
            "cut_off": text(cut_off, 2), "exponent": text(exponents[0], 2),
            "expansion_exponent": text(exponents[1], 2), "exhaust_pressure": text(exhaust, 2),
        }  # fmt: skip
        return gas(compression, peak, cut_off, exponents, exhaust), given

    def _masses(self, load: str, options: Mapping[str, Any]) -> tuple[Rod, dict[str, Any]]:
        """Return masses whose forces are a share of the load's, and what weighs them."""
        stroke, bore, speed = self.number(0.3, 1.5, 2), self.number(0.2, 0.6, 2), self.number(5, 20, 1)
        share = self.number(0.02, 0.2)
        pressure = 8.0 if load == "steam" else 1.0
        if load == "pump":
            suction, delivery = (float(options[f"{one}_pressure"][:-3]) for one in ("suction", "delivery"))
            pressure = delivery - suction
        unit = math.pi / 4 * bore**2 * pressure * 1e5 / (stroke / 2 * speed**2)
        reciprocating, rod = (round(unit * one, 1) for one in (share, share / 2))
        centre, gyration = self.number(0.4, 0.8, 2), self.number(0.2, 0.4, 2)
        given = {
            "stroke": f"{text(stroke, 2)}m", "bore": f"{text(bore, 2)}m", "speed": f"{text(speed, 1)}rad/s",
            "reciprocating": f"{text(reciprocating, 1)}kg", "rod_mass": f"{text(rod, 1)}kg",
            "centre": text(centre, 2), "gyration": text(gyration, 2),
        }  # fmt: skip
        if load == "steam":
            given["pressure"] = "8bar"
        elif load != "pump":
            given["suction_pressure"] = "1bar"
        # kurbel's centre counts from the crosshead pin.
        return Rod(reciprocating / unit, rod / unit, 1 - centre, gyration), given


def beam(arm: float, length: float) -> Rocker:
    """Return the beam engine whose end swings as far above the horizontal through its pivot as below it, and
    leans by half the sagitta to either side of the vertical through the shaft.

    The dead centres, at which the rod's end is length ± 1 from the shaft, are as high above each other as the
    end swings; turned so that the slide direction, upwards, is kurbel's.
    """

    def lacking(chord: float) -> float:
        sagitta = arm - math.sqrt(arm**2 - chord**2)
        heights = [math.sqrt((length + sign) ** 2 - sagitta**2 / 4) for sign in (1, -1)]
        return heights[0] - heights[1] - 2 * chord

    chord = brentq(lacking, 0.5, min(arm, length) * (1 - 1e-12), xtol=1e-15)
    sagitta = arm - math.sqrt(arm**2 - chord**2)
    heights = [math.sqrt((length + sign) ** 2 - sagitta**2 / 4) for sign in (1, -1)]
    # In the middle the end lies half the sagitta beyond the vertical, away from the pivot.
    return Rocker(length, arm, (sum(heights) / 2, arm - sagitta / 2))


MECHANISMS = ("straight", "offset", "arc", "beam")
LOADS = ("steam", "compressor", "pump", "gas")
DIGITS = 5


def printed(machine: Machine) -> tuple[float, float]:
    """Return the mean tangential force and δ as kurbel prints them."""
    import kurbel

    page = kurbel.delta_table(**machine.options, columns="mean_force,delta", digits=DIGITS)
    *_, force, delta = kurbel.typeset(page, "csv").splitlines()[-1].split(",")
    return float(force), float(delta)


def compared(machine: Machine, samples: int) -> float:
    """Return by how many units of its last place the worse of both is off the sum over the steps."""
    pairs = zip(printed(machine), machine.turned(samples), strict=True)
    return float(max(abs(one - other) for one, other in pairs) * 10**DIGITS)


def main() -> int:
    parser = argparse.ArgumentParser()
    for name, default in (("machines", 200), ("samples", 2_000_000), ("seed", 1)):
        parser.add_argument(f"--{name}", type=int, default=default)
    asked = parser.parse_args()
    draw, worst = Draw(asked.seed), 0.0
    for number in range(asked.machines):
        mechanism = MECHANISMS[number % len(MECHANISMS)]
        load = LOADS[number // len(MECHANISMS) % len(LOADS)]
        machine = draw.machine(mechanism, load)
        off = compared(machine, asked.samples)
        worst = max(worst, off)
        if off > 1:
            print(f"{mechanism}, {load}: off by {off:.2f}: {machine.options}")
    print(f"{asked.machines} machines in {asked.samples} steps each: at most {worst:.3f} of the last place")
    return int(worst > 1)


if __name__ == "__main__":
    sys.exit(main())
