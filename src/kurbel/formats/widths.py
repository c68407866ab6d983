"""Estimated widths of the columns of a table in print, in units of the type's size.

The estimate is of Computer Modern; it is a little too wide by design.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from kurbel.formats.page import Page, PagePanel


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
