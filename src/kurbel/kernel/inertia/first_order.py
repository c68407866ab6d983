"""The masses of the straight crank to first order in λ, so that their torque is the slope of their energy.

The piston has the velocity c = sin φ + ½ λ sin 2φ and the rod turns by λ cos φ; kernel/moving.py has the
energy of the two. The torque is that of `Loaded` by `WITH_ARM`; units and arguments are those of `Loaded`.
Re-derived.
"""

from kurbel.kernel import kinematics, moving
from kurbel.kernel.circle import Circle, Number
from kurbel.kernel.rod import Masses


def kinetic_energy(circle: Circle[Number], ratio: Number, masses: Masses[Number]) -> Number:
    """Return the part of the masses' energy that changes, in units of m R² ω²."""
    velocity = kinematics.piston_velocity_first_order(circle, ratio)
    return moving.kinetic_energy(velocity, circle.cosine, masses.crosshead, masses.couple)


def torque_slope(circle: Circle[Number], ratio: Number, masses: Masses[Number]) -> Number:
    """Return the change of the masses' torque with the angle in radians."""
    sine, cosine = circle.sine, circle.cosine
    velocity = kinematics.piston_velocity_first_order(circle, ratio)
    acceleration = kinematics.piston_acceleration_first_order(circle, ratio)
    jerk = 0 - sine * (1 + 4 * ratio * cosine)
    driven = acceleration * acceleration + velocity * jerk
    return 0 - (masses.crosshead * driven + masses.couple * ((sine - cosine) * (sine + cosine)))
