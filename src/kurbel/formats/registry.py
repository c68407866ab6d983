"""The registry of output formats. Cheap to import: the help text and shell completion read it."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Literal, NamedTuple, cast

from kurbel.errors import ChoiceError

if TYPE_CHECKING:
    from collections.abc import Callable

    from kurbel.page.formula import Formula

DECIMALS = {"comma": ",", "point": "."}
DECIMAL_OF_LANGUAGE = {"de": "comma", "en": "point"}


class Format(NamedTuple):
    """What distinguishes one format from another, apart from its templates.

    `decimal` is "language" or "point": where the decimal mark comes from unless the user sets it.
    `document` tells that a standalone page differs from a fragment. Formats of pages also set labels, with
    functions that carry their name and are looked up when the first label is set, to keep the registry cheap.
    A compiled format is bytes, made of the document in another format.
    """

    name: str
    suffixes: tuple[str, ...]
    media: str
    kind: Literal["page", "records", "compiled"]
    decimal: Literal["language", "point"]
    minus: str = "−"
    missing: str = "–"
    document: bool = False

    @property
    def escape(self) -> Callable[[str], str]:
        """The function that sets prose."""
        from kurbel.formats import escapes

        return cast("Callable[[str], str]", getattr(escapes, f"escape_{self.name}"))

    @property
    def note_mark(self) -> Callable[[str, str], str]:
        """The function that sets a mark and a link to the note of the given name.

        The name is empty for the mark before the note itself.
        """
        from kurbel.formats import escapes

        return cast("Callable[[str, str], str]", getattr(escapes, f"mark_{self.name}"))

    @property
    def finish(self) -> Callable[[str], str]:
        """The function that a label goes through when all its parts are set; most formats have none."""
        from kurbel.formats import escapes

        return cast("Callable[[str], str]", getattr(escapes, f"finish_{self.name}", str))

    @property
    def formula(self) -> Callable[[Formula, str, bool], str]:
        """The function that sets a formula with a decimal mark, and on wish with fractions of full size."""
        from kurbel.formats import formula_print

        return cast("Callable[[Formula, str, bool], str]", getattr(formula_print, f"formula_{self.name}"))

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
        Format(
            "text",
            (".txt",),
            "plain text for terminals and e-mail",
            "page",
            "language",
        ),
        Format(
            "markdown",
            (".md",),
            "Markdown tables as GitHub and most wikis read them",
            "page",
            "language",
        ),
        Format(
            "latex",
            (".tex",),
            r"LaTeX with booktabs rules, for \input or as a document",
            "page",
            "language",
            minus="$-$",
            missing="--",
            document=True,
        ),
        Format(
            "html",
            (".html", ".htm"),
            "HTML with MathML, for a page or as a page",
            "page",
            "language",
            document=True,
        ),
        Format(
            "typst",
            (".typ",),
            "Typst, for #include or as a document",
            "page",
            "language",
            document=True,
        ),
        Format("pdf", (".pdf",), "PDF by Typst, always a document", "compiled", "language"),
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


def for_suffix(path: str) -> Format:
    """Return the format that a file name asks for; raise ChoiceError if its suffix belongs to none."""
    suffix = os.path.splitext(path)[1].lower()
    for entry in FORMATS.values():
        if suffix in entry.suffixes:
            return entry
    known = ", ".join(suffix for entry in FORMATS.values() for suffix in entry.suffixes)
    raise ChoiceError(f"the file name {str(path)!r} names no format; its suffix must be one of {known}")
