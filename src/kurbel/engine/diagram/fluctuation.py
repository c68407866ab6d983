"""How the energy of a machine varies over a cycle in steady state, and with it the speed of its flywheel.

Torques count as the shaft turns: the torque that drives it less that of the load is the excess torque, and
its integral over the angle the excess energy, which is greatest where the speed is. Energies are in J,
torques in N m.

Of the speed the mean is given, ω = ½ (ω_max + ω_min), so that ω_max - ω_min = ΔW/(J ω) and the speed where
the excess energy is W is the root of ω_max² - 2 (W_max - W)/J, exactly. Re-derived.

A turning-moment diagram by the areas between it and the mean line, in the order in which they follow.

The points at which the diagram crosses the mean line have letters: a before the first area, b behind it, and
so on; behind the last area the diagram is at a again.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import accumulate
from string import ascii_lowercase
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from kurbel.drive.at import known
from kurbel.errors import ProblemError
from kurbel.exact.kind import Kind, balls, floats, settled
from kurbel.exact.numerals import Label, Number, figures, finite_decimals, nearest, number_text
from kurbel.kernel.circle import Numeric
from kurbel.page.axes import angle_decimals
from kurbel.page.quantity import Texts
from kurbel.reading import notation, units
from kurbel.reading.amounts import moved, unit_of_page
from kurbel.reading.given import FrozenValue
from kurbel.reading.notation import about, check_bounds
from kurbel.reading.units import Speed

if TYPE_CHECKING:
    from kurbel.engine.diagram.excess import ExcessTorque

WORDS = Texts("engine.diagram", "diagram")

# So many places are named; more go on in the same steps.
MOST_PLACES = 6
# The decimals of an angle.
PLACES = 3


class Extreme(NamedTuple):
    """Where the speed is greatest or least: the letter of a point of a diagram, or the crank angle.

    `degrees` gives it on a kind of number, None where a letter is all that is known; `exact` is the angle
    where it is a rational number of degrees.
    """

    letter: str = ""
    degrees: Callable[[Kind], Numeric] | None = None
    exact: Fraction | None = None


@dataclass(frozen=True)
class Steady:
    """A flywheel by its moment of inertia in kg m² and its mean speed, under an energy that swings."""

    swinging: Fluctuation
    inertia: Fraction
    speed: Speed

    def __post_init__(self) -> None:
        if float(self.irregularity(balls())) >= 2:
            raise ProblemError(
                f"a flywheel of J = {about(self.inertia)} kg m² comes to rest: the energy swings by more than"
                " twice J ω²; give a heavier one, or more speed"
            )

    def mean(self, kind: Kind) -> Numeric:
        """Return ω in 1/s."""
        return self.speed.omega(kind)

    def irregularity(self, kind: Kind) -> Numeric:
        """Return δ = (ω_max - ω_min)/ω = ΔW/(J ω²)."""
        mean = self.mean(kind)
        return self.swinging.swing(kind) / (kind.of(self.inertia) * mean * mean)

    def greatest(self, kind: Kind) -> Numeric:
        """Return ω_max in 1/s."""
        return self.mean(kind) + self._half(kind)

    def least(self, kind: Kind) -> Numeric:
        """Return ω_min in 1/s."""
        return self.mean(kind) - self._half(kind)

    def _half(self, kind: Kind) -> Numeric:
        return self.swinging.swing(kind) / (kind.of(2 * self.inertia) * self.mean(kind))

    def at(self, energy: Numeric, kind: Kind) -> Numeric:
        """Return ω in 1/s where the excess energy is this, in J."""
        greatest = self.greatest(kind)
        lacking = self.swinging.extreme_energy(kind, greatest=True) - energy
        return (greatest * greatest - 2 * lacking / kind.of(self.inertia)) ** 0.5


def shown(value: Callable[[Kind], Numeric]) -> str:
    """Return a number to five figures, every digit of which is meant."""
    decimals = figures(float(value(floats())))
    return number_text(Number(settled(value, decimals), decimals))


def _amount(value: Callable[[Kind], Numeric | None], symbol: str) -> Label:
    """Return the same of an amount in this unit of metric pages, with the unit of the page."""
    times, unit = unit_of_page(symbol)
    text = shown(lambda kind: known(value(kind)) * kind.of(times))
    if times == 1:
        # Every digit stays in a larger unit.
        times, unit = unit_of_page(symbol, Fraction(text))
        text = moved(text, times, exact=False)
    return f"{text} {unit}"


def outcome(
    fluctuation: Fluctuation, speed: Speed | None, steady: Steady | None, lang: str
) -> Iterator[Label]:
    """Yield what follows of a cycle: mean torque, work, swing, where the speed is greatest, the flywheel."""
    parts = []
    if fluctuation.mean_torque(floats()) is not None:
        parts.append(WORDS["mean"][lang].format(mean=_amount(fluctuation.mean_torque, "N m")))
        parts.append(WORDS["work"][lang].format(work=_amount(fluctuation.work, "J")))
    parts.append(WORDS["swing"][lang].format(swing=_amount(fluctuation.swing, "J")))
    if speed is not None and fluctuation.mean_torque(floats()) is not None:
        power = _amount(lambda kind: fluctuation.mean_torque(kind) * speed.omega(kind), "W")
        parts.append(WORDS["power"][lang].format(power=power))
    yield ", ".join(parts)
    greatest, least = (places(fluctuation.extremes(greatest=which)) for which in (True, False))
    yield WORDS["extremes"][lang].format(greatest=greatest, least=least)
    if steady is not None:
        most = shown(lambda kind: 30 * steady.greatest(kind) / kind.pi)
        low = shown(lambda kind: 30 * steady.least(kind) / kind.pi)
        delta = shown(steady.irregularity)
        yield WORDS["irregularity"][lang].format(delta=delta, most=most, least=low)


def places(extremes: Sequence[Extreme]) -> Label:
    """Return places in a row: $30°$; $150°$."""
    named = "; ".join(f"${place_text(one)}$" for one in extremes[:MOST_PLACES])
    return f"{named}; …" if len(extremes) > MOST_PLACES else named


def place_text(extreme: Extreme, most: int = PLACES, rounding: str = "half-away") -> str:
    """Return a letter, or an angle to so many decimals or as many as write it exactly."""
    if extreme.letter:
        return extreme.letter
    if extreme.exact is not None:
        decimals = finite_decimals(extreme.exact)
        number = nearest(extreme.exact, most if decimals is None else min(decimals, most), rounding)
    else:
        number = Number(settled(known(extreme.degrees), most, rounding), most)
    return f"{number_text(number)}°"


MOST_AREAS = 1000
_RADIANS = re.compile(r"(.+?)\s*rad")
_UNIT_OF_PAPER = re.compile(r"\s*1\s*(?:mm|cm|in|inch)\s*=\s*")


class Scale(NamedTuple):
    """What a unit of area stands for: `energy` in J, times π where its width is in degrees."""

    energy: Fraction
    of_pi: bool = False


@dataclass(frozen=True)
class Areas(FrozenValue):
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
        check_bounds("the scale of the areas", self.scale.energy, "be above 0", " J")

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

    def energy(self, level: Fraction, kind: Kind) -> Numeric:
        """Return what an area stands for in J."""
        joules = kind.of(level * self.scale.energy)
        return joules * kind.pi if self.scale.of_pi else joules

    def swing(self, kind: Kind) -> Numeric:
        """Return the greatest excess energy less the least, in J."""
        return self.energy(max(self.levels) - min(self.levels), kind)

    def extreme_energy(self, kind: Kind, *, greatest: bool) -> Numeric:
        """Return the greatest or the least energy in J, that at a being 0."""
        return self.energy(max(self.levels) if greatest else min(self.levels), kind)

    def mean_torque(self, kind: Kind) -> None:
        """Areas say nothing of it, nor of the work of a cycle."""

    work = mean_torque

    def extremes(self, *, greatest: bool) -> tuple[Extreme, ...]:
        """Return where the speed is greatest, or least: several points only where it is so at all of them."""
        level = max(self.levels) if greatest else min(self.levels)
        pairs = zip(self.letters, self.levels, strict=True)
        return tuple(Extreme(letter) for letter, own in pairs if own == level)


Fluctuation: TypeAlias = "Areas | ExcessTorque"
"""How the excess energy varies over a cycle, in numbers of the kind that is asked for."""


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
