"""The indicator card of a steam engine, from a CSV file: the pressures in one end of the cylinder.

    # comment
    position [%];p_forward [bar];p_return [bar]
    0;8,1;1,2
    0,5;8,1;1,15
    ...
    100;2,4;1,1

`position` is the share of the stroke from the dead centre of this end, 0 to 1 or 0 % to 100 %, rising.
`p_forward` is the pressure while the piston goes away from that dead centre, `p_return` while it comes back.
Both are measured from one zero, vacuum or atmosphere.

The pressures have a unit that pint knows (extra `units`), such as bar, kPa, MPa, psi, atm, at, kp/cm², N/mm²:
in the head, as `p_forward [bar]`, `p_forward (bar)`, `p_forward/bar`, `p_forward in bar` or `p_forward bar`,
or behind each value, as `8,1 bar`. `position` may have %. Columns are in any order, more of them are ignored.
Semicolons, tabs or commas part them; a decimal comma is read where commas do not part. Empty lines, comments
(#), quotes, BOM and CRLF are allowed.
"""

from __future__ import annotations

import csv
import math
import os
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

from kurbel.card_lines import place, said_lines, shown
from kurbel.choices import did_you_mean
from kurbel.errors import CardError, NotationError

LEAST_POINTS = 8
# Nearer points are one point: a pressure that jumps is no function of the position.
LEAST_STEP = 1e-9
LARGEST_PRESSURE = 1e12
# Forces are counted in the greatest p_forward.
LEAST_ADMISSION = 1.0

_HEAD = re.compile(
    r"(?P<name>\w+)\s*(?:\[(?P<square>[^\]]*)\]|/?\s*\((?P<round>[^)]*)\)|(?:/|\bin\b)?(?P<bare>.*))"
)
_VALUE = re.compile(r"([+−-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d{1,3})?)\s*([A-Za-zµ%].*)?", re.ASCII)
_DELIMITERS = ";\t,"
_WORD = r"([A-Za-zµ]+)(?:\^|\*\*)?([2²]?)"
_UNIT = re.compile(rf"{_WORD}(?:\s*[/·*]\s*{_WORD})*")
# As engineers wrote it, the kg of a pressure is a force; pint's is a mass, and it knows no kp.
_FORCES = {"kp": "kgf", "kg": "kgf", "lb": "lbf", "lbs": "lbf"}
_PRESSURES = ("bar", "mbar", "Pa", "hPa", "kPa", "MPa", "psi", "atm", "at")
_EXAMPLES = "bar, kPa, MPa, psi, atm, at or kp/cm²"
_SHARES = {"": 1.0, "1": 1.0, "-": 1.0, "%": 0.01}


@dataclass(frozen=True, slots=True)
class Card:
    """Pressures in Pa at rising positions 0 to 1, on the way from the dead centre of this end and back to it.

    `name` and `lines` say where the points stand, for messages; `resolution` in Pa is the unit of the last
    place to which the pressures are written. Valid for pressures within ±10^12 Pa, may they be above vacuum
    or above the atmosphere, of which the greatest p_forward is at least 1 Pa.
    """

    positions: tuple[float, ...]
    forward: tuple[float, ...]
    back: tuple[float, ...]
    name: str = "the card"
    lines: tuple[int, ...] = ()
    resolution: float = 0.0

    def __post_init__(self) -> None:
        for index, position in enumerate(self.positions):
            if not 0 <= position <= 1:
                raise CardError(
                    f"{self._place(index)}: position {position:.10g} is outside 0..1;"
                    " it is a share of the stroke, write percent as position [%]"
                )
        self._check_order()
        self._check_ends()
        self._check_pressures()

    @property
    def admission(self) -> float:
        """The greatest p_forward in Pa, which the forces are counted in."""
        return max(self.forward)

    def halves(self) -> tuple[Card, Card]:
        """Return the card of its even and that of its odd points, both with both ends."""
        last = len(self.positions) - 1
        return self._only({0, last, *range(0, last, 2)}), self._only({0, last, *range(1, last, 2)})

    def _only(self, points: set[int]) -> Card:
        kept = sorted(points)
        columns = (self.positions, self.forward, self.back)
        positions, forward, back = (tuple(column[index] for index in kept) for column in columns)
        lines = tuple(self.lines[index] for index in kept if self.lines)
        return Card(positions, forward, back, self.name, lines, self.resolution)

    def _check_order(self) -> None:
        for index, (before, after) in enumerate(pairwise(self.positions), 1):
            if after < before:
                raise CardError(
                    f"{self._place(index)}: position {after:.10g} comes after {before:.10g}, but positions"
                    " must rise; give a closed curve, out and back, as p_forward and p_return side by side"
                )
            if after - before < LEAST_STEP:
                raise CardError(
                    f"{self._place(index)}: position {after:.10g} is repeated; a card has one p_forward and"
                    " one p_return a position, so a sudden change needs two positions close together"
                )

    def _check_ends(self) -> None:
        if not self.positions or (self.positions[0], self.positions[-1]) != (0, 1):
            covered = f"{self.positions[0]:.10g}..{self.positions[-1]:.10g}" if self.positions else "nothing"
            raise CardError(
                f"{self.name}: the positions cover {covered}; they must cover 0..1, the whole stroke"
            )

    def _check_pressures(self) -> None:
        for what, column in (("p_forward", self.forward), ("p_return", self.back)):
            for index, pressure in enumerate(column):
                if not abs(pressure) <= LARGEST_PRESSURE:
                    raise CardError(
                        f"{self._place(index)}: {what} is {pressure:.6g} Pa; no card goes beyond 10^12 Pa"
                    )
        if self.admission < LEAST_ADMISSION:
            raise CardError(
                f"{self.name}: the greatest p_forward is {self.admission:.6g} Pa; it must be at least 1 Pa,"
                " for forces are counted in it; give pressures below the atmosphere as those above vacuum"
            )

    def _place(self, index: int) -> str:
        return place(self.name, self.lines[index] if self.lines else None)


