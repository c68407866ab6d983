"""The handbook as one HTML page that needs nothing else: no font, no picture from elsewhere, and no script
but that of interactive tables."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import NamedTuple

from kurbel.documents.document import Chapter, Item
from kurbel.formats.documents import DocumentMaker
from kurbel.formats.html.live.pages import LIVE, RUNS, live_of, of_each_step
from kurbel.formats.html.svg import inline
from kurbel.formats.html.writer import panelled

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
    """A text, table or figure as finished HTML. `lang` is empty where it is that of the page."""

    kind: str
    target: str
    number: str
    caption: str
    lang: str
    content: str


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


class Maker(DocumentMaker):
    # The page has one heading above the chapters.
    level = 2
    places = True

    def files(self) -> dict[str, str]:
        """Return the page by the name of its file."""
        title, author = self.plain(self.document.title), self.plain(self.document.author)
        values = self.values()
        values |= {
            "plain_title": self.writer.escape(title),
            "plain_author": self.writer.escape(author),
            "head": css_string(title),
            "sections": values["chapters"],
            "words": {**values["words"], **WORDS[self.document.lang]},
            "live": live_of(self.fragments.values())
            if any(LIVE in one or RUNS in one for one in self.fragments.values())
            else None,
        }
        return {NAME: self.filled("handbook", values)}

    def page(self, chapter: Chapter) -> str:
        return "#"

    def chapter(self, chapter: Chapter) -> Section:
        return Section(
            chapter.number,
            self.label(chapter),
            self.titled(chapter.title, chapter.lang),
            css_string(self.plain(chapter.title, chapter.lang)),
            self.other(chapter.lang),
            self.parts(chapter),
        )

    def text_part(self, item: Item) -> Part:
        return Part("text", "", "", "", self.other(item.lang), self.text(item))

    def part(self, item: Item) -> Part:
        target, number, fragment = self.label(item), self.number(item), self.fragments[item.name]
        if item.kind == "table":
            bare = _REMARK.sub("", fragment)
            if LIVE in fragment:
                content = of_each_step(bare, lambda page: panelled(_numbered(page, target)))
            else:
                content = panelled(_numbered(bare, target))
        else:
            title = f"{number}: {self.plain(item.caption, item.lang)}"
            content = self.drawing(fragment, target, title, item.lang)
        caption = self.writer.finish(self.titled(item.caption, item.lang))
        return Part(item.kind, target, number, caption, self.other(item.lang), content)

    def drawing(self, svg: str, target: str, title: str, lang: str) -> str:
        """Return a drawing, and what leads one that moves."""
        if RUNS not in svg:
            return inline(svg, target, title, own_page=True)
        from kurbel.formats.html.live.film import film_block

        return film_block(svg, target, title, lang or self.document.lang, self.document.mark(lang))


def css_string(text: str) -> str:
    """Return text for a string of CSS: nothing but letters and digits stands for itself."""
    return "".join(
        one if one.isascii() and one.isalnum() else f"\\{ord(one):06x}" for one in text if one != "\0"
    )


def _numbered(fragment: str, target: str) -> str:
    """Return a table whose regions are called by its number too, for captions may be alike."""
    return fragment.replace(f'labelledby="{target}-caption', f'labelledby="{target}-number {target}-caption')
