"""What can act on a crank drive: the loads by their names, a force on the piston, and what steam is asked.

What acts on piston and crosshead beside a given force: pressures on both sides, friction; checked once.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import ClassVar, NamedTuple, Protocol

from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label
from kurbel.exact.numerals import figure as figure
from kurbel.kernel.circle import Numeric, root
from kurbel.kernel.forces import Circles, Stroke
from kurbel.reading.amounts import amount
from kurbel.reading.given import as_signed_force, found_at
from kurbel.reading.notation import about, check_bounds

LARGEST_FORCE = 10**12
AGAINST = {"de": ", gegen die Richtung des Hubes", "en": ", against the direction of the stroke"}
FORCE, MASSES, STEAM, CARD = "force", "masses", "steam", "card"
COMPRESSOR, PUMP, GAS = "compressor", "pump", "gas"


class Registered(NamedTuple):
    """What sentences call a load; of one that --force describes, the class that reads it, and how it is
    written."""

    title: str
    place: str = ""
    example: str = ""


LOADS: Mapping[str, Registered] = {
    FORCE: Registered("a constant force", "kurbel.drive.load:PistonForce", "10kN"),
    MASSES: Registered("moving masses"),
    STEAM: Registered("steam"),
    CARD: Registered("an indicator card"),
    COMPRESSOR: Registered("a compressor"),
    PUMP: Registered("a pump"),
    GAS: Registered("the cycle of a gas engine"),
    # Another load is one more line here.
}


class PlaceOnStroke(Protocol):
    """A place on a stroke: the share of it that the piston has gone, on a kind of number."""

    @property
    def share(self) -> Numeric: ...
    @property
    def numbers(self) -> Kind: ...


@dataclass(frozen=True)
class PistonForce:
    """A force on the piston in newtons, in the direction of the stroke, below 0 against it, on the outstroke
    a pull: by itself a constant one.

    Of another load `first` is the force where a stroke begins.
    """

    name: ClassVar[str] = FORCE

    first: Fraction

    def __post_init__(self) -> None:
        if not 0 < abs(self.first) <= LARGEST_FORCE:
            raise ProblemError(
                f"the piston force is {about(self.first)} N; it is above 0 or, against the direction of"
                " the stroke, below it, and at most 10^12 N"
            )

    @classmethod
    def read(cls, given: object) -> PistonForce | None:
        """Return the load that is written so, None if none of these is."""
        return cls(as_signed_force(given, "force"))

    def relative(self, place: PlaceOnStroke) -> Numeric | None:
        """Return the force at a place as a multiple of the first, on its kind of number; None for one."""
        return None

    @property
    def growth(self) -> Fraction:
        """A bound of that multiple and of its slope over the share, together."""
        return Fraction(1)

    def note(self, lang: str) -> Label:
        """Return the line that pages have below their tables."""
        against = AGAINST[lang] if self.first < 0 else ""
        return f"$F = {amount(self.first, 'N')}${against}"


def read_force(given: object) -> PistonForce:
    """Return the load that --force describes: the one registered last that is written so."""
    found = (one.read(given) for one in reversed([*piston_forces()]))
    return next(one for one in found if one is not None)


def examples() -> str:
    """Return how these are written."""
    return ", ".join(one.example for one in LOADS.values() if one.example)


def piston_forces() -> Iterator[type[PistonForce]]:
    """Return the loads that --force describes."""
    return (found_at(entry.place) for entry in LOADS.values() if entry.place)


class Load(Protocol):
    """What drives the piston of an engine or resists it, on any kind of number: nothing is asked of it but
    its force at a share of the stroke, and the work that it has done there.
    """

    @property
    def name(self) -> str:
        """What it is: a key of LOADS."""
        ...

    @property
    def driven(self) -> bool:
        """Whether the shaft drives the piston, as in compressors and pumps; of a card its work says so."""
        ...

    def strokes(self, kind: Kind, double: bool) -> Sequence[Stroke]:
        """Return the strokes of a cycle, two or four, beginning with an outstroke; of a cylinder that is not
        `double` one end works, and of steam the return idles."""
        ...


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
