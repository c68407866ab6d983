"""Columns whose numbers are left to the package siunitx: digits, sign and mark as they are typed."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from kurbel.formats.latex.writer import PlainWriter, TexLayout, Writer
from kurbel.formats.page import Page, PageCell, page
from kurbel.page.table import Table


class RawWriter(Writer):
    minus = "-"


class RawPlainWriter(PlainWriter):
    minus = "-"


def left_to_siunitx(table: Table, mark: str, tex: TexLayout, writer: Writer) -> dict[str, Any]:
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
