"""Pages with interactive tables, and without: cheap to ask where there are none."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

LIVE = 'class="live-data"'


def of_each_step(page: str, change: Callable[[str], str]) -> str:
    """Return a page that was changed, of an interactive one the table of every step."""
    if LIVE not in page:
        return change(page)
    from kurbel.formats.html.live.block import finished

    return finished(page, change)


def live_in(page: str) -> Any:
    """Return the script and the style of interactive tables if there are any on a page."""
    if LIVE not in page:
        return None
    from kurbel.formats.html.live.block import live

    return live()
