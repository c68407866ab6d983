"""From a table to text in a format. The only module that knows Jinja; templates only arrange.

Plain text needs no template, for its grid is all there is to it: that saves the first table on a terminal
the third of its time that loading Jinja takes.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from functools import cache
from typing import TYPE_CHECKING, Any

from kurbel.errors import ChoiceError
from kurbel.formats import Format, by_name
from kurbel.labels import plain
from kurbel.layouts import template_folder
from kurbel.page import blank, page
from kurbel.table import Table
from kurbel.textgrid import grid_of, text_page

if TYPE_CHECKING:
    from jinja2 import Environment, Template


def render(
    table: Table,
    format: str,
    *,
    decimal: str | None = None,
    standalone: bool = False,
    longtable: bool = False,
    width: int | None = None,
) -> str:
    """Return the table as text in the named format.

    `decimal` is "comma" or "point"; by default it follows the language of the table, and is a point in CSV
    and JSON. `standalone` makes a document of what is otherwise a fragment, in the formats that have
    documents; `longtable` lets a LaTeX table break over pages. JSON has only points. Plain text goes on in
    further panels where it would be wider than `width` characters.
    """
    form = by_name(format)
    if form.kind == "compiled":
        raise ChoiceError(f"a {form.name} is bytes and no text; make it with kurbel.typeset_{form.name}")
    if form.kind == "records":
        return "".join(rows(table, form, decimal))
    mark = form.decimal_mark(table.lang, decimal)
    if form.name == "text" and width is not None:
        from kurbel.narrow import narrowed

        table = narrowed(table, lambda parted: grid_of(page(parted, form, mark)).total <= width)
        return text_page(page(table, form, mark), width)
    return _page(table, form, mark, standalone, longtable)


def rows(table: Table, form: Format, decimal: str | None = None) -> Iterator[str]:
    """Yield the text of a records format in pieces, for tables that need not fit in memory."""
    from kurbel.records import csv_rows, json_rows

    if form.name == "json":
        return json_rows(table)
    return csv_rows(table.records, form.decimal_name(table.lang, decimal))


def _page(table: Table, form: Format, mark: str, standalone: bool, longtable: bool) -> str:
    ready = page(table, form, mark)
    if form.name == "text" and not _own_template(table, form.name):
        return text_page(ready)
    values: dict[str, Any] = {"page": ready}
    if form.name == "latex":
        from kurbel.texwidth import tex_layout

        tex = tex_layout(page(table, by_name("text"), mark), ready)
        # A float longer than a page would run out of a document that has nothing else on it.
        values |= {"tex": tex, "longtable": longtable or (standalone and tex.tall)}
    if form.name == "typst":
        from kurbel.typstrows import typst_layout

        values |= {"typst": typst_layout(page(table, by_name("text"), mark))}
    fragment = _template(table, form.name, form.name).render(values)
    if standalone and form.document:
        return _template(table, form.name, f"{form.name}.document").render(
            values, fragment=fragment, title=form.escape(plain(table.caption, mark))
        )
    return fragment


def is_taller_than_a_page(table: Table) -> bool:
    """Tell whether the table, set by LaTeX, is too long for a float."""
    from kurbel.texwidth import tex_layout

    return tex_layout(*(page(table, by_name(name), ".") for name in ("text", "latex"))).tall


def _template(table: Table, format: str, name: str) -> Template:
    """Return the template of the layout, if it has its own, else the common one."""
    return _environment(format).get_template(_own_template(table, name) or f"base/{name}.jinja")


def _own_template(table: Table, name: str) -> str:
    own = f"{table.layout or table.key}/{name}.jinja"
    return own if os.path.exists(os.path.join(template_folder(), own)) else ""


# LaTeX is full of braces and percent signs.
_DELIMITERS: dict[str, dict[str, Any]] = {
    "latex": {
        "block_start_string": "<%",
        "block_end_string": "%>",
        "variable_start_string": "<<",
        "variable_end_string": ">>",
        "comment_start_string": "<#",
        "comment_end_string": "#>",
    }
}
# Typst has hash signs, braces and dollar signs, but no percent signs.
_DELIMITERS["typst"] = _DELIMITERS["latex"]


@cache
def _environment(name: str) -> Environment:
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    from kurbel.pipes import pipe_tables
    from kurbel.texwidth import blank_filled

    # No autoescape: every string of a page is finished text of its format, formulas included.
    environment = Environment(
        loader=FileSystemLoader(template_folder()),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        auto_reload=False,
        **_DELIMITERS.get(name, {}),
    )
    environment.filters.update(blank=blank, blank_filled=blank_filled, pipe_tables=pipe_tables)
    return environment
