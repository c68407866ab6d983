"""`kurbel forces`: what a piston force, or the steam of an engine, calls up in rod, guide and crank pin."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

import click

from kurbel import notation
from kurbel.cli.engine import STEAM_NAMES, engine_conditions, print_engine, steam_options
from kurbel.cli.machine import machine_option
from kurbel.cli.masses import MASSES, MOVING, SIZE
from kurbel.cli.options import LayoutName, Name, in_order, output_options, sheet_of, typed, without_outdone
from kurbel.cli.table import RIVALS, chosen_angles, cranks_of, motion_options, print_motion
from kurbel.errors import ProblemError

OF_ENGINES = ("crank forces", "machine")
POSITIONS = ("tangent",)


@click.command()
@machine_option
@motion_options("forces", "phi,rod_force,guide_force,torque")
@click.option("--force", metavar="FORCE", help="Piston force, for columns in N and N m: 10kN.")
@click.option(
    "--at",
    type=Name("position", lambda: POSITIONS),
    help="tangent: a sheet of the position in which the rod touches the crank circle, with closed forms.",
)
@steam_options
@in_order(SIZE)
@in_order(MOVING)
@click.option(
    "--rotating",
    metavar="MASS",
    help="Mass of the crank itself at its pin, for the main bearing: 60kg; -40kg if counterweights outweigh.",
)
@click.option("--speed", metavar="SPEED", help="Speed, for the masses: 120/min, 12.5rad/s.")
@click.option(
    "--method",
    type=Name("method", lambda: ("exact", "series")),
    help="Motion of the piston of an engine: exact (default) or series.",
)
@click.option(
    "--layout",
    type=LayoutName(("motion", *OF_ENGINES, "tangent")),
    help="Page layout; default: forces; with --eps or --card engine-forces, and with masses machine-forces.",
)
@output_options
def forces(**options: Any) -> None:
    """Print the forces of the crank drive: rod, guide, tangential and radial force, torque.

    Per unit piston force, under a force of so many newtons, or over the turn of a steam engine.

    \b
    kurbel forces --ratio 1:5
    kurbel forces --ratio 1:5 --force 10kN --stroke 600mm
    kurbel forces --ratio 1:5 --at tangent
    kurbel forces --eps 4 --bore 300mm --pressure 8bar
    kurbel forces --machine engine.toml
    """  # fmt: skip
    _subject(options)(options)


def _subject(options: Mapping[str, Any]) -> Any:
    from kurbel.layouts import layout

    page = options["layout"] and layout(options["layout"])
    if options["at"] is not None or (page and page.subject == "tangent"):
        return _print_tangent
    return _print_engine if engine_conditions(options) else _print_unit


def _print_unit(options: dict[str, Any]) -> None:
    _refuse(options, ("bore", "pressure", *MASSES), "is for the steam of an engine; add --eps or --card")
    print_motion({**options, "layout": options["layout"] or "forces"}, _newtons(options))


def _print_engine(options: dict[str, Any]) -> None:
    from kurbel.layouts import layout_of

    if options["offset"] is not None and notation.number(options["offset"], "offset"):
        raise ProblemError("the steam engine has a straight crank, and an offset was given; leave it out")
    without = "does not go with the steam of an engine, --eps or --card; leave it out"
    _refuse(options, ("force", "rod"), without)
    heavy = any(options[name] is not None for name in MASSES)
    name = options["layout"] or ("machine-forces" if heavy else "engine-forces")
    angles = chosen_angles(layout_of(name, OF_ENGINES), options)
    options |= {"cranks": None, "method": (options["method"],) if options["method"] else ()}
    print_engine(options, name, OF_ENGINES, angles=angles)


def _print_tangent(options: dict[str, Any]) -> None:
    from kurbel.cli.printing import Printing, print_table
    from kurbel.layouts import layout_of
    from kurbel.tangent_page import TangentRequest

    options = without_outdone(options, RIVALS)
    page = layout_of(options["layout"] or "forces-tangent", ("tangent",))
    own = "does not go with --at tangent, a position with an angle of its own; leave it out"
    _refuse(options, ("angle", "from", "to", "step"), own)
    about = "does not go with --at tangent, a position under one piston force, --force; leave it out"
    _refuse(options, (*STEAM_NAMES, *MASSES, "bore", "pressure"), about)
    force, printing = _newtons(options), Printing.chosen(options)
    request = TangentRequest(
        layout=page,
        cranks=tuple(replace(crank, force=force) for crank in cranks_of(page, options)),
        **sheet_of(options, "phi,rod_force"),
    )
    print_table(request, printing)


def _refuse(options: Mapping[str, Any], names: tuple[str, ...], why: str) -> None:
    for name in names:
        if options[name] not in (None, ()) and typed(name):
            raise ProblemError(f"--{name.replace('_', '-')} {why}")


def _newtons(options: Mapping[str, Any]) -> Fraction | None:
    from kurbel.units import force

    return None if options["force"] is None else force(options["force"])
