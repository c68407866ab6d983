"""The page of the piston's motion: its axes, and its digits computed once."""

from __future__ import annotations

from kurbel.arrange import Grid, Place, check_size
from kurbel.axes import AngleAxis, ColumnAxis, RatioAxis, angle_pairs
from kurbel.digits import columns_in_balls, columns_in_floats, is_long
from kurbel.request import PageColumn, Request
from kurbel.table import Cell, Number


def motion_grid(request: Request, columns: tuple[PageColumn, ...]) -> Grid:
    """Return the grid of ratios, angles and columns that was asked for."""
    layout, angles, lang = request.layout, request.angles, request.lang
    sizes = {"ratio": len(request.cranks), "angle": len(angles), "column": len(columns)}
    check_size(layout, sizes)
    if layout.pairs:
        angles = angle_pairs(angles)
    digits = [column.digits for column in columns]
    compute = columns_in_floats if is_long(digits, request.cranks, request.angles) else columns_in_balls
    values = [compute(digits, crank, angles, request.rounding) for crank in request.cranks]

    def cell(place: Place) -> Cell:
        scaled = values[place["ratio"]][place["column"]][place["angle"]]
        return Cell(Number(int(scaled), digits[place["column"]].decimals))

    ratios = [crank.ratio for crank in request.cranks]
    return Grid(
        {
            "ratio": RatioAxis(layout, ratios, lang),
            "angle": AngleAxis(layout, angles, lang),
            "column": ColumnAxis(layout, columns, ratios, lang),
        },
        cell,
    )
