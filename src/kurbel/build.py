"""What was asked for becomes a table: the only place where numbers meet pages."""

from __future__ import annotations

from typing import Protocol

from kurbel import captions
from kurbel.arrange import panels
from kurbel.motion import motion_grid
from kurbel.request import Request, page_columns
from kurbel.rows import RecordRows
from kurbel.table import Note, Records, Table


class Asked(Protocol):
    """What is asked for of an engine: its language, how many records it has, and the table."""

    @property
    def lang(self) -> str: ...
    def __len__(self) -> int: ...
    def table(self, pages: bool) -> Table: ...


def build(request: Request | Asked, pages: bool = True) -> Table:
    """Return the table that was asked for; without `pages` only its records, which need no memory."""
    return _motion(request, pages) if isinstance(request, Request) else request.table(pages)


def _motion(request: Request, pages: bool) -> Table:
    columns = page_columns(request)
    digits = [column.digits for column in columns]
    shown, own = {column.key for column in columns}, {column.key for column in request.layout.columns}
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
