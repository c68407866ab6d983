"""The indicator card of a steam engine from a CSV file.

    # comment
    position [%];p_forward [bar];p_return [bar]
    0;8,1;1,2
    0,5;8,1;1,15
    ...
    100;2,4;1,1

`position` is the share of the stroke from the dead centre of this end, 0 to 1 or 0 % to 100 %, rising.
`p_forward` is the pressure while the piston goes away from that dead centre, `p_return` while it comes back.
Both are measured from one zero, vacuum or atmosphere.

A cylinder of four strokes has four pressures at a position, which counts from the inner dead centre:

    position [%];p_expansion [bar];p_exhaust [bar];p_suction [bar];p_compression [bar]

Pressures of a test bench are over the crank angle, by rows in its order, with one cycle of 720°, or of 360°:

    angle [°];p [bar]
    0;31,5
    1;32,2
    ...
    719;30,8

`angle` counts from the inner dead centre in which the cylinder fires; it may begin elsewhere, at -360 too.

The pressures have a unit that pint knows (extra `units`), such as bar, kPa, MPa, psi, atm, at, kp/cm², N/mm²:
in the head, as `p_forward [bar]`, `p_forward (bar)`, `p_forward/bar`, `p_forward in bar` or `p_forward bar`,
or behind each value, as `8,1 bar`. `position` may have %. Columns are in any order, more of them are ignored.
Semicolons, tabs or commas part them; a decimal comma is read where commas do not part. Empty lines, comments
(#), quotes, BOM and CRLF are allowed.
"""

from __future__ import annotations

import math
import os
import re
import sys
from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

from kurbel.engine.card.card import LEAST_STEP, AngleCard, Card, CycleCard, check_positions, check_pressures
from kurbel.errors import CardError, NotationError
from kurbel.reading.amounts import plain_unit
from kurbel.reading.csv_file import (
    Column,
    Head,
    Kind,
    check_once,
    clipped,
    digits_and_unit,
    name_and_unit,
    read_head,
    read_rows,
    shown,
)
from kurbel.reading.names import did_you_mean
from kurbel.reading.units import unit_in

KIND = Kind("card", "point", CardError)
LEAST_POINTS = 8

_NAMES = ("position", "p_forward", "p_return")
_FOUR_STROKES = ("position", "p_expansion", "p_exhaust", "p_suction", "p_compression")
_BY_ANGLE = ("angle", "p")
# What is no pressure.
_PLAIN = ("position", "angle")
# As engineers wrote it, the kg of a pressure is a force; pint's is a mass, and it knows no kp.
_FORCES = {"kp": "kgf", "kg": "kgf", "lb": "lbf", "lbs": "lbf"}
_PRESSURES = ("bar", "mbar", "Pa", "hPa", "kPa", "MPa", "psi", "atm", "at")
_EXAMPLES = "bar, kPa, MPa, psi, atm, at or kp/cm²"
_SHARES = {"": 1.0, "1": 1.0, "-": 1.0, "%": 0.01}
_DEGREES = ("", "°", "deg", "degree", "degrees", "°CA", "degCA")


class _Point(NamedTuple):
    line: int
    values: tuple[float, ...]
    step: float


def read_card(path: str | os.PathLike[str]) -> Card | CycleCard | AngleCard:
    """Return the card in a CSV file; the text above says how it is written.

    Raises CardError for a file that is none, with its name and line, and MissingExtraError without pint.
    """
    starts = "a card starts with the heads position, p_forward and p_return"
    points = list(read_rows(path, KIND, _head, _point, starts))
    name = shown(path)
    if len(points) < LEAST_POINTS:
        raise CardError(f"{name} has {len(points)} points; a card has at least {LEAST_POINTS}")
    lines, values, steps = zip(*points, strict=True)
    # Trailing zeros are often left out: the finest step is that of all.
    resolution, (first, *columns) = min(steps), zip(*values, strict=True)
    if len(columns) == 1:
        return AngleCard(first, columns[0], name, lines, resolution)
    if len(columns) == 2:
        return Card(first, columns[0], columns[1], name, lines, resolution)
    check_positions(first, name, lines)
    for what, column in zip(_FOUR_STROKES[1:], columns, strict=True):
        check_pressures(what, column, name, lines)
    back = tuple(1 - position for position in reversed(first))
    strokes = ((back, one[::-1]) if index % 2 else (first, one) for index, one in enumerate(columns))
    return CycleCard(tuple(strokes), name, resolution)


