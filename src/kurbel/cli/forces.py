"""`kurbel forces`: what a piston force, or the steam of an engine, calls up in rod, guide and crank pin."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from kurbel.cli.engine import engine_conditions, print_engine, steam_options
from kurbel.cli.machine import machine_option
from kurbel.cli.options import LayoutName, Name, output_options, typed
from kurbel.cli.table import chosen_angles, motion_options, print_motion
from kurbel.errors import ProblemError

if TYPE_CHECKING:
    from kurbel.engine_quantities import Load


@click.command()
@machine_option
@motion_options("forces", "phi,rod_force,guide_force,torque")
@click.option("--force", metavar="FORCE", help="Piston force, for columns in N and N m: 10kN.")
@steam_options
@click.option(
    "--bore", metavar="LENGTH", help="Bore of the cylinder, with --pressure for columns in N: 300mm."
)
@click.option("--pressure", metavar="PRESSURE", help="Steam pressure before cut-off: 8bar.")
@click.option(
    "--method",
    type=Name("method", lambda: ("exact", "series")),
    help="Motion of the piston of an engine: exact (default) or series.",
)
@click.option(
    "--layout",
    type=LayoutName(("motion", "turning")),
    help="Page layout; default: forces, or engine-forces with --eps or --card.",
)
@output_options
def forces(**options: Any) -> None:
    """Print the forces of the crank drive: rod, guide, tangential and radial force, torque.

    Per unit piston force, under a force of so many newtons, or over the turn of a steam engine.

    \b
    kurbel forces --ratio 1:5
    kurbel forces --ratio 1:5 --force 10kN --stroke 600mm
    kurbel forces --eps 4 --bore 300mm --pressure 8bar
    """  # fmt: skip
    if not engine_conditions(options):
        from kurbel.units import force

        for name in ("bore", "pressure"):
            if options[name] is not None and typed(name):
                raise ProblemError(f"--{name} is for the steam of an engine; add --eps or --card")
        options["layout"] = options["layout"] or "forces"
        print_motion(options, None if options["force"] is None else force(options["force"]))
        return
    for name in ("force", "offset", "stroke", "rod"):
        if options[name] is not None and typed(name):
            raise ProblemError(
                f"--{name} does not go with the steam of an engine, --eps or --card; leave it out"
            )
    from kurbel.layouts import layout_of

    name = options["layout"] or "engine-forces"
    angles = chosen_angles(layout_of(name, ("turning",)), options)
    options |= {"cranks": None, "method": (options["method"],) if options["method"] else ()}
    print_engine(options, name, ("turning",), angles=angles, load=_load(options))


def _load(options: dict[str, Any]) -> Load | None:
    if options["bore"] is None and options["pressure"] is None:
        return None
    if options["bore"] is None or options["pressure"] is None:
        raise ProblemError("newtons need both, --bore and --pressure")
    from fractions import Fraction

    from kurbel.engine_quantities import Load
    from kurbel.units import length, pressure

    return Load(length(options["bore"], "bore"), Fraction(pressure(options["pressure"], "pressure")))
