"""A piston in its crank drive, over the strokes, on any kind of number: what an engine asks of a drive.

A stroke is 0, the outstroke, or 1, the return; everything on it counts from the dead centre where it begins
and in its direction. The circle is that of the crank angle φ, on the return of φ less 180°.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Protocol

from kurbel.drive.at import At, CrankForce, Weights, framed
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.kernel import forces, kinematics
from kurbel.kernel.circle import Circle, Numeric, root
from kurbel.kernel.forces import Weight, on_return, tangential_force, torque_slope, work
from kurbel.kernel.moving import EVEN, OF_FIRST_ORDER, Masses
from kurbel.kernel.rod import LoadedCrank

if TYPE_CHECKING:
    from kurbel.drive.crank import Crank

MOTIONS = {"exact": forces.EXACT, "series": forces.FIRST_ORDER, "weisbach": forces.FIRST_ORDER}


class DeadCentres:
    """A drive between its dead centres, at 0° and 180° unless it says otherwise; degrees and units of R."""

    __slots__ = ()

    def dead_angle(self, stroke: int, kind: Kind) -> Numeric:
        """Return φ_i, or for a stroke of -1, the return, φ_o - 180°, within ±180°."""
        return kind.of(Fraction(0))

    def inner(self, kind: Kind) -> Numeric:
        """Return φ_i."""
        return self.dead_angle(1, kind)

    def outer(self, kind: Kind) -> Numeric:
        """Return φ_o."""
        return self.dead_angle(-1, kind) + 180

    def lead(self, kind: Kind) -> Numeric:
        """Return Δ, by which the crank turns more than 180° during the outstroke."""
        return self.dead_angle(-1, kind) - self.dead_angle(1, kind)

    def time_ratio(self, kind: Kind) -> Numeric:
        """Return the time of the outstroke over that of the return, the crank turning uniformly."""
        more = self.lead(kind)
        return (180 + more) / (180 - more)

    def least_transmission(self, kind: Kind) -> Numeric:
        """Return the least angle between the rod and what guides its end, square where there is no rod."""
        return kind.of(Fraction(90))


class Drive(Protocol):
    """A crank drive that can be loaded: what is known of its crank, and how its piston moves."""

    @property
    def crank(self) -> Crank: ...

    def of(self, crank: Crank) -> Drive: ...

    def at(
        self, stroke: int, circle: Circle[Numeric], numbers: Kind, method: str, of: object = None
    ) -> At: ...

    def moved(self, kind: Kind, method: str) -> Moved: ...


class Moved(ABC):
    """A drive on one kind of number: lengths in R, slopes over the crank angle in radians.

    `regular` where the dead centres lie at 0° and 180°. `length` is that of the stroke.
    """

    regular = False
    length: Numeric

    def dead_centre(self, stroke: int) -> Numeric:
        """Return where the stroke begins, in half turns of φ, on the return of φ less 180°."""
        return 0

    @abstractmethod
    def path(self, stroke: int, circle: Circle[Numeric]) -> Numeric:
        """Return the way of the piston."""

    @abstractmethod
    def velocity(self, stroke: int, circle: Circle[Numeric]) -> Numeric:
        """Return the slope of the path."""

    @abstractmethod
    def acceleration(self, stroke: int, circle: Circle[Numeric]) -> Numeric:
        """Return the slope of the velocity."""

    def lever(self, stroke: int, circle: Circle[Numeric]) -> Numeric:
        """Return the tangential force of a unit force on the piston, by virtual work the velocity."""
        return self.velocity(stroke, circle)

    @abstractmethod
    def loaded(
        self,
        stroke: int,
        circle: Circle[Numeric],
        masses: Masses[Numeric],
        net: Numeric,
        reciprocating: Numeric,
        weight: Weight[Numeric] | None,
        friction: Numeric | None,
    ) -> LoadedCrank:
        """Return the drive with its masses under a force on the piston."""

    def power(
        self, stroke: int, circle: Circle[Numeric], masses: Masses[Numeric], weight: Weight[Numeric] | None
    ) -> Numeric:
        """Return what inertia and weight of the masses do over the angle in radians, less what they take:
        the torque that they make."""
        return self.loaded(stroke, circle, masses, 0, 0, weight, None).power()

    def kinetic_energy(self, stroke: int, circle: Circle[Numeric], masses: Masses[Numeric]) -> Numeric:
        """Return the part of the masses' energy that changes, in units of m R² ω²."""
        return self.loaded(stroke, circle, masses, 0, 0, None, None).kinetic_energy()

    def torque_slope(self, stroke: int, circle: Circle[Numeric], masses: Masses[Numeric]) -> Numeric:
        """Return the change of the power of the masses' inertia with the angle in radians."""
        return self.loaded(stroke, circle, masses, 0, 0, None, None).torque_slope()

    def weight_slope(self, stroke: int, circle: Circle[Numeric], weight: Weight[Numeric]) -> Numeric:
        """Return the change of the torque of weights with the angle in radians."""
        own = on_return(weight) if stroke else weight
        return torque_slope(own, circle, self.acceleration(stroke, circle))

    def work_of_weight(self, stroke: int, circle: Circle[Numeric], weight: Weight[Numeric]) -> Numeric:
        """Return the work that weights have done since a fixed place, over R."""
        own = on_return(weight) if stroke else weight
        return work(own, circle, self.path(stroke, circle), self.length, bool(stroke))

    def bare(self, force: CrankForce, stroke: int, circle: Circle[Numeric]) -> Numeric:
        """Return a force that a unit force on the piston calls up in the drive without masses."""
        return force.on(self.loaded(stroke, circle, Masses(0, 0), 1, 0, None, None))

    def force(
        self,
        force: CrankForce,
        stroke: int,
        circle: Circle[Numeric],
        weights: Weights | None,
        net: Numeric,
        friction: Numeric | None = None,
    ) -> Numeric:
        """Return a force of the drive under a force on the piston, with the masses or without, and friction
        that counts as it does."""
        if weights is None and friction is not None:
            with_friction = self.loaded(stroke, circle, Masses(0, 0), net, 0, None, friction)
            return force.on(with_friction)
        if weights is None:
            found = net * self.bare(force, stroke, circle)
            return abs(found) if force.magnitude else found
        masses = weights.on_shaft if force.on_shaft else weights.masses
        reciprocating = 0 if force.on_shaft else weights.reciprocating
        weight = weights.weight
        return force.on(self.loaded(stroke, circle, masses, net, reciprocating, weight, friction))

    def angle_at(self, stroke: int, share: Numeric) -> Numeric | None:
        """Return the half turns at which the piston has gone a share of the stroke, None if no formula has
        them."""
        return None


