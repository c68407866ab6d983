"""The books: a folder each, with a source.toml and the printed values of its tables as characters.

    sources/<book>/source.toml     citation, what is stated and what is inferred, and [tables.<name>]
    sources/<book>/<name>.csv      place;quantity;ratio;phi;...;method;formula;way;label;printed

A table's key is <book>-<name>. `place` names the cell. What it is a `quantity` of kurbel's says, at ratio and
phi, at epsilon and stroke, or at ratio and arm, or else a `formula` from other cells by their places. The
`way` says how the book came to it from what it had printed; without one the formula does. `printed` is what
the book has; a cell that it has not is there for others.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any, ClassVar, NamedTuple

from msgspec import Struct

from kurbel.books.expression import Expression
from kurbel.books.formulas.table import FormulaTable
from kurbel.books.printed_value import Printed, printed_value
from kurbel.errors import NotationError, SourceError
from kurbel.page.layouts import LANGUAGES, Notes, Words
from kurbel.reading.csv_file import NONE, Head, Kind, place, read_rows, shown, whole_head
from kurbel.reading.toml_file import Fault, TomlFile, TomlKind, about

KIND = Kind("source", "cell", SourceError)
SOURCE = TomlKind("source", SourceError, 200_000, "a source has a citation and tables", "book/source.toml")
AXIS_KEYS = ("ratio", "phi", "epsilon", "stroke", "arm")
COLUMNS = ("place", "quantity", *AXIS_KEYS, "method", "formula", "way", "label", "printed")
NEEDED = ("place", "printed")
# As many cells may build on one another.
DEEPEST = 50
_KEY = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]*")


class SourceCell(NamedTuple):
    """A printed value with what it is, in the words of the file."""

    place: str
    printed: Printed | None
    quantity: str
    axes: Mapping[str, str]
    method: str
    line: int
    formula: Expression | None = None
    way: Expression | None = None
    label: str = ""

    @property
    def names(self) -> set[str]:
        """The places of the other cells that its value is made of."""
        return {name for one in (self.formula, self.way) if one for name in one.names}


def _is_text(entry: object) -> bool:
    # The no-break space is typography, though it counts as not printable.
    return isinstance(entry, str) and entry.replace("\u00a0", " ").isprintable()


class BookWords(Words):
    """A line of text in each language, or one for both."""

    MUST = "a line of text, or one each in de and en"

    @classmethod
    def read(cls, given: Any, name: str) -> BookWords:
        words = cls(super().read(given, name))
        if not all(map(_is_text, words.values())):
            raise Fault(cls.MUST)
        return words


class BookNotes(dict[str, Sequence[str]]):
    """Lines of text in each language, if there are any."""

    SCHEMA: ClassVar[Mapping[str, Any]] = Notes.SCHEMA

    @classmethod
    def read(cls, given: Any, _: str) -> BookNotes:
        notes: dict[str, Any] = {lang: [] for lang in LANGUAGES} | (
            given if isinstance(given, dict) else {"": 0}
        )
        known = all(isinstance(lines, list) and all(map(_is_text, lines)) for lines in notes.values())
        if not known or len(notes) > len(LANGUAGES):
            raise Fault("lists of lines, notes.de and notes.en")
        return cls(notes)


class TableFile(Struct, frozen=True, forbid_unknown_fields=True):
    """What source.toml says of a table."""

    NOUN: ClassVar[str] = "key of a table"
    SHAPE: ClassVar[str] = "a section, such as [tables.112]"

    title: Annotated[BookWords, about("title")] = BookWords(de="", en="")
    notes: Annotated[BookNotes, about("lines below the collation")] = BookNotes(de=(), en=())
    method: Annotated[str, about("method by which the book computes; default: exact")] = "exact"
    layout: Annotated[str, about("layout that prints the table as the book does")] = ""


class FormulasFile(Struct, frozen=True, forbid_unknown_fields=True):
    """What source.toml says of the formulas of a section."""

    NOUN: ClassVar[str] = "key of formulas"
    SHAPE: ClassVar[str] = "a section, such as [formulas.equations]"

    title: Annotated[BookWords, about("title")] = BookWords(de="", en="")
    notes: Annotated[BookNotes, about("lines below the collation")] = BookNotes(de=(), en=())
    letters: Annotated[dict[str, str], about("what letters are made of")] = {}
    labels: Annotated[dict[str, str], about("how letters are printed that are not named so")] = {}


class BookFile(Struct, frozen=True, forbid_unknown_fields=True):
    """What source.toml says. `name`, `example` and `ratio` are for worked examples: what the book is called
    there, what it calls them, and its letters of the crank ratio."""

    NOUN: ClassVar[str] = "key of a source"

    citation: Annotated[BookWords, about("author, title, place")] = BookWords(de="", en="")
    stated: Annotated[BookWords, about("what the copy says of itself")] = BookWords(de="", en="")
    inferred: Annotated[BookWords, about("what it does not say")] = BookWords(de="", en="")
    tables: Annotated[dict[str, TableFile], about("its tables")] = {}
    formulas: Annotated[dict[str, FormulasFile], about("its formulas")] = {}
    name: Annotated[str, about("short name")] = ""
    example: Annotated[BookWords, about("what it calls an example")] = BookWords(de="", en="")
    ratio: Annotated[str, about("letters of the crank ratio")] = "R:L"


class SourceTable:
    """A table or worked example of a book."""

    def __init__(self, book: Book, name: str, given: TableFile) -> None:
        self.book = book
        self.name = name
        self.key = f"{book.key}-{name}"
        self.title = given.title
        self.notes = given.notes
        self.method = given.method
        self.layout = given.layout
        self.file = book.file_of(name)

    @cached_property
    def cells(self) -> tuple[SourceCell, ...]:
        """The printed values in their order."""
        starts = f"it starts with its heads, {';'.join(COLUMNS)}"
        cells = tuple(read_rows(self.file, KIND, _head, self._cell, starts, NONE))
        places = [cell.place for cell in cells]
        for cell in cells:
            if places.count(cell.place) > 1:
                raise SourceError(f"{self.at(cell)}: the place {cell.place} is given twice")
            for unknown in sorted(cell.names - {*places}):
                raise SourceError(f"{self.at(cell)}: {unknown} in a formula is no place here")
        self._check_circles(cells)
        if not any(cell.printed for cell in cells):
            raise SourceError(f"{shown(self.file)} has no printed value below its heads")
        return cells

    def at(self, cell: SourceCell) -> str:
        """Return where the cell stands, for the start of a sentence."""
        return place(shown(self.file), cell.line)

    def _cell(self, texts: list[str], head: Head, line: int) -> SourceCell:
        row = {column.name: text for column, text in zip(head.columns, texts, strict=True)}
        known = {name: row.get(name, "").strip() for name in COLUMNS}
        if not known["place"].isidentifier():
            raise NotationError(f'the place "{known["place"][:40]}" is no name; write it as x_45')
        if not known["quantity"] and not known["formula"]:
            raise NotationError(f"{known['place']} has neither a quantity nor a formula")
        if known["quantity"] and known["formula"]:
            raise NotationError(
                f"{known['place']} has a quantity and a formula; leave one out, or call the formula way"
            )
        return SourceCell(
            known["place"],
            printed_value(known["printed"]) if known["printed"] else None,
            known["quantity"],
            {axis: known[axis] for axis in AXIS_KEYS if known[axis]},
            known["method"] or self.method,
            line,
            Expression(known["formula"]) if known["formula"] else None,
            Expression(known["way"], later=True) if known["way"] else None,
            known["label"] or ("" if known["quantity"] else known["place"].replace("_", " ")),
        )

    def _check_circles(self, cells: Sequence[SourceCell]) -> None:
        """Raise SourceError where a cell's value would need itself."""
        settled: set[str] = set()
        rounds = 0
        while left := [cell for cell in cells if cell.place not in settled]:
            ready = [cell.place for cell in left if cell.names <= settled]
            if not ready:
                raise SourceError(f"{self.at(left[0])}: {left[0].place} names itself, by way of other cells")
            settled |= {*ready}
            rounds += 1
            if rounds > DEEPEST:
                raise SourceError(
                    f"{self.at(left[0])}: more than {DEEPEST} cells build on one another up to {ready[0]}"
                )


