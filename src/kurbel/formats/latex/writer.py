r"""Labels in LaTeX, how it sets a table, and what its templates read. Formulas need amsmath.

TeX, left alone, gives the width that a spanner needs beyond its columns to the last of them, and sets figures
flush under the right edge of a wide heading. A column with space of its own, >{\hspace{..}}, does neither,
and keeps the cells of the source clean.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from itertools import groupby
from typing import Any, NamedTuple

from kurbel.formats.formula import TEX_OBEYED, TexMath, has_bar
from kurbel.formats.page import Page, PageCell, page
from kurbel.formats.writer import PERCENT_DELIMITERS, PLAIN, PageWriter, column_widths, spare_widths
from kurbel.page.formula import GREEK, SIGNS, SYMBOLS, Formula
from kurbel.page.table import HeadCell, Table


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
    | TEX_OBEYED
    | {
        # babel makes " active in German; \textquotedbl is missing in the old default encoding.
        '"': r"\char34{}",
        # After \\ a bracket or a star would be read as its argument.
        "[": "{[}",
        "]": "{]}",
        "*": "{*}",
        "°": r"\textdegree{}",
        "√": r"$\surd$",
    }
)
# Two of these in a row are one sign in TeX fonts: --, ,, '' << >>. Between braces LuaTeX still joins them.
_LIGATURE = re.compile(r"([-,'<>])(?=\1)")


def escape(prose: str) -> str:
    """Return prose of which every character is printed and none obeyed."""
    return _LIGATURE.sub(r"\1\\/", prose.translate(_PROSE))


_STRING = str.maketrans(
    TEX_OBEYED
    | {
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


TYPE_WIDTH = 455.0
"""The width of a page of 16 cm, in points."""
TYPE_HEIGHT = 600.0
# A note is not squeezed into the width of a small table.
NARROWEST = 0.6


class Size(NamedTuple):
    """A type size. `em` is its width in points; small sizes of Computer Modern are cut wider."""

    command: str
    em: float
    leading: float
    tabcolsep: float


SIZES = (
    Size("", 10, 12, 6),
    Size(r"\small", 9.25, 11, 5),
    Size(r"\footnotesize", 8.5, 9.5, 4),
    Size(r"\scriptsize", 8, 8, 2.5),
)


class TexLayout(NamedTuple):
    """How a table is set: the columns, which all panels share, and the size.

    `share` is the width of the table as a part of the line, `tall` tells that it is longer than a page.
    """

    columns: tuple[str, ...]
    size: Size
    share: float
    tall: bool

    @property
    def narrow(self) -> bool:
        return self.share < NARROWEST

    @property
    def note_size(self) -> str:
        """The size of the notes: small, but never above that of the table."""
        return SIZES[-1].command if self.size == SIZES[-1] else r"\footnotesize"

    def spec(self, count: int) -> str:
        """Return the specification of the first columns, equal neighbours written once."""
        runs = [(column, len(list(run))) for column, run in groupby(self.columns[:count])]
        return "".join(f"*{{{times}}}{{{column}}}" if times > 2 else column * times for column, times in runs)


def tex_layout(page: Page, ready: Page) -> TexLayout:
    """Return the layout for a page set as plain text, whose characters are what is measured.

    `ready` is the same page for LaTeX: a line with a high fraction takes the height of two.
    """
    widths = column_widths(page)
    size = next((size for size in SIZES if _points(widths, size) <= TYPE_WIDTH), SIZES[-1])
    return TexLayout(
        columns=tuple("l" if spare is None else _figures(spare) for spare in spare_widths(page, widths)),
        size=size,
        share=min(1.0, round(_points(widths, size) / TYPE_WIDTH, 2)),
        tall=_lines(ready) * size.leading > TYPE_HEIGHT,
    )


def _lines(page: Page) -> int:
    heads = sum(len(panel.spanners) + len(panel.heading_lines) + 2 for panel in page.panels)
    groups = [group for panel in page.panels for group in panel.groups]
    return heads + sum(sum(map(_row_lines, group.rows)) + (3 if group.label else 1) for group in groups)


def _row_lines(row: Sequence[PageCell]) -> int:
    return 2 if any("\\displaystyle" in cell.text for cell in row) else 1


def _points(widths: Sequence[float], size: Size) -> float:
    return sum(widths) * size.em + 2 * len(widths) * size.tabcolsep


def _figures(spare: float) -> str:
    """Return a column whose figures stand in the middle of spare em of room."""
    half = f"{spare / 2:.1f}"
    return "r" if half == "0.0" else f">{{\\hspace{{{half}em}}}}r<{{\\hspace{{{half}em}}}}"


def blank_filled(spanners: Sequence[HeadCell], columns: int) -> list[HeadCell]:
    """Return the cells of a spanner line, with an empty one for each column that has none."""
    line: list[HeadCell] = []
    for cell in [*spanners, HeadCell(("",), "spanner", columns)]:
        reached = line[-1].last + 1 if line else 0
        line += [HeadCell(("",), "heading", place) for place in range(reached, cell.first)]
        line.append(cell)
    return line[:-1]
