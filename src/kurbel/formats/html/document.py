"""The handbook as one HTML page that needs nothing else: no font, no picture from elsewhere, and no script
but that of interactive tables; its free text; and a drawing's SVG file made part of a page: names of its own,
colours of the page, nothing to spare."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, NamedTuple

from kurbel.documents import prose
from kurbel.documents.document import Chapter, Item
from kurbel.documents.inject import MARKUP_COMMENT, Kind
from kurbel.formats.documents import DocumentMaker, ProsePrinter, Reference
from kurbel.formats.html.writer import RUNS, beside, escape, live_of

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

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


# The colours of drawings by the names that the style sheet gives them, which has others for dark paper.
COLOURS: Mapping[str, str] = {
    "#000000": "ink",
    "#ffffff": "paper",
    "#8c8c8c": "grey",
    "#d9d9d9": "pale",
    "#0072b2": "blue",
    "#d55e00": "orange",
    "#009e73": "green",
    "#a8508c": "purple",
    "#8f6b00": "brown",
}
# What is black by itself has the colour of the text around it.
_NAMES = {**COLOURS, "currentColor": "ink"}
_COLOUR = re.compile("|".join(_NAMES))
_TARGET = re.compile(r"(url\(#)([^)]+)")
_NAMESPACE = re.compile(r"^\{[^}]*\}")
# What a style sheet within a drawing says of all of its elements, and would say of the whole page.
_ALL = re.compile(r"\*\s*\{([^{}]*)\}")
_SPACE = re.compile(r"\s+")
# The class of the style sheet by which a drawing moves, and how the names in it begin.
MOVES, _MOVING = "film-style", re.compile(r"\bfilm-")


def inline(
    svg: str, name: str, title: str, own_page: bool, step: Callable[[str], int] = lambda name: 0
) -> str:
    """Return the drawing for the middle of a page, an element a line.

    Ids begin with `name`, those that nothing refers to are gone, and so are metadata; `title`, plain text, is
    what a screen reader says before the drawing's description. On a page of our own colours are those of its
    style sheet; on another's the drawing keeps its colours and says itself that it is no wider than the page.
    A group has the number that `step` says of its id, but 0.
    Raises xml.etree.ElementTree.ParseError for what is no SVG.
    """
    from xml.etree import ElementTree

    root = ElementTree.fromstring(svg)
    _prune(root)
    for group in root.iter("g"):
        if number := step(group.get("id", "")):
            group.set("data-step", str(number))
    _name(root, name, own_page)
    heading = ElementTree.Element("title", {"id": f"{name}-title"})
    heading.text = title
    root.insert(0, heading)
    kept = ("viewBox", "width", "height", "fill")
    size = {key: root.attrib[key] for key in kept if key in root.attrib}
    said = [root.get("style", ""), "" if own_page else "max-width: 100%; height: auto"]
    style = {"style": "; ".join(filter(None, said))} if any(said) else {}
    root.attrib.clear()
    root.attrib.update(size | style | {"role": "img", "aria-labelledby": f"{name}-title"})
    ElementTree.indent(root, "")
    return ElementTree.tostring(root, encoding="unicode")


def _prune(root: Element) -> None:
    """Drop what only files need; what a style sheet says of all elements, the root says."""
    for parent in [*root.iter()]:
        parent.tag = _NAMESPACE.sub("", parent.tag)
        for child in [*parent]:
            tag = _NAMESPACE.sub("", child.tag)
            if tag == "style" and (said := _ALL.search(child.text or "")):
                root.set("style", said[1])
            if tag in ("title", "metadata", "style") and child.get("class") != MOVES:
                parent.remove(child)
        parent.tail = None
        if parent.tag not in ("desc", "style"):
            parent.text = None
        attributes = {_NAMESPACE.sub("", key): value for key, value in parent.attrib.items()}
        parent.attrib.clear()
        parent.attrib.update(attributes)


def _name(root: Element, name: str, own_page: bool) -> None:
    """Give ids, and what refers to them, names of their own, and colours those of a page of ours."""
    values = [value for one in root.iter() for value in one.attrib.values()]
    targets = {match[2] for value in values for match in _TARGET.finditer(value)}
    targets |= {one.get("href", "").removeprefix("#") for one in root.iter()}
    for one in root.iter():
        if one.tag == "style":
            one.text = _MOVING.sub(f"{name}-film-", one.text or "")
        if one.get("id") not in targets and not _MOVING.match(one.get("id", "")):
            one.attrib.pop("id", None)
        for key, value in one.attrib.items():
            renamed = _SPACE.sub(" ", _renamed(key, value, name)).strip()
            if own_page:
                renamed = _COLOUR.sub(lambda colour: f"var(--{_NAMES[colour[0]]})", renamed)
            one.attrib[key] = renamed


def _renamed(key: str, value: str, name: str) -> str:
    if key == "id":
        return f"{name}-{value}"
    if key == "href":
        return f"#{name}-{value.removeprefix('#')}"
    return _TARGET.sub(rf"\g<1>{name}-\g<2>", value)
