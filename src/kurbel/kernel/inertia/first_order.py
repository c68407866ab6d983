"""The energy of the masses of the straight crank to first order in λ, and its slopes.

The piston has the velocity c = sin φ + ½ λ sin 2φ and the rod turns by λ cos φ; kernel/moving.py has the
energy of the two. Units and arguments are those of `Loaded`, whose torque is not quite the slope of this
energy: its forces pass at the exact angle of the rod. Re-derived.
"""

from kurbel.kernel import kinematics, moving
from kurbel.kernel.circle import Circle, Number
from kurbel.kernel.effort import Weight, pin_torque
from kurbel.kernel.rod import Masses


def kinetic_energy(circle: Circle[Number], ratio: Number, masses: Masses[Number]) -> Number:
    """Return the part of the masses' energy that changes, in units of m R² ω²."""
    velocity = kinematics.piston_velocity_first_order(circle, ratio)
    return moving.kinetic_energy(velocity, circle.cosine, masses.crosshead, masses.couple)


def power(
    circle: Circle[Number], ratio: Number, masses: Masses[Number], weight: Weight[Number] | None
) -> Number:
    """Return what inertia and weight of the masses do over the angle in radians, less what they take."""
    velocity = kinematics.piston_velocity_first_order(circle, ratio)
    push = 0 - masses.crosshead * kinematics.piston_acceleration_first_order(circle, ratio)
    turning = masses.couple * (circle.sine * circle.cosine)
    if weight is None:
        return push * velocity + turning
    return (push + weight.crosshead * weight.along) * velocity + turning + pin_torque(weight, circle)


def torque_slope(circle: Circle[Number], ratio: Number, masses: Masses[Number]) -> Number:
    """Return the change of the power of the masses' inertia with the angle in radians."""
    sine, cosine = circle.sine, circle.cosine
    velocity = kinematics.piston_velocity_first_order(circle, ratio)
    acceleration = kinematics.piston_acceleration_first_order(circle, ratio)
    jerk = 0 - sine * (1 + 4 * ratio * cosine)
    driven = acceleration * acceleration + velocity * jerk
    return 0 - (masses.crosshead * driven + masses.couple * ((sine - cosine) * (sine + cosine)))
