"""What was asked for becomes a table: the only place where numbers meet pages."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Protocol

from kurbel import captions
from kurbel.arrange import panels
from kurbel.layouts import Layout
from kurbel.motion import motion_grid
from kurbel.request import Request, page_columns, quantities_of
from kurbel.rows import RecordRows
from kurbel.table import Note, Records, Table

if TYPE_CHECKING:
    from kurbel.balance_request import BalanceRequest
    from kurbel.beam_page import BeamRequest
    from kurbel.collate_page import CollateRequest
    from kurbel.engine_request import EngineRequest
    from kurbel.harmonics_page import HarmonicsRequest
    from kurbel.inertia_page import ErrorsRequest
    from kurbel.linkage_page import LinkageRequest
    from kurbel.solve_page import SolveRequest
    from kurbel.tangent_page import TangentRequest


class Asked(Protocol):
    """What is asked for, whatever it is about: the layout, the language, how many records there are."""

    @property
    def layout(self) -> Layout: ...
    @property
    def lang(self) -> str: ...
    def __len__(self) -> int: ...


def build(request: Asked, pages: bool = True) -> Table:
    """Return the table that was asked for; without `pages` only its records, which need no memory."""
    return BUILDERS[request.layout.subject](request, pages)


def _engine(request: EngineRequest, pages: bool) -> Table:
    from kurbel.engine_page import build_engine

    return build_engine(request, pages)


def _beam(request: BeamRequest, pages: bool) -> Table:
    from kurbel.beam_page import build_beam

    return build_beam(request, pages)


def _collation(request: CollateRequest, pages: bool) -> Table:
    from kurbel.collate_page import build_collation

    return build_collation(request, pages)


def _harmonics(request: HarmonicsRequest, pages: bool) -> Table:
    from kurbel.harmonics_page import build_harmonics

    return build_harmonics(request, pages)


def _balance(request: BalanceRequest, pages: bool) -> Table:
    from kurbel.balance_page import build_balance

    return build_balance(request, pages)


def _linkage(request: LinkageRequest, pages: bool) -> Table:
    from kurbel.linkage_page import build_linkage

    return build_linkage(request, pages)


def _errors(request: ErrorsRequest, pages: bool) -> Table:
    from kurbel.inertia_page import build_errors

    return build_errors(request, pages)


def _tangent(request: TangentRequest, pages: bool) -> Table:
    from kurbel.tangent_page import build_tangent

    return build_tangent(request, pages)


def _roots(request: SolveRequest, pages: bool) -> Table:
    from kurbel.solve_page import build_solve

    return build_solve(request, pages)


def _inertia(request: Request, pages: bool) -> Table:
    table = _motion(request, pages)
    if not pages:
        return table
    from kurbel.inertia_page import error_notes

    return replace(table, notes=(*table.notes, *map(Note, error_notes(request))))


def _motion(request: Request, pages: bool) -> Table:
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


# By the subject of the layout; a request knows only layouts of its own subjects.
BUILDERS: dict[str, Callable[[Any, bool], Table]] = {
    "motion": _motion,
    "inertia": _inertia,
    "inertia errors": _errors,
    "tangent": _tangent,
    "roots": _roots,
    "irregularity": _engine,
    "strokes": _engine,
    "turning": _engine,
    "crank forces": _engine,
    "machine": _engine,
    "flywheel": _engine,
    "dead centres": _beam,
    "harmonics": _harmonics,
    "collation": _collation,
    "balance": _balance,
    "arc crank": _linkage,
    "parallel crank": _linkage,
}
