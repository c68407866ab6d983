"""The space in tables for Typst: around figures that are narrower than their head, and between rows.

Typst sets figures flush under the right edge of a wide heading and gives the width that a spanner needs
beyond its columns to the last of them, as TeX does; the widths are estimated for both alike.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from kurbel.escapes import string_typst
from kurbel.page import Page
from kurbel.texwidth import column_widths, spare_widths


class TypstLayout(NamedTuple):
    """`margins` are the em on both sides of the cells of each column; the rest are numbers of rows.

    Rows are counted from 0 over the heads and bodies of all panels. An `opening` row follows a rule, a
    `closing` one stands before a rule, a `parted` one begins a group without a label.
    """

    label: str
    columns: tuple[str, ...]
    margins: tuple[str, ...]
    opening: tuple[int, ...]
    closing: tuple[int, ...]
    parted: tuple[int, ...]


# On both sides of every cell; between two columns there are twice as many and the gutter.
MARGIN = 0.3


def typst_layout(page: Page) -> TypstLayout:
    """Return the layout for a page set as plain text, whose characters are what is measured."""
    spare = tuple(spare_widths(page, column_widths(page)))
    rows = tuple(_rows(page))
    return TypstLayout(
        label=string_typst(f"tab-{page.key}"),
        columns=tuple("left" if one is None else "right" for one in spare),
        margins=tuple(f"{MARGIN + (one or 0) / 2:.2f}em" for one in spare),
        **{
            kind: tuple(place for place, found in enumerate(rows) if kind in found)
            for kind in ("opening", "closing", "parted")
        },
    )


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
