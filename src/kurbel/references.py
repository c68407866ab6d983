"""What a text of a handbook refers to by name: one finder for all formats, which differ in the target."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

from kurbel.document import WORDS, Chapter, Document, Item
from kurbel.prose_print import Find, Reference

PREFIXES = {"table": "tab", "figure": "fig", "chapter": "sec"}


def label_of(part: Chapter | Item, joint: str) -> str:
    """Return the label of a chapter, a table or a figure: tab:delta or, joined by a hyphen, tab-delta."""
    return f"{PREFIXES[_kind(part)]}{joint}{part.name}"


def finder(
    document: Document, joint: str, lang: str = "", page: Callable[[Chapter], str] = lambda chapter: ""
) -> Find:
    """Return the function that finds what a name refers to; it raises ChoiceError for one that nothing has.

    The target is the label behind what `page` returns for its chapter, such as "#" or "02-paths.md#"; what it
    is called is said in the language of the text.
    """

    def find(name: str) -> Reference:
        chapter, item = document.home(name)
        part = item or chapter
        return Reference(_kind(part), page(chapter) + label_of(part, joint), document.title_of(part, lang))

    return find


def number_of(item: Item) -> str:
    """Return what stands over a table or under a figure, in its own language: "Table 3"."""
    return f"{WORDS[item.lang][item.kind]} {item.number}"


def _kind(part: Chapter | Item) -> Literal["table", "figure", "chapter"]:
    if isinstance(part, Chapter):
        return "chapter"
    assert part.kind != "text"
    return part.kind
