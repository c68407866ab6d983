"""What acts on a crank drive beside a given force, checked once: pressures, friction, and on the shaft."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.kernel.circle import Numeric, root
from kurbel.kernel.forces import Circles
from kurbel.reading.notation import about, check_bounds

HIGHEST = 10**12


@dataclass(frozen=True, slots=True)
class Areas:
    """The bore of a cylinder, the diameter of the piston rod, towards the crank, and that of a tail rod,
    through the cover, in metres; 0 where there is none."""

    bore: Fraction
    rod: Fraction = Fraction(0)
    tail: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        check_bounds("the bore", self.bore, "be above 0", " m")
        for name, diameter in (("piston rod", self.rod), ("tail rod", self.tail)):
            if not 0 <= diameter < self.bore:
                raise ProblemError(
                    f"the {name} has a diameter of {about(diameter)} m; it must be below the bore,"
                    f" {about(self.bore)} m"
                )

    @property
    def head(self) -> Fraction:
        """The piston's area on the side of the cover as a share of the bore's."""
        return 1 - (self.tail / self.bore) ** 2

    @property
    def crank(self) -> Fraction:
        """The same on the side of the crank."""
        return 1 - (self.rod / self.bore) ** 2


@dataclass(frozen=True, slots=True)
class Pressures:
    """The pressures in Pa on the piston's side of the cover and of the crank, above the surroundings: these
    press on the rods from outside."""

    areas: Areas
    head: Fraction = Fraction(0)
    crank: Fraction = Fraction(0)
    # Whether only their difference is known.
    difference: bool = False

    def __post_init__(self) -> None:
        for pressure in (self.head, self.crank):
            if abs(pressure) > HIGHEST:
                raise ProblemError(f"the pressure is {about(pressure)} Pa; it must be at most 10^12 Pa")

    @property
    def rational(self) -> Fraction:
        """The force towards the crank in newtons, but for the factor π."""
        area = self.areas.bore**2 / 4
        return area * (self.head * self.areas.head - self.crank * self.areas.crank)

    def force(self, kind: Kind) -> Numeric:
        """Return that force."""
        return kind.of(self.rational) * kind.pi


@dataclass(frozen=True, slots=True)
class Pins:
    """The coefficient of friction of the pins, and the diameters in metres of crosshead pin, crank pin and
    shaft; 0 where there is no friction."""

    friction: Fraction
    crosshead: Fraction = Fraction(0)
    crank: Fraction = Fraction(0)
    shaft: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        check_bounds("the coefficient of friction of the pins", self.friction, "lie within 0..1")

    def check(self, radius: Fraction, ratio: Fraction) -> None:
        """Raise ProblemError for pins in which a crank of this radius in metres is stuck."""
        reach = self.friction * (self.crosshead + self.crank) / 2
        if reach * ratio >= radius:
            raise ProblemError(
                "the circles of friction of crosshead pin and crank pin are together as large as the rod is"
                " long; give smaller diameters"
            )

    def circles(self, kind: Kind, radius: Fraction) -> Circles[Numeric]:
        """Return the radii of the circles of friction in crank radii, on a kind of number."""
        # r sin ρ of μ = tan ρ.
        share = kind.of(self.friction / (2 * radius)) / root(kind.of(1 + self.friction**2))
        crosshead, crank, shaft = (kind.of(one) * share for one in (self.crosshead, self.crank, self.shaft))
        return Circles(crosshead, crank, shaft)


@dataclass(frozen=True, slots=True)
class Shaft:
    """What the torque accelerates: the moment of inertia in kg m² of what turns with the shaft, and the power
    in watts that is taken off it."""

    inertia: Fraction
    power: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        check_bounds("the moment of inertia", self.inertia, "be above 0 and at most 10^12 kg m²", " kg m²")


@dataclass(frozen=True, slots=True)
class Effort:
    """Pressures on the piston, and the friction of piston and crosshead in newtons, against their motion; the
    areas on which the load of an engine acts, if rods lessen them; the friction of the pins; the shaft."""

    pressures: Pressures | None = None
    friction: Fraction = Fraction(0)
    areas: Areas | None = None
    pins: Pins | None = None
    shaft: Shaft | None = None

    def __post_init__(self) -> None:
        check_bounds(
            "the friction", self.friction, "lie within 0..10^12 N, for it acts against the motion", " N"
        )

    @property
    def greatest(self) -> Fraction:
        """A bound of the force in newtons."""
        return self.friction + (4 * abs(self.pressures.rational) if self.pressures else 0)
