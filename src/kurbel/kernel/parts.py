"""The parts of the rod's inertia as Ensslin parts them: accelerations, and forces in A and B for each part.

A is the crank-pin end of the rod and B its crosshead end. The acceleration of a point at the distance x from
B is p₂ + (p₄ + p₅) x/L: p₂ is that of B, p₄ the turning part at A, square to the rod, p₅ the stretching part
at A, along the rod. Together p₄ and p₅ are p₃, which with p₂ replaces p₁, the acceleration of A. So the rod
may be looked at under each part alone, and what is found is added:

- under p₂ it presses on A and B like the masses M a/L in A and M b/L in B,
- under p₅ like the same masses, of which the one in B is at rest: M a/L p₅ in A, nothing in B,
- under p₄ there is M (k² + a²)/L² p₄ in A, by moments about B, and in B the rest, M (a b - k²)/L² p₄.

Here a is the distance of the centre of mass from B and b that from A, as Ensslin has them, and `Masses` of
kernel/rod.py has M a/L as `pin`, M b/L as `crosshead` and M (k² - a b)/L² as `couple`.

What a force along the rod in A holds, one in B can hold as well, for both lie in one line; the accelerations
do not tell which. `in_pin` and `in_crosshead` share it as Ensslin's two masses do. In a drive without a
piston force nothing holds the rod's end B along the slide: `guide`, `at_pin` and `torque` are of this share.
They are the forces of `rod.Loaded` without F, part by part.

An acceleration is positive against X and against Y of kernel/rod.py, its turning part square to the rod
against Y, its stretching part along the rod with X; forces on the rod are positive with X and with Y. The
rod presses on pins and guide the other way. Units are R ω² and, with masses of a rod of mass 1, M R ω².

Floats: as close as those of kernel/rod.py. Source: Ensslin, Dinglers Polytechnisches Journal 322 (1907),
593-595, figures 1 to 7. The forces under p₄ stand in the part of his article that is not transcribed;
re-derived, and for a rocker in place of the slide.

The force along the slide that moves the rod, as Mollier asks for it.

Ensslin names it as the force that has to act at the crosshead in the direction of thrust to move the rod;
Mollier's article (Zeitschrift des Vereines deutscher Ingenieure 1903, p. 1638), which he cites, was not at
hand. It is read here so: the crank turns evenly and its pin guides the rod, but takes no torque from it and
gives it none. By virtual displacements the force times the velocity of the crosshead then is what the kinetic
energy of the rod gains in unit time, so that H = dT/dx: H = m_B p for two masses, of which the one at the
crank pin moves evenly, and for the rod itself besides what its couple M (k² - a b) asks for. At a force H on
the crosshead the torque of kernel/rod.py is zero.

Units and signs are those of kernel/rod.py; H is positive as F is, against X.
"""

from __future__ import annotations

from dataclasses import dataclass

from kurbel.kernel.circle import Circle, Numeric
from kurbel.kernel.forces import tangential_force
from kurbel.kernel.kinematics import RodDirection, piston_acceleration, rod_slant, rod_turning
from kurbel.kernel.moving import Masses
from kurbel.kernel.rocker import LoadedRocker
from kurbel.kernel.rod import LoadedCrank, Parts, Vector, magnitude

COMMON, TURNING, STRETCHING = PARTS = Parts._fields


