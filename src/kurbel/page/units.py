"""Columns in other units than those of metric pages."""

from __future__ import annotations

import re
from fractions import Fraction

from kurbel.exact.numerals import Label
from kurbel.page.quantity import Column, Words, multiplied
from kurbel.reading.amounts import BOTH, Unit, Units

# What stands before the unit that a rate is over: steam per kWh.
_PER: Words = {"de": "je", "en": "per"}


def in_units(column: Column, units: Units, lang: str, counted: bool) -> Column:
    """Return a column in these units, with as many more or fewer decimals unless they were `counted`.

    Where rows have units of their own, forces and moments, their numbers are its subject's.
    """
    quantity = column.quantity
    if (pair := units.of(quantity.unit["en"])) is None:
        return column
    own, other = pair
    more = _more_decimals(other.size / own.size)
    decimals = column.decimals
    is_taken = own.dimension in units.taken and decimals is None
    times = Fraction(1) if own.symbol == BOTH else own.size / other.size
    return column._replace(
        quantity=multiplied(quantity, times)._replace(
            name={one: _renamed(name, own, other, one) for one, name in quantity.name.items()},
            heading={one: _renamed(head, own, other, one) for one, head in quantity.heading.items()},
            unit=dict.fromkeys(quantity.unit, other.symbol),
            decimals=_shifted(quantity.decimals, more),
        ),
        decimals=decimals if counted else _shifted(decimals, more),
        least=more if is_taken else 0,
        heading=tuple(_renamed(label, own, other, lang) for label in column.heading),
        spanners=tuple(_renamed(label, own, other, lang) for label in column.spanners),
    )


def _renamed(label: Label, own: Unit, other: Unit, lang: str) -> Label:
    """Return the name or the head of a column with the unit that it names, if it names one, in its place."""
    if names_unit(label, own.symbol):
        return label.removesuffix(own.symbol) + other.said(lang)
    over, instead = (f" {_PER[lang]} {one.symbol.partition('/')[2].strip('()')}" for one in (own, other))
    return re.sub(rf"{over}\b", instead, label)


def names_unit(label: Label, symbol: str) -> bool:
    """Whether the head of a column is the unit or ends with it: "$F$ in N"."""
    return label == symbol or f" {label}".endswith(f" in {symbol}")


def _shifted(decimals: int | None, more: int) -> int | None:
    return None if decimals is None else max(0, decimals + more)


def _more_decimals(times: Fraction) -> int:
    """Return how many more decimals a unit that is so many times as large needs."""
    more = 0
    while times >= 10:
        times, more = times / 10, more + 1
    while times <= Fraction(1, 10):
        times, more = times * 10, more - 1
    return more