class _Column(NamedTuple):
    """A column that the card needs: its place in the row and the unit in its head, "" if there is none."""

    name: str
    place: int
    unit: str


class _Head(NamedTuple):
    columns: tuple[_Column, ...]
    delimiter: str
    width: int


class _Point(NamedTuple):
    line: int
    position: float
    forward: float
    back: float
    step: float


def read_card(path: str | os.PathLike[str]) -> Card:
    """Return the card in a CSV file; the text above says how it is written.

    Raises CardError for a file that is none, with its name and line, and MissingExtraError without pint.
    """
    points = list(_points(path))
    name = shown(path)
    if len(points) < LEAST_POINTS:
        raise CardError(f"{name} has {len(points)} points; a card has at least {LEAST_POINTS}")
    lines, positions, forward, back, steps = zip(*points, strict=True)
    # Trailing zeros are often left out: the finest step is that of all.
    return Card(positions, forward, back, name, lines, min(steps))


def _points(path: str | os.PathLike[str]) -> Iterator[_Point]:
    name, head, marks = shown(path), None, ""
    for number, line in said_lines(path):
        try:
            if head is None:
                head = _head(line)
                continue
            texts = _row(line, head)
            marks = _decimal_marks("".join(texts), marks)
            position, forward, back = (
                _value(text, column, head.delimiter) for text, column in zip(texts, head.columns, strict=True)
            )
        except NotationError as error:
            raise CardError(f"{place(name, number)}: {error}") from None
        step = min(map(_step, texts[1:], head.columns[1:]))
        yield _Point(number, _whole_ends(position), forward, back, step)
    if head is None:
        raise CardError(f"{name} is empty; a card starts with the heads position, p_forward and p_return")


def _whole_ends(position: float) -> float:
    # Steps added up end at 1.0000000000000002.
    return next((end for end in (0.0, 1.0) if abs(position - end) < LEAST_STEP), position)


def _head(line: str) -> _Head:
    delimiter = _delimiter(line)
    fields = _fields(line, delimiter)
    columns = _columns(fields)
    _check_columns([column.name for column in columns], fields)
    for column in columns:
        if column.unit:
            _factor(column.name, column.unit)
    # In the order of a point.
    ordered = sorted(columns, key=lambda column: list(_FACTORS).index(column.name))
    return _Head(tuple(ordered), delimiter, len(fields))


def _delimiter(line: str) -> str:
    """Return the delimiter that parts the head into most of the columns sought, or into most columns."""
    # Quotes match for the right delimiter only.
    split = {delimiter: _fields(line, delimiter, strict=False) for delimiter in _DELIMITERS}
    return max(split, key=lambda one: (len(_columns(split[one])), len(split[one])))


def _columns(fields: Sequence[str]) -> list[_Column]:
    found = [(index, *_name_and_unit(field)) for index, field in enumerate(fields)]
    return [_Column(name, index, unit) for index, name, unit in found if name in _FACTORS]


def _name_and_unit(field: str) -> tuple[str, str]:
    match = _HEAD.fullmatch(field.strip())
    if match is None:
        return field.strip(), ""
    unit = next(unit for unit in match.group("square", "round", "bare") if unit is not None)
    return match["name"].casefold(), unit.strip()


