"""Free text in print: what the printers of all formats share."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from copy import copy
from typing import Any, ClassVar, Literal, NamedTuple, Self
from urllib.parse import unquote

from kurbel.documents import prose
from kurbel.formats.registry import PageFormat
from kurbel.formats.writer import PageWriter
from kurbel.page.formula import Formula
from kurbel.page.labels import formula_plain


class Reference(NamedTuple):
    """A part of the handbook that a text names; `matter` is what has a title and no number.

    `target` is what the format jumps to: tab:delta in LaTeX, tab-delta in Typst, #tab-delta in HTML.
    `text` is its name and number, "Tabelle 3", not escaped, for formats that count nothing by themselves.
    """

    kind: Literal["table", "figure", "chapter", "matter"]
    target: str
    text: str


Find = Callable[[str], Reference]


def set_prose(blocks: prose.Blocks, form: PageFormat, mark: str, refer: Find, level: int = 1) -> str:
    """Return a text in a format, its last line ended.

    `mark` is the decimal mark of numbers in formulas; `refer` returns what a name refers to, or raises;
    `level` is how many levels of headings stand above the text: at 1 its # is a section below a chapter.
    """
    printer: ProsePrinter = form.module("document").Printer(form.writer, mark, refer, level)
    return printer.document(blocks)


class ProsePrinter(ABC):
    """Sets blocks and inlines; each format says how.

    `emphasised` and `strong` are what stands before and behind such words, `quoted` before and behind a
    quotation; `rule` is a line across the page, `line_end` the end of a line that the author asked for,
    `between` what stands between blocks.
    """

    emphasised: ClassVar[tuple[str, str]] = ("", "")
    strong: ClassVar[tuple[str, str]] = ("", "")
    quoted: ClassVar[tuple[str, str]] = ("", "")
    rule: str
    line_end: str = "\n"
    between: str = "\n\n"

    def __init__(self, writer: PageWriter, mark: str, refer: Find, level: int) -> None:
        self.writer = writer
        self.mark = mark
        self.refer = refer
        self.level = level

    def but(self, **changed: Any) -> Self:
        """Return a printer like this one but for some of what it knows, for what stands within."""
        other = copy(self)
        vars(other).update(changed)
        return other

    def document(self, blocks: prose.Blocks) -> str:
        """Return the whole text."""
        return self.blocks(blocks) + "\n" if blocks else ""

    def blocks(self, blocks: prose.Blocks, between: str | None = None) -> str:
        """Return blocks below each other."""
        return (between or self.between).join(self.block(block) for block in blocks)

    def block(self, block: prose.Block) -> str:
        """Return one block, without the end of its last line."""
        match block:
            case prose.Paragraph(content):
                return self.paragraph(content)
            case prose.Heading(level, content):
                return self.heading(level + self.level, content)
            case prose.CodeBlock(lines):
                return self.code_block(lines)
            case prose.Quote(content):
                return self.quote(content)
            case prose.Listing():
                return self.listing(block)
            case prose.Rule():
                return self.rule
            case prose.Grid():
                return self.grid(block)
            case prose.Index():
                return self.index(block)

    def inlines(self, content: prose.Inlines) -> str:
        """Return inlines beside each other."""
        return "".join(self.inline(inline) for inline in content)

    def inline(self, inline: prose.Inline) -> str:
        """Return one inline."""
        match inline:
            case prose.Text(text):
                return self.text(text)
            case Formula():
                return self.writer.formula(inline, self.mark)
            case prose.Code(text):
                return self.code(text)
            case prose.Break():
                return self.line_end
            case prose.Emphasis(content):
                return self.inlines(content).join(self.emphasised)
            case prose.Strong(content):
                return self.inlines(content).join(self.strong)
            case prose.Link(address, content):
                return self.link(address, content)
            case prose.Refer(name, content):
                found = self.refer(name)
                title = (prose.Text(found.text),) if found.kind == "matter" else ()
                return self.reference(found, content or title)
            case prose.Indexed(_, content, place):
                words = self.inlines(content)
                return self.marked(self.refer(place), words) if place else words

    def plain(self, content: prose.Inlines) -> str:
        """Return the letters of inlines, where nothing else can stand."""
        pieces = []
        for inline in content:
            match inline:
                case prose.Text(text) | prose.Code(text):
                    pieces.append(text)
                case Formula():
                    pieces.append(formula_plain(inline, self.mark))
                case prose.Emphasis(inner) | prose.Strong(inner) | prose.Link(_, inner):
                    pieces.append(self.plain(inner))
                case prose.Indexed(_, inner):
                    pieces.append(self.plain(inner))
                case prose.Refer(name, inner):
                    pieces.append(self.plain(inner) or self.refer(name).text)
                case prose.Break():
                    pieces.append(" ")
        return "".join(pieces)

    def text(self, text: str) -> str:
        """Return words."""
        return self.writer.escape(text)

    def paragraph(self, content: prose.Inlines) -> str:
        """Return a paragraph."""
        return self.inlines(content)

    @abstractmethod
    def heading(self, level: int, content: prose.Inlines) -> str:
        """Return a heading; level 1 is that of a title or chapter."""

    @abstractmethod
    def code_block(self, lines: tuple[str, ...]) -> str:
        """Return lines of code."""

    def quote(self, content: prose.Blocks) -> str:
        """Return a quotation."""
        return self.blocks(content).join(self.quoted)

    @abstractmethod
    def listing(self, listing: prose.Listing) -> str:
        """Return a list."""

    @abstractmethod
    def grid(self, grid: prose.Grid) -> str:
        """Return a table."""

    def index(self, index: prose.Index) -> str:
        """Return an index, whose terms lead to tables, figures and chapters where there are no pages."""
        blocks: list[prose.Block] = []
        for letter, terms in index.groups:
            head = prose.Paragraph((prose.Strong((prose.Text(letter),)),))
            entries = ((prose.Paragraph(self._entry(term)),) for term in terms)
            blocks += [head, prose.Listing(None, True, tuple(entries))]
        return self.blocks(tuple(blocks))

    def _entry(self, term: prose.Term) -> prose.Inlines:
        # Several places of one chapter without pages of its own are called alike.
        found = {self.refer(name).text: prose.Refer(name, ()) for name in term.places}
        parted = (inline for refer in found.values() for inline in (prose.Text(", "), refer))
        return (prose.Text(term.words), *parted, *([prose.Text(f" {term.more}")] if term.more else []))

    def marked(self, place: Reference, words: str) -> str:
        """Return words to which an index leads."""
        return words

    @abstractmethod
    def code(self, text: str) -> str:
        """Return characters of code."""

    @abstractmethod
    def link(self, address: str, content: prose.Inlines) -> str:
        """Return a link to another site."""

    def reference(self, reference: Reference, content: prose.Inlines) -> str:
        """Return a reference to a part of the handbook."""
        return self.link(reference.target, content or (prose.Text(reference.text),))


def is_own(address: str, content: prose.Inlines) -> bool:
    """Tell whether the words of a link are nothing but its address."""
    match content:
        case (prose.Text(text),):
            return unquote(text) in (unquote(address), unquote(address.removeprefix("mailto:")))
    return False


def indented(text: str, first: str, rest: str) -> str:
    """Return lines with what stands before the first and before the others, nothing at their ends."""
    lines = text.split("\n")
    prefixes = [first] + [rest] * (len(lines) - 1)
    return "\n".join(
        f"{prefix}{line}" if line else prefix.rstrip() for prefix, line in zip(prefixes, lines, strict=True)
    )
