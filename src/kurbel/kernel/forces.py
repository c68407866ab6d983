"""Forces that one piston force calls up in the crank drive: in the rod, at the guide, at the crank pin.

Every function takes the `Circle` of the crank angle, the crank ratio λ = R/L and, for an offset crank,
η = e/R (None is the straight crank), and returns a number of the circle's kind: a float, an array, a ball or
a separation bound. Forces are in units of the piston force F, torques in units of F R. Without masses and
friction; with the masses see kernel/rod.py.

F acts along the slide and counts away from the dead centre, in the direction in which the piston moves: a
positive force drives the crank on either stroke. A negative ratio, with a negative offset, is the return
stroke, as in kernel/kinematics.py. All signs are those of the stroke in question, that is of a frame that has
the shaft for its origin, X along the slide towards its dead centre and Y towards the side on which the crank
pin runs: on the return stroke both point the other way. With a positive ratio and 0 to 360° everything is in
the one frame of the outstroke. Valid where the kinematics are.
"""

from typing import Generic, NamedTuple, TypeVar

from kurbel.kernel import kinematics
from kurbel.kernel.circle import Circle, Number, cosine_of, root

Kind = TypeVar("Kind")


class Slant(NamedTuple, Generic[Kind]):
    """sin ψ and cos ψ of the rod angle ψ, of one kind of number."""

    sine: Kind
    cosine: Kind


def rod_slant(circle: Circle[Number], ratio: Number, offset: Number | None = None) -> Slant[Number]:
    """Return the direction of the rod, ψ positive as in `kinematics.rod_sine`."""
    if offset is None:
        return Slant(ratio * circle.sine, kinematics.rod_cosine(circle, ratio))
    sine = kinematics.rod_sine(circle, ratio, offset)
    return Slant(sine, cosine_of(sine))


def rod_force(circle: Circle[Number], ratio: Number, offset: Number | None = None) -> Number:
    """Return the force along the rod, F/cos ψ, a thrust on the outstroke and a pull on the return stroke.

    Floats: at most 1.5 ulp from the true value for |λ| <= 1/3, 3 ulp for |λ| <= 0.99; of an offset crank as
    close as `kinematics.offset_path`. Source: exercise "Kräfte am Kurbeltrieb", eq. (3).
    """
    return 1 / rod_slant(circle, ratio, offset).cosine


def guide_force(circle: Circle[Number], ratio: Number, offset: Number | None = None) -> Number:
    """Return the force of the guide on the crosshead, F tan ψ, positive towards the side of the crank pin.

    The crosshead presses the other way. Negative on the return stroke of the straight crank: there the pin
    runs on the other side, so the crosshead of an engine that drives lies against one face on both strokes.
    Floats: at most 1.5 ulp from the true value for |λ| <= 1/3, 5 ulp for |λ| <= 0.99; of an offset crank as
    close as `kinematics.offset_path`. Source: exercise "Kräfte am Kurbeltrieb", eq. (6).
    """
    slant = rod_slant(circle, ratio, offset)
    # No zero is to have a sign, and a negative ratio gives it one.
    if offset is not None:
        return slant.sine / slant.cosine + 0
    # The quotient outright reaches 3.1 ulp; 1/cos ψ is 1 + (1 - cos ψ)/cos ψ.
    share = slant.sine * slant.sine / ((1 + slant.cosine) * slant.cosine)
    return slant.sine + (slant.sine * share + ratio * circle.sine_tail) + 0


def tangential_force(circle: Circle[Number], ratio: Number, offset: Number | None = None) -> Number:
    """Return the force across the crank at its pin, F sin(φ + ψ)/cos ψ, positive as the crank turns.

    In units of F R it is the torque on the shaft. It is the piston velocity over v, by the principle of
    virtual displacements. Source: Rötscher, Zusammenstellung 112.
    """
    if offset is None:
        return kinematics.piston_velocity(circle, ratio)
    return kinematics.offset_velocity(circle, ratio, offset)


def radial_force(circle: Circle[Number], ratio: Number, offset: Number | None = None) -> Number:
    """Return the force along the crank at its pin, F cos(φ + ψ)/cos ψ, positive towards the shaft.

    F presses the pin towards the shaft at the dead centre that the stroke leaves, and pulls it away at the
    one it reaches. Floats: at most 2 ulp of max(|value|, 1) from the true value for |λ| <= 1/3, 5 ulp for
    |λ| <= 0.99; of an offset crank as close as `kinematics.offset_path`. Re-derived, as cos φ - sin φ tan ψ.
    """
    slant = rod_slant(circle, ratio, offset)
    return circle.cosine - circle.sine * (slant.sine / slant.cosine)


def square_position(ratio: Number) -> Circle[Number]:
    """Return the crank angle at which the rod touches the crank circle, square to the crank: tan ψ = λ.

    Then φ + ψ = 90°, sin φ = cos ψ and cos φ = sin ψ. Straight crank.
    Source: exercise "Kräfte am Kurbeltrieb", eq. (1) and (4).
    """
    sine = 1 / square_rod_force(ratio)
    return Circle(sine, ratio * sine, 1 - ratio * sine)


def square_rod_force(ratio: Number) -> Number:
    """Return F √(λ² + 1), the rod force in the square position, where it is the tangential force too.

    In units of F R it is the torque; the guide force is F λ and the radial force 0.
    Source: exercise "Kräfte am Kurbeltrieb", eq. (5), (9) and (11).
    """
    return root(ratio * ratio + 1)
