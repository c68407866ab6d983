"""The page of the piston's motion: its axes, and its digits computed once."""

from __future__ import annotations

from dataclasses import replace

from kurbel.exact.numerals import Number
from kurbel.motion import captions
from kurbel.motion.digits import columns_in_balls, columns_in_floats, is_long
from kurbel.motion.request import PageColumn, Request, page_columns, quantities_of
from kurbel.motion.rows import RecordRows
from kurbel.page.arrange import Grid, Place, check_size, panels
from kurbel.page.axes import AngleAxis, ColumnAxis, RatioAxis, angle_pairs
from kurbel.page.table import Cell, Note, Records, Table


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


def build_inertia(request: Request, pages: bool) -> Table:
    table = build_motion(request, pages)
    if not pages:
        return table
    from kurbel.motion.inertia_page import error_notes

    return replace(table, notes=(*table.notes, *map(Note, error_notes(request))))


def build_motion(request: Request, pages: bool) -> Table:
    columns = page_columns(request)
    digits = [column.digits for column in columns]
    shown, own = {column.key for column in columns}, {column.key for column in request.layout.columns}
    if request.layout.subject == "inertia":
        # All are forces of the rod, of which the caption speaks.
        own |= {key for key, quantity in quantities_of(request.layout).items() if quantity.model}
    # A fixed page's caption names its formulas, all of them.
    chosen = bool(request.columns) and (not shown <= own or (request.layout.fixed and shown < own))
    records = RecordRows(request, columns)
    return Table(
        key=request.label or request.layout.key,
        layout=request.layout.key,
        lang=request.lang,
        caption=captions.caption(request, digits, chosen),
        panels=panels(request.layout, motion_grid(request, columns)) if pages else (),
        records=Records(records.fields(), records),
        notes=tuple(Note(text) for text in captions.notes(request, digits)),
        source=request.layout.source[request.lang],
    )
