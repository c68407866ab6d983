"""From a table to text in a format. With `sandbox` the only module that knows Jinja; templates only
arrange.

Plain text needs no template, for its grid is all there is to it: that saves the first table on a terminal
the third of its time that loading Jinja takes.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from functools import cache
from typing import TYPE_CHECKING, Any

from kurbel.errors import ChoiceError
from kurbel.formats.page import blank, page
from kurbel.formats.registry import Format, by_name
from kurbel.formats.textgrid import grid_of, text_page
from kurbel.page.labels import plain
from kurbel.page.layouts import template_folder
from kurbel.page.table import Table

if TYPE_CHECKING:
    from jinja2 import Environment


def render(
    table: Table,
    format: str,
    *,
    decimal: str | None = None,
    standalone: bool = False,
    longtable: bool = False,
    width: int | None = None,
    templates: str | None = None,
) -> str:
    """Return the table as text in the named format.

    `decimal` is "comma" or "point"; by default it follows the language of the table, and is a point in CSV
    and JSON. `standalone` makes a document of what is otherwise a fragment, in the formats that have
    documents; `longtable` lets a LaTeX table break over pages. JSON has only points. Plain text goes on in
    further panels where it would be wider than `width` characters.

    `templates` is a folder whose templates outdo ours of the same names. They run in a sandbox; one that
    cannot be used is a LayoutError with its line.
    """
    form = by_name(format)
    if form.kind == "compiled":
        raise ChoiceError(f"a {form.name} is bytes and no text; make it with kurbel.typeset_{form.name}")
    if form.kind == "records":
        return "".join(rows(table, form, decimal))
    mark = form.decimal_mark(table.lang, decimal)
    if form.name == "text" and width is not None:
        from kurbel.formats.narrow import narrowed

        table = narrowed(table, lambda parted: grid_of(page(parted, form, mark)).total <= width)
        return text_page(page(table, form, mark), width)
    return _page(table, form, mark, standalone, longtable, templates)


def rows(table: Table, form: Format, decimal: str | None = None) -> Iterator[str]:
    """Yield the text of a records format in pieces, for tables that need not fit in memory."""
    from kurbel.formats.records import csv_rows, json_rows

    if form.name == "json":
        return json_rows(table)
    return csv_rows(table.records, form.decimal_name(table.lang, decimal))


def _page(
    table: Table, form: Format, mark: str, standalone: bool, longtable: bool, templates: str | None
) -> str:
    ready = page(table, form, mark)
    if form.name == "text" and not _own_template(table, form.name, templates):
        return text_page(ready)
    values: dict[str, Any] = {"page": ready}
    if form.name == "latex":
        from kurbel.formats.texwidth import tex_layout

        tex = tex_layout(page(table, by_name("text"), mark), ready)
        # A float longer than a page would run out of a document that has nothing else on it.
        values |= {"tex": tex, "longtable": longtable or (standalone and tex.tall)}
    if form.name == "typst":
        from kurbel.formats.typstrows import typst_layout

        values |= {"typst": typst_layout(page(table, by_name("text"), mark), ready)}

    def filled(name: str, more: dict[str, str]) -> str:
        template = _own_template(table, name, templates) or f"base/{name}.jinja"
        return _filled(form.name, template, values | more, templates)

    fragment = filled(form.name, {})
    if standalone and form.document:
        title = form.escape(plain(table.caption, mark))
        return filled(f"{form.name}.document", {"fragment": fragment, "title": title})
    return fragment


def render_document(
    format: str, name: str, values: Mapping[str, object], templates: str | None = None
) -> str:
    """Return what a template for whole documents, such as "index" in Markdown, makes of the values.

    `templates` is a folder of the user's, as in `render`.
    """
    return _filled(format, f"base/{name}.{format}.jinja", values, templates)


def _filled(format: str, template: str, values: Mapping[str, object], templates: str | None) -> str:
    if templates is None:
        return _environment(format).get_template(template).render(values)
    from kurbel.formats.sandbox import filled

    return filled(_sandbox(format, templates), template, values, templates)


def is_taller_than_a_page(table: Table) -> bool:
    """Tell whether the table, set by LaTeX, is too long for a float."""
    from kurbel.formats.texwidth import tex_layout

    return tex_layout(*(page(table, by_name(name), ".") for name in ("text", "latex"))).tall


def _own_template(table: Table, name: str, templates: str | None) -> str:
    """Return the template of the layout, if it has its own, here or in the user's folder."""
    own = f"{table.layout or table.key}/{name}.jinja"
    folders = [template_folder(), *([templates] if templates else [])]
    if any(os.path.exists(os.path.join(folder, own)) for folder in folders):
        return own
    return f"base/{name}.jinja" if templates and os.path.exists(f"{templates}/base/{name}.jinja") else ""


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
    from jinja2 import Environment, FileSystemLoader

    return _prepared(Environment, name, auto_reload=False, loader=FileSystemLoader(template_folder()))


@cache
def _sandbox(name: str, templates: str) -> Environment:
    from kurbel.formats.sandbox import Folders, Sandbox

    return _prepared(Sandbox, name, loader=Folders(templates))


def _prepared(kind: type[Environment], name: str, **options: Any) -> Environment:
    from jinja2 import StrictUndefined

    from kurbel.formats.pipes import pipe_tables
    from kurbel.formats.texwidth import blank_filled

    # No autoescape: every string of a page is finished text of its format, formulas included.
    environment = kind(
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        **_DELIMITERS.get(name, {}),
        **options,
    )
    environment.filters.update(blank=blank, blank_filled=blank_filled, pipe_tables=pipe_tables)
    return environment
