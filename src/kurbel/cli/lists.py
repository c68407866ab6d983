"""`kurbel layouts` and `kurbel quantities`: what there is, a line each."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from typing import TYPE_CHECKING

import click

from kurbel.cli.options import Name, click_option
from kurbel.commands.options import Parameter
from kurbel.commands.parameters import LAYOUTS
from kurbel.page.layouts import LANGUAGES

if TYPE_CHECKING:
    from kurbel.page.layouts import Layout
    from kurbel.reading.files import File

lang_option = click.option(
    "--lang", type=Name("language", lambda: LANGUAGES), default="de", show_default=True, envvar="KURBEL_LANG",
    help="Language of the list: de or en.",
)  # fmt: skip


@click.command(params=[click_option(Parameter("layouts", LAYOUTS, None, False))])
@lang_option
def layouts(layouts: File | None, lang: str) -> None:
    """List the page layouts, each with a command that prints it."""
    from kurbel.page.layouts import layout, layout_names

    found = [layout(name, layouts) for name in layout_names(layouts)]
    _print([(one.key, one.title[lang], _printing(one, layouts)) for one in found])


def _printing(layout: Layout, folder: File | None) -> str:
    """Return what prints the layout."""
    from kurbel.page.subject import subject

    about = subject(layout.subject)
    own = ("--layouts", str(folder)) if layout.folder and folder else ()
    return shlex.join(("kurbel", *(about.sample or about.command).split(), *own, "--layout", layout.key))


@click.command()
@lang_option
def quantities(lang: str) -> None:
    """List the quantities that columns can show, with their units and the commands that print them."""
    from kurbel.balance.harmonics_page import quantities as harmonics_registry
    from kurbel.balance.request import balance_registry
    from kurbel.engine.page import printed_by
    from kurbel.engine.quantities import engine_registry
    from kurbel.linkage.beam import registry as beam_registry
    from kurbel.linkage.quantities import arc_registry, page_command, parallel_registry
    from kurbel.motion.evaluation import NEEDS
    from kurbel.motion.inertia import inertia_registry
    from kurbel.motion.inertia_page import error_columns
    from kurbel.motion.quantities import registry
    from kurbel.page.axes import PHI, RATIO
    from kurbel.page.labels import plain
    from kurbel.solve.page import own_columns

    rows = [("ratio", RATIO[lang], "", "table"), ("phi", PHI[lang], "°", "table")]
    for key, quantity in registry().items():
        options = " ".join(("table", *NEEDS[quantity.needs]))
        rows.append((key, quantity.full_name(lang), quantity.plain_unit(lang), options))
    for key, one in engine_registry().items():
        name = f"{one.name[lang]} {plain(one.symbol)}"
        rows.append((key, name, one.plain_unit(lang), printed_by(one)))
    for key, beam in beam_registry().items():
        rows.append((key, f"{beam.name[lang]} {plain(beam.symbol)}", beam.plain_unit(lang), "deadcentres"))
    for key, harmonic in harmonics_registry().items():
        name = f"{harmonic.name[lang]} {plain(harmonic.symbol)}"
        rows.append(("value", name, harmonic.plain_unit(lang), f"harmonics --quantity {key}"))
    for key, column in balance_registry().items():
        rows.append((key, column.name[lang], column.plain_unit(lang), "balance"))
    for mechanism, linkage in (("arc", arc_registry()), ("parallel", parallel_registry())):
        for key, motion in linkage.items():
            command = f"{page_command(motion)} --mechanism {mechanism}"
            options = " ".join((command, *NEEDS[motion.needs]))
            rows.append((key, motion.full_name(lang), motion.plain_unit(lang), options))
    for key, force in inertia_registry().items():
        options = " ".join(("inertia", *NEEDS[force.needs]))
        rows.append((key, force.full_name(lang), force.unit[lang], options))
    for key, error in error_columns().items():
        rows.append((key, error.full_name(lang), error.plain_unit(lang), "inertia --layout inertia-errors"))
    for key, names in own_columns().items():
        rows.append((key, names[lang], "°" if key.startswith("phi") else "", "solve"))
    _print(rows)


def _print(rows: Sequence[Sequence[str]]) -> None:
    from tabulate import tabulate

    click.echo(tabulate(rows, tablefmt="plain", disable_numparse=True))
