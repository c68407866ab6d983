"""The load of a connecting rod by brute force: a fine grid over the turn, without kurbel's formulas.

Joints are placed as geometry says, their accelerations are Fourier derivatives of the places, and the rod's
forces follow from Newton's and Euler's equations. Lengths are in R, forces in Q, masses in Q/(R ω²); X points
from the shaft along the slide, Y to the side of the pin on the outstroke. Strokes are sampled with both ends.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
SAMPLES = 2**16


class Body(NamedTuple):
    """A rod's mass, its centre in rod lengths from the crank pin, and k² in those squared."""

    mass: float = 0.0
    centre: float = 0.5
    gyration_square: float = 0.1


class Drive(NamedTuple):
    ratio: float
    offset: float = 0.0
    reciprocating: float = 0.0
    rod: Body = Body()


class Extremes(NamedTuple):
    """Greatest thrust and pull, their places in degrees, and over how many degrees there is either."""

    thrust: float
    pull: float
    thrust_at: float
    pull_at: float
    thrust_angle: float
    pull_angle: float


def loads(drive: Drive, strokes: Sequence[Callable[[Array], Array]]) -> dict[str, Extremes]:
    """Return the load at each place, of the net pressures over the share of each stroke of a cycle."""
    angles = 2 * np.pi * np.arange(SAMPLES) / SAMPLES
    length = 1 / drive.ratio
    pin = np.array([np.cos(angles), np.sin(angles)])
    across = drive.offset - pin[1]
    crosshead = pin[0] + np.sqrt(length**2 - across**2)
    far, near = (length + side for side in (1, -1))
    inner = np.arcsin(drive.offset / far)
    outer = np.pi + np.arcsin(drive.offset / near)
    begin, end = np.sqrt(far**2 - drive.offset**2), np.sqrt(near**2 - drive.offset**2)
    share = (begin - crosshead) / (begin - end)
    stacked: dict[str, list[tuple[Array, Array]]] = {}
    inertia = _forces(drive, pin, crosshead)
    for stroke, pressure in enumerate(strokes):
        back = stroke % 2
        low, high = ((inner, outer), (outer, inner + 2 * np.pi))[back]
        place = np.linspace(low, high, SAMPLES)
        gone = np.clip(_at(place, share), 0, 1)
        net = pressure(1 - gone if back else gone) * (-1 if back else 1)
        for name, (of_pressure, of_masses) in inertia.items():
            load = net * _at(place, of_pressure) + _at(place, of_masses)
            stacked.setdefault(name, []).append((place + 2 * np.pi * (stroke // 2), load))
    return {name: _extremes(found) for name, found in stacked.items()}


def _forces(drive: Drive, pin: Array, crosshead: Array) -> dict[str, tuple[Array, Array]]:
    """Return each load on the grid by a unit pressure along the slide, and by the masses."""
    found: dict[str, list[Array]] = {}
    for net, moving in ((1.0, False), (0.0, True)):
        mass = drive.rod.mass if moving else 0.0
        # The crosshead presses on the rod against X with what its own inertia leaves of the piston's force.
        thrust = net - drive.reciprocating * moving * -_second(crosshead)
        line = np.array([crosshead, np.full_like(crosshead, drive.offset)]) - pin
        length = 1 / drive.ratio
        direction = line / length
        centre = pin + drive.rod.centre * line
        pull = mass * np.array([_second(centre[0]), _second(centre[1])])
        turning = np.arctan2(line[1], line[0])
        moment = mass * drive.rod.gyration_square * length**2 * _second(turning)
        # Moments about the crank pin of the force (-thrust, guide) on the crosshead end.
        wanted = moment + _cross(drive.rod.centre * line, pull)
        guide = (wanted - line[1] * thrust) / line[0]
        at_crosshead = np.array([-thrust, guide])
        at_pin = pull - at_crosshead
        found.setdefault("slide", []).append(thrust + 0 * guide)
        found.setdefault("crosshead", []).append(-np.sum(at_crosshead * direction, axis=0))
        found.setdefault("crank", []).append(np.sum(at_pin * direction, axis=0))
    return {name: (one, other) for name, (one, other) in found.items()}


def _cross(arm: Array, force: Array) -> Array:
    return np.asarray(arm[0] * force[1] - arm[1] * force[0])


def _second(values: Array) -> Array:
    """The second derivative over the angle of a periodic function on the grid."""
    spectrum = np.fft.rfft(values)
    orders = np.arange(len(spectrum))
    # Beyond these orders there is rounding only, which the square of the order would blow up.
    spectrum[orders > 400] = 0
    return np.asarray(np.fft.irfft(-(orders**2) * spectrum, len(values)))


def _at(place: Array, values: Array) -> Array:
    grid = 2 * np.pi * np.arange(-1, SAMPLES + 2) / SAMPLES
    wrapped = np.concatenate([values[-1:], values, values[:2]])
    return np.asarray(np.interp(place % (2 * np.pi), grid, wrapped))


def _extremes(found: Sequence[tuple[Array, Array]]) -> Extremes:
    place, load = (np.concatenate(parts) for parts in zip(*found, strict=True))
    spans = [[_span(angles, sign * loads) for sign in (1, -1)] for angles, loads in found]
    thrust, pull = (np.degrees(sum(column)) for column in zip(*spans, strict=True))
    high, low = int(load.argmax()), int(load.argmin())
    degrees = np.degrees(place)
    return Extremes(load[high], -load[low], degrees[high], degrees[low], float(thrust), float(pull))


def _span(angles: Array, loads: Array) -> float:
    """Over how much of the angles the load is above zero, zeros between samples by the chord."""
    step = angles[1] - angles[0]
    before, after = loads[:-1], loads[1:]
    # Of a load that is nothing rounding has a sign.
    floor = 1e-11
    above = np.where((before > floor) & (after > floor), 1.0, 0.0)
    crossed = np.maximum(before, after) > floor
    crossed &= np.minimum(before, after) < -floor
    with np.errstate(divide="ignore", invalid="ignore"):
        part = np.maximum(before, after) / np.abs(after - before)
    return float(np.sum(np.where(crossed, part, above)) * step)
