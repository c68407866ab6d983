"""What can act on a crank drive: the loads by their names, and a force on the piston."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, ClassVar, NamedTuple, Protocol

from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.exact.numerals import Label
from kurbel.kernel.circle import Numeric
from kurbel.reading.amounts import amount
from kurbel.reading.given import as_signed_force, found_at
from kurbel.reading.notation import about

if TYPE_CHECKING:
    from kurbel.kernel.law import Stroke

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
