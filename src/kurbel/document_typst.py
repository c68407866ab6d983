"""A handbook in Typst: one source that includes the tables and draws in the figures beside it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from kurbel.document import Chapter, Document, Item
from kurbel.escapes import string_typst
from kurbel.formats import DECIMALS, Format, by_name
from kurbel.labels import plain
from kurbel.prose_levels import stepwise
from kurbel.prose_print import set_prose
from kurbel.references import finder, label_of
from kurbel.render import render_document


class TypstTitle(NamedTuple):
    """A title as it is printed, as a string of code for what a PDF says of itself, and for a running head."""

    text: str
    string: str
    head: str


class TypstPart(NamedTuple):
    """A text, table or figure; `path`, `alt` and `label` are strings of code.

    `lang` is the language of a table or figure where it is not the document's; `alt` is the caption for
    readers that do not see the figure.
    """

    kind: str
    path: str
    label: str
    text: str
    alt: str
    lang: str


class TypstChapter(NamedTuple):
    title: TypstTitle
    label: str
    parts: tuple[TypstPart, ...]


def files(document: Document, fragments: Mapping[str, str], templates: str | None = None) -> dict[str, str]:
    """Return handbook.typ, which includes the fragments as files of the folder tables."""
    form = by_name("typst")
    values = {
        "document": document,
        "title": _title(document, document.title, form),
        "subtitle": _title(document, document.subtitle, form),
        "author": _title(document, document.author, form),
        "words": document.words,
        "chapters": [_chapter(document, chapter, form) for chapter in document.chapters],
        "kinds": {item.kind for item in document.items("table", "figure")},
    }
    return {"handbook.typ": render_document("typst", "handbook", values, templates)}


def _chapter(document: Document, chapter: Chapter, form: Format) -> TypstChapter:
    parts = tuple(_parts(document, chapter, form))
    return TypstChapter(_title(document, chapter.title, form), string_typst(label_of(chapter, "-")), parts)


def _parts(document: Document, chapter: Chapter, form: Format) -> Iterator[TypstPart]:
    mark = DECIMALS[document.decimal]
    find = finder(document, "-")
    above: list[int] = []
    for item in chapter.items:
        if item.kind == "text":
            text = set_prose(stepwise(tuple(item.blocks), above), form, mark, find)
            yield TypstPart("text", "", "", text, "", "")
        else:
            yield TypstPart(
                item.kind,
                string_typst(_path(item)),
                string_typst(label_of(item, "-")),
                document.set(item.caption, form),
                string_typst(plain(item.caption, mark)),
                item.lang if item.lang != document.lang else "",
            )


def _path(item: Item) -> str:
    return f"tables/{item.name}.typ" if item.kind == "table" else f"figures/{item.name}.svg"


def _title(document: Document, label: str, form: Format) -> TypstTitle:
    words = plain(label, DECIMALS[document.decimal])
    return TypstTitle(document.set(label, form), string_typst(words), document.set_head(label, form))
