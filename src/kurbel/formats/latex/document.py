r"""A handbook in LaTeX: an appendix for \input, and an article around it.

The appendix numbers nothing by itself: its sections, tables and figures take the numbers of the document
that inputs it, and its lists are made of references, so that they hold what is in the appendix and leave
\listoftables to that document.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

from kurbel.documents.document import WORDS, Chapter, Document, Item
from kurbel.formats.documents import head_of, label_of, text_setter, titled
from kurbel.formats.latex import FORMAT
from kurbel.formats.latex.escapes import string
from kurbel.formats.render import render_document
from kurbel.page.labels import plain


class TexTitle(NamedTuple):
    """A title as it is printed, as the strings of a PDF have it, and for a running head."""

    text: str
    string: str
    head: str


class TexPart(NamedTuple):
    r"""A text, table or figure. `language` is that of babel where it is not the document's.

    A `long` table is no float and may not overtake those that wait.
    """

    kind: str
    name: str
    label: str
    text: str
    language: str
    long: bool


class TexChapter(NamedTuple):
    title: TexTitle
    label: str
    parts: tuple[TexPart, ...]


def files(document: Document, fragments: Mapping[str, str], templates: str | None = None) -> dict[str, str]:
    """Return appendix.tex and handbook.tex; `fragments` are the tables that they input."""
    # A chapter is a section, and what stands below it a subsection.
    text = text_setter(document, FORMAT, ":", 2)
    chapters = tuple(_chapter(document, chapter, fragments, text) for chapter in document.chapters)
    values = {
        "document": document,
        "title": _title(document, document.title),
        "subtitle": titled(document, document.subtitle, FORMAT),
        "author": _title(document, document.author),
        "words": document.words,
        "languages": _languages(document),
        "chapters": chapters,
        "long": any(part.long for chapter in chapters for part in chapter.parts),
        "linked": any(document.items("text")),
    }
    return {
        f"{name}.tex": render_document(FORMAT, name, values, templates) for name in ("appendix", "handbook")
    }


def _chapter(
    document: Document, chapter: Chapter, fragments: Mapping[str, str], text: Callable[[Item], str]
) -> TexChapter:
    title = _title(document, chapter.title, chapter.lang)
    return TexChapter(title, label_of(chapter, ":"), tuple(_parts(document, chapter, fragments, text)))


def _parts(
    document: Document, chapter: Chapter, fragments: Mapping[str, str], text: Callable[[Item], str]
) -> Iterator[TexPart]:
    for item in chapter.items:
        language = _language(document, item)
        if item.kind == "text":
            yield TexPart("text", "", "", text(item), language, False)
        else:
            long = item.kind == "table" and r"\begin{longtable}" in fragments[item.name]
            caption = titled(document, item.caption, FORMAT, item.lang)
            yield TexPart(item.kind, item.name, label_of(item, ":"), caption, language, long)


def _language(document: Document, item: Item) -> str:
    return "" if item.lang in ("", document.lang) else WORDS[item.lang]["babel"]


def _languages(document: Document) -> str:
    """Return the options of babel, the document's own language last."""
    others = sorted({_language(document, item) for item in document.items("text", "table", "figure")} - {""})
    return ",".join([*others, f"main={document.words['babel']}"])


def _title(document: Document, label: str, lang: str = "") -> TexTitle:
    words = string(plain(label, document.mark(lang)))
    return TexTitle(titled(document, label, FORMAT, lang), words, head_of(document, label, FORMAT, lang))
