"""Whole documents of a handbook and their free text: what makers and printers of all formats share."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from copy import copy
from functools import partial
from typing import Any, ClassVar, Literal, NamedTuple, Self
from urllib.parse import unquote

from kurbel.documents import prose
from kurbel.documents.document import PLACE, WORDS, Chapter, Document, Item
from kurbel.exact.numerals import Label
from kurbel.formats.registry import FORMATS, PageFormat
from kurbel.formats.render import render_document
from kurbel.formats.writer import PageWriter
from kurbel.page.formula import Formula
from kurbel.page.labels import formula_plain, plain, set_label
from kurbel.reading.given import choose


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

    def but(self, **changed: object) -> Self:
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


PREFIXES = {"table": "tab", "figure": "fig", "chapter": "sec", "place": "idx"}
# What fits one side of a running head.
HEAD = 44


def document_files(
    document: Document, format: str, fragments: Mapping[str, str], templates: str | None = None
) -> dict[str, str]:
    """Return the whole documents of a format as texts by their paths in the output folder.

    `fragments` has each table by its name, rendered in the format, and each figure that is a text;
    `templates` is a folder of the user's own templates. Raises KurbelError for a reference to nothing and
    for a template that cannot be used.
    """
    whole = {name: form for name, form in FORMATS.items() if isinstance(form, PageFormat) and form.figures}
    form = whole[choose(format, whole, "format of documents")]
    maker: DocumentMaker = form.module("document").Maker(form, document, fragments, templates)
    return maker.files()


class DocumentTitle(NamedTuple):
    """A title as it is printed, as a string for what a PDF says of itself, and for a running head."""

    text: str
    string: str
    head: str


class DocumentPart(NamedTuple):
    """A text; or a table or a figure with its number, "Table 3". `alt` is the caption as plain text.

    `lang` is the language where it is not the document's.
    """

    kind: str
    name: str = ""
    label: str = ""
    number: str = ""
    caption: str = ""
    alt: str = ""
    text: str = ""
    lang: str = ""


class DocumentChapter(NamedTuple):
    """A chapter: `heading` is the title as it stands over it, `file` the name of a page of its own.

    `lang` is the language where it is not the document's; `number` is 0 for what is no chapter of its own.
    """

    title: DocumentTitle | str
    heading: str
    label: str
    file: str
    lang: str
    parts: tuple[Any, ...]
    number: int


class DocumentMaker(ABC):
    """Makes the whole documents in a format.

    The labels of chapters, tables and figures are joined by `joint`: tab:delta, tab-delta. `level` is how
    many levels of headings stand above those of the texts, and with `places` an index leads to the words.
    """

    joint: ClassVar[str] = "-"
    level: ClassVar[int] = 1
    places: ClassVar[bool] = False

    def __init__(
        self, form: PageFormat, document: Document, fragments: Mapping[str, str], templates: str | None
    ) -> None:
        self.form = form
        self.writer = form.writer
        self.document = document
        self.fragments = fragments
        self.templates = templates
        self.homes = document.homes()

    @abstractmethod
    def files(self) -> dict[str, str]:
        """Return the documents as texts by their paths in the output folder."""

    def filled(self, name: str, values: Mapping[str, object]) -> str:
        """Return what the template of that name makes of the values."""
        return render_document(self.form, name, values, self.templates)

    def values(self) -> dict[str, Any]:
        """Return what the templates read."""
        document = self.document
        return {
            "document": document,
            "words": document.words,
            "title": self.title(document.title),
            "subtitle": self.titled(document.subtitle),
            "author": self.titled(document.author),
            "chapters": [self.chapter(chapter) for chapter in document.chapters],
        }

    def chapter(self, chapter: Chapter) -> Any:
        """Return a chapter as the templates read it."""
        title = self.title(chapter.title, chapter.lang)
        lang, parts = self.other(chapter.lang), self.parts(chapter)
        heading, label = self.heading(title), self.label(chapter)
        return DocumentChapter(title, heading, label, self.file(chapter), lang, parts, chapter.number)

    def title(self, label: Label, lang: str = "") -> DocumentTitle | str:
        """Return a title as the templates read it."""
        return self.titled(label, lang)

    def titles(self, label: Label, lang: str, string: Callable[[str], str]) -> DocumentTitle:
        """Return a title in all its forms; `string` makes a string of its plain text."""
        text = self.titled(label, lang)
        return DocumentTitle(text, string(self.plain(label, lang)), self.head(label, lang))

    def heading(self, title: Any) -> str:
        """Return a title as it stands over a page."""
        return ""

    def page(self, chapter: Chapter) -> str:
        """Return what stands before the label in a reference to a part of a chapter: "02-paths.md#"."""
        return ""

    def titled(self, label: Label, lang: str = "") -> str:
        """Return a title or a caption of a language in the format."""
        writer, mark = self.writer, self.document.mark(lang)
        return set_label(label, writer.escape, lambda formula: writer.formula(formula, mark), lambda note: "")

    def plain(self, label: Label, lang: str = "") -> str:
        """Return a title or a caption as plain text."""
        return plain(label, self.document.mark(lang))

    def head(self, label: Label, lang: str = "") -> str:
        """Return a title for a running head: one too long for it is cut, its formulas in one line."""
        words = self.plain(label, lang)
        if len(words) <= HEAD:
            return self.titled(label, lang)
        return self.writer.escape(f"{words[: HEAD - 1].rstrip()}…")

    def label(self, part: Chapter | Item) -> str:
        """Return the label of a chapter, a table or a figure."""
        return f"{PREFIXES[_kind(part)]}{self.joint}{part.name}"

    def number(self, item: Item) -> str:
        """Return what stands over a table or under a figure, in its own language: "Table 3"."""
        return f"{WORDS[item.lang][item.kind]} {item.number}"

    def other(self, lang: str) -> str:
        """Return a language where it is not the document's."""
        return "" if lang == self.document.lang else lang

    def file(self, chapter: Chapter) -> str:
        """Return the name of a chapter's own page without its suffix: "02-paths"."""
        chapters = self.document.chapters
        digits = max(2, len(str(len(chapters))))
        before = max(one.number for one in chapters[: chapters.index(chapter) + 1])
        number = chapter.number or before + (before > 0)
        return f"{number:0{digits}}-{chapter.name}"

    def text(self, item: Item) -> str:
        """Return a text in the format.

        What it refers to is called as the text's language calls it. A name that nothing has is a ChoiceError
        with the nearest.
        """
        find = partial(self._find, item.lang)
        return set_prose(tuple(item.blocks), self.form, self.document.mark(item.lang), find, self.level)

    def _find(self, lang: str, name: str) -> Reference:
        chapter, item = self.homes[choose(name, self.homes, "table, figure or chapter")]
        part = item or chapter
        place = name.removeprefix(PLACE) if self.places and name.startswith(PLACE) else ""
        label = f"{PREFIXES['place']}{self.joint}{place}" if place else self.label(part)
        kind = _kind(part) if item or chapter.number else "matter"
        return Reference(kind, self.page(chapter) + label, self.document.title_of(part, lang))

    def parts(self, chapter: Chapter) -> tuple[Any, ...]:
        """Return the parts of a chapter as the templates read them."""
        return tuple(
            self.text_part(item) if item.kind == "text" else self.part(item) for item in chapter.items
        )

    def text_part(self, item: Item) -> object:
        """Return a text as the templates read it."""
        return DocumentPart("text", text=self.text(item), lang=self.other(item.lang))

    def part(self, item: Item) -> Any:
        """Return a table or a figure as the templates read it; the text of a figure is empty."""
        return DocumentPart(
            item.kind,
            item.name,
            self.label(item),
            self.number(item),
            self.titled(item.caption, item.lang),
            self.plain(item.caption, item.lang),
            self.fragments[item.name] if item.kind == "table" else "",
            self.other(item.lang),
        )


def _kind(part: Chapter | Item) -> Literal["table", "figure", "chapter"]:
    if isinstance(part, Chapter):
        return "chapter"
    assert part.kind != "text"
    return part.kind
