"""The accelerations of the masses of the crank drive, which `Loaded` of kernel/rod.py makes forces of.

They are the exact ones or those of first order in λ, of a crank that turns evenly or has an angular
acceleration α at the moment: x'' ω² + x' α of whatever moves, with the slopes over the crank angle. `gain`
is κ = α/ω², positive as the crank turns, None for even turning. Units are R ω²; signs and arguments are those
of kernel/rod.py, offset being η or None for the straight crank.

The first order is that of the textbooks of the theory of machines: the piston's acceleration is
cos φ + λ cos 2φ, and the rod turns by ψ' = λ cos φ and ψ'' = -λ sin φ; the angle ψ at which forces pass
through the rod is exact, so that the forces of a place compose.
"""

from typing import Generic, NamedTuple, TypeVar

from kurbel.kernel import kinematics
from kurbel.kernel.circle import Circle, Number
from kurbel.kernel.forces import Slant, tangential_force

Kind = TypeVar("Kind")


class Accelerations(NamedTuple, Generic[Kind]):
    """How the masses are accelerated. The first order is of the straight crank alone."""

    gain: Kind | None = None
    first_order: bool = False

    def piston(self, circle: Circle[Number], ratio: Number, offset: Number | None) -> Number:
        """Return p, that of the piston against X."""
        if self.first_order:
            found = kinematics.piston_acceleration_first_order(circle, ratio)
        elif offset is None:
            found = kinematics.piston_acceleration(circle, ratio)
        else:
            found = kinematics.offset_acceleration(circle, ratio, offset)
        return found if self.gain is None else found + self.gain * self.velocity(circle, ratio, offset)

    def velocity(self, circle: Circle[Number], ratio: Number, offset: Number | None) -> Number:
        """Return c of the piston in units of v."""
        if self.first_order:
            return kinematics.piston_velocity_first_order(circle, ratio)
        return tangential_force(circle, ratio, offset)

    def turning(
        self, circle: Circle[Number], ratio: Number, slant: Slant[Number], offset: Number | None
    ) -> Number:
        """Return -L ψ̈, that of the crank-pin end about the other, square to the rod."""
        if self.first_order:
            found, turn = circle.sine, circle.cosine
        else:
            found = kinematics.rod_turning(circle, ratio, slant.sine, slant.cosine, offset)
            turn = circle.cosine / slant.cosine
        return found if self.gain is None else found - self.gain * turn

    def stretching(self, circle: Circle[Number], ratio: Number, slant: Slant[Number]) -> Number:
        """Return L ψ̇², along the rod."""
        pull = circle.cosine if self.first_order else circle.cosine / slant.cosine
        return ratio * (pull * pull)

    def pin_along(self, circle: Circle[Number]) -> Number:
        """Return that of the crank pin along the slide, against X: cos φ + κ sin φ."""
        return circle.cosine if self.gain is None else circle.cosine + self.gain * circle.sine

    def pin_across(self, circle: Circle[Number]) -> Number:
        """Return that of the crank pin across the slide, against Y: sin φ - κ cos φ."""
        return circle.sine if self.gain is None else circle.sine - self.gain * circle.cosine


EVEN: Accelerations[Number] = Accelerations()
OF_FIRST_ORDER: Accelerations[Number] = Accelerations(first_order=True)
