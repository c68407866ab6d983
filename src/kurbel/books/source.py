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
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

from kurbel.books.expression import Expression
from kurbel.books.printed_value import Printed, printed_value
from kurbel.errors import NotationError, SourceError
from kurbel.reading.csv_columns import NONE, Head, read_rows, whole_head
from kurbel.reading.csv_lines import Kind, place, shown

KIND = Kind("source", "cell", SourceError)
AXES = ("ratio", "phi", "epsilon", "stroke", "arm")
COLUMNS = ("place", "quantity", *AXES, "method", "formula", "way", "label", "printed")
NEEDED = ("place", "printed")
LANGUAGES = ("de", "en")
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
    formula: Expression | None
    way: Expression | None
    label: str
    line: int


class SourceTable:
    """A table or worked example of a book."""

    def __init__(self, book: Book, name: str, given: Any) -> None:
        if not isinstance(given, dict) or not _KEY.fullmatch(name):
            raise SourceError(f"{book.path}: the table {name[:40]!r} must be a section, such as [tables.112]")
        self.book = book
        self.name = name
        self.key = f"{book.key}-{name}"
        self.title = _words(book, given, "title")
        self.notes = _notes(book, given)
        self.method = str(given.get("method", "exact"))
        self.layout = str(given.get("layout", ""))
        self.file = book.folder / f"{name}.csv"

    @cached_property
    def cells(self) -> tuple[SourceCell, ...]:
        """The printed values in their order."""
        cells = tuple(_cells(self.file, self.method))
        places = [cell.place for cell in cells]
        for cell in cells:
            if places.count(cell.place) > 1:
                raise SourceError(f"{_at(self.file, cell)}: the place {cell.place} is given twice")
            named = {name for one in (cell.formula, cell.way) if one for name in one.names}
            for unknown in sorted(named - {*places}):
                raise SourceError(f"{_at(self.file, cell)}: {unknown} in a formula is no place here")
        _check_circles(self.file, cells)
        if not any(cell.printed for cell in cells):
            raise SourceError(f"{shown(self.file)} has no printed value below its heads")
        return cells

    def at(self, cell: SourceCell) -> str:
        """Return where the cell stands, for the start of a sentence."""
        return _at(self.file, cell)


class Book:
    """A book: its citation, what its text says of itself, what was inferred, and its tables."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.key = folder.name
        if not _KEY.fullmatch(self.key):
            raise SourceError(f"the folder {shown(folder)} names a book; use letters, digits, - and _ alone")
        given = _toml(folder / "source.toml")
        self.citation = _words(self, given, "citation")
        self.stated = _words(self, given, "stated")
        self.inferred = _words(self, given, "inferred")
        tables = given.get("tables", {})
        if not isinstance(tables, dict):
            raise SourceError(f"{self.path}: tables must be sections, such as [tables.112]")
        self.tables = [SourceTable(self, name, entry) for name, entry in tables.items()]

    @property
    def path(self) -> str:
        return shown(self.folder / "source.toml")


def books(folder: str | os.PathLike[str] | None = None) -> Iterator[Book]:
    """Yield the books that kurbel knows, and those in a folder of the user's."""
    own = Path(__file__).parent / "sources"
    for path in (own, *([Path(folder)] if folder else [])):
        if folder and path == Path(folder) and not path.is_dir():
            raise SourceError(f"cannot read the sources {shown(folder)}: there is no such folder")
        found = [each for each in sorted(path.iterdir()) if (each / "source.toml").is_file()]
        if not found:
            raise SourceError(f"{shown(path)} has no books: no folder in it has a source.toml")
        yield from map(Book, found)


def source_tables(folder: str | os.PathLike[str] | None = None) -> Mapping[str, SourceTable]:
    """Return every table of every book by its key; the user's go before kurbel's own."""
    return {table.key: table for book in books(folder) for table in book.tables}


def _toml(path: Path) -> dict[str, Any]:
    try:
        return tomllib.loads(path.read_text(encoding="utf-8-sig"))
    except (OSError, ValueError, RecursionError) as error:
        raise SourceError(f"cannot read the source {shown(path)}: {error}") from None


def _words(book: Book, given: Mapping[str, Any], key: str) -> Mapping[str, str]:
    """A text in each language, or one for all."""
    entry = given.get(key, "")
    texts = dict.fromkeys(LANGUAGES, entry) if isinstance(entry, str) else entry
    if not isinstance(texts, dict) or not all(_is_text(texts.get(lang)) for lang in LANGUAGES):
        raise SourceError(f"{book.path}: {key} must be a line of text, or one each as {key}.de and {key}.en")
    return {lang: texts[lang] for lang in LANGUAGES}


def _is_text(entry: object) -> bool:
    # The no-break space is typography, though it counts as not printable.
    return isinstance(entry, str) and entry.replace("\u00a0", " ").isprintable()


def _notes(book: Book, given: Mapping[str, Any]) -> Mapping[str, Sequence[str]]:
    entry = given.get("notes", {})
    lists: list[Any] = [entry.get(lang, []) for lang in LANGUAGES] if isinstance(entry, dict) else [None]
    if not all(isinstance(one, list) and all(map(_is_text, one)) for one in lists):
        raise SourceError(f"{book.path}: notes must be lists of lines, notes.de and notes.en")
    return dict(zip(LANGUAGES, lists, strict=True))


def _at(file: Path, cell: SourceCell) -> str:
    return place(shown(file), cell.line)


def _cells(file: Path, method: str) -> Iterator[SourceCell]:
    def cell_of(texts: list[str], head: Head, line: int) -> SourceCell:
        names = [column.name for column in head.columns]
        return _cell(dict(zip(names, texts, strict=True)), method, line)

    return read_rows(file, KIND, _head, cell_of, f"it starts with its heads, {';'.join(COLUMNS)}", NONE)


def _check_circles(file: Path, cells: Sequence[SourceCell]) -> None:
    """Raise SourceError where a cell's value would need itself."""
    needs = {
        cell.place: {name for one in (cell.formula, cell.way) if one for name in one.names} for cell in cells
    }
    settled: set[str] = set()
    rounds = 0
    while left := [cell for cell in cells if cell.place not in settled]:
        ready = [cell.place for cell in left if needs[cell.place] <= settled]
        if not ready:
            raise SourceError(f"{_at(file, left[0])}: {left[0].place} names itself, by way of other cells")
        settled |= {*ready}
        rounds += 1
        if rounds > DEEPEST:
            raise SourceError(
                f"{_at(file, left[0])}: more than {DEEPEST} cells build on one another up to {ready[0]}"
            )


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


def _cell(row: Mapping[str, str], method: str, line: int) -> SourceCell:
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
        {axis: known[axis] for axis in AXES if known[axis]},
        known["method"] or method,
        Expression(known["formula"]) if known["formula"] else None,
        Expression(known["way"]) if known["way"] else None,
        known["label"] or ("" if known["quantity"] else known["place"].replace("_", " ")),
        line,
    )
