"""The space that shows what belongs together: gaps between columns, pauses between rows.

It is worked out once, here; formats only obey it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise

from kurbel.exact.numerals import Number
from kurbel.page.labels import plain
from kurbel.page.table import DITTO, Cell, Column, Group, Panel

# In em. Columns under the same spanners, or of a stub, stand close; of those that share an outer spanner
# only, and where there are no spanners, further apart.
WITHIN, BESIDE, BETWEEN = 1.3, 2.0, 2.6
# A table with fewer rows is seen at a glance.
FEWEST = 12
# Steps after which a pause falls on what readers look for, by preference.
_ROUND_ANGLES = (30, 90, 15, 45, 60)
_COUNTS = (3, 5)
# Rows of one line that stay together.
MOST_HELD = 8
_RELATION = r"\s*\$\s*[=≈<>≤≥]"


def gaps(panel: Panel) -> Iterator[float]:
    """Yield the space before each column, that of the stub first."""
    columns = panel.stub + panel.columns
    plain_head = not any(column.spanners for column in columns)
    for place, column in enumerate(columns):
        if place == 0:
            yield 0.0
        elif place < len(panel.stub):
            yield WITHIN
        elif place == len(panel.stub):
            yield BESIDE if plain_head else BETWEEN
        else:
            yield BESIDE if plain_head else _gap(columns[place - 1], column)


def _gap(left: Column, right: Column) -> float:
    if left.spanners == right.spanners:
        return WITHIN
    return BESIDE if left.spanners[:1] == right.spanners[:1] else BETWEEN


def panel_pauses(panel: Panel, every: int | None) -> Iterator[frozenset[int]]:
    """Yield the rows of each group before which there is a pause.

    `every` says after how many rows, 0 for none. None leaves it to the step of the last column of the stub:
    three rows or five, so that the rows after a pause have round values; none in a short table, in one whose
    rows have no even step, and between the rows of one cell of the stub.
    """
    for group in panel.groups:
        yield frozenset(_every(group, every) if every is not None else _by_step(panel, group))


def held(group: Group) -> frozenset[int]:
    """Return the rows of a group before which no page may end: what goes on with the line above it.

    That is a further part of an equation or a further figure of a line, whose stub says nothing or begins
    with a sign of relation. A line of very many rows ends where it must.
    """
    found, run = [], 0
    for place, row in enumerate(group.rows):
        run = run + 1 if place and row.stub and _continues(row.stub) else 0
        if 0 < run < MOST_HELD:
            found.append(place)
    return frozenset(found)


def _continues(stub: Sequence[Cell]) -> bool:
    return all(cell.value is DITTO or cell.value == "" for cell in stub) or (
        isinstance(stub[-1].value, str) and re.match(_RELATION, stub[-1].value) is not None
    )


def _every(group: Group, count: int) -> Iterator[int]:
    yield from range(count, len(group.rows), count) if count else ()


def _by_step(panel: Panel, group: Group) -> Iterator[int]:
    if len(group.rows) < FEWEST or not panel.stub:
        return
    if any(cell.value is DITTO for row in group.rows for cell in row.stub[:-1]):
        yield from (place for place, row in enumerate(group.rows) if place and not _goes_on(row.stub))
        return
    values = [_value(row.stub[-1]) for row in group.rows]
    known = [value for value in values if value is not None]
    steps = {after - before for before, after in pairwise(known)}
    if len(known) < len(values) or len(steps) != 1 or 0 in steps:
        return
    (step,) = steps
    stride = abs(step) * _count(abs(step), panel.stub[-1].key == "angle")
    yield from (place for place, value in enumerate(known) if place and value % stride == 0)


def _goes_on(stub: Sequence[Cell]) -> bool:
    return any(cell.value is DITTO for cell in stub)


def _count(step: Fraction, angle: bool) -> int:
    """Return how many rows stand between pauses: as many as end on a round value, else five."""
    if angle:
        for stride in _ROUND_ANGLES:
            if stride / step in _COUNTS:
                return int(stride / step)
    return next((count for count in _COUNTS if _is_round(count * step)), _COUNTS[-1])


def _is_round(value: Fraction) -> bool:
    """Tell whether a positive value is 1, 2 or 5 times a power of ten."""
    while value >= 10:
        value /= 10
    while value < 1:
        value *= 10
    return value in (1, 2, 5)


_DEGREES = r"([0-9]+)°(?:([0-9]+)′)?"


def _value(cell: Cell) -> Fraction | None:
    """Return the number of a cell of the stub, or its degrees and minutes; None for words."""
    if isinstance(cell.value, Number):
        return Fraction(cell.value.scaled, 10**cell.value.decimals)
    degrees = re.fullmatch(_DEGREES, plain(cell.value)) if isinstance(cell.value, str) else None
    return None if degrees is None else int(degrees[1]) + Fraction(int(degrees[2] or 0), 60)
