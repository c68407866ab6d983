"""The firing orders of engines."""

from typing import Annotated, Unpack

from kurbel.commands import parameters as option
from kurbel.commands.balance import Banks, CylinderCranks, Engine
from kurbel.commands.old_motion import sheet_of
from kurbel.commands.options import Count, Option
from kurbel.commands.subject import makes_table
from kurbel.page.layouts import layout_of
from kurbel.page.subject import Question
from kurbel.reading.given import as_crank_angles, as_names


@makes_table()
def firing_table(
    engine: Engine = None,
    *,
    cranks: CylinderCranks = None,
    banks: Banks = None,
    order: Annotated[
        str | None,
        Option("Firing order whose cranks are sought, or of these cranks: 1-3-4-2.", "ORDER"),
    ] = None,
    intervals: Annotated[
        option.Given | None,
        Option(
            "With --order: the angles from each firing to the next, '315;405'; default: equal ones.",
            "ANGLES",
            unit="degrees",
        ),
    ] = None,
    strokes: Annotated[
        int, Option("Strokes of a cycle: 4 (default) or 2.", "N", Count("number of strokes", 2, 4))
    ] = 4,
    columns: Annotated[
        option.Names, option.columns_option("firing-orders", "number,firing_order,longest")
    ] = (),
    layouts: option.Layouts = None,
    layout: Annotated[str | None, option.layout_option("firing orders", "firing")] = None,
    **sheet: Unpack[option.Plain],
) -> Question:
    """Print the firing orders that an engine's cranks allow; with --order the cranks that it needs.

    \b
    kurbel firing --cranks '0;180;180;0'
    kurbel firing --engine v8-90
    kurbel firing --order 1-5-3-6-2-4
    kurbel firing --order 1-2 --banks '0;45' --intervals '405;315'
    \f
    >>> import kurbel
    >>> page = kurbel.firing_table(cranks="0;180;180;0", columns="firing_order")
    >>> print(kurbel.typeset(page, "csv"), end="")
    number,firing_order
    1,1-2-4-3
    2,1-3-4-2
    """
    from kurbel.balance.firing import read_order
    from kurbel.balance.firing_page import FiringRequest, asked

    page = layout_of(layout or ("firing" if order else "firing-orders"), ("firing orders", "firing"), layouts)
    sought = () if order is None else read_order(order)
    name, arrangement = asked(
        engine,
        () if cranks is None else as_crank_angles(cranks),
        () if banks is None else as_crank_angles(banks),
        sought,
        strokes,
        () if intervals is None else as_crank_angles(intervals),
    )
    return FiringRequest(
        layout=page,
        arrangement=arrangement,
        strokes=strokes,
        order=sought,
        engine=name,
        columns=as_names(columns, "firing_order" if order is None else "crank,fires_at"),
        **sheet_of(sheet),
    )
