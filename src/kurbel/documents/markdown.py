"""A handbook in Markdown: a folder with an index and one page a chapter."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

from kurbel.documents.document import Chapter, Document, Item
from kurbel.documents.references import label_of, number_of, text_setter
from kurbel.formats.registry import by_name
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
    form = by_name("markdown")
    text = text_setter(document, form, "-", 1, lambda chapter: f"{_file(document, chapter)}#")
    chapters = [
        MarkdownChapter(
            title := document.set(chapter.title, form, chapter.lang),
            _heading(title),
            label_of(chapter, "-"),
            _file(document, chapter),
            tuple(_parts(document, chapter, fragments, text)),
        )
        for chapter in document.chapters
    ]
    title = document.set(document.title, form)
    common = {
        "words": document.words,
        "title": title,
        "heading": _heading(title),
        "subtitle": document.set(document.subtitle, form),
        "author": document.set(document.author, form),
        "chapters": chapters,
    }
    pages = {"markdown/index.md": render_document("markdown", "index", common, templates)}
    for place, chapter in enumerate(chapters):
        values = common | {
            "chapter": chapter,
            "before": chapters[place - 1] if place else None,
            "after": chapters[place + 1] if place + 1 < len(chapters) else None,
        }
        pages[f"markdown/{chapter.file}"] = render_document("markdown", "chapter", values, templates)
    return pages


def _file(document: Document, chapter: Chapter) -> str:
    digits = max(2, len(str(len(document.chapters))))
    return f"{chapter.number:0{digits}}-{chapter.name}.md"


def _heading(title: str) -> str:
    return _LAST_HASHES.sub(r"\\\1", title)


def _parts(
    document: Document, chapter: Chapter, fragments: Mapping[str, str], text: Callable[[Item], str]
) -> Iterator[MarkdownPart]:
    form = by_name("markdown")
    for item in chapter.items:
        if item.kind == "text":
            yield MarkdownPart("text", "", "", "", "", "", text(item))
        else:
            yield MarkdownPart(
                item.kind,
                item.name,
                label_of(item, "-"),
                number_of(item),
                document.set(item.caption, form, item.lang),
                form.escape(plain(item.caption, document.mark(item.lang))),
                fragments[item.name] if item.kind == "table" else "",
            )
