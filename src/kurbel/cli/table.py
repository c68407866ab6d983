"""`kurbel table`: piston path, velocity and acceleration over the crank angle."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, TypeVar

import click

from kurbel.cli.lengths import settled_lengths
from kurbel.cli.machine import machine_option
from kurbel.cli.mechanism import MECHANISMS, chosen_mechanism, mechanism_options
from kurbel.cli.options import (
    Columns,
    Name,
    in_order,
    layout_option,
    output_options,
    sheet_of,
    without_outdone,
)
from kurbel.drive.crank import Crank
from kurbel.errors import NotationError, ProblemError
from kurbel.motion.evaluation import METHODS
from kurbel.page.layouts import Layout
from kurbel.reading import notation
from kurbel.reading.speed import Speed

if TYPE_CHECKING:
    from kurbel.motion.question import Request

# What gives way, where it only comes from the environment, to what is typed.
RIVALS = (
    ("angle", {"from"}),
    ("angle", {"to"}),
    ("angle", {"step"}),
    ("from", {"angle"}),
    ("to", {"angle"}),
    ("step", {"angle"}),
)
Command = TypeVar("Command", bound=Callable[..., Any])
FULL_TURN = Fraction(360)
STEP = Fraction(10)

RATIO = click.option("-r", "--ratio", multiple=True, metavar="R:L",
                     help="Crank ratio: 1:5, 1:4,5, 0.2; lists 1:4;1:5 and ranges 1:3..6:0.5; 1:∞ is the"
                     " infinite rod.")  # fmt: skip
LENGTHS = (
    click.option("--offset", metavar="E",
                 help="Offset crank: e as a share of R, or as a length with --stroke."),
    click.option("--stroke", metavar="LENGTH", help="2R: 600mm."),
    click.option("--rod", metavar="LENGTH",
                 help="Rod length L, which with --stroke gives the ratio: 1500mm."),
)  # fmt: skip
METHOD = click.option("--method", type=Name("method", lambda: METHODS),
                      help="exact (default), series (first order, as Blau prints) or infinite (rod of"
                      " infinite length).")  # fmt: skip


def motion_options(layout: str, example: str) -> Callable[[Command], Command]:
    """Add what describes the crank and its angles, and the columns of the layout."""
    options = (
        RATIO,
        click.option("--angle", multiple=True, metavar="ANGLES",
                     help="Crank angles in degrees: 22.5, 2°30', lists 0;45;90, ranges 0..180:10."),
        click.option("--from", metavar="ANGLE", help="First angle; default 0."),
        click.option("--to", metavar="ANGLE", help="Last angle; default 360, the whole turn."),
        click.option("--step", metavar="ANGLE",
                     help="Step of the angles; default 10. Without any of these options a layout has its own"
                     " angles."),
        click.option("--columns", type=Columns(layout), multiple=True, metavar="NAMES",
                     help=f"Columns and their order: {example}; `kurbel quantities` lists them. Pages keep φ"
                     " at the left."),
        *LENGTHS,
    )  # fmt: skip
    return in_order(options)


@click.command()
@machine_option
@motion_options("kinematics", "phi,x,c,p")
@METHOD
@click.option("--speed", metavar="SPEED", help="Speed, for columns in m/s and m/s²: 120/min, 12.5rad/s.")
@mechanism_options
@layout_option("", *{one.subject for one in MECHANISMS.values()})
@output_options
def table(**options: Any) -> None:
    """Print a table of piston path, velocity and acceleration.

    \b
    kurbel table --ratio 1:5
    kurbel table --ratio '1:4;1:4,5' --step 15 --to 180 -f latex -o anhang.tex
    kurbel table --layout roetscher-112 --ratio 1:5 --ratio 1:4,5 --ratio 1:4
    kurbel table --stroke 600mm --rod 1500mm --speed 120/min
    kurbel table --mechanism arc --ratio 1:5 --rocker 6
    """  # fmt: skip
    name, options = chosen_mechanism(options)
    if MECHANISMS[name].subject != "motion":
        from kurbel.cli.linkage import print_linkage

        print_linkage(name, options)
        return
    print_motion(options)


def print_motion(options: dict[str, Any], force: Fraction | None = None) -> None:
    """Print a page of the crank that the options describe, under a piston force in newtons if there is."""
    from kurbel.cli.printing import Printing, print_table
    from kurbel.page.layouts import layout_of

    options = without_outdone(options, RIVALS)
    page = layout_of(options["layout"], ["motion"])
    printing = Printing.chosen(options)
    print_table(motion_request(page, cranks_of(page, options, force), options), printing)


def motion_request(page: Layout, cranks: tuple[Crank, ...], options: Mapping[str, Any]) -> Request:
    """Return what the options ask for of these cranks."""
    from kurbel.motion.question import Request

    return Request(
        layout=page,
        cranks=cranks,
        angles=chosen_angles(page, options),
        method=options.get("method"),
        **sheet_of(options, "phi,x,c,p"),
    )


def chosen_angles(page: Layout, options: Mapping[str, Any]) -> Sequence[Fraction]:
    """Return the angles of --angle, or of --from, --to and --step, or the layout's own."""
    angles: tuple[str, ...] = options["angle"]
    start, stop, step = run = tuple(options[name] for name in ("from", "to", "step"))
    running = any(text is not None for text in run)
    if angles and running:
        raise ProblemError(
            "--angle lists the angles and --from, --to, --step run through them; use one or the other"
        )
    if not running:
        return notation.angles(angles or page.angles)
    first, last = ends_of_run(start, stop)
    width = min(STEP, last - first) if step is None and last > first else STEP
    return notation.progression(first, last, width if step is None else notation.angle(step, "step"))


