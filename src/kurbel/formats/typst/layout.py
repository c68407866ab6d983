"""The space in tables for Typst: around figures that are narrower than their head, between rows, and in all.

Typst sets figures flush under the right edge of a wide heading and gives the width that a spanner needs
beyond its columns to the last of them, as TeX does; the widths are estimated for both alike.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from kurbel.formats.page import Page, PageCell, PagePanel
from kurbel.formats.typst.writer import string
from kurbel.formats.widths import column_widths, em, spare_widths


class TypstLayout(NamedTuple):
    """The space that a table takes.

    `width` and `height` are bounds in em; `margins` are the em on both sides of the cells of each column;
    `widest` has, for each panel, rows of the widest cells of its columns, which Typst measures: to have it
    measure the whole table takes longer than to set it, and ten times the memory. The rest are numbers of
    rows, counted from 0 over the heads and bodies of all panels. An `opening` row follows a rule, a `closing`
    one stands before a rule, a `parted` one begins a group without a label.
    """

    label: str
    width: float
    height: float
    widest: tuple[tuple[tuple[PageCell, ...], ...], ...]
    columns: tuple[str, ...]
    margins: tuple[str, ...]
    opening: tuple[int, ...]
    closing: tuple[int, ...]
    parted: tuple[int, ...]


# On both sides of every cell; between two columns there are twice as many and the gutter.
MARGIN, GUTTER = 0.3, 0.6
# The height of a row, of one with a fraction of full size, and of a line of notes: rather too much.
ROW, HIGH_ROW, NOTE = 1.2, 3.1, 1.2
NARROWEST_NOTE = 24.0
# The widest of these cells in print is the widest of its column, though another may be so by the estimate.
CANDIDATES = 4


def typst_layout(page: Page, ready: Page) -> TypstLayout:
    """Return the layout for a page set as plain text, whose characters are what is measured.

    `ready` is the same page for Typst, where fractions may have their full size.
    """
    widths = column_widths(page)
    spare = tuple(spare_widths(page, widths))
    width = sum(widths) + 2 * MARGIN * len(widths) + GUTTER * (len(widths) - 1)
    rows = tuple(_rows(page))
    return TypstLayout(
        label=string(f"tab-{page.key}"),
        width=round(width, 1),
        height=round(_rows_height(ready) + _notes_height(page, max(width, NARROWEST_NOTE)), 1),
        widest=tuple(map(_widest_rows, page.panels, ready.panels)),
        columns=tuple("left" if one is None else "right" for one in spare),
        margins=tuple(f"{MARGIN + (one or 0) / 2:.2f}em" for one in spare),
        **{
            kind: tuple(place for place, found in enumerate(rows) if kind in found)
            for kind in ("opening", "closing", "parted")
        },
    )


def _widest_rows(panel: PagePanel, ready: PagePanel) -> tuple[tuple[PageCell, ...], ...]:
    """Return rows of the cells of each column that are widest in plain text, as Typst has them."""
    plain, made = ([row for group in one.groups for row in group.rows] for one in (panel, ready))
    columns = []
    for place in range(len(panel.columns)):
        order = sorted(
            range(len(plain)), key=lambda row: -em(plain[row][place].text + plain[row][place].tail)
        )
        columns.append([made[row][place]._replace(down=1) for row in order[:CANDIDATES]])
    return tuple(zip(*columns, strict=True))


def _rows_height(page: Page) -> float:
    heads = sum(len(panel.spanners) + len(panel.heading_lines) + 3 for panel in page.panels)
    groups = [group for panel in page.panels for group in panel.groups]
    rows = [row for group in groups for row in group.rows]
    high = sum(any("#box(height" in cell.text for cell in row) for row in rows)
    return (heads + 2 * len(groups) + len(rows) - high) * ROW + high * HIGH_ROW


def _notes_height(page: Page, width: float) -> float:
    texts = [*(note.text for note in page.notes), page.source]
    return sum(2 * NOTE + em(text) / width * NOTE for text in texts if text)


def _rows(page: Page) -> Iterator[set[str]]:
    """Yield what is special about each row of the table."""
    for number, panel in enumerate(page.panels):
        # Each panel but the first has a line above its head that says that it goes on.
        yield from [set()] * (len(panel.head) + (number > 0))
        rows: list[set[str]] = []
        for group in panel.groups:
            rows += [set()] * bool(group.label)
            rows += [{"parted"} if rows and not group.label else set(), *[set()] * (len(group.rows) - 1)]
        rows[0] = rows[0] | {"opening"}
        rows[-1] = rows[-1] | {"closing"}
        yield from rows
