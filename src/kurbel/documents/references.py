"""What a text of a handbook refers to by name: one way for all formats, which differ in the target."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Literal

from kurbel.documents.document import WORDS, Chapter, Document, Item
from kurbel.documents.prose_print import Reference, set_prose
from kurbel.formats.registry import Format
from kurbel.reading.choices import choose

PREFIXES = {"table": "tab", "figure": "fig", "chapter": "sec"}


def label_of(part: Chapter | Item, joint: str) -> str:
    """Return the label of a chapter, a table or a figure: tab:delta or, joined by a hyphen, tab-delta."""
    return f"{PREFIXES[_kind(part)]}{joint}{part.name}"


def text_setter(
    document: Document, form: Format, joint: str, level: int, page: Callable[[Chapter], str] = lambda one: ""
) -> Callable[[Item], str]:
    """Return what sets the texts of the document in a format, with headings below those of so many levels.

    What a text refers to is the label, with this joint, behind what `page` returns for its chapter, such as
    "#" or "02-paths.md#", and is called as the text's language calls it. A name that nothing has is a
    ChoiceError with the nearest.
    """
    homes = document.homes()

    def find(lang: str, name: str) -> Reference:
        chapter, item = homes[choose(name, homes, "table, figure or chapter")]
        part = item or chapter
        return Reference(_kind(part), page(chapter) + label_of(part, joint), document.title_of(part, lang))

    def text(item: Item) -> str:
        blocks, mark = tuple(item.blocks), document.mark(item.lang)
        return set_prose(blocks, form, mark, partial(find, item.lang), level)

    return text


def number_of(item: Item) -> str:
    """Return what stands over a table or under a figure, in its own language: "Table 3"."""
    return f"{WORDS[item.lang][item.kind]} {item.number}"


def _kind(part: Chapter | Item) -> Literal["table", "figure", "chapter"]:
    if isinstance(part, Chapter):
        return "chapter"
    assert part.kind != "text"
    return part.kind
