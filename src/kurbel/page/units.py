"""Columns in other units than those of metric pages, and in a larger one, kN in place of N, where their
numbers have five digits before the decimal mark.

A page has one unit for all columns of a dimension, by the greatest number of them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial

from kurbel.exact.numerals import Label, Number
from kurbel.page.axes import places
from kurbel.page.quantity import Column, Known, Words, known_at, multiplied
from kurbel.page.subject import Question
from kurbel.reading.amounts import BOTH, LARGER, UNITS, Unit, Units, larger

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
        return label.removesuffix(own.symbol) + other.heading(lang)
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


def enlarged(question: Question) -> Question:
    """Return the question with larger units where its page has longer numbers."""
    columns: dict[str, list[Column]] = {}
    for column in question.page_columns:
        if _symbols(column)[0] in LARGER:
            columns.setdefault(_unit(column).dimension, []).append(column)
    known: dict[Known, Number] = {}
    taken: dict[str, Unit] = {}
    for found in columns.values():
        if all(_is_free(question, column) and _says(question, column) for column in found):
            known |= (numbers := _numbers(question, found))
            taken |= {longer.dimension: longer for longer in _longer(found, numbers)}
    if not taken:
        return question
    asked = question.units.chosen if question.units else {}
    units = Units({**asked, **taken}, data=False, taken=frozenset(taken))
    counted = question.digits is not None
    return question.varied(units=units, known={} if counted else _moved(known, columns, units))


def _symbols(column: Column) -> list[str]:
    """Return the unit of a column, of one with forces in some rows and moments in others both of them."""
    return column.quantity.unit["en"].split(", ")


def _unit(column: Column) -> Unit:
    return UNITS[_symbols(column)[0]]


def _is_free(question: Question, column: Column) -> bool:
    """Whether no unit of the column's dimension was asked for."""
    asked = question.units.chosen if question.units else {}
    return not any(UNITS[one].dimension in asked for one in _symbols(column))


def _says(question: Question, column: Column) -> bool:
    """Whether the page says the unit of the column where another can stand in its place."""
    return question.layout.unit or any(
        names_unit(label, column.quantity.unit["en"]) for label in (*column.heading, *column.spanners)
    )


def _numbers(question: Question, columns: Sequence[Column]) -> dict[Known, Number]:
    """Return what stands in these columns, by column and place."""
    sizes = {name: axis.size for name, axis in question.axes.items() if name != "column"}
    found = {}
    for column in columns:
        index = question.page_columns.index(column)
        for place in places(sizes, partial(question.subject.exists, question)):
            shown = question.number(column, at := {**place, "column": index})
            if isinstance(shown, Number):
                found[known_at(column, at)] = shown
    return found


def _longer(columns: Sequence[Column], numbers: Mapping[Known, Number]) -> Iterator[Unit]:
    """Yield the unit in place of that of the columns, if their greatest number asks for one."""
    sizes = {column.key: _unit(column).size for column in columns}
    greatest = max(
        (abs(one.scaled) * sizes[key] / 10**one.decimals for (key, _), one in numbers.items()),
        default=Fraction(0),
    )
    for symbol in (one for column in columns for one in _symbols(column)):
        if (longer := larger(symbol, greatest / UNITS[symbol].size)) != symbol:
            yield UNITS[longer]


def _moved(
    numbers: Mapping[Known, Number], columns: Mapping[str, Sequence[Column]], units: Units
) -> dict[Known, Number]:
    """Return the numbers in these units, each with every digit that it had.

    What is printed to figures of its own, or is exact, is left out.
    """
    counted = {
        one.key: (one.decimals, len(str(1 / units.times(_unit(one).symbol))) - 1)
        for found in columns.values()
        for one in found
    }
    moved = {}
    for (key, place), number in numbers.items():
        decimals, more = counted[key]
        if number.decimals == decimals:
            moved[key, place] = Number(number.scaled, decimals + more)
    return moved
