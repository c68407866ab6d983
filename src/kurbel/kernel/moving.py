"""Kinetic energy of the moving masses, and the slope of the torque that they make, of any drive with a rod.

The masses of rod and driven end have the energy ½ m_B c² + ½ m q u² and, at the crank pin, one that never
changes; c is the velocity of the driven end and u = cos φ/cos ψ, L ψ̇ over R ω. So their torque on a crank
that turns evenly is -(m_B c c' + m q u u'), and its slope -(m_B (c'² + c c'') + m q (u'² + u u'')), where a
dash is a slope over the crank angle in radians.

Numbers are floats, arrays, balls or separation bounds. Units as in kernel/rod.py. Re-derived.
"""

from typing import Generic, NamedTuple

from kurbel.kernel.circle import Kind, Number


class Link(NamedTuple, Generic[Kind]):
    """A drive at a crank angle: sine and cosine of φ and ψ, both from the way of the driven end; λ and β.

    β = R/B is the curvature of this way, 0 of a straight one. Signs are those of kernel/linkage.py: negative
    numbers are the return stroke.
    """

    sine: Kind
    cosine: Kind
    slant: Kind
    slant_cosine: Kind
    ratio: Kind
    curvature: Kind | int = 0


def kinetic_energy(velocity: Number, turning: Number, driven: Number, couple: Number) -> Number:
    """Return the part of the energy that changes, from c, u, m_B and the rod's couple m q."""
    return (driven * velocity * velocity + couple * turning * turning) / 2


def torque_slope(link: Link[Number], driven: Number, couple: Number) -> Number:
    """Return the change of the masses' torque with the crank angle in radians, from m_B and the couple m q.

    Where the driven end's way is curved, it turns by βc: the crank's angle from it grows by 1 + βc and ψ by
    λu - βc.
    """
    sine, cosine, slant, w, ratio, curvature = link
    tangent = slant / w
    velocity, pull, turning = sine + cosine * tangent, cosine - sine * tangent, cosine / w
    growth, opening = 1 + curvature * velocity, ratio * turning - curvature * velocity
    # cos φ/cos² ψ, what ψ adds to c.
    lift = turning / w
    acceleration = pull * growth + lift * opening
    lean = turning * tangent * opening - sine / w * growth
    bent, hurried = curvature * acceleration, ratio * lean - curvature * acceleration
    square, fall = opening * opening, sine / (w * w) * opening
    jerk = pull * bent - growth * (velocity * growth + 2 * fall) + lift * (hurried + 2 * tangent * square)
    curl = turning * (tangent * (tangent * square + hurried) + square / (w * w) - growth * growth)
    curl -= sine / w * (bent + 2 * growth * tangent * opening)
    moving = acceleration * acceleration + velocity * jerk
    return -(driven * moving + couple * (lean * lean + turning * curl))
