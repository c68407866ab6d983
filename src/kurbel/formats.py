"""The registry of output formats. Cheap to import: the help text and shell completion read it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import PurePath
from typing import Literal

from kurbel import escapes, formula_print
from kurbel.errors import ChoiceError
from kurbel.formula import Formula

DECIMALS = {"comma": ",", "point": "."}
DECIMAL_OF_LANGUAGE = {"de": "comma", "en": "point"}


@dataclass(frozen=True, slots=True)
class Format:
    """What distinguishes one format from another, apart from its templates.

    `decimal` is "language" or "point": where the decimal mark comes from unless the user sets it.
    `escape` sets prose. `formula` sets a formula with a given decimal mark, and with full-sized fractions in
    a cell of its own. `note_mark` sets a mark and a link to the note of the given name, which is empty for
    the mark before the note itself. `document` tells that a standalone page differs from a fragment.
    """

    name: str
    suffixes: tuple[str, ...]
    media: str
    kind: Literal["page", "records"]
    decimal: Literal["language", "point"]
    minus: str = "−"
    escape: Callable[[str], str] = escapes.escape_text
    formula: Callable[[Formula, str, bool], str] = formula_print.formula_text
    note_mark: Callable[[str, str], str] = escapes.mark_text
    missing: str = "–"
    document: bool = False

    def decimal_name(self, lang: str, decimal: str | None = None) -> str:
        """Return "comma" or "point": what the user asks for, else the rule of the format."""
        if decimal is not None:
            if decimal not in DECIMALS:
                raise ChoiceError(f"decimal mark is {decimal!r}; it must be {' or '.join(DECIMALS)}")
            return decimal
        return DECIMAL_OF_LANGUAGE.get(lang, "point") if self.decimal == "language" else "point"

    def decimal_mark(self, lang: str, decimal: str | None = None) -> str:
        """Return the character "," or "."."""
        return DECIMALS[self.decimal_name(lang, decimal)]


FORMATS = {
    entry.name: entry
    for entry in (
        Format("text", (".txt",), "plain text for terminals and e-mail", "page", "language"),
        Format(
            "markdown",
            (".md",),
            "Markdown tables as GitHub and most wikis read them",
            "page",
            "language",
            escape=escapes.escape_markdown,
            formula=formula_print.formula_markdown,
            note_mark=escapes.mark_markdown,
        ),
        Format(
            "latex",
            (".tex",),
            r"LaTeX with booktabs rules, for \input or as a document",
            "page",
            "language",
            minus="$-$",
            escape=escapes.escape_latex,
            formula=formula_print.formula_latex,
            note_mark=escapes.mark_latex,
            missing="--",
            document=True,
        ),
        Format(
            "html",
            (".html", ".htm"),
            "HTML with MathML, for a page or as a page",
            "page",
            "language",
            escape=escapes.escape_html,
            formula=formula_print.formula_html,
            note_mark=escapes.mark_html,
            document=True,
        ),
        Format("csv", (".csv",), "one record a line, for spreadsheets", "records", "point", minus="-"),
        Format(
            "json",
            (".json",),
            "one object with columns and rows, for programs",
            "records",
            "point",
            minus="-",
        ),
    )
}


def by_name(name: str) -> Format:
    """Return the format of that name; raise ChoiceError if there is none."""
    if name not in FORMATS:
        raise ChoiceError(f"format is {name!r}; it must be one of {', '.join(FORMATS)}")
    return FORMATS[name]


def for_suffix(path: str | PurePath) -> Format:
    """Return the format that a file name asks for; raise ChoiceError if its suffix belongs to none."""
    suffix = PurePath(path).suffix.lower()
    for entry in FORMATS.values():
        if suffix in entry.suffixes:
            return entry
    known = ", ".join(suffix for entry in FORMATS.values() for suffix in entry.suffixes)
    raise ChoiceError(f"the file name {str(path)!r} names no format; its suffix must be one of {known}")
