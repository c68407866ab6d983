"""A piston in its crank drive, over the strokes, on any kind of number: what an engine asks of a drive.

A stroke is 0, the outstroke, or 1, the return; everything on it counts from the dead centre where it begins
and in its direction. The circle is that of the crank angle φ, on the return of φ less 180°.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING, Any, Protocol

from kurbel.errors import ProblemError
from kurbel.kernel import kinematics, rod, turning
from kurbel.kernel.circle import Circle, Number, root
from kurbel.kernel.effort.weight import Weight, on_return, torque_slope, work
from kurbel.kernel.rod import Loaded, Masses

if TYPE_CHECKING:
    from kurbel.drive.crank import Crank
    from kurbel.drive.crank_forces import CrankForce, Weights
    from kurbel.exact.kind import Kind

MOTIONS = {"exact": turning.EXACT, "series": turning.FIRST_ORDER, "weisbach": turning.FIRST_ORDER}


class Drive(Protocol):
    """A crank drive that can be loaded: what is known of its crank, and how its piston moves."""

    @property
    def crank(self) -> Crank: ...

    def of(self, crank: Crank) -> Drive: ...

    def moved(self, kind: Kind, method: str) -> Moved: ...


class Moved(ABC):
    """A drive on one kind of number: lengths in R, slopes over the crank angle in radians.

    `regular` where the dead centres lie at 0° and 180°. `length` is that of the stroke.
    """

    regular = False
    length: Number

    def dead_centre(self, stroke: int) -> Number:
        """Return where the stroke begins, in half turns of φ, on the return of φ less 180°."""
        return 0

    @abstractmethod
    def path(self, stroke: int, circle: Circle[Any]) -> Number:
        """Return the way of the piston."""

    @abstractmethod
    def velocity(self, stroke: int, circle: Circle[Any]) -> Number:
        """Return the slope of the path."""

    @abstractmethod
    def acceleration(self, stroke: int, circle: Circle[Any]) -> Number:
        """Return the slope of the velocity."""

    def lever(self, stroke: int, circle: Circle[Any]) -> Number:
        """Return the tangential force of a unit force on the piston, by virtual work the velocity."""
        return self.velocity(stroke, circle)

    @abstractmethod
    def loaded(
        self,
        stroke: int,
        circle: Circle[Any],
        masses: Masses[Any],
        net: Number,
        reciprocating: Number = 0,
        weight: Weight[Any] | None = None,
        friction: Number | None = None,
    ) -> Any:
        """Return the drive with its masses under a force on the piston, or what knows the same forces."""

    def power(
        self, stroke: int, circle: Circle[Any], masses: Masses[Any], weight: Weight[Any] | None
    ) -> Number:
        """Return what inertia and weight of the masses do over the angle in radians, less what they take:
        the torque that they make."""
        found: Number = self.loaded(stroke, circle, masses, 0, weight=weight).torque()
        return found

    @abstractmethod
    def kinetic_energy(self, stroke: int, circle: Circle[Any], masses: Masses[Any]) -> Number:
        """Return the part of the masses' energy that changes, in units of m R² ω²."""

    @abstractmethod
    def torque_slope(self, stroke: int, circle: Circle[Any], masses: Masses[Any]) -> Number:
        """Return the change of the power of the masses' inertia with the angle in radians."""

    def weight_slope(self, stroke: int, circle: Circle[Any], weight: Weight[Any]) -> Number:
        """Return the change of the torque of weights with the angle in radians."""
        own = on_return(weight) if stroke else weight
        return torque_slope(own, circle, self.acceleration(stroke, circle))

    def work_of_weight(self, stroke: int, circle: Circle[Any], weight: Weight[Any]) -> Number:
        """Return the work that weights have done since a fixed place, over R."""
        own = on_return(weight) if stroke else weight
        return work(own, circle, self.path(stroke, circle), self.length, bool(stroke))

    def bare(self, force: CrankForce, stroke: int, circle: Circle[Any]) -> Number:
        """Return a force that a unit force on the piston calls up in the drive without masses."""
        return force.on(self.loaded(stroke, circle, Masses(0, 0), 1))

    def force(
        self,
        force: CrankForce,
        stroke: int,
        circle: Circle[Any],
        weights: Weights | None,
        net: Number,
        friction: Number | None = None,
    ) -> Number:
        """Return a force of the drive under a force on the piston, with the masses or without, and friction
        that counts as it does."""
        if weights is None and friction is not None:
            rubbed = self.loaded(stroke, circle, Masses(0, 0, 0, 0), net, friction=friction)
            return force.on(rubbed)
        if weights is None:
            found = net * self.bare(force, stroke, circle)
            return abs(found) if force.magnitude else found
        masses = weights.on_shaft if force.on_shaft else weights.masses
        reciprocating = 0 if force.on_shaft else weights.reciprocating
        weight = weights.weight
        return force.on(self.loaded(stroke, circle, masses, net, reciprocating, weight, friction))

    def angle_at(self, stroke: int, share: Number) -> Number | None:
        """Return the half turns at which the piston has gone a share of the stroke, None if no formula has
        them."""
        return None


