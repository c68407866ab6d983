"""Free text as a small tree of blocks and inlines."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Literal

from kurbel.page.formula import Formula

Align = Literal["left", "center", "right"]


@dataclass(frozen=True, slots=True)
class Text:
    text: str


@dataclass(frozen=True, slots=True)
class Code:
    """Characters of a program or a command line."""

    text: str


@dataclass(frozen=True, slots=True)
class Break:
    """The end of a line that the author asked for."""


@dataclass(frozen=True, slots=True)
class Emphasis:
    content: Inlines


@dataclass(frozen=True, slots=True)
class Strong:
    content: Inlines


@dataclass(frozen=True, slots=True)
class Link:
    """A link to another site; `address` is percent-encoded."""

    address: str
    content: Inlines


@dataclass(frozen=True, slots=True)
class Refer:
    """A reference to a part of the same handbook; without content it prints the number of the part."""

    name: str
    content: Inlines


Inline = Text | Formula | Code | Break | Emphasis | Strong | Link | Refer
Inlines = tuple[Inline, ...]


@dataclass(frozen=True, slots=True)
class Paragraph:
    content: Inlines


@dataclass(frozen=True, slots=True)
class Heading:
    """A heading; its level is 1 for a single #."""

    level: int
    content: Inlines


@dataclass(frozen=True, slots=True)
class CodeBlock:
    lines: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Quote:
    content: Blocks


@dataclass(frozen=True, slots=True)
class Listing:
    """A list; `start` is its first number, or None for bullets. The items of a tight one stand close."""

    start: int | None
    tight: bool
    items: tuple[Blocks, ...]


@dataclass(frozen=True, slots=True)
class Rule:
    """A line across the page."""


@dataclass(frozen=True, slots=True)
class Grid:
    """A table written in the text."""

    aligns: tuple[Align | None, ...]
    head: tuple[Inlines, ...]
    rows: tuple[tuple[Inlines, ...], ...]


Block = Paragraph | Heading | CodeBlock | Quote | Listing | Rule | Grid
Blocks = tuple[Block, ...]


def references(content: object) -> Iterator[str]:
    """Yield the names that a text, or any part of one, refers to."""
    if isinstance(content, Refer):
        yield content.name
    if isinstance(content, tuple):
        for one in content:
            yield from references(one)
    elif is_dataclass(content) and not isinstance(content, type):
        for field in fields(content):
            yield from references(getattr(content, field.name))


def stepwise(blocks: Blocks, above: list[int]) -> Blocks:
    """Return the blocks with each heading one level below the nearest before it that has a lower level.

    A text that begins with ### and goes on with # has two headings of level 1. `above` are the levels, as
    typed, of the headings that hold at the end of the blocks; the next text of a chapter goes on with them.
    """
    return tuple(_stepwise(blocks, above))


def _stepwise(blocks: Blocks, above: list[int]) -> Iterator[Block]:
    for block in blocks:
        match block:
            case Heading(level):
                while above and above[-1] >= level:
                    above.pop()
                above.append(level)
                yield replace(block, level=len(above))
            case Quote(content):
                yield replace(block, content=stepwise(content, above))
            case Listing(items=items):
                yield replace(block, items=tuple(stepwise(item, above) for item in items))
            case _:
                yield block
