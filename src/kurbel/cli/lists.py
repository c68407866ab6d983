"""`kurbel layouts` and `kurbel quantities`: what there is, a line each."""

from __future__ import annotations

import shlex
from collections.abc import Sequence

import click

from kurbel.cli.options import click_option, lang_option
from kurbel.commands.options import Parameter
from kurbel.commands.parameters import LAYOUTS
from kurbel.page.axes import PHI, RATIO
from kurbel.page.layouts import Layout, layout, layout_names
from kurbel.page.subjects import SUBJECTS
from kurbel.reading.given import File

LANG = lang_option("list")


@click.command(params=[click_option(Parameter("layouts", LAYOUTS, None, False)), LANG])
def layouts(layouts: File | None, lang: str) -> None:
    """List the page layouts, each with a command that prints it."""
    found = [layout(name, layouts) for name in layout_names(layouts)]
    _print([(one.key, one.title[lang], _printing(one, layouts)) for one in found])


def _printing(layout: Layout, folder: File | None) -> str:
    """Return what prints the layout."""
    own = ("--layouts", str(folder)) if layout.folder and folder else ()
    sample = SUBJECTS[layout.subject].sample.partition(" --layout ")[0]
    return shlex.join(("kurbel", *sample.split(), *own, "--layout", layout.key))


@click.command(params=[LANG])
def quantities(lang: str) -> None:
    """List the quantities that columns can show, with their units and the commands that print them."""
    from kurbel.page.subject import subject

    rows = [("ratio", RATIO[lang], "", "table"), ("phi", PHI[lang], "°", "table")]
    for about in map(subject, SUBJECTS):
        for one, command in about.entries():
            rows.append((one.key, about.name_of(one, lang), one.plain_unit(lang), command))
    _print(rows)


def _print(rows: Sequence[Sequence[str]]) -> None:
    from tabulate import tabulate

    click.echo(tabulate(rows, tablefmt="plain", disable_numparse=True))
