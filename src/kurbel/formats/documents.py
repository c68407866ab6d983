"""Whole documents of a handbook: what the makers of all formats share."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Literal

from kurbel.documents.document import WORDS, Chapter, Document, Item
from kurbel.exact.numerals import Label
from kurbel.formats.format import PageFormat
from kurbel.formats.printer import Reference, set_prose
from kurbel.formats.registry import FORMATS
from kurbel.page.labels import plain, set_label
from kurbel.reading.choices import choose

PREFIXES = {"table": "tab", "figure": "fig", "chapter": "sec"}
# What fits one side of a running head.
HEAD = 44


def document_files(
    document: Document, format: str, fragments: Mapping[str, str], templates: str | None = None
) -> dict[str, str]:
    """Return the whole documents of a format as texts by their paths in the output folder.

    `fragments` has each table by its name, rendered in the format, and each figure that is a text;
    `templates` is a folder of the user's own templates. Raises KurbelError for a reference to nothing and
    for a template that cannot be used.
    """
    whole = {name: form for name, form in FORMATS.items() if isinstance(form, PageFormat) and form.figures}
    return whole[choose(format, whole, "format of documents")].documents(document, fragments, templates)


def titled(document: Document, label: Label, form: PageFormat, lang: str = "") -> str:
    """Return a title or a caption of a language in a format."""
    mark = document.mark(lang)
    return set_label(label, form.escape, lambda formula: form.formula(formula, mark, False), lambda note: "")


def head_of(document: Document, label: Label, form: PageFormat, lang: str = "") -> str:
    """Return a title for a running head: one too long for it is cut, its formulas in one line."""
    words = plain(label, document.mark(lang))
    if len(words) <= HEAD:
        return titled(document, label, form, lang)
    return form.escape(f"{words[: HEAD - 1].rstrip()}…")


def label_of(part: Chapter | Item, joint: str) -> str:
    """Return the label of a chapter, a table or a figure: tab:delta or, joined by a hyphen, tab-delta."""
    return f"{PREFIXES[_kind(part)]}{joint}{part.name}"


def text_setter(
    document: Document,
    form: PageFormat,
    joint: str,
    level: int,
    page: Callable[[Chapter], str] = lambda one: "",
) -> Callable[[Item], str]:
    """Return what sets the texts of the document in a format, with headings below those of so many levels.

    What a text refers to is the label, with this joint, behind what `page` returns for its chapter, such as
    "#" or "02-paths.md#", and is called as the text's language calls it. A name that nothing has is a
    ChoiceError with the nearest.
    """
    homes = document.homes()

    def find(lang: str, name: str) -> Reference:
        chapter, item = homes[choose(name, homes, "table, figure or chapter")]
        part = item or chapter
        return Reference(_kind(part), page(chapter) + label_of(part, joint), document.title_of(part, lang))

    def text(item: Item) -> str:
        blocks, mark = tuple(item.blocks), document.mark(item.lang)
        return set_prose(blocks, form, mark, partial(find, item.lang), level)

    return text


def number_of(item: Item) -> str:
    """Return what stands over a table or under a figure, in its own language: "Table 3"."""
    return f"{WORDS[item.lang][item.kind]} {item.number}"


def _kind(part: Chapter | Item) -> Literal["table", "figure", "chapter"]:
    if isinstance(part, Chapter):
        return "chapter"
    assert part.kind != "text"
    return part.kind
