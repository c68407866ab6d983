"""The values of an option that is given several: a list a;b;c, a range a..b:step, words, each by itself."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from kurbel.commands.options import TEXT, Option
from kurbel.errors import NotationError
from kurbel.exact.numerals import finite_decimals
from kurbel.reading import notation
from kurbel.reading.notation import Progression, check_length, number, plain, progression, quoted

LONGEST = 10**6
_MEASURE = re.compile(r"([-−+]?[\d.,]+(?:[eE][+-]?\d+)?(?:/\d+)?)\s*(.*)")
_RANGE = re.compile(r"(.+?)\.\.([^:]+)(?::(.+))?")


@dataclass(frozen=True, slots=True)
class Written(Sequence[str]):
    """Equally spaced numbers as one types them, with the unit of their range: 100/min, 120/min."""

    numbers: Progression
    unit: str

    def __len__(self) -> int:
        return self.numbers.size

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return Written(self.numbers[index], self.unit)
        return f"{figures(self.numbers[index])}{self.unit}"


def several(option: Option[Any], texts: Iterable[Any]) -> Sequence[Any]:
    """Return the values that the texts list, each once, as the command takes them one at a time.

    A range is never written out. Raises NotationError.
    """
    name, given = option.name, list(texts)
    if option.whole:
        return tuple(dict.fromkeys(given))
    if not all(isinstance(one, str) for one in given):
        return tuple(dict.fromkeys(given))
    if name == "ratio":
        return notation.ratios(given, LONGEST)
    if option.unit == "degrees":
        return notation.angles(given) if any(";" in one or ".." in one for one in given) else tuple(given)
    values = values_of(name, given)
    if option.kind is TEXT:
        return values
    return tuple(dict.fromkeys(option.kind.read(one, {}) for one in values))


def values_of(name: str, texts: Sequence[str]) -> Sequence[str]:
    """Return the values of lists and ranges of numbers with or without units, each once."""
    parts = [part.strip() for text in texts for part in text.split(";")]
    if len(parts) > 1 and not all(parts):
        raise NotationError(f"{name} {quoted(';'.join(texts))} has an empty place; write a list as '2;3;4'")
    parts = _in_one_unit(parts)
    if len(parts) == 1:
        return _range(parts[0], name) if ".." in parts[0] else tuple(parts)
    found: list[str] = []
    for part in parts:
        values: Sequence[str] = _range(part, name) if ".." in part else (part,)
        check_length(len(found) + len(values), LONGEST, f"values of --{name.replace('_', '-')}")
        found += values
    return tuple(dict.fromkeys(found))


def _in_one_unit(parts: list[str]) -> list[str]:
    """Return the parts with the unit that stands behind the last one alone: 100;120/min."""
    unit = parted(parts[-1])[1]
    bare = all(not parted(one)[1] and is_measured(one) for one in parts[:-1])
    if len(parts) == 1 or not bare or not unit or unit in ("%", "°") or ".." in parts[-1]:
        return parts
    return [*(f"{one}{unit}" for one in parts[:-1]), parts[-1]]


def _range(text: str, name: str) -> Written:
    """Return the values of a range, whose unit may stand at each of its parts or once: 100..140:20/min."""
    match = _RANGE.fullmatch(text)
    if match is None:
        raise NotationError(f"{name} {quoted(text)} is not a range; write it as 2..6 or 2..6:0.5")
    parts = [parted(part) for part in match.groups("1")]
    units = dict.fromkeys(unit for _, unit in parts if unit)
    if len(units) > 1:
        raise NotationError(
            f"{name} {quoted(text)} has the units {' and '.join(units)}; give its ends and its step in one"
        )
    first, last, step = (number(shown, name) for shown, _ in parts)
    return Written(progression(first, last, step, name), next(iter(units), ""))


def parted(text: str) -> tuple[str, str]:
    """Return the figures of a value, and its unit; what has no figures is all figures."""
    match = _MEASURE.fullmatch(text.strip())
    return (match[1], match[2]) if match else (text, "")


def is_measured(text: str) -> bool:
    """Whether the text begins with figures."""
    return _MEASURE.fullmatch(text) is not None


def figures(value: Fraction) -> str:
    return str(value) if finite_decimals(value) is None else plain(value)
