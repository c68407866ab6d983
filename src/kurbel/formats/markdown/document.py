"""A handbook in Markdown: a folder with an index and one page a chapter."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

from kurbel.documents.document import Chapter, Document, Item
from kurbel.formats.documents import label_of, number_of, text_setter, titled
from kurbel.formats.markdown import FORMAT
from kurbel.formats.render import render_document
from kurbel.page.labels import plain

# A # at the end of a heading would be taken for its end.
_LAST_HASHES = re.compile(r"(#+)$")


class MarkdownPart(NamedTuple):
    """A text; or a table or a figure with its caption. `alt` is the caption without formulas' notation."""

    kind: str
    name: str
    label: str
    number: str
    caption: str
    alt: str
    text: str


class MarkdownChapter(NamedTuple):
    """`heading` is the title where it stands behind # signs."""

    title: str
    heading: str
    label: str
    file: str
    parts: tuple[MarkdownPart, ...]


def files(document: Document, fragments: Mapping[str, str], templates: str | None = None) -> dict[str, str]:
    """Return markdown/index.md and a page for each chapter."""
    text = text_setter(document, FORMAT, "-", 1, lambda chapter: f"{_file(document, chapter)}#")
    chapters = [
        MarkdownChapter(
            title := titled(document, chapter.title, FORMAT, chapter.lang),
            _heading(title),
            label_of(chapter, "-"),
            _file(document, chapter),
            tuple(_parts(document, chapter, fragments, text)),
        )
        for chapter in document.chapters
    ]
    title = titled(document, document.title, FORMAT)
    common = {
        "words": document.words,
        "title": title,
        "heading": _heading(title),
        "subtitle": titled(document, document.subtitle, FORMAT),
        "author": titled(document, document.author, FORMAT),
        "chapters": chapters,
    }
    pages = {"markdown/index.md": render_document(FORMAT, "index", common, templates)}
    for place, chapter in enumerate(chapters):
        values = common | {
            "chapter": chapter,
            "before": chapters[place - 1] if place else None,
            "after": chapters[place + 1] if place + 1 < len(chapters) else None,
        }
        pages[f"markdown/{chapter.file}"] = render_document(FORMAT, "chapter", values, templates)
    return pages


def _file(document: Document, chapter: Chapter) -> str:
    digits = max(2, len(str(len(document.chapters))))
    return f"{chapter.number:0{digits}}-{chapter.name}.md"


def _heading(title: str) -> str:
    return _LAST_HASHES.sub(r"\\\1", title)


def _parts(
    document: Document, chapter: Chapter, fragments: Mapping[str, str], text: Callable[[Item], str]
) -> Iterator[MarkdownPart]:
    for item in chapter.items:
        if item.kind == "text":
            yield MarkdownPart("text", "", "", "", "", "", text(item))
        else:
            yield MarkdownPart(
                item.kind,
                item.name,
                label_of(item, "-"),
                number_of(item),
                titled(document, item.caption, FORMAT, item.lang),
                FORMAT.escape(plain(item.caption, document.mark(item.lang))),
                fragments[item.name] if item.kind == "table" else "",
            )
