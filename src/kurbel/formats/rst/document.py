"""A handbook in reStructuredText: a project of Sphinx with an index and one page a chapter."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

from kurbel.documents.document import Chapter, Document, Item
from kurbel.documents.prose import Block, Heading
from kurbel.documents.prose_levels import stepwise
from kurbel.formats.documents import label_of, number_of, text_setter, titled
from kurbel.formats.render import render_document
from kurbel.formats.rst import FORMAT
from kurbel.formats.rst.escapes import finish
from kurbel.formats.rst.prose import underlined
from kurbel.page.labels import plain

_CAPTION = re.compile(r"^\.\. table::", re.MULTILINE)


class RstPart(NamedTuple):
    """A text; or a table or a figure with its number. `alt` is the caption without formulas' notation."""

    kind: str
    name: str
    label: str
    number: str
    caption: str
    alt: str
    text: str


class RstChapter(NamedTuple):
    """`heading` is the title with its line, `file` the name of the page without its suffix."""

    heading: str
    label: str
    file: str
    parts: tuple[RstPart, ...]


def files(document: Document, fragments: Mapping[str, str], templates: str | None = None) -> dict[str, str]:
    """Return rst/index.rst, a page for each chapter, and what Sphinx reads: conf.py and a style sheet."""
    text = text_setter(document, FORMAT, "-", 1)
    chapters = [
        RstChapter(
            underlined(_titled(document, chapter.title, chapter.lang), 1),
            label_of(chapter, "-"),
            _file(document, chapter),
            tuple(_parts(document, chapter, fragments, text)),
        )
        for chapter in document.chapters
    ]
    common = {
        "words": document.words,
        "document": document,
        "heading": underlined(_titled(document, document.title), 1),
        "subtitle": _titled(document, document.subtitle),
        "author": _titled(document, document.author),
        "project": repr(plain(document.title, document.mark())),
        "by": repr(plain(document.author, document.mark())),
        "chapters": chapters,
    }
    pages = {
        f"rst/{file}": render_document(FORMAT, name, common, templates)
        for file, name in (("index.rst", "index"), ("conf.py", "conf"), ("kurbel.css", "style"))
    }
    for chapter in chapters:
        pages[f"rst/{chapter.file}.rst"] = render_document(
            FORMAT, "chapter", common | {"chapter": chapter}, templates
        )
    return pages


def _file(document: Document, chapter: Chapter) -> str:
    digits = max(2, len(str(len(document.chapters))))
    return f"{chapter.number:0{digits}}-{chapter.name}"


def _titled(document: Document, label: str, lang: str = "") -> str:
    return finish(titled(document, label, FORMAT, lang))


def _parts(
    document: Document, chapter: Chapter, fragments: Mapping[str, str], text: Callable[[Item], str]
) -> Iterator[RstPart]:
    above: list[int] = []
    for item in chapter.items:
        if item.kind == "text":
            blocks = tuple(_as_sections(item.blocks, above))
            yield RstPart("text", "", "", "", "", "", text(item._replace(blocks=blocks)))
            continue
        number = number_of(item)
        yield RstPart(
            item.kind,
            item.name,
            label_of(item, "-"),
            number,
            _titled(document, item.caption, item.lang),
            " ".join(plain(item.caption, document.mark(item.lang)).split()),
            _CAPTION.sub(f".. table:: {number}.", fragments[item.name], 1) if item.kind == "table" else "",
        )


def _as_sections(blocks: Sequence[Block], above: list[int]) -> Iterator[Block]:
    """Yield the blocks with the levels of headings anew: those in lists and quotations are no sections."""
    for block in blocks:
        yield from stepwise((block,), above) if isinstance(block, Heading) else (block,)
