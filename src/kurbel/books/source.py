"""The books: a folder each, with a source.toml and the printed values of its tables as characters.

    sources/<book>/source.toml     citation, what is stated and what is inferred, and [tables.<name>]
    sources/<book>/<name>.csv      place;quantity;ratio;phi;...;method;formula;way;label;printed

A table's key is <book>-<name>. `place` names the cell. What it is a `quantity` of kurbel's says, at ratio and
phi, at epsilon and stroke, or at ratio and arm, or else a `formula` from other cells by their places. The
`way` says how the book came to it from what it had printed; without one the formula does. `printed` is what
the book has; a cell that it has not is there for others.

Formulas stand in such a file with place;label;printed;follows;relation;letter;form, as printed, in the
notation of labels, and in a form that is evaluated. A formula `follows` from one above it, from the last
without a name, and its `relation` to that is empty where it begins, `equal`, `nearly` where the book neglects
something small, `same` where the same equation stands otherwise and `root` where it solves the equation. The
letter of `nearly` is what is small, that of an equation its unknown; an equation's form is what must vanish.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any, ClassVar, Generic, NamedTuple, TypeVar

from msgspec import Struct

from kurbel.books.book_values import Expression
from kurbel.books.equation import OF_LETTER, RELATIONS, STARTS, Finding, Step, found
from kurbel.books.form import SLOPE, Form
from kurbel.books.printed_value import PrintedValue, printed_value
from kurbel.errors import ChoiceError, LayoutError, NotationError, SourceError
from kurbel.page.formula import GREEK
from kurbel.page.labels import parse
from kurbel.page.layouts import LANGUAGES, Notes, Words
from kurbel.reading.csv_file import NONE, Head, Kind, place, read_rows, shown, whole_head
from kurbel.reading.given import choose
from kurbel.reading.toml_file import Fault, TomlFile, TomlKind, about

SOURCE = TomlKind("source", SourceError, 200_000, "a source has a citation and tables", "book/source.toml")
AXIS_KEYS = ("ratio", "phi", "epsilon", "stroke", "arm")
# As many cells may build on one another, and as many letters be made of others.
DEEPEST, DEEPEST_LETTERS = 50, 20
_KEY = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]*")


class SourceCell(NamedTuple):
    """A printed value with what it is, in the words of the file."""

    place: str
    printed: PrintedValue | None
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

    SCHEMA: ClassVar[Mapping[str, object]] = Notes.SCHEMA

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


File = TypeVar("File", bound=TableFile | FormulasFile)
Row = TypeVar("Row")


class BookTable(Generic[File]):
    """What a file of a book has, by its name there: printed values, or formulas."""

    kind: ClassVar[Kind]
    columns: ClassVar[tuple[str, ...]]
    needed: ClassVar[tuple[str, ...]]
    having: ClassVar[str]
    named: ClassVar[str]

    def __init__(self, book: Book, name: str, given: File) -> None:
        self.book, self.name, self.given = book, name, given
        self.key, self.title, self.notes = f"{book.key}-{name}", given.title, given.notes
        self.file = book.folder / f"{name}.csv"

    def read(self, row: Callable[[dict[str, str], int], Row]) -> Iterator[Row]:
        """Yield what is made of each line, of its texts by their columns and its number."""

        def made(texts: list[str], head: Head, line: int) -> Row:
            found = {column.name: text.strip() for column, text in zip(head.columns, texts, strict=True)}
            if not found["place"].isidentifier():
                raise NotationError(f'the place "{found["place"][:40]}" is no name; write it as {self.named}')
            return row({name: found.get(name, "") for name in self.columns}, line)

        starts = f"it starts with its heads, {';'.join(self.columns)}"
        yield from read_rows(self.file, self.kind, self._head, made, starts, NONE, ChoiceError)

    def _head(self, line: str) -> Head:
        head = whole_head(line, ";")
        names = [column.name for column in head.columns]
        if len({*names}) != len(names):
            raise NotationError("a column stands there twice")
        for name in names:
            choose(name, self.columns, "column")
        for needed in self.needed:
            if needed not in names:
                raise NotationError(f"there is no column {needed}, which {self.having}")
        return head


def _tangle(needs: Mapping[str, Set[str]], most: int) -> tuple[str, str]:
    """Return a name that needs itself, by way of others; or one that is left when more than so many build on
    one another, and up to which."""
    settled: set[str] = set()
    for count in range(len(needs)):
        left = [name for name in needs if name not in settled]
        ready = [name for name in left if needs[name] <= settled]
        if left and (not ready or count >= most):
            return left[0], "".join(ready[:1])
        settled |= {*ready}
    return "", ""


class SourceTable(BookTable[TableFile]):
    """A table or worked example of a book."""

    kind = Kind("source", "cell", SourceError)
    columns = ("place", "quantity", *AXIS_KEYS, "method", "formula", "way", "label", "printed")
    needed, having, named = ("place", "printed"), "every source has", "x_45"

    @property
    def method(self) -> str:
        return self.given.method

    @property
    def layout(self) -> str:
        return self.given.layout

    @cached_property
    def cells(self) -> tuple[SourceCell, ...]:
        """The printed values in their order."""
        cells: tuple[SourceCell, ...] = tuple(self.read(self._cell))
        places = [cell.place for cell in cells]
        for cell in cells:
            if places.count(cell.place) > 1:
                raise SourceError(f"{self.at(cell)}: the place {cell.place} is given twice")
            for unknown in sorted(cell.names - {*places}):
                raise SourceError(f"{self.at(cell)}: {unknown} in a formula is no place here")
        by_place = {cell.place: cell for cell in cells}
        name, last = _tangle({cell.place: cell.names for cell in cells}, DEEPEST)
        if name:
            said = (
                f"more than {DEEPEST} cells build on one another up to {last}"
                if last
                else f"{name} names itself, by way of other cells"
            )
            raise SourceError(f"{self.at(by_place[name])}: {said}")
        if not any(cell.printed for cell in cells):
            raise SourceError(f"{shown(self.file)} has no printed value below its heads")
        return cells

    def at(self, cell: SourceCell) -> str:
        """Return where the cell stands, for the start of a sentence."""
        return place(shown(self.file), cell.line)

    def _cell(self, known: Mapping[str, str], line: int) -> SourceCell:
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


_LETTER = re.compile(r"\w(_\w)?")
# lambda is a word of Python's, and no letter of a form.
_GREEK = {name.removeprefix("\\").removeprefix("var"): letter for letter, name in GREEK.items()}
_GREEK |= {"lam": "λ", "eps": "ε"}


class FormulaRow(NamedTuple):
    """A printed formula with the form of it, in the words of the file."""

    place: str
    label: str
    printed: str
    follows: str
    relation: str
    letter: str
    form: Form
    line: int


class CollatedFormula(NamedTuple):
    """A printed formula, and what it is found to be."""

    row: FormulaRow
    finding: Finding


class FormulaTable(BookTable[FormulasFile]):
    """The formulas of a section of a book."""

    kind = Kind("source", "formula", SourceError)
    columns = ("place", "label", "printed", "follows", "relation", "letter", "form")
    needed, having, named = ("place", "printed", "form"), "formulas have", "c_m"

    def __init__(self, book: Book, name: str, given: FormulasFile) -> None:
        super().__init__(book, name, given)
        self.forms = self._forms(given.letters)

    def _forms(self, letters: Mapping[str, str]) -> Mapping[str, Form]:
        """Return what letters are made of, each of others."""
        forms = {}
        for name, text in letters.items():
            try:
                forms[name] = Form(text)
                if SLOPE in text:
                    raise NotationError(f"{name} has a slope; write it in the formula itself")
            except NotationError as error:
                raise self._error("letters", name, error) from None
        needs = {name: forms[name].letters & forms.keys() for name in sorted(forms)}
        name, last = _tangle(needs, DEEPEST_LETTERS)
        if last:
            said = f"more than {DEEPEST_LETTERS} letters are made of one another"
            raise self._error("letters", last, said)
        if name:
            raise self._error("letters", name, f"{name} is made of itself, by way of other letters")
        return forms

    def _error(self, key: str, name: str, said: object) -> Exception:
        return self.book.file.error(("formulas", self.name, key, name), said)

    def rows(self) -> Iterator[FormulaRow]:
        """Yield the formulas in their order."""
        before: dict[str, FormulaRow] = {}
        for row in self.read(_row):
            where = place(shown(self.file), row.line)
            if row.place in before:
                raise SourceError(f"{where}: the place {row.place} is given twice")
            if row.relation and not row.follows:
                if not before:
                    raise SourceError(f"{where}: {row.place} follows from none; leave its relation out")
                row = row._replace(follows=[*before][-1])
            if row.relation and row.follows not in before:
                raise SourceError(f"{where}: {row.follows} is no formula above {row.place}")
            before[row.place] = row
            yield row
        if not before:
            raise SourceError(f"{shown(self.file)} has no printed formula below its heads")

    def collated(self) -> Iterator[CollatedFormula]:
        """Yield the formulas, each with what it is found to be."""
        by_place: dict[str, FormulaRow] = {}
        for row in self.rows():
            by_place[row.place] = row
            if not row.relation:
                yield CollatedFormula(row, Finding(STARTS))
                continue
            before = by_place[row.follows].form
            yield CollatedFormula(row, found(Step(before, row.form, row.relation, row.letter, self.forms)))

    def letter_label(self, name: str) -> str:
        """Return how a letter is printed in a formula: α for alpha, m_1 as it stands."""
        own = _GREEK.get(name, name)
        return self.given.labels.get(name) or (own if _LETTER.fullmatch(own) else f'"{name}"')


def _row(known: dict[str, str], line: int) -> FormulaRow:
    if known["relation"] not in RELATIONS:
        choose(known["relation"], [one for one in RELATIONS if one], "relation")
    if known["relation"] in OF_LETTER and not known["letter"].isidentifier():
        raise NotationError(f"the relation {known['relation']} of {known['place']} needs a letter")
    if not known["printed"]:
        raise NotationError(f"{known['place']} has no printed formula")
    try:
        parse(f"${known['printed']}$")
    except LayoutError as error:
        raise NotationError(str(error)) from None
    form = Form(known.pop("form"))
    return FormulaRow(**known, form=form, line=line)


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


def all_tables(folder: str | os.PathLike[str] | None = None) -> Mapping[str, SourceTable | FormulaTable]:
    """Return every table of every book by its key; the user's go before kurbel's own."""
    return {table.key: table for book in books(folder) for table in book.all_tables}
