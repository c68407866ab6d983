"""Lengths and speeds with their units, exact: 600mm, 23.5 inch, 120/min, 12.5 rad/s. Needs the extra `units`."""

from __future__ import annotations

import re
from fractions import Fraction
from functools import cache
from typing import Any

from kurbel.errors import MissingExtraError, NotationError
from kurbel.notation import number
from kurbel.problem import Speed

# The number is read by kurbel, for pint would evaluate 9**9**9; the unit may not compute either.
_MEASURE = re.compile(r"\s*([+-]?[\d.,]+(?:[eE][+-]?\d+)?)\s*(/?\s*[A-Za-zµ]+(?:\s*[/*·]\s*[A-Za-zµ]+)*|1\s*/\s*[A-Za-z]+)?\s*")
_LARGEST = Fraction(10**9)
# Umdrehungen, as German data sheets write it; pint's U is the unit of enzymes.
_TURNS = {"U/min": "rpm", "Upm": "rpm", "U/s": "turn/s", "min⁻¹": "/min"}


def length(text: str, what: str) -> Fraction:
    """Return a length in metres: "600mm", "0,6 m", "23.5 inch"."""
    return _checked(_quantity(text, what, "a length such as 600mm", "[length]").to("m").magnitude, text, what)


def speed(text: str) -> Speed:
    """Return a speed of rotation: "120/min", "120rpm", "2 Hz" in turns, "12.5 rad/s" in radians."""
    quantity = _quantity(text, "speed", "a speed of rotation such as 120/min, 120rpm or 12.5rad/s", "1/[time]")
    name = str(quantity.units)
    if "radian" in name:
        return Speed(_checked(quantity.to("rad/s").magnitude, text, "speed"), turns=False)
    per_second = "turn/s" if "turn" in name or "revolution" in name else "1/s"
    return Speed(_checked(quantity.to(per_second).magnitude, text, "speed"))


def is_measure(text: str) -> bool:
    """Whether the text has a unit."""
    match = _MEASURE.fullmatch(text)
    return match is not None and match.group(2) is not None


def _quantity(text: str, what: str, example: str, dimension: str) -> Any:
    match = _MEASURE.fullmatch(_with_turns(text)) if len(text) <= 80 else None
    if match is None:
        raise NotationError(f'{what} "{text[:40]}" is not {example}')
    digits, unit = match.groups()
    if unit is None:
        raise NotationError(f'{what} "{text[:40]}" has no unit; write {example}')
    try:
        quantity = _registry().Quantity(number(digits, what), "1" + unit if unit.startswith("/") else unit)
    except (AttributeError, ValueError, TypeError, AssertionError):
        # pint answers an unknown unit with an AttributeError of its own.
        raise NotationError(f'{what} "{text[:40]}" has the unknown unit {unit}; write {example}') from None
    if not quantity.check(dimension):
        raise NotationError(f'{what} "{text[:40]}" is in {quantity.units}; it must be {example}')
    return quantity


def _with_turns(text: str) -> str:
    for written, read in _TURNS.items():
        if text.rstrip().endswith(written):
            return text.rstrip().removesuffix(written) + read
    return text


def _checked(value: Fraction, text: str, what: str) -> Fraction:
    if not 0 < value <= _LARGEST:
        raise NotationError(f'{what} "{text[:40]}" is out of range; it must be above 0 and at most 10^9 m or 1/s')
    return value


@cache
def _registry() -> Any:
    try:
        import pint
    except ImportError:
        raise MissingExtraError(
            "lengths and speeds with units need pint; install it with: pip install 'kurbel[units]'"
        ) from None
    return pint.UnitRegistry(non_int_type=Fraction)
