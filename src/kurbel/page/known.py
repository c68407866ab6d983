"""Numbers of a page that are known from the same page in smaller units."""

from __future__ import annotations

from typing import TypeAlias

from kurbel.exact.numerals import Number, figures
from kurbel.page.axes import Place
from kurbel.page.quantity import Column

# The key of a column, and a place.
Known: TypeAlias = tuple[str, frozenset[tuple[str, int]]]


def known_at(column: Column, place: Place) -> Known:
    return column.key, frozenset(place.items())


def is_short(number: Number, column: Column) -> bool:
    """Whether a number of five figures has fewer decimals than the column has at the least.

    What is printed to fewer figures is exact.
    """
    return number.decimals < column.least and number.decimals == figures(number.scaled / 10**number.decimals)
