"""`kurbel deadcentres`: the dead centres of the beam engine."""

from __future__ import annotations

from typing import Any

import click

from kurbel.cli.options import Columns, layout_option, output_options, sheet_of
from kurbel.reading import notation


@click.command()
@click.option(
    "--beam",
    multiple=True,
    metavar="A:R",
    help="Arm of the beam in crank radii: 3; lists 3;4, ranges 3..6:0.5.",
)
@click.option(
    "-r", "--ratio", multiple=True, metavar="R:L", help="Crank ratio: 1:5; lists and ranges 1:3..6."
)
@click.option(
    "--exact", is_flag=True, help="From the true geometry of the linkage; default: the formulas of § 149."
)
@click.option(
    "--columns",
    type=Columns("weisbach-149"),
    multiple=True,
    metavar="NAMES",
    help="Columns and their order: mu,nu,path_1.",
)
@layout_option("weisbach-149", "dead centres")
@output_options
def deadcentres(**options: Any) -> None:
    """Print the dead centres of a beam engine: angles μ and ν of the rod, their distance, the small paths.

    \b
    kurbel deadcentres --beam 3 --ratio 1:5
    kurbel deadcentres --beam 3 --ratio 1:5 --exact
    """  # fmt: skip
    from kurbel.cli.printing import Printing, print_table
    from kurbel.linkage.beam_page import BeamRequest
    from kurbel.page.layouts import layout_of

    printing = Printing.chosen(options)
    page = layout_of(options["layout"], ("dead centres",))
    request = BeamRequest(
        layout=page,
        arms=notation.numbers(options["beam"] or page.arms, "beam arm"),
        ratios=notation.ratios(options["ratio"] or page.ratios),
        exact=options["exact"],
        **sheet_of(options, "mu,nu"),
    )
    print_table(request, printing)
