"""The values of axes as floats, in which unit, and in which rows they stand: the coordinates of a file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from kurbel.commands.options import TEXT, Option
from kurbel.commands.sliders import SpacedValues, parted
from kurbel.drive.size import is_written
from kurbel.errors import KurbelError, NotationError
from kurbel.motion.bulk import float_angles
from kurbel.reading import notation, units
from kurbel.reading.amounts import known_unit, plain_unit
from kurbel.reading.given import as_fraction, as_share
from kurbel.reading.notation import Progression
from kurbel.sweeps.plan import Axis, Cell, Floats, Places, Plan, Points, text_of

# Units of the SI by their powers of metre, kilogram and second.
SI: Mapping[tuple[int, ...], str] = {
    known.powers: one.unit.replace("**2", "²").replace("**3", "³").replace("*", " ")
    for one in vars(units).values()
    if isinstance(one, units.Measure) and (known := known_unit(one.unit))
}
TURNS = "1/s"
# 1/(2π), of which a float is rounded once.
TURN_OF_RADIAN = Fraction("0.159154943091895335768883763372514362034459645740456448747667")

# Of larger numbers a float has none in some unit.
LARGEST = 10**300


def measured(
    parameter: Option[object], values: Sequence[object], unit: str = ""
) -> tuple[Sequence[Fraction], Fraction | int, str] | None:
    """Return exact numbers, what they are to be multiplied by and their unit, nothing for what are no
    numbers.

    They are in the unit of the SI, or in this one. Of a range the numbers are never written out. Raises
    NotationError for one that no float holds.
    """
    found = _in_si(parameter, values)
    if found is None:
        return None
    numbers, factor, si = found
    # Of a range the largest is at an end.
    farthest = (numbers[0], numbers[-1]) if isinstance(numbers, Progression) else numbers
    if any(abs(one) * factor > LARGEST for one in farthest):
        raise NotationError(f"{parameter.flag} goes beyond 10^300, which no column holds")
    return found if unit in ("", si) else (numbers, factor * (into(si, unit) or 1), unit)


def into(si: str, unit: str) -> Fraction | None:
    """Return what a unit of the SI is in another, None where they measure different things."""
    plain = plain_unit(unit) or unit
    if si == unit:
        return Fraction(1)
    if si == TURNS and plain in units.TURNS:
        return 1 / units.TURNS[plain]
    if not si and unit == "%":
        return Fraction(100)
    return units.known_in(si, unit)


def _in_si(
    parameter: Option[object], values: Sequence[Any]
) -> tuple[Sequence[Fraction], Fraction | int, str] | None:
    if parameter.kind is not TEXT:
        return None
    if isinstance(values, Progression):
        return values, 1, _own(parameter)
    if isinstance(values, SpacedValues):
        factor, unit = _factor(values.unit, parameter)
        return (values.numbers, factor, unit) if factor else None
    if all(type(one) is Fraction for one in values):
        return values, 1, _own(parameter)
    found = [_value(parameter, one) for one in values]
    known = {one[1] for one in found if one is not None}
    if None in found or len(known) != 1:
        return None
    return [one[0] for one in found if one is not None], 1, known.pop()


def _value(parameter: Option[object], given: object) -> tuple[Fraction, str] | None:
    if isinstance(given, bool):
        return None
    if not isinstance(given, str):
        return as_fraction(given), _own(parameter)
    try:
        if parameter.unit == "degrees":
            return notation.angle(given), "°"
        if ":" in given or "∶" in given:
            return notation.ratio(given), ""
        if given.strip().endswith("%"):
            return as_share(given), ""
        if not units.is_measure(given):
            return notation.number(given), _own(parameter)
        shown, unit = units.split(given)
        factor, si = _factor(unit, parameter)
        return (shown * factor, si) if factor else None
    except KurbelError:
        return None


def _own(parameter: Option[object]) -> str:
    """Return the unit of a bare number."""
    return {"degrees": "°", "turns a second": TURNS}.get(parameter.unit, parameter.unit)


def _factor(unit: str, parameter: Option[object]) -> tuple[Fraction | int, str]:
    """Return what the unit is in that of the SI, and this one; 0 for one that is not known."""
    if not unit:
        return 1, _own(parameter)
    if unit == "%":
        return Fraction(1, 100), ""
    if unit == "°":
        return 1, "°"
    plain = plain_unit(unit) or unit
    if plain in units.TURNS:
        return units.TURNS[plain], TURNS
    if plain == units.RADIANS:
        return TURN_OF_RADIAN, TURNS
    if plain == f"{units.RADIANS}/s":
        return 1, "rad/s²"
    known = known_unit(unit)
    return (known.size, SI[known.powers]) if known and known.powers in SI else (0, "")


def is_readable(parameter: Option[object], text: str) -> bool:
    """Whether a text that is to be a number may be one: it begins with figures."""
    return is_written(text) or parted(text)[0] != text or _value(parameter, text) is not None


def exact_at(plan: Plan, axis: Axis, place: int) -> Fraction | str:
    """Return the value of an axis at a place as an exact number, or as text."""
    found = measured(plan.asking.options[axis.option], axis.values[place : place + 1])
    return text_of(axis.values[place]) if found is None else found[0][0] * found[1]


# Shorter runs of equal values cost more than a division.
LEAST_RUN = 64


@dataclass(frozen=True)
class Coordinates:
    """The axes of a plan, as columns have them: in units by their options, or in those of the SI."""

    plan: Plan
    units: Mapping[str, str] = field(default_factory=dict)

    def at(self, points: Points) -> Mapping[str, Any]:
        """Return the values of each axis at these points: an array of floats, or a list of texts."""
        last = len(self.plan.groups) - 1
        found: dict[str, Cell] = {}
        repeated, places = 1, points.places
        for number in range(last, -1, -1):
            group, size = self.plan.groups[number], self.plan.sizes[number]
            runs = points.first is not None and repeated >= LEAST_RUN
            if runs and points.first is not None:
                for axis in group:
                    found[axis.option] = self._in_runs(axis, points.first, len(points), repeated)
            else:
                own = (places // repeated) % size if repeated > 1 else places % size
                for axis in group:
                    found[axis.option] = self._known[axis.option].at(own)
            repeated *= size
        return found

    def _in_runs(self, axis: Axis, start: int, count: int, repeated: int) -> Cell:
        """Return the values of an axis on which so many rows stand at each place."""
        first, last = start // repeated, (start + count - 1) // repeated + 1
        places = np.arange(first, last) % len(axis.values)
        lengths = np.full(last - first, repeated)
        lengths[0] -= start - first * repeated
        lengths[-1] -= last * repeated - (start + count)
        values = self._known[axis.option].at(places)
        if isinstance(values, list):
            return np.repeat(np.array(values, object), lengths).tolist()
        return np.repeat(values, lengths)

    @cached_property
    def _known(self) -> Mapping[str, _Values]:
        units = self.units
        return {
            name: _Values.of(self.plan, axis, units.get(name, "")) for name, axis in self.plan.axes.items()
        }


def values_at(plan: Plan, axis: Axis, places: Places, unit: str = "") -> Cell:
    """Return the values of an axis at these places, in this unit or that of the SI: an array of floats, or a
    list of texts."""
    return _Values.of(plan, axis, unit).at(places)


@dataclass(frozen=True)
class _Values:
    """The values of an axis: of a range they are made where they are wanted."""

    # A range, or an array of floats; None of texts.
    numbers: Progression | Floats | None
    factor: Fraction | int
    texts: Sequence[object]

    @classmethod
    def of(cls, plan: Plan, axis: Axis, unit: str) -> _Values:
        found = measured(plan.asking.options[axis.option], axis.values, unit)
        if found is None:
            return cls(None, 1, axis.values)
        numbers, factor, _ = found
        if isinstance(numbers, Progression):
            return cls(numbers, factor, ())
        exact = numbers if factor == 1 else [one * factor for one in numbers]
        return cls(np.array([float(one) for one in exact]), factor, ())

    def at(self, places: Places) -> Cell:
        """Return the values at these places."""
        if self.numbers is None:
            return [text_of(self.texts[place]) for place in places.tolist()]
        if not isinstance(self.numbers, Progression):
            return self.numbers[places]
        first, last = int(places.min()), int(places.max()) + 1
        within = self.numbers[first:last]
        if self.factor != 1:
            # One number each, not the product of two roundings.
            return np.array([float(one * self.factor) for one in within])[places - first]
        return float_angles(within)[places - first]
