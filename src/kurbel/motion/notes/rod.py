"""What pages say of a connecting rod: where its masses are."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import isqrt
from typing import TYPE_CHECKING

from kurbel.drive.load import figure
from kurbel.exact.numerals import Label, finite_decimals
from kurbel.kernel.circle import root
from kurbel.motion.captions import WORDS, digits_text
from kurbel.motion.notes.effort import usual_gravity
from kurbel.page.quantity import Words
from kurbel.reading.amounts import amount

if TYPE_CHECKING:
    from kurbel.drive.rod import Rod


def connecting_rod(rod: Rod, lang: str, length: str = "L", named: Mapping[str, Words] = WORDS) -> Label:
    """Return the line about a rod: where its masses are, and its mass if that is known."""
    square = rod.gyration_square
    said = named["connecting_rod"][lang].format(
        length=length,
        centre=figure(1 - rod.centre),
        gyration=_root(square) or digits_text(lambda numbers: root(numbers.of(square)), 4),
        couple=figure(rod.couple),
        mass=f", $M = {amount(rod.mass, 'kg')}$" if rod.mass is not None else "",
    )
    return said + _swing(rod, lang)


def _swing(rod: Rod, lang: str) -> Label:
    """Return from which swing the radius of gyration is, nothing where it was given."""
    if rod.swing is None:
        return ""
    time, pin, gravity = rod.swing
    said = WORDS["swing"][lang].format(time=figure(time), pin=WORDS[f"swing_{pin}"][lang])
    return f"{said}, $g = {amount(gravity, 'm/s²')}$" + usual_gravity(gravity)


def _root(square: Fraction) -> str:
    """The square root of a fraction that has a short one, else nothing."""
    found = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return figure(found) if found * found == square and finite_decimals(found) is not None else ""
