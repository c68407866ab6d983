"""Prose, strings and marks of labels in LaTeX."""

from __future__ import annotations

import re

from kurbel.page.formula import GREEK, SIGNS, SYMBOLS

_PROSE = str.maketrans(
    {letter: f"${command}$" for letter, command in GREEK.items()}
    | {symbol: f"${latex}$" for symbol, (_, latex) in (SIGNS | SYMBOLS).items() if not symbol.isascii()}
    | {character: f"\\{character}" for character in "#$%&_{}"}
    | {
        "\\": r"\textbackslash{}",
        "~": r"\textasciitilde{}",
        "^": r"\textasciicircum{}",
        "`": r"\textasciigrave{}",
        # babel makes " active in German; \textquotedbl is missing in the old default encoding.
        '"': r"\char34{}",
        # After \\ a bracket or a star would be read as its argument.
        "[": "{[}",
        "]": "{]}",
        "*": "{*}",
        "°": r"\textdegree{}",
    }
)
# Two of these in a row are one sign in TeX fonts: --, ,, '' << >>. Between braces LuaTeX still joins them.
_LIGATURE = re.compile(r"([-,'<>])(?=\1)")


def escape(prose: str) -> str:
    """Return prose of which every character is printed and none obeyed."""
    return _LIGATURE.sub(r"\1\\/", prose.translate(_PROSE))


_STRING = str.maketrans(
    {character: f"\\{character}" for character in "#$%&_{}"}
    | {
        "\\": r"\textbackslash{}",
        "~": r"\textasciitilde{}",
        "^": r"\textasciicircum{}",
        "`": r"\textasciigrave{}",
        '"': r"\textquotedbl{}",
        "'": r"\textquotesingle{}",
        # Two of them would be one sign.
        "-": "-{}",
        ",": ",{}",
        "<": "<{}",
        ">": ">{}",
    }
)


def string(text: str) -> str:
    """Return a text as the strings of a PDF, its bookmarks, take it from LaTeX: nothing but characters."""
    return text.translate(_STRING)


def note_mark(mark: str) -> str:
    """Return a raised mark without a link."""
    return f"\\textsuperscript{{{escape(mark)})}}"
