r"""A handbook in LaTeX: an appendix for \input, and an article around it.

The appendix numbers nothing by itself: its sections, tables and figures take the numbers of the document
that inputs it, and its lists are made of references, so that they hold what is in the appendix and leave
\listoftables to that document.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from kurbel.document import WORDS, Chapter, Document, Item
from kurbel.formats import Format, by_name
from kurbel.labels import plain
from kurbel.prose_print import set_prose
from kurbel.references import finder, label_of
from kurbel.render import render_document

# What hyperref does not take from a string of letters as it stands.
_STRING = str.maketrans(
    {character: f"\\{character}" for character in "#$%&_{}"}
    | {
        "\\": r"\textbackslash{}",
        "~": r"\textasciitilde{}",
        "^": r"\textasciicircum{}",
        "`": r"\textasciigrave{}",
        '"': r"\textquotedbl{}",
        "'": r"\textquotesingle{}",
        # Two of them would be one sign.
        "-": "-{}",
        ",": ",{}",
        "<": "<{}",
        ">": ">{}",
    }
)


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
    form = by_name("latex")
    chapters = tuple(_chapter(document, chapter, form, fragments) for chapter in document.chapters)
    values = {
        "document": document,
        "title": _title(document, document.title, form),
        "subtitle": document.set(document.subtitle, form),
        "author": _title(document, document.author, form),
        "words": document.words,
        "languages": _languages(document),
        "chapters": chapters,
        "long": any(part.long for chapter in chapters for part in chapter.parts),
        "linked": any(document.items("text")),
    }
    return {
        f"{name}.tex": render_document("latex", name, values, templates) for name in ("appendix", "handbook")
    }


def _chapter(document: Document, chapter: Chapter, form: Format, fragments: Mapping[str, str]) -> TexChapter:
    parts = tuple(_parts(document, chapter, form, fragments))
    title = _title(document, chapter.title, form, chapter.lang)
    return TexChapter(title, label_of(chapter, ":"), parts)


def _parts(
    document: Document, chapter: Chapter, form: Format, fragments: Mapping[str, str]
) -> Iterator[TexPart]:
    for item in chapter.items:
        if item.kind == "text":
            find = finder(document, ":", item.lang)
            # A chapter is a section, and what stands below it a subsection.
            text = set_prose(tuple(item.blocks), form, document.mark(item.lang), find, 2)
            yield TexPart("text", "", "", text, _language(document, item), False)
        else:
            long = item.kind == "table" and r"\begin{longtable}" in fragments[item.name]
            caption = document.set(item.caption, form, item.lang)
            yield TexPart(item.kind, item.name, label_of(item, ":"), caption, _language(document, item), long)


def _language(document: Document, item: Item) -> str:
    return "" if item.lang in ("", document.lang) else WORDS[item.lang]["babel"]


def _languages(document: Document) -> str:
    """Return the options of babel, the document's own language last."""
    others = sorted({_language(document, item) for item in document.items("text", "table", "figure")} - {""})
    return ",".join([*others, f"main={document.words['babel']}"])


def _title(document: Document, label: str, form: Format, lang: str = "") -> TexTitle:
    words = plain(label, document.mark(lang)).translate(_STRING)
    return TexTitle(document.set(label, form, lang), words, document.set_head(label, form, lang))
