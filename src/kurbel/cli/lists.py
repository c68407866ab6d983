"""`kurbel layouts` and `kurbel quantities`: what there is."""

from __future__ import annotations

import os
import shlex
from collections.abc import Mapping, Sequence

import click

from kurbel.cli import say
from kurbel.cli.listing import Listing, Shell, list_format, plain_lines, show_list
from kurbel.cli.options import click_option, lang_option
from kurbel.commands.parts.sheet import Layouts
from kurbel.page.axes import PHI, RATIO
from kurbel.page.layouts import Layout, layout, layout_file, layout_names
from kurbel.page.subjects import SUBJECTS
from kurbel.reading.given import File

LANG = lang_option("list")
HEADS: Mapping[str, Mapping[str, Sequence[str]]] = {
    "layouts": {
        "de": ("Layout", "Seite, und der Befehl, der sie druckt"),
        "en": ("layout", "page, and the command that prints it"),
    },
    "quantities": {
        "de": ("Spalte", "Größe", "Einheit", "Befehl"),
        "en": ("column", "quantity", "unit", "command"),
    },
}


COPY = click.Option(
    ["--copy"], nargs=2, metavar="LAYOUT DIR",
    help="Write a layout and the templates of its pages into a folder, to be changed.",
)  # fmt: skip


@click.command(params=[click_option(Layouts.layouts), COPY, list_format(), LANG])
def layouts(layouts: File | None, copy: tuple[str, str] | None, form: str, lang: str) -> None:
    """List the page layouts, each with a command that prints it, or copy one."""
    if copy is not None:
        from kurbel.formats.templates import copied

        name, folder = copy
        say(
            f"{copied(name, folder)} is a copy; --layouts {shlex.quote(folder)} takes it in place of kurbel's"
        )
        return
    found = [layout(name, layouts) for name in layout_names(layouts)]
    rows = [(one.key, one.title[lang], Shell(printing(one, layouts))) for one in found]
    entries = [(key, (title, command)) for key, title, command in rows]
    keys = ("layout", "title", "command")
    listing = Listing("layouts", lang, keys, rows, HEADS["layouts"][lang], entries)
    show_list(listing, form, plain_lines(rows))


def printing(layout: Layout, folder: File | None) -> str:
    """Return what prints the layout."""
    own = ("--layouts", str(folder)) if folder and os.path.exists(layout_file(folder, layout.key)) else ()
    sample = SUBJECTS[layout.subject].sample.partition(" --layout ")[0]
    return shlex.join(("kurbel", *sample.split(), *own, "--layout", layout.key))


@click.command(params=[list_format(), LANG])
def quantities(form: str, lang: str) -> None:
    """List the quantities that columns can show, with their units and the commands that print them."""
    from kurbel.page.subject import subject

    rows = [("ratio", RATIO[lang], "", "table"), ("phi", PHI[lang], "°", "table")]
    for about in map(subject, SUBJECTS):
        for one, command in about.entries():
            rows.append((one.key, about.name_of(one, lang), one.plain_unit(lang), command))
    keys = ("key", "name", "unit", "command")
    show_list(
        Listing("quantities", lang, keys, rows, HEADS["quantities"][lang], rows), form, plain_lines(rows)
    )
