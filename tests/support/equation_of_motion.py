"""The speed of a crankshaft with a flywheel from its equation of motion, integrated step by step.

½ d(J ω²)/dφ = T - R, where J is that of the flywheel and of the masses of the drive at the crank angle, T the
torque of the steam and R the resistance. Textbook kinematics of a crank of radius 1 whose slide line passes
the shaft at a distance; nothing of kurbel's. The piston force before cut-off is 1.
"""

from __future__ import annotations

from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

TOLERANCES = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13}
# For the derivative of an analytic function along the imaginary axis.
STEP = 1e-200


class Masses(NamedTuple):
    """Piston and rod; the rod's centre of mass from the crosshead and its radius of gyration in lengths."""

    piston: float = 0.0
    rod: float = 0.0
    centre: float = 0.6
    gyration: float = 0.3


class Shaft(NamedTuple):
    """Cranks at angles in degrees, all with pistons under steam; J is that of what turns evenly."""

    inertia: float
    expansion: float
    back: float
    length: float = 5.0
    offset: float = 0.0
    double: bool = True
    cranks: tuple[float, ...] = (0.0,)
    masses: Masses = Masses()


class Motion:
    """One steady turn against a torque that is constant or, with a factor, as the square of the speed."""

    def __init__(self, shaft: Shaft, square: float | None = None) -> None:
        self.shaft, self.square = shaft, square

    def place(self, angle: Any) -> Any:
        """The crosshead's distance from the shaft along the slide."""
        return np.cos(angle) + np.sqrt(self.shaft.length**2 - (np.sin(angle) - self.shaft.offset) ** 2)

    def slope(self, angle: Any) -> Any:
        across = np.sin(angle) - self.shaft.offset
        return -np.sin(angle) - across * np.cos(angle) / np.sqrt(self.shaft.length**2 - across**2)

    @cached_property
    def dead(self) -> tuple[float, float]:
        """The crank angles of the inner and the outer dead centre."""
        length, offset = self.shaft.length, self.shaft.offset
        return float(np.arcsin(offset / (length + 1))), float(np.pi + np.arcsin(offset / (length - 1)))

    def share(self, angle: float) -> float:
        """The share of the stroke that the piston has gone."""
        inner, outer = map(self.place, self.dead)
        gone = (inner - self.place(angle)) / (inner - outer)
        return float(gone if self._is_out(angle) else 1 - gone)

    def _is_out(self, angle: float) -> bool:
        inner, outer = self.dead
        return (angle - inner) % (2 * np.pi) < outer - inner

    def torque(self, angle: float) -> float:
        return sum(self._torque_of_one(angle - np.radians(crank)) for crank in self.shaft.cranks)

    def _torque_of_one(self, angle: float) -> float:
        shaft = self.shaft
        if not (shaft.double or self._is_out(angle)):
            return 0.0
        pressure = min(1.0, 1 / (shaft.expansion * max(self.share(angle), 1e-12)))
        return (pressure - shaft.back) * abs(float(self.slope(angle)))

    def moving(self, angle: Any) -> Any:
        """The inertia of the masses but for that of the rod at the crank pin, which turns evenly."""
        one = self.shaft.masses
        return sum(self._moving_of_one(angle - np.radians(crank), one) for crank in self.shaft.cranks)

    def _moving_of_one(self, angle: Any, one: Masses) -> Any:
        length, across = self.shaft.length, np.sin(angle) - self.shaft.offset
        head, swing = self.slope(angle), np.cos(angle) / np.sqrt(length**2 - across**2)
        along = head + one.centre * (-np.sin(angle) - head)
        aside = one.centre * np.cos(angle)
        rod = along**2 + aside**2 + (one.gyration * length * swing) ** 2 - one.centre
        return one.piston * head**2 + one.rod * rod

    @cached_property
    def corners(self) -> list[float]:
        """Dead centres and cut-offs of all cranks over a turn from the first one's inner dead centre."""
        inner, outer = self.dead
        found = [inner, outer]
        for low, high in ((inner, outer), (outer, inner + 2 * np.pi)):
            within = (low + 1e-9, high - 1e-9)
            found.append(brentq(lambda at: self.share(at) - 1 / self.shaft.expansion, *within, xtol=1e-15))
        turns = {
            (corner + np.radians(crank) - inner) % (2 * np.pi) + inner
            for corner in found
            for crank in self.shaft.cranks
        }
        return sorted({*turns, inner, inner + 2 * np.pi})

    @cached_property
    def mean(self) -> float:
        """The mean torque of the steam."""
        work = 0.0
        for low, high in pairwise(self.corners):
            found = solve_ivp(lambda at, _: [self.torque(at)], (low, high), [0.0], **TOLERANCES)
            work += found.y[0, -1]
        return work / (2 * np.pi)

    def _change(self, angle: float, state: Any) -> list[float]:
        speed = state[0]
        growth = float(np.imag(self.moving(angle + 1j * STEP))) / STEP
        resistance = self.mean if self.square is None else self.square * speed**2
        pull = self.torque(angle) - resistance - growth * speed**2 / 2
        inertia = self.shaft.inertia + float(np.real(self.moving(angle)))
        return [pull / (inertia * speed), 1 / speed]

    def turn(self, first: float, angles: Any = ()) -> tuple[np.ndarray, np.ndarray]:
        """Return speeds and times at rising angles from the inner dead centre on, and at the end of the turn.

        `first` is the speed at the inner dead centre, where the time is 0.
        """
        state, speeds, times = np.array([first, 0.0]), [], []
        for low, high in pairwise(self.corners):
            wanted = [one for one in angles if low <= one < high]
            found = solve_ivp(self._change, (low, high), state, t_eval=[*wanted, high], **TOLERANCES)
            speeds += found.y[0, :-1].tolist()
            times += found.y[1, :-1].tolist()
            state = found.y[:, -1]
        return np.array([*speeds, state[0]]), np.array([*times, state[1]])

    def steady(self) -> float:
        """Return the speed at the dead centre that comes again after a turn, against the square of the speed.

        ½ J ω² has a linear equation: two turns tell it.
        """
        squares = [self.turn(first)[0][-1] ** 2 for first in (1.0, 2.0)]
        share = (squares[1] - squares[0]) / 3
        return float(np.sqrt((squares[0] - share) / (1 - share)))

    def extremes(self, first: float, steps: int = 3600) -> tuple[float, float]:
        """Return the least and the greatest speed, of parabolas through the samples."""
        inner = self.dead[0]
        angles = inner + np.linspace(0, 2 * np.pi, steps, endpoint=False)
        speeds = self.turn(first, angles)[0]
        return -_top(-speeds), _top(speeds)


def _top(values: np.ndarray) -> float:
    highest = int(values.argmax())
    if not 0 < highest < len(values) - 1:
        return float(values[highest])
    before, at, after = values[highest - 1 : highest + 2]
    return float(at - (after - before) ** 2 / (8 * (before - 2 * at + after)))