class Slide(Moved):
    """The straight or offset crank by exact formulas, the straight one also by those of first order.

    The first order is that of the motion: path, velocity and acceleration of the piston, the turning of the
    rod. Works and energies are those of this motion. Forces pass through the drive at the exact angle of the
    rod, as under one force on the piston, so that those of a place compose; the tangential force then differs
    from the slope of the work as the exact velocity does from that of first order.
    """

    def __init__(self, motion: forces.Motion, kind: Kind, ratio: Numeric, *offset: Numeric) -> None:
        self.regular = not offset
        self.numbers: tuple[tuple[Any, ...], ...] = tuple(
            (sign * ratio, *(sign * one for one in offset)) for sign in (1, -1)
        )
        self.length = kinematics.stroke(ratio, *offset) if offset else 2
        self.motion, self.kind = motion, kind

    @property
    def _is_first_order(self) -> bool:
        return self.motion is forces.FIRST_ORDER

    def dead_centre(self, stroke: int) -> Numeric:
        if self.regular:
            return 0
        return self.kind.arc(kinematics.dead_centre_sine(*self.numbers[stroke])) / 180

    def path(self, stroke: int, circle: Circle[Numeric]) -> Numeric:
        return self.motion.path(circle, *self.numbers[stroke])

    def velocity(self, stroke: int, circle: Circle[Numeric]) -> Numeric:
        return self.motion.velocity(circle, *self.numbers[stroke])

    def acceleration(self, stroke: int, circle: Circle[Numeric]) -> Numeric:
        return self.motion.acceleration(circle, *self.numbers[stroke])

    def lever(self, stroke: int, circle: Circle[Numeric]) -> Numeric:
        if self._is_first_order:
            return tangential_force(circle, *self.numbers[stroke])
        return self.velocity(stroke, circle)

    def loaded(
        self,
        stroke: int,
        circle: Circle[Numeric],
        masses: Masses[Numeric],
        net: Numeric,
        reciprocating: Numeric,
        weight: Weight[Numeric] | None,
        friction: Numeric | None,
    ) -> LoadedCrank:
        ratio, offset = (*self.numbers[stroke], None)[:2]
        by = OF_FIRST_ORDER if self._is_first_order else EVEN
        own = framed(weight, stroke)
        return LoadedCrank(
            circle, ratio, masses, offset, net, reciprocating, by, weight=own, friction=friction
        )

    def bare(self, force: CrankForce, stroke: int, circle: Circle[Numeric]) -> Numeric:
        ratio, offset = (*self.numbers[stroke], None)[:2]
        return force.bare(circle, ratio, offset)

    def angle_at(self, stroke: int, share: Numeric) -> Numeric | None:
        if not self.regular:
            return None
        versine = self.motion.versine_at(2 * share, *self.numbers[stroke])
        return self.kind.arc(root(versine / 2)) / 90


def moved(crank: Crank, kind: Kind, method: str) -> Moved:
    """Return the straight or the offset crank as a turn asks it, by a method."""
    if not crank.offset:
        return Slide(MOTIONS[method], kind, kind.of(crank.ratio))
    if method != "exact":
        raise ProblemError(f'method "{method}" has no formulas for the offset crank; use exact')
    return Slide(forces.EXACT, kind, kind.of(crank.ratio), kind.of(crank.offset))
