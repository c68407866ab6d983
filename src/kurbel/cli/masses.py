"""The options that weigh the moving masses of an engine against its steam."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any, TypeVar

import click

from kurbel import notation
from kurbel.errors import ProblemError

if TYPE_CHECKING:
    from kurbel.engine import Inertia
    from kurbel.rod import Rod

Command = TypeVar("Command", bound=Callable[..., Any])
# What every mass needs beside it to become a force.
SCALE = ("stroke", "speed", "bore", "pressure")
MASSES = ("reciprocating", "rod_mass")


def mass_options(command: Command) -> Command:
    """Add the masses, and the size and pressure of the engine; --speed is left to the command."""
    options = (
        click.option("--reciprocating", metavar="MASS",
                     help="Mass of piston and crosshead: 200kg. Masses need --stroke, --speed, --bore and"
                     " --pressure."),
        click.option("--rod-mass", metavar="MASS", help="Mass of the connecting rod: 150kg."),
        click.option("--centre", metavar="A",
                     help="Distance of the rod's centre of mass from the crosshead pin, in rod lengths:"
                     " 0.6."),
        click.option("--gyration", metavar="K",
                     help="Radius of gyration about the centre of mass, in rod lengths: 0.3; default: that of"
                     " two masses at the pins."),
        click.option("--stroke", metavar="LENGTH", help="Stroke 2R: 600mm."),
        click.option("--bore", metavar="LENGTH", help="Bore of the cylinder: 300mm."),
        click.option("--pressure", metavar="PRESSURE", help="Steam pressure before cut-off: 8bar."),
    )  # fmt: skip
    for option in reversed(options):
        command = option(command)
    return command


def inertia_of(options: Mapping[str, Any]) -> Inertia | None:
    """Return the masses that the options describe, None if there are none."""
    given = [name for name in (*MASSES, "centre", "gyration") if options[name] is not None]
    if not given:
        return None
    option = f"--{given[0].replace('_', '-')}"
    if not any(options[name] is not None for name in MASSES):
        raise ProblemError(f"{option} is for a rod with a mass; add --rod-mass")
    missing = [f"--{name}" for name in SCALE if options[name] is None]
    if missing:
        raise ProblemError(f"{option} needs {', '.join(missing)} to become a force")
    from kurbel.engine import Inertia
    from kurbel.units import length, mass, pressure, speed

    reciprocating = options["reciprocating"]
    return Inertia(
        Fraction(0) if reciprocating is None else mass(reciprocating, "reciprocating mass"),
        length(options["stroke"], "stroke") / 2,
        speed(options["speed"]),
        length(options["bore"], "bore"),
        Fraction(pressure(options["pressure"], "pressure")),
        _rod(options),
    )


def _rod(options: Mapping[str, Any]) -> Rod | None:
    if options["rod_mass"] is None:
        if options["centre"] is not None or options["gyration"] is not None:
            raise ProblemError("--centre and --gyration are for a rod with a mass; add --rod-mass")
        return None
    if options["centre"] is None:
        raise ProblemError("--rod-mass needs --centre, where the rod's centre of mass is, for example 0.6")
    from kurbel.rod import Rod
    from kurbel.units import mass

    weight = mass(options["rod_mass"], "rod mass")
    # The rod counts from the crank pin.
    centre = 1 - notation.number(options["centre"], "centre")
    if options["gyration"] is None:
        return Rod(centre, centre * (1 - centre), weight)
    return Rod.of_gyration(centre, notation.number(options["gyration"], "gyration"), weight)
