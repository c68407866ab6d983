"""Printed values as characters: what they say, to which last place, and how another would stand there."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import NamedTuple

from kurbel.errors import NotationError
from kurbel.exact.numerals import Label, Number, number_text

LONGEST = 100
# Units of the last place in one of the next.
NEXT_PLACE = 10
_DECIMAL = re.compile(r"([-−]?)([0-9]+)(?:([.,])([0-9]+))?")
_ARC = re.compile(r"([-−]?)([0-9]+)°\s*(?:([0-9]+)(½)?['′])?")
_QUOTIENT = re.compile(r"([-−]?)([0-9]+)/([0-9]+)")


# Of what is printed, whole ones; a quotient in place of a quotient need not be.
Units = int | Fraction


class Printed(NamedTuple):
    """A printed value: scaled · unit, where the unit is that of its last place.

    `form` says how it is written: with a decimal "," or ".", as "°", "'" (degrees and minutes), "½'" (half
    minutes counted), or as "/", a quotient, which has no last place but is exact.
    """

    text: str
    scaled: int
    unit: Fraction
    form: str

    @property
    def value(self) -> Fraction:
        return self.scaled * self.unit

    @property
    def exact(self) -> bool:
        return self.form == "/"

    def standing_for(self, scaled: Units) -> str:
        """Return how a value of so many units would be printed in its place."""
        if self.exact:
            return self.text if scaled == self.scaled else str(scaled * self.unit)
        assert isinstance(scaled, int)
        if self.form in (",", "."):
            return number_text(Number(scaled, self.decimals), self.form)
        sign = "-" if scaled < 0 else ""
        size = abs(scaled)
        if self.form == "°":
            return f"{sign}{size}°"
        halves = 2 if self.form == "½'" else 1
        degrees, rest = divmod(size, 60 * halves)
        minutes, half = divmod(rest, halves)
        return f"{sign}{degrees}°{minutes}{'½' if half else ''}'"

    def with_units(self, scaled: Units) -> Printed:
        """Return the value of so many units, printed in its place."""
        text = self.standing_for(scaled)
        if self.exact:
            value = scaled * self.unit
            return Printed(text, value.numerator, Fraction(1, value.denominator), self.form)
        return self._replace(text=text, scaled=int(scaled))

    @property
    def in_tens(self) -> bool:
        """Whether it may be meant to ten minutes: 79°20'. A decimal fraction promises all its places."""
        return self.form == "'" and self.scaled % NEXT_PLACE == 0

    def coarser(self) -> Printed:
        """Return the value in units ten times as great; one in tens is the same."""
        return self._replace(scaled=self.scaled // NEXT_PLACE, unit=self.unit * NEXT_PLACE)

    def in_formula(self) -> str:
        """Return the value for a formula, with a decimal point: 0.343, 79°20', 5/4; for prose 32°51½′."""
        # The notation of formulas has no ½, nor has that of prose a prime after it.
        return self.standing_for(self.scaled).replace(",", ".").replace("½'", "½′")

    def cell(self) -> Number | Label:
        """Return the value for a table."""
        if self.form in (",", "."):
            return Number(self.scaled, self.decimals)
        text = self.in_formula()
        return text if "½" in text else f"${text}$"

    @property
    def decimals(self) -> int:
        """How many decimals are printed."""
        return len(str(self.unit.denominator)) - 1 if self.form in (",", ".") else 0


def printed_value(text: str) -> Printed:
    """Return what the characters say: "0,981", "-0.025", "32°51½'", "77°", "1/72"."""
    stripped = text.strip()
    if len(stripped) > LONGEST:
        raise NotationError(
            f"a printed value of {len(stripped)} characters is too long; {LONGEST} are allowed"
        )
    if match := _DECIMAL.fullmatch(stripped):
        sign, whole, mark, rest = match.groups()
        rest = rest or ""
        scaled = int(whole + rest) * (-1 if sign else 1)
        return Printed(stripped, scaled, Fraction(1, 10 ** len(rest)), mark or ",")
    if match := _ARC.fullmatch(stripped):
        sign, degrees, minutes, half = match.groups()
        if minutes is None:
            return Printed(stripped, int(degrees) * (-1 if sign else 1), Fraction(1), "°")
        halves = 2 if half else 1
        scaled = (int(degrees) * 60 + int(minutes)) * halves + bool(half)
        form = "½'" if half else "'"
        return Printed(stripped, scaled * (-1 if sign else 1), Fraction(1, 60 * halves), form)
    if match := _QUOTIENT.fullmatch(stripped):
        sign, top, bottom = match.groups()
        if int(bottom):
            value = Fraction(int(top), int(bottom)) * (-1 if sign else 1)
            return Printed(stripped, value.numerator, Fraction(1, value.denominator), "/")
    raise NotationError(
        f'"{text[:40]}" is no printed value; write 0,981 or 0.981, an angle as 32°51\' or a quotient as 1/72'
    )
