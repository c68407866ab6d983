"""The table model: every printed part of a table has a name, and no part knows a format.

A *label* is a short piece of prose with formulas between dollar signs, written in the notation of
`labels.py`: "Kolbenweg $x/R$". A mark such as [^a] inside a label or in `Cell.notes` points to a note.
Numbers in formulas are written with a decimal point; the format sets the mark of the language.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple

from kurbel.exact.numerals import Label, Number

_MARK = re.compile(r"\[\^([^\]]+)\]")


class Ditto(Enum):
    """A stub cell that belongs to the one above it."""

    DITTO = "ditto"


DITTO = Ditto.DITTO


# The key of a last column that says the unit of each row.
UNIT = "unit"


class Cell(NamedTuple):
    """A number, a label, the continuation of the cell above (stub only), or None for a missing value."""

    value: Number | Label | Ditto | None
    notes: tuple[str, ...] = ()


class Column(NamedTuple):
    """A column: its key, the lines of its heading, and the spanners above it, outermost first."""

    key: str
    heading: tuple[Label, ...]
    spanners: tuple[Label, ...] = ()


class Row(NamedTuple):
    stub: tuple[Cell, ...]
    cells: tuple[Cell, ...]


class Group(NamedTuple):
    """Rows that belong together; a rule or a space parts them from the next group."""

    rows: tuple[Row, ...]
    label: Label = ""


@dataclass(frozen=True, slots=True)
class Panel:
    """One block of columns. A page that is too wide goes on in further panels below the first."""

    stub: tuple[Column, ...]
    columns: tuple[Column, ...]
    groups: tuple[Group, ...]

    def __post_init__(self) -> None:
        for row in self.rows():
            if (len(row.stub), len(row.cells)) != (len(self.stub), len(self.columns)):
                raise ValueError(
                    f"a row has {len(row.stub)} + {len(row.cells)} cells under"
                    f" {len(self.stub)} + {len(self.columns)} columns"
                )

    def rows(self) -> Iterator[Row]:
        for group in self.groups:
            yield from group.rows


class Note(NamedTuple):
    """A line below the table; without a mark it speaks of the whole table."""

    text: Label
    mark: str = ""


class Field(NamedTuple):
    """A column of the records: a stable key, and what it means."""

    key: str
    name: str
    symbol: Label = ""
    unit: str = ""
    decimals: int | None = None
    method: str = ""


Value = Number | Label | None


class Records(NamedTuple):
    """The same values for programs: one record a point, whatever the arrangement of the page.

    `rows` may be any iterable that can be run through again; it need not fit in memory.
    """

    fields: tuple[Field, ...]
    rows: Iterable[Sequence[Value]]


@dataclass(frozen=True, slots=True)
class Table:
    """A finished table. `key` is its name for cross references, without a prefix: "kinematics".

    `layout` names the templates' folder, where it is not the key; `templates` is the folder of the user's in
    which that lies, nothing where it is kurbel's. `pause` is the number of rows between small spaces, 0 for
    none; None leaves it to the step of the rows.
    """

    key: str
    lang: str
    caption: Label
    panels: tuple[Panel, ...]
    records: Records
    notes: tuple[Note, ...] = ()
    source: Label = ""
    layout: str = ""
    templates: str = ""
    pause: int | None = None

    def __post_init__(self) -> None:
        defined = {note.mark for note in self.notes}
        missing = sorted(set(self._marks()) - defined)
        if missing:
            raise ValueError(f"no note explains the mark {', '.join(missing)}")

    def _marks(self) -> Iterator[str]:
        yield from _MARK.findall(self.caption)
        for panel in self.panels:
            for column in panel.stub + panel.columns:
                for label in column.heading + column.spanners:
                    yield from _MARK.findall(label)
            for group in panel.groups:
                yield from _MARK.findall(group.label)
            for row in panel.rows():
                for cell in row.stub + row.cells:
                    yield from cell.notes
                    if isinstance(cell.value, str):
                        yield from _MARK.findall(cell.value)
