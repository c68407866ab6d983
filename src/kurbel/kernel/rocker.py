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

from kurbel.kernel import linkage, moving
from kurbel.kernel.circle import Circle, Numeric
from kurbel.kernel.linkage import Arc, Place
from kurbel.kernel.moving import Link, Masses
from kurbel.kernel.rod import magnitude


@dataclass(frozen=True, eq=False, repr=False)
class LoadedRocker:
    """The arc crank at a crank angle: its masses, and the force F on the rocker's end, positive against X.

    `circle` is that of the crank angle from the slide direction. `masses` are those of the rod joined with
    the `reciprocating` one, which goes with the rocker's end and has no part of the rod, and J/B².
    """

    circle: Circle[Numeric]
    place: Place[Numeric]
    arc: Arc[Numeric]
    masses: Masses[Numeric]
    piston_force: Numeric = 0
    reciprocating: Numeric = 0

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
        """-L ψ̈."""
        # L ψ̈ = p sin ψ - c (1 + βc) cos ψ, which has no λ below.
        place = self.place
        return place.slant_cosine * (place.velocity + self.draught) - place.slant * self.acceleration

    @cached_property
    def turning(self) -> Numeric:
        """The inertia couple over L and its sign, square to the rod."""
        return self.masses.couple * self.swing

    def couple(self) -> Numeric:
        """Return the inertia couple -M (k² - a b) ψ̈ over L, by which the two masses are wrong."""
        return self.turning + 0

    @cached_property
    def push(self) -> Numeric:
        """F - (m_B + J/B²) p."""
        return self.piston_force - (self.masses.crosshead + self.masses.rocker) * self.acceleration

    @cached_property
    def across(self) -> Numeric:
        """What the rod bears of the force with Y at B, without its own mass there."""
        place = self.place
        return (self.push * place.slant + self.turning) / place.slant_cosine + 0

    def guide_force(self) -> Numeric:
        """Return the force of the rocker on its end, positive with Y: a pull of the rocker for β > 0.

        (F - (m_B + J/B²) p) tan ψ, the couple's, and m_B βc², which draws the masses along.
        """
        return self.across + self.masses.crosshead * self.draught

    def inertia_force(self) -> Numeric:
        """Return the inertia force of the reciprocating mass."""
        return 0 - (self.reciprocating + self.masses.rocker) * self.acceleration

    def weight_force(self) -> Numeric:
        """Return no weight: what a rocker weighs is not known."""
        return 0

    def friction_force(self) -> Numeric:
        """Return no friction."""
        return 0

    def thrust(self) -> Numeric:
        """Return the force of the joint on the rod along the arc, positive against X."""
        return self.piston_force - (self.reciprocating + self.masses.rocker) * self.acceleration

    def rod_force(self) -> Numeric:
        """Return the force along the rod at its rocker end, positive where it presses the rod."""
        place = self.place
        return self.thrust() * place.slant_cosine + self._on_rod() * place.slant

    def pin_rod_force(self) -> Numeric:
        """Return the force along the rod at its crank-pin end, positive where it presses the rod."""
        place = self.place
        return self._along() * place.slant_cosine - self._across() * place.slant

    def crosshead_pin_force(self) -> Numeric:
        """Return the magnitude of the force between rod and rocker's end."""
        return magnitude(self.thrust(), self._on_rod())

    def pin_force(self) -> Numeric:
        """Return the magnitude of the force between crank pin and rod."""
        return magnitude(self._along(), self._across())

    def pin_force_along(self) -> Numeric:
        """Return the force of the crank pin on the rod along the slide direction, as `rod.Loaded` has it."""
        along, across, (sine, cosine) = self._along(), self._across(), self.lean
        return along * cosine - across * sine

    def pin_force_across(self) -> Numeric:
        """Return the same across the slide direction."""
        along, across, (sine, cosine) = self._along(), self._across(), self.lean
        return along * sine + across * cosine

    def radial_force(self) -> Numeric:
        """Return the force of the rod on the crank pin along the crank, positive towards the shaft."""
        return self._along() * self.place.cosine + self._across() * self.place.sine

    def torque(self) -> Numeric:
        """Return the torque on the shaft, positive as the crank turns: (F - (m_B + J/B²) p) c, the couple's.

        Times ω it is the work of F less the gain of kinetic energy in unit time.
        """
        place = self.place
        return self.push * place.velocity + self.turning * (place.cosine / place.slant_cosine) + 0

    def _on_rod(self) -> Numeric:
        """The force of the joint on the rod with Y."""
        return self.guide_force() - self.reciprocating * self.draught

    def _along(self) -> Numeric:
        return self.push - self.masses.pin * self.place.cosine

    def _across(self) -> Numeric:
        return 0 - (self.masses.pin * self.place.sine + self.across)

    @property
    def lean(self) -> tuple[Numeric, Numeric]:
        """Sine and cosine of the angle from the slide direction to the arc's tangent, as the crank turns."""
        circle, place = self.circle, self.place
        return (
            circle.sine * place.cosine - circle.cosine * place.sine,
            circle.cosine * place.cosine + circle.sine * place.sine,
        )


def kinetic_energy(place: Place[Numeric], masses: Masses[Numeric]) -> Numeric:
    """Return the part of the masses' kinetic energy that changes, in units of m R² ω²."""
    turning = place.cosine / place.slant_cosine
    return moving.kinetic_energy(place.velocity, turning, masses.crosshead + masses.rocker, masses.couple)


def torque_slope(place: Place[Numeric], arc: Arc[Numeric], masses: Masses[Numeric]) -> Numeric:
    """Return the change of `LoadedRocker.torque` without F with the angle in radians."""
    link = Link(place.sine, place.cosine, place.slant, place.slant_cosine, arc.ratio, arc.curvature)
    return moving.torque_slope(link, masses.crosshead + masses.rocker, masses.couple)
