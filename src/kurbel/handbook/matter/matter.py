"""The document with what its manifest asks for before and behind the chapters."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from kurbel.documents import prose
from kurbel.documents.document import Chapter, Document, Item
from kurbel.exact.numerals import DECIMAL_OF_LANGUAGE
from kurbel.handbook.matter.colophon import colophon, day_of
from kurbel.handbook.matter.index import author_of, index
from kurbel.handbook.matter.notation import notation
from kurbel.handbook.matter.symbols import symbols
from kurbel.page.quantity import Letter, words

if TYPE_CHECKING:
    from kurbel.handbook.manifest import Manifest
    from kurbel.handbook.pool import About

TITLES = {
    "notation": words("Schreibweise und Vorzeichen|Notation and signs"),
    "symbols": words("Formelzeichen|Symbols"),
    "index": words("Register|Index"),
    "colophon": words("Kolophon|Colophon"),
}
FRONT, BACK = ("notation", "symbols"), ("index", "colophon")
# Their pages show values that books print.
OF_BOOKS = ("example", "collate")


def with_matter(document: Document, manifest: Manifest, made: Mapping[str, About]) -> Document:
    """Return the document with its matter; `made` has what is to know of tables and figures by name."""
    of = _Matter(document, manifest, made)
    return document._replace(chapters=(*of.chapters_of(FRONT), *document.chapters, *of.chapters_of(BACK)))


class _Matter:
    """Makes what stands before and behind the chapters of a document."""

    def __init__(self, document: Document, manifest: Manifest, made: Mapping[str, About]) -> None:
        self.document = document
        self.manifest = manifest
        self.lang = document.lang
        self.abouts = {item.name: made[item.name] for item in document.items("table", "figure")}
        # In another language their quantities have other names.
        own = {name: about for name, about in self.abouts.items() if about.lang == self.lang}
        self.letters: dict[str, tuple[Letter, ...]] = {name: about.letters for name, about in own.items()}

    def chapters_of(self, names: tuple[str, ...]) -> Iterator[Chapter]:
        for name in (name for name in names if name in self.manifest.matter):
            if blocks := getattr(self, name)():
                item = Item("text", lang=self.lang, blocks=blocks)
                yield Chapter(TITLES[name][self.lang], name, 0, (item,), self.lang)

    def notation(self) -> prose.Blocks:
        parts = [part for part in self.manifest.parts() if part.words]
        books = {part.name for part in parts if part.words[0] in OF_BOOKS}
        own = {name: about for name, about in self.abouts.items() if name not in books}
        rounded = {name: about.rounding for name, about in own.items() if about.rounding}
        mark = self.document.decimal or DECIMAL_OF_LANGUAGE[self.lang]
        letters = (one for own in self.letters.values() for one in own)
        return notation(letters, mark, rounded, bool(books), self.lang)

    def symbols(self) -> prose.Blocks:
        return symbols(self.letters, self.lang, "notation" if "notation" in self.manifest.matter else "")

    def index(self) -> prose.Blocks:
        captions = {name: about.caption for name, about in self.abouts.items() if about.lang == self.lang}
        return index(self.letters, captions, self.authors(), self.document.chapters, self.lang)

    def authors(self) -> dict[str, str]:
        """Return the authors after whom tables are, as an index has them."""
        from kurbel.books.source import books

        known = {author_of(book.citation[self.lang]) for book in books()}
        return {
            name: author
            for name, about in self.abouts.items()
            for author in sorted(known)
            if author.split(",")[0] in about.source
        }

    def colophon(self) -> prose.Blocks:
        manifest = self.manifest
        counts = {kind: len([*self.document.items(kind)]) for kind in ("table", "figure")}
        day = day_of(manifest.date)
        return colophon(manifest.title, manifest.author, manifest.version, day, counts, self.lang)
