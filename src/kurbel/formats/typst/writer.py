"""Labels in Typst, and what its templates read."""

from __future__ import annotations

import re
import unicodedata
from typing import Any

from kurbel.formats.formula import has_bar, has_stroke, is_seen
from kurbel.formats.page import Page
from kurbel.formats.typst.layout import string, typst_layout
from kurbel.formats.writer import PERCENT_DELIMITERS, PageWriter, Wishes
from kurbel.page import formula as tree
from kurbel.page.formula import Formula
from kurbel.page.labels import formula_plain
from kurbel.page.table import Table


class Writer(PageWriter):
    # Typst has hash signs, braces and dollar signs, but no percent signs.
    delimiters = PERCENT_DELIMITERS

    def escape(self, prose: str) -> str:
        return escape(prose)

    def note_mark(self, mark: str, target: str = "") -> str:
        """Return a mark without a link: a document that prints a table twice would not compile with it."""
        return f"#super[{escape(mark)})];"

    def formula(self, formula: Formula, mark: str, display: bool = False) -> str:
        """Return a formula with a text for readers that do not see it, which PDF/UA asks for.

        `display` gives fractions their full size, and the line the height for it.
        """
        content = _typst(formula.content, mark)
        alternative = string(formula_plain(formula, mark))
        if display and has_bar(formula.content):
            # The empty box is as high above the middle of the digits beside it as it is deep below.
            content = f"display({content})#box(height: 2.9em, baseline: 1.12em)"
        return f"#math.equation(alt: {alternative}, ${content}$);"

    def values(self, table: Table, ready: Page, mark: str, wishes: Wishes) -> dict[str, Any]:
        return {"typst": typst_layout(table, mark, ready)}


# Characters that Typst obeys anywhere.
_ANYWHERE = re.compile(r"[\\#$*_@<`~\[\]\"']")
# A hyphen stays before a letter only: with another one, ?, a digit or a space it makes a dash, a break, a
# minus sign or a list. Points make an ellipsis, strokes a comment or, after a colon, a link.
_PAIRS = re.compile(r"-(?=(.?))|\.(?=\.)|(?<=\.)\.|/(?=[/*])|(?<=/)/", re.DOTALL)
_APOSTROPHE = re.compile(r"(?<=[^\W\d_])'(?=[^\W\d_])")
# At the start of a line these make a heading, a list or a term.
_START = re.compile(r"^( *)([=+/])|^( *[0-9]+)(\.)")


def _paired(sign: re.Match[str]) -> str:
    # A fraction or a Roman numeral of one character is a number too.
    beside = sign.group(1)
    return sign.group() if beside and unicodedata.category(beside).startswith("L") else f"\\{sign.group()}"


def escape(prose: str) -> str:
    """Return prose of which every character is printed and none obeyed.

    An apostrophe between letters is that of print, as a TeX sets it.
    """
    escaped = _PAIRS.sub(_paired, _ANYWHERE.sub(r"\\\g<0>", _APOSTROPHE.sub("’", prose)))
    return _START.sub(r"\1\3\\\2\4", escaped)


# Beside these nothing runs together; a space beside quotation marks would be printed.
_TYPST_CLOSED = frozenset('()[]"')


def _typst(nodes: tree.Nodes, mark: str) -> str:
    result = ""
    for place in range(len(nodes)):
        piece = _typst_node(nodes, place, mark)
        result += " " * _would_join(result[-1:], piece[:1]) + piece
    return result


def _would_join(before: str, after: str) -> bool:
    """Tell whether two characters would be read as one word or, as -> is, one sign."""
    if not before or not after or {before, after} & _TYPST_CLOSED:
        return False
    return _in_word(before) == _in_word(after)


def _in_word(character: str) -> bool:
    """Tell whether Typst reads a character behind a letter as part of the word, as it does with a · too."""
    return f"x{character}".isidentifier()


def _typst_node(nodes: tree.Nodes, place: int, mark: str) -> str:
    node = nodes[place]
    match node:
        case tree.Word(text) | tree.Variable(text):
            return text
        case tree.Numeral(text):
            # A comma in quotes, for else it is set with the space of a list.
            return text.replace(".", '","' if mark == "," else mark)
        case tree.Sign(":"):
            return '":"'
        case tree.Sign(text):
            return tree.SIGNS[text][0]
        case tree.Symbol(text):
            return f'"{tree.SYMBOLS[text][0]}"'
        case tree.Upright(text):
            return string(text)
        case tree.Space():
            return "thin" * is_seen(nodes, place)
        case tree.Group(content, fences):
            return f"{fences[0]}{_typst(content, mark)}{fences[1]}"
        case tree.Root(content):
            return f"sqrt({_typst(content, mark)})"
        case tree.Overline(content):
            return f"overline({_typst(content, mark)})"
        case tree.Fraction(top, bottom) if has_stroke(nodes, place):
            below = _typst(bottom if len(bottom) == 1 else (tree.Group(bottom),), mark)
            return f"{_typst(top, mark)}\\/{below}"
        case tree.Fraction(top, bottom):
            return f"frac({_typst(top, mark)}, {_typst(bottom, mark)})"
        case tree.Script(base, index, power):
            below = f"_({_typst(index, mark)})" if index else ""
            above = f"^({_typst(power, mark)})" if power else ""
            return _typst((base,), mark) + below + above