class Book:
    """A book: its citation, what its text says of itself, what was inferred, and its tables."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.key = folder.name
        if not _KEY.fullmatch(self.key):
            raise SourceError(f"the folder {shown(folder)} names a book; use letters, digits, - and _ alone")
        self.file = TomlFile(folder / "source.toml", SOURCE)
        self.given = self.file.read(BookFile)
        self.citation = self.given.citation
        self.stated = self.given.stated
        self.inferred = self.given.inferred
        for kind, names in (("tables", self.given.tables), ("formulas", self.given.formulas)):
            for name in names:
                self._check_name(kind, name)
        self.tables = [SourceTable(self, name, entry) for name, entry in self.given.tables.items()]
        self.formulas = [FormulaTable(self, name, entry) for name, entry in self.given.formulas.items()]

    def file_of(self, name: str) -> Path:
        """Return the file of a table."""
        return self.folder / f"{name}.csv"

    @property
    def all_tables(self) -> list[SourceTable | FormulaTable]:
        """Its tables of values, then those of formulas."""
        return [*self.tables, *self.formulas]

    def _check_name(self, kind: str, name: str) -> None:
        if not _KEY.fullmatch(name):
            raise self.file.error(
                (kind, name), f'the table "{name[:40]}" cannot be a file; use letters, digits, - and _'
            )
        if kind == "formulas" and name in self.given.tables:
            raise self.file.error((kind, name), f'there is a table "{name}" of values; give one another name')


def books(folder: str | os.PathLike[str] | None = None) -> Iterator[Book]:
    """Yield the books that kurbel knows, and those in a folder of the user's."""
    own = Path(__file__).parent / "sources"
    for path in (own, *([Path(folder)] if folder else [])):
        try:
            if folder and path == Path(folder) and not path.is_dir():
                raise SourceError(f"cannot read the sources {shown(folder)}: there is no such folder")
            found = [each for each in sorted(path.iterdir()) if (each / "source.toml").is_file()]
        except OSError as error:
            raise SourceError(f"cannot read the sources {shown(path)}: {error.strerror}") from None
        if not found:
            raise SourceError(f"{shown(path)} has no books: no folder in it has a source.toml")
        yield from map(Book, found)


def source_tables(folder: str | os.PathLike[str] | None = None) -> Mapping[str, SourceTable]:
    """Return every table of values of every book by its key; the user's go before kurbel's own."""
    return {key: table for key, table in all_tables(folder).items() if isinstance(table, SourceTable)}


def all_tables(folder: str | os.PathLike[str] | None = None) -> Mapping[str, SourceTable | FormulaTable]:
    """Return the same with the tables of formulas."""
    return {table.key: table for book in books(folder) for table in book.all_tables}


def _head(line: str) -> Head:
    head = whole_head(line, ";")
    names = [column.name for column in head.columns]
    if len({*names}) != len(names):
        raise NotationError("a column stands there twice")
    for name in names:
        if name not in COLUMNS:
            raise NotationError(f'there is no column "{name[:40]}"; choose from {", ".join(COLUMNS)}')
    for needed in NEEDED:
        if needed not in names:
            raise NotationError(f"there is no column {needed}, which every source has")
    return head
