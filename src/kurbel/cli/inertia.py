"""`kurbel inertia`: forces of the moving connecting rod, exact and by the masses that stand in for it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import click

from kurbel.cli.machine import machine_option
from kurbel.cli.masses import rod_of, rod_options
from kurbel.cli.options import layout_option, output_options, sheet_of, without_outdone
from kurbel.cli.table import RIVALS, cranks_of, motion_options, motion_request
from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.page.layouts import Layout, layout_of

if TYPE_CHECKING:
    from kurbel.motion.inertia_page import ErrorsRequest

SUBJECTS = ("inertia", "inertia errors")


@click.command()
@machine_option
@motion_options("inertia", "phi,inertia_guide,inertia_pin")
@rod_options
@click.option("--speed", metavar="SPEED", help="Speed, for columns in N and N m: 120/min, 12.5rad/s.")
@layout_option("inertia", *SUBJECTS)
@output_options
def inertia(**options: Any) -> None:
    """Print the forces that the moving rod calls up at guide and crank pin, and the torque.

    Exact, by two masses at the pins that keep the centre of mass, and by the railway rule, 6/10 of the mass
    rotating and 4/10 reciprocating. Layout inertia-errors has the greatest forces and errors of a turn.

    \b
    kurbel inertia --ratio 1:5 --centre 0.65 --gyration 0.35
    kurbel inertia --rod-file rod.csv --stroke 600mm --speed 120/min
    kurbel inertia --centre 0.65 --gyration 0.35 --layout inertia-errors
    """  # fmt: skip
    from kurbel.cli.printing import Printing, print_table

    options = without_outdone(options, RIVALS)
    page = layout_of(options["layout"], SUBJECTS)
    printing = Printing.chosen(options)
    cranks = _cranks(page, options)
    if page.subject == "inertia":
        print_table(motion_request(page, cranks, options), printing)
        return
    print_table(_errors(page, cranks, options), printing)


def _errors(page: Layout, cranks: tuple[Crank, ...], options: dict[str, Any]) -> ErrorsRequest:
    from kurbel.motion.inertia_page import ErrorsRequest

    for name in ("angle", "from", "to", "step"):
        if options[name]:
            raise ProblemError(f"layout {page.key} is of the whole turn; leave --{name} out")
    return ErrorsRequest(
        layout=page,
        cranks=cranks,
        **sheet_of(options, "greatest,error_percent"),
    )


def _cranks(page: Layout, options: dict[str, Any]) -> tuple[Crank, ...]:
    return tuple(replace(crank, rod=rod_of(options, crank.rod_length)) for crank in cranks_of(page, options))
