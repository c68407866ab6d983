"""The printed formulas of a book: a CSV file with one a line, as printed and in a form that is evaluated.

    place;label;printed;follows;relation;letter;form

`printed` is in the notation of labels. A formula `follows` from one above it, from the last without a name,
and its `relation` to that is empty where it begins, `equal`, `nearly` where the book neglects something
small, `same` where the same equation stands otherwise and `root` where it solves the equation. The letter of
`nearly` is what is small, that of an equation its unknown; an equation's form is what must vanish.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, NamedTuple

from kurbel.books.formulas.form import SLOPE, Form
from kurbel.errors import ChoiceError, LayoutError, NotationError, SourceError
from kurbel.page.formula import GREEK
from kurbel.page.labels import parse
from kurbel.reading.csv_file import NONE, Head, Kind, place, read_rows, shown, whole_head
from kurbel.reading.given import choose

if TYPE_CHECKING:
    from kurbel.books.formulas.equation import Finding
    from kurbel.books.source import Book, FormulasFile

KIND = Kind("source", "formula", SourceError)
COLUMNS = ("place", "label", "printed", "follows", "relation", "letter", "form")
NEEDED = ("place", "printed", "form")
# As many letters may be made of one another.
DEEPEST = 20
_LETTER = re.compile(r"\w(_\w)?")
# lambda is a word of Python's, and no letter of a form.
_GREEK = {name.removeprefix("\\").removeprefix("var"): letter for letter, name in GREEK.items()}
_GREEK |= {"lam": "λ", "eps": "ε"}


class Row(NamedTuple):
    """A printed formula with the form of it, in the words of the file."""

    place: str
    label: str
    printed: str
    follows: str
    relation: str
    letter: str
    form: Form
    line: int


class Collated(NamedTuple):
    """A printed formula, and what it is found to be."""

    row: Row
    finding: Finding


class FormulaTable:
    """The formulas of a section of a book."""

    def __init__(self, book: Book, name: str, given: FormulasFile) -> None:
        self.book = book
        self.name = name
        self.key = f"{book.key}-{name}"
        self.title = given.title
        self.notes = given.notes
        self.labels = given.labels
        self.file = book.file_of(name)
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
        settled: set[str] = set()
        rounds = 0
        while left := forms.keys() - settled:
            ready = {name for name in left if not (forms[name].letters & forms.keys()) - settled}
            if not ready:
                name = min(left)
                raise self._error("letters", name, f"{name} is made of itself, by way of other letters")
            settled |= ready
            rounds += 1
            if rounds > DEEPEST:
                name = min(ready)
                raise self._error("letters", name, f"more than {DEEPEST} letters are made of one another")
        return forms

    def _error(self, key: str, name: str, said: object) -> Exception:
        return self.book.file.error(("formulas", self.name, key, name), said)

    def rows(self) -> Iterator[Row]:
        """Yield the formulas in their order."""
        starts = f"it starts with its heads, {';'.join(COLUMNS)}"
        before: dict[str, Row] = {}
        for row in read_rows(self.file, KIND, _head, _row, starts, NONE, ChoiceError):
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

    def collated(self) -> Iterator[Collated]:
        """Yield the formulas, each with what it is found to be."""
        from kurbel.books.formulas.equation import STARTS, Finding, Step, found

        by_place: dict[str, Row] = {}
        for row in self.rows():
            by_place[row.place] = row
            if not row.relation:
                yield Collated(row, Finding(STARTS))
                continue
            before = by_place[row.follows].form
            yield Collated(row, found(Step(before, row.form, row.relation, row.letter, self.forms)))

    def letter_label(self, name: str) -> str:
        """Return how a letter is printed in a formula: α for alpha, m_1 as it stands."""
        own = _GREEK.get(name, name)
        return self.labels.get(name) or (own if _LETTER.fullmatch(own) else f'"{name}"')


def _head(line: str) -> Head:
    head = whole_head(line, ";")
    names = [column.name for column in head.columns]
    if len({*names}) != len(names):
        raise NotationError("a column stands there twice")
    for name in names:
        choose(name, COLUMNS, "column")
    for needed in NEEDED:
        if needed not in names:
            raise NotationError(f"there is no column {needed}, which formulas have")
    return head


def _row(texts: list[str], head: Head, line: int) -> Row:
    from kurbel.books.formulas.equation import OF_LETTER, RELATIONS

    row = {column.name: text.strip() for column, text in zip(head.columns, texts, strict=True)}
    known = {name: row.get(name, "") for name in COLUMNS}
    if not known["place"].isidentifier():
        raise NotationError(f'the place "{known["place"][:40]}" is no name; write it as c_m')
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
    return Row(**known, form=form, line=line)
