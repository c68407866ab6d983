"""Machines of every drive under every load: force, energy, load of the rod and speed, nothing of kurbel's.

The driven end of a mechanism is found from the lengths of its links, its velocity from their constraints, the
dead centres where that is zero. The tangential force follows by virtual work, the energy by quadrature
between the corners of the load, that of the masses from the velocities of two points of the rod, what presses
on its ends from Newton's and Euler's equations. Lengths are in R, forces in Q, masses in Q/(R ω²), angles of
the crank in degrees from the slide direction.

python tests/support/machines.py [--machines N] [--seed N]

compares so many random machines with what kurbel prints.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import brentq
from strokes import Grid, Options, Stroke, number, pressure_of, strokes
from turns import Speed, Turn

Plane: TypeAlias = Any
# Steps of the difference that is a derivative to sixteen digits of what has its waves in whole turns.
REACH = 0.02


class Motion(NamedTuple):
    """The driven end at crank angles: its way since somewhere, which grows on the outstroke, the slope of
    that, where it stands and where the outstroke leads, X from the shaft to the cylinder and Y to the side of
    the pin on the outstroke."""

    way: Grid
    speed: Grid
    place: Plane
    heading: Plane

    @property
    def velocity(self) -> Plane:
        return self.speed * self.heading


@dataclass(frozen=True)
class Slide:
    """A piston on a straight slide that passes the shaft at `offset`; `series` to the first power of λ."""

    length: float
    offset: float = 0.0
    series: bool = False

    @property
    def true(self) -> Slide:
        return Slide(self.length, self.offset)

    def motion(self, angle: Grid) -> Motion:
        rise = np.sin(angle) - self.offset
        if self.series:
            drop, slope = rise**2 / (2 * self.length), rise * np.cos(angle) / self.length
        else:
            reach = np.sqrt(self.length**2 - rise**2)
            drop, slope = rise**2 / (self.length + reach), rise * np.cos(angle) / reach
        way, speed = drop - np.cos(angle), np.sin(angle) + slope
        # An infinite rod ends nowhere.
        far = self.length if self.length < math.inf else 0.0
        return Motion(way, speed, far - way + 1j * self.offset, np.full_like(angle, -1) + 0j)


@dataclass(frozen=True)
class Rocker:
    """A piston at the end of a rocker whose pivot lies at x + iy from the shaft."""

    length: float
    rocker: float
    pivot: complex

    @property
    def true(self) -> Rocker:
        return self

    def motion(self, angle: Grid) -> Motion:
        """Return the motion of that end which lies farther from the shaft along the slide."""
        pin = np.exp(1j * angle)
        line = pin - self.pivot
        # The angle at the pivot in the triangle of rocker, rod and the line to the crank pin.
        opening = np.arccos(
            (self.rocker**2 + abs(line) ** 2 - self.length**2) / (2 * self.rocker * abs(line))
        )
        towards = np.angle(line / -self.pivot) + np.angle(-self.pivot)
        side = 1 if np.cos(towards + opening).sum() > np.cos(towards - opening).sum() else -1
        radius = self.rocker * np.exp(1j * (towards + side * opening))
        rod = self.pivot + radius - pin
        # The end moves square to the rocker, and as fast along the rod as the pin does.
        square = -1j * side * radius / self.rocker
        speed = _dot(rod, 1j * pin) / _dot(rod, square)
        way = -side * self.rocker * (towards + side * opening)
        return Motion(way, speed, self.pivot + radius, square)


Drive: TypeAlias = Slide | Rocker


def _dot(one: Plane, other: Plane) -> Grid:
    return np.asarray((one * other.conjugate()).real)


def _cross(arm: Plane, force: Plane) -> Grid:
    return np.asarray((arm.conjugate() * force).imag)


def slope(function: Callable[[Grid], Any], angle: Grid) -> Any:
    """Return the derivative over the angle."""
    factors = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
    return sum(
        factor * (function(angle + step * REACH) - function(angle - step * REACH)) / REACH
        for step, factor in enumerate(factors, 1)
    )


class Masses(NamedTuple):
    """What reciprocates, the rod, its centre from the crosshead pin and its radius of gyration in lengths,
    the rocker's J/B², the crank's counterweight, and gravity over R ω²."""

    reciprocating: float = 0.0
    rod: float = 0.0
    centre: float = 0.5
    gyration: float = 0.3
    rocker: float = 0.0
    rotating: float = 0.0
    gravity: complex = 0j


@dataclass(frozen=True)
class Machine:
    """Pistons alike, each on a drive of this kind; `options` are kurbel's for the same."""

    drive: Drive
    strokes: Sequence[Stroke]
    options: Options
    cranks: tuple[float, ...] = (0.0,)
    masses: Masses = field(default_factory=Masses)

    @cached_property
    def dead_centres(self) -> tuple[float, float]:
        """The crank angles in degrees at which the outstroke and the return begin."""

        def speed(angle: float) -> float:
            return float(self.drive.motion(np.array([angle])).speed[0])

        coarse = np.linspace(0, math.tau, 721) - 3
        grows = self.drive.motion(coarse).speed > 0
        roots = {
            bool(grows[index + 1]): brentq(speed, coarse[index], coarse[index + 1], xtol=1e-15)
            for index in np.flatnonzero(grows[1:] != grows[:-1])
        }
        inner, outer = math.degrees(roots[True]), math.degrees(roots[False])
        return inner, outer if outer > inner else outer + 360

    @property
    def cycle(self) -> int:
        """Degrees after which the load comes again."""
        return 180 * len(self.strokes)

    @cached_property
    def _ends(self) -> Grid:
        return self.drive.motion(np.radians(self.dead_centres)).way

    def stroke(self, degrees: ArrayLike) -> tuple[Any, Grid]:
        """Return the stroke at angles of a crank of its own, and the share of it that is gone."""
        angle = np.asarray(degrees, dtype=float)
        inner, outer = self.dead_centres
        since = np.mod(angle - inner, self.cycle)
        stroke = 2 * np.floor(since / 360).astype(int) + (np.mod(since, 360) >= outer - inner)
        gone = (self.drive.motion(np.radians(angle)).way - self._ends[0]) / (self._ends[1] - self._ends[0])
        return stroke, np.clip(np.where(stroke % 2, 1 - gone, gone), 0, 1)

    def net(self, degrees: ArrayLike) -> Grid:
        """Return the force on one piston in its direction of travel, by angles of its own crank."""
        stroke, share = self.stroke(degrees)
        return np.select([stroke == index for index in range(len(self.strokes))],
                         [one.force(share) for one in self.strokes])  # fmt: skip

    def steam(self, degrees: ArrayLike, drive: Drive | None = None) -> Grid:
        """Return the tangential force of the load of all cranks, at the true angle of the rod."""
        drive = drive or self.drive.true
        own = [np.asarray(degrees, dtype=float) - crank for crank in self.cranks]
        return np.asarray(sum(self.net(one) * abs(drive.motion(np.radians(one)).speed) for one in own))

    def power(self, degrees: ArrayLike) -> Grid:
        """Return the work over the angle: the tangential force, but to the first power of λ."""
        if self.drive.true == self.drive:
            return self.force(degrees)
        return self.steam(degrees, self.drive)

    def force(self, degrees: ArrayLike) -> Grid:
        """Return the tangential force of load and masses of all cranks."""
        if self.masses == Masses():
            return self.steam(degrees)
        return self.steam(degrees) - slope(self.stored, np.radians(np.asarray(degrees, dtype=float)))

    def stored(self, angle: Grid) -> Grid:
        """Return the energy of motion and of height of all masses in Q R, at radians."""
        return self.kinetic(angle) - self.fallen(angle)

    def kinetic(self, angle: Grid) -> Grid:
        return self._sum(self._kinetic, angle)

    def fallen(self, angle: Grid) -> Grid:
        """Return what gravity has done on the way to the places of the masses."""
        return self._sum(self._height, angle)

    def _sum(self, energy: Callable[[Grid], Grid], angle: Grid) -> Grid:
        return np.asarray(sum(energy(angle - math.radians(crank)) for crank in self.cranks))

    def _kinetic(self, angle: Grid) -> Grid:
        masses, end = self.masses, self.drive.motion(angle)
        pin = 1j * np.exp(1j * angle)
        middle = end.velocity + masses.centre * (pin - end.velocity)
        own = abs(middle) ** 2 + (masses.gyration * abs(pin - end.velocity)) ** 2
        return ((masses.reciprocating + masses.rocker) * end.speed**2 + masses.rod * own) / 2

    def _height(self, angle: Grid) -> Grid:
        masses, end = self.masses, self.drive.motion(angle).place
        middle = end + masses.centre * (np.exp(1j * angle) - end)
        return _dot(masses.reciprocating * end + masses.rod * middle, np.full_like(end, masses.gravity))

    def angles_of(self, stroke: int, shares: ArrayLike) -> Grid:
        """Return the angles in degrees at which these shares of a stroke are gone, by halving."""
        inner, outer = self.dead_centres
        wanted = np.asarray(shares, dtype=float)
        begin, end = ((inner, outer), (outer, inner + 360))[stroke % 2]
        low, high = np.full_like(wanted, begin), np.full_like(wanted, end)
        ends = self._ends[::-1] if stroke % 2 else self._ends
        for _ in range(54):
            middle = (low + high) / 2
            gone = (self.drive.motion(np.radians(middle)).way - ends[0]) / (ends[1] - ends[0])
            low, high = np.where(gone < wanted, middle, low), np.where(gone < wanted, high, middle)
        return low + 360 * (stroke // 2)

    @cached_property
    def turn(self) -> Turn:
        return Turn(self)

    def rod(self, degrees: ArrayLike) -> dict[str, Grid]:
        """Return the forces of one crank in Q by kurbel's names, all in the frame of the outstroke."""
        masses, angle = self.masses, np.radians(np.asarray(degrees, dtype=float))
        gravity, pin, end = masses.gravity, np.exp(1j * angle), self.drive.motion(angle)
        heading = end.heading
        piston = self.net(degrees) * np.where(self.stroke(degrees)[0] % 2, -1, 1)
        line = end.place - pin
        speeds = slope(lambda at: self.drive.motion(at).velocity, angle)
        to_centre = (1 - masses.centre) * line
        pull = masses.rod * (-pin + (1 - masses.centre) * (speeds + pin) - gravity)
        turning = slope(lambda at: _spin(self.drive, at), angle)
        moment = masses.rod * (masses.gyration * abs(line)) ** 2 * turning + _cross(to_centre, pull)
        # The rod's end is pressed by what inertia and weight leave of the piston's force.
        inertia, weight = masses.reciprocating * -speeds, masses.reciprocating * gravity
        along = piston + _dot(inertia + weight, heading)
        aside = heading * -1j
        across = (moment - along * _cross(line, heading)) / _cross(line, aside)
        head = along * heading + across * aside
        foot = pull - head
        bearing = masses.rotating * pin - foot
        return {
            "piston_force": piston, "inertia_force": _dot(inertia, heading), "crosshead_load": along,
            "guide_force": across - _dot(inertia + weight, aside),
            "rod_force": -_dot(head, line) / abs(line), "crank_end_force": _dot(foot, line) / abs(line),
            "crosshead_pin_force": abs(head), "crank_pin_force": abs(foot),
            "tangential_force": -_cross(pin, foot), "radial_force": _dot(pin, foot),
            "bearing_along": -bearing.real, "bearing_across": bearing.imag, "bearing_force": abs(bearing),
        }  # fmt: skip

    def speed(self, inertia: float | None = None, number: float = 0.0, square: bool = False) -> Speed:
        """Return the speed of a flywheel of J in Q R/ω² or of m₁ v₁²/(P r), against a constant torque or one
        as the square of the speed."""
        return Speed(self, inertia, number, square)


def _spin(drive: Drive, angle: Grid) -> Grid:
    """Return the angular velocity of the rod over that of the crank."""
    end, pin = drive.motion(angle), np.exp(1j * angle)
    return _cross(end.place - pin, end.velocity - 1j * pin) / abs(end.place - pin) ** 2


def machine(**options: Any) -> Machine:
    """Return the machine that kurbel's options describe, written as they are typed."""
    drive, radius = _drive(options), number(options.get("stroke"), 2.0) / 2
    cranks = tuple(number(one) for one in str(options.get("cranks", 0)).split(";"))
    return Machine(drive, strokes(options), options, cranks, _masses(options, drive, radius))


def _ratio(options: Options) -> float:
    if "rod" in options:
        return number(options["stroke"]) / 2 / number(options["rod"])
    crank, _, rod = str(options.get("ratio", "1:5")).replace("/", ":").partition(":")
    return 0.0 if rod == "∞" else float(crank) / float(rod or 1)


def _drive(options: Options) -> Drive:
    ratio = _ratio(options)
    length = 1 / ratio if ratio else math.inf
    offset = number(options.get("offset"))
    if str(options.get("offset", "")).endswith("m"):
        offset /= number(options["stroke"]) / 2
    mechanism = options.get("mechanism")
    if mechanism == "beam":
        return beam(number(options["beam"]), length)
    if mechanism == "arc":
        rocker = number(options["rocker"])
        along, _, across = str(options.get("pivot", f"{length};{offset + rocker}")).partition(";")
        return Rocker(length, rocker, complex(float(along), float(across)))
    return Slide(length, offset, options.get("method") == "series")


def _masses(options: Options, drive: Drive, radius: float) -> Masses:
    if not options.keys() & {"reciprocating", "rod_mass", "rotating"}:
        return Masses()
    omega = number(options["speed"]) * (1 if isinstance(options["speed"], str) else math.tau)
    scale = radius * omega**2 / (math.pi / 4 * number(options["bore"]) ** 2 * pressure_of(options))
    weights = [scale * number(options.get(key)) for key in ("reciprocating", "rod_mass", "rotating")]
    rocker = 0.0
    if isinstance(drive, Rocker):
        rocker = scale * number(options.get("rocker_inertia")) / (drive.rocker * radius) ** 2
    gravity = 0j
    if "slope" in options:
        steep = math.radians(90.0 if options["slope"] == "vertical" else number(options["slope"]))
        pull = number(options.get("gravity"), 9.80665) / (radius * omega**2)
        gravity = -pull * complex(math.sin(steep), math.cos(steep))
    centre, gyration = number(options.get("centre"), 0.5), number(options.get("gyration"), 0.3)
    return Masses(weights[0], weights[1], centre, gyration, rocker, weights[2], gravity)


def beam(arm: float, length: float) -> Rocker:
    """Return the beam engine whose end swings as far above the horizontal through its pivot as below it, and
    leans by half the sagitta to either side of the vertical through the shaft.

    The dead centres, at which the rod's end is length ± 1 from the shaft, are as high above each other as the
    end swings; turned so that the slide direction, upwards, is kurbel's.
    """

    def heights(chord: float) -> tuple[float, float, float]:
        sagitta = arm - math.sqrt(arm**2 - chord**2)
        high, low = (math.sqrt((length + sign) ** 2 - sagitta**2 / 4) for sign in (1, -1))
        return high, low, sagitta

    def lacking(chord: float) -> float:
        high, low, _ = heights(chord)
        return high - low - 2 * chord

    high, low, sagitta = heights(brentq(lacking, 0.5, min(arm, length) * (1 - 1e-12), xtol=1e-15))
    # In the middle the end lies half the sagitta beyond the vertical, away from the pivot.
    return Rocker(length, arm, complex((high + low) / 2, arm - sagitta / 2))


if __name__ == "__main__":
    from drawn_machines import main

    sys.exit(main())
