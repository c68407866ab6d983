"""`kurbel forces`: what a piston force calls up in rod, guide and crank pin."""

from __future__ import annotations

from typing import Any

import click

from kurbel.cli.options import layout_option, output_options
from kurbel.cli.table import motion_options, print_motion


@click.command()
@motion_options("forces", "phi,rod_force,guide_force,torque")
@click.option("--force", metavar="FORCE", help="Piston force, for columns in N and N m: 10kN.")
@layout_option("forces", "motion")
@output_options
def forces(**options: Any) -> None:
    """Print the forces of the crank drive: rod, guide, tangential and radial force, torque.

    \b
    kurbel forces --ratio 1:5
    kurbel forces --ratio 1:5 --force 10kN --stroke 600mm
    """  # fmt: skip
    from kurbel.units import force

    print_motion(options, None if options["force"] is None else force(options["force"]))
