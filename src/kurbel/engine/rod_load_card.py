"""The load of the rod where an indicator card gives the pressures: in floats, with an error estimate."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq, minimize_scalar

from kurbel.drive.at import CrankForce
from kurbel.engine.arrays import ZERO_TOLERANCE
from kurbel.engine.card.force import NOTHING, SAMPLES, CardTurn
from kurbel.engine.cylinder import SIGNS
from kurbel.engine.rod_load import AnyRodLoad, Span
from kurbel.kernel.circle import Numeric

# Of a stroke; a load of less than this in Q has no sign.
LEAST_LOAD = 1e-12
# Half turns over which slopes and bends are taken.
BESIDE = 1e-3


class _Extreme(NamedTuple):
    """The greatest load of a sign: its value, its stroke and the angle in that; at an end of it exactly."""

    value: float
    stroke: int
    angle: float
    at_end: bool


class CardRodLoad(AnyRodLoad):
    """The load of the first crank's rod, sampled and refined."""

    def __init__(self, turn: CardTurn, force: CrankForce) -> None:
        self.turn, self.force = turn, force

    @cached_property
    def coarser(self) -> tuple[CardRodLoad, ...]:
        """The loads by the two cards that have every second point."""
        return tuple(CardRodLoad(half, self.force) for half in self.turn.coarser)

    def load(self, stroke: int, angle: Numeric) -> Any:
        """Return the load in Q on a stroke, of a float or an array of half turns."""
        return self.turn.cylinder.force(self.force, stroke, angle) + 0.0 * angle

    def _ends(self, stroke: int) -> tuple[float, float]:
        drive, way = self.turn.cylinder.drive, stroke % 2
        return float(drive.dead_centre(way)), 1 + float(drive.dead_centre(1 - way))

    @cached_property
    def _samples(self) -> list[tuple[NDArray[np.float64], NDArray[np.float64]]]:
        """The angles in each stroke and the loads there."""
        angles = [
            np.linspace(*self._ends(stroke), SAMPLES) for stroke in range(len(self.turn.cylinder.strokes))
        ]
        loads = [self.load(stroke, each) for stroke, each in enumerate(angles)]
        for each in loads:
            # What is nothing but for rounding changes no sign in a dead centre.
            each[[0, -1]] *= abs(each[[0, -1]]) > LEAST_LOAD
        return [*zip(angles, loads, strict=True)]

    @cached_property
    def _greatest(self) -> dict[int, _Extreme]:
        found = {sign: self._found(sign) for sign in SIGNS}
        return {sign: one for sign, one in found.items() if sign * one.value > LEAST_LOAD}

    def _found(self, sign: int) -> _Extreme:
        stroke = max(
            range(len(self._samples)), key=lambda stroke: float((sign * self._samples[stroke][1]).max())
        )
        angles, loads = self._samples[stroke]
        index = int((sign * loads).argmax())
        if index in (0, len(angles) - 1):
            return _Extreme(float(loads[index]), stroke, float(angles[index]), True)
        near = minimize_scalar(
            lambda angle: -sign * float(self.load(stroke, angle)),
            bounds=(angles[index - 1], angles[index + 1]),
            method="bounded",
            options={"xatol": ZERO_TOLERANCE},
        )
        return _Extreme(-sign * float(near.fun), stroke, float(near.x), False)

    def greatest(self, sign: int) -> float | None:
        return sign * self._greatest[sign].value if sign in self._greatest else None

    def degrees(self, sign: int) -> float | Fraction | None:
        found = self._greatest.get(sign)
        if found is None:
            return None
        if found.at_end and self.turn.cylinder.drive.regular:
            return Fraction(180 * round(found.stroke + found.angle))
        return 180 * (found.stroke + found.angle)

    @cached_property
    def _zeros(self) -> list[tuple[int, float]]:
        """The strokes and angles at which the load changes its sign within a stroke."""
        return [
            (stroke, float(brentq(lambda at, stroke=stroke: float(self.load(stroke, at)), low, high)))
            for stroke, (angles, loads) in enumerate(self._samples)
            for (low, before), (high, after) in pairwise(zip(angles, loads, strict=True))
            if before * after < 0
        ]

    @cached_property
    def spans(self) -> Sequence[Span]:
        return [*self._spans()]

    def _spans(self) -> Iterator[Span]:
        for stroke in range(len(self._samples)):
            begin, end = self._ends(stroke)
            inner = [angle for place, angle in self._zeros if place == stroke]
            for low, high in pairwise((begin, *inner, end)):
                load = float(self.load(stroke, (low + high) / 2))
                yield Span(0 if abs(load) < LEAST_LOAD else 1 if load > 0 else -1, high - low)

    def error(self, kernel: Callable[[AnyRodLoad], Numeric], allowed: float) -> float:
        """Return how far a number may be off: by what the coarser cards show, or what is allowed for."""
        best, others = kernel(self), [kernel(half) for half in self.coarser]
        return max(allowed, *(abs(float(best - other)) for other in others if other is not None))

    def force_error(self, sign: int) -> float:
        """Return how far the greatest load may be off, in Q."""
        at = self._greatest[sign]
        return self._force_error(at.stroke, at.angle)

    def _force_error(self, stroke: int, angle: float) -> float:
        cylinder = self.turn.cylinder
        bare = cylinder.drive.bare(self.force, stroke % 2, cylinder.circle(angle))
        return self.turn.force_apart * abs(float(bare))

    def place_error(self, sign: int) -> float:
        """Return how far its place may be off, in half turns: as far as the load is flat within its error."""
        at = self._greatest[sign]
        if at.at_end:
            return 0.0
        beside = [float(self.load(at.stroke, at.angle + step)) for step in (-BESIDE, 0, BESIDE)]
        bend = abs(beside[0] - 2 * beside[1] + beside[2]) / BESIDE**2
        return float(np.sqrt(2 * self.force_error(sign) / (bend + NOTHING)))

    def share_error(self) -> float:
        """Return how far the reversed load may be off, in percent of the greatest."""
        errors = [self.force_error(sign) for sign in self._greatest]
        return 100 * sum(errors) / max(abs(one.value) for one in self._greatest.values())

    def zero_error(self) -> float:
        """Return how far all zeros together may be off, in half turns."""
        return sum(self._force_error(*zero) / (abs(self._slope(*zero)) + NOTHING) for zero in self._zeros)

    def _slope(self, stroke: int, angle: float) -> float:
        beyond, before = (float(self.load(stroke, angle + step)) for step in (BESIDE, -BESIDE))
        return (beyond - before) / (2 * BESIDE)
