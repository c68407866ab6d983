"""The moving masses of any drive with a rod: what moves like the rod, how it is accelerated, and its energy.

The masses of rod and driven end have the energy ½ m_B c² + ½ m q u² and, at the crank pin, one that never
changes; c is the velocity of the driven end and u = cos φ/cos ψ, L ψ̇ over R ω. So their torque on a crank
that turns evenly is -(m_B c c' + m q u u'), and its slope -(m_B (c'² + c c'') + m q (u'² + u u'')), where a
dash is a slope over the crank angle in radians.

Numbers are floats, arrays, balls or separation bounds. Units as in kernel/rod.py. Re-derived.

`Accelerations`, which `Loaded` of kernel/rod.py makes forces of, are exact or of first order in λ, of a crank
that turns evenly or has an angular acceleration α at the moment: x'' ω² + x' α of whatever moves, with the
slopes over the crank angle. `gain` is κ = α/ω², positive as the crank turns, None for even turning. Units are
R ω²; signs and arguments are those of kernel/rod.py, offset being η or None for the straight crank.

The first order is that of the textbooks of the theory of machines: the piston's acceleration is
cos φ + λ cos 2φ, and the rod turns by ψ' = λ cos φ and ψ'' = -λ sin φ; the angle ψ at which forces pass
through the rod is exact, so that the forces of a place compose. So the torque of `Loaded` is not quite the
slope of the energy to first order, of c = sin φ + ½ λ sin 2φ and u = cos φ.
"""

from typing import Any, Generic, NamedTuple

from kurbel.kernel import kinematics
from kurbel.kernel.circle import Circle, Kind, Numeric
from kurbel.kernel.forces import tangential_force
from kurbel.kernel.kinematics import RodDirection


class Masses(NamedTuple, Generic[Kind]):
    """What moves like the rod: a mass at A, one at B, and the couple m (k² - a b)/L², 0 for two masses.

    `rocker` is one that a rocker in place of the guide has at B along its arc alone: kernel/rocker.py.
    """

    pin: Kind
    crosshead: Kind
    couple: Kind | int = 0
    rocker: Kind | int = 0


def rod_masses(centre: Numeric, gyration_square: Numeric) -> Masses[Any]:
    """Return the masses of a rod of mass 1 from a/L and k²/L²."""
    return Masses(1 - centre, centre, gyration_square - centre * (1 - centre))


def two_masses(crosshead: Numeric) -> Masses[Any]:
    """Return the two masses that replace a rod of mass 1, this share of it at the crosshead.

    By the centre of mass the share is a/L, by the railway rule 4/10. Source: Ensslin, 593.
    """
    return Masses(1 - crosshead, crosshead)


def joined(masses: Masses[Numeric], rod: Numeric, reciprocating: Numeric) -> Masses[Any]:
    """Return the masses of a rod of mass `rod`, one that reciprocates with the crosshead added.

    The forces are then in the unit of mass times R ω², and so must the piston force be.
    """
    pin, crosshead, couple, *_ = (rod * part for part in masses)
    return Masses(pin, crosshead + reciprocating, couple)


def with_crank(masses: Masses[Numeric], rotating: Numeric) -> Masses[Numeric]:
    """Return masses of which the forces at the pin are those of the main bearing on the shaft.

    `rotating` is the crank's own mass times the distance of its centre from the shaft, over R; negative for
    a counterweight. It leaves the guide force and the torque as they are, and has no weight here, for what
    the crank weighs is not known of it.
    """
    return masses._replace(pin=masses.pin + rotating)


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


def torque_slope(link: Link[Numeric], driven: Numeric, couple: Numeric) -> Numeric:
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


class Accelerations(NamedTuple, Generic[Kind]):
    """How the masses are accelerated. The first order is of the straight crank alone."""

    gain: Kind | None = None
    first_order: bool = False

    def piston(self, circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None) -> Numeric:
        """Return p, that of the piston against X."""
        if self.first_order:
            found = kinematics.piston_acceleration_first_order(circle, ratio)
        else:
            found = kinematics.piston_acceleration(circle, ratio, offset)
        return found if self.gain is None else found + self.gain * self.velocity(circle, ratio, offset)

    def velocity(self, circle: Circle[Numeric], ratio: Numeric, offset: Numeric | None) -> Numeric:
        """Return c of the piston in units of v."""
        if self.first_order:
            return kinematics.piston_velocity_first_order(circle, ratio)
        return tangential_force(circle, ratio, offset)

    def turning(
        self, circle: Circle[Numeric], ratio: Numeric, slant: RodDirection[Numeric], offset: Numeric | None
    ) -> Numeric:
        """Return -L ψ̈, that of the crank-pin end about the other, square to the rod."""
        if self.first_order:
            found, turn = circle.sine, circle.cosine
        else:
            found = kinematics.rod_turning(circle, ratio, slant.sine, slant.cosine, offset)
            turn = circle.cosine / slant.cosine
        return found if self.gain is None else found - self.gain * turn

    def stretching(self, circle: Circle[Numeric], ratio: Numeric, slant: RodDirection[Numeric]) -> Numeric:
        """Return L ψ̇², along the rod."""
        pull = circle.cosine if self.first_order else circle.cosine / slant.cosine
        return ratio * (pull * pull)

    def pin_along(self, circle: Circle[Numeric]) -> Numeric:
        """Return that of the crank pin along the slide, against X: cos φ + κ sin φ."""
        return circle.cosine if self.gain is None else circle.cosine + self.gain * circle.sine

    def pin_across(self, circle: Circle[Numeric]) -> Numeric:
        """Return that of the crank pin across the slide, against Y: sin φ - κ cos φ."""
        return circle.sine if self.gain is None else circle.sine - self.gain * circle.cosine


EVEN: Accelerations[Numeric] = Accelerations()
OF_FIRST_ORDER: Accelerations[Numeric] = Accelerations(first_order=True)


def torque_slope_first_order(circle: Circle[Numeric], ratio: Numeric, masses: Masses[Numeric]) -> Numeric:
    """Return the change of the power of the masses' inertia with the angle in radians."""
    sine, cosine = circle.sine, circle.cosine
    velocity = kinematics.piston_velocity_first_order(circle, ratio)
    acceleration = kinematics.piston_acceleration_first_order(circle, ratio)
    jerk = 0 - sine * (1 + 4 * ratio * cosine)
    driven = acceleration * acceleration + velocity * jerk
    return 0 - (masses.crosshead * driven + masses.couple * ((sine - cosine) * (sine + cosine)))
