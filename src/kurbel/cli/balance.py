"""`kurbel harmonics` and `kurbel balance`: the piston's harmonics, and what engines leave unbalanced."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

from kurbel.balance.arrangement import usual
from kurbel.balance.harmonics import HARMONICS, MOST_ORDERS
from kurbel.cli.machine import machine_option
from kurbel.cli.options import Columns, Count, Name, layout_option, output_options, sheet_of, without_outdone
from kurbel.motion.evaluation import METHODS
from kurbel.reading import notation

Command = TypeVar("Command", bound=Callable[..., Any])
# What gives way, where it only comes from the environment, to what is typed.
RIVALS = (("engine", {"cranks"}), ("cranks", {"engine"}), ("positions", {"engine"}), ("banks", {"engine"}))

ratio_option = click.option(
    "-r", "--ratio", multiple=True, metavar="R:L",
    help="Crank ratio: 1:5; lists 1:4;1:5 and ranges 1:3..6:0.5.",
)  # fmt: skip
method_option = click.option(
    "--method", type=Name("method", lambda: METHODS), default="exact", show_default=True,
    help="exact, series (first order in λ) or infinite (rod of infinite length).",
)  # fmt: skip


def orders_option(default: int) -> Callable[[Command], Command]:
    return click.option(
        "--orders", type=Count("orders", 1, MOST_ORDERS), metavar="N", default=default, show_default=True,
        help=f"Orders up to N, 1 to {MOST_ORDERS}; odd ones above 1 are 0 and left out.",
    )  # fmt: skip


@click.command()
@machine_option
@ratio_option
@click.option(
    "--quantity",
    type=Name("quantity", lambda: HARMONICS),
    help="x (path), c (velocity) or p (acceleration, default).",
)
@orders_option(6)
@method_option
@layout_option("harmonics", "harmonics")
@output_options
def harmonics(**options: Any) -> None:
    """Print the harmonics of the piston's motion: coefficients of cos φ, cos 2φ, cos 4φ, ...

    \b
    kurbel harmonics --ratio 1:5
    kurbel harmonics --ratio '1:4;1:5' --quantity x --orders 10 --digits 12
    """  # fmt: skip
    from kurbel.balance.harmonics_page import HarmonicsRequest
    from kurbel.cli.printing import Printing, print_table
    from kurbel.page.layouts import layout_of

    printing = Printing.chosen(options)
    page = layout_of(options["layout"], ("harmonics",))
    request = HarmonicsRequest(
        layout=page,
        ratios=notation.ratios(options["ratio"] or page.ratios),
        quantity=options["quantity"] or "",
        last_order=options["orders"],
        method=options["method"],
        **sheet_of(options),
    )
    print_table(request, printing)


@click.command()
@machine_option
@click.option(
    "--engine",
    type=Name("engine", usual),
    help="inline-1, inline-2-180, inline-2-360, inline-3 to inline-6, v2-90, v6-90, v8-90, v12-60, boxer-2,"
    " boxer-4; default: inline-4.",
)
@click.option(
    "--cranks",
    metavar="ANGLES",
    help="Another engine: the crank of every cylinder, 0;180;180;0.",
)
@click.option(
    "--positions",
    metavar="NUMBERS",
    help="Where its cylinders lie along the shaft: 0;1;2;3, which is the default.",
)
@click.option(
    "--banks", metavar="ANGLES", help="Directions of its cylinders, counted as the cranks: -45;45; default 0."
)
@click.option(
    "--share",
    metavar="SHARE",
    default="0",
    show_default=True,
    help="Share of each reciprocating mass that counterweights balance: 0.5, 50%.",
)
@ratio_option
@orders_option(2)
@method_option
@click.option(
    "--columns",
    type=Columns("balance"),
    multiple=True,
    metavar="NAMES",
    help="Columns and their order: order,along,forward; `kurbel quantities` lists them.",
)
@layout_option("balance", "balance")
@output_options
def balance(**options: Any) -> None:
    """Print the free forces and moments of an engine by orders.

    \b
    kurbel balance --engine inline-4 --ratio 1:4
    kurbel balance --engine v2-90 --share 0.5 --orders 6
    kurbel balance --cranks '0;0;90;90' --positions '0;0;1;1' --banks '-45;45;-45;45'
    """  # fmt: skip
    from kurbel.balance.request import BalanceRequest, arranged
    from kurbel.cli.printing import Printing, print_table
    from kurbel.page.layouts import layout_of

    options = without_outdone(options, RIVALS)
    printing = Printing.chosen(options)
    page = layout_of(options["layout"], ("balance",))
    engine, arrangement = arranged(
        options["engine"],
        () if options["cranks"] is None else notation.crank_angles(options["cranks"]),
        () if options["positions"] is None else notation.each_number([options["positions"]], "position"),
        () if options["banks"] is None else notation.crank_angles(options["banks"]),
        notation.share(options["share"], "share"),
    )
    request = BalanceRequest(
        layout=page,
        arrangement=arrangement,
        ratios=notation.ratios(options["ratio"] or page.ratios),
        engine=engine,
        last_order=options["orders"],
        method=options["method"],
        **sheet_of(options, "order,along"),
    )
    print_table(request, printing)