class Slide(Moved):
    """The straight crank, by exact or first-order formulas."""

    regular = True
    length = 2

    def __init__(self, ratio: Number, motion: turning.Motion, kind: Kind) -> None:
        self.ratios = (ratio, -ratio)
        self.motion, self.kind = motion, kind

    def path(self, stroke: int, circle: Circle[Any]) -> Number:
        return self.motion.path(circle, self.ratios[stroke])

    def velocity(self, stroke: int, circle: Circle[Any]) -> Number:
        return self.motion.velocity(circle, self.ratios[stroke])

    def acceleration(self, stroke: int, circle: Circle[Any]) -> Number:
        return self.motion.acceleration(circle, self.ratios[stroke])

    def loaded(
        self,
        stroke: int,
        circle: Circle[Any],
        masses: Masses[Any],
        net: Number,
        reciprocating: Number = 0,
        weight: Weight[Any] | None = None,
        friction: Number | None = None,
    ) -> Loaded:
        own = framed(weight, stroke)
        return Loaded(
            circle, self.ratios[stroke], masses, None, net, reciprocating, weight=own, friction=friction
        )

    def bare(self, force: CrankForce, stroke: int, circle: Circle[Any]) -> Number:
        return force.bare(circle, self.ratios[stroke], None)

    def kinetic_energy(self, stroke: int, circle: Circle[Any], masses: Masses[Any]) -> Number:
        return rod.kinetic_energy(circle, self.ratios[stroke], masses)

    def torque_slope(self, stroke: int, circle: Circle[Any], masses: Masses[Any]) -> Number:
        return rod.torque_slope(circle, self.ratios[stroke], masses)

    def angle_at(self, stroke: int, share: Number) -> Number | None:
        versine = self.motion.versine_at(2 * share, self.ratios[stroke])
        return self.kind.arc(root(versine / 2)) / 90


class OffsetSlide(Moved):
    """The offset crank."""

    def __init__(self, ratio: Number, offset: Number, kind: Kind) -> None:
        self.numbers = ((ratio, offset), (-ratio, -offset))
        self.length = kinematics.stroke(ratio, offset)
        self.kind = kind

    def dead_centre(self, stroke: int) -> Number:
        return self.kind.arc(kinematics.dead_centre_sine(*self.numbers[stroke])) / 180

    def path(self, stroke: int, circle: Circle[Any]) -> Number:
        return kinematics.offset_path(circle, *self.numbers[stroke])

    def velocity(self, stroke: int, circle: Circle[Any]) -> Number:
        return kinematics.offset_velocity(circle, *self.numbers[stroke])

    def acceleration(self, stroke: int, circle: Circle[Any]) -> Number:
        return kinematics.offset_acceleration(circle, *self.numbers[stroke])

    def loaded(
        self,
        stroke: int,
        circle: Circle[Any],
        masses: Masses[Any],
        net: Number,
        reciprocating: Number = 0,
        weight: Weight[Any] | None = None,
        friction: Number | None = None,
    ) -> Loaded:
        ratio, offset = self.numbers[stroke]
        own = framed(weight, stroke)
        return Loaded(circle, ratio, masses, offset, net, reciprocating, weight=own, friction=friction)

    def bare(self, force: CrankForce, stroke: int, circle: Circle[Any]) -> Number:
        return force.bare(circle, *self.numbers[stroke])

    def kinetic_energy(self, stroke: int, circle: Circle[Any], masses: Masses[Any]) -> Number:
        ratio, offset = self.numbers[stroke]
        return rod.kinetic_energy(circle, ratio, masses, offset)

    def torque_slope(self, stroke: int, circle: Circle[Any], masses: Masses[Any]) -> Number:
        ratio, offset = self.numbers[stroke]
        return rod.torque_slope(circle, ratio, masses, offset)


def framed(weight: Weight[Any] | None, stroke: int) -> Weight[Any] | None:
    """Return weights in the frame of the stroke."""
    return on_return(weight) if stroke and weight is not None else weight


def moved(crank: Crank, kind: Kind, method: str) -> Moved:
    """Return the straight or the offset crank as a turn asks it, by a method."""
    ratio = kind.of(crank.ratio)
    if not crank.offset and method == "exact":
        return Slide(ratio, MOTIONS[method], kind)
    if not crank.offset:
        from kurbel.drive.first_order import FirstOrderSlide

        return FirstOrderSlide(ratio, MOTIONS[method], kind)
    if method != "exact":
        raise ProblemError(f'method "{method}" has no formulas for the offset crank; use exact')
    return OffsetSlide(ratio, kind.of(crank.offset), kind)
