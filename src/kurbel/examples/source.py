"""The worked examples of the books: sources/<book>/<number>.toml has their lines and the steps in them.

A step is a formula of given numbers and other steps, or a quantity of kurbel's by the method of the book. Its
printed value stands in the table of the same number, sources/<book>/<number>.csv: at the place that the
part's `printed` names, else at that of the step's own name.
"""

from __future__ import annotations

import os
import tomllib
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from kurbel.books.printed_value import Printed, printed_value
from kurbel.books.source import Book, SourceTable
from kurbel.errors import LayoutError
from kurbel.exact.numerals import Label
from kurbel.page.folders import LANGUAGES
from kurbel.reading.choices import choose
from kurbel.reading.notation import number, ratio

FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "books", "sources")
Localised = Mapping[str, str]


class Line(NamedTuple):
    """A line of the working, with places {step} for its figures.

    `added` tells that the book does not have it, `when` is the condition under which it is needed, such as
    "ratio >= 5/7". A line with what the given numbers do not settle is left out.
    """

    text: Label
    added: bool = False
    when: str = ""


class Step(NamedTuple):
    """A number of the working: its symbol, a formula or a quantity, perhaps that of a stroke.

    `form` is how it is written where no printed value says so.
    """

    symbol: Label
    form: Printed
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
    remarks: Mapping[str, Localised]
    title: Localised | None = None


class Source(NamedTuple):
    """A book: its name, what it calls its examples, how it is cited, its letters of the ratio."""

    key: str
    name: str
    example: Localised
    citation: Localised
    ratio: str = "R:L"


class Example(NamedTuple):
    """A worked example: its lines, its steps, and the exact numbers that follow from given ones.

    `method` is that of its quantities. `takes` names the options that replace its numbers, `own` the lines
    for these; without lines the book's serve.
    """

    source: Source
    number: str
    title: Localised
    method: str
    takes: tuple[str, ...]
    notes: tuple[Localised, ...]
    numbers: Mapping[str, str]
    steps: Mapping[str, Step]
    parts: tuple[Part, ...]
    own: tuple[Line, ...]


@cache
def source_keys() -> tuple[str, ...]:
    return tuple(sorted(key for key in os.listdir(FOLDER) if numbers_of(key)))


@cache
def numbers_of(key: str) -> tuple[str, ...]:
    """Return the numbers of the examples of a source, in order."""
    names = (os.path.splitext(name) for name in os.listdir(os.path.join(FOLDER, key)))
    return tuple(sorted((stem for stem, suffix in names if suffix == ".toml" and stem != "source"), key=int))


@cache
def source(key: str) -> Source:
    """Return the source of that key; an unknown one is answered with the nearest and the list."""
    page = _read(choose(key, source_keys(), "source"), "source")
    example, citation = (_localised(page[name]) for name in ("example", "citation"))
    return Source(key, page["name"], example, citation, page.get("ratio", "R:L"))


@cache
def example(key: str, number: str) -> Example:
    """Return an example; an unknown one is answered with the nearest and the list."""
    book = source(key)
    page = _read(key, choose(number, numbers_of(key), f"example of {key}"))
    notes = page.get("notes", {language: [] for language in LANGUAGES})
    table = next((one for one in Book(Path(FOLDER, key)).tables if one.name == number), None)
    return Example(
        source=book,
        number=number,
        title=_localised(page["title"]),
        method=table.method if table else "",
        takes=tuple(page["takes"]),
        notes=tuple({"de": de, "en": en} for de, en in zip(notes["de"], notes["en"], strict=True)),
        numbers=page.get("numbers", {}),
        steps={name: _step(**step) for name, step in page.get("steps", {}).items()},
        parts=tuple(_part(table, page["takes"], **part) for part in page["part"]),
        own=_lines(page.get("own", {"lines": []})["lines"]),
    )


def _read(key: str, name: str) -> dict[str, Any]:
    try:
        with open(os.path.join(FOLDER, key, f"{name}.toml"), "rb") as file:
            return tomllib.load(file)
    except tomllib.TOMLDecodeError as error:
        raise LayoutError(f"{key}/{name}.toml cannot be used: {error}") from error


def _step(form: str, **step: str) -> Step:
    return Step(form=printed_value(form), **step)


def _part(
    table: SourceTable | None,
    takes: Sequence[str],
    lines: Sequence[Any],
    letter: str = "",
    printed: Mapping[str, str] | None = None,
    remarks: Mapping[str, Localised] | None = None,
    title: Localised | None = None,
    **given: str,
) -> Part:
    numbers = {name: READERS[name](given[name]) for name in takes if name in given}
    found = {cell.place: cell.printed for cell in table.cells if cell.printed} if table else {}
    if printed is not None:
        found = {step: found[place] for step, place in printed.items()}
    return Part(letter, numbers, _lines(lines), found, remarks or {}, title)


READERS = {"ratio": ratio, "angle": number, "beam": number, "eps": number}


def _lines(lines: Sequence[Any]) -> tuple[Line, ...]:
    return tuple(_line(**({"line": line} if isinstance(line, str) else line)) for line in lines)


def _line(line: Label, added: bool = False, when: str = "") -> Line:
    return Line(line, added, when)


def _localised(text: str | Mapping[str, str]) -> Localised:
    return dict.fromkeys(LANGUAGES, text) if isinstance(text, str) else {one: text[one] for one in LANGUAGES}
