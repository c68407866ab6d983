"""Grid tables: cells of any extent, drawn with lines."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import accumulate
from typing import NamedTuple
from unicodedata import combining, east_asian_width

from kurbel.formats.measure import Span, shared
from kurbel.formats.page import PagePanel
from kurbel.formats.rst.writer import finish
from kurbel.page.table import HeadCell


class GridCell(NamedTuple):
    """A cell by its place, counted from 0, and its extent; figures stand at the right of it."""

    row: int
    column: int
    lines: tuple[str, ...]
    down: int = 1
    across: int = 1
    right: bool = False

    @property
    def width(self) -> int:
        return max(map(width_of, self.lines), default=0)


def grid_table(panel: PagePanel) -> list[str]:
    """Return the lines of a panel."""
    head = [
        GridCell(row, cell.first, _head_lines(cell), cell.down, cell.across)
        for row, cells in enumerate(panel.head)
        for cell in cells
    ]
    return grid_lines([*head, *_body(panel)], len(panel.head))


def _head_lines(cell: HeadCell) -> tuple[str, ...]:
    return (cell.text,) if cell.kind == "spanner" else _block(cell.lines)


def _block(lines: Sequence[str]) -> tuple[str, ...]:
    """Return the lines of a heading as they stay apart."""
    return tuple(f"| {line}".rstrip() for line in lines) if len(lines) > 1 else tuple(lines)


def _body(panel: PagePanel) -> Iterator[GridCell]:
    row = len(panel.head)
    for group in panel.groups:
        if group.label:
            yield GridCell(row, 0, (group.label,), across=len(panel.columns))
            row += 1
        for cells in group.rows:
            for place, cell in enumerate(cells):
                if cell.down:
                    right = panel.columns[place].align == "right"
                    yield GridCell(row, place, (finish(cell.text + cell.marks),), cell.down, right=right)
            row += 1


def left_columns(panel: PagePanel) -> list[int]:
    """Return the columns of words, counted from 1 and from the right: at the left rows share cells."""
    last = len(panel.columns)
    return [last - place for place, column in enumerate(panel.columns) if column.align == "left"]


def width_of(text: str) -> int:
    """Return how many places a text takes where all letters are of one width."""
    return sum(0 if combining(one) else 1 + (east_asian_width(one) in "WF") for one in text)


def grid_lines(cells: Sequence[GridCell], heads: int) -> list[str]:
    """Return the lines of cells that cover a rectangle; so many rows are its head."""
    across = _edges([Span(cell.column, cell.across, cell.width + 2) for cell in cells])
    along = _edges([Span(cell.row, cell.down, len(cell.lines)) for cell in cells])
    canvas = [[" "] * (across[-1] + 1) for _ in range(along[-1] + 1)]
    for cell in cells:
        left, right = across[cell.column], across[cell.column + cell.across]
        for row in (cell.row, cell.row + cell.down):
            _fill(canvas[along[row]], left + 1, ("=" if 0 < row == heads else "-") * (right - left - 1))
        for line in canvas[along[cell.row] + 1 : along[cell.row + cell.down]]:
            _fill(line, left, "|")
            _fill(line, right, "|")
        for line, text in zip(canvas[along[cell.row] + 1 :], cell.lines, strict=False):
            blanks = right - left - 3 - width_of(text) if cell.right else 0
            _fill(line, left + 2 + blanks, text)
    for cell in cells:
        for row in (cell.row, cell.row + cell.down):
            for column in (cell.column, cell.column + cell.across):
                canvas[along[row]][across[column]] = "+"
    return ["".join(line) for line in canvas]


def _fill(line: list[str], place: int, text: Iterable[str]) -> None:
    """Put text into a line of places; what takes two of them, or none, leaves the line as long as it is."""
    for one in text:
        width = width_of(one)
        if width:
            line[place] = one
            line[place + 1 : place + width] = [""] * (width - 1)
        else:
            line[place - 1] += one
        place += width


def _edges(extents: Sequence[Span[int]]) -> list[int]:
    """Return where the lines stand that part rows or columns: each extent begins, covers many, needs room."""
    count = max(extent.first + extent.across for extent in extents)
    # What covers several comes last, when it is known how much room they have without it.
    rooms = shared([1] * count, sorted(extents, key=lambda extent: extent.across), [1] * count)
    return [0, *accumulate(room + 1 for room in rooms)]
