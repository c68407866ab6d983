"""Pages of approximations of the straight crank: the errors of series, and Rötscher's steps."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from kurbel.commands.drives.orders import orders_of
from kurbel.commands.machines import check_whole
from kurbel.commands.old_motion import angles_of, sheet_of
from kurbel.commands.options import is_given
from kurbel.drive.crank import Described
from kurbel.errors import ProblemError
from kurbel.motion.mechanism import Mechanism
from kurbel.page.layouts import Layout
from kurbel.page.subject import Question
from kurbel.reading.given import as_names

ERRORS = "series errors"


def approximations(chosen: Mechanism, said: Described, page: Layout, given: Mapping[str, Any]) -> Question:
    """Return what is asked for of the cranks that were described. Raises KurbelError."""
    _check(chosen, page, given)
    cranks = chosen.drives(said, page.ratios)
    if page.subject == ERRORS:
        from kurbel.motion.series.errors_page import ORDERS, SeriesErrorsRequest

        check_whole(page, given)
        orders = orders_of(given["order"]) if is_given(given["order"]) else ORDERS
        names = as_names(given["columns"], "order,error_x,error_c,error_p")
        return SeriesErrorsRequest(
            layout=page, cranks=cranks, orders=orders, columns=names, **sheet_of(given)
        )
    from kurbel.motion.series.chord_page import ChordRequest

    angles, names = angles_of(page, given), as_names(given["columns"], "phi,gf_1,gf_2,gf")
    return ChordRequest(layout=page, cranks=cranks, angles=angles, columns=names, **sheet_of(given))


def _check(chosen: Mechanism, page: Layout, given: Mapping[str, Any]) -> None:
    if chosen.name != "straight":
        raise ProblemError(
            f"layout {page.key} is of the straight crank, and {chosen.title} was described; leave that out"
        )
    if given["method"] is not None:
        raise ProblemError(f"layout {page.key} compares formulas and takes no method; leave --method out")
    if given["acceleration"] is not None:
        raise ProblemError(f"layout {page.key} is of a crank that turns evenly; leave --acceleration out")
    if is_given(given["order"]) and page.subject != ERRORS:
        raise ProblemError(
            f"layout {page.key} has steps and no series; leave --order out, or choose columns, gf_1 to gf_9"
        )
