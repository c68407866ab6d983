"""What of a document is code, in which markers are only shown: what all kinds of documents share."""

from __future__ import annotations

import re
from typing import Protocol

_RUN = re.compile(rb"`+")


class Code(Protocol):
    """Goes through a document line by line."""

    def holds(self, line: bytes) -> bool:
        """Whether the line, the next one of the document, is of a block of code."""

    def without_inline(self, line: bytes) -> bytes:
        """Return the line without the code in it."""


class NoCode:
    """A kind of document that shows markers only with other letters, as HTML does."""

    def holds(self, line: bytes) -> bool:
        return False

    def without_inline(self, line: bytes) -> bytes:
        return line


def without_raw(line: bytes) -> bytes:
    """Return a line without what stands between equal runs of backticks."""
    runs = [(run.start(), run.end()) for run in _RUN.finditer(line)]
    last_of_length = {end - start: place for place, (start, end) in enumerate(runs)}
    pieces, done, place = [], 0, 0
    while place < len(runs):
        start, end = runs[place]
        place += 1
        if last_of_length[end - start] < place:
            continue
        while runs[place][1] - runs[place][0] != end - start:
            place += 1
        pieces.append(line[done:start])
        done = runs[place][1]
        place += 1
    return b"".join((*pieces, line[done:]))
