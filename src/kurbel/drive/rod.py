"""The moving masses of a crank drive, checked once: the rod, by its centre of mass or sections; the rest."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import NamedTuple

from kurbel.drive.at import Weights
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.kernel.circle import Numeric, Same
from kurbel.kernel.forces import Weight
from kurbel.kernel.moving import Masses, joined, rod_masses, two_masses
from kurbel.reading.amounts import STANDARD_GRAVITY
from kurbel.reading.notation import about, check_bounds

VERTICAL = Fraction(90)
STEEPEST = 180
GREATEST_GRAVITY = 1000


@dataclass(frozen=True, slots=True)
class Slope:
    """By how many degrees the slide rises from the shaft to the cylinder, in the sense of rotation, and g in
    m/s²: 90 is a cylinder above the shaft, -90 one below it. At 0 it lies, and the crank pin passes above
    the shaft on the outstroke, beyond 90 and -90 below it.
    """

    angle: Fraction
    gravity: Fraction = STANDARD_GRAVITY

    def __post_init__(self) -> None:
        check_bounds(
            "the slope", self.angle,
            "lie within -180..180, for 90 is a cylinder above the shaft and -90 one below it", "°",
        )  # fmt: skip
        check_bounds("gravity", self.gravity, "be above 0 and at most 1000, on earth 9.80665", " m/s²")

    @property
    def upright(self) -> bool:
        """Whether no weight acts across the slide."""
        return abs(self.angle) == VERTICAL

    @property
    def over(self) -> bool:
        """Whether the crank pin passes above the shaft on the outstroke."""
        return abs(self.angle) < VERTICAL

    def weight(
        self, kind: Kind, pin: Fraction, crosshead: Fraction, reciprocating: Fraction
    ) -> Weight[Numeric]:
        """Return what masses in kg weigh in newtons, on a kind of number."""
        circle = kind.circle(self.angle)
        at_pin, at_end, own = (kind.of(self.gravity * mass) for mass in (pin, crosshead, reciprocating))
        return Weight(at_pin, at_end, own, circle.sine, circle.cosine)


# Sections end within half a rod's length of its pins.
REACH = Fraction(1, 2)
# The ends about which it may swing, in L from the crosshead pin.
PINS = {"crosshead": Fraction(0), "crank": Fraction(1)}
# The share of the rod that railway engineers count as reciprocating.
RAILWAY_CROSSHEAD = Fraction(4, 10)


class Swing(NamedTuple):
    """How the radius of gyration was found: the time in s of a full swing about a point, in L from the
    crosshead pin, and g in m/s²."""

    time: Fraction
    place: Fraction
    gravity: Fraction


@dataclass(frozen=True, slots=True)
class Rod:
    """A rod by its centre of mass, a/L from the crank pin, its k²/L² about it, and its mass in kg if known.

    k² and not k is kept, for of fractions it is a fraction. The centre lies on the line between the pins,
    0 <= a <= L. k² above a (L - a) is for rods that reach beyond their pins or far to the side; valid up to
    that of two masses half a length beyond the pins. Of `swings` k², and of two of them a, are
    transcendental; the fractions are near them to more places than are ever printed.
    """

    centre: Fraction
    gyration_square: Fraction
    mass: Fraction | None = None
    swings: tuple[Swing, ...] = ()

    def __post_init__(self) -> None:
        check_bounds(
            "the rod's centre of mass", self.centre,
            "lie within 0..1, between the pins, for no rod has most of its mass beyond one",
            " L from the crank pin",
        )  # fmt: skip
        check_bounds(
            "the rod's k²", self.gyration_square,
            "be above 0, for no rod has all its mass in one point", " L²",
        )  # fmt: skip
        if self.gyration_square > self._greatest_square():
            raise ProblemError(
                f"the rod's k² is {about(self.gyration_square)} L²; with the centre of mass"
                f" {about(self.centre)} L from the crank pin it must be at most"
                f" {about(self._greatest_square())} L², for no rod reaches half its length beyond both pins"
            )
        check_bounds("the rod's mass", self.mass, "be above 0 and at most 10^9 kg", " kg")

    @classmethod
    def from_crosshead(cls, centre: Fraction, gyration: Fraction, mass: Fraction | None = None) -> Rod:
        """Return the rod with this a/L and k/L, a counted from the crosshead pin as Ensslin does."""
        check_centre(centre)
        check_bounds(
            "the rod's radius of gyration k", gyration,
            "be above 0, for no rod has all its mass in one point", " L",
        )  # fmt: skip
        return cls(1 - centre, gyration * gyration, mass)

    @property
    def couple(self) -> Fraction:
        """(k² - a b)/L²: 0 if two masses replace the rod exactly, below 0 for rods between their pins."""
        return self.gyration_square - self.centre * (1 - self.centre)

    def masses(self, model: str, of: Callable[[Fraction], Same]) -> Masses[Same]:
        """Return the masses that a model puts for a rod of mass 1, on the kind of number that `of` makes."""
        return Masses(*(of(Fraction(part)) for part in MODELS[model](self)))

    def _greatest_square(self) -> Fraction:
        return (self.centre + REACH) * (1 - self.centre + REACH)


def check_centre(centre: Fraction) -> None:
    """Raise ProblemError where a centre of mass, in L from the crosshead pin, lies beyond a pin."""
    check_bounds(
        "the rod's centre of mass", centre,
        "lie within 0..1, between the pins, for no rod has most of its mass beyond one",
        " L from the crosshead pin",
    )  # fmt: skip


# The rod itself, and the two masses that stand in for it.
MODELS: Mapping[str, Callable[[Rod], Masses[Fraction]]] = {
    "exact": lambda rod: rod_masses(rod.centre, rod.gyration_square),
    "two-mass": lambda rod: two_masses(rod.centre),
    "railway": lambda rod: two_masses(RAILWAY_CROSSHEAD),
}


class Section(NamedTuple):
    """A mass spread evenly from `start` to `end`, both in L from the crank pin; a point if they agree."""

    start: Fraction
    end: Fraction
    mass: Fraction


def rod_of_sections(sections: Sequence[Section], kilograms: bool = False) -> Rod:
    """Return the rod made of sections; the masses are in kg or else shares, of which it has no mass."""
    for section in sections:
        check_section(section)
    places = len({end for section in sections for end in section[:2]})
    if places < 2:
        raise ProblemError(
            f"masses are given at {places} of the rod's places; at least 2 are needed, from pin to pin"
        )
    mass, first, second = (sum(moments) for moments in zip(*map(_moments, sections), strict=True))
    centre = first / mass
    return Rod(centre, second / mass - centre * centre, mass if kilograms else None)


def _moments(section: Section) -> tuple[Fraction, Fraction, Fraction]:
    """Return the mass, its first and its second moment about the crank pin."""
    middle, span = (section.start + section.end) / 2, section.end - section.start
    return section.mass, section.mass * middle, section.mass * (middle * middle + span * span / 12)


def check_section(section: Section) -> None:
    """Raise ProblemError for a section that no rod has."""
    for position in section[:2]:
        if not -REACH <= position <= 1 + REACH:
            raise ProblemError(
                f"position {about(position)} L is outside -0.5..1.5; positions count from the crank pin,"
                " and no rod reaches farther than half its length beyond a pin"
            )
    if section.end < section.start:
        raise ProblemError(
            f"the section runs from {about(section.start)} L to {about(section.end)} L;"
            " its end must not lie before its start"
        )
    if section.mass <= 0:
        raise ProblemError(f"mass {about(section.mass)} must be above 0, for no part of a rod weighs nothing")


@dataclass(frozen=True)
class MovingMasses:
    """The moving masses of one crank drive in kg: piston and crosshead, the rod, and `rotating`, the crank's
    own at its pin, which is negative where counterweights outweigh it. `rocker` is the moment of inertia of a
    rocker about its pivot, in kg m², and `arm` its length in metres. What piston, crosshead and rod weigh
    counts where the `slope` of the slide is known.
    """

    reciprocating: Fraction
    rod: Rod | None = None
    rotating: Fraction = Fraction(0)
    rocker: Fraction = Fraction(0)
    arm: Fraction | None = None
    slope: Slope | None = None

    def __post_init__(self) -> None:
        check_bounds("the rocker's moment of inertia", self.rocker, "lie within 0..10^9 kg m²", " kg m²")
        check_bounds("the reciprocating mass", self.reciprocating, "lie within 0..10^9 kg", " kg")
        if self.rod is not None and self.rod.mass is None:
            raise ProblemError("the rod's masses are shares; add its mass in kg, --rod-mass")
        check_bounds("the rotating mass", self.rotating, "lie within -10^9..10^9 kg", " kg")

    @cached_property
    def joined(self) -> Masses[Fraction]:
        """The masses of rod and reciprocating parts, and of a rocker at its end, in kg."""
        end = self.rocker / self.arm**2 if self.arm else Fraction(0)
        if self.rod is None:
            return Masses(Fraction(0), self.reciprocating, Fraction(0), end)
        own = joined(self.rod.masses("exact", Fraction), self.rod.mass or Fraction(0), self.reciprocating)
        return own._replace(rocker=end)

    def weights(self, kind: Kind, factor: Numeric, newton: Numeric = 1) -> Weights:
        """Return the masses times a factor, in a kind of number, and their weight, if that counts, times
        that of a newton."""
        of, joined = kind.of, self.joined
        masses = Masses(*(of(Fraction(part)) * factor for part in joined))
        found = Weights(masses, of(self.reciprocating) * factor, of(self.rotating) * factor)
        if self.slope is None:
            return found
        pin, crosshead, own, *slope = self.slope.weight(
            kind, joined.pin, joined.crosshead, self.reciprocating
        )
        return found._replace(weight=Weight(pin * newton, crosshead * newton, own * newton, *slope))
