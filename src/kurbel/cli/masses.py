"""The options that weigh the moving masses of an engine against its steam."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import click

from kurbel.cli.options import in_order, without_outdone
from kurbel.errors import NotationError, ProblemError
from kurbel.reading import notation

if TYPE_CHECKING:
    from kurbel.drive.crank import Crank
    from kurbel.drive.rod import Rod
    from kurbel.engine.engine import Load

ROD_NAMES = ("rod_mass", "centre", "gyration", "rod_file")
MASSES = ("reciprocating", *ROD_NAMES, "rotating")
# What gives way, where it only comes from the environment or a machine, to what is typed.
ROD_RIVALS = (
    *((name, {"rod_file"}) for name in ("rod_mass", "centre", "gyration")),
    *(("rod_file", {name}) for name in ("centre", "gyration")),
)


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
                 help="Mass of piston and crosshead: 200kg. Masses need --stroke and --speed, and beside"
                 " steam --bore and --pressure."),
    *ROD,
)  # fmt: skip
ROTATING = click.option("--rotating", metavar="MASS",
                        help="Mass of the crank itself at its pin, for the main bearing: 60kg; -40kg if"
                        " counterweights outweigh it.")  # fmt: skip
SIZE = (
    click.option("--bore", metavar="LENGTH", help="Bore of the cylinder: 300mm."),
    click.option("--pressure", metavar="PRESSURE",
                 help="Steam pressure before cut-off: 8bar; an indicator card has its own."),
)  # fmt: skip
LENGTHS = (
    click.option("--stroke", metavar="LENGTH", help="Stroke 2R: 600mm."),
    click.option("--rod", metavar="LENGTH",
                 help="Rod length L, which with --stroke gives the ratio: 1500mm."),
)  # fmt: skip
mass_options = in_order((*MOVING, *LENGTHS, *SIZE))


def load_of(options: Mapping[str, Any]) -> Load | None:
    """Return what makes newtons of the steam force, None if it is not known."""
    if options["bore"] is None and (options["card"] or options["pressure"] is None):
        return None
    needed = ("bore",) if options["card"] else ("bore", "pressure")
    missing = [f"--{name}" for name in needed if options[name] is None]
    if missing:
        raise ProblemError(f"newtons need the bore and the steam pressure; add {missing[0]}")
    from kurbel.engine.engine import Load
    from kurbel.reading.units import length, pressure

    steam = options["pressure"]
    return Load(length(options["bore"], "bore"), None if steam is None else pressure(steam, "pressure"))


def is_heavy(options: Mapping[str, Any]) -> bool:
    """Whether any mass is given."""
    return any(options.get(name) is not None for name in MASSES)


def with_masses(cranks: Sequence[Crank], options: Mapping[str, Any], beside: tuple[str, ...]) -> list[Crank]:
    """Return the cranks with the masses that the options describe, and the speed that makes forces of them.

    `beside` names the further options that every mass needs.
    """
    if not is_heavy(options):
        return list(cranks)
    first = next(name for name in MASSES if options.get(name) is not None)
    missing = [f"--{name}" for name in ("speed", *beside) if options[name] is None]
    if any(crank.radius is None for crank in cranks):
        missing.insert(0, "--stroke")
    if missing:
        raise ProblemError(f"--{first.replace('_', '-')} needs {', '.join(missing)} to become a force")
    from kurbel.drive.moving import Moving
    from kurbel.reading.units import mass, signed_mass, speed

    reciprocating, rotating = options["reciprocating"], options.get("rotating")
    # One rod for all ratios has a length of its own only if there is one ratio.
    length = cranks[0].rod_length if len(cranks) == 1 else None
    moving = Moving(
        Fraction(0) if reciprocating is None else mass(reciprocating, "reciprocating mass"),
        rod_of(options, length) if any(options[name] is not None for name in ROD_NAMES) else None,
        Fraction(0) if rotating is None else signed_mass(rotating, "rotating mass"),
    )
    return [replace(crank, speed=speed(options["speed"]), moving=moving) for crank in cranks]


def rod_of(options: Mapping[str, Any], length: Fraction | None) -> Rod:
    """Return the rod of rod_options, between pins so far apart, in metres, if that is known."""
    from kurbel.drive.rod_given import given_rod
    from kurbel.reading.units import mass

    options = without_outdone(dict(options), ROD_RIVALS)
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
    from kurbel.reading import units

    if not units.is_measure(text):
        return notation.share(text, what)
    measured = units.length(text, what)
    if length is None:
        raise NotationError(
            f'{what} "{text[:40]}" is a length, but that of the rod is not known; add --stroke and one'
            " --ratio, or give a share of the rod's length"
        )
    return measured / length
