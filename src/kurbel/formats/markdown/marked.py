"""Marked places in Markdown, and the code in which they are only shown."""

from __future__ import annotations

import re

from kurbel.documents.inject import MARKUP_COMMENT, Code, Kind, without_raw

_FENCE = re.compile(rb"(`{3,})[^`]*\Z|(~{3,})", re.DOTALL)
_ITEM = re.compile(rb"(?:[-*+]|[0-9]{1,9}[.)])(?: +|\Z)")
# What ends a paragraph that otherwise goes on, however its lines are indented.
_BEGINNING = re.compile(rb"[<>#]|```|~~~|" + _ITEM.pattern)
_QUOTE = re.compile(rb"(?: {0,3}>)+ ?")

# No block of code, item or quotation begins with one of these; most lines of a text do.
_PLAIN = frozenset(range(256)) - frozenset(b" \t\r\n\f\v>-*+0123456789`~")


class MarkdownCode(Code):
    """Fenced and indented code, also in items of lists and in quotations.

    Source: CommonMark 0.31, sections 4.4, 4.5, 5.1 and 5.2.
    """

    def __init__(self) -> None:
        self.fence = b""
        self.of_fence = 0
        # Where the texts of the open items begin, outermost first.
        self.items: list[int] = []
        self.quoted = False
        # The items that a quotation is in.
        self.outside: list[int] = []
        self.after_blank = True
        # Whether the last line began an item and has nothing else.
        self.bare = False

    def holds(self, line: bytes) -> bool:
        if line[0] in b"\r\n" and not self.quoted:
            return self._blank()
        if line[0] in _PLAIN and not (self.fence or self.items or self.quoted):
            self.after_blank = False
            return False
        # In a fence that is not of a quotation > is a letter like others.
        quote = None if self.fence and not self.quoted else _QUOTE.match(line)
        if bool(quote) != self.quoted:
            self._quote(line)
        text = line[quote.end() if quote else 0 :].rstrip().expandtabs(4)
        if not text:
            return self._blank()
        stripped = text.lstrip(b" ")
        indent = len(text) - len(stripped)
        if self.fence and indent >= self.of_fence:
            self._close(indent, stripped)
            return True
        if self.fence:
            # Its item has ended, and no paragraph goes on.
            self.fence, self.after_blank = b"", True
        return self._block(indent, stripped)

    def _blank(self) -> bool:
        if self.bare:
            self.items.pop()
        self.after_blank, self.bare = True, False
        return bool(self.fence)

    def _quote(self, line: bytes) -> None:
        """Begin or end a quotation, which has items of its own and ends with all that is in it."""
        self.quoted = not self.quoted
        if self.quoted:
            lead = len(line) - len(line.lstrip(b" "))
            self.outside, self.items = [item for item in self.items if item <= lead], []
        else:
            self.items, self.fence = self.outside, b""
        self.bare = False

    def _close(self, indent: int, stripped: bytes) -> None:
        # At least as many of the same sign, and nothing behind them.
        ends = stripped.startswith(self.fence) and not stripped.strip(self.fence[:1])
        if ends and indent - self.of_fence < 4:
            self.fence = b""
            self.after_blank = True

    def _block(self, indent: int, stripped: bytes) -> bool:
        self.bare = False
        home = [item for item in self.items if item <= indent]
        if indent - (home[-1] if home else 0) >= 4:
            # Without a blank line before it, it goes on with a paragraph; no table can stand there.
            return True
        if self.after_blank or _BEGINNING.match(stripped):
            self.items = home
        while (item := _ITEM.match(stripped)) and indent - self._base() < 4:
            width = item.end() if stripped[item.end() :] else len(item[0].rstrip()) + 1
            if width - len(item[0].rstrip()) > 4:
                width = len(item[0].rstrip()) + 1
            self.items.append(indent + width)
            indent, stripped = indent + item.end(), stripped[item.end() :]
            self.bare = not stripped
        self.after_blank = False
        if fence := _FENCE.match(stripped):
            self.fence = fence[1] or fence[2]
            self.of_fence = self._base()
        return bool(self.fence)

    def _base(self) -> int:
        return self.items[-1] if self.items else 0

    def without_inline(self, line: bytes) -> bytes:
        return without_raw(line)


KIND = Kind(
    name="Markdown",
    suffixes=(".md", ".markdown", ".qmd", ".rmd"),
    left="<!--",
    right="-->",
    comment=MARKUP_COMMENT,
    code=MarkdownCode,
    apart=True,
    labelled=False,
)
