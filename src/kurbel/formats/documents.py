"""Whole documents of a handbook: what the makers of all formats share."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, ClassVar, Literal, NamedTuple

from kurbel.documents.document import PLACE, WORDS, Chapter, Document, Item
from kurbel.exact.numerals import Label
from kurbel.formats.printer import Reference, set_prose
from kurbel.formats.registry import FORMATS, PageFormat
from kurbel.formats.render import render_document
from kurbel.page.labels import plain, set_label
from kurbel.reading.given import choose

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

    title: Any
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

    def title(self, label: Label, lang: str = "") -> Any:
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

    def text_part(self, item: Item) -> Any:
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
