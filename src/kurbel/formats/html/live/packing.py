"""Many pages that are nearly alike, kept short: what they have in common once, and of each what is its own.

Nothing is lost: each page comes out as it was, letter by letter.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

# Where pages are cut, and lines of words.
TAG, SPACE = re.compile(r"(<[^>]*>)"), re.compile(r"( )")
# The first of these that no text has parts texts in one string.
_SEPARATORS = ("|", "~", "^", "¦", "\t")


def packed(pages: Sequence[str], cut: re.Pattern[str] = TAG) -> dict[str, Any]:
    """Return the pages for JSON; pieces of them begin and end where they are `cut`.

    In `shapes` texts and numbers of gaps alternate; every page has one, of a kind, and a text of what stands
    in its gaps, joined by `by`.
    """
    tokens = [cut.split(page) for page in pages]
    separator = separator_of(token for page in tokens for token in page)
    lengths = list(dict.fromkeys(map(len, tokens)))
    shapes, texts = [], [""] * len(pages)
    for length in lengths:
        alike = [number for number, page in enumerate(tokens) if len(page) == length]
        shape, own = _shaped([tokens[number] for number in alike])
        shapes.append(shape)
        for number, values in zip(alike, own, strict=True):
            texts[number] = separator.join(values)
    kinds = [lengths.index(len(page)) for page in tokens]
    return {"by": separator, "shapes": shapes, "kinds": kinds, "texts": texts}


def _shaped(pages: Sequence[Sequence[str]]) -> tuple[list[str | int], list[list[str]]]:
    """Return what pages of as many pieces have in common, with gaps, and of each what fills these.

    Pieces that are alike on every page, as of a table that stands there twice, share a gap.
    """
    shape: list[str | int] = []
    gaps: dict[tuple[str, ...], int] = {}
    for pieces in zip(*pages, strict=True):
        if len(set(pieces)) > 1:
            shape.append(gaps.setdefault(pieces, len(gaps)))
        elif shape and isinstance(shape[-1], str):
            shape[-1] += pieces[0]
        else:
            shape.append(pieces[0])
    return shape, [list(own) for own in zip(*gaps, strict=True)] or [[] for _ in pages]


def unpacked(data: Mapping[str, Any]) -> list[str]:
    """Return the pages of which these are the data."""
    pages = []
    for kind, text in zip(data["kinds"], data["texts"], strict=True):
        own = text.split(data["by"])
        pages.append(
            "".join(own[piece] if isinstance(piece, int) else piece for piece in data["shapes"][kind])
        )
    return pages


def separator_of(texts: Iterable[str]) -> str:
    """Return what parts these texts in one string."""
    letters = set("".join(texts))
    return next(one for one in (*_SEPARATORS, *map(chr, range(0xE000, 0xF8FF))) if one not in letters)
