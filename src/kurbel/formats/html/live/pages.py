"""Pages with interactive tables, and without: cheap to ask where there are none."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

LIVE, FILM = 'class="live-data"', 'class="film-data"'
# What the file of a drawing that moves says of its run.
RUNS = 'data-film="'


def of_each_step(page: str, change: Callable[[str], str]) -> str:
    """Return a page that was changed, of an interactive one the table of every step."""
    if LIVE not in page:
        return change(page)
    from kurbel.formats.html.live.block import finished

    return finished(page, change)


def live_of(fragments: Iterable[str]) -> Any:
    """Return the same of a page that is made of these tables and of files of drawings."""
    texts = [*fragments]
    found = [mark for mark, begun in ((LIVE, LIVE), (FILM, RUNS)) if any(begun in one for one in texts)]
    return live_in(" ".join(found))


def live_in(page: str) -> Any:
    """Return the script and the style of interactive tables and of drawings that move if there are any on a
    page."""
    kinds = tuple(name for name, mark in (("live", LIVE), ("film", FILM)) if mark in page)
    if not kinds:
        return None
    from kurbel.formats.html.live.block import live

    return live(kinds)
