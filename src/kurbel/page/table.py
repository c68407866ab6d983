"""The table model: every printed part of a table has a name, and no part knows a format.

A *label* is a short piece of prose with formulas between dollar signs, written in the notation of
`labels.py`: "Kolbenweg $x/R$". A mark such as [^a] inside a label or in `Cell.notes` points to a note.
Numbers in formulas are written with a decimal point; the format sets the mark of the language.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from enum import Enum
from functools import partial
from itertools import groupby
from typing import TYPE_CHECKING, Literal, NamedTuple, TypeAlias

from kurbel.errors import LayoutError, ProblemError
from kurbel.exact.numerals import Label, Number
from kurbel.page.labels import WHITE, Mark, parse
from kurbel.page.quantity import Letter

if TYPE_CHECKING:
    from kurbel.page.steps import Steps

_MARK = re.compile(r"\[\^([^\]]+)\]")
# Whatever is longer is a text beside the table, and no words of a page.
LONGEST = 2000
_MARKED = r"(?s)\s*\[\^([^\]\s]+)\]\s*(.*)"


class Ditto(Enum):
    """A stub cell that belongs to the one above it."""

    DITTO = "ditto"


DITTO = Ditto.DITTO


# The key of a last column that says the unit of each row.
UNIT = "unit"


# How what a cell says is to be taken, for those who see colours; its words say it, too.
Tone: TypeAlias = Literal["", "right", "near", "other", "wrong"]


class Cell(NamedTuple):
    """A number, a label, the continuation of the cell above (stub only), or None for a missing value."""

    value: Number | Label | Ditto | None
    notes: tuple[str, ...] = ()
    tone: Tone = ""


class Column(NamedTuple):
    """A column: its key, the lines of its heading, and the spanners above it, outermost first."""

    key: str
    heading: tuple[Label, ...]
    spanners: tuple[Label, ...] = ()


# The spanners above a column.
Path: TypeAlias = tuple[Label, ...]


class Row(NamedTuple):
    stub: tuple[Cell, ...]
    cells: tuple[Cell, ...]


class Group(NamedTuple):
    """Rows that belong together; a rule or a space parts them from the next group."""

    rows: tuple[Row, ...]
    label: Label = ""


@dataclass(frozen=True, eq=False, repr=False)
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


# The name of a page among those of its layout, made where it is asked for.
Variant: TypeAlias = Callable[[], str]


class Request(NamedTuple):
    """What a page was made of: its command and the options that count, as they were given."""

    command: str
    options: Mapping[str, object]


class Records(NamedTuple):
    """The same values for programs: one record a point, whatever the arrangement of the page.

    `rows` may be any iterable that can be run through again; it need not fit in memory.
    """

    fields: tuple[Field, ...]
    rows: Iterable[Sequence[Value]]


@dataclass(frozen=True, eq=False, repr=False)
class Table:
    """A finished table. `key` is its name for cross references, without a prefix: "kinematics".

    `layout` names the templates' folder, where it is not the key; `templates` are the user's folders with
    templates, the first of which outdoes the others. `pause` is the number of rows between small spaces, 0
    for none; None leaves it to the step of the rows. `variant` gives the key with what was asked for beside
    the defaults of the layout: "kinematics-ratio-1-4". `quantities` are those of its columns. An interactive
    page has `steps`, of which this is the first that is shown. `told` are caption and notes as they stand
    with the records, where those of the page have other units. `request` is what was asked for.
    """

    key: str
    lang: str
    caption: Label
    panels: tuple[Panel, ...]
    records: Records
    notes: tuple[Note, ...] = ()
    source: Label = ""
    layout: str = ""
    templates: tuple[str, ...] = ()
    pause: int | None = None
    variant: Variant | None = None
    quantities: tuple[Letter, ...] = ()
    steps: Steps | None = None
    told: tuple[Label, tuple[Note, ...]] | None = None
    request: Request | None = None

    @property
    def anchor(self) -> str:
        """A name for cross references that another page of the layout has not: "kinematics-ratio-1-4"."""
        # Whoever gives the table another key has named it.
        name = self.variant() if self.variant else ""
        return name if name.startswith(f"{self.key}-") else self.key

    def __post_init__(self) -> None:
        defined = {note.mark for note in self.notes}
        missing = sorted(set(self._marks()) - defined)
        if missing:
            raise ValueError(f"no note explains the mark {', '.join(missing)}")

    def __reduce__(self) -> tuple[object, ...]:
        """Return how the same is made with what it computes as it is asked for."""
        given = {field.name: getattr(self, field.name) for field in fields(self)}
        given["records"] = self.records._replace(rows=tuple(map(tuple, self.records.rows)))
        given["variant"] = partial(str, self.variant()) if self.variant else None
        return partial(type(self), **given), ()

    def letters(self) -> tuple[Letter, ...]:
        """Return its quantities, the axes first; what has neither a letter nor a unit is none."""
        # Columns are computed by a method, and axes are not.
        axes = [
            Letter(field.name, field.symbol, field.unit)
            for field in self.records.fields
            if field.symbol and not field.method
        ]
        columns = [one for one in self.quantities if one.symbol or one.unit]
        return tuple(dict.fromkeys((*axes, *columns)))

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


class HeadCell(NamedTuple):
    """A cell of the head. `level` counts the spanners above it: 0 for the outermost one.

    A spanner has its name as the first line and, as a second, the symbol that all columns below it share.
    """

    lines: tuple[str, ...]
    kind: Literal["stub", "spanner", "heading"]
    first: int
    across: int = 1
    down: int = 1
    level: int = 0

    @property
    def last(self) -> int:
        return self.first + self.across - 1

    @property
    def text(self) -> str:
        """All lines of it on one."""
        return " ".join(line for line in self.lines if line)


def shared_symbols(panel: Panel) -> dict[Path, Label]:
    """Return, by the spanners above them, the symbols that stand in the innermost of these.

    They are the last lines of the headings, where all columns under each spanner share theirs; nothing where
    those of any differ, for the line would then remain.
    """
    paths = [column.spanners for column in panel.columns if column.spanners]
    shared = {path: _shared([one.heading for one in panel.columns if one.spanners == path]) for path in paths}
    return shared if all(shared.values()) else {}


def _shared(headings: Sequence[tuple[Label, ...]]) -> Label:
    """Return the last line of all headings, where it is the same formula below other lines; else nothing."""
    lasts = {heading[-1] for heading in headings}
    ready = len(lasts) == 1 and "$" in headings[0][-1] and all(heading[:-1] for heading in headings)
    return lasts.pop() if ready else ""


def head_rows(panel: Panel) -> tuple[tuple[HeadCell, ...], ...]:
    """Return the rows of the head, spanners merged where neighbours share them and all above them."""
    columns = panel.stub + panel.columns
    shared = shared_symbols(panel)
    levels = max(len(column.spanners) for column in columns)
    rows = []
    for level in range(levels + 1):
        cells = [
            *_spanners(columns, level, shared),
            *_headings(columns, level, levels, len(panel.stub), bool(shared)),
        ]
        rows.append(tuple(sorted(cells, key=lambda cell: cell.first)))
    return tuple(rows)


def _spanners(columns: Sequence[Column], level: int, shared: Mapping[Path, Label]) -> Iterator[HeadCell]:
    first = 0
    for path, members in groupby(columns, key=lambda column: column.spanners[: level + 1]):
        across = len(list(members))
        if len(path) > level:
            lines = (path[level], shared[path]) if path in shared else (path[level],)
            yield HeadCell(lines, "spanner", first, across, 1, level)
        first += across


def _headings(
    columns: Sequence[Column], level: int, levels: int, stubs: int, without_symbols: bool
) -> Iterator[HeadCell]:
    for place, column in enumerate(columns):
        if len(column.spanners) == level:
            kind: Literal["stub", "heading"] = "stub" if place < stubs else "heading"
            lines = column.heading[:-1] if without_symbols and column.spanners else column.heading
            yield HeadCell(lines, kind, place, 1, levels - level + 1, level)


def check_label(label: str) -> None:
    """Raise a KurbelError unless cross references can bear the label."""
    if not isinstance(label, str):
        raise ProblemError(f"label is {str(label)[:40]}; it must be text")
    if any(not (one.isascii() and (one.isalnum() or one in "-.:")) for one in label):
        raise ProblemError(f'label "{label[:40]}" may have letters, digits and the signs -.: only')


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Worded:
    """What is said of a page in one's own words, in the notation of labels.

    None as `caption` or `source` leaves it to the page; an empty source leaves out the line. Each
    `note` stands below those of the page; a mark such as [^a] in a caption, a source or a note points to one.
    `templates` is a folder with templates of one's own.
    """

    caption: Label | None = None
    note: tuple[Note, ...] = ()
    source: Label | None = None
    templates: str | os.PathLike[str] | None = None

    def __repr__(self) -> str:
        # Written once for all questions: to compile it for each is a hundredth of a start.
        said = ", ".join(f"{one.name}={getattr(self, one.name)!r}" for one in fields(self))
        return f"{type(self).__qualname__}({said})"

    def worded(self, table: Table) -> Table:
        """Return the page with these words. Raises ProblemError for a mark without its note, or with two."""
        marks = [note.mark for note in (*table.notes, *self.note) if note.mark]
        if twice := [mark for mark in marks if marks.count(mark) > 1]:
            raise ProblemError(
                f"two notes have the mark {twice[0]}; give yours another, as --note '[^1] ...'"
            )
        for said in (self.caption or "", self.source or "", *(note.text for note in self.note)):
            for part in parse(said):
                if isinstance(part, Mark) and " " in part.text:
                    raise ProblemError(
                        f"the mark [^{part.text}] has a space; a mark is a word or a number, such as [^1]"
                    )
                if isinstance(part, Mark) and part.text not in marks:
                    raise ProblemError(
                        f"the mark [^{part.text}] has no note; give it one, as --note '[^{part.text}] ...'"
                    )
        return replace(
            table,
            caption=self.caption or table.caption,
            notes=(*table.notes, *self.note),
            source=table.source if self.source is None else self.source,
        )


def own_words(values: Mapping[str, object]) -> Mapping[str, object]:
    """Return the options `caption`, `note` and `source` as a page takes them. Raises ProblemError."""
    caption, source, notes = values["caption"], values["source"], values["note"]
    if caption is not None and not _said(caption, "caption"):
        raise ProblemError("the caption is empty; give its words, or leave --caption out")
    several = notes if isinstance(notes, Iterable) and not isinstance(notes, str) else (notes,)
    return {
        **values,
        "caption": None if caption is None else _said(caption, "caption"),
        "note": tuple(_note(one) for one in several if one is not None),
        "source": None if source is None else _said(source, "source"),
    }


def _note(given: object) -> Note:
    if isinstance(given, Note):
        return given
    said = _said(given, "note")
    marked = re.fullmatch(_MARKED, said)
    mark, text = (marked[1], marked[2]) if marked else ("", said)
    if not text:
        raise ProblemError("a note is empty; give its words, or leave --note out")
    return Note(text, mark)


def _said(given: object, name: str) -> Label:
    """Return a text that can be set, white space as one space each."""
    if not isinstance(given, str):
        raise ProblemError(f"the {name} is {str(given)[:40]}; it must be text")
    text = WHITE.sub(" ", given).strip()
    if len(text) > LONGEST:
        raise ProblemError(f"the {name} has {len(text)} characters; at most {LONGEST} are set")
    from unicodedata import category

    if any(category(one) in ("Cc", "Cs") for one in text):
        raise ProblemError(f"the {name} has a character that cannot be printed; write letters and signs only")
    try:
        parse(text)
    except LayoutError as error:
        raise ProblemError(str(error).replace("the label", f"the {name}", 1)) from None
    return text
