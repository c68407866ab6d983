"""Headings of texts one level below each other, as readers that do not see the page demand (PDF/UA)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from kurbel.documents.prose import Block, Blocks, Heading, Listing, Quote


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
