"""Forces of the arc crank with its moving masses: rod, rocker, and what goes to and fro at the rocker's end.

The piston force F and the reciprocating mass act at the rocker's end B, along its arc. The rod moves like
`Masses` of kernel/moving.py, at the crank pin A and at B with the couple that makes up its moment of inertia.
The rocker's own moment of inertia J about its pivot is there a mass J/B² at its end, but only along the arc:
its pivot bears what pulls it across. Forces are in M R ω², torques in M R² ω²; the crank turns evenly, and
there is neither friction nor weight.

Signs are those of kernel/rod.py, with X and Y at the place of B: X along its arc against the stroke, Y along
the rocker, towards the side on which the crank pin runs in the stroke and, for β > 0, towards the pivot. As
the rocker grows, all this becomes the offset crank. Floats: as close as the acceleration, counted in the
greatest of the forces.

All formulas are re-derived, from the equilibrium of the joint at B and of the rod, for B is drawn to the
pivot by βc².
"""

from dataclasses import dataclass
from functools import cached_property

from kurbel.kernel import linkage
from kurbel.kernel.circle import Circle, Numeric
from kurbel.kernel.coupler import arc_direction
from kurbel.kernel.kinematics import RodDirection
from kurbel.kernel.linkage import Arc, Place
from kurbel.kernel.moving import Link
from kurbel.kernel.rod import LoadedCrank, Vector


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class LoadedRocker(LoadedCrank):
    """The arc crank at a crank angle: its masses, and the force F on the rocker's end, positive against X.

    `circle` is that of the crank angle from the slide direction. `masses` are those of the rod joined with
    the `reciprocating` one, which goes with the rocker's end and has no part of the rod, and J/B². What the
    rocker weighs is not known, and there is no friction.
    """

    place: Place[Numeric]
    arc: Arc[Numeric]

    @cached_property
    def pin(self) -> Circle[Numeric]:
        return Circle(self.place.sine, self.place.cosine, 1 - self.place.cosine)

    @cached_property
    def slant(self) -> RodDirection[Numeric]:
        return RodDirection(self.place.slant, self.place.slant_cosine)

    @property
    def velocity(self) -> Numeric:
        return self.place.velocity

    @cached_property
    def acceleration(self) -> Numeric:
        """That of B along the arc, p."""
        return linkage.acceleration(self.place, self.arc)

    @cached_property
    def draught(self) -> Numeric:
        """That of B along the rocker with Y, βc²."""
        return self.arc.curvature * self.place.velocity * self.place.velocity

    @cached_property
    def swing(self) -> Numeric:
        # L ψ̈ = p sin ψ - c (1 + βc) cos ψ, which has no λ below.
        place = self.place
        return place.slant_cosine * (place.velocity + self.draught) - place.slant * self.acceleration

    @property
    def driven(self) -> Numeric:
        return self.masses.crosshead + self.masses.rocker

    @property
    def going(self) -> Numeric:
        return self.reciprocating + self.masses.rocker

    def guide_force(self) -> Numeric:
        """Return the force of the rocker on its end, positive with Y: a pull of the rocker for β > 0.

        (F - (m_B + J/B²) p) tan ψ, the couple's, and m_B βc², which draws the masses along.
        """
        return self.side + self.masses.crosshead * self.draught

    def crosshead_side(self) -> Numeric:
        return self.guide_force() - self.reciprocating * self.draught

    def pin_force_along(self) -> Numeric:
        """Return the force of the crank pin on the rod along the slide direction."""
        (along, across), (cosine, sine) = self.at_pin(), self.way
        return along * cosine - across * sine

    def pin_force_across(self) -> Numeric:
        """Return the same across the slide direction."""
        (along, across), (cosine, sine) = self.at_pin(), self.way
        return along * sine + across * cosine

    @property
    def link(self) -> Link[Numeric]:
        return super().link._replace(curvature=self.arc.curvature)

    @property
    def way(self) -> Vector[Numeric]:
        """The direction of the arc from that of the slide, as the crank turns."""
        return arc_direction(self.circle, self.place)
