"""A turning-moment diagram by the areas between it and the mean line, in the order in which they follow.

The points at which the diagram crosses the mean line have letters: a before the first area, b behind it, and
so on; behind the last area the diagram is at a again.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import accumulate
from string import ascii_lowercase
from typing import Any, NamedTuple

from kurbel.engine.diagram.fluctuation import Extreme
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind
from kurbel.kernel.circle import Numeric
from kurbel.page.axes import angle_decimals
from kurbel.reading import notation, units
from kurbel.reading.given import Given
from kurbel.reading.notation import about

MOST_AREAS = 1000
_RADIANS = re.compile(r"(.+?)\s*rad")
_UNIT_OF_PAPER = re.compile(r"\s*1\s*(?:mm|cm|in|inch)\s*=\s*")


class Scale(NamedTuple):
    """What a unit of area stands for: `energy` in J, times π where its width is in degrees."""

    energy: Fraction
    of_pi: bool = False


@dataclass(frozen=True)
class Areas(Given):
    """The signed areas of a cycle, above the mean line positive, and their scale; `turns` of the cycle where
    they are known. They are `measured` where they are energies themselves."""

    areas: tuple[Fraction, ...]
    scale: Scale
    turns: Fraction | None
    measured: bool

    def __post_init__(self) -> None:
        if len(self.areas) < 2:
            raise ProblemError(
                "a diagram has at least two areas, one above and one below its mean line; write them as"
                " --areas '+52;-124;+72'"
            )
        if len(self.areas) > MOST_AREAS:
            raise ProblemError(f"{len(self.areas)} areas were given; at most {MOST_AREAS} are allowed")
        above = sum(self.areas)
        if above:
            raise ProblemError(
                f"the areas sum to {about(above)}; above and below the mean line of a cycle they must be"
                " equal, or the line is not that of the mean"
            )
        if not any(self.areas):
            raise ProblemError("all areas are 0; the torque never leaves its mean")
        if self.scale.energy <= 0:
            raise ProblemError(f"the scale of the areas is {about(self.scale.energy)} J; it must be above 0")

    @cached_property
    def levels(self) -> tuple[Fraction, ...]:
        """What of the area is above the line at each letter, a with 0 first; without the end, which is a."""
        return (Fraction(0), *accumulate(self.areas[:-1]))

    @cached_property
    def level_decimals(self) -> int | None:
        """How many decimals write every level exactly, None if no number of them does."""
        return angle_decimals(self.levels)

    @property
    def letters(self) -> tuple[str, ...]:
        return tuple(letter_of(number) for number in range(len(self.levels)))

    def energy(self, level: Fraction, kind: Kind) -> Any:
        """Return what an area stands for in J."""
        joules = kind.of(level * self.scale.energy)
        return joules * kind.pi if self.scale.of_pi else joules

    def swing(self, kind: Kind) -> Any:
        return self.energy(max(self.levels) - min(self.levels), kind)

    def extreme_energy(self, kind: Kind, *, greatest: bool) -> Numeric:
        """Return the greatest or the least energy in J, that at a being 0."""
        return self.energy(max(self.levels) if greatest else min(self.levels), kind)

    def mean_torque(self, kind: Kind) -> None:
        return None

    def work(self, kind: Kind) -> None:
        return None

    def extremes(self, *, greatest: bool) -> tuple[Extreme, ...]:
        level = max(self.levels) if greatest else min(self.levels)
        pairs = zip(self.letters, self.levels, strict=True)
        return tuple(Extreme(letter) for letter, own in pairs if own == level)


def letter_of(number: int) -> str:
    """Return the letter of a point by its number from 0: a, b, ..., z, a₁, b₁."""
    # In a formula aa would be a function.
    times, place = divmod(number, len(ascii_lowercase))
    return f"{ascii_lowercase[place]}_{times}" if times else ascii_lowercase[place]


def given_areas(areas: Sequence[str], scale: str | None, turns: Fraction | None) -> Areas:
    """Return the areas of texts, as `scaled_areas` reads them."""
    found, own, measured = scaled_areas(areas, scale)
    return Areas(found, own, turns, measured)


def scaled_areas(
    areas: Sequence[str], scale: str | None = None, what: str = "areas"
) -> tuple[tuple[Fraction, ...], Scale, bool]:
    """Return the areas of texts such as "+52;-124;+72", with the scale of a text such as "52.36J" or
    "500 N m; 6°", and whether they are energies; without a scale they have their unit: "+52J;-124J;+72J"."""
    if scale is not None:
        return notation.each_number(areas, "area"), read_scale(scale), False
    parts = [part.strip() for text in areas for part in text.split(";")]
    if any(not any(map(str.isalpha, part)) for part in parts):
        raise ProblemError(
            f"the {what} have no scale; add the energy of a unit of area, --area-scale 52.36J, or the"
            " scales of torque and angle, --area-scale '500 N m; 6°', or write their unit: '+52J;-124J;+72J'"
        )
    return tuple(units.energy(part, "area") for part in parts), Scale(Fraction(1)), True


def read_scale(text: str) -> Scale:
    """Return the scale of "52.36J", or of a torque and an angle for the units of length, "500 N m; 6°"."""
    parts = [_UNIT_OF_PAPER.sub("", part) for part in text.split(";")]
    if len(parts) == 1:
        return Scale(units.energy(parts[0], "scale of the areas"))
    if len(parts) > 2:
        raise ProblemError(
            f'the scale of the areas "{text[:40]}" has {len(parts)} parts; write an energy, 52.36J, or a'
            " torque and an angle, '500 N m; 6°'"
        )
    torque = units.signed_torque(parts[0], "scale of the torque")
    if radians := _RADIANS.fullmatch(parts[1].strip()):
        return Scale(torque * notation.number(radians[1], "scale of the angle"))
    return Scale(torque * notation.angle(parts[1], "scale of the angle") / 180, of_pi=True)
