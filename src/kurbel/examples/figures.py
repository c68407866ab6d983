"""Figures as books print them, each with the size of its last place: 0,343  79°20'  32°51½'  5/4."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import NamedTuple

from kurbel.errors import LayoutError
from kurbel.exact.numerals import Label, Number, number_text


class Form(NamedTuple):
    """How a figure is written: as a number with so many decimals, as an angle, or as a fraction.

    `parts` counts the last places of an angle in a degree: 1, 60 for minutes, 120 for half minutes; it is 0
    for what is no angle. A fraction has no last place.
    """

    decimals: int = 0
    parts: int = 0
    fraction: bool = False


class Figure(NamedTuple):
    """A printed figure: so many units of its last place, or a fraction."""

    value: Fraction
    form: Form

    def text(self) -> str:
        """Return the figure for a formula, with a decimal point: 0.343, 79°20', 5/4; for prose 32°51½′."""
        if self.form.fraction:
            return str(self.value)
        if not self.form.parts:
            return number_text(self._number())
        degrees, rest = divmod(abs(int(self.value)), self.form.parts)
        minutes, half = divmod(rest * 60, self.form.parts)
        sign = "-" if self.value < 0 else ""
        if self.form.parts == 1:
            return f"{sign}{degrees}°"
        # The notation of formulas has no ½, nor has that of prose a prime after it.
        return f"{sign}{degrees}°{minutes}½′" if half else f"{sign}{degrees}°{minutes}'"

    def cell(self) -> Number | Label:
        """Return the figure for a table."""
        if not self.form.fraction and not self.form.parts:
            return self._number()
        text = self.text()
        return text if "½" in text else f"${text}$"

    def _number(self) -> Number:
        return Number(int(self.value), self.form.decimals)


_FIGURE = re.compile(
    r"(?P<sign>-?)(?:(?P<degrees>\d+)°(?:(?P<minutes>\d+)(?P<half>½?)')?|(?P<fraction>\d+/\d+)"
    r"|(?P<whole>\d+)(?:[.,](?P<decimals>\d+))?)",
    re.ASCII,
)


def figure(text: str) -> Figure:
    """Return the figure that was printed; raise LayoutError for what is none."""
    match = _FIGURE.fullmatch(text)
    if match is None:
        raise LayoutError(f'the printed value "{text}" is no figure')
    value, form = _read(match)
    return Figure(-value if match["sign"] else value, form)


def _read(match: re.Match[str]) -> tuple[Fraction, Form]:
    if match["fraction"]:
        return Fraction(match["fraction"]), Form(fraction=True)
    if match["degrees"]:
        minutes = match["minutes"]
        parts = 1 if minutes is None else 120 if match["half"] else 60
        turned = Fraction(match["degrees"]) + (Fraction(minutes or 0) + Fraction(bool(match["half"]), 2)) / 60
        return turned * parts, Form(parts=parts)
    decimals = match["decimals"] or ""
    return Fraction(match["whole"] + decimals), Form(len(decimals))
