"""The date that the environment sets for what is made: SOURCE_DATE_EPOCH."""

from __future__ import annotations

import os

from kurbel.errors import NotationError

EPOCH = "SOURCE_DATE_EPOCH"
# The last second of the year 9999, with which dates in a PDF end.
LAST = 253402300799


def source_date_epoch() -> int | None:
    """Return the date that the environment sets for what is made, in seconds since 1970, if it does."""
    text = os.environ.get(EPOCH, "")
    if not text:
        return None
    if not (text.isascii() and text.isdigit() and int(text[:20]) <= LAST):
        raise NotationError(
            f'{EPOCH} is "{text[:40]}"; it must be a number of seconds from 1970 up to the year 9999'
        )
    return int(text)
