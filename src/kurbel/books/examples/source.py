"""The worked examples of the books: sources/<book>/<number>.toml has their lines and the steps in them.

A step is a formula of given numbers and other steps, or a quantity of kurbel's by the method of the book. Its
printed value stands in the table of the same number, sources/<book>/<number>.csv: at the place that the
part's `printed` names, else at that of the step's own name.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any, ClassVar, NamedTuple

from msgspec import Struct

from kurbel.books.printed_value import Printed
from kurbel.books.source import SOURCE, Book, SourceTable
from kurbel.exact.numerals import Label
from kurbel.page.layouts import Notes, Words
from kurbel.reading.given import choose, meant
from kurbel.reading.notation import number, ratio
from kurbel.reading.toml_file import Fault, TomlFile

FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "sources")


class Line(NamedTuple):
    """A line of the working, with places {step} for its figures.

    `added` tells that the book does not have it, `when` is the condition under which it is needed, such as
    "ratio >= 5/7". A line with what the given numbers do not settle is left out.
    """

    line: Label
    added: bool = False
    when: str = ""


class Lines(tuple[Line, ...]):
    """Lines, in a file texts or tables with line, added and when."""

    @classmethod
    def read(cls, given: Any, _: str) -> Lines:
        try:
            return cls(Line(**({"line": one} if isinstance(one, str) else one)) for one in given)
        except TypeError:
            raise Fault("a list of texts, or of tables with line, added and when") from None


class Step(Struct, frozen=True, forbid_unknown_fields=True):
    """A number of the working: its symbol, a formula or a quantity, perhaps that of a stroke.

    `form` is how it is written where no printed value says so.
    """

    NOUN: ClassVar[str] = "key of a step"

    symbol: Label
    form: str
    formula: str = ""
    quantity: str = ""
    stroke: str = ""


class Part(NamedTuple):
    """A part of an example as the book has it: its numbers, its lines and the printed values of its steps.

    `title` heads the part; `remarks` say of a step what its difference from print is.
    """

    letter: str
    given: Mapping[str, Fraction]
    lines: tuple[Line, ...]
    printed: Mapping[str, Printed]
    remarks: Mapping[str, Words]
    title: Words | None = None


class PartFile(Struct, frozen=True, forbid_unknown_fields=True):
    """A part as the file has it: the numbers that are given are text, and `printed` are places of values."""

    NOUN: ClassVar[str] = "key of a part"

    lines: Lines
    letter: str = ""
    title: Words | None = None
    printed: dict[str, str] | None = None
    remarks: dict[str, Words] = {}
    ratio: str | None = None
    angle: str | None = None
    beam: str | None = None
    eps: str | None = None


class OwnFile(Struct, frozen=True, forbid_unknown_fields=True):
    lines: Lines = Lines()


class ExampleFile(Struct, frozen=True, forbid_unknown_fields=True):
    """What the file says: the steps, and the exact numbers that follow from given ones.

    `takes` names the options that replace the numbers, `own` has the lines for these; without lines the
    book's serve.
    """

    NOUN: ClassVar[str] = "key of an example"

    title: Words
    takes: tuple[str, ...]
    part: tuple[PartFile, ...]
    notes: Notes = Notes()
    numbers: dict[str, str] = {}
    steps: dict[str, Step] = {}
    own: OwnFile = OwnFile()


class Example(NamedTuple):
    """A worked example of a book: what its file says, and its parts. `method` is that of its quantities."""

    source: Book
    number: str
    page: ExampleFile
    method: str
    parts: tuple[Part, ...]


@cache
def source_keys() -> tuple[str, ...]:
    return tuple(sorted(key for key in os.listdir(FOLDER) if numbers_of(key)))


@cache
def numbers_of(key: str) -> tuple[str, ...]:
    """Return the numbers of the examples of a source, in order."""
    names = (os.path.splitext(name) for name in os.listdir(os.path.join(FOLDER, key)))
    return tuple(sorted((stem for stem, suffix in names if suffix == ".toml" and stem != "source"), key=int))


@cache
def source(key: str) -> Book:
    """Return the book of that key; an unknown one is answered with the nearest and the list."""
    return Book(Path(FOLDER, meant(key, source_keys(), "source")))


@cache
def example(key: str, number: str) -> Example:
    """Return an example; an unknown one is answered with the nearest and the list."""
    key = meant(key, source_keys(), "source")
    book = source(key)
    name = choose(number, numbers_of(key), f"example of {key}")
    page = TomlFile(os.path.join(FOLDER, key, f"{name}.toml"), SOURCE).read(ExampleFile)
    table = next((one for one in book.tables if one.name == number), None)
    parts = tuple(_part(table, page.takes, part) for part in page.part)
    return Example(book, number, page, table.method if table else "", parts)


def _part(table: SourceTable | None, takes: tuple[str, ...], part: PartFile) -> Part:
    given = {name: getattr(part, name, None) for name in takes}
    numbers = {name: READERS[name](text) for name, text in given.items() if text is not None}
    found = {cell.place: cell.printed for cell in table.cells if cell.printed} if table else {}
    if part.printed is not None:
        found = {step: found[place] for step, place in part.printed.items()}
    return Part(part.letter, numbers, part.lines, found, part.remarks, part.title)


READERS = {"ratio": ratio, "angle": number, "beam": number, "eps": number}
