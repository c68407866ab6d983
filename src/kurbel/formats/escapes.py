"""Prose and note marks in the notation of each format: every character is printed, none is obeyed.

A new format adds two functions named after it; `Format.escape` and `Format.note_mark` find them by this name,
and `Format.finish` a third, if labels need it.
"""

from __future__ import annotations

import re

from kurbel.page.formula import GREEK, SIGNS, SYMBOLS
from kurbel.page.plain import escape_text as escape_text
from kurbel.page.plain import mark_text as mark_text

_MARKDOWN = re.compile(r"[\\`*_\[\]<>|~$]|&(?=[#A-Za-z])")
# At the start of a line these make a list or a heading.
_MARKDOWN_START = re.compile(r"^( *)([-+=]|#+|[0-9]+(?=[.)](?: |$)))(?=[ .)]|$)")


def escape_markdown(prose: str) -> str:
    escaped = _MARKDOWN.sub(r"\\\g<0>", prose)
    return _MARKDOWN_START.sub(_escape_start, escaped)


def _escape_start(match: re.Match[str]) -> str:
    space, start = match.groups()
    return f"{space}{start}\\" if start.isdigit() else f"{space}\\{start}"


_HTML = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"})


def escape_html(prose: str) -> str:
    return prose.translate(_HTML)


_LATEX = str.maketrans(
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


def escape_latex(prose: str) -> str:
    return _LIGATURE.sub(r"\1\\/", prose.translate(_LATEX))


# Characters that Typst obeys anywhere.
_TYPST = re.compile(r"[\\#$*_@<`~\[\]\"']")
# A hyphen stays before a letter only: with another one, ?, a digit or a space it makes a dash, a break, a
# minus sign or a list. Points make an ellipsis, strokes a comment or, after a colon, a link.
_TYPST_PAIRS = re.compile(r"-(?![^\W\d_])|\.(?=\.)|(?<=\.)\.|/(?=[/*])|(?<=/)/")
# At the start of a line these make a heading, a list or a term.
_TYPST_START = re.compile(r"^( *)([=+/])|^( *[0-9]+)(\.)")


def escape_typst(prose: str) -> str:
    escaped = _TYPST_PAIRS.sub(r"\\\g<0>", _TYPST.sub(r"\\\g<0>", prose))
    return _TYPST_START.sub(r"\1\3\\\2\4", escaped)


_TYPST_STRING = str.maketrans({"\\": r"\\", '"': r"\"", "\n": r"\n"})


def string_typst(text: str) -> str:
    """Return a text as a string of Typst's code, quotation marks included."""
    return f'"{text.translate(_TYPST_STRING)}"'


_LATEX_STRING = str.maketrans(
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


def string_latex(text: str) -> str:
    """Return a text as the strings of a PDF, its bookmarks, take it from LaTeX: nothing but characters."""
    return text.translate(_LATEX_STRING)


def mark_markdown(mark: str, target: str = "") -> str:
    """Return a mark without a link: an anchor in Markdown is HTML, which many readers drop."""
    return escape_markdown(mark_text(mark))


def mark_latex(mark: str, target: str = "") -> str:
    return f"\\textsuperscript{{{escape_latex(mark)})}}"


def mark_html(mark: str, target: str = "") -> str:
    text = f"{escape_html(mark)})"
    return f'<sup><a href="#{escape_html(target)}">{text}</a></sup>' if target else f"<sup>{text}</sup>"


# Browsers break a line between a formula and a sign beside it, whatever the sign.
_BESIDE_FORMULA = re.compile(r"(?<![^\s<>])(?:[^\s<>]*<math.*?</math>)+[^\s<>]*")


def finish_html(label: str) -> str:
    """Return a label that was set, with every formula on one line with the signs that touch it."""
    return _BESIDE_FORMULA.sub(_kept, label)


def _kept(match: re.Match[str]) -> str:
    text = match[0]
    alone = text.startswith("<math") and text.endswith("</math>")
    return text if alone else f'<span class="kept">{text}</span>'


def mark_typst(mark: str, target: str = "") -> str:
    """Return a mark without a link: a document that prints a table twice would not compile with it."""
    return f"#super[{escape_typst(mark)})];"
