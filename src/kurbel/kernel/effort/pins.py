"""The torque that the friction of the pins leaves, by the circles of friction.

A pin of radius r with the coefficient of friction μ = tan ρ carries its force not through its centre but
along a tangent of the circle of friction, with the radius r sin ρ, so that the force opposes the turning of
one part in the other. The line of thrust of a rod without mass touches the circles at both of its pins and
leans from the line of their centres by ε, sin ε = -(k_A + k_B)/L for a thrust: at the crank pin rod and crank
always turn against each other, at the crosshead pin the rod turns back where cos φ < 0. The shaft bears what
the crank pin does, and its circle takes another part. The crank turns in the sense from X to Y of
kernel/forces.py, over the whole turn in the frame of the outstroke. Lengths are in R, torques in units of
force times R. Numbers are floats, arrays, balls or separation bounds. Source: the textbooks of the theory of
machines; re-derived.
"""

from typing import Any, Generic, NamedTuple

from kurbel.kernel.circle import Circle, Kind, Number, cosine_of
from kurbel.kernel.forces import rod_slant


class Circles(NamedTuple, Generic[Kind]):
    """The radii of the circles of friction at crosshead pin, crank pin and shaft."""

    crosshead: Kind
    crank: Kind
    shaft: Kind


def net_torque(
    circle: Circle[Number], ratio: Number, offset: Number | None, thrust: Number, circles: Circles[Number]
) -> Number:
    """Return the torque on the shaft that a force on the rod's crosshead end along the slide makes, positive
    against X, less what the friction of the pins takes.

    Where the rod turns its swing round, that of the swing which begins there counts.
    """
    # The circle at the crosshead pin is touched on the other side as the rod swings back.
    swing = _chosen(circle.cosine, circles.crosshead, -circles.crosshead, circle.sine)
    lean = ratio * (circles.crank + swing)
    lost = circles.crank + circles.shaft
    pushed = _by_thrust(circle, ratio, offset, -lean, -lost)
    pulled = _by_thrust(circle, ratio, offset, lean, lost)
    return _chosen(thrust, thrust * pushed, thrust * pulled, 0 * thrust)


def _by_thrust(
    circle: Circle[Number], ratio: Number, offset: Number | None, lean: Number, lost: Number
) -> Number:
    """Return (sin(φ + ψ + ε) + lost)/cos(ψ + ε), the torque of a unit thrust, from sin ε."""
    slant, upright = rod_slant(circle, ratio, offset), cosine_of(lean)
    sine = slant.sine * upright + slant.cosine * lean
    cosine = slant.cosine * upright - slant.sine * lean
    return circle.sine + (circle.cosine * sine + lost) / cosine


def _chosen(sign: Any, above: Any, below: Any, falling: Any) -> Any:
    """Return what belongs to a sign: at 0 to that which follows where `falling` is the slope downwards. A
    ball that holds 0 has both, and so has a separation bound."""
    if hasattr(sign, "shape"):
        import numpy as np

        return np.where((sign > 0) | ((sign == 0) & (falling <= 0)), above, below)
    if hasattr(sign, "union") and not hasattr(sign, "rad"):
        return above.union(below)
    if sign > 0:
        return above
    if sign < 0:
        return below
    if sign == 0 and (falling > 0 or falling <= 0):
        return below if falling > 0 else above
    return above.union(below)
