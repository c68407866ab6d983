"""Words in columns: how wide each column may be, and the lines of a text in so much room."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import wrap


def fitted(widths: Sequence[int], least: Sequence[int], room: int) -> list[int] | None:
    """Return widths that have room together; the widest give way first, none below its least.

    None if not even the least widths have room.
    """
    fitting = list(widths)
    for _ in range(sum(widths) - room):
        places = [place for place, width in enumerate(fitting) if width > least[place]]
        if not places:
            return None
        # Of columns alike the last gives way, which is the one with the longest texts.
        fitting[max(places, key=lambda place: (fitting[place], place))] -= 1
    return fitting


def lines_of(text: str, room: int, further: str = "") -> list[str]:
    """Return the lines of a text, of which no word is broken; the second and later ones begin anew."""
    room = max(room, 1)
    return wrap(text, room, subsequent_indent=further, break_on_hyphens=False, break_long_words=False) or [""]


def longest_word(text: str) -> int:
    """Return the least room that a text needs."""
    return max(map(len, text.split(" ")))
