"""A handbook in plain text: one file to read from the top to the end."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

from kurbel.documents.document import Chapter, Document, Item
from kurbel.formats.documents import number_of, text_setter, titled
from kurbel.formats.render import render_document
from kurbel.formats.text import FORMAT
from kurbel.formats.text.grid import wrapped

# As wide as texts are.
WIDTH = 78
CHAPTER, TITLE = "━", "═"


class TextPart(NamedTuple):
    """A text; or a table or a figure with its number, and as it stands in the contents."""

    kind: str
    name: str
    number: str
    entry: str
    text: str


class TextChapter(NamedTuple):
    """`heading` is the title with its line, `entry` how it stands in the contents."""

    heading: str
    entry: str
    parts: tuple[TextPart, ...]


def files(document: Document, fragments: Mapping[str, str], templates: str | None = None) -> dict[str, str]:
    """Return handbook.txt, which has the tables in it and names the files of the figures."""
    text = text_setter(document, FORMAT, "", 2)
    values = {
        "document": document,
        "title": _underlined(_titled(document, document.title), TITLE),
        "subtitle": _titled(document, document.subtitle),
        "author": _titled(document, document.author),
        "words": document.words,
        "chapters": [_chapter(document, chapter, fragments, text) for chapter in document.chapters],
    }
    return {"handbook.txt": render_document(FORMAT, "handbook", values, templates)}


def _chapter(
    document: Document, chapter: Chapter, fragments: Mapping[str, str], text: Callable[[Item], str]
) -> TextChapter:
    title = _titled(document, chapter.title, chapter.lang)
    return TextChapter(
        _underlined(f"{chapter.number}  {title}", CHAPTER),
        wrapped(f"{chapter.number}  {title}", WIDTH, 3),
        tuple(_parts(document, chapter, fragments, text)),
    )


def _parts(
    document: Document, chapter: Chapter, fragments: Mapping[str, str], text: Callable[[Item], str]
) -> Iterator[TextPart]:
    for item in chapter.items:
        if item.kind == "text":
            yield TextPart("text", "", "", "", text(item))
            continue
        number, caption = number_of(item), _titled(document, item.caption, item.lang)
        entry = wrapped(f"    {number}. {caption}", WIDTH, 8)
        content = fragments[item.name] if item.kind == "table" else wrapped(f"{number}. {caption}", WIDTH)
        yield TextPart(item.kind, item.name, number, entry, content)


def _titled(document: Document, label: str, lang: str = "") -> str:
    return titled(document, label, FORMAT, lang)


def _underlined(title: str, line: str) -> str:
    lines = wrapped(title, WIDTH).split("\n")
    return "\n".join((*lines, f" {line * (max(map(len, lines)) - 1)}"))
