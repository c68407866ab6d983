"""A part of a handbook is made: its command's words become the files of a table or of a drawing."""

from __future__ import annotations

import os
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from kurbel.errors import KurbelError
from kurbel.formats.registry import FORMATS
from kurbel.handbook.parts import GIGABYTES, Made, Task

if TYPE_CHECKING:
    from kurbel.cli.asking import Asked
    from kurbel.commands.shown import Drawing
    from kurbel.page.table import Table


def make_part(task: Task) -> Made | str:
    """Return the files of the part, or in a sentence why it cannot be made.

    It is made in the manifest's folder, beside which the files lie that its command names.
    """
    from kurbel.cli.asking import asked
    from kurbel.page.table import Table

    part = task.part
    try:
        answer = asked(part.words, {**part.options, "label": part.name}, task.machine, folder=task.folder)
        if answer.code:
            return "the command ends with 1, for printed values deviate and it is strict"
        made = answer.made
        return _table(task, answer, made) if isinstance(made, Table) else _figure(task, answer, made)
    except KurbelError as error:
        return str(error)


def _table(task: Task, answer: Asked, table: Table) -> Made:
    from kurbel.handbook.pool import deadline

    part = task.part
    named = replace(
        table, key=part.name, layout=table.layout or table.key, caption=part.caption or table.caption
    )
    templates = task.templates and os.path.join(task.folder, task.templates)
    with deadline(task.patience, GIGABYTES, bool(templates or named.templates)):
        files = {
            f"tables/{part.name}{FORMATS[name].suffixes[0]}": _text(named, name, answer.decimal, templates)
            for name in task.formats
        }
    return Made(files, answer.files, ("table", named.caption, named.lang))


def _text(table: Any, name: str, decimal: str | None, templates: str | None) -> bytes:
    from kurbel.formats.render import render

    if FORMATS[name].kind == "records":
        # Data keep the point, so that programs need not know the language of the page.
        return render(table, name).encode()
    longtable = FORMATS[name].is_tall(table)
    return render(table, name, decimal=decimal, longtable=longtable, templates=templates).encode()


def _figure(task: Task, answer: Asked, drawing: Drawing) -> Made:
    part = task.part
    caption = part.caption or drawing.title
    titled = replace(drawing, title=caption)
    files = {f"figures/{part.name}.{name}": titled.image(name) for name in task.figures}
    return Made(files, answer.files, ("figure", caption, answer.lang))
