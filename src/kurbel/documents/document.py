"""A handbook as its documents see it: chapters of texts, tables and figures, numbered throughout.

Titles and captions are labels in the notation of `labels.py`; what stands in a format is made elsewhere.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Literal, NamedTuple

from kurbel.documents.prose import Block, terms
from kurbel.exact.numerals import DECIMAL_OF_LANGUAGE, DECIMALS, Label
from kurbel.page.labels import plain

# Before the number of a place to which the index leads: no name begins so.
PLACE = "@"
# By the language of the document; TeX and Typst have the same words.
WORDS: Mapping[str, Mapping[str, str]] = {
    "de": {
        "table": "Tabelle",
        "figure": "Abbildung",
        "contents": "Inhalt",
        "tables": "Tabellenverzeichnis",
        "figures": "Abbildungsverzeichnis",
        "babel": "ngerman",
    },
    "en": {
        "table": "Table",
        "figure": "Figure",
        "contents": "Contents",
        "tables": "List of Tables",
        "figures": "List of Figures",
        "babel": "english",
    },
}


class Item(NamedTuple):
    """A text, a table or a figure of a chapter.

    `name` is what its files are called and, behind tab: or fig:, its label; `number` counts its kind through
    the whole handbook from 1. A text has only its language and its blocks; one with a name stands in for a
    table or a figure that could not be made. Its highest headings have level 1, just below the chapter.
    """

    kind: Literal["text", "table", "figure"]
    name: str = ""
    number: int = 0
    lang: str = ""
    caption: Label = ""
    blocks: Sequence[Block] = ()


class Chapter(NamedTuple):
    """`name` is a slug, unique among the chapters; `number` counts from 1. No language is the document's.

    What stands before the chapters or behind them, such as an index, has the number 0.
    """

    title: Label
    name: str
    number: int
    items: tuple[Item, ...]
    lang: str = ""


class Document(NamedTuple):
    """`decimal` is the decimal mark of numbers in texts and titles; by default that of their language."""

    title: Label
    lang: str
    decimal: str
    chapters: tuple[Chapter, ...]
    subtitle: Label = ""
    author: Label = ""

    def items(self, *kinds: str) -> Iterator[Item]:
        """Yield the items of these kinds in their order."""
        for chapter in self.chapters:
            yield from (item for item in chapter.items if item.kind in kinds)

    @property
    def words(self) -> Mapping[str, str]:
        """The document's own words, such as those over its lists."""
        return WORDS[self.lang]

    def mark(self, lang: str = "") -> str:
        """Return the decimal mark in what has a language, by default the document's."""
        return DECIMALS[self.decimal or DECIMAL_OF_LANGUAGE[lang or self.lang]]

    def homes(self) -> dict[str, tuple[Chapter, Item | None]]:
        """Return by its name each chapter, and each table and figure with its chapter.

        What should be a table or a figure and could not be made is its chapter alone, and so is a place to
        which the index leads.
        """
        homes: dict[str, tuple[Chapter, Item | None]] = {one.name: (one, None) for one in self.chapters}
        homes |= {
            term.place: (chapter, None)
            for chapter in self.chapters
            for item in chapter.items
            for term in (terms(tuple(item.blocks)) if item.blocks else ())
            if term.place
        }
        return homes | {
            item.name: (chapter, None if item.kind == "text" else item)
            for chapter in self.chapters
            for item in chapter.items
            if item.name
        }

    def title_of(self, one: Chapter | Item, lang: str = "") -> str:
        """Return what a reference in a language calls it: "Tabelle 3", "§ 2"."""
        if isinstance(one, Chapter):
            return f"§ {one.number}" if one.number else plain(one.title, self.mark(lang))
        return f"{WORDS[lang or self.lang][one.kind]} {one.number}"