def _point(texts: list[str], head: Head, line: int) -> _Point:
    fields = zip(texts, head.columns, strict=True)
    (first, _), *pressures = (_read(*field, head.delimiter) for field in fields)
    if head.columns[0].name == "position":
        # Steps added up end at 1.0000000000000002.
        first = next((end for end in (0.0, 1.0) if abs(first - end) < LEAST_STEP), first)
    return _Point(line, (first, *(value for value, _ in pressures)), min(step for _, step in pressures))


def _head(line: str) -> Head:
    wanted = _form(line)
    head, fields = read_head(line, wanted)
    check_once(head, KIND.noun)
    names = [column.name for column in head.columns]
    missing = [name for name in wanted if name not in names]
    if missing:
        found = [clipped(field) for field in fields]
        near = did_you_mean(missing[0], [field for field in found if name_and_unit(field)[0] not in names])
        needed = ", ".join(name if name in _PLAIN else f"{name} [bar]" for name in wanted)
        raise NotationError(
            f"there is no column {' and no '.join(missing)}{near}; the heads are"
            f" {clipped(', '.join(found), 60)}, and a card needs {needed}"
        )
    for column in head.columns:
        if column.unit:
            _factor(column.name, column.unit)
    return head


def _form(line: str) -> tuple[str, ...]:
    """Return the columns of the form in which a card is written, by those that no other form has."""
    for form, own in ((_FOUR_STROKES, _FOUR_STROKES[1:]), (_BY_ANGLE, _BY_ANGLE[:1])):
        if read_head(line, own)[0].columns:
            return form
    return _NAMES


def _read(text: str, column: Column, delimiter: str) -> tuple[float, float]:
    """Return a position or a pressure, a share or in Pa, and the unit of its last place as written."""
    digits, unit = digits_and_unit(text, column, delimiter, "8.1")
    digits, factor = digits.lower().replace(",", ".").replace("−", "-"), _factor(column.name, unit)
    mantissa, _, exponent = digits.partition("e")
    decimals, value = len(mantissa.partition(".")[2]) - int(exponent or 0), float(digits) * factor
    if not math.isfinite(value) or decimals < -sys.float_info.max_10_exp:
        raise NotationError(f'{column.name} "{clipped(text)}" is too large')
    return value, 10.0**-decimals * factor


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
            f'has the unit "{clipped(text)}"; it is a share of the stroke, 0..1, or 0..100 with the unit %'
        )
    return _SHARES[text]


def angle_unit(text: str) -> float:
    """Return the degrees that the unit is: 1 for "", "°" and "deg"."""
    if text not in _DEGREES:
        raise NotationError(f'has the unit "{clipped(text)}"; crank angles are in degrees, °')
    return 1.0


def pressure_unit(text: str) -> float:
    """Return the pressure in Pa that the unit is: "bar", "kPa", "psi", "at", "kp/cm²", "N/mm^2"."""
    if not text:
        raise NotationError("has no unit; write it in the head, as in p_forward [bar], or behind each value")
    pascals = _pascals(text) if len(text) <= 40 else None
    if pascals is None:
        near = did_you_mean(text, _PRESSURES)
        raise NotationError(f'has the unit "{clipped(text)}", which is no pressure{near}; write {_EXAMPLES}')
    return pascals


def _pascals(unit: str) -> float | None:
    """Return the unit in Pa, None if pint does not know it or it is no pressure."""
    plain = plain_unit(unit)
    if plain is None:
        return None
    forces = re.sub(r"\w+", lambda word: _FORCES.get(word[0], word[0]), plain)
    pascals = unit_in(forces, "Pa")
    return None if pascals is None else float(pascals)


_FACTORS: dict[str, Callable[[str], float]] = {
    "position": position_unit,
    "angle": angle_unit,
    **dict.fromkeys((*_NAMES[1:], *_FOUR_STROKES[1:], "p"), pressure_unit),
}
