"""The handbook as one HTML page that needs nothing else: no font, no picture from elsewhere, and no script
but that of interactive tables; and its free text."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from kurbel.documents import prose
from kurbel.documents.document import Chapter, Item
from kurbel.documents.inject import MARKUP_COMMENT, Kind
from kurbel.formats.documents import DocumentMaker, ProsePrinter, Reference
from kurbel.formats.html.svg import inline
from kurbel.formats.html.writer import RUNS, beside, escape, live_of

KIND = Kind(
    name="HTML",
    suffixes=(".html", ".htm", ".xhtml"),
    left="<!--",
    right="-->",
    comment=MARKUP_COMMENT,
)


class Printer(ProsePrinter):
    emphasised, strong = ("<em>", "</em>"), ("<strong>", "</strong>")
    quoted = ("<blockquote>\n", "\n</blockquote>")
    rule, line_end, between = "<hr>", "<br>\n", "\n"

    def paragraph(self, content: prose.Inlines) -> str:
        return f"<p>{beside(self.inlines(content))}</p>"

    def heading(self, level: int, content: prose.Inlines) -> str:
        level = min(level, 6)
        return f"<h{level}>{self.inlines(content)}</h{level}>"

    def code_block(self, lines: tuple[str, ...]) -> str:
        # A long line scrolls, also by the keyboard.
        code = escape("".join(f"{line}\n" for line in lines))
        return f'<pre tabindex="0"><code>{code}</code></pre>'

    def listing(self, listing: prose.Listing) -> str:
        tag = "ul" if listing.start is None else "ol"
        start = "" if listing.start in (None, 1) else f' start="{listing.start}"'
        items = "\n".join(self._item(item, listing.tight) for item in listing.items)
        return f"<{tag}{start}>\n{items}\n</{tag}>"

    def _item(self, item: prose.Blocks, tight: bool) -> str:
        """Return an item; in a tight list its paragraphs stand bare."""
        blocks = (
            self.inlines(block.content) if tight and isinstance(block, prose.Paragraph) else self.block(block)
            for block in item
        )
        return "\n".join(blocks).join(("<li>", "</li>"))

    def grid(self, grid: prose.Grid) -> str:
        head = self._row(grid.head, grid.aligns, "th", ' scope="col"')
        rows = "\n".join(self._row(row, grid.aligns, "td") for row in grid.rows)
        body = f"<tbody>\n{rows}\n</tbody>\n" if rows else ""
        table = f"<table>\n<thead>\n{head}\n</thead>\n{body}</table>"
        return f'<div class="scroll" tabindex="0">\n{table}\n</div>'

    def _row(
        self, cells: Iterable[prose.Inlines], aligns: Iterable[prose.Align | None], tag: str, scope: str = ""
    ) -> str:
        styles = (f' style="text-align: {align}"' if align else "" for align in aligns)
        tags = (
            f"<{tag}{scope}{style}>{self.inlines(cell)}</{tag}>"
            for cell, style in zip(cells, styles, strict=True)
        )
        return f"<tr>{''.join(tags)}</tr>"

    def index(self, index: prose.Index) -> str:
        return super().index(index).join(('<div class="index">\n', "\n</div>"))

    def marked(self, place: Reference, words: str) -> str:
        return f'<span id="{escape(place.target.removeprefix("#"))}">{words}</span>'

    def code(self, text: str) -> str:
        return f"<code>{escape(text)}</code>"

    def link(self, address: str, content: prose.Inlines) -> str:
        return f'<a href="{escape(address)}">{self.inlines(content)}</a>'


NAME = "handbook.html"
WORDS: Mapping[str, Mapping[str, str]] = {
    "de": {
        "skip": "Zum Inhalt der Seite springen",
        "link": "Link zum Kapitel",
        "back": "Zum Inhaltsverzeichnis",
    },
    "en": {"skip": "Skip to the main text", "link": "Link to the chapter", "back": "Back to the contents"},
}


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
            "live": live_of(self.fragments.values()),
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
            content = fragment
        else:
            title = f"{number}: {self.plain(item.caption, item.lang)}"
            content = self.drawing(fragment, target, title, item.lang)
        caption = self.writer.finish(self.titled(item.caption, item.lang))
        return Part(item.kind, target, number, caption, self.other(item.lang), content)

    def drawing(self, svg: str, target: str, title: str, lang: str) -> str:
        """Return a drawing, and what leads one that moves."""
        if RUNS not in svg:
            return inline(svg, target, title, own_page=True)
        from kurbel.formats.html.live import film_block

        return film_block(svg, target, title, lang or self.document.lang, self.document.mark(lang))


def css_string(text: str) -> str:
    """Return text for a string of CSS: nothing but letters and digits stands for itself."""
    return "".join(
        one if one.isascii() and one.isalnum() else f"\\{ord(one):06x}" for one in text if one != "\0"
    )
