"""`kurbel solve`: the crank angles at which path, velocity, acceleration and the like fulfil a condition."""

from __future__ import annotations

from typing import Any

import click

from kurbel.cli.machine import machine_option
from kurbel.cli.mechanism import chosen_mechanism, mechanism_options
from kurbel.cli.options import Columns, in_order, layout_option, output_options, sheet_of
from kurbel.cli.table import LENGTHS, METHOD, RATIO
from kurbel.errors import ProblemError
from kurbel.page.layouts import Layout


@click.command()
@machine_option
@click.option(
    "--where",
    multiple=True,
    metavar="CONDITION",
    help='Condition: p=0, s=25% (share of the stroke), x=1.1, "x = 200 mm", "c = 3 m/s", c=max, p=min,'
    ' "p = 1/6 of dead centre", psi=5; repeated for several.',
)
@RATIO
@click.option(
    "--columns",
    type=Columns("solve"),
    multiple=True,
    metavar="NAMES",
    help="Columns and their order: stroke,phi,phi_turn,x,c,p. Pages keep the stroke and φ at the left.",
)
@in_order(LENGTHS)
@METHOD
@click.option("--speed", metavar="SPEED", help="Speed, for columns in m/s and m/s²: 120/min, 12.5rad/s.")
@mechanism_options
@layout_option("solve", "roots")
@output_options
def solve(**options: Any) -> None:
    """Print all crank angles of the turn at which a condition holds, on both strokes.

    Path, velocity and acceleration count on either stroke from the dead centre where it begins, in its
    direction; max and min are those of each stroke.

    \b
    kurbel solve --ratio 1:5 --method series --where p=0
    kurbel solve --ratio '1:4;1:5' --where s=25% --where c=max
    kurbel solve --stroke 600mm --rod 1500mm --speed 120/min --where "c = 3 m/s"
    kurbel solve --ratio 1:5 --mechanism arc --rocker 6 --where acceleration=0
    """  # fmt: skip
    from kurbel.cli.printing import Printing, print_table
    from kurbel.page.layouts import layout_of
    from kurbel.reading.where import read_condition
    from kurbel.solve.page import SolveRequest

    page = layout_of(options["layout"], ("roots",))
    name, options = chosen_mechanism({**options, "layout": None})
    if name == "parallel":
        raise ProblemError(
            "the rod of the parallel crank moves as the piston with a rod of infinite length;"
            " use --method infinite"
        )
    printing = Printing.chosen(options)
    drives = _arc_drives(page, options) if name == "arc" else _slide_drives(page, options)
    conditions = tuple(dict.fromkeys(read_condition(text, drives[0].names) for text in options["where"]))
    request = SolveRequest(
        layout=page, drives=drives, conditions=conditions, **sheet_of(options, "stroke,phi,x")
    )
    print_table(request, printing)


def _slide_drives(page: Layout, options: dict[str, Any]) -> Any:
    from kurbel.cli.table import cranks_of
    from kurbel.motion.drives import slide_drives

    return slide_drives(cranks_of(page, options), options["method"] or "exact")


def _arc_drives(page: Layout, options: dict[str, Any]) -> Any:
    from kurbel.cli.linkage import arc_cranks
    from kurbel.linkage.arc_drive import ArcDrive

    return tuple(ArcDrive(crank) for crank in arc_cranks(page, options))
