"""Columns in other units than those of metric pages."""

from __future__ import annotations

from fractions import Fraction

from kurbel.exact.numerals import Label
from kurbel.page.quantity import Column, multiplied
from kurbel.reading.amounts import Unit, Units


def in_units(column: Column, units: Units, lang: str, counted: bool) -> Column:
    """Return a column in these units, with as many more or fewer decimals unless they were `counted`."""
    if (pair := units.of(column.quantity.unit["en"])) is None:
        return column
    own, other = pair
    more = _more_decimals(other.size / own.size)
    decimals = column.decimals
    is_taken = own.dimension in units.taken and decimals is None
    return column._replace(
        quantity=multiplied(column.quantity, own.size / other.size)._replace(
            unit=dict.fromkeys(column.quantity.unit, other.symbol)
        ),
        decimals=decimals if decimals is None or counted else max(0, decimals + more),
        least=more if is_taken else 0,
        heading=tuple(_renamed(label, own, other, lang) for label in column.heading),
        spanners=tuple(_renamed(label, own, other, lang) for label in column.spanners),
    )


def _renamed(label: Label, own: Unit, other: Unit, lang: str) -> Label:
    """Return the head of a column with the unit that it names, if it names one, in its place."""
    said = other.named[lang] if other.named else other.symbol
    return f"{label.removesuffix(own.symbol)}{said}" if names_unit(label, own) else label


def names_unit(label: Label, unit: Unit) -> bool:
    """Whether the head of a column is the unit or ends with it: "$F$ in N"."""
    return label == unit.symbol or f" {label}".endswith(f" in {unit.symbol}")


def _more_decimals(times: Fraction) -> int:
    """Return how many more decimals a unit that is so many times as large needs."""
    more = 0
    while times >= 10:
        times, more = times / 10, more + 1
    while times <= Fraction(1, 10):
        times, more = times * 10, more - 1
    return more
