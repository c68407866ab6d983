"""Weight of the masses of the crank drive, and friction of its pins.

The weight of the moving masses of a crank drive, by the slope of its slide.

The frame is that of kernel/forces.py: X runs from the shaft along the slide towards the dead centre that the
stroke leaves, Y towards the side of the crank pin. The slope is the angle by which X rises from the horizon,
counted in the sense in which the crank turns: at 90° the cylinder stands above the shaft, at 0° it lies, and
the crank pin passes above the shaft on the outstroke; at 180° it passes below. A weight G then acts as
-G sin α along X and -G cos α along Y. On the return stroke, whose frame points the other way, both change
their sign. Numbers are floats, arrays, balls or separation bounds. Re-derived.

The torque that the friction of the pins leaves, by the circles of friction.

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

from __future__ import annotations

from typing import Any, Generic, NamedTuple

from kurbel.kernel.circle import Circle, Kind, Number, cosine_of
from kurbel.kernel.forces import rod_slant


class Weight(NamedTuple, Generic[Kind]):
    """The weights that act at the crank pin and at the crosshead, that of the reciprocating parts among the
    latter, as forces; sin α and cos α of the slope, both negative on the return stroke."""

    pin: Kind
    crosshead: Kind
    reciprocating: Kind
    along: Kind
    across: Kind


def on_return(weight: Weight[Number]) -> Weight[Number]:
    """Return the same in the frame of the return stroke."""
    return weight._replace(along=-1 * weight.along, across=-1 * weight.across)


def pin_torque(weight: Weight[Number], circle: Circle[Number]) -> Number:
    """Return the torque of the weight at the crank pin, over R."""
    return weight.pin * (weight.along * circle.sine - weight.across * circle.cosine)


def torque_slope(weight: Weight[Number], circle: Circle[Number], acceleration: Number) -> Number:
    """Return the change with the angle in radians of the torque of all weights, from the piston's
    acceleration."""
    at_pin = weight.pin * (weight.along * circle.cosine + weight.across * circle.sine)
    return weight.crosshead * weight.along * acceleration + at_pin


def work(
    weight: Weight[Number], circle: Circle[Number], path: Number, length: Number, returning: bool
) -> Number:
    """Return the work that weight has done on the masses since any fixed place, over R.

    All is in the frame of the stroke, which is the return stroke or not; `length` is that of the stroke.
    """
    at_pin = weight.pin * (weight.along * circle.cosine + weight.across * circle.sine)
    # On the return `along` has the other sign, also of what the outstroke has done.
    gone = path - length if returning else path
    return weight.crosshead * weight.along * gone - at_pin


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
