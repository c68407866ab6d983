"""The arrangement of a page: which value stands in which row and column, under which heads."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import groupby, pairwise, product
from math import prod

from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label, Number
from kurbel.page.layouts import Layout
from kurbel.page.table import DITTO, UNIT, Cell, Column, Field, Group, Panel, Row, Value

# A page is held in memory whole; records stream. 300,000 cells take some seconds and 200 MB.
MOST_CELLS = 300_000
MOST_COLUMNS = 500

# A place on a page: the index on each axis by the axis' name.
Place = Mapping[str, int]


class Axis:
    """What varies along a page: its places, how each is written as a head, in the stub, over a group, and
    its field in records.

    A page has `size` places of it, records `count`.
    """

    # How many lines of the heads stay in the heading when the others span several columns.
    lines = 1
    # Its key in records.
    key = ""

    def __init__(self, size: int, count: int | None = None) -> None:
        self.size = size
        self.count = size if count is None else count

    def field(self) -> Field:
        """What it is in records."""
        raise NotImplementedError

    def value(self, place: Place) -> Value:
        """What stands for a place in records."""
        raise NotImplementedError

    def stub_heading(self) -> Label:
        """The heading of its column in the stub, unless the layout has another."""
        return self.field().name

    def heads(self, place: Place) -> tuple[Label, ...]:
        """The heads above a column, outermost first."""
        raise NotImplementedError

    def stub(self, place: Place) -> Number | Label:
        return self.heads(place)[-1]

    def over_group(self, place: Place) -> Label:
        return self.heads(place)[0]


class Grid:
    """The axes of a page by their names, and what stands at a place, in a language.

    `unit` gives a last column with the unit of each row, where the quantities run down; `exists` leaves out
    places of which there are fewer than the axes' sizes say.
    """

    def __init__(
        self,
        axes: Mapping[str, Axis],
        lang: str,
        cell: Callable[[Place], Cell],
        unit: Callable[[Place], Label] | None = None,
        exists: Callable[[Place], bool] | None = None,
    ) -> None:
        self.axes = axes
        self.lang = lang
        self.cell = cell
        self.unit = unit
        self.exists = exists

    def places(self, names: Sequence[str]) -> list[Place]:
        sizes = (range(self.axes[name].size) for name in names)
        places = (dict(zip(names, place, strict=True)) for place in product(*sizes))
        return [place for place in places if self.exists is None or self.exists(place)]


def panels(layout: Layout, grid: Grid) -> tuple[Panel, ...]:
    across = grid.places(layout.across)
    return tuple(_panel(layout, grid, block) for block in _blocks(across, layout.block))


def check_size(layout: Layout, sizes: Mapping[str, int]) -> None:
    """Raise ProblemError for a page of so many places that it cannot be held."""
    cells, across = prod(sizes.values()), prod(sizes[name] for name in layout.across)
    if cells > MOST_CELLS:
        raise ProblemError(
            f"a page of {cells} numbers is too long; at most {MOST_CELLS} are set, use -f csv or -f json"
        )
    # A panel of a block goes on below.
    if across > MOST_COLUMNS and not layout.block:
        raise ProblemError(
            f"a page of {across} columns is too wide; at most {MOST_COLUMNS} are set, use -f csv or -f json"
        )


def _blocks(places: list[Place], most: int) -> Iterator[list[Place]]:
    """Split into as few blocks as needed, of equal size, the larger ones last."""
    count = -(-len(places) // most) if most else 1
    ends = [len(places) * block // count for block in range(count + 1)]
    for start, end in pairwise(ends):
        yield places[start:end]


def _panel(layout: Layout, grid: Grid, across: list[Place]) -> Panel:
    heads = [name for name in layout.down if name not in layout.stub]
    # Where all heads stand in the stub, the outermost parts the groups.
    outer = heads or (layout.down[:1] if len(layout.down) > 1 else ())
    down = grid.places(layout.down)
    groups = [list(rows) for _, rows in groupby(down, key=lambda place: [place[name] for name in outer])]
    columns = _merged(tuple(_column(layout, grid, place) for place in across))
    return Panel(
        stub=tuple(_stub_column(layout, grid, name) for name in layout.stub),
        columns=(*columns, Column(UNIT, ("",))) if grid.unit else columns,
        groups=tuple(
            Group(
                tuple(_rows(layout, grid, rows, across)),
                # What has one place only stands in the caption.
                ", ".join(grid.axes[name].over_group(rows[0]) for name in heads if grid.axes[name].size > 1),
            )
            for rows in groups
        ),
    )


def _stub_column(layout: Layout, grid: Grid, name: str) -> Column:
    own = layout.stub_headings.get(name)
    return Column(name, (own[grid.lang] if own else grid.axes[name].stub_heading(),))


def _rows(layout: Layout, grid: Grid, rows: list[Place], across: list[Place]) -> Iterator[Row]:
    above: list[Cell | None] = [None] * len(layout.stub)
    for place in rows:
        stub = [Cell(grid.axes[name].stub(place)) for name in layout.stub]
        # Only outer heads are carried over several rows.
        shown = [
            Cell(DITTO) if cell == before and index < len(stub) - 1 else cell
            for index, (cell, before) in enumerate(zip(stub, above, strict=True))
        ]
        above = list(stub)
        unit = (Cell(grid.unit(place)),) if grid.unit else ()
        yield Row(tuple(shown), (*(grid.cell({**place, **other}) for other in across), *unit))


def _column(layout: Layout, grid: Grid, place: Place) -> Column:
    """A column with all its heads as spanners; `_merged` makes headings of those that span nothing."""
    labels = [label for name in layout.across for label in grid.axes[name].heads(place)]
    key = "-".join(str(place[name]) for name in layout.across)
    lines = max(grid.axes[name].lines for name in layout.across)
    return Column(key, tuple(labels[-lines:]), tuple(labels[:-lines]))


def _merged(columns: tuple[Column, ...]) -> tuple[Column, ...]:
    """Turn spanners over a single column into lines of its heading."""
    paths = [column.spanners for column in columns]
    around = [(), *paths, ()]
    return tuple(
        _own_heading(column, before, after)
        for column, before, after in zip(columns, around, around[2:], strict=False)
    )


def _own_heading(column: Column, before: tuple[Label, ...], after: tuple[Label, ...]) -> Column:
    shared = len(column.spanners)
    while shared and column.spanners[:shared] not in (before[:shared], after[:shared]):
        shared -= 1
    return Column(column.key, column.spanners[shared:] + column.heading, column.spanners[:shared])
