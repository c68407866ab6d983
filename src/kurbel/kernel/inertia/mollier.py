"""The force along the slide that moves the rod, as Mollier asks for it.

Ensslin names it as the force that has to act at the crosshead in the direction of thrust to move the rod;
Mollier's article (Zeitschrift des Vereines deutscher Ingenieure 1903, p. 1638), which he cites, was not at
hand. It is read here so: the crank turns evenly and its pin guides the rod, but takes no torque from it and
gives it none. By virtual displacements the force times the velocity of the crosshead then is what the kinetic
energy of the rod gains in unit time, so that H = dT/dx: H = m_B p for two masses, of which the one at the
crank pin moves evenly, and for the rod itself besides what its couple M (k² - a b) asks for. At a force H on
the crosshead the torque of kernel/rod.py is zero.

Units and signs are those of kernel/rod.py; H is positive as F is, against X.
"""

from kurbel.kernel.circle import Circle, Number
from kurbel.kernel.forces import rod_slant, tangential_force
from kurbel.kernel.kinematics import offset_acceleration, piston_acceleration, rod_turning
from kurbel.kernel.rod import Masses


def moving_force(
    circle: Circle[Number], ratio: Number, masses: Masses[Number], offset: Number | None = None
) -> Number:
    """Return H = m_B p - q cos φ (cos ψ - λ cos φ)/cos³ ψ, q being the couple m (k² - a b)/L².

    Exact. Of the offset crank the last part is q ψ̈ cos φ/(cos ψ c) in L, which has poles at the dead
    centres: there the rod turns while the crosshead rests. Floats: as close as kernel/rod.py; of the offset
    crank that times 1/|c|. Re-derived.
    """
    slant = rod_slant(circle, ratio, offset)
    if offset is None:
        # ψ̈ and c have the zeros of sin φ in common, and (1 - λ²)/(w + λ cos φ) is w - λ cos φ.
        share = slant.cosine - ratio * circle.cosine
        turning = circle.cosine * share / (slant.cosine * slant.cosine * slant.cosine)
        return masses.crosshead * piston_acceleration(circle, ratio) - masses.couple * turning
    swing = rod_turning(circle, ratio, slant.sine, slant.cosine, offset)
    turning = swing * circle.cosine / (slant.cosine * tangential_force(circle, ratio, offset))
    return masses.crosshead * offset_acceleration(circle, ratio, offset) - masses.couple * turning
