r"""Labels in LaTeX, how it sets a table, and what its templates read. Formulas need amsmath.

TeX, left alone, gives the width that a spanner needs beyond its columns to the last of them, and sets figures
flush under the right edge of a wide heading. A column with space of its own, >{\hspace{..}}, does neither,
and keeps the cells of the source clean.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import groupby
from typing import NamedTuple, Self

from kurbel.formats.formula import TEX_OBEYED, TexMath, has_bar
from kurbel.formats.page import Page, PageCell, PagePanel, page
from kurbel.formats.spacing import WITHIN, added, bodies, em, headings, overhangs, spans, widest
from kurbel.formats.writer import PERCENT_DELIMITERS, PLAIN, PageWriter, WriteOptions
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

    def filters(self) -> Mapping[str, Callable[..., object]]:
        return {"spanner_lines": spanner_lines}

    def values(self, table: Table, ready: Page, mark: str, wishes: WriteOptions) -> dict[str, object]:
        writer = PlainWriter() if wishes.plain else self
        if wishes.plain:
            ready = page(table, writer, mark)
        plain = page(table, PLAIN, mark)
        tex = (PlainLayout if wishes.plain else TexLayout).of(plain, ready)
        values = {
            "page": ready,
            "tex": tex,
            "plain": wishes.plain,
            "longtable": wishes.longtable or tex.endless or (tex.tall and wishes.place == "document"),
            "marker": "",
        }
        if not wishes.siunitx:
            return values
        return values | left_to_siunitx(table, mark, tex, writer)

    def is_tall(self, table: Table) -> bool:
        return TexLayout.of(page(table, PLAIN, "."), page(table, self, ".")).tall

    def remarks(self, table: Table) -> Iterator[str]:
        if TexLayout.of(plain := page(table, PLAIN, "."), plain).wide:
            yield "the table is wider than a line of 16 cm in type of 7 pt; LaTeX turns it"


class PlainWriter(Writer):
    """For pages as a careful author types them."""

    def formula(self, formula: Formula, mark: str, display: bool = False) -> str:
        """Return a formula whose fractions make room for themselves."""
        content = TexMath(mark, escape).set(formula.content)
        return f"$\\displaystyle {content}$" if display and has_bar(formula.content) else f"${content}$"


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


TYPE_WIDTH, TYPE_HEIGHT = 455.0, 683.0
"""A page of 16 cm by 24 cm, in points."""
# The shortest line for which a table that does not stand turned on it in type of 7 points is made.
SHORT_LINE = 330.0
# The width of an em of small and of the smallest type, and the leading of the latter, in points.
SMALL, SMALLEST, LEADING = 9.25, 8.0, 8.0
# TeX counts no higher than some thirty pages, and keeps fewer floats that wait.
MOST_FLOATS = 10
# Half the gap in a pair of columns, which TeX calls \tabcolsep: whole, and where smaller type is better.
WHOLE, LEAST = WITHIN / 2, 0.3


# A spanner has room as if the gaps below it were half of what they can be.
TIGHT = 0.5


class Widths(NamedTuple):
    """The columns of all panels: their widths, those of their cells alone, the gaps before them, and by how
    much spanners that are wider than what is below them hang over on the left and on the right."""

    columns: Sequence[float]
    cells: Sequence[float]
    gaps: Sequence[float]
    left: Sequence[float]
    right: Sequence[float]

    @property
    def all(self) -> float:
        """The width of all columns without the gaps."""
        return added(self.columns) + added(self.left) + added(self.right)

    @property
    def natural(self) -> float:
        """The width with whole gaps."""
        return self.all + added(self.gaps)


def widths(page: Page, stacked: bool) -> Widths:
    """Return the widths of a page that is set as plain text.

    `stacked` tells that the symbols of spanners stand below their names.
    """
    return Widths(*map(widest, zip(*(_widths(panel, stacked) for panel in page.panels), strict=True)))


def _widths(panel: PagePanel, stacked: bool) -> Widths:
    cells = bodies(panel, em)
    columns, gaps = widest((cells, headings(panel, em))), [column.gap for column in panel.columns]
    above = spans(panel, lambda cell: max(map(em, cell.lines)) if stacked else em(cell.text))
    left, right = ([room.at(TIGHT) for room in side] for side in overhangs(columns, above, gaps, TIGHT))
    return Widths(columns, cells, gaps, left, right)


def whole_pairs(page: Page, room: Widths) -> Widths:
    """Return the widths with the gaps below wide spanners as they shall be on any line: they cost no width.

    What hangs over serves these gaps first; they then belong to the columns. Several panels leave it.
    """
    gaps, left, right = ([*part] for part in (room.gaps, room.left, room.right))
    innermost = page.panels[0].spanners[-1] if len(page.panels) == 1 and page.panels[0].spanners else ()
    for cell in innermost:
        inner = range(cell.first + 1, cell.last + 1)
        needed = (1 - TIGHT) * added(gaps[place] for place in inner) / 2
        if needed and min(left[cell.first], right[cell.last]) >= needed:
            left[cell.first] -= needed
            right[cell.last] -= needed
            for place in inner:
                gaps[place], left[place] = 0.0, left[place] + gaps[place]
    return room._replace(gaps=gaps, left=left, right=right)


class TexLayout(NamedTuple):
    """How a table is set.

    `columns` are the columns that all panels share, without the gaps; `stacked` tells that the symbols of
    spanners have a line of their own, `pages` how many of them the table is high in type of 7 points.
    """

    widths: Widths
    columns: tuple[str, ...]
    stacked: bool
    pages: float

    @classmethod
    def of(cls, plain: Page, ready: Page) -> Self:
        """Return the layout for a page set as plain text, whose characters are what is measured.

        `ready` is the same page for LaTeX: a line with a high fraction takes the height of two. A spanner has
        its symbol beside it where the page is wide enough.
        """
        room = widths(plain, False)
        stacked = room.natural * SMALL > TYPE_WIDTH
        if stacked:
            room = widths(plain, True)
        words = {
            place
            for panel in plain.panels
            for place, column in enumerate(panel.columns)
            if column.align == "left"
        }
        return cls(
            widths=whole_pairs(plain, room),
            columns=tuple(
                "l" if place in words else cls.figures(whole - own)
                for place, (whole, own) in enumerate(zip(room.columns, room.cells, strict=True))
            ),
            stacked=stacked,
            pages=_lines(plain, ready) * LEADING / TYPE_HEIGHT,
        )

    @staticmethod
    def figures(spare: float) -> str:
        """Return a column whose figures stand in the middle of spare em of room."""
        half = f"{spare / 2:.2f}"
        return "r" if spare < 0.1 else f">{{\\hspace{{{half}em}}}}r<{{\\hspace{{{half}em}}}}"

    @property
    def tall(self) -> bool:
        """Whether it is longer than a page."""
        return self.pages > 1

    @property
    def endless(self) -> bool:
        """Whether it is longer than floats can be."""
        return self.pages > MOST_FLOATS

    @property
    def all(self) -> str:
        """The width of all columns in em, with what the estimate may lack."""
        return f"{1.015 * self.widths.all:.2f}"

    @property
    def gaps(self) -> int:
        """The hundreds of \\tabcolsep in all gaps."""
        return max(100, round(100 * added(self.widths.gaps) / WHOLE))

    @property
    def _least(self) -> float:
        """The width in em below which gaps and type are too small."""
        return self.widths.all + added(self.widths.gaps) * LEAST / WHOLE

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


class PlainLayout(TexLayout):
    """How a table is set by an author who measures nothing."""

    @staticmethod
    def figures(spare: float) -> str:
        return "r"

    def spec(self, count: int) -> str:
        return "".join(self.columns[:count])

    def head(self, cell: HeadCell, align: str, count: int) -> str:
        return align

    def trims(self, cell: HeadCell, count: int) -> str:
        return "lr"

    def spanner(self, cell: HeadCell) -> str:
        return cell.text


def _lines(plain: Page, ready: Page) -> float:
    """Return about how many lines of figures a page takes, with its caption and its notes."""
    lines = sum(2 * len(panel.spanners) + len(panel.heading_lines) + 1.0 for panel in ready.panels)
    for group in (group for panel in ready.panels for group in panel.groups):
        high = sum(any("\\displaystyle" in cell.text for cell in row) for row in group.rows)
        lines += len(group.rows) + high + (2 if group.label else 1) + 0.4 * len(group.pauses)
    texts = [*(note.text for note in plain.notes), plain.source]
    return lines + 4 + 1.2 * sum(math.ceil(em(text) * SMALLEST / TYPE_WIDTH) for text in texts)


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


class RawWriter(Writer):
    minus = "-"


class RawPlainWriter(PlainWriter):
    minus = "-"


def left_to_siunitx(table: Table, mark: str, tex: TexLayout, writer: Writer) -> dict[str, object]:
    """Return the page with raw numbers, and the layout with S columns for those of numbers alone."""
    ready = page(table, RawPlainWriter() if isinstance(writer, PlainWriter) else RawWriter(), mark)
    columns = [_column(tex.columns[place], cells, mark) for place, cells in enumerate(_by_column(ready))]
    return {"page": ready, "tex": tex._replace(columns=tuple(columns)), "marker": f"{{{mark}}}"}


def _by_column(ready: Page) -> Iterator[list[PageCell]]:
    """Yield the cells of each column in all panels that have it."""
    for place in range(max(len(panel.columns) for panel in ready.panels)):
        panels = [panel for panel in ready.panels if len(panel.columns) > place]
        yield [row[place] for panel in panels for row in panel.rows]


def _column(column: str, cells: list[PageCell], mark: str) -> str:
    numbers = [cell.text for cell in cells if cell.kind == "number"]
    if not numbers or any(cell.kind == "label" for cell in cells):
        return column
    whole = max(len(number.lstrip("-").split(mark)[0]) for number in numbers)
    decimals = max(len(number.partition(mark)[2]) for number in numbers)
    sign = "-" if any(number.startswith("-") for number in numbers) else ""
    return f"S[table-format={sign}{whole}.{decimals}]"
