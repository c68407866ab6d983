"""Conditions on the motion as text: p = 0, s = 25%, c = max, p = 1/6 of dead centre, x = 200 mm."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from fractions import Fraction

from kurbel.errors import NotationError
from kurbel.exact.numerals import degrees_text, exact_text, finite_decimals
from kurbel.reading import notation
from kurbel.reading.amounts import UNITS
from kurbel.reading.given import SHARE, allowed_name, as_share
from kurbel.reading.notation import BEFORE_UNIT, LONGEST_NUMBER, quoted

GRAMMAR = 'write it as p=0, s=25%, x=1.1, "x = 200 mm", c=max, p=min or "p = 1/6 of dead centre"'
# What a condition can ask beside a number.
VALUE, MAX, MIN, DEAD_CENTRE = "value", "max", "min", "dead centre"
# Of the magnitude, |p| = max.
MOST = "greatest magnitude"
EXTREMES = (MAX, MIN, MOST)
# Quantities that are angles, and those of which a share of the value at the dead centre makes sense.
ANGLES = ("psi", "rocker")
# Those whose greatest value is the greatest lean to either side.
LEANING = ("psi",)
ACCELERATIONS = ("p", "acceleration")
# Quantities that may have a unit: mm, m/s, m/s².
MEASURED = ("x", "c", "p")
OF_SLIDES = "x, c and p of the straight or offset crank"
SMALLEST, LARGEST = Fraction(1, 10**30), Fraction(10**30)

_CONDITION = r"\s*([^\s=<>]+)\s*=\s*([^=]*?)\s*"
# max|p|, as books write it.
_MOST = r"\s*max\s*\|([^\s=<>|]+)\|\s*"
_OF_DEAD_CENTRE = r"(.*?)\s*\bof\s+(?:the\s+)?dead\s+cent(?:re|er)"
_MEASURE = rf"{BEFORE_UNIT}\s*((?![eE][+-]?\d|of\b)[A-Za-zµ].*)"


@dataclass(frozen=True, slots=True)
class Condition:
    """That a quantity has a value, a share of its value at the dead centre, or is greatest or least.

    An angle is in degrees, a path, velocity or acceleration with a `unit` in that unit, else in units of R,
    v and v²/R. Written out it can be read again.
    """

    quantity: str
    kind: str = VALUE
    value: Fraction = Fraction(0)
    unit: str = ""

    def __str__(self) -> str:
        name = f"|{self.quantity}|" if self.kind == MOST else self.quantity
        return f"{name} = {self.right_side()}"

    def right_side(self, mark: str = ".") -> str:
        """Return what stands behind the equals sign."""
        if self.kind in EXTREMES:
            return MIN if self.kind == MIN else MAX
        if self.kind == DEAD_CENTRE:
            return f"{exact_text(self.value, mark)} of dead centre"
        if self.unit:
            return f"{exact_text(self.value, mark)} {self.unit}"
        if self.quantity == SHARE and finite_decimals(self.value) is not None:
            return f"{exact_text(100 * self.value, mark)}%"
        if self.quantity in ANGLES and finite_decimals(self.value) is None:
            return degrees_text(self.value, mark)
        return exact_text(self.value, mark)


def read_condition(
    text: str, names: Mapping[str, str], measured: Collection[str] = MEASURED, whose: str = OF_SLIDES
) -> Condition:
    """Return the condition that is written, of a quantity among the names, each with what it stands for.

    Those `measured` may have a unit; `whose` they are, sentences say.
    """
    shown = f'condition "{text[:LONGEST_NUMBER]}"'
    text = re.sub(rf"^{_MOST}$", r"|\1| = max", text)
    match = re.fullmatch(_CONDITION, text) if len(text) <= 3 * LONGEST_NUMBER else None
    if match is None or not match.group(2):
        raise NotationError(f"{shown} cannot be read; {GRAMMAR}")
    bare, right = match.groups()
    name = bare.strip("|")
    _refuse_column(name, right, names)
    quantity = names[allowed_name(name, names, "quantity")]
    if name != bare:
        if right != MAX or bare != f"|{name}|":
            raise NotationError(f'{shown} is of a magnitude, which may be greatest; write "|{name}| = max"')
        return Condition(quantity, MOST)
    if right in (MAX, MIN):
        return Condition(quantity, right)
    if share := re.fullmatch(_OF_DEAD_CENTRE, right):
        return _of_dead_centre(quantity, share.group(1), shown)
    if quantity in ANGLES:
        return Condition(quantity, VALUE, _in_range(notation.angle(right, f"{shown}:"), shown))
    if measure := re.fullmatch(_MEASURE, right):
        unit = measure.group(1)
        if quantity not in measured:
            raise NotationError(f"{shown} has a unit, which only {whose} can have; {GRAMMAR}")
        return Condition(quantity, VALUE, _number(right.removesuffix(unit).strip(), shown), unit)
    if right.endswith("%") and quantity != SHARE:
        raise NotationError(
            f"{shown} has a percentage, which is for s, the share of the stroke, and of the dead centre;"
            f" write it as s={right.replace(' ', '')}"
        )
    return Condition(quantity, VALUE, _number(right, shown))


def _refuse_column(name: str, right: str, names: Mapping[str, str]) -> None:
    """Raise NotationError for the name of a column in a unit, c_mps, of which a condition has the unit behind
    the value."""
    quantity, _, ending = name.rpartition("_")
    if name in names or quantity not in (*names, *MEASURED):
        return
    if symbol := next((unit.symbol for unit in UNITS.values() if unit.ending == ending), ""):
        unit = "" if right in (MAX, MIN) or any(map(str.isalpha, right)) else f" {symbol}"
        line = f'"{quantity} = {right}{unit}"'
        raise NotationError(f"{quoted(name)} is a column; a condition has its unit behind the value: {line}")


def _of_dead_centre(quantity: str, share: str, shown: str) -> Condition:
    if quantity not in ACCELERATIONS:
        raise NotationError(
            f"{shown} has no value at the dead centre to be a share of; only the acceleration p has one"
        )
    return Condition(quantity, DEAD_CENTRE, _number(share or "1", shown))


def _number(text: str, shown: str) -> Fraction:
    """Return a number or a percentage: 0.25, 25%, -1/6."""
    try:
        value = as_share(text, "share")
    except NotationError:
        raise NotationError(f"{shown} cannot be read; {GRAMMAR}") from None
    return _in_range(value, shown)


def _in_range(value: Fraction, shown: str) -> Fraction:
    if value and not SMALLEST <= abs(value) <= LARGEST:
        raise NotationError(f"{shown} is out of range; a value is 0 or within 10^-30 and 10^30")
    return value
