"""`kurbel plot`: one command for all drawings, of the options of the functions that draw them."""

from __future__ import annotations

import sys
from typing import NamedTuple

import click

from kurbel.cli.options import (
    Given,
    Option,
    Type,
    click_option,
    machine_option,
    output_option,
)
from kurbel.cli.tables import MakingCommand
from kurbel.commands import engine_plots, plots
from kurbel.commands.cylinder import pressures
from kurbel.commands.cylinder.effort import RODS, RUBBING
from kurbel.commands.cylinder.slope import LYING
from kurbel.commands.diagram.given import Diagram
from kurbel.commands.engine import Wheeled
from kurbel.commands.loads import PARTS, astray, named
from kurbel.commands.machines import MASSES, STEAM
from kurbel.commands.options import Choice
from kurbel.commands.shown import Drawing
from kurbel.commands.subject import Command
from kurbel.errors import ProblemError

HELP = """\
Draw path, velocity and acceleration over the crank angle, or what --positions, --forces, --polar,
--pressures and --turning say. Drawings need the extra `plot`.

\b
kurbel plot --ratio 1:5 -o bewegung.svg
kurbel plot --ratio 1:5 --infinite --width 85 -o spalte.pdf
kurbel plot --ratio '1:4;1:5' --columns p -o beschleunigung.pdf
kurbel plot --ratio 1:5 --over path --infinite -o geschwindigkeitsellipse.pdf
kurbel plot --ratio 1:5 --force 10kN --stroke 600mm -o kraefte.pdf
kurbel plot --positions 30 --ratio 1:5 -o kurbeltrieb.svg
kurbel plot --animate --ratio 1:4 -o drehung.html
kurbel plot --point 0.5 --ratio 1:5 -o koppelkurve.svg
kurbel plot --mechanism arc --rocker 6 -o bogenschubkurbel.svg
kurbel plot --polar --eps 4 --bore 300mm --pressure 8bar -o zapfenkraft.pdf
kurbel plot --forces --machine engine.toml -o kraefte.svg
kurbel plot --turning --eps 4 --ratio 1:5 --over path -o drehkraft.pdf
kurbel plot --turning --eps 4 --flywheel 50 --speed 120/min -o drehzahl.pdf
kurbel plot --turning --pressure-ratio 3 --clearance 5% -o kompressor.pdf
kurbel plot --turning --torque '5000 + 1500 sin(3φ)' --load-torque '5000 + 600 sin φ' -o drehmoment.pdf
kurbel plot --pressures --machine engine.toml -o beschleunigungsdruck.pdf
"""
FLAGS = {
    "forces": "Draw the forces in the crank drive: of a steam engine with --eps or --card, else of a constant"
    " piston force.",
    "polar": "Draw the polar diagram of the force on the crank pin, of either.",
    "pressures": "Draw the acceleration pressure under the indicator diagram, over the stroke.",
    "turning": "Draw the turning effort of a steam engine: tangential force, its mean and the excess energy;"
    " with a flywheel the speed as well; with --torque a diagram without an engine.",
}
# The options that all drawings have, or that say which one it is, or where it goes.
SHARED = frozenset(("positions", *FLAGS, "ratio", "format", "output", "text", "lang", "units", "decimal"))
OF_ENGINES = frozenset(
    (
        *(*STEAM, *Wheeled.__annotations__, "cranks", "cylinder", "of", "bore", "pressure"),
        *(*MASSES, *LYING, *RODS, *RUBBING),
    )
)


class Kind(NamedTuple):
    """A kind of drawing: what a message calls it, and what draws it."""

    name: str
    command: Command

    @property
    def takes(self) -> frozenset[str]:
        return frozenset(one.name for one in self.command.parameters.values())


MOTION = Kind("the motion", plots.plot_motion.command)
KINDS = {
    "positions": Kind("the mechanism", plots.plot_mechanism.command),
    "forces": Kind("the forces", plots.plot_forces.command),
    "polar": Kind("the polar diagram", plots.plot_polar.command),
    "pressures": Kind("the pressures on the piston", pressures.plot_pressures.command),
    "turning": Kind("the turning effort", engine_plots.plot_turning.command),
}
# The same where steam drives the piston; the forces are those of the first crank.
OF_STEAM = {
    "forces": Kind("the forces of an engine", engine_plots.plot_engine_forces.command),
    "polar": Kind("the polar diagram of an engine", engine_plots.plot_engine_polar.command),
}


class PlotCommand(MakingCommand):
    """The command, whose options are those of all kinds."""

    def __init__(self) -> None:
        super().__init__("plot", params=_params(), help=HELP)

    def made(self, given: Given) -> tuple[Drawing, int]:
        """Return the drawing, and the exit code of the command."""
        kind = _kind(given)
        if given.values["cylinder"] and "eps" in kind.takes and "cylinder" not in kind.takes:
            raise ProblemError(f"{kind.name} are of one cylinder, and the machine has a list; leave that out")
        for name in set(given.values) - SHARED - kind.takes:
            given.drop(name)
        return kind.command.ask(given), 0

    def run(self, given: Given) -> int:
        from kurbel.formats.render import whole_file

        name = _format(given)
        drawing, code = self.made(given)
        drawn = drawing.image(name, text=given.values["text"])
        with whole_file(given.values["output"]) as stream:
            stream.write(drawn)
        return code


