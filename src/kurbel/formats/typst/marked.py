"""Marked places in Typst, and the code in which they are only shown."""

from __future__ import annotations

import re

from kurbel.documents.inject import Code, Kind, without_raw

_SIGN = re.compile(rb"`+|/\*|\*/|(?<!:)//")


class TypstCode(Code):
    """Raw text between backticks, and comments between /* and */, which may be nested."""

    def __init__(self) -> None:
        self.ticks = 0
        self.depth = 0

    def holds(self, line: bytes) -> bool:
        held = bool(self.ticks or self.depth)
        for match in _SIGN.finditer(line):
            sign = match[0]
            if sign.startswith(b"`"):
                self._raw(len(sign))
            elif self.ticks:
                continue
            elif sign == b"//":
                if not self.depth:
                    break
            elif sign == b"/*":
                self.depth += 1
            elif self.depth:
                self.depth -= 1
        return held

    def _raw(self, ticks: int) -> None:
        if self.depth:
            return
        if not self.ticks:
            # Two are an empty text, three and more begin a block.
            self.ticks = 0 if ticks == 2 else ticks
        elif ticks >= self.ticks:
            self.ticks = 0

    def without_inline(self, line: bytes) -> bytes:
        return without_raw(line)


KIND = Kind(
    name="Typst",
    suffixes=(".typ",),
    left="//",
    right="",
    # Two slashes behind a colon are those of an address.
    comment=re.compile(rb"\A(?:(?!(?<!:)//).)*(?<!:)//[ \t]*(?:kurbel:|/kurbel\b)", re.DOTALL),
    code=TypstCode,
)
