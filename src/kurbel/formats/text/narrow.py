"""Pages for a narrow terminal: a panel that is too wide goes on in further panels below, as books do it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import groupby, pairwise

from kurbel.page.table import UNIT, Column, Group, Panel, Row, Table


def narrowed(table: Table, fits: Callable[[Table], bool]) -> Table:
    """Return the table in as few panels as fit, parted between spanners if that is enough.

    A table of which not even single columns fit is returned as it is.
    """
    if fits(table):
        return table
    # Units stand in a panel of their own only where no column has room beside them.
    for blocks_of, repeated in ((_under_spanners, 1), (_single, 1), (_single, 0)):
        most = max(len(blocks_of(panel.columns)) for panel in table.panels)
        for pieces in range(2, most + 1):
            panels = tuple(
                part for panel in table.panels for part in _parted(panel, blocks_of, pieces, repeated)
            )
            parted = replace(table, panels=panels)
            if fits(parted):
                return parted
    return table


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
