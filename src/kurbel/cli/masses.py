"""The options that weigh the moving masses of an engine against its steam."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import click

from kurbel import notation
from kurbel.cli.options import in_order
from kurbel.errors import NotationError, ProblemError

if TYPE_CHECKING:
    from kurbel.engine import Inertia, Load
    from kurbel.problem import Crank
    from kurbel.rod import Rod

# What every mass needs beside it to become a force.
SCALE = ("stroke", "speed", "bore", "pressure")
ROD_NAMES = ("rod_mass", "centre", "gyration", "rod_file")
MASSES = ("reciprocating", *ROD_NAMES, "rotating")


ROD = (
    click.option("--rod-mass", metavar="MASS", help="Mass of the connecting rod: 150kg."),
    click.option("--centre", metavar="A",
                 help="Centre of mass of the rod from the crosshead pin, in rod lengths: 0.6, 60%; or a"
                 " length, where that of the rod is known."),
    click.option("--gyration", metavar="K",
                 help="Radius of gyration about the centre of mass, in rod lengths: 0.3; or a length."),
    click.option("--rod-file", metavar="FILE", type=click.Path(),
                 help="The rod's masses from a CSV file in place of these: from, to, mass or position, mass,"
                 " counted from the crank pin."),
)  # fmt: skip
rod_options = in_order(ROD)
MOVING = (
    click.option("--reciprocating", metavar="MASS",
                 help="Mass of piston and crosshead: 200kg. Masses need --stroke, --speed, --bore and"
                 " --pressure."),
    *ROD,
)  # fmt: skip
SIZE = (
    click.option("--bore", metavar="LENGTH", help="Bore of the cylinder: 300mm."),
    click.option("--pressure", metavar="PRESSURE",
                 help="Steam pressure before cut-off: 8bar; an indicator card has its own."),
)  # fmt: skip
STROKE = click.option("--stroke", metavar="LENGTH", help="Stroke 2R: 600mm.")
mass_options = in_order((*MOVING, STROKE, *SIZE))


def load_of(options: Mapping[str, Any]) -> Load | None:
    """Return what makes newtons of the steam force, None if it is not known."""
    needed = ("bore",) if options["card"] else ("bore", "pressure")
    if options["bore"] is None and (options["card"] or options["pressure"] is None):
        return None
    missing = [f"--{name}" for name in needed if options[name] is None]
    if missing:
        raise ProblemError(f"newtons need the bore and the steam pressure; add {missing[0]}")
    from kurbel.engine import Load
    from kurbel.units import length, pressure

    steam, stroke = options["pressure"], options["stroke"]
    return Load(
        length(options["bore"], "bore"),
        None if steam is None else Fraction(pressure(steam, "pressure")),
        None if stroke is None else length(stroke, "stroke") / 2,
    )


def inertia_of(options: Mapping[str, Any], drives: Sequence[Crank]) -> Inertia | None:
    """Return the masses that the options describe, None if there are none."""
    given = [name for name in MASSES if options.get(name) is not None]
    if not given:
        return None
    option = f"--{given[0].replace('_', '-')}"
    needed = [name for name in SCALE if name != "pressure" or not options["card"]]
    missing = [f"--{name}" for name in needed if options[name] is None]
    if missing:
        raise ProblemError(f"{option} needs {', '.join(missing)} to become a force")
    from kurbel.engine import Inertia
    from kurbel.units import length, mass, signed_mass, speed

    reciprocating, rotating = options["reciprocating"], options.get("rotating")
    radius = length(options["stroke"], "stroke") / 2
    return Inertia(
        Fraction(0) if reciprocating is None else mass(reciprocating, "reciprocating mass"),
        speed(options["speed"]),
        _heavy_rod(options, [replace(drive, radius=radius) for drive in drives]),
        Fraction(0) if rotating is None else signed_mass(rotating, "rotating mass"),
    )


def _heavy_rod(options: Mapping[str, Any], drives: Sequence[Crank]) -> Rod | None:
    if all(options[name] is None for name in ROD_NAMES):
        return None
    # One rod for all ratios has a length of its own only if there is one ratio.
    return rod_of(options, drives[0].rod_length if len(drives) == 1 else None)


def rod_of(options: Mapping[str, Any], length: Fraction | None) -> Rod:
    """Return the rod of rod_options, between pins so far apart, in metres, if that is known."""
    from kurbel.rod_given import given_rod
    from kurbel.units import mass

    weight = options["rod_mass"]
    return given_rod(
        _in_rod_lengths(options["centre"], "centre of mass", length),
        _in_rod_lengths(options["gyration"], "radius of gyration", length),
        options["rod_file"],
        None if weight is None else mass(weight, "rod mass"),
        length,
    )


def _in_rod_lengths(text: str | None, what: str, length: Fraction | None) -> Fraction | None:
    if text is None:
        return None
    from kurbel import units

    if not units.is_measure(text):
        return notation.share(text, what)
    measured = units.length(text, what)
    if length is None:
        raise NotationError(
            f'{what} "{text[:40]}" is a length, but that of the rod is not known; add --stroke and one'
            " --ratio, or give a share of the rod's length"
        )
    return measured / length
