"""Inertia of the connecting rod: part-accelerations, and the forces at its pins while the crank turns evenly.

A is the crank-pin end of the rod and B its crosshead end, S its centre of mass at the distance a from A and
b = L - a from B on the line between them, k its radius of gyration about S. (Ensslin's a is the distance from
B.) However its mass M is spread, the rod moves like `Masses`: M b/L at A, M a/L at B and, without mass, a
couple that makes up what its moment of inertia lacks or has too much, M (k² - a b). So a rod with k² = a b is
two masses exactly; a rod between its pins has k² < a b. For another rod these two masses are wrong by the
couple M (k² - a b) ψ̈ and by nothing else: all forces along the slide stay as they are, for the guide, which
holds the couple, makes forces across it only.

A `LoadedCrank` has the `Circle` of the crank angle, the ratio λ = R/L, the masses and, for an offset crank,
η = e/R (None is the straight crank); its forces are numbers of the circle's kind: floats, arrays, balls or
separation bounds. Accelerations are in units of R ω². With masses in units of the rod's M, forces are in
M R ω², torques in M R² ω². The crank turns evenly and accelerations are exact unless they come `by` others,
kernel/moving.py; there is no friction in the pins. Weights of the masses act where the masses are, for these
have the rod's centre of mass.

Signs are those of kernel/forces.py: X runs from the shaft along the slide towards the dead centre that the
stroke leaves, Y towards the side of the crank pin; both point the other way on the return stroke, a negative
ratio with a negative offset. With a positive ratio and 0 to 360° everything is in the one frame of the
outstroke. Ratio 0 is the infinite rod, which has these forces as limits. Valid where the kinematics are.

Floats: values of a rod of mass 1 are at most 2 ulp of max(|value|, 1) from the true value for |λ| <= 1/3,
16 ulp for |λ| <= 0.99; of an offset crank as close as `kinematics.offset_path`. Values of greater masses and
a piston force are as close, counted in the greatest of them.

Source: Ensslin, Dinglers Polytechnisches Journal 322 (1907), 593-595. His displayed formulas are not
transcribed, and his article goes on where the transcription ends; re-derived.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Generic, NamedTuple, Self

from kurbel.kernel import moving
from kurbel.kernel.circle import Circle, Kind, Numeric, root
from kurbel.kernel.forces import Weight, pin_torque, tangential_force
from kurbel.kernel.kinematics import RodDirection, rod_slant
from kurbel.kernel.moving import EVEN, Accelerations, Link, Masses


class Parts(NamedTuple, Generic[Kind]):
    """The acceleration of A, in three parts; at the distance x from B it is p₂ + (p₄ + p₅) x/L.

    `common` is p₂, that of B, against X: the piston acceleration. `turning` is p₄, square to the rod against
    Y, L |ψ̈| in magnitude. `stretching` is p₅, along the rod with X, L ψ̇² in magnitude: it points to B on
    either stroke, and is negative on the return.
    """

    common: Kind
    turning: Kind
    stretching: Kind


class Vector(NamedTuple, Generic[Kind]):
    """What has a part along the slide and one across it."""

    along: Kind
    across: Kind

    def size(self) -> Numeric:
        """Return its amount."""
        return magnitude(self.along, self.across)


@dataclass(frozen=True, eq=False, repr=False)
class LoadedCrank:
    """The crank drive at a crank angle: its masses, and the force F on the piston, positive against X.

    `masses` are those of the rod joined with the `reciprocating` one, which goes to and fro with the
    crosshead and has no part of the rod; `weight` is what they weigh, None where that does not count.
    `friction` of piston and crosshead counts as F does. Of a drive that guides B otherwise, X and Y are along
    its way and square to it, and what differs is overridden.
    """

    circle: Circle[Numeric]
    ratio: Numeric
    masses: Masses[Numeric]
    offset: Numeric | None = None
    piston_force: Numeric = 0
    reciprocating: Numeric = 0
    by: Accelerations[Numeric] = EVEN
    weight: Weight[Numeric] | None = None
    friction: Numeric | None = None

    def bearing(self, masses: Masses[Numeric]) -> Self:
        """Return the same drive at the same place with other masses, whose motion is not computed anew."""
        other = object.__new__(type(self))
        moving = ("slant", "acceleration", "swing")
        vars(other).update(vars(self), masses=masses, **{name: getattr(self, name) for name in moving})
        return other

    @property
    def pin(self) -> Circle[Numeric]:
        """The circle of the crank angle from X."""
        return self.circle

    @cached_property
    def slant(self) -> RodDirection[Numeric]:
        return rod_slant(self.circle, self.ratio, self.offset)

    @cached_property
    def velocity(self) -> Numeric:
        """That of B by exact formulas, c, which is the torque of a unit force."""
        return tangential_force(self.circle, self.ratio, self.offset)

    @property
    def motion(self) -> tuple[Numeric, Numeric]:
        """The velocity of B and L ψ̇, as the masses are accelerated."""
        if self.by.first_order:
            return self.by.velocity(self.circle, self.ratio, self.offset), self.circle.cosine
        return self.velocity, self.spin

    @property
    def spin(self) -> Numeric:
        """L ψ̇ by exact formulas."""
        return self.pin.cosine / self.slant.cosine

    @property
    def driven(self) -> Numeric:
        """All that is accelerated with B along its way, m_B."""
        return self.masses.crosshead

    @property
    def going(self) -> Numeric:
        """What of this has no part of the rod."""
        return self.reciprocating

    @cached_property
    def acceleration(self) -> Numeric:
        """The piston's, p."""
        return self.by.piston(self.circle, self.ratio, self.offset)

    @cached_property
    def swing(self) -> Numeric:
        """-L ψ̈."""
        return self.by.turning(self.circle, self.ratio, self.slant, self.offset)

    @property
    def parts(self) -> Parts[Numeric]:
        """Ensslin's parts of the acceleration."""
        # No zero is to have a sign, here and below.
        stretching = self.by.stretching(self.pin, self.ratio, self.slant) + 0
        return Parts(self.acceleration, self.swing, stretching)

    @cached_property
    def turning(self) -> Numeric:
        """The inertia couple over L and its sign, square to the rod."""
        return self.masses.couple * self.swing

    @cached_property
    def push(self) -> Numeric:
        """F - m_B p, with friction and weight along the slide."""
        push = self.effort - self.driven * self.acceleration
        weight = self.weight
        return push if weight is None else push + weight.crosshead * weight.along

    @property
    def effort(self) -> Numeric:
        """F with friction."""
        return self.piston_force if self.friction is None else self.piston_force + self.friction

    def couple(self) -> Numeric:
        """Return the inertia couple -M (k² - a b) ψ̈ over L, by which the two masses are wrong.

        It is the force with Y at A, and against Y at B, square to the rod, that makes the couple.
        """
        return self.turning + 0

    def guide_force(self) -> Numeric:
        """Return the force of the guide on the crosshead, positive with Y: (F - m_B p) tan ψ, the couple's
        and the weight at B across the slide.

        Re-derived: moments about A.
        """
        weight = self.weight
        return self.side if weight is None else self.side + weight.crosshead * weight.across

    @cached_property
    def side(self) -> Numeric:
        """The guide force but for the weight across."""
        slant = self.slant
        return (self.push * slant.sine + self.turning) / slant.cosine + 0

    def pin_force_along(self) -> Numeric:
        """Return the force of the crank pin on the rod along the slide, F - m_B p - m_A cos φ, with X.

        The couple is not in it. The rod presses on the pin the other way.
        """
        return self.at_pin().along

    def pin_force_across(self) -> Numeric:
        """Return the force of the crank pin on the rod across the slide, positive with Y: -m_A sin φ - N."""
        return self.at_pin().across

    def at_pin(self) -> Vector[Numeric]:
        """Return both along and across the way of B."""
        pin, weight = self.masses.pin, self.weight
        along = self.effort - (self.driven * self.acceleration + pin * self.by.pin_along(self.pin))
        across = 0 - (pin * self.by.pin_across(self.pin) + self.side)
        if weight is None:
            return Vector(along, across)
        both = weight.crosshead + weight.pin
        return Vector(along + both * weight.along, across + weight.pin * weight.across)

    def pin_force(self) -> Numeric:
        """Return the magnitude of the force between crank pin and rod."""
        return self.at_pin().size()

    def thrust(self) -> Numeric:
        """Return the force of the crosshead on the rod along the slide, positive against X: F - m p, with
        friction and weight."""
        thrust = self.effort - self.going * self.acceleration
        return thrust if self.weight is None else thrust + self.weight_force()

    def inertia_force(self) -> Numeric:
        """Return the inertia force of the reciprocating mass, positive against X: -m p."""
        return 0 - self.going * self.acceleration

    def weight_force(self) -> Numeric:
        """Return the weight of the reciprocating mass along the slide, positive against X."""
        weight = self.weight
        return 0 if weight is None else weight.reciprocating * weight.along + 0

    def friction_force(self) -> Numeric:
        """Return the friction of piston and crosshead, positive against X."""
        return 0 if self.friction is None else self.friction

    def crosshead_side(self) -> Numeric:
        """Return the force of the crosshead on the rod across the slide, positive with Y."""
        weight = self.weight
        if weight is None:
            return self.guide_force()
        return self.side + (weight.crosshead - weight.reciprocating) * weight.across

    def rod_force(self) -> Numeric:
        """Return the force along the rod at its crosshead end, positive where it presses the rod.

        Of a rod without mass it is the same all along the rod, F/cos ψ. Re-derived, from the equilibrium of
        the crosshead.
        """
        slant = self.slant
        return self.thrust() * slant.cosine + self.crosshead_side() * slant.sine

    def pin_rod_force(self) -> Numeric:
        """Return the force along the rod at its crank-pin end, positive where it presses the rod.

        The rod's own inertia makes it another one than `rod_force`. Re-derived, from `pin_force_along` and
        `pin_force_across`.
        """
        slant, (along, across) = self.slant, self.at_pin()
        return along * slant.cosine - across * slant.sine

    def crosshead_pin_force(self) -> Numeric:
        """Return the magnitude of the force between crosshead pin and rod."""
        return magnitude(self.thrust(), self.crosshead_side())

    def radial_force(self) -> Numeric:
        """Return the force of the rod on the crank pin along the crank, positive towards the shaft.

        The force across the crank is `torque`, in units of R. Re-derived: the pin force turned by φ.
        """
        along, across = self.at_pin()
        return along * self.pin.cosine + across * self.pin.sine

    def torque(self) -> Numeric:
        """Return the torque on the shaft, positive as the crank turns: (F - m_B p) c, and the couple's.

        Times ω it is the work of F less the gain of kinetic energy in unit time. It has what speeds up the
        rod's mass at the pin, if the crank does not turn evenly, but nothing of the crank's own. Re-derived.
        """
        found = self._work(self.velocity, self.spin)
        return found if self.by.gain is None else found - self.by.gain * self.masses.pin

    def power(self) -> Numeric:
        """Return what all does over the angle in radians, less what the masses take: the torque, but for the
        first order, whose motion is its own."""
        return self._work(*self.motion)

    def _work(self, velocity: Numeric, spin: Numeric) -> Numeric:
        # The couple's part is its force on the guide times cos φ, the share of R across the slide.
        work = self.push * velocity + self.turning * spin + 0
        return work if self.weight is None else work + pin_torque(self.weight, self.circle)

    def kinetic_energy(self) -> Numeric:
        """Return ½ m_B c² + ½ m q (cos φ/cos ψ)², the part of the masses' energy that changes.

        In units of m R² ω²; q is the couple. The mass at the crank pin turns evenly. Re-derived.
        """
        velocity, spin = self.motion
        return (self.driven * velocity * velocity + self.masses.couple * spin * spin) / 2

    def torque_slope(self) -> Numeric:
        """Return the change of what the inertia of the masses does, `power`, with the angle in radians."""
        if self.by.first_order:
            return moving.torque_slope_first_order(self.circle, self.ratio, self.masses)
        return moving.torque_slope(self.link, self.driven, self.masses.couple)

    @property
    def link(self) -> Link[Numeric]:
        return Link(self.pin.sine, self.pin.cosine, *self.slant, self.ratio)


def magnitude(along: Any, across: Any) -> Numeric:
    """Return the length of a force from two components square to each other."""
    square = along * along + across * across
    if hasattr(square, "abs_upper") and square.contains(0):
        # The square of a ball that holds 0 reaches below 0, where there is no root.
        edge = root(square.abs_upper())
        return edge.union(-edge)
    return root(square)
