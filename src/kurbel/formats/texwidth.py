r"""Estimated widths for LaTeX: what TeX, left alone, would set badly.

TeX gives the width that a spanner needs beyond its columns to the last of them, and sets figures flush
under the right edge of a wide heading. A column with space of its own, >{\hspace{..}}, does neither, and
keeps the cells of the source clean. The estimate is of Computer Modern; it is a little too wide by design.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from typing import NamedTuple

from kurbel.formats.page import HeadCell, Page, PageCell, PagePanel

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


def column_widths(page: Page) -> list[float]:
    """Return the width of each column in em, the same in all panels."""
    return _widest((_widths(panel) for panel in page.panels), _count(page))


def spare_widths(page: Page, widths: Sequence[float]) -> Iterator[float | None]:
    """Yield the width that its figures leave free in each column of that width, None for words."""
    words = {
        place for panel in page.panels for place, column in enumerate(panel.columns) if column.align == "left"
    }
    cells = _widest((_cell_widths(panel) for panel in page.panels), _count(page))
    for place, (room, own) in enumerate(zip(widths, cells, strict=True)):
        yield None if place in words else room - own


def _count(page: Page) -> int:
    return max(len(panel.columns) for panel in page.panels)


def _widest(panels: Iterable[Sequence[float]], count: int) -> list[float]:
    padded = ([*widths, *[0.0] * (count - len(widths))] for widths in panels)
    return [max(column) for column in zip(*padded, strict=True)]


def _lines(page: Page) -> int:
    heads = sum(len(panel.spanners) + len(panel.heading_lines) + 2 for panel in page.panels)
    groups = [group for panel in page.panels for group in panel.groups]
    return heads + sum(sum(map(_row_lines, group.rows)) + (3 if group.label else 1) for group in groups)


def _row_lines(row: Sequence[PageCell]) -> int:
    return 2 if any("\\displaystyle" in cell.text for cell in row) else 1


def _points(widths: Sequence[float], size: Size) -> float:
    return sum(widths) * size.em + 2 * len(widths) * size.tabcolsep


_CHARACTERS = (
    ("ijlIt.,:;'|!()[] ⁰¹²³⁴⁵⁶⁷⁸⁹⁾", 0.33),
    ("mwMW−±+=<>", 0.8),
    ("ABCDEFGHKLNOPQRSTUVXYZÄÖÜΔ", 0.72),
)
_EM = {character: width for characters, width in _CHARACTERS for character in characters}


def em(text: str) -> float:
    """Return the width of a text in units of the type size."""
    return sum(_EM.get(character, 0.52) for character in text)


def _cell_widths(panel: PagePanel) -> list[float]:
    rows = [row for group in panel.groups for row in group.rows]
    return [
        max((em(row[place].text + row[place].tail) for row in rows), default=0.0)
        for place in range(len(panel.columns))
    ]


def _widths(panel: PagePanel) -> list[float]:
    """Return the width of each column: its cells, its heading, and its share of the spanners above it."""
    widths = [
        max(cells, *map(em, column.heading), 0.0)
        for column, cells in zip(panel.columns, _cell_widths(panel), strict=True)
    ]
    for spanners in reversed(panel.spanners):
        for cell in spanners:
            # Between two columns stand twice 6 points, 1.2 em at normal size.
            extent = sum(widths[cell.first : cell.last + 1]) + 1.2 * (cell.across - 1)
            lacking = max(em(cell.lines[0]) - extent, 0.0)
            for place in range(cell.first, cell.last + 1):
                widths[place] += lacking / cell.across
    return widths


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
