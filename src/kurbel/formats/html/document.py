"""The handbook as one HTML page that needs nothing else: no script, no font, no picture from elsewhere."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from html.parser import HTMLParser
from typing import NamedTuple

from kurbel.documents.document import Chapter, Item
from kurbel.formats.documents import DocumentMaker
from kurbel.formats.html.svg import inline

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


class Maker(DocumentMaker):
    # The page has one heading above the chapters.
    level = 2

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
            content, ems = _numbered(_REMARK.sub("", fragment), target), width_in_ems(fragment)
        else:
            title = f"{number}: {self.plain(item.caption, item.lang)}"
            content, ems = inline(fragment, target, title, own_page=True), 0.0
        caption = self.titled(item.caption, item.lang)
        return Part(item.kind, target, number, caption, self.other(item.lang), content, ems)


def css_string(text: str) -> str:
    """Return text for a string of CSS: nothing but letters and digits stands for itself."""
    return "".join(
        one if one.isascii() and one.isalnum() else f"\\{ord(one):06x}" for one in text if one != "\0"
    )


def _numbered(fragment: str, target: str) -> str:
    """Return a table whose regions are called by its number too, for captions may be alike."""
    return fragment.replace(f'labelledby="{target}-caption', f'labelledby="{target}-number {target}-caption')


# In units of the type's size, for the widest of the faces that the style sheet names.
_LETTER, _BETWEEN = 0.64, 1.1


def width_in_ems(fragment: str) -> float:
    """Return about how wide the widest table of a fragment is, in units of the size of its type.

    Rather too wide than too narrow: letters count like figures, a formula like its letters on one line but
    for fractions, whose two halves stand above each other.
    """
    reader = _Reader()
    reader.feed(fragment)
    reader.close()
    return max((_width(table) for table in reader.tables), default=0.0)


class _Cell(NamedTuple):
    across: int
    down: int
    letters: float


def _width(rows: list[list[_Cell]]) -> float:
    columns: dict[int, float] = {}
    # A cell across several columns comes last, when it is known how wide they are without it.
    for place, cell in sorted(_placed(rows), key=lambda placed: placed[1].across):
        over = range(place, place + cell.across)
        lacking = _LETTER * cell.letters + _BETWEEN - sum(columns.get(column, 0.0) for column in over)
        for column in over:
            columns[column] = columns.get(column, 0.0) + max(0.0, lacking) / cell.across
    return sum(columns.values())


def _placed(rows: list[list[_Cell]]) -> Iterator[tuple[int, _Cell]]:
    """Yield each cell with the number of its column, past those that reach down from the rows above."""
    taken: dict[int, int] = {}
    for row in rows:
        place = 0
        reaching = {column: left - 1 for column, left in taken.items() if left > 1}
        for cell in row:
            while place in reaching:
                place += 1
            yield place, cell
            reaching |= {place + step: cell.down for step in range(cell.across)}
            place += cell.across
        taken = reaching


class _Reader(HTMLParser):
    """Collects the cells of all tables by their rows."""

    def __init__(self) -> None:
        super().__init__()
        self.tables: list[list[list[_Cell]]] = []
        self.spans = (1, 1)
        self.lines: list[float] = []
        self.fractions = 0

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag == "table":
            self.tables.append([])
        elif tag == "tr":
            self.tables[-1].append([])
        elif tag in ("td", "th"):
            given = dict(attrs)
            self.spans = int(given.get("colspan") or 1), int(given.get("rowspan") or 1)
            self.lines = [0.0]
        elif tag == "br":
            self.lines.append(0.0)
        elif tag == "mfrac":
            self.fractions += 1

    def handle_endtag(self, tag: str) -> None:
        if tag in ("td", "th"):
            self.tables[-1][-1].append(_Cell(*self.spans, max(self.lines)))
            self.lines = []
        elif tag == "mfrac":
            self.fractions -= 1

    def handle_data(self, text: str) -> None:
        if self.lines:
            self.lines[-1] += len(text.strip("\n")) / 2**self.fractions
