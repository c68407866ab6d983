"""A crank drive under its load, on any kind of number: the motion of the one, the force of the other.

Of the drive a turn asks where the piston is on a stroke and how fast; of the load, which force acts on it
there. Forces are in units of Q, energies in Q R; angles are half turns. A cylinder whose cycle takes two
turns has four strokes.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import lru_cache, reduce
from itertools import product
from typing import TYPE_CHECKING, Any, NamedTuple

from kurbel.drive.at import known
from kurbel.exact.certify import FLOAT_BITS, at_bits
from kurbel.kernel import forces
from kurbel.kernel.steam import larger, smaller
from kurbel.motion.evaluation import OUT, RETURN

if TYPE_CHECKING:
    from kurbel.drive.at import CrankForce, Weights
    from kurbel.drive.moved import Moved
    from kurbel.drive.wheel import Flywheel
    from kurbel.engine.engine import Assembly, Engine
    from kurbel.exact.kind import Kind
    from kurbel.kernel.circle import Circle, Numeric
    from kurbel.kernel.law import Stroke

# The spans of a turn that have extremes of their own.
OUTSTROKE, RETURN_STROKE, WHOLE = 0, 1, None
KEPT_POSITIONS = 16
SIGNS = (OUT, RETURN)
# Half turns beyond a dead centre of which a float is known.
JUST_BEYOND = Fraction(1, 10**13)


class TurnPlace(NamedTuple):
    """What a quantity is asked for: a span of the turn, a crank angle in half turns, a flywheel."""

    stroke: int | None = WHOLE
    # A number, or an array or enclosures of them.
    half_turns: Any = Fraction(0)
    flywheel: Flywheel | None = None


class Member(NamedTuple):
    """A cylinder of an engine by its number, its part, and by how many half turns its crank follows the
    first; of the whole engine the part is None."""

    number: int
    part: int | None = None
    start: Fraction = Fraction(0)


class Crank(NamedTuple):
    """A crank: which part of the engine it is of, and the half turns by which it follows the first."""

    part: int
    start: Fraction


def cranks_of(engine: Engine | Assembly) -> list[Crank]:
    """Return all cranks of an engine, the first one first."""
    return [Crank(part, start) for part, one in enumerate(engine.parts) for start in one.starts]


def members_of(engine: Engine | Assembly) -> tuple[Member, ...]:
    """Return every cylinder of an engine."""
    return tuple(Member(number, *crank) for number, crank in enumerate(cranks_of(engine), 1))


class Peak(NamedTuple):
    """Where the speed is least or greatest, in half turns, its excess energy there, in Q R, and the stroke
    of the one crank."""

    place: Numeric
    energy: Numeric
    stroke: int


class CrankPosition(NamedTuple):
    """Where a crank stands: which part of the engine it is of, the stroke that it is in, counted in its
    cycle, and the half turns φ less those of the strokes before."""

    part: int
    stroke: int
    angle: Any


class Cylinder(NamedTuple):
    """A crank drive under its load, of a cycle of two strokes or four.

    An angle is φ in half turns, less the number of strokes before this one; `circle` makes the circle of
    it. Balls are of one precision. `unit` is Q R of these cylinders in those of the engine, None if they
    are the same. `friction`, which the strokes have in them, is None where there is none.
    """

    drive: Moved
    strokes: Sequence[Stroke]
    mean: Numeric
    weights: Weights | None
    kind: Kind
    circle: Callable[[Any], Circle[Any]]
    unit: Numeric | None = None
    friction: Numeric | None = None

    def share(self, stroke: int, circle: Circle[Numeric]) -> Numeric:
        """Return the share of the stroke that the piston has gone."""
        return self.drive.path(stroke % 2, circle) / self.drive.length

    def effort(self, stroke: int, angle: Any) -> Any:
        """Return the tangential force of load and masses."""
        circle, way = self.circle(angle), stroke % 2
        force = self.strokes[stroke].force(self.share(stroke, circle)) * self.drive.lever(way, circle)
        if self.weights is not None:
            own = self.drive.loaded(way, circle, self.weights.masses, 0, 0, self.weights.weight, None)
            force = force + own.torque()
        return self._whole(force)

    def power(self, stroke: int, angle: Numeric) -> Numeric:
        """Return the work of load and masses over the angle in radians, of which `energy` is the sum; to
        first order it is not quite the effort."""
        circle, way = self.circle(angle), stroke % 2
        power = self.strokes[stroke].force(self.share(stroke, circle)) * self.drive.velocity(way, circle)
        if self.weights is not None:
            power = power + self.drive.power(way, circle, self.weights.masses, self.weights.weight)
        return self._whole(power)

    def force(self, force: CrankForce, stroke: int, angle: Numeric) -> Numeric:
        """Return a force of the drive, in its own Q."""
        circle, way = self.circle(angle), stroke % 2
        net, friction = self.strokes[stroke].force(self.share(stroke, circle)), None
        if self.friction is not None:
            net, friction = net + self.friction, -self.friction
        found = self.drive.force(force, way, circle, self.weights, net, friction)
        return found * (SIGNS[way] if force.framed else 1)

    def slope(self, stroke: int, angle: Numeric) -> Numeric:
        """Return the change of the power with the half turns."""
        circle, way, acting = self.circle(angle), stroke % 2, self.strokes[stroke]
        share, velocity = self.share(stroke, circle), self.drive.velocity(way, circle)
        total = acting.slope(share) * velocity * velocity / self.drive.length
        total += acting.force(share) * self.drive.acceleration(way, circle)
        if self.weights is not None:
            total += self.drive.torque_slope(way, circle, self.weights.masses)
            if self.weights.weight is not None:
                total += self.drive.weight_slope(way, circle, self.weights.weight)
        return self._whole(total * self.kind.pi)

    def energy(self, stroke: int, angle: Numeric) -> Numeric:
        """Return the work of the excess over the mean since the cycle began, but for a constant."""
        circle, length = self.circle(angle), self.drive.length
        work = length * self.strokes[stroke].work(self.share(stroke, circle))
        if self.weights is not None:
            work -= self.drive.kinetic_energy(stroke % 2, circle, self.weights.masses)
            if self.weights.weight is not None:
                work += self.drive.work_of_weight(stroke % 2, circle, self.weights.weight)
        before = length * sum(one.work(1) for one in self.strokes[:stroke]) if stroke else 0
        turned = angle + stroke
        if isinstance(turned, Fraction):
            turned = self.kind.of(turned)
        return self._whole(before + work - self.mean * turned * self.kind.pi)

    def kinetic_energy(self, stroke: int, angle: Numeric) -> Numeric:
        """Return the energy of the masses, as far as it changes."""
        if self.weights is None:
            return self.kind.of(Fraction(0))
        return self._whole(self.drive.kinetic_energy(stroke % 2, self.circle(angle), self.weights.masses))

    @property
    def still(self) -> Cylinder:
        """The same without the inertia of its masses."""
        return self if self.weights is None else self._replace(weights=self.weights.still)

    @property
    def whole_mean(self) -> Numeric:
        """The mean tangential force in the engine's unit."""
        return self._whole(self.mean)

    def _whole(self, value: Numeric) -> Numeric:
        return value if self.unit is None else value * self.unit


