"""`kurbel forces`: what a piston force, or the steam of an engine, calls up in rod, guide and crank pin."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

import click

from kurbel.cli.engine import CRANKS, STEAM_NAMES, engine_conditions, print_engine, steam_options
from kurbel.cli.machine import machine_option
from kurbel.cli.masses import MASSES, MOVING, ROTATING, SIZE, is_heavy, with_masses
from kurbel.cli.options import (
    LayoutName,
    Name,
    in_order,
    output_options,
    sheet_of,
    typed,
    without_outdone,
)
from kurbel.cli.printing import Printing, print_table
from kurbel.cli.table import RIVALS, chosen_angles, cranks_of, motion_options, motion_request
from kurbel.errors import ProblemError
from kurbel.page.layouts import layout_of
from kurbel.reading import notation

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
@CRANKS
@in_order(SIZE)
@in_order(MOVING)
@ROTATING
@click.option("--speed", metavar="SPEED", help="Speed, for the masses: 120/min, 12.5rad/s.")
@click.option(
    "--layout",
    type=LayoutName(("motion", *OF_ENGINES, "tangent")),
    help="Page layout; default: forces; with --eps or --card engine-forces, and with masses machine-forces.",
)
@output_options
def forces(**options: Any) -> None:
    """Print the forces of the crank drive: rod, guide, tangential and radial force, torque.

    Per unit piston force, under a force of so many newtons and with moving masses, or over the turn of a
    steam engine.

    \b
    kurbel forces --ratio 1:5
    kurbel forces --ratio 1:5 --force 10kN --stroke 600mm
    kurbel forces --ratio 1:5 --at tangent
    kurbel forces --eps 4 --bore 300mm --pressure 8bar
    kurbel forces --machine engine.toml
    """  # fmt: skip
    _subject(options)(options)


def _subject(options: Mapping[str, Any]) -> Callable[[dict[str, Any]], None]:
    from kurbel.page.layouts import layout

    about = layout(options["layout"]).subject if options["layout"] else ""
    if options["at"] is not None or about == "tangent":
        return _print_tangent
    # What is typed outdoes the steam of a machine.
    alone = about == "motion" or (typed("force") and not (typed("eps") or typed("card")))
    return _print_engine if engine_conditions(options) and not alone else _print_piston


def _print_piston(options: dict[str, Any]) -> None:
    steam = ("bore", "pressure", "cranks", *STEAM_NAMES)
    _refuse(options, steam, "is for the steam of an engine; add --eps or --card")
    name = options["layout"] or "forces"
    if layout_of(name, ("motion", *OF_ENGINES)).subject in OF_ENGINES:
        raise ProblemError(f"layout {name} is of a steam engine; add --eps or --card")
    if not is_heavy(options):
        _refuse(options, ("speed",), "is for moving masses; add --reciprocating or a rod, --rod-mass")
    options = without_outdone(options, RIVALS)
    page, printing = layout_of(name, ("motion",)), Printing.chosen(options)
    # A speed alone makes no force.
    cranks = cranks_of(page, {**options, "speed": None}, _newtons(options))
    print_table(motion_request(page, tuple(with_masses(cranks, options, ())), options), printing)


def _print_engine(options: dict[str, Any]) -> None:
    if options["offset"] is not None and notation.number(options["offset"], "offset"):
        raise ProblemError("the steam engine has a straight crank, and an offset was given; leave it out")
    _refuse(options, ("force",), "does not go with the steam of an engine, --eps or --card; leave it out")
    if not is_heavy(options):
        _refuse(options, ("speed",), "is for moving masses; add --reciprocating or a rod, --rod-mass")
        if options["bore"] is None:
            _refuse(options, ("stroke",), "makes newton metres of the steam only with --bore; add that")
    name = options["layout"] or ("machine-forces" if is_heavy(options) else "engine-forces")
    angles = chosen_angles(layout_of(name, OF_ENGINES), options)
    print_engine({**options, "method": ()}, name, OF_ENGINES, angles=angles)


def _print_tangent(options: dict[str, Any]) -> None:
    from kurbel.motion.tangent_page import TangentRequest

    options = without_outdone(options, RIVALS)
    page = layout_of(options["layout"] or "forces-tangent", ("tangent",))
    own = "does not go with --at tangent, a position with an angle of its own; leave it out"
    _refuse(options, ("angle", "from", "to", "step"), own)
    about = "does not go with --at tangent, a position under one piston force, --force; leave it out"
    _refuse(options, (*STEAM_NAMES, *MASSES, "bore", "pressure", "speed", "cranks"), about)
    force, printing = _newtons(options), Printing.chosen(options)
    request = TangentRequest(
        layout=page,
        cranks=tuple(replace(crank, force=force) for crank in cranks_of(page, {**options, "speed": None})),
        **sheet_of(options, "phi,rod_force"),
    )
    print_table(request, printing)


def _refuse(options: Mapping[str, Any], names: tuple[str, ...], why: str) -> None:
    for name in names:
        if options[name] not in (None, (), False) and typed(name):
            raise ProblemError(f"--{name.replace('_', '-')} {why}")


def _newtons(options: Mapping[str, Any]) -> Fraction | None:
    from kurbel.reading.units import force

    return None if options["force"] is None else force(options["force"])
