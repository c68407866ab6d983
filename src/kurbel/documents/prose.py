"""Free text as a small tree of blocks and inlines."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

from msgspec import Struct
from msgspec.structs import replace

from kurbel.page.formula import Formula

Align = Literal["left", "center", "right"]


class Text(Struct, frozen=True):
    text: str


class Code(Struct, frozen=True):
    """Characters of a program or a command line."""

    text: str


class Break(Struct, frozen=True):
    """The end of a line that the author asked for."""


class Emphasis(Struct, frozen=True):
    content: Inlines


class Strong(Struct, frozen=True):
    content: Inlines


class Link(Struct, frozen=True):
    """A link to another site; `address` is percent-encoded."""

    address: str
    content: Inlines


class Refer(Struct, frozen=True):
    """A reference to a part of the same handbook; without content it prints the number of the part."""

    name: str
    content: Inlines


class Indexed(Struct, frozen=True):
    """Words that the index lists as `term`; `place` names where they stand, empty without an index."""

    term: str
    content: Inlines
    place: str = ""


Inline = Text | Formula | Code | Break | Emphasis | Strong | Link | Refer | Indexed
Inlines = tuple[Inline, ...]


class Paragraph(Struct, frozen=True):
    content: Inlines


class Heading(Struct, frozen=True):
    """A heading; its level is 1 for a single #."""

    level: int
    content: Inlines


class CodeBlock(Struct, frozen=True):
    lines: tuple[str, ...]


class Quote(Struct, frozen=True):
    content: Blocks


class Listing(Struct, frozen=True):
    """A list; `start` is its first number, or None for bullets. The items of a tight one stand close."""

    start: int | None
    tight: bool
    items: tuple[Blocks, ...]


class Rule(Struct, frozen=True):
    """A line across the page."""


class Grid(Struct, frozen=True):
    """A table written in the text; a `long` one goes on over pages."""

    aligns: tuple[Align | None, ...]
    head: tuple[Inlines, ...]
    rows: tuple[tuple[Inlines, ...], ...]
    long: bool = False


class Term(Struct, frozen=True):
    """What an index lists, with the names of the tables, figures and places where it stands.

    `more` is said behind them where these are only the first.
    """

    words: str
    places: tuple[str, ...]
    more: str = ""


class Index(Struct, frozen=True):
    """An index: letters, each with its terms."""

    groups: tuple[tuple[str, tuple[Term, ...]], ...]


Block = Paragraph | Heading | CodeBlock | Quote | Listing | Rule | Grid | Index
Blocks = tuple[Block, ...]


def references(content: object) -> Iterator[str]:
    """Yield the names that a text, or any part of one, refers to."""
    return (one.name for one in _parts(content) if isinstance(one, Refer))


def terms(content: object) -> Iterator[Indexed]:
    """Yield the words of a text, or of any part of one, that an index lists."""
    return (one for one in _parts(content) if isinstance(one, Indexed))


def _parts(content: object) -> Iterator[object]:
    """Yield a text, or a part of one, and all that is in it."""
    yield content
    if isinstance(content, Struct):
        content = tuple(getattr(content, field) for field in content.__struct_fields__)
    for one in content if isinstance(content, tuple) else ():
        yield from _parts(one)


def with_places(content: Any, names: Iterator[str]) -> Any:
    """Return a text, or a part of one, whose words for the index have places by these names, in order."""
    # A formula is a tuple of another type.
    if type(content) is tuple:
        return tuple(with_places(one, names) for one in content)
    if isinstance(content, Indexed):
        content = replace(content, place=next(names))
    if isinstance(content, Struct):
        fields = {field: getattr(content, field) for field in content.__struct_fields__}
        return replace(content, **{name: with_places(one, names) for name, one in fields.items()})
    return content


def stepwise(blocks: Blocks, above: list[int]) -> Blocks:
    """Return the blocks with each heading one level below the nearest before it that has a lower level.

    A text that begins with ### and goes on with # has two headings of level 1. `above` are the levels, as
    typed, of the headings that hold at the end of the blocks; the next text of a chapter goes on with them.
    """
    return tuple(_stepped(block, above) for block in blocks)


def _stepped(block: Block, above: list[int]) -> Block:
    match block:
        case Heading(level):
            while above and above[-1] >= level:
                above.pop()
            above.append(level)
            return replace(block, level=len(above))
        case Quote(content):
            return Quote(stepwise(content, above))
        case Listing(items=items):
            return replace(block, items=tuple(stepwise(item, above) for item in items))
    return block
