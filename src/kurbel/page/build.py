"""What was asked for becomes a table: its grid for the page, its records for programs."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextvars import ContextVar
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import groupby, pairwise
from math import prod

from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number, degrees_text
from kurbel.page.axes import Axis, Grid, Place, angle_text, places
from kurbel.page.layouts import Layout
from kurbel.page.quantity import Column, letter
from kurbel.page.subject import Question
from kurbel.page.table import DITTO, UNIT, Cell, Group, Note, Panel, Records, Row, Table, Value
from kurbel.page.table import Column as Printed
from kurbel.reading.amounts import LARGER, TAKEN, printed_in

# A page is held in memory whole; records stream. 100,000 cells take some seconds and 100 MB.
MOST_CELLS = 100_000
MOST_COLUMNS = 500
# Who is told how many numbers a page has, and returns what is called for each of them.
WATCHER: ContextVar[Callable[[int], Callable[[], None]] | None] = ContextVar("watcher", default=None)


def build(question: Question, pages: bool = True) -> Table:
    """Return the table that was asked for; without `pages` only its records, which need no memory.

    Pages have larger units for long numbers and leave columns out that give way, records do not.
    """
    if not pages:
        return _in_units(question.full, pages, False)
    shown = enlarged(question)
    token = TAKEN.set(set())
    try:
        page = _in_units(shown, pages, True)
        if shown is question.full and not TAKEN.get():
            return page
    finally:
        TAKEN.reset(token)
    plain = _in_units(question.full, pages, False)
    return replace(page, records=plain.records, told=(plain.caption, plain.notes))


def enlarged(question: Question) -> Question:
    """Return the question with larger units where its page has long numbers."""
    if not any(column.quantity.unit["en"].partition(",")[0] in LARGER for column in question.page_columns):
        return question
    from kurbel.page import units

    return units.enlarged(question)


def _in_units(question: Question, pages: bool, whole: bool) -> Table:
    if question.units is None:
        return _built(question, pages, whole)
    with printed_in(question.units):
        return _built(question, pages, whole)


def _built(question: Question, pages: bool, whole: bool) -> Table:
    about, layout = question.subject, question.layout
    further = (*_zero(question), *(about.page_notes(question) if pages else ()))
    page = Table(
        key=question.key,
        layout=layout.key,
        lang=question.lang,
        caption=about.caption(question),
        panels=panels(*_watched(*(about.grid or own_grid)(question))) if whole else (),
        records=_records(question.for_data),
        notes=tuple(one if isinstance(one, Note) else Note(one) for one in (*question.below(), *further)),
        source=question.origin,
        templates=tuple(os.fspath(one) for one in (question.templates, layout.folder) if one),
        pause=layout.pause,
        quantities=tuple(letter(column.quantity, question.lang) for column in question.page_columns),
    )
    spoken = question.note or question.caption is not None or question.source is not None
    return question.worded(page) if spoken else page


def _watched(layout: Layout, grid: Grid) -> tuple[Layout, Grid]:
    """Return the grid with somebody told of each number, if anybody wants to be."""
    watcher = WATCHER.get()
    if watcher is None:
        return layout, grid
    passed = watcher(prod(grid.axes[name].size for name in (*layout.down, *layout.across)))

    def cell(place: Place) -> Cell:
        found = grid.cell(place)
        passed()
        return found

    return layout, replace(grid, cell=cell)


def _zero(question: Question) -> Iterator[Label]:
    """Yield the line about angles that do not count from φ = 0."""
    if not question.zero:
        return
    said = {
        "de": "Winkel der Tafel von ${phi} = {zero}$ an; die der Formeln und Totlagen von ${phi} = 0$ an",
        "en": "Angles of the table count from ${phi} = {zero}$, those of formulas and dead centres from"
        " ${phi} = 0$",
    }
    phi = question.layout.angle_symbol
    yield said[question.lang].format(phi=phi, zero=angle_text(question.zero))


def _records(question: Question) -> Records:
    """Return the records, whose columns have the endings of their units as keys have them."""
    records, units = own_records(question), question.units
    if units is None:
        return records
    fields = (field._replace(key=units.key(field.key, field.unit)) for field in records.fields)
    return records._replace(fields=tuple(fields))


def own_grid(question: Question) -> tuple[Layout, Grid]:
    """Return the layout, and the axes of the page with what stands at their places."""
    about, layout, columns = question.subject, question.layout, question.page_columns
    if not columns:
        raise ProblemError(question.columnless)
    check_size(layout, {name: axis.size for name, axis in question.axes.items()})

    def cell(place: Place) -> Cell:
        column = columns[place.get("column", 0)]
        shown, marks = shown_at(question, column, place), about.marks(question, column, place)
        return Cell(shown, marks, about.tone(question, column, place))

    def unit(place: Place) -> Label:
        return columns[place["column"]].quantity.unit_beside(question.lang)

    exists = partial(about.exists, question)
    return layout, Grid(question.axes, question.lang, cell, unit if layout.unit else None, exists)


def shown_at(question: Question, column: Column, place: Place) -> Value:
    """Return the number, or degrees and minutes; of what has no minutes, whole degrees."""
    if not column.quantity.minutes:
        number = question.number(column, place)
        if question.layout.bare_zeros and number == Number(0, column.places) and _is_zero(question, place):
            return Number(0, 0)
        return number
    whole = column._replace(decimals=0)
    minutes = question.number(whole, place, 60)
    if isinstance(minutes, Number):
        return f"${degrees_text(Fraction(minutes.scaled, 60))}$"
    degrees = question.number(whole, place)
    return f"${degrees.scaled}°$" if isinstance(degrees, Number) else None


def _is_zero(question: Question, place: Place) -> bool:
    """Tell whether a number is zero to all digits that can be printed, not only to those of its column."""
    finest = question.finest
    number = finest.number(finest.page_columns[place.get("column", 0)], place)
    return isinstance(number, Number) and not number.scaled


def own_records(question: Question) -> Records:
    """Return the records that the subject has of a question, else one for each place."""
    rows = question.subject.rows
    return rows(question) if rows else records_of(question)


def records_of(question: Question) -> Records:
    """Return the records: one for each place but for the columns."""
    columns = {one.key: one for column in question.page_columns for one in _followed(question, column)}
    own = {column.key: column for column in question.page_columns}
    names = question.named or (*question.axis_keys, *own)
    axes = {axis.key: axis for axis in question.axes.values() if isinstance(axis, Axis)}
    keys = [
        key
        # What tells records apart is a column, asked for or not.
        for name in (*(one for one in question.apart if one not in names), *names)
        for key in ([one.key for one in _followed(question, own[name])] if name in own else [name])
    ]
    fields = [axes[key].field() if key in axes else question.field(columns[key]) for key in keys]
    return Records(tuple(fields), Rows(question, axes, columns, keys))


def _followed(question: Question, column: Column) -> tuple[Column, ...]:
    """Return a column and those that follow it in records."""
    return (column, *question.subject.beside(question, column))


class Rows:
    """Records that are computed as they are asked for."""

    def __init__(
        self, question: Question, axes: Mapping[str, Axis], columns: Mapping[str, Column], keys: Sequence[str]
    ) -> None:
        self.question, self.axes, self.columns, self.keys = question, axes, columns, keys

    def __len__(self) -> int:
        return len(self.question)

    def __iter__(self) -> Iterator[tuple[Value, ...]]:
        question = self.question
        sizes = {name: axis.count for name, axis in question.axes.items() if name != "column"}
        for place in places(sizes, partial(question.subject.exists, question)):
            yield tuple(
                self.axes[key].value(place) if key in self.axes else question.number(self.columns[key], place)
                for key in self.keys
            )


def panels(layout: Layout, grid: Grid) -> tuple[Panel, ...]:
    across = grid.places(layout.across)
    return tuple(_panel(layout, grid, block) for block in _blocks(across, layout.block))


def check_size(layout: Layout, sizes: Mapping[str, int]) -> None:
    """Raise ProblemError for a page of so many places that it cannot be held."""
    cells, across = prod(sizes.values()), prod(sizes[name] for name in layout.across)
    if cells > MOST_CELLS:
        raise ProblemError(
            f"a page of {cells} numbers is too long; at most {MOST_CELLS} are set, use -f csv or -f json"
        )
    # A panel of a block goes on below.
    if across > MOST_COLUMNS and not layout.block:
        raise ProblemError(
            f"a page of {across} columns is too wide; at most {MOST_COLUMNS} are set, use -f csv or -f json"
        )


def _blocks(places: list[Place], most: int) -> Iterator[list[Place]]:
    """Split into as few blocks as needed, of equal size, the larger ones last."""
    count = -(-len(places) // most) if most else 1
    ends = [len(places) * block // count for block in range(count + 1)]
    for start, end in pairwise(ends):
        yield places[start:end]


def _panel(layout: Layout, grid: Grid, across: list[Place]) -> Panel:
    heads = [name for name in layout.down if name not in layout.stub]
    # Where all heads stand in the stub, the outermost parts the groups.
    outer = heads or (layout.down[:1] if len(layout.down) > 1 else ())
    down = grid.places(layout.down)
    groups = [list(rows) for _, rows in groupby(down, key=lambda place: [place[name] for name in outer])]
    columns = _merged(tuple(_column(layout, grid, place) for place in across))
    return Panel(
        stub=tuple(_stub_column(layout, grid, name) for name in layout.stub),
        columns=(*columns, Printed(UNIT, ("",))) if grid.unit else columns,
        groups=tuple(
            Group(
                tuple(_rows(layout, grid, rows, across)),
                # What has one place only stands in the caption.
                ", ".join(grid.axes[name].over_group(rows[0]) for name in heads if grid.axes[name].size > 1),
            )
            for rows in groups
        ),
    )


def _stub_column(layout: Layout, grid: Grid, name: str) -> Printed:
    own = layout.stub_headings.get(name)
    return Printed(name, (own[grid.lang] if own else grid.axes[name].stub_heading(),))


def _rows(layout: Layout, grid: Grid, rows: list[Place], across: list[Place]) -> Iterator[Row]:
    above: list[Cell | None] = [None] * len(layout.stub)
    for place in rows:
        stub = [Cell(grid.axes[name].stub(place)) for name in layout.stub]
        # Only outer heads are carried over several rows.
        shown = [
            Cell(DITTO) if cell == before and index < len(stub) - 1 else cell
            for index, (cell, before) in enumerate(zip(stub, above, strict=True))
        ]
        above = list(stub)
        unit = (Cell(grid.unit(place)),) if grid.unit else ()
        yield Row(tuple(shown), (*(grid.cell({**place, **other}) for other in across), *unit))


def _column(layout: Layout, grid: Grid, place: Place) -> Printed:
    """A column with all its heads as spanners; `_merged` makes headings of those that span nothing."""
    labels = [label for name in layout.across for label in grid.axes[name].heads(place)]
    key = "-".join(str(place[name]) for name in layout.across)
    lines = max(grid.axes[name].lines for name in layout.across)
    return Printed(key, tuple(labels[-lines:]), tuple(labels[:-lines]))


def _merged(columns: tuple[Printed, ...]) -> tuple[Printed, ...]:
    """Turn spanners over a single column into lines of its heading."""
    paths = [column.spanners for column in columns]
    around = [(), *paths, ()]
    return tuple(
        _own_heading(column, before, after)
        for column, before, after in zip(columns, around, around[2:], strict=False)
    )


def _own_heading(column: Printed, before: tuple[Label, ...], after: tuple[Label, ...]) -> Printed:
    shared = len(column.spanners)
    while shared and column.spanners[:shared] not in (before[:shared], after[:shared]):
        shared -= 1
    return Printed(column.key, column.spanners[shared:] + column.heading, column.spanners[:shared])
