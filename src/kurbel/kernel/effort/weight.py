"""The weight of the moving masses of a crank drive, by the slope of its slide.

The frame is that of kernel/forces.py: X runs from the shaft along the slide towards the dead centre that the
stroke leaves, Y towards the side of the crank pin. The slope is the angle by which X rises from the horizon,
counted in the sense in which the crank turns: at 90° the cylinder stands above the shaft, at 0° it lies, and
the crank pin passes above the shaft on the outstroke; at 180° it passes below. A weight G then acts as
-G sin α along X and -G cos α along Y. On the return stroke, whose frame points the other way, both change
their sign. Numbers are floats, arrays, balls or separation bounds. Re-derived.
"""

from __future__ import annotations

from typing import Generic, NamedTuple

from kurbel.kernel.circle import Circle, Kind, Number


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
