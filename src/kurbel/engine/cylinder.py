"""A crank drive under its load, on any kind of number: the motion of the one, the force of the other.

Of the drive a turn asks where the piston is on a stroke and how fast; of the load, which force acts on it
there. Forces are in units of Q, energies in Q R; angles are half turns.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import reduce
from typing import Any, NamedTuple

from kurbel.drive.crank_forces import CrankForce, Weights
from kurbel.drive.load import Load
from kurbel.engine.engine import Engine
from kurbel.exact.kind import Kind
from kurbel.kernel import turning
from kurbel.kernel.circle import Circle, Number
from kurbel.kernel.rod import Loaded, kinetic_energy, torque_slope
from kurbel.kernel.steam import larger, smaller
from kurbel.kernel.turning import Motion, Stroke
from kurbel.motion.evaluation import OUT, RETURN

MOTIONS = {"exact": turning.EXACT, "series": turning.FIRST_ORDER, "weisbach": turning.FIRST_ORDER}
SIGNS = (OUT, RETURN)


class Peak(NamedTuple):
    """Where the speed is least or greatest, in half turns, its excess energy there, in Q R, and the stroke
    of the one crank."""

    place: Number
    energy: Number
    stroke: int


class Cylinder(NamedTuple):
    """A crank drive under its load: angles count from the dead centre of the stroke, 0 or 1, that it is in.

    `circle` makes the circle of them. Balls are of one precision.
    """

    ratio: Number
    motion: Motion
    strokes: tuple[Stroke, Stroke]
    mean: Number
    weights: Weights | None
    kind: Kind
    circle: Callable[[Any], Circle[Any]]

    def at(self, stroke: int, angle: Any) -> tuple[Circle[Any], Number]:
        """Return what a formula takes: the circle, and the ratio with the sign of the stroke."""
        return self.circle(angle), self.ratio * SIGNS[stroke]

    def effort(self, stroke: int, angle: Any) -> Number:
        """Return the tangential force of load and masses."""
        place = self.at(stroke, angle)
        force = turning.tangential_force(self.strokes[stroke], self.motion, *place)
        return force if self.weights is None else force + Loaded(*place, self.weights.masses).torque()

    def force(self, force: CrankForce, stroke: int, angle: Any) -> Number:
        """Return a force of the drive."""
        place = self.at(stroke, angle)
        net = self.strokes[stroke].force(self.motion.path(*place) / 2)
        return force.of(*place, self.weights, net) * (SIGNS[stroke] if force.framed else 1)

    def slope(self, stroke: int, angle: Any) -> Number:
        """Return the change of the effort with the half turns, of a load that knows that of its force."""
        place = self.at(stroke, angle)
        acting: Any = self.strokes[stroke]
        share, velocity = self.motion.path(*place) / 2, self.motion.velocity(*place)
        total = acting.slope(share) * velocity * velocity / 2
        total += acting.force(share) * self.motion.acceleration(*place)
        if self.weights is not None:
            total += torque_slope(*place, self.weights.masses)
        return total * self.kind.pi

    def energy(self, stroke: int, angle: Any) -> Number:
        """Return the work of the excess over the mean since the inner dead centre."""
        place = self.at(stroke, angle)
        work = turning.work_done(self.strokes[stroke], self.motion, *place)
        if self.weights is not None:
            work -= kinetic_energy(*place, self.weights.masses)
        before = 2 * self.strokes[0].work(1) if stroke else 0
        turned = angle + stroke
        if isinstance(turned, Fraction):
            turned = self.kind.of(turned)
        return before + work - self.mean * turned * self.kind.pi


class AnyTurn(ABC):
    """A turn of an engine by a method: in balls or, of an indicator card, in floats with an error.

    Angles are half turns from the inner dead centre of the first crank.
    """

    def __init__(self, engine: Engine, method: str) -> None:
        self.engine = engine
        self.method = method

    @property
    @abstractmethod
    def cylinder(self) -> Cylinder:
        """The cylinders' common formulas, of balls at the precision in force."""

    def cylinder_on(self, kind: Kind, circle: Callable[[Any], Circle[Any]]) -> Cylinder:
        """Return what all cylinders of the engine have in common, on a kind of number."""
        load: Load = self.engine.steam
        strokes = load.strokes(kind, self.engine.double)
        mean, weights = turning.mean_force(strokes, kind.pi), self.engine.weights(kind)
        ratio = kind.of(self.engine.crank.ratio)
        return Cylinder(ratio, MOTIONS[self.method], strokes, mean, weights, kind, circle)

    @abstractmethod
    def peaks(self, greatest: bool, stroke: int | None = None) -> Sequence[Peak]:
        """Return where in the turn, or in a stroke of the one crank, the speed is least or greatest.

        Several where they cannot be told apart, as with an infinite rod.
        """

    def extreme(self, greatest: bool, stroke: int | None = None) -> Peak:
        """Return the first of the peaks with what all of their energies may be.

        The place is in half turns from the beginning of the turn or of the stroke.
        """
        peaks = self.peaks(greatest, stroke)
        energy = reduce(larger if greatest else smaller, (one.energy for one in peaks))
        return peaks[0]._replace(place=peaks[0].place - (stroke or 0), energy=energy)

    @property
    def pi(self) -> Number:
        return self.cylinder.kind.pi

    def of(self, value: Fraction) -> Number:
        return self.cylinder.kind.of(value)

    def force_unit(self) -> Number:
        """The force Q in newtons."""
        load, pressure = self.engine.load, self.engine.pressure
        assert load is not None
        assert pressure is not None
        return self.of(pressure * load.bore**2 / 4) * self.pi

    def torque_unit(self) -> Number:
        """The moment Q R about the shaft in newton metres."""
        assert self.engine.crank.radius is not None
        return self.force_unit() * self.of(self.engine.crank.radius)

    def mean_force(self) -> Number:
        """P/Q, the mean tangential force of all cranks together."""
        return self.cylinder.mean * len(self.engine.cranks)

    def tangential_force(self, half_turns: Fraction) -> Number:
        """The tangential force T/Q of all cranks."""
        return sum(self.cylinder.effort(*one) for one in self.engine.positions(half_turns))

    def crank_force(self, force: CrankForce, half_turns: Fraction) -> Number:
        """A force of the first crank in Q."""
        return self.cylinder.force(force, *self.first(half_turns))

    def first(self, half_turns: Fraction) -> tuple[int, Fraction]:
        """Return the stroke of the first crank and the half turns since that began."""
        return next(self.engine.positions(half_turns))

    def energy_at(self, half_turns: Fraction) -> Number:
        """The excess work W/(Q R) since the first crank's inner dead centre."""
        energy, positions = self.cylinder.energy, self.engine.positions
        since = sum(energy(*one) for one in positions(half_turns))
        return since - sum(energy(*one) for one in positions(Fraction(0)))

    def irregularity(self) -> Number:
        """Return δ in units of P R/(m₁ v₁²)."""
        return (self.extreme(greatest=True).energy - self.extreme(greatest=False).energy) / self.mean_force()
