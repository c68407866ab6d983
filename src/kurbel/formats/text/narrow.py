"""Pages for a narrow terminal: texts go on in further lines, or become notes, or a panel goes on below."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import groupby, pairwise

from kurbel.formats.page import Page
from kurbel.formats.text.reflow import reflowed
from kurbel.formats.text.writer import grids_of
from kurbel.page.table import UNIT, Column, Group, Panel, Row, Table


def narrowed(table: Table, page: Page, annotated: Callable[[Table], Page], width: int) -> Page:
    """Return the page in as few panels as fit, parted between spanners if that is enough.

    What stands side by side stays so if lines of its texts can be shorter, or if long ones become notes. A
    table of which not even single columns fit is returned as it is.
    """
    for ready in (page, *map(annotated, _parted_tables(table))):
        for attempt in reflowed(ready, width):
            if all(grid.total <= width for grid in grids_of(attempt, width)):
                return attempt
    return page


def _parted_tables(table: Table) -> Iterator[Table]:
    # Units stand in a panel of their own only where no column has room beside them.
    for blocks_of, repeated in ((_under_spanners, 1), (_single, 1), (_single, 0)):
        most = max(len(blocks_of(panel.columns)) for panel in table.panels)
        for pieces in range(2, most + 1):
            panels = tuple(
                part for panel in table.panels for part in _parted(panel, blocks_of, pieces, repeated)
            )
            yield replace(table, panels=panels)


def _under_spanners(columns: Sequence[Column]) -> list[int]:
    """Return how many columns stand under each outermost spanner."""
    runs = groupby(range(len(columns)), lambda place: columns[place].spanners[:1] or (place,))
    return [len(list(run)) for _, run in runs]


def _single(columns: Sequence[Column]) -> list[int]:
    return [1] * len(columns)


def _parted(
    panel: Panel, blocks_of: Callable[[Sequence[Column]], list[int]], pieces: int, repeated: int
) -> Iterator[Panel]:
    """Yield the panel in so many pieces with about as many blocks each, units in all if they are repeated."""
    units = repeated if panel.columns[-1].key == UNIT else 0
    shown = len(panel.columns) - units
    blocks = blocks_of(panel.columns[:shown])
    pieces = min(pieces, len(blocks))
    # The first pieces take what is left over, as a book fills its first block.
    ends = [sum(blocks[: -(-len(blocks) * piece // pieces)]) for piece in range(pieces + 1)]
    for start, end in pairwise(ends):
        groups = tuple(
            Group(
                tuple(Row(row.stub, row.cells[start:end] + row.cells[shown:]) for row in group.rows),
                group.label,
            )
            for group in panel.groups
        )
        yield Panel(panel.stub, panel.columns[start:end] + panel.columns[shown:], groups)
