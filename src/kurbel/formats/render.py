"""From a table to text in a format. With `sandbox` the only module that knows Jinja; templates only
arrange.

A format that is written without templates saves the first table on a terminal the third of its time that
loading Jinja takes.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from functools import cache
from typing import TYPE_CHECKING, Any

from kurbel.errors import ChoiceError
from kurbel.formats.page import blank, page
from kurbel.formats.registry import PageFormat, RecordsFormat, by_name
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
    documents; `longtable` lets a table break over pages, in the formats where it would not. JSON has only
    points. Plain text goes on in further panels where it would be wider than `width` characters.

    `templates` is a folder whose templates outdo ours of the same names; by default it is the one that the
    table's layout lies in, if that is the user's. They run in a sandbox; one that cannot be used is a
    LayoutError with its line.
    """
    form, templates = by_name(format), templates or table.templates or None
    if isinstance(form, RecordsFormat):
        return "".join(form.writer.rows(table, form.decimal_name(table.lang, decimal)))
    if not isinstance(form, PageFormat):
        raise ChoiceError(f"a {form.name} is bytes and no text; make it with kurbel.typeset_{form.name}")
    mark, writer = form.decimal_mark(table.lang, decimal), form.writer
    if not _own_template(table, form.name, templates):
        written = writer.written(table, mark, width)
        if written is not None:
            return written
    ready = page(table, writer, mark)
    values = {"page": ready, **writer.values(table, ready, mark, longtable, standalone)}

    def filled(name: str, more: dict[str, str]) -> str:
        template = _own_template(table, name, templates) or f"base/{name}.jinja"
        return _filled(form, template, values | more, templates)

    fragment = filled(form.name, {})
    if standalone and form.standalone:
        title = writer.escape(plain(table.caption, mark))
        return filled(f"{form.name}.document", {"fragment": fragment, "title": title})
    return fragment


def render_document(
    form: PageFormat, name: str, values: Mapping[str, object], templates: str | None = None
) -> str:
    """Return what a template for whole documents, such as "index" in Markdown, makes of the values.

    `templates` is a folder of the user's, as in `render`.
    """
    return _filled(form, f"base/{name}.{form.name}.jinja", values, templates)


def _filled(form: PageFormat, template: str, values: Mapping[str, object], templates: str | None) -> str:
    if templates is None:
        return _environment(form).get_template(template).render(values)
    from kurbel.formats.sandbox import filled

    return filled(_sandbox(form, templates), template, values, templates)


def _own_template(table: Table, name: str, templates: str | None) -> str:
    """Return the template of the layout, if it has its own, here or in the user's folder."""
    own = f"{table.layout or table.key}/{name}.jinja"
    folders = [template_folder(), *([templates] if templates else [])]
    if any(os.path.exists(os.path.join(folder, own)) for folder in folders):
        return own
    return f"base/{name}.jinja" if templates and os.path.exists(f"{templates}/base/{name}.jinja") else ""


@cache
def _environment(form: PageFormat) -> Environment:
    from jinja2 import ChoiceLoader, Environment, FileSystemLoader, PrefixLoader

    own = PrefixLoader({"base": FileSystemLoader(form.templates)})
    loader = ChoiceLoader([own, FileSystemLoader(template_folder())])
    return _prepared(Environment, form, auto_reload=False, loader=loader)


@cache
def _sandbox(form: PageFormat, templates: str) -> Environment:
    from kurbel.formats.sandbox import Folders, Sandbox

    return _prepared(Sandbox, form, loader=Folders(templates, {"base": form.templates}))


def _prepared(kind: type[Environment], form: PageFormat, **options: Any) -> Environment:
    from jinja2 import StrictUndefined

    # No autoescape: every string of a page is finished text of its format, formulas included.
    environment = kind(
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        **form.writer.delimiters,
        **options,
    )
    environment.filters.update(blank=blank, **form.writer.filters())
    return environment
