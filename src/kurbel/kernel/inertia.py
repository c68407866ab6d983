"""Kinetic energy of the masses that go to and fro with the piston and the rod, and the slope of its torque.

Straight crank. Masses are those of kernel/rod.py; energies and torques are in units of m R² ω². A negative
ratio is the return stroke. The torque itself is `Loaded.torque`.
"""

from __future__ import annotations

from kurbel.kernel import kinematics
from kurbel.kernel.circle import Circle, Number
from kurbel.kernel.rod import Masses


def kinetic_energy(circle: Circle[Number], ratio: Number, masses: Masses[Number]) -> Number:
    """Return ½ m_B c² + ½ m q (cos φ/cos ψ)², the part of the energy that changes; q is the couple.

    The mass at the crank pin turns evenly. Re-derived.
    """
    velocity = kinematics.piston_velocity(circle, ratio)
    turning = circle.cosine / kinematics.rod_cosine(circle, ratio)
    return (masses.crosshead * velocity * velocity + masses.couple * turning * turning) / 2


def torque_slope(circle: Circle[Number], ratio: Number, masses: Masses[Number]) -> Number:
    """Return the change of `Loaded.torque` with the crank angle in radians. Re-derived."""
    sine, cosine = circle.sine, circle.cosine
    w = kinematics.rod_cosine(circle, ratio)
    velocity, acceleration = (
        kinematics.piston_velocity(circle, ratio),
        kinematics.piston_acceleration(circle, ratio),
    )
    # tan ψ and its slopes.
    slant, steeper = ratio * sine / w, ratio * cosine / (w * w * w)
    bend = ratio * sine * (3 * (ratio * cosine / w) ** 2 - 1) / (w * w * w)
    jerk = cosine * (bend - slant) - sine * (1 + 2 * steeper)
    # cos φ/cos ψ and its slopes.
    turning = cosine / w
    slower = -sine * (1 - ratio) * (1 + ratio) / (w * w * w)
    curved = -cosine * (1 - ratio) * (1 + ratio) / (w * w * w) * (1 + 3 * (ratio * sine / w) ** 2)
    moving = acceleration * acceleration + velocity * jerk
    return -(masses.crosshead * moving + masses.couple * (slower * slower + turning * curved))
