"""The space that shows what belongs together, gaps between columns and pauses between rows; and how wide
columns are, by their own texts and by what spanners above them need, in the metric of a format.

A metric is a function that returns the width of a text: characters, or em, such as those of Computer Modern
here, where they are nearly the same in all sizes. Formats only obey what is worked out here.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from functools import reduce
from itertools import chain, groupby, pairwise, zip_longest
from operator import add
from typing import TYPE_CHECKING, Generic, NamedTuple, TypeVar

from kurbel.exact.numerals import Number
from kurbel.page.labels import plain
from kurbel.page.table import DITTO, UNIT, Cell, Column, Group, HeadCell, Panel, Row

if TYPE_CHECKING:
    from kurbel.formats.page import PagePanel

# Characters, or em.
Length = TypeVar("Length", int, float)

_CHARACTERS = (
    ("ilI,.:;[]'’!|", 0.28),
    ("fj- ", 0.33),
    ("rst()₀₁₂₃₄₅₆₇₈₉", 0.39),
    ("cez?°⁻⁰¹²³⁴⁵⁶⁷⁸⁹⁾ₘ", 0.46),
    ("kqvxySbdhnpuüµJ", 0.55),
    ("LFEPBCTRAHNUVXYDwφψαωZ", 0.72),
    ("KOQG+−±=ÄÖÜΔΠΣΦΨΩ", 0.78),
    ("mM%½", 0.85),
    ("—∞W", 1.0),
)
_EM = {character: width for characters, width in _CHARACTERS for character in characters}


def added(lengths: Iterable[Length]) -> Length:
    """Return the sum, added one after the other.

    From Python 3.12 on sum() carries what floats lose, and a length here and there had another last digit.
    """
    return reduce(add, lengths, 0)


def em(text: str) -> float:
    """Return the width of a text; a character that is not listed is as wide as a digit."""
    return added([_EM.get(character, 0.5) for character in text])


def bodies(panel: PagePanel, width: Callable[[str], Length]) -> list[Length]:
    """Return the width of the widest cell of each column, of figures with room for the longest fraction."""
    cells = [[row[place] for row in panel.rows] for place in range(len(panel.columns))]
    return [max((width(cell.text + cell.tail) for cell in column), default=0) for column in cells]


def headings(panel: PagePanel, width: Callable[[str], Length]) -> list[Length]:
    """Return the width of the widest line of the heading of each column."""
    return [max(map(width, column.heading), default=0) for column in panel.columns]


def widest(panels: Iterable[Sequence[Length]]) -> list[Length]:
    """Return for each column the largest of what the panels have."""
    return [max(column) for column in zip_longest(*panels, fillvalue=0)]


class Span(NamedTuple, Generic[Length]):
    """What stands over several columns, or rows, and how wide it is."""

    first: int
    across: int
    width: Length


def spans(panel: PagePanel, width: Callable[[HeadCell], Length]) -> Iterator[Span[Length]]:
    """Yield the spanners of a panel, the innermost first."""
    for cell in chain.from_iterable(reversed(panel.spanners)):
        yield Span(cell.first, cell.across, width(cell))


def shared(columns: Sequence[Length], spans: Iterable[Span[Length]], gaps: Sequence[Length]) -> list[Length]:
    """Return the widths of columns that share evenly what the spanners above them lack; the gap before each
    column serves those that reach over it."""
    widths = list(columns)
    for span in spans:
        below = slice(span.first, span.first + span.across)
        lacking = span.width - added(gaps[below][1:]) - added(widths[below])
        for step in range(span.across):
            widths[span.first + step] += _share(lacking, span.across, step)
    return widths


def _share(lacking: Length, across: int, step: int) -> Length:
    # Of characters, which are not divided, the first columns have one more.
    return max(-((step - lacking) // across) if isinstance(lacking, int) else lacking / across, 0)


class StretchableWidth(NamedTuple):
    """A width, of which `gaps` take a share that grows and shrinks with them."""

    em: float
    gaps: float = 0.0

    def at(self, unit: float = 1.0) -> float:
        """Return the width with gaps of so many units."""
        return self.em + unit * self.gaps

    def __bool__(self) -> bool:
        return bool(self.em)


def overhangs(
    columns: Sequence[float], spans: Iterable[Span[float]], gaps: Sequence[float], unit: float = 1.0
) -> tuple[list[StretchableWidth], list[StretchableWidth]]:
    """Return how far spanners that are wider than what is below them reach over each column, left and right.

    Room there keeps the gaps between the columns below as they are, however wide the spanner is; of these, so
    many `unit`s serve the spanner.
    """
    left, right = ([StretchableWidth(0.0) for _ in columns] for _ in range(2))
    for first, across, width in spans:
        below, last = slice(first, first + across), first + across - 1
        hanging = [*left[below], *right[below]]
        em = width - added(columns[below]) - added(one.em for one in hanging)
        taken = added(gaps[below][1:]) + added(one.gaps for one in hanging)
        if em > unit * taken:
            for side, place in ((left, first), (right, last)):
                side[place] = StretchableWidth(side[place].em + em / 2, side[place].gaps - taken / 2)
    return left, right


def partings(panels: Sequence[Panel]) -> Iterator[tuple[Panel, ...]]:
    """Yield the panels in more and more pieces below each other, parted beside spanners, then anywhere.

    Units stand in all pieces, in one of their own only where no column has room beside them.
    """
    for blocks_of, repeated in ((_outermost, 1), (_under_spanners, 1), (_single, 1), (_single, 0)):
        most = max(len(blocks_of(panel.columns)) for panel in panels)
        for pieces in range(2, most + 1):
            yield tuple(part for panel in panels for part in _parted(panel, blocks_of, pieces, repeated))


def _outermost(columns: Sequence[Column]) -> list[int]:
    """Return how many columns stand under each outermost spanner, and between two of these."""
    return [len(list(run)) for _, run in groupby(columns, lambda column: column.spanners[:1])]


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
        by_count = range(every, len(group.rows), every) if every else ()
        yield frozenset(_by_step(panel, group) if every is None else by_count)


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


def _by_step(panel: Panel, group: Group) -> Iterator[int]:
    if len(group.rows) < FEWEST or not panel.stub:
        return
    if any(cell.value is DITTO for row in group.rows for cell in row.stub[:-1]):
        goes_on = [any(cell.value is DITTO for cell in row.stub) for row in group.rows]
        yield from (place for place, one in enumerate(goes_on) if place and not one)
        return
    values = [_value(row.stub[-1]) for row in group.rows]
    known = [value for value in values if value is not None]
    steps = {after - before for before, after in pairwise(known)}
    if len(known) < len(values) or len(steps) != 1 or 0 in steps:
        return
    (step,) = steps
    stride = abs(step) * _count(abs(step), panel.stub[-1].key == "angle")
    yield from (place for place, value in enumerate(known) if place and value % stride == 0)


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
