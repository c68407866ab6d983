"""From a table to text in a format. The only module that knows Jinja; templates only arrange."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kurbel.errors import LayoutError
from kurbel.formats import Format, by_name
from kurbel.labels import plain
from kurbel.page import blank, page
from kurbel.pipes import pipe_tables
from kurbel.table import Table
from kurbel.textgrid import grid_of, panel_lines, wrapped
from kurbel.texwidth import blank_filled, tex_layout

if TYPE_CHECKING:
    from jinja2 import Environment, Template


def render(
    table: Table,
    format: str,
    *,
    decimal: str | None = None,
    standalone: bool = False,
    longtable: bool = False,
) -> str:
    """Return the table as text in the named format.

    `decimal` is "comma" or "point"; by default it follows the language of the table, and is a point in CSV
    and JSON. `standalone` makes a document of what is otherwise a fragment, in the formats that have
    documents; `longtable` lets a LaTeX table break over pages. JSON has only points.
    """
    form = by_name(format)
    if form.kind == "records":
        return "".join(rows(table, form, decimal))
    return _page(table, form, form.decimal_mark(table.lang, decimal), standalone, longtable)


def rows(table: Table, form: Format, decimal: str | None = None) -> Iterator[str]:
    """Yield the text of a records format in pieces, for tables that need not fit in memory."""
    from kurbel.records import csv_rows, json_rows

    if form.name == "json":
        return json_rows(table)
    return csv_rows(table.records, form.decimal_name(table.lang, decimal))


def _page(table: Table, form: Format, mark: str, standalone: bool, longtable: bool) -> str:
    values: dict[str, Any] = {"page": page(table, form, mark)}
    if form.name == "text":
        values["grid"] = grid_of(values["page"])
    if form.name == "latex":
        tex = tex_layout(page(table, by_name("text"), mark))
        # A float longer than a page would run out of a document that has nothing else on it.
        values |= {"tex": tex, "longtable": longtable or (standalone and tex.tall)}
    fragment = _template(table, form.name, form.name).render(values)
    if standalone and form.document:
        return _template(table, form.name, f"{form.name}.document").render(
            values, fragment=fragment, title=form.escape(plain(table.caption, mark))
        )
    return fragment


def _template(table: Table, format: str, name: str) -> Template:
    """Return the template of the layout, if it has its own, else the common one."""
    folder = table.layout or table.key
    return _environment(format).select_template([f"{folder}/{name}.jinja", f"base/{name}.jinja"])


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


@cache
def _environment(name: str) -> Environment:
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    # No autoescape: every string of a page is finished text of its format, formulas included.
    environment = Environment(
        loader=FileSystemLoader(templates_folder()),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        auto_reload=False,
        **_DELIMITERS.get(name, {}),
    )
    environment.filters.update(
        blank=blank,
        blank_filled=blank_filled,
        panel_lines=panel_lines,
        pipe_tables=pipe_tables,
        wrapped=wrapped,
    )
    return environment


def templates_folder() -> Path:
    """Return the folder of the templates: in the installed package, else in the checkout."""
    here = Path(__file__).resolve().parent
    for folder in (here / "templates", here.parent.parent / "templates"):
        if (folder / "base").is_dir():
            return folder
    raise LayoutError(f"no templates found beside {here}; the installation is not complete")
