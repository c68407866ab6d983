"""Labels in LaTeX, and what its templates read. Formulas need amsmath."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from kurbel.formats.formula import TexMath, has_bar
from kurbel.formats.latex.layout import blank_filled, tex_layout
from kurbel.formats.page import Page, page
from kurbel.formats.writer import PERCENT_DELIMITERS, PLAIN, PageWriter
from kurbel.page.formula import GREEK, SIGNS, SYMBOLS, Formula
from kurbel.page.table import Table


class Writer(PageWriter):
    minus = "$-$"
    missing = "--"
    # LaTeX is full of braces and percent signs.
    delimiters = PERCENT_DELIMITERS

    def escape(self, prose: str) -> str:
        return escape(prose)

    def note_mark(self, mark: str, target: str = "") -> str:
        """Return a raised mark without a link."""
        return f"\\textsuperscript{{{escape(mark)})}}"

    def formula(self, formula: Formula, mark: str = ".", display: bool = False) -> str:
        r"""Return a formula with its dollar signs: $x/R$, $\frac{1}{4{,}5}\cos\varphi$.

        `display` gives fractions their full size, and the line the height for it.
        """
        content = TexMath(mark, escape).set(formula.content)
        if display and has_bar(formula.content):
            return f"$\\displaystyle {content}\\rule[-1.05em]{{0pt}}{{2.7em}}$"
        return f"${content}$"

    def filters(self) -> Mapping[str, Callable[..., Any]]:
        return {"blank_filled": blank_filled}

    def values(self, table: Table, ready: Page, mark: str, longtable: bool, alone: bool) -> dict[str, Any]:
        tex = tex_layout(page(table, PLAIN, mark), ready)
        # A float longer than a page would run out of a document that has nothing else on it.
        return {"tex": tex, "longtable": longtable or (alone and tex.tall)}

    def is_tall(self, table: Table) -> bool:
        return tex_layout(page(table, PLAIN, "."), page(table, self, ".")).tall


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
