"""`kurbel table --mechanism arc` and `--mechanism parallel`."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from kurbel.cli.mechanism import MECHANISMS
from kurbel.cli.options import sheet_of, without_outdone
from kurbel.cli.table import RIVALS, chosen_angles
from kurbel.drive.crank import Crank
from kurbel.errors import NotationError, ProblemError
from kurbel.linkage.arc import ArcCrank
from kurbel.page.layouts import Layout
from kurbel.reading import notation


def print_linkage(name: str, options: dict[str, Any]) -> None:
    """Print a page of the arc crank or the parallel crank that the options describe."""
    from kurbel.cli.printing import Printing, print_table
    from kurbel.linkage.page import LinkageRequest
    from kurbel.page.layouts import layout_of

    options = without_outdone(options, RIVALS)
    page = layout_of(options["layout"], [MECHANISMS[name].subject])
    printing = Printing.chosen(options)
    request = LinkageRequest(
        layout=page,
        angles=chosen_angles(page, options),
        cranks=arc_cranks(page, options) if name == "arc" else (),
        **sheet_of(options, "phi,path,rocker"),
    )
    print_table(request, printing)


def arc_cranks(page: Layout, options: Mapping[str, Any]) -> tuple[ArcCrank, ...]:
    """Return the arc cranks that the options describe, of the layout's ratios if none are there."""
    if options["method"] not in (None, "exact"):
        raise ProblemError(
            f'method "{options["method"]}" has no formulas for the arc crank; use exact,'
            " with --ratio 1:∞ for the infinite rod"
        )
    offset = Fraction(0) if options["offset"] is None else _radii(options["offset"], "offset")
    rocker, pivot = _radii(options["rocker"], "rocker"), _pivot(options["pivot"])
    return tuple(
        ArcCrank(Crank(ratio, offset), rocker, *pivot)
        for ratio in notation.ratios(options["ratio"] or page.ratios)
    )


def _pivot(text: str | None) -> tuple[Fraction, Fraction] | tuple[()]:
    """D and H from "5;6"."""
    if text is None:
        return ()
    parts = text.split(";")
    if len(parts) != 2:
        raise NotationError(
            f'pivot "{text[:40]}" is not a place; write its distance from the shaft along and across the'
            " slide in units of R as D;H, for example 5;6"
        )
    distance, height = (_radii(part, "pivot") for part in parts)
    return distance, height


def _radii(text: str, what: str) -> Fraction:
    """A length in units of R: 6, 6R."""
    from kurbel.reading.units import is_measure

    share = text.strip().removesuffix("R")
    if is_measure(share):
        raise NotationError(
            f'{what} "{text[:40]}" has a unit; lengths of the arc crank are in units of R, for example 6'
        )
    return notation.number(share, what)
