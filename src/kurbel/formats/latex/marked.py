"""Marked places in LaTeX, and the code in which they are only shown."""

from __future__ import annotations

import re

from kurbel.documents.inject import Code, Kind

_LITERAL = rb"verbatim|[BL]?Verbatim|lstlisting|minted|comment|alltt|filecontents"
_BEGIN = re.compile(rb"\\begin[ \t]*\{((?:" + _LITERAL + rb")\*?)\}")
_VERB = re.compile(rb"\\(?:verb\*?|lstinline(?:\[[^]\n]*\])?)([^A-Za-z\s*])(?:(?!\1).)*\1")
_TEX_TEXT = re.compile(rb"(?:[^\\%]|\\.)*", re.DOTALL)


class LatexCode(Code):
    """Verbatim environments of LaTeX, fancyvrb, listings, minted and verbatim."""

    def __init__(self) -> None:
        self.end = b""

    def holds(self, line: bytes) -> bool:
        if self.end:
            if self.end in line:
                self.end = b""
            return True
        if b"\\begin" not in line:
            return False
        text = _TEX_TEXT.match(self.without_inline(line))
        assert text
        for begin in _BEGIN.finditer(text[0]):
            end = b"\\end{" + begin[1] + b"}"
            if end not in line[line.rfind(begin[0]) :]:
                self.end = end
        return bool(self.end)

    def without_inline(self, line: bytes) -> bytes:
        return _VERB.sub(b"", line) if b"\\verb" in line or b"\\lstinline" in line else line


KIND = Kind(
    name="LaTeX",
    suffixes=(".tex", ".ltx"),
    left="%",
    right="",
    # The first percent sign that no backslash makes a sign begins the comment.
    comment=re.compile(rb"\A(?:[^\\%]|\\.)*%[ \t]*(?:kurbel:|/kurbel\b)", re.DOTALL),
    code=LatexCode,
)