def ends_of_run(start: str | None, stop: str | None) -> tuple[Fraction, Fraction]:
    """Return the first and the last angle, by default those of the whole turn."""
    first = Fraction(0) if start is None else notation.angle(start, "first angle")
    return first, FULL_TURN if stop is None else notation.angle(stop, "last angle")


def cranks_of(page: Layout, options: Mapping[str, Any], force: Fraction | None = None) -> tuple[Crank, ...]:
    """Return the cranks that --ratio, --offset, --stroke, --rod and --speed describe, or the layout's."""
    options = settled_lengths(options)
    if options.get("method") == "infinite" and options["rod"] and not options["stroke"]:
        raise ProblemError("--rod gives the rod a length, but --method infinite takes none; use --stroke")
    radius, length = _length(options["stroke"], "stroke"), _length(options["rod"], "rod")
    radius = None if radius is None else radius / 2
    if radius is not None and length is not None:
        values: Sequence[Fraction] = (radius / length,)
    else:
        values = notation.ratios(options["ratio"] or page.ratios)
        if length is not None and 0 in values:
            raise ProblemError(
                "--rod gives the rod a length, but ratio 1:∞ asks for an infinite one; leave one out"
            )
    speed = _speed(options.get("speed"))
    return tuple(
        Crank(value, _offset(options.get("offset"), size), size, speed, force)
        for value in values
        for size in [length * value if length is not None and radius is None else radius]
    )


def _length(text: str | None, what: str) -> Fraction | None:
    if text is None:
        return None
    from kurbel.reading.units import length

    return length(text, what)


def _speed(text: str | None) -> Speed | None:
    if text is None:
        return None
    from kurbel.reading.units import speed

    return speed(text)


def _offset(text: str | None, radius: Fraction | None) -> Fraction:
    """e/R from a share of R or a length, which may be negative."""
    if text is None:
        return Fraction(0)
    from kurbel.reading import units

    share = text.strip().removesuffix("R")
    if not units.is_measure(share):
        return notation.number(share, "offset")
    displacement = units.displacement(text, "offset")
    if radius is None:
        raise NotationError(
            f'offset "{text[:40]}" is a length, but no length of the crank is known;'
            " add --stroke or give e as a share of R"
        )
    return displacement / radius
