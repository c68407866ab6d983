"""A turn of an engine in floats, at arrays of crank angles."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from kurbel.drive.crank_forces import CrankForce
from kurbel.engine.cylinder import AnyTurn, Cylinder, Peak, Standing
from kurbel.engine.quantities import Where, value
from kurbel.errors import ProblemError
from kurbel.exact.kind import floats
from kurbel.kernel.circle import Circle, circle

if TYPE_CHECKING:
    from kurbel.engine.request import EngineRequest
    from kurbel.page.quantity import Quantity

Floats = NDArray[np.float64]
# Half turns by which a float may lie before a dead centre that it is in.
ZERO_TOLERANCE = 1e-13
# What is a number of each crank angle.
AT_ANGLES = ("angle", "crank")


class FloatTurn(AnyTurn):
    """One cycle by a method, in floats."""

    @cached_property
    def cylinders(self) -> tuple[Cylinder, ...]:
        return self.cylinders_on(floats(), _circle)

    def total(self, value: Callable[[Cylinder, int, Any], Any], places: Floats, first: float) -> Floats:
        """Return the sum of a number and of what each crank has at an array of half turns."""
        total = np.full_like(places, first)
        for start, cylinder in self._cranks():
            total += _on_strokes(cylinder, start, value, places)
        return total

    def energies(self, places: Floats) -> Floats:
        """Return the excess work since the inner dead centre at an array of half turns."""
        return self.total(Cylinder.energy, places, -float(self.energy_begun()))

    def has_reached(self, since: Fraction, part: int, stroke: int) -> bool:
        begun = stroke + self.cylinders[part].drive.dead_centre(stroke % 2)
        return bool(float(since) - begun >= -ZERO_TOLERANCE)

    def begun(self) -> list[Standing]:
        return [*self.positions(Fraction(self.cylinder.drive.dead_centre(0)))]

    def _cranks(self) -> Iterator[tuple[Fraction, Cylinder]]:
        """Yield each crank's start, and its cylinder."""
        for part, cylinder in zip(self.engine.parts, self.cylinders, strict=True):
            for start in part.starts:
                yield start, cylinder


class ArrayTurn(FloatTurn):
    """The same, whose quantities of a crank angle are those of an array of half turns."""

    def of(self, value: Any) -> Any:
        return value if isinstance(value, np.ndarray) else super().of(value)

    def tangential_force(self, half_turns: Any) -> Any:
        return self.total(Cylinder.effort, half_turns, 0.0)

    def energy_at(self, half_turns: Any) -> Any:
        return self.energies(half_turns)

    def crank_force(self, force: CrankForce, half_turns: Any) -> Any:
        def of_first(cylinder: Cylinder, stroke: int, angle: Any) -> Any:
            return cylinder.force(force, stroke, angle)

        return _on_strokes(self.cylinder, self.part.starts[0], of_first, half_turns)

    def peaks(self, greatest: bool, stroke: int | None = None) -> Sequence[Peak]:
        raise AssertionError("a crank angle has no extremes")


def at_angles(request: EngineRequest, quantity: Quantity, method: str, degrees: Floats) -> list[Floats]:
    """Return a quantity of a crank angle at an array of angles, for each load and each drive in turn.

    Raises ProblemError for a quantity that is not of a crank angle.
    """
    if quantity.of not in AT_ANGLES:
        raise ProblemError(
            f"{quantity.key} is one number of a turn and has no array over the crank angle; print it, with"
            " kurbel.delta"
        )
    # Kernels hand the place on to the turn, and that of arrays takes an array.
    where = Where(half_turns=degrees / 180)
    return [
        np.broadcast_to(value(quantity, ArrayTurn(engine, method), where), degrees.shape)
        for engine in (
            request.engine(steam, drive)
            for steam in range(len(request.steams))
            for drive in range(len(request.drives))
        )
    ]


def _on_strokes(
    cylinder: Cylinder, start: Fraction, value: Callable[[Cylinder, int, Any], Any], places: Floats
) -> Floats:
    """Return what a crank has that follows the first by so many half turns, at each of the places."""
    begins = [stroke + cylinder.drive.dead_centre(stroke % 2) for stroke in range(len(cylinder.strokes))]
    since = (places - float(start) - begins[0]) % len(begins) + begins[0]
    strokes = np.searchsorted(begins, since, side="right") - 1
    found = np.empty_like(places)
    for stroke in range(len(begins)):
        here = strokes == stroke
        found[here] = value(cylinder, stroke, since[here] - stroke)
    return found


def _circle(half_turns: Any) -> Circle[Any]:
    """Return the circle of exact half turns, or of floats."""
    return circle(180.0 * (float(half_turns) if isinstance(half_turns, Fraction) else half_turns))
