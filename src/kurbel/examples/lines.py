"""Templates of lines filled in: {path} a figure of a step, {-path} with the other sign before it.

{half}       a step, or an exact number: 0.125, 1/9
{+c} {-c}    sign and amount: + 0.707; {-c} turns the sign
{(c)}        in parentheses if it is negative or a fraction
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from fractions import Fraction

from kurbel.exact.numerals import Label, finite_decimals, nearest, number_text

_PLACE = re.compile(r"\{(?P<sign>[+-]?)(?P<open>\(?)(?P<name>\w+)\)?\}")
# An exact number with more decimals is written as a fraction.
MOST_DECIMALS = 4


def names_in(text: Label) -> Iterator[str]:
    """Yield the names in a template, each once."""
    yield from dict.fromkeys(match["name"] for match in _PLACE.finditer(text))


def filled(text: Label, figure_of: Callable[[str], str]) -> Label:
    """Return the line with its figures; `figure_of` returns the text of a name."""

    def place(match: re.Match[str]) -> str:
        shown = figure_of(match["name"])
        negative = shown.startswith("-")
        amount = shown.removeprefix("-")
        if match["sign"]:
            return f"{'+' if negative == (match['sign'] == '-') else '-'} {amount}"
        return f"({shown})" if match["open"] and (negative or "/" in shown) else shown

    return _PLACE.sub(place, text)


def exact_text(value: Fraction) -> str:
    """Return an exact number for a formula: 5, 0.125, -5/12."""
    decimals = finite_decimals(value)
    if decimals is None or decimals > MOST_DECIMALS:
        return str(value)
    return number_text(nearest(value, decimals))
