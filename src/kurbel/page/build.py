"""What was asked for becomes a table: its grid for the page, its records for programs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import product

from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number, degrees_text
from kurbel.page.arrange import Axis, Grid, Place, check_size, panels
from kurbel.page.quantity import Column
from kurbel.page.question import Question
from kurbel.page.table import Cell, Note, Panel, Records, Table, Value


def build(question: Question, pages: bool = True) -> Table:
    """Return the table that was asked for; without `pages` only its records, which need no memory."""
    about, layout = question.subject, question.layout
    further = about.page_notes(question) if pages else ()
    return Table(
        key=question.key,
        layout=layout.key,
        lang=question.lang,
        caption=about.caption(question),
        panels=_panels(question) if pages else (),
        records=about.rows(question) if about.rows else records_of(question),
        notes=tuple(
            one if isinstance(one, Note) else Note(one) for one in (*about.notes(question), *further)
        ),
        source=question.source,
        templates=layout.folder,
    )


def _panels(question: Question) -> tuple[Panel, ...]:
    other = question.subject.grid
    return panels(*other(question)) if other else panels(question.layout, grid_of(question))


def grid_of(question: Question) -> Grid:
    """Return the axes of the page and what stands at their places."""
    about, layout, columns = question.subject, question.layout, question.page_columns
    if not columns:
        raise ProblemError(question.no_column)
    check_size(layout, {name: axis.size for name, axis in question.axes.items()})

    def cell(place: Place) -> Cell:
        column = columns[place.get("column", 0)]
        return Cell(_shown(question, column, place), about.marks(question, column, place))

    def unit(place: Place) -> Label:
        quantity = columns[place["column"]].quantity
        return "" if quantity.minutes else quantity.unit[question.lang]

    def exists(place: Place) -> bool:
        return about.exists(question, place)

    return Grid(question.axes, question.lang, cell, unit if layout.unit else None, exists)


def _shown(question: Question, column: Column, place: Place) -> Value:
    """Return the number, or degrees and minutes; of what has no minutes, whole degrees."""
    if not column.quantity.minutes:
        return question.number(column, place)
    whole = column._replace(decimals=0)
    minutes = question.number(whole, place, 60)
    if isinstance(minutes, Number):
        return f"${degrees_text(Fraction(minutes.scaled, 60))}$"
    degrees = question.number(whole, place)
    return f"${degrees.scaled}°$" if isinstance(degrees, Number) else None


def records_of(question: Question) -> Records:
    """Return the records: one for each place but for the columns."""
    columns = {one.key: one for column in question.page_columns for one in _followed(question, column)}
    own = {column.key: column for column in question.page_columns}
    names = question.columns or (*question.axis_keys, *own)
    keys = [
        key
        for name in names
        for key in ([one.key for one in _followed(question, own[name])] if name in own else [name])
    ]
    axes = {axis.key: axis for axis in question.axes.values() if axis.key}
    fields = [axes[key].field() if key in axes else question.field(columns[key]) for key in keys]
    return Records(tuple(fields), Rows(question, axes, columns, keys))


def _followed(question: Question, column: Column) -> tuple[Column, ...]:
    """Return a column and those that follow it in records."""
    return (column, *question.subject.beside(question, column))


class Rows:
    """Records that are computed as they are asked for."""

    def __init__(
        self,
        question: Question,
        axes: Mapping[str, Axis],
        columns: Mapping[str, Column],
        keys: Sequence[str],
    ) -> None:
        self.question, self.axes, self.columns, self.keys = question, axes, columns, keys

    def __len__(self) -> int:
        return len(self.question)

    def __iter__(self) -> Iterator[tuple[Value, ...]]:
        for place in self._places():
            yield tuple(
                self.axes[key].value(place)
                if key in self.axes
                else self.question.number(self.columns[key], place)
                for key in self.keys
            )

    def _places(self) -> Iterator[Place]:
        named = {name: axis for name, axis in self.question.axes.items() if name != "column"}
        for indices in product(*(range(axis.count) for axis in named.values())):
            place = dict(zip(named, indices, strict=True))
            if self.question.subject.exists(self.question, place):
                yield place
