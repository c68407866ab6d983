"""`kurbel plot`: the motion, the mechanism to scale, and the forces, also those of an engine."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from typing import Any

import click

from kurbel.cli import engine
from kurbel.cli.kept import keeper
from kurbel.cli.machine import machine_option
from kurbel.cli.masses import MOVING, ROTATING, SIZE
from kurbel.cli.mechanism import mechanism_options
from kurbel.cli.options import Columns, Name, in_order, typed, without_outdone
from kurbel.cli.plot_kinds import ENGINE_LAYOUT, LAYOUT, STEPS, WIDEST, kind_of, of_kind
from kurbel.cli.table import LENGTHS, METHOD, RATIO
from kurbel.errors import ChoiceError
from kurbel.formats.registry import DECIMAL_OF_LANGUAGE, DECIMALS
from kurbel.page.folders import LANGUAGES


def _formats() -> Sequence[str]:
    from kurbel.plot.style import FORMATS

    return tuple(FORMATS)


class DrawnColumns(Columns):
    """Names of columns of the page whose quantities are drawn."""

    def _default(self, typed: Mapping[str, Any]) -> str:
        if typed.get("forces") and (typed.get("eps") or typed.get("card")):
            return ENGINE_LAYOUT
        return super()._default(typed)


KINDS = (
    click.option("--positions", multiple=True, metavar="ANGLES",
                 help="Draw the mechanism to scale at these crank angles: 30, or 30;90;150."),
    click.option("--forces", is_flag=True,
                 help="Draw the forces in the crank drive: of a steam engine with --eps or --card, else of a"
                 " constant piston force."),
    click.option("--polar", is_flag=True,
                 help="Draw the polar diagram of the force on the crank pin, of either."),
    click.option("--turning", is_flag=True,
                 help="Draw the turning effort of a steam engine: tangential force, its mean and the excess"
                 " energy."),
)  # fmt: skip
CURVES = (
    click.option("--columns", type=DrawnColumns(LAYOUT), multiple=True, metavar="NAMES",
                 help="Quantities to draw: x,c,p or rod_force,guide_force; `kurbel quantities` lists them."),
    METHOD,
    click.option("--from", metavar="ANGLE", help="First angle; default 0."),
    click.option("--to", metavar="ANGLE", help="Last angle; default 360, the whole turn."),
    click.option("--step", metavar="ANGLE",
                 help=f"Step of the angles; default 1/{STEPS} of their range, at most {WIDEST}°."),
)  # fmt: skip
UNITS = (
    *LENGTHS,
    click.option(
        "--speed", metavar="SPEED", help="Speed, for m/s and m/s², and for masses: 120/min, 12.5rad/s."
    ),
    click.option("--force", metavar="FORCE", help="Piston force, to draw forces in N and N m: 10kN."),
)
ENGINE = (engine.EPS, *engine.STEAM, engine.CRANKS, *SIZE, *MOVING, ROTATING)
OUTPUT = (
    click.option("-f", "--format", type=Name("drawing format", _formats), metavar="FORMAT",
                 help="svg, png or pdf; default: by the suffix of -o."),
    click.option("-o", "--output", type=click.Path(allow_dash=True), metavar="FILE", default="-",
                 help="File to write, whole or not at all; - is standard output, unless a terminal."),
    click.option("--lang", type=Name("language", lambda: LANGUAGES), default="de", show_default=True,
                 envvar="KURBEL_LANG", help="Language of the labels: de or en."),
    click.option("--decimal", type=Name("decimal mark", lambda: DECIMALS), envvar="KURBEL_DECIMAL",
                 help="comma or point; default: by the language."),
)  # fmt: skip


@click.command()
@machine_option
@in_order((*KINDS, RATIO, *CURVES, *UNITS))
@mechanism_options
@in_order((*ENGINE, *OUTPUT))
def plot(**options: Any) -> None:
    """Draw path, velocity and acceleration over the crank angle, or what --positions, --forces, --polar and
    --turning say. Drawings need the extra `plot`.

    \b
    kurbel plot --ratio 1:5 -o bewegung.svg
    kurbel plot --ratio '1:4;1:5' --columns p -o beschleunigung.pdf
    kurbel plot --ratio 1:5 --force 10kN --stroke 600mm -o kraefte.pdf
    kurbel plot --positions 30 --ratio 1:5 -o kurbeltrieb.svg
    kurbel plot --mechanism arc --rocker 6 -o bogenschubkurbel.svg
    kurbel plot --polar --eps 4 --bore 300mm --pressure 8bar -o zapfenkraft.pdf
    kurbel plot --forces --machine engine.toml -o kraefte.svg
    kurbel plot --turning --eps 4 --ratio 1:5 -o drehkraft.pdf
    """  # fmt: skip
    from kurbel.formats.output import whole_file
    from kurbel.page.labels import plain
    from kurbel.plot.style import image

    kept_drawing = keeper()
    name = "" if kept_drawing else _format(options["format"], options["output"])
    kind = kind_of(options)
    kept = of_kind(without_outdone(options, engine.RIVALS), kind)
    decimal = options["decimal"] or DECIMAL_OF_LANGUAGE[options["lang"]]
    mark = DECIMALS[decimal]
    drawing = kind.draw(kept, mark)
    if kept_drawing:
        kept_drawing.made, kept_drawing.lang, kept_drawing.decimal = drawing, options["lang"], decimal
        return
    drawn = image(drawing.figure, name, plain(drawing.title, mark))
    with whole_file(options["output"]) as stream:
        stream.write(drawn)


def _format(name: str | None, output: str) -> str:
    """Return the format of -f or of the file's suffix; raise an error for a terminal, which takes none."""
    if not output:
        raise click.UsageError("--output names no file; - is standard output.")
    if output == "-":
        if sys.stdout.isatty():
            raise click.UsageError("a terminal shows no drawings; name a file, such as -o kurbel.svg")
        if name is None:
            raise click.UsageError("no file was named; add -o kurbel.svg, or -f svg for standard output")
        return name
    if name is not None and typed("format"):
        return name
    suffix = os.path.splitext(output)[1].lower()
    if suffix.removeprefix(".") not in _formats():
        known = ", ".join(f".{one}" for one in _formats())
        raise ChoiceError(
            f'the file name "{output[-60:]}" names no drawing; its suffix must be one of {known}'
        )
    return suffix[1:]
