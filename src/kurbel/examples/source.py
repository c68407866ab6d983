"""The worked examples of the books: sources/<key>/ holds their lines in TOML and printed values in CSV."""

from __future__ import annotations

import csv
import os
import tomllib
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple

from kurbel.errors import LayoutError
from kurbel.exact.numerals import Label
from kurbel.examples.figures import Figure, figure
from kurbel.page.layouts import LANGUAGES
from kurbel.reading.choices import choose
from kurbel.reading.notation import number, ratio

FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "books", "sources")
Localised = Mapping[str, str]


class Line(NamedTuple):
    """A line of the working, with places {step} for its figures.

    `added` tells that the book does not have it, `when` names the condition under which it is needed.
    """

    text: Label
    added: bool = False
    when: str = ""


class Step(NamedTuple):
    """A number of the working: its symbol, and how it is written where no printed value says so."""

    symbol: Label
    figure: Figure


class Part(NamedTuple):
    """A part of an example as the book has it: its numbers, its lines and the printed values of its steps.

    `title` heads the part; `remarks` say of a step what its difference from print is.
    """

    letter: str
    given: Mapping[str, Fraction]
    lines: tuple[Line, ...]
    printed: Mapping[str, Figure]
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
    """A worked example. `takes` names the options that replace its numbers, `own` the lines for these;
    without lines the book's serve."""

    source: Source
    number: str
    title: Localised
    formulas: str
    takes: tuple[str, ...]
    notes: tuple[Localised, ...]
    steps: Mapping[str, Step]
    parts: tuple[Part, ...]
    own: tuple[Line, ...]


@cache
def source_keys() -> tuple[str, ...]:
    return tuple(sorted(name for name in os.listdir(FOLDER) if os.path.exists(_path(name, "steps", "csv"))))


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
    printed = _printed(key, number)
    return Example(
        source=book,
        number=number,
        title=_localised(page["title"]),
        formulas=page["formulas"],
        takes=tuple(page["takes"]),
        notes=tuple({"de": de, "en": en} for de, en in zip(notes["de"], notes["en"], strict=True)),
        steps={name: Step(symbol, figure(form)) for name, (symbol, form) in page.get("steps", {}).items()},
        parts=tuple(_part(printed, page["takes"], **part) for part in page["part"]),
        own=_lines(page.get("own", {"lines": []})["lines"]),
    )


def _path(key: str, name: str, suffix: str = "toml") -> str:
    return os.path.join(FOLDER, key, f"{name}.{suffix}")


def _read(key: str, name: str) -> dict[str, Any]:
    try:
        with open(_path(key, name), "rb") as file:
            return tomllib.load(file)
    except tomllib.TOMLDecodeError as error:
        raise LayoutError(f"{key}/{name}.toml cannot be used: {error}") from error


def _printed(key: str, number: str) -> Mapping[str, Mapping[str, Figure]]:
    """Return the printed values of an example by part and step."""
    found: dict[str, dict[str, Figure]] = {}
    with open(_path(key, "steps", "csv"), encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, delimiter=";"):
            if row["example"] == number:
                found.setdefault(row["part"], {})[row["step"]] = figure(row["printed"])
    return found


def _part(
    printed: Mapping[str, Mapping[str, Figure]],
    takes: Sequence[str],
    lines: Sequence[Any],
    letter: str = "",
    remarks: Mapping[str, Localised] | None = None,
    title: Localised | None = None,
    **given: str,
) -> Part:
    numbers = {name: READERS[name](given[name]) for name in takes if name in given}
    return Part(letter, numbers, _lines(lines), printed.get(letter, {}), remarks or {}, title)


READERS = {"ratio": ratio, "angle": number, "beam": number, "eps": number}


def _lines(lines: Sequence[Any]) -> tuple[Line, ...]:
    return tuple(_line(**({"line": line} if isinstance(line, str) else line)) for line in lines)


def _line(line: Label, added: bool = False, when: str = "") -> Line:
    return Line(line, added, when)


def _localised(text: str | Mapping[str, str]) -> Localised:
    return dict.fromkeys(LANGUAGES, text) if isinstance(text, str) else {one: text[one] for one in LANGUAGES}
