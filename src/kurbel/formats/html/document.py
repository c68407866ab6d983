"""The handbook as one HTML page that needs nothing else: no script, no font, no picture from elsewhere."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

from kurbel.documents.document import Document, Item
from kurbel.formats.documents import label_of, number_of, text_setter, titled
from kurbel.formats.html import FORMAT
from kurbel.formats.html.svg import inline
from kurbel.formats.html.width import width_in_ems
from kurbel.formats.render import render_document
from kurbel.page.labels import plain

NAME = "handbook.html"
WORDS: Mapping[str, Mapping[str, str]] = {
    "de": {
        "skip": "Zum Inhalt der Seite springen",
        "link": "Link zum Kapitel",
        "back": "Zum Inhaltsverzeichnis",
    },
    "en": {"skip": "Skip to the main text", "link": "Link to the chapter", "back": "Back to the contents"},
}
_REMARK = re.compile(r"\A\s*<!--.*?-->\s*", re.DOTALL)


class Part(NamedTuple):
    """A text, table or figure as finished HTML. `lang` is empty where it is that of the page.

    `ems` is how wide a table is in units of the size of its type.
    """

    kind: str
    target: str
    number: str
    caption: str
    lang: str
    content: str
    ems: float = 0.0


class Section(NamedTuple):
    """A chapter. `head` is what stands above its printed pages, as a string of CSS without its quotes."""

    number: int
    target: str
    title: str
    head: str
    lang: str
    parts: tuple[Part, ...]

    @property
    def entries(self) -> tuple[Part, ...]:
        """What the table of contents lists below the chapter."""
        return tuple(part for part in self.parts if part.kind != "text")


def files(document: Document, fragments: Mapping[str, str], templates: str | None = None) -> dict[str, str]:
    """Return the page by the name of its file.

    `fragments` has the HTML of each table and the SVG file of each figure by its name.
    """
    mark = document.mark()
    page = render_document(
        FORMAT,
        "handbook",
        {
            "document": document,
            "title": titled(document, document.title, FORMAT),
            "subtitle": titled(document, document.subtitle, FORMAT),
            "author": titled(document, document.author, FORMAT),
            "plain_title": FORMAT.escape(plain(document.title, mark)),
            "plain_author": FORMAT.escape(plain(document.author, mark)),
            "head": css_string(plain(document.title, mark)),
            "sections": [*_sections(document, fragments)],
            "words": {**document.words, **WORDS[document.lang]},
        },
        templates,
    )
    return {NAME: page}


def css_string(text: str) -> str:
    """Return text for a string of CSS: nothing but letters and digits stands for itself."""
    return "".join(
        one if one.isascii() and one.isalnum() else f"\\{ord(one):06x}" for one in text if one != "\0"
    )


def _sections(document: Document, fragments: Mapping[str, str]) -> Iterator[Section]:
    # The page has one heading above the chapters.
    text = text_setter(document, FORMAT, "-", 2, lambda chapter: "#")
    for chapter in document.chapters:
        yield Section(
            chapter.number,
            label_of(chapter, "-"),
            titled(document, chapter.title, FORMAT, chapter.lang),
            css_string(plain(chapter.title, document.mark(chapter.lang))),
            _other(document, chapter.lang),
            tuple(_part(document, item, fragments, text) for item in chapter.items),
        )


def _other(document: Document, lang: str) -> str:
    """Return a language where it is not the document's."""
    return "" if lang == document.lang else lang


def _part(document: Document, item: Item, fragments: Mapping[str, str], text: Callable[[Item], str]) -> Part:
    lang = _other(document, item.lang)
    if item.kind == "text":
        return Part("text", "", "", "", lang, text(item))
    target, number = label_of(item, "-"), number_of(item)
    caption = titled(document, item.caption, FORMAT, item.lang)
    fragment = fragments[item.name]
    if item.kind == "table":
        content = _numbered(_REMARK.sub("", fragment), target)
        return Part("table", target, number, caption, lang, content, width_in_ems(fragment))
    title = f"{number}: {plain(item.caption, document.mark(item.lang))}"
    return Part("figure", target, number, caption, lang, inline(fragment, target, title, own_page=True))


def _numbered(fragment: str, target: str) -> str:
    """Return a table whose regions are called by its number too, for captions may be alike."""
    return fragment.replace(f'labelledby="{target}-caption', f'labelledby="{target}-number {target}-caption')
