"""What pushes the piston at a place beside a given force: pressures, and friction against its motion.

Friction has the direction of the stroke that the piston is in; at a dead centre, of that which begins there.
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from kurbel.drive.crank import Crank, known
from kurbel.drive.moved import framed
from kurbel.exact.kind import Kind, balls
from kurbel.kernel import forces, kinematics
from kurbel.kernel.circle import Circle
from kurbel.kernel.effort.pins import net_torque as pin_torque
from kurbel.kernel.rod import Loaded, Masses

if TYPE_CHECKING:
    from kurbel.kernel.effort.weight import Weight
    from kurbel.motion.evaluation import At

FIRST_BITS = 64
RETURN = -1


def under_force(at: At, masses: Masses[Any], reciprocating: Any, weight: Weight[Any] | None) -> Loaded:
    """Return the drive with its masses under all that acts at a place, in newtons."""
    crank = at.crank
    net = at.acting(at.numbers.of(crank.force.first if crank.force else Fraction(0)))
    drive, friction = (at.circle, at.ratio, masses, at.offset), None
    if crank.effort is not None:
        net, friction = net + pressed(at), rubbing(at)
    own = framed(weight, at.stroke == RETURN)
    return Loaded(*drive, net, reciprocating, at.by, weight=own, friction=friction)


def pressed(at: At) -> Any:
    """Return the force of the pressures in newtons, in the direction of the stroke, 0 without them."""
    effort = at.crank.effort
    # On the return stroke the cover lies the other way.
    return at.stroke * effort.pressures.force(at.numbers) if effort and effort.pressures else 0


def rubbing(at: At) -> Any:
    """Return the friction in newtons, in the direction of the stroke, None where there is none."""
    effort = at.crank.effort
    if effort is None or not effort.friction:
        return None
    return at.numbers.of(effort.friction) * (_way(at) if at.way is None else at.way) * -1


def _way(at: At) -> Any:
    """Return 1 where the piston moves in the direction of the stroke, -1 where against it, of any kind of
    number: a float in a dead centre goes where it is drawn to, a ball about one holds both."""
    velocity = forces.tangential_force(at.circle, at.ratio, at.offset)
    if hasattr(velocity, "union"):
        if hasattr(velocity, "rad") and not velocity.contains(0):
            return 1 if velocity > 0 else -1
        return (0 * velocity - 1).union(0 * velocity + 1)
    import numpy as np

    drawn = at.by.piston(at.circle, at.ratio, at.offset)
    towards: Any = np.where(velocity == 0, drawn, velocity)
    return np.where(towards < 0, -1.0, 1.0)


def net_torque(at: At) -> Any:
    """Return the torque on the shaft less what the friction of the pins takes, over R, in newtons."""
    crank = at.crank
    pins, radius = known(known(crank.effort).pins), known(crank.radius)
    circle, ratio, offset, thrust = at.circle, at.ratio, at.offset, at.loaded.thrust()
    if at.stroke == RETURN:
        # The circles of friction are those of the whole turn.
        circle = Circle(-1 * circle.sine, -1 * circle.cosine, 2 - circle.versine)
        ratio, thrust, offset = -1 * ratio, -1 * thrust, None if offset is None else -1 * offset
    return pin_torque(circle, ratio, offset, thrust, pins.circles(at.numbers, radius))


def way_at(crank: Crank, stroke: int, angle: Fraction) -> int:
    """Return whether the piston moves in the direction of a stroke, 1, or against it, -1, at an angle that
    counts from where the stroke begins."""
    if not crank.offset:
        return 1 if angle % 360 < 180 else -1
    import flint

    from kurbel.exact.terms import vanishes

    def velocity(kind: Kind) -> Any:
        return kinematics.offset_velocity(kind.circle(angle), *_numbers(crank, stroke, kind))

    def acceleration(kind: Kind) -> Any:
        return kinematics.offset_acceleration(kind.circle(angle), *_numbers(crank, stroke, kind))

    rests = vanishes(velocity)
    bits = FIRST_BITS
    while True:
        with flint.ctx.workprec(bits):
            found = (acceleration if rests else velocity)(balls())
        if not found.contains(0):
            return 1 if found > 0 else -1
        bits *= 2


def _numbers(crank: Crank, stroke: int, kind: Kind) -> tuple[Any, Any]:
    return kind.of(stroke * crank.ratio), kind.of(stroke * crank.offset)
