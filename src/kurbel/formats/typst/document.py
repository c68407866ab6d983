"""A handbook in Typst: one source that includes the tables and draws in the figures beside it."""

from __future__ import annotations

import math
import re
from typing import NamedTuple

from kurbel.documents.document import WORDS, Chapter, Item
from kurbel.exact.numerals import Label
from kurbel.formats.documents import DocumentMaker
from kurbel.formats.typst.writer import string

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


class Maker(DocumentMaker):
    def files(self) -> dict[str, str]:
        """Return handbook.typ, which includes the fragments as files of the folder tables."""
        document = self.document
        values = {
            "document": document,
            "title": self.title(document.title),
            "subtitle": self.title(document.subtitle),
            "author": self.title(document.author),
            "words": document.words,
            "languages": WORDS,
            "chapters": [self.chapter(chapter) for chapter in document.chapters],
            "kinds": {item.kind for item in document.items("table", "figure")},
        }
        return {"handbook.typ": self.filled("handbook", values)}

    def chapter(self, chapter: Chapter) -> TypstChapter:
        title = self.title(chapter.title, chapter.lang)
        return TypstChapter(title, string(self.label(chapter)), self.other(chapter.lang), self.parts(chapter))

    def title(self, label: Label, lang: str = "") -> TypstTitle:
        return TypstTitle(self.titled(label, lang), string(self.plain(label, lang)), self.head(label, lang))

    def text_part(self, item: Item) -> TypstPart:
        return TypstPart("text", "", "", self.text(item), "", self.other(item.lang))

    def part(self, item: Item) -> TypstPart:
        table = item.kind == "table"
        return TypstPart(
            item.kind,
            string(f"tables/{item.name}.typ" if table else f"figures/{item.name}.svg"),
            string(self.label(item)),
            self.titled(item.caption, item.lang),
            string(self.plain(item.caption, item.lang)),
            self.other(item.lang),
            table and _width(self.fragments[item.name]) < NARROW,
        )


def _width(fragment: str) -> float:
    """Return how wide a table is at the most, in em, as its fragment says."""
    found = _WIDE.search(fragment)
    return float(found[1]) if found else math.inf