class AnyTurn(ABC):
    """A cycle of an engine, one turn or two, by a method: in balls or, of an indicator card, in floats with
    an error.

    Angles are half turns of the first crank's φ; energies count from its inner dead centre.
    """

    def __init__(self, engine: Engine | Assembly, method: str) -> None:
        self.engine = engine
        self.method = method
        self._at_speeds: dict[Fraction, AnyTurn] = {}
        # The columns of a row are of one angle.
        self.positions = lru_cache(maxsize=KEPT_POSITIONS)(self._positions)

    @property
    def part(self) -> Engine:
        """The first part of the engine, or the engine."""
        return self.engine.parts[0]

    @property
    @abstractmethod
    def cylinders(self) -> Sequence[Cylinder]:
        """The formulas of each part of the engine, of balls at the precision in force."""

    @property
    def cylinder(self) -> Cylinder:
        """Those of its first part."""
        return self.cylinders[0]

    def cylinders_on(self, kind: Kind, circle: Callable[[Any], Circle[Any]]) -> tuple[Cylinder, ...]:
        """Return what the cylinders of each part have in common, on a kind of number."""
        return tuple(self._cylinder_on(part, kind, circle) for part in self.engine.parts)

    def _cylinder_on(self, part: Engine, kind: Kind, circle: Callable[[Any], Circle[Any]]) -> Cylinder:
        strokes, drive = part.strokes(kind), part.drive.moved(kind, self.method)
        mean, weights = forces.mean_force(strokes, kind.pi, drive.length), part.weights(kind)
        unit = None if part is self.part else self._unit(part, kind)
        return Cylinder(drive, strokes, mean, weights, kind, circle, unit, part.friction(kind))

    def _unit(self, part: Engine, kind: Kind) -> Numeric:
        own, first = (
            known(one.pressure) * known(one.load).bore ** 2 * known(one.crank.radius)
            for one in (part, self.part)
        )
        return kind.of(own / first)

    @property
    def cycle(self) -> int:
        """The half turns after which everything comes again."""
        return max(len(one.strokes) for one in self.cylinders)

    def standing(self, half_turns: Fraction, part: int, start: Fraction) -> CrankPosition:
        """Return where a crank of a part stands that follows the engine's by so many half turns."""
        one = self.cylinders[part]
        since = (half_turns - start) % len(one.strokes)
        stroke = int(since)
        if not one.drive.regular:
            stroke, since = self._irregular(since, part, len(one.strokes))
        return CrankPosition(part, stroke, since - stroke)

    def _irregular(self, since: Fraction, part: int, cycle: int) -> tuple[int, Fraction]:
        """Return the stroke of a crank and its half turns, from the dead centre on where its cycle begins."""
        if not self.has_reached(since, part, 0):
            since += cycle
        elif self.has_reached(since, part, cycle):
            since -= cycle
        return sum(self.has_reached(since, part, stroke) for stroke in range(1, cycle)), since

    @abstractmethod
    def has_reached(self, since: Fraction, part: int, stroke: int) -> bool:
        """Whether a stroke of a part has begun at so many half turns of its φ; at its dead centre it has."""

    def _positions(self, half_turns: Fraction) -> tuple[CrankPosition, ...]:
        """Return where each crank stands, the first one first."""
        return tuple(self.standing(half_turns, *crank) for crank in cranks_of(self.engine))

    @abstractmethod
    def peaks(self, greatest: bool, stroke: int | None = None) -> Sequence[Peak]:
        """Return where in the cycle, or in a stroke of the one crank, the speed is least or greatest.

        Several where they cannot be told apart, as with an infinite rod.
        """

    def extreme(self, greatest: bool, stroke: int | None = None) -> Peak:
        """Return the first of the peaks with what all of their energies may be.

        The place is in half turns from the beginning of the cycle or of the stroke.
        """
        peaks = self.peaks(greatest, stroke)
        energy = reduce(larger if greatest else smaller, (one.energy for one in peaks))
        begun = (stroke or 0) + self.cylinder.drive.dead_centre((stroke or 0) % 2)
        return peaks[0]._replace(place=peaks[0].place - begun, energy=energy)

    def dead_centres(self) -> Iterator[Fraction]:
        """Yield the half turns of all dead centres over a cycle, in any order; those that are
        irrational, just beyond."""
        for (part, start), stroke in product(cranks_of(self.engine), range(self.cycle)):
            drive = self.cylinders[part].drive
            begun = drive.dead_centre(stroke % 2)
            yield start + stroke + (Fraction(0) if drive.regular else Fraction(float(begun)) + JUST_BEYOND)

    @property
    def pi(self) -> Numeric:
        return self.cylinder.kind.pi

    def of(self, value: Fraction) -> Numeric:
        return self.cylinder.kind.of(value)

    def force_unit(self) -> Numeric:
        """The force Q in newtons."""
        first = self.part
        return self.of(known(first.pressure) * known(first.load).bore ** 2 / 4) * self.pi

    def torque_unit(self) -> Numeric:
        """The moment Q R about the shaft in newton metres."""
        return self.force_unit() * self.of(known(self.engine.crank.radius))

    def back(self) -> Numeric:
        """The back pressure R_b/Q."""
        kind = self.cylinder.kind
        return self.part.ideal.numbers(kind.of, kind.exponent).back

    def mean_force(self) -> Numeric:
        """P/Q, the mean tangential force of all cranks together; negative where the shaft drives them."""
        parts = zip(self.engine.parts, self.cylinders, strict=True)
        return sum(one.whole_mean * len(part.starts) for part, one in parts)

    @property
    def mean_sign(self) -> int:
        """1 where the pistons drive the shaft, -1 where it drives them, 0 where that is not known."""
        with at_bits(FLOAT_BITS):
            mean = self.mean_force()
            return int(bool(mean > 0)) - int(bool(mean < 0))

    def indicated_force(self) -> Numeric:
        """The same without what friction takes."""
        lost: Numeric = 0
        for part, one in zip(self.engine.parts, self.cylinders, strict=True):
            if one.friction is not None:
                own = one.friction * one.drive.length / one.kind.pi * len(part.starts)
                lost = lost + (own if one.unit is None else own * one.unit)
        return self.mean_force() + lost

    def tangential_force(self, half_turns: Fraction) -> Numeric:
        """The tangential force T/Q of all cranks."""
        cylinders = self.cylinders
        total: Numeric = sum(cylinders[part].effort(*one) for part, *one in self.positions(half_turns))
        return total

    def power(self, half_turns: Fraction) -> Numeric:
        """The work of all cranks over the angle in radians, in Q R."""
        cylinders = self.cylinders
        return sum(cylinders[part].power(*one) for part, *one in self.positions(half_turns))

    def crank_force(self, force: CrankForce, half_turns: Fraction) -> Numeric:
        """A force of the first crank in Q."""
        _, *first = self.first(half_turns)
        return self.cylinder.force(force, *first)

    def first(self, half_turns: Fraction) -> CrankPosition:
        """Return where the first crank stands."""
        return self.positions(half_turns)[0]

    @abstractmethod
    def begun(self) -> Sequence[CrankPosition]:
        """Return where the cranks stand as the first is in its inner dead centre."""

    def energy_at(self, half_turns: Fraction) -> Numeric:
        """The excess work W/(Q R) since the first crank's inner dead centre."""
        cylinders = self.cylinders
        since = sum(cylinders[part].energy(*one) for part, *one in self.positions(half_turns))
        return since - self.energy_begun()

    def energy_begun(self) -> Numeric:
        """The energies of all cranks in the first one's inner dead centre, from where they count."""
        cylinders = self.cylinders
        return sum(cylinders[part].energy(*one) for part, *one in self.begun())

    def kinetic_energy_begun(self) -> Numeric:
        """The energy of the moving masses, as far as it changes, in the first crank's inner dead centre, in
        Q R."""
        cylinders = self.cylinders
        return sum(cylinders[part].kinetic_energy(*one) for part, *one in self.begun())

    def at_speed(self, factor: Fraction) -> AnyTurn:
        """Return the turn of the engine at another speed, so many times its own."""
        if factor not in self._at_speeds:
            self._at_speeds[factor] = type(self)(self.engine.at_speed(factor), self.method)
        return self._at_speeds[factor]

    def irregularity(self) -> Numeric:
        """Return δ in units of |P| R/(m₁ v₁²)."""
        swing = self.extreme(greatest=True).energy - self.extreme(greatest=False).energy
        return swing / abs(self.mean_force())
