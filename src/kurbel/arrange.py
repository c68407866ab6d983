"""The arrangement of a page: which value stands in which row and column, under which heads."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import groupby, pairwise, product

from kurbel import captions
from kurbel.digits import columns_in_balls, columns_in_floats, is_long
from kurbel.errors import ProblemError
from kurbel.notation import plain, ratio_text
from kurbel.numerals import degrees_text, finite_decimals
from kurbel.request import PageColumn, Request
from kurbel.rows import angle_decimals, angle_number
from kurbel.table import DITTO, Cell, Column, Group, Label, Number, Panel, Row

# A page is held in memory whole; records stream. 300,000 cells take some seconds and 200 MB.
MOST_CELLS = 300_000
MOST_COLUMNS = 500

# A place on an axis: the index of a ratio, an angle or a column by the name of its axis.
Place = Mapping[str, int]


def panels(request: Request, columns: tuple[PageColumn, ...]) -> tuple[Panel, ...]:
    page = _Page(request, columns)
    across = page.places(request.layout.across)
    return tuple(page.panel(block) for block in _blocks(across, request.layout.block))


def _blocks(places: list[Place], most: int) -> Iterator[list[Place]]:
    """Split into as few blocks as needed, of equal size, the larger ones last."""
    count = -(-len(places) // most) if most else 1
    ends = [len(places) * block // count for block in range(count + 1)]
    for start, end in pairwise(ends):
        yield places[start:end]


class _Page:
    """The arrangement of one request: where a place of the three axes is printed, and what stands there."""

    def __init__(self, request: Request, columns: tuple[PageColumn, ...]) -> None:
        _check_size(request, columns)
        self.angles = _pairs(request.angles) if request.layout.pairs else request.angles
        self.request = request
        self.layout = request.layout
        self.columns = columns
        self.angle_decimals = angle_decimals(self.angles)
        digits = [column.digits for column in columns]
        long = is_long(digits, request.cranks, request.angles)
        compute = columns_in_floats if long else columns_in_balls
        self.values = [compute(digits, crank, self.angles, request.rounding) for crank in request.cranks]

    def places(self, axes: Sequence[str]) -> list[Place]:
        lengths = {
            "ratio": len(self.request.cranks),
            "angle": len(self.angles),
            "column": len(self.columns),
        }
        return [
            dict(zip(axes, place, strict=True)) for place in product(*(range(lengths[axis]) for axis in axes))
        ]

    def panel(self, across: list[Place]) -> Panel:
        down = self.places(self.layout.down)
        heads = [axis for axis in self.layout.down if axis not in self.layout.stub]
        outer = self.layout.down[:1] if len(self.layout.down) > 1 else ()
        groups = [list(rows) for _, rows in groupby(down, key=lambda place: [place[axis] for axis in outer])]
        return Panel(
            stub=tuple(Column(axis, self._stub_heading(axis)) for axis in self.layout.stub),
            columns=_merged(tuple(self._column(place) for place in across)),
            groups=tuple(
                Group(
                    tuple(self._rows(rows, across)),
                    " ".join(self._label(axis, rows[0])[0] for axis in heads) if len(groups) > 1 else "",
                )
                for rows in groups
            ),
        )

    def _rows(self, rows: list[Place], across: list[Place]) -> Iterator[Row]:
        above: list[Cell | None] = [None] * len(self.layout.stub)
        for place in rows:
            stub = [self._stub_cell(axis, place) for axis in self.layout.stub]
            # Only outer heads are carried over several rows.
            shown = [
                Cell(DITTO) if cell == before and index < len(stub) - 1 else cell
                for index, (cell, before) in enumerate(zip(stub, above, strict=True))
            ]
            above = list(stub)
            yield Row(tuple(shown), tuple(self._cell({**place, **other}) for other in across))

    def _cell(self, place: Place) -> Cell:
        scaled = self.values[place["ratio"]][place["column"]][place["angle"]]
        return Cell(Number(int(scaled), self.columns[place["column"]].digits.decimals))

    def _stub_cell(self, axis: str, place: Place) -> Cell:
        if axis == "angle":
            return Cell(_angle_cell(self.angles[place["angle"]], self.angle_decimals))
        return Cell(self._label(axis, place)[-1])

    def _stub_heading(self, axis: str) -> tuple[Label, ...]:
        default = {
            "angle": f"${self.layout.angle_symbol}$" + (" in °" if self.angle_decimals is not None else ""),
            "ratio": f"${self.layout.ratio_symbol}$",
            "column": "",
        }
        return (self.layout.stub_headings.get(axis, default[axis]),)

    def _column(self, place: Place) -> Column:
        """A column with all its heads as spanners; `_merged` makes headings of those that span nothing."""
        labels = [label for axis in self.layout.across for label in self._label(axis, place, across=True)]
        key = "-".join(str(place[axis]) for axis in self.layout.across)
        lines = 2 if self.layout.pairs and "angle" in place else 1
        return Column(key, tuple(labels[-lines:]), tuple(labels[:-lines]))

    def _label(self, axis: str, place: Place, across: bool = False) -> tuple[Label, ...]:
        if axis == "ratio":
            shown = ratio_text(self.request.cranks[place["ratio"]].ratio)
            return (
                (f"${shown}$",)
                if across or axis in self.layout.stub
                else (f"${self.layout.ratio_symbol} = {shown}$",)
            )
        if axis == "angle":
            angle = self.angles[place["angle"]]
            return (
                (_angle_label(angle), _angle_label(360 - angle))
                if self.layout.pairs
                else (_angle_label(angle),)
            )
        column = self.columns[place["column"]]
        labels = column.spanners + column.heading if across else column.heading
        if "ratio" in self.layout.across:
            # The ratios stand below without their letters: "Hingang, R:L" over 1:4, 1:5.
            return (*labels[:-1], f"{labels[-1]}, ${self.layout.ratio_symbol}$")
        if "ratio" not in place:
            return labels
        return tuple(
            captions.with_ratio(label, self.request.cranks[place["ratio"]].ratio) for label in labels
        )


def _pairs(angles: Sequence[Fraction]) -> tuple[Fraction, ...]:
    """Return each pair of angles once, by the one up to 180°: 200° stands in the pair of 160°."""
    within = (angle % 360 for angle in angles)
    return tuple(dict.fromkeys(min(angle, 360 - angle) for angle in within))


def _check_size(request: Request, columns: tuple[PageColumn, ...]) -> None:
    cells = len(request.cranks) * len(request.angles) * len(columns)
    if cells > MOST_CELLS:
        raise ProblemError(
            f"a page of {cells} numbers is too long; at most {MOST_CELLS} are set, use -f csv or -f json"
        )
    if "ratio" in request.layout.across and len(request.cranks) * len(columns) > MOST_COLUMNS:
        raise ProblemError(
            f"a page of {len(request.cranks)} ratios across is too wide;"
            f" at most {MOST_COLUMNS} columns are set, use -f csv or -f json"
        )


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


def _angle_cell(angle: Fraction, decimals: int | None) -> Number | Label:
    return f"${degrees_text(angle)}$" if decimals is None else angle_number(angle, decimals)


def _angle_label(angle: Fraction) -> Label:
    return f"${plain(angle) if finite_decimals(angle) is not None else degrees_text(angle)}$"
