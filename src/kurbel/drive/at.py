"""A place of any crank drive, on any kind of number, and what acts on the piston there.

Friction has the direction of the stroke that the piston is in; at a dead centre, of that which begins there.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from kurbel.drive.crank import Crank, known
from kurbel.drive.crank_forces import NOTHING, Weights
from kurbel.drive.moved import framed
from kurbel.drive.spin import gain
from kurbel.exact.kind import Kind, balls
from kurbel.kernel import forces, kinematics
from kurbel.kernel.circle import Circle
from kurbel.kernel.forces import net_torque as pin_torque
from kurbel.kernel.moving import Accelerations, Masses
from kurbel.kernel.rod import Loaded

FIRST_BITS = 64
RETURN = -1


@dataclass(eq=False)
class At:
    """A place of a drive, which a kernel call takes: the circle of its crank angle, the kind of number, the
    stroke, OUT (1) or RETURN (-1).

    Of the straight or offset crank λ and e/R (None without an offset) with the sign of the stroke; whether
    what is accelerated is so to first order; whether the piston moves in the direction of the stroke, if that
    is known for certain. Of other drives where the driven end stands, and the dead centre of one on an arc.
    """

    circle: Any
    drive: Any
    numbers: Kind
    stroke: int = 1
    ratio: Any = None
    offset: Any = None
    first_order: bool = False
    way: int | None = None
    degrees: Any = None
    place: Any = None
    arc: Any = None

    @property
    def crank(self) -> Crank:
        found: Crank = self.drive.crank
        return found

    @cached_property
    def gain(self) -> Any:
        """α/ω² of a crank that is itself accelerated, else None."""
        return gain(self.crank, self.numbers) if self.crank.acceleration else None

    @cached_property
    def by(self) -> Accelerations[Any]:
        """How the masses are accelerated."""
        return Accelerations(self.gain, self.first_order)

    @cached_property
    def loaded(self) -> Any:
        """The drive with its masses under the force at this place, in newtons."""
        return self._under_force(self._weights.masses, self._weights.reciprocating)

    @cached_property
    def on_shaft(self) -> Any:
        """The same with the masses of which the force at the pin is that of the main bearing."""
        return self._under_force(self._weights.on_shaft, 0)

    @cached_property
    def _weights(self) -> Weights:
        moving = self.crank.moving
        if moving is None:
            return NOTHING
        return moving.weights(self.numbers, self.crank.pin_acceleration(self.numbers))

    def _under_force(self, masses: Masses[Any], reciprocating: Any) -> Any:
        crank = self.crank
        net = self.acting(self.numbers.of(crank.force.first if crank.force else Fraction(0)))
        if self.arc is not None:
            return self.drive.under(self.circle, self.place, self.arc, masses, net, reciprocating)
        drive, friction = (self.circle, self.ratio, masses, self.offset), None
        if crank.effort is not None:
            net, friction = net + self.pressed(), self.rubbing()
        own = framed(self._weights.weight, self.stroke == RETURN)
        return Loaded(*drive, net, reciprocating, self.by, weight=own, friction=friction)

    @property
    def share(self) -> Any:
        """The share of the stroke that the piston has gone."""
        if self.offset is None:
            return kinematics.piston_path(self.circle, self.ratio) / 2
        path = kinematics.offset_path(self.circle, self.ratio, self.offset)
        return path / kinematics.stroke(self.ratio, self.offset)

    def acting(self, force: Any) -> Any:
        """Return what the first piston force calls up, as the force at this place does."""
        factor = self.crank.force.relative(self) if self.crank.force else None
        return force if factor is None else force * factor

    def pressed(self) -> Any:
        """Return the force of the pressures in newtons, in the direction of the stroke, 0 without them."""
        effort = self.crank.effort
        # On the return stroke the cover lies the other way.
        return self.stroke * effort.pressures.force(self.numbers) if effort and effort.pressures else 0

    def rubbing(self) -> Any:
        """Return the friction in newtons, in the direction of the stroke, None where there is none."""
        effort = self.crank.effort
        if effort is None or not effort.friction:
            return None
        return self.numbers.of(effort.friction) * (self._way() if self.way is None else self.way) * -1

    def _way(self) -> Any:
        """Return 1 where the piston moves in the direction of the stroke, -1 where against it, of any kind of
        number: a float in a dead centre goes where it is drawn to, a ball about one holds both."""
        velocity = forces.tangential_force(self.circle, self.ratio, self.offset)
        if hasattr(velocity, "union"):
            if hasattr(velocity, "rad") and not velocity.contains(0):
                return 1 if velocity > 0 else -1
            return (0 * velocity - 1).union(0 * velocity + 1)
        import numpy as np

        drawn = self.by.piston(self.circle, self.ratio, self.offset)
        towards: Any = np.where(velocity == 0, drawn, velocity)
        return np.where(towards < 0, -1.0, 1.0)

    def net_torque(self) -> Any:
        """Return the torque on the shaft less what the friction of the pins takes, over R, in newtons."""
        crank = self.crank
        pins, radius = known(known(crank.effort).pins), known(crank.radius)
        circle, ratio, offset, thrust = self.circle, self.ratio, self.offset, self.loaded.thrust()
        if self.stroke == RETURN:
            # The circles of friction are those of the whole turn.
            circle = Circle(-1 * circle.sine, -1 * circle.cosine, 2 - circle.versine)
            ratio, thrust, offset = -1 * ratio, -1 * thrust, None if offset is None else -1 * offset
        return pin_torque(circle, ratio, offset, thrust, pins.circles(self.numbers, radius))


def way_at(crank: Crank, stroke: int, angle: Fraction) -> int:
    """Return whether the piston moves in the direction of a stroke, 1, or against it, -1, at an angle that
    counts from where the stroke begins."""
    if not crank.offset:
        return 1 if angle % 360 < 180 else -1
    from kurbel.exact.certify import at_bits
    from kurbel.exact.terms import vanishes

    def velocity(kind: Kind) -> Any:
        return kinematics.offset_velocity(kind.circle(angle), *_numbers(crank, stroke, kind))

    def acceleration(kind: Kind) -> Any:
        return kinematics.offset_acceleration(kind.circle(angle), *_numbers(crank, stroke, kind))

    rests = vanishes(velocity)
    bits = FIRST_BITS
    while True:
        with at_bits(bits):
            found = (acceleration if rests else velocity)(balls())
        if not found.contains(0):
            return 1 if found > 0 else -1
        bits *= 2


def _numbers(crank: Crank, stroke: int, kind: Kind) -> tuple[Any, Any]:
    return kind.of(stroke * crank.ratio), kind.of(stroke * crank.offset)
