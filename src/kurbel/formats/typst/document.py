"""A handbook in Typst: one source that includes the tables and draws in the figures beside it."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

from kurbel.documents.document import WORDS, Chapter, Document, Item
from kurbel.formats.documents import head_of, label_of, text_setter, titled
from kurbel.formats.render import render_document
from kurbel.formats.typst import FORMAT
from kurbel.formats.typst.escapes import string
from kurbel.page.labels import plain

# The text is 42 em wide.
NARROW = 42.0
_WIDE = re.compile(r"let \(wide, high\) = \(([0-9.]+)em")


class TypstTitle(NamedTuple):
    """A title as it is printed, as a string of code for what a PDF says of itself, and for a running head."""

    text: str
    string: str
    head: str


class TypstPart(NamedTuple):
    """A text, table or figure; `path`, `alt` and `label` are strings of code.

    `lang` is the language where it is not the document's; `alt` is the caption for readers that do not see
    the figure; `narrow` is a table that surely is no wider than the text.
    """

    kind: str
    path: str
    label: str
    text: str
    alt: str
    lang: str
    narrow: bool = False


class TypstChapter(NamedTuple):
    title: TypstTitle
    label: str
    lang: str
    parts: tuple[TypstPart, ...]


def files(document: Document, fragments: Mapping[str, str], templates: str | None = None) -> dict[str, str]:
    """Return handbook.typ, which includes the fragments as files of the folder tables."""
    text = text_setter(document, FORMAT, "-", 1)
    values = {
        "document": document,
        "title": _title(document, document.title),
        "subtitle": _title(document, document.subtitle),
        "author": _title(document, document.author),
        "words": document.words,
        "languages": WORDS,
        "chapters": [_chapter(document, chapter, fragments, text) for chapter in document.chapters],
        "kinds": {item.kind for item in document.items("table", "figure")},
    }
    return {"handbook.typ": render_document(FORMAT, "handbook", values, templates)}


def _chapter(
    document: Document, chapter: Chapter, fragments: Mapping[str, str], text: Callable[[Item], str]
) -> TypstChapter:
    return TypstChapter(
        _title(document, chapter.title, chapter.lang),
        string(label_of(chapter, "-")),
        _other(document, chapter.lang),
        tuple(_parts(document, chapter, fragments, text)),
    )


def _parts(
    document: Document, chapter: Chapter, fragments: Mapping[str, str], text: Callable[[Item], str]
) -> Iterator[TypstPart]:
    for item in chapter.items:
        lang, mark = _other(document, item.lang), document.mark(item.lang)
        if item.kind == "text":
            yield TypstPart("text", "", "", text(item), "", lang)
        else:
            yield TypstPart(
                item.kind,
                string(_path(item)),
                string(label_of(item, "-")),
                titled(document, item.caption, FORMAT, item.lang),
                string(plain(item.caption, mark)),
                lang,
                item.kind == "table" and _width(fragments[item.name]) < NARROW,
            )


def _width(fragment: str) -> float:
    """Return how wide a table is at the most, in em, as its fragment says."""
    found = _WIDE.search(fragment)
    return float(found[1]) if found else math.inf


def _path(item: Item) -> str:
    return f"tables/{item.name}.typ" if item.kind == "table" else f"figures/{item.name}.svg"


def _other(document: Document, lang: str) -> str:
    """Return a language where it is not the document's."""
    return "" if lang == document.lang else lang


def _title(document: Document, label: str, lang: str = "") -> TypstTitle:
    words = string(plain(label, document.mark(lang)))
    return TypstTitle(titled(document, label, FORMAT, lang), words, head_of(document, label, FORMAT, lang))
