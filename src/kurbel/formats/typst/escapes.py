"""Prose, strings and marks of labels in Typst."""

from __future__ import annotations

import re

# Characters that Typst obeys anywhere.
_ANYWHERE = re.compile(r"[\\#$*_@<`~\[\]\"']")
# A hyphen stays before a letter only: with another one, ?, a digit or a space it makes a dash, a break, a
# minus sign or a list. Points make an ellipsis, strokes a comment or, after a colon, a link.
_PAIRS = re.compile(r"-(?![^\W\d_])|\.(?=\.)|(?<=\.)\.|/(?=[/*])|(?<=/)/")
# At the start of a line these make a heading, a list or a term.
_START = re.compile(r"^( *)([=+/])|^( *[0-9]+)(\.)")


def escape(prose: str) -> str:
    """Return prose of which every character is printed and none obeyed."""
    escaped = _PAIRS.sub(r"\\\g<0>", _ANYWHERE.sub(r"\\\g<0>", prose))
    return _START.sub(r"\1\3\\\2\4", escaped)


_STRING = str.maketrans({"\\": r"\\", '"': r"\"", "\n": r"\n"})


def string(text: str) -> str:
    """Return a text as a string of Typst's code, quotation marks included."""
    return f'"{text.translate(_STRING)}"'


def note_mark(mark: str) -> str:
    """Return a mark without a link: a document that prints a table twice would not compile with it."""
    return f"#super[{escape(mark)})];"
