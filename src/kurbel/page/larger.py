"""Columns whose numbers have five digits before the decimal mark, in a larger unit: kN in place of N.

A page has one unit for all columns of a dimension, by the greatest number of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial

from kurbel.exact.numerals import Number
from kurbel.page.axes import places
from kurbel.page.quantity import Column, Known, known_at
from kurbel.page.subject import Question
from kurbel.page.units import names_unit
from kurbel.reading.amounts import LARGER, UNITS, Unit, Units, larger


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
