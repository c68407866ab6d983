r"""Labels in LaTeX, how it sets a table, and what its templates read. Formulas need amsmath.

TeX, left alone, gives the width that a spanner needs beyond its columns to the last of them, and sets figures
flush under the right edge of a wide heading. A column with space of its own, >{\hspace{..}}, does neither,
and keeps the cells of the source clean.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import groupby
from typing import Any, NamedTuple

from kurbel.formats.formula import TEX_OBEYED, TexMath, has_bar
from kurbel.formats.page import Page, PageCell, page
from kurbel.formats.spacing import WITHIN
from kurbel.formats.writer import (
    PERCENT_DELIMITERS,
    PLAIN,
    PageWriter,
    Widths,
    Wishes,
    added,
    whole_pairs,
    widths,
)
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

    def formula(self, formula: Formula, mark: str, display: bool = False) -> str:
        r"""Return a formula with its dollar signs: $x/R$, $\frac{1}{4{,}5}\cos\varphi$.

        `display` gives fractions their full size, and the line the height for it.
        """
        content = TexMath(mark, escape).set(formula.content)
        if display and has_bar(formula.content):
            return f"$\\displaystyle {content}\\rule[-1.05em]{{0pt}}{{2.7em}}$"
        return f"${content}$"

    def filters(self) -> Mapping[str, Callable[..., Any]]:
        return {"spanner_lines": spanner_lines}

    def values(self, table: Table, ready: Page, mark: str, wishes: Wishes) -> dict[str, Any]:
        tex = tex_layout(page(table, PLAIN, mark), ready)
        # A float longer than a page would run out of a document that has nothing else on it.
        longtable = wishes.longtable or (wishes.alone and tex.tall)
        values = {"tex": tex, "longtable": longtable, "marker": ""}
        if not wishes.siunitx:
            return values
        from kurbel.formats.latex.siunitx import left_to_siunitx

        return values | left_to_siunitx(table, mark, tex)

    def is_tall(self, table: Table) -> bool:
        return tex_layout(page(table, PLAIN, "."), page(table, self, ".")).tall

    def remarks(self, table: Table) -> Iterator[str]:
        if tex_layout(plain := page(table, PLAIN, "."), plain).wide:
            yield (
                "the table is wider than a line of 16 cm in type of 7 pt; LaTeX turns it, and sets smaller"
                " type where it is higher than a page then"
            )


# \textdegree calls for a font that has bitmaps only where cm-super is not installed.
DEGREE = r"$^\circ$"
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
        # They are other signs in the old default encoding.
        "<": r"\textless{}",
        ">": r"\textgreater{}",
        "|": r"\textbar{}",
        "°": DEGREE,
        "√": r"$\surd$",
    }
)
# Two of these in a row are one sign in TeX fonts: --, ,, '' << >>. Between braces LuaTeX still joins them.
_LIGATURE = re.compile(r"([-,']|\\text(?:less|greater)\{\})(?=\1)")


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


TYPE_WIDTH, TYPE_HEIGHT = 455.0, 600.0
"""A page of 16 cm by 24 cm, less its caption and notes, in points."""
# The least room in which no table needs help, as a column of two has it.
NARROW_LINE = 240.0
# The shortest line for which a table that does not stand turned on it in type of 7 points is made.
SHORT_LINE = 330.0
# The width of an em of small and of the smallest type, and the leading of small type, in points.
SMALL, SMALLEST, LEADING = 9.25, 8.0, 11.0
# Half the gap in a pair of columns, which TeX calls \tabcolsep: whole, and where smaller type is better.
WHOLE, LEAST = WITHIN / 2, 0.3


class TexLayout(NamedTuple):
    """How a table is set.

    `columns` are the columns that all panels share, without the gaps; `stacked` tells that the symbols of
    spanners have a line of their own, `tall` that the table is longer than a page.
    """

    widths: Widths
    columns: tuple[str, ...]
    stacked: bool
    tall: bool

    @property
    def all(self) -> str:
        """The width of all columns in em, with what the estimate may lack."""
        return f"{1.015 * self.widths.all:.2f}"

    @property
    def gaps(self) -> int:
        """The hundreds of \\tabcolsep in all gaps."""
        return max(1, round(100 * added(self.widths.gaps) / WHOLE))

    @property
    def least(self) -> str:
        """The width in em below which gaps and type are too small."""
        return f"{self._least:.2f}"

    @property
    def _least(self) -> float:
        return self.widths.all + added(self.widths.gaps) * LEAST / WHOLE

    @property
    def fits(self) -> bool:
        """Whether it fits every line."""
        return self.widths.natural * SMALL <= NARROW_LINE

    @property
    def turns(self) -> bool:
        """Whether it might have to be turned."""
        return self._least * SMALLEST > SHORT_LINE

    @property
    def wide(self) -> bool:
        """Whether it is wider than a page."""
        return self._least * SMALLEST > TYPE_WIDTH

    def is_raw(self, place: int) -> bool:
        """Whether the numbers of a column are left to siunitx."""
        return self.columns[place].startswith("S")

    def spec(self, count: int) -> str:
        """Return the specification of the first columns, equal neighbours written once."""
        columns = [column + self._behind(place, count) for place, column in enumerate(self.columns[:count])]
        runs = [(column, len(list(run))) for column, run in groupby(columns)]
        return self._before(0) + "".join(
            f"*{{{times}}}{{{column}}}" if times > 2 else column * times for column, times in runs
        )

    def head(self, cell: HeadCell, align: str, count: int) -> str:
        """Return the specification of a cell of the head."""
        return self._before(cell.first) + align + self._behind(cell.last, count)

    def heading(self, place: int, align: str, count: int) -> str:
        """Return the specification of a heading of one column."""
        return self.head(HeadCell((), "heading", place), align, count)

    def trims(self, cell: HeadCell, count: int) -> str:
        """Return what a rule below a spanner leaves free of the gaps on both sides."""
        left, right = self.widths.left, ""
        if cell.last < count - 1:
            right = _trim("r", 1 + self._more(cell.last), left[cell.last + 1])
        return (_trim("l", 1, -left[cell.first]) if cell.first else "") + right

    def spanner(self, cell: HeadCell) -> str:
        """Return the text of a spanner; one that hangs over does not widen the columns below it."""
        over = self.widths.left[cell.first] + self.widths.right[cell.last]
        return f"\\makebox[0pt]{{{cell.text}}}" if over else cell.text

    def _before(self, place: int) -> str:
        return "" if place else f"@{{{_space(0, self.widths.left[0])}}}"

    def _behind(self, place: int, count: int) -> str:
        if place == count - 1:
            return f"@{{{_space(0, self.widths.right[place])}}}"
        space = _space(self._more(place), self.widths.right[place] + self.widths.left[place + 1])
        return space and f"!{{{space}}}"

    def _more(self, place: int) -> float:
        """Return how many \\tabcolsep the gap behind a column has beyond the two that TeX sets."""
        return round(self.widths.gaps[place + 1] / WHOLE - 2, 2)


def tex_layout(page: Page, ready: Page) -> TexLayout:
    """Return the layout for a page set as plain text, whose characters are what is measured.

    `ready` is the same page for LaTeX: a line with a high fraction takes the height of two. A spanner has its
    symbol beside it where the page is wide enough.
    """
    room = widths(page, False)
    stacked = room.natural * SMALL > TYPE_WIDTH
    if stacked:
        room = widths(page, True)
    words = {
        place for panel in page.panels for place, column in enumerate(panel.columns) if column.align == "left"
    }
    return TexLayout(
        widths=whole_pairs(page, room),
        columns=tuple(
            "l" if place in words else _figures(whole - own)
            for place, (whole, own) in enumerate(zip(room.columns, room.cells, strict=True))
        ),
        stacked=stacked,
        tall=_lines(ready) * LEADING > TYPE_HEIGHT,
    )


def _lines(page: Page) -> float:
    heads = sum(2 * len(panel.spanners) + len(panel.heading_lines) + 1 for panel in page.panels)
    groups = [group for panel in page.panels for group in panel.groups]
    return heads + sum(
        sum(map(_row_lines, group.rows)) + (2 if group.label else 1) + 0.4 * len(group.pauses)
        for group in groups
    )


def _row_lines(row: Sequence[PageCell]) -> int:
    return 2 if any("\\displaystyle" in cell.text for cell in row) else 1


def _trim(side: str, times: float, em: float) -> str:
    """Return how much a rule is shorter on a side, of which the usual is one \\tabcolsep."""
    if abs(em) < 0.005:
        return side if times == 1 else f"{side}{{{times:g}\\tabcolsep}}"
    return f"{side}{{\\dimexpr{times:g}\\tabcolsep{em:+.2f}em\\relax}}"


def _space(times: float, em: float) -> str:
    """Return a space of so many \\tabcolsep and em, nothing for none."""
    fixed, gap = f"{em:.2f}em", f"{times:g}\\tabcolsep"
    if em < 0.005:
        return f"\\hspace{{{gap}}}" if times else ""
    return f"\\hspace{{\\dimexpr{gap}+{fixed}\\relax}}" if times else f"\\hspace{{{fixed}}}"


def _figures(spare: float) -> str:
    """Return a column whose figures stand in the middle of spare em of room."""
    half = f"{spare / 2:.2f}"
    return "r" if spare < 0.1 else f">{{\\hspace{{{half}em}}}}r<{{\\hspace{{{half}em}}}}"


def spanner_lines(spanners: Sequence[HeadCell], columns: int, stacked: bool) -> Iterator[list[HeadCell]]:
    """Yield the lines of a row of spanners, with an empty cell for each column that has none."""
    count = max(len(cell.lines) for cell in spanners) if stacked else 1
    for line in range(count):
        yield _blank_filled(
            [
                cell._replace(lines=cell.lines[line : line + 1] if stacked else (cell.text,))
                for cell in spanners
            ],
            columns,
        )


def _blank_filled(spanners: Sequence[HeadCell], columns: int) -> list[HeadCell]:
    line: list[HeadCell] = []
    for cell in [*spanners, HeadCell(("",), "spanner", columns)]:
        reached = line[-1].last + 1 if line else 0
        line += [HeadCell(("",), "heading", place) for place in range(reached, cell.first)]
        line.append(cell)
    return line[:-1]