@dataclass(frozen=True, eq=False, repr=False)
class AccelerationParts:
    """The rod at a crank angle, its acceleration in parts.

    `pin` is p₁ and `common` p₂; `turning` and `stretching` are p₄ and p₅. `slant` has the direction of the
    rod and `crank` that of the crank: X and Y of the crank pin, in R. `way` is the direction in which B is
    free to move, with X; None is X itself. The guide holds B square to it, with Y.
    """

    pin: Vector[Numeric]
    common: Vector[Numeric]
    turning: Numeric
    stretching: Numeric
    slant: RodDirection[Numeric]
    crank: Vector[Numeric]
    masses: Masses[Numeric]
    way: Vector[Numeric] | None = None

    def replaced(self) -> Vector[Numeric]:
        """Return p₃ = p₁ - p₂."""
        return _sum(self._square(self.turning), self._lengthwise(self.stretching))

    def replaced_size(self) -> Numeric:
        """Return the amount of p₃, from its two parts square to each other."""
        return magnitude(self.turning, self.stretching)

    def at_point(self, share: Numeric) -> Vector[Numeric]:
        """Return the acceleration of the point at the distance x from B, from x/L."""
        replaced = self.replaced()
        return _sum(self.common, Vector(share * replaced.along, share * replaced.across))

    def part_at(self, part: str, share: Numeric) -> Vector[Numeric]:
        """Return one part of the acceleration of the point at the distance x from B, from x/L."""
        if part == COMMON:
            return self.common
        if part == TURNING:
            return self._square(share * self.turning)
        return self._lengthwise(share * self.stretching)

    def mass_in_pin(self, part: str) -> Numeric:
        """Return the mass in A that has the forces of a part: M a/L, under p₄ M (k² + a²)/L²."""
        return self.masses.pin + self.masses.couple if part == TURNING else self.masses.pin

    def mass_in_crosshead(self, part: str) -> Numeric:
        """Return what times the part's acceleration, p₂, p₄ or p₅, is the force in B: M b/L, under p₄
        M (a b - k²)/L² and under p₅ nothing."""
        if part == COMMON:
            return self.masses.crosshead
        return 0 - self.masses.couple if part == TURNING else 0 * self.masses.couple

    def in_pin(self, part: str = "") -> Vector[Numeric]:
        """Return the force on the rod in A for a part, without one their sum: that of M a/L p₁ and of the
        couple M (k² - a b) ψ̈."""
        if part:
            return _pull(self.mass_in_pin(part), self.part_at(part, 1))
        return _sum(_pull(self.masses.pin, self.pin), _pull(self.masses.couple, self._square(self.turning)))

    def in_crosshead(self, part: str = "") -> Vector[Numeric]:
        """Return the force on the rod in B for a part, without one their sum: that of M b/L p₂ less that of
        the couple."""
        if part:
            return _pull(self.mass_in_crosshead(part), self.part_at(part, 1))
        couple = _pull(0 - self.masses.couple, self._square(self.turning))
        return _sum(_pull(self.masses.crosshead, self.common), couple)

    def guide(self, part: str = "") -> Numeric:
        """Return the force of the guide on the rod for a part, where nothing holds B in its way.

        What `in_crosshead` has in the way of B goes through the rod to A.
        """
        held = _sum(self.in_crosshead(part), self._carried(part))
        if self.way is None:
            return held.across + 0
        return held.across * self.way.along - held.along * self.way.across + 0

    def at_pin(self, part: str = "") -> Vector[Numeric]:
        """Return the force of the crank pin on the rod for a part, where nothing holds B in its way."""
        own, carried = self.in_pin(part), self._carried(part)
        return Vector(own.along - carried.along + 0, own.across - carried.across + 0)

    def torque(self, part: str = "") -> Numeric:
        """Return the torque on the shaft for a part, positive as the crank turns, in M R² ω²."""
        force = self.at_pin(part)
        return force.along * self.crank.across - force.across * self.crank.along + 0

    def _carried(self, part: str) -> Vector[Numeric]:
        """The force along the rod in B by which it needs none in its way."""
        held, (sine, cosine) = self.in_crosshead(part), self.slant
        if self.way is None:
            return Vector(0 - held.along, held.along * sine / cosine)
        against = held.along * self.way.along + held.across * self.way.across
        share = 0 - against / (cosine * self.way.along - sine * self.way.across)
        return Vector(share * cosine, 0 - share * sine)

    def _square(self, amount: Numeric) -> Vector[Numeric]:
        """An acceleration square to the rod."""
        return Vector(amount * self.slant.sine, amount * self.slant.cosine)

    def _lengthwise(self, amount: Numeric) -> Vector[Numeric]:
        """An acceleration along the rod."""
        return Vector(0 - amount * self.slant.cosine, amount * self.slant.sine)


def parted(loaded: LoadedCrank) -> AccelerationParts:
    """Return the rod of a drive, its acceleration in parts. Of one that moves a rocker B is the end of that,
    and the rocker is the guide.

    Along the slide and across it are as at the crank, not along the arc. The acceleration of B has a part
    towards the pivot, and p₂ is both together. Re-derived.
    """
    circle, by, (along, turning, stretching) = loaded.circle, loaded.by, loaded.parts
    common, slant, way = Vector(along, 0 * along), loaded.slant, None
    if isinstance(loaded, LoadedRocker):
        draught, way, lean = loaded.draught, loaded.way, slant
        cosine, sine = way
        common = Vector(along * cosine + draught * sine, along * sine - draught * cosine)
        slant = RodDirection(lean.sine * cosine - lean.cosine * sine, lean.cosine * cosine + lean.sine * sine)
    pin = Vector(by.pin_along(circle), by.pin_across(circle))
    crank = Vector(circle.cosine, circle.sine)
    return AccelerationParts(pin, common, turning, stretching, slant, crank, loaded.masses, way)


def _pull(mass: Numeric, acceleration: Vector[Numeric]) -> Vector[Numeric]:
    """The force with X and Y that a mass asks for; no zero is to have a sign."""
    return Vector(0 - mass * acceleration.along, 0 - mass * acceleration.across)


def _sum(one: Vector[Numeric], other: Vector[Numeric]) -> Vector[Numeric]:
    return Vector(one.along + other.along, one.across + other.across)


def moving_force(
    circle: Circle[Numeric], ratio: Numeric, masses: Masses[Numeric], offset: Numeric | None = None
) -> Numeric:
    """Return H = m_B p - q cos φ (cos ψ - λ cos φ)/cos³ ψ, q being the couple m (k² - a b)/L².

    Exact. Of the offset crank the last part is q ψ̈ cos φ/(cos ψ c) in L, which has poles at the dead
    centres: there the rod turns while the crosshead rests. Floats: as close as kernel/rod.py; of the offset
    crank that times 1/|c|. Re-derived.
    """
    slant, driven = rod_slant(circle, ratio, offset), piston_acceleration(circle, ratio, offset)
    if offset is None:
        # ψ̈ and c have the zeros of sin φ in common, and (1 - λ²)/(w + λ cos φ) is w - λ cos φ.
        share = slant.cosine - ratio * circle.cosine
        turning = circle.cosine * share / (slant.cosine * slant.cosine * slant.cosine)
    else:
        swing = rod_turning(circle, ratio, *slant, offset)
        turning = swing * circle.cosine / (slant.cosine * tangential_force(circle, ratio, offset))
    return masses.crosshead * driven - masses.couple * turning
