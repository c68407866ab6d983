"""`kurbel plot`: the drawings of what has no page."""

from __future__ import annotations

import click

from kurbel.cli.drawings import check_moving, check_terminal, write
from kurbel.cli.options import (
    Given,
    Option,
    Type,
    click_option,
    help_of,
    machine_option,
    output_option,
)
from kurbel.cli.tables import MakingCommand
from kurbel.commands.options import Choice
from kurbel.commands.parts.drawing import Pictured
from kurbel.commands.plot import plot_mechanism
from kurbel.commands.shown import Drawing

LAST = ("animate", "seconds", "width", "height", "lang", "units", "decimal")


class PlotCommand(MakingCommand):
    """The command, whose options are those of the function and of its files."""

    def __init__(self) -> None:
        super().__init__("plot", params=_params(), help=help_of(plot_mechanism.command))

    def made(self, given: Given) -> tuple[Drawing, int]:
        """Return the drawing, and the exit code of the command."""
        drawing: Drawing = plot_mechanism.command.ask(given)
        return drawing, 0

    def run(self, given: Given) -> int:
        name = _format(given)
        drawing, code = self.made(given)
        write(drawing, name, given)
        return code


def _format(given: Given) -> str:
    """Return the format of -f or of the file's suffix; raise an error for one that cannot move, or that is
    only for what moves, and for a terminal, which takes none."""
    name, output = given.values["format"], given.values["output"]
    if not output:
        raise click.UsageError("--output names no file; - is standard output.")
    check_terminal(output, "svg")
    if output == "-" and name is None:
        raise click.UsageError("no file was named; add -o kurbel.svg, or -f svg for standard output")
    if output != "-" and not given.typed("format"):
        from kurbel.plot.style import format_of

        name = format_of(output, moves=given.values["animate"])
    check_moving(name, given.values["animate"])
    return str(name)


def _params() -> list[click.Parameter]:
    own = {one.name: click_option(one) for one in plot_mechanism.command.parameters.values()}
    output = [
        Option(["format", "-f", "--format"], metavar="FORMAT",
               type=Type(Choice("drawing format", "kurbel.plot.style:FILES")),
               help="svg, png, pdf or pgf, of drawings that move html, svg or gif; default: by the suffix of"
               " -o."),
        output_option(
            "File to write, whole or not at all; - is standard output, unless a terminal.", default="-"
        ),
        click_option(Pictured.text),
    ]  # fmt: skip
    first = (param for name, param in own.items() if name not in LAST)
    return [machine_option(), *first, *output, *(own[name] for name in LAST)]


plot = PlotCommand()