def _kind(given: Given) -> Kind:
    """Return what is to be drawn; raise ProblemError for options that say nothing about it."""
    flags = [name for name in KINDS if given.values[name]]
    if len(flags) > 1:
        raise ProblemError(f"--{flags[0]} and --{flags[1]} are two drawings; leave one out")
    flag = flags[0] if flags else _unsaid(given)
    kind = OF_STEAM[flag] if flag in OF_STEAM and _driven_by_steam(given) else KINDS.get(flag, MOTION)
    for name in given.values:
        if name not in SHARED | kind.takes and given.typed(name):
            raise ProblemError(_refusal(name, kind, flag))
    return kind


def _unsaid(given: Given) -> str:
    """Return what is drawn where no flag says it: with a point of the rod alone its path."""
    over_axis = given.values["columns"] or given.typed("over")
    return "positions" if given.values["point"] and not over_axis else ""


def _driven_by_steam(given: Given) -> bool:
    """Whether steam drives the piston, and no constant force that outdoes the steam of the machine."""
    return bool(named(given.values)) and (not given.typed("force") or any(map(given.typed, STEAM)))


def _refusal(name: str, kind: Kind, flag: str) -> str:
    option = f"--{name.replace('_', '-')}"
    if flag in OF_STEAM and kind is not OF_STEAM[flag] and name in OF_ENGINES & OF_STEAM[flag].takes:
        return (
            astray(name) if name in PARTS else f"{option} is for the steam of an engine; add --eps or --card"
        )
    if name in OF_ENGINES and flag in ("", "positions"):
        return f"{option} describes a steam engine; --forces, --polar, --pressures and --turning draw one"
    return f"{option} says nothing about {kind.name}; leave it out"


def _format(given: Given) -> str:
    """Return the format of -f or of the file's suffix; raise an error for one that cannot move, or that is
    only for what moves."""
    from kurbel.plot.style import FORMATS, MOVING

    name, moves = _named_format(given), given.values["animate"]
    if moves and name not in MOVING:
        raise click.UsageError(
            f"{name} stands still, and --animate writes html, svg or gif, such as -o turn.html; leave it"
            f" out for {name}"
        )
    if not moves and name not in FORMATS:
        raise click.UsageError(f"{name} is for drawings that move; add --animate, or take -f svg, png or pdf")
    return name


def _named_format(given: Given) -> str:
    """Return the format of -f or of the file's suffix; raise an error for a terminal, which takes none."""
    name, output = given.values["format"], given.values["output"]
    if not output:
        raise click.UsageError("--output names no file; - is standard output.")
    if output == "-":
        if sys.stdout.isatty():
            raise click.UsageError("a terminal shows no drawings; name a file, such as -o kurbel.svg")
        if name is None:
            raise click.UsageError("no file was named; add -o kurbel.svg, or -f svg for standard output")
        return str(name)
    if name is not None and given.typed("format"):
        return str(name)
    from kurbel.plot.style import format_of

    return format_of(output, moves=given.values["animate"])


def _params() -> list[click.Parameter]:
    known = {
        one.name: one
        for kind in (*KINDS.values(), MOTION, *OF_STEAM.values())
        for one in kind.command.parameters.values()
    }
    own = {name: click_option(one._replace(required=False)) for name, one in known.items()}
    flags = [Option([f"--{name}"], is_flag=True, help=text) for name, text in FLAGS.items()]
    last = ("animate", "seconds", "width", "height", "lang", "units", "decimal")
    output = [
        Option(["format", "-f", "--format"], metavar="FORMAT",
               type=Type(Choice("drawing format", "kurbel.plot.style:FILES")),
               help="svg, png, pdf or pgf, of drawings that move html, svg or gif; default: by the suffix of"
               " -o."),
        output_option(
            "File to write, whole or not at all; - is standard output, unless a terminal.", default="-"
        ),
        Option(["--text"], is_flag=True,
               help="SVG: letters stay text, to be searched and edited, in the reader's fonts; without it"
               " they are outlines, alike everywhere."),
    ]  # fmt: skip
    order = (
        "ratio", "columns", "over", "infinite", *Diagram.__annotations__, *Wheeled.__annotations__,
        "method", "order", "from", "to", "step", "offset", "stroke", "crank", "true_stroke", "time_ratio",
        "rod", "speed", "force", "mechanism", "rocker", "pivot", "circuit", "beam", *STEAM, "cranks",
        "cylinder", "of", "bore", "pressure", *MASSES, *LYING, *RODS, *RUBBING,
    )  # fmt: skip
    return [
        machine_option(), own["positions"], own["point"], *flags, *(own[name] for name in order), *output,
        *(own[name] for name in last),
    ]  # fmt: skip


plot = PlotCommand()