def _check_columns(names: Sequence[str], fields: Sequence[str]) -> None:
    for name in _FACTORS:
        if names.count(name) > 1:
            raise NotationError(f"{names.count(name)} columns are headed {name}; a card has one")
    missing = [name for name in _FACTORS if name not in names]
    if missing:
        found = [_clipped(field.strip()) for field in fields]
        near = did_you_mean(missing[0], [field for field in found if _name_and_unit(field)[0] not in names])
        raise NotationError(
            f"there is no column {' and no '.join(missing)}{near}; the heads are"
            f" {_clipped(', '.join(found), 60)}, and a card needs position, p_forward [bar], p_return [bar]"
        )


def _row(line: str, head: _Head) -> list[str]:
    fields = _fields(line, head.delimiter)
    if len(fields) != head.width:
        advice = "; with decimal commas, part the columns by semicolons" if head.delimiter == "," else ""
        raise NotationError(f"the row has {len(fields)} fields where the head has {head.width}{advice}")
    return [fields[column.place].strip() for column in head.columns]


def _fields(line: str, delimiter: str, strict: bool = True) -> list[str]:
    if '"' not in line:
        return line.split(delimiter)
    try:
        return next(csv.reader([line], delimiter=delimiter, skipinitialspace=True, strict=strict))
    except csv.Error as error:
        raise NotationError(f"the quotes do not match ({error})") from None


def _decimal_marks(texts: str, known: str) -> str:
    """Return the decimal mark seen so far; a card has one, for beside commas 1.013 may be a thousand."""
    marks = "".join(mark for mark in ".," if mark in known or mark in texts)
    if len(marks) > 1:
        raise NotationError(
            "decimal points and decimal commas are mixed from here on; write one of them,"
            " and no thousands marks"
        )
    return marks


def _value(text: str, column: _Column, delimiter: str) -> float:
    match = _VALUE.fullmatch(text)
    if match is None or (delimiter == "," and "," in match[1]):
        raise NotationError(f'{column.name} "{_clipped(text)}" is not a number; write it as 8.1')
    digits, unit = match.groups()
    if unit and column.unit:
        raise NotationError(
            f'{column.name} "{_clipped(text)}" has a unit behind the value and one in the head,'
            f" {_clipped(column.unit)}; write it once"
        )
    value = float(digits.replace(",", ".").replace("−", "-")) * _factor(column.name, unit or column.unit)
    if not math.isfinite(value):
        raise NotationError(f'{column.name} "{_clipped(text)}" is too large')
    return value


def _step(text: str, column: _Column) -> float:
    """Return the unit of the last place of a pressure as written, in Pa."""
    match = _VALUE.fullmatch(text)
    assert match is not None
    digits, unit = match.groups()
    mantissa, _, exponent = digits.lower().replace(",", ".").partition("e")
    decimals = len(mantissa.partition(".")[2]) - int(exponent or 0)
    return float(10.0**-decimals * _factor(column.name, unit or column.unit))


@lru_cache(maxsize=64)
def _factor(name: str, unit: str) -> float:
    try:
        return _FACTORS[name](unit)
    except NotationError as error:
        raise NotationError(f"{name} {error}") from None


def position_unit(text: str) -> float:
    """Return the share of the stroke that the unit is: 1 for "", "1" or "-", and 0.01 for "%"."""
    if text not in _SHARES:
        raise NotationError(
            f'has the unit "{_clipped(text)}"; it is a share of the stroke, 0..1, or 0..100 with the unit %'
        )
    return _SHARES[text]


def pressure_unit(text: str) -> float:
    """Return the pressure in Pa that the unit is: "bar", "kPa", "psi", "at", "kp/cm²", "N/mm^2"."""
    if not text:
        raise NotationError("has no unit; write it in the head, as in p_forward [bar], or behind each value")
    pascals = _pascals(text) if len(text) <= 40 and _UNIT.fullmatch(text) else None
    if pascals is None:
        near = did_you_mean(text, _PRESSURES)
        raise NotationError(f'has the unit "{_clipped(text)}", which is no pressure{near}; write {_EXAMPLES}')
    return pascals


def _pascals(unit: str) -> float | None:
    """Return the unit in Pa, None if pint does not know it or it is no pressure."""
    from kurbel.units import registry

    units = registry()
    try:
        quantity = units.Quantity(1, re.sub(_WORD, _pint_word, unit))
    except (AttributeError, ValueError, TypeError, AssertionError):
        return None
    return float(quantity.to("Pa").magnitude) if quantity.check("[pressure]") else None


def _pint_word(word: re.Match[str]) -> str:
    name, power = word.groups()
    return _FORCES.get(name, name) + ("**2" if power else "")


def _clipped(text: str, most: int = 40) -> str:
    return text if len(text) <= most else f"{text[: most - 3]}..."


_FACTORS: dict[str, Callable[[str], float]] = {
    "position": position_unit,
    "p_forward": pressure_unit,
    "p_return": pressure_unit,
}
