"""The head of a table: its spanners and headings as cells, and the symbols that columns share."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby
from typing import Literal, NamedTuple, TypeAlias

from kurbel.exact.numerals import Label
from kurbel.page.table import Column, Panel

Path: TypeAlias = tuple[Label, ...]


class HeadCell(NamedTuple):
    """A cell of the head. `level` counts the spanners above it: 0 for the outermost one.

    A spanner has its name as the first line and, as a second, the symbol that all columns below it share.
    """

    lines: tuple[str, ...]
    kind: Literal["stub", "spanner", "heading"]
    first: int
    across: int = 1
    down: int = 1
    level: int = 0

    @property
    def last(self) -> int:
        return self.first + self.across - 1

    @property
    def text(self) -> str:
        """All lines of it on one."""
        return " ".join(line for line in self.lines if line)


def shared_symbols(panel: Panel) -> dict[Path, Label]:
    """Return, by the spanners above them, the symbols that stand in the innermost of these.

    They are the last lines of the headings, where all columns under each spanner share theirs; nothing where
    those of any differ, for the line would then remain.
    """
    paths = [column.spanners for column in panel.columns if column.spanners]
    shared = {path: _shared([one.heading for one in panel.columns if one.spanners == path]) for path in paths}
    return shared if all(shared.values()) else {}


def _shared(headings: Sequence[tuple[Label, ...]]) -> Label:
    """Return the last line of all headings, where it is the same formula below other lines; else nothing."""
    lasts = {heading[-1] for heading in headings}
    ready = len(lasts) == 1 and "$" in headings[0][-1] and all(heading[:-1] for heading in headings)
    return lasts.pop() if ready else ""


def head_rows(panel: Panel) -> tuple[tuple[HeadCell, ...], ...]:
    """Return the rows of the head, spanners merged where neighbours share them and all above them."""
    columns = panel.stub + panel.columns
    shared = shared_symbols(panel)
    levels = max(len(column.spanners) for column in columns)
    rows = []
    for level in range(levels + 1):
        cells = [
            *_spanners(columns, level, shared),
            *_headings(columns, level, levels, len(panel.stub), bool(shared)),
        ]
        rows.append(tuple(sorted(cells, key=lambda cell: cell.first)))
    return tuple(rows)


def _spanners(columns: Sequence[Column], level: int, shared: Mapping[Path, Label]) -> Iterator[HeadCell]:
    first = 0
    for path, members in groupby(columns, key=lambda column: column.spanners[: level + 1]):
        across = len(list(members))
        if len(path) > level:
            lines = (path[level], shared[path]) if path in shared else (path[level],)
            yield HeadCell(lines, "spanner", first, across, 1, level)
        first += across


def _headings(
    columns: Sequence[Column], level: int, levels: int, stubs: int, without_symbols: bool
) -> Iterator[HeadCell]:
    for place, column in enumerate(columns):
        if len(column.spanners) == level:
            kind: Literal["stub", "heading"] = "stub" if place < stubs else "heading"
            lines = column.heading[:-1] if without_symbols and column.spanners else column.heading
            yield HeadCell(lines, kind, place, 1, levels - level + 1, level)
