"""`kurbel construct`: a construction as a drawing where the file is one, else as the table of its lengths."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Mapping
from typing import Any

import click

from kurbel.cli.options import RIVALS, FormatName, Given, Option, Type, click_option, resolved
from kurbel.cli.tables import TableCommand
from kurbel.commands.constructions.construct import construction_table, plot_construction
from kurbel.commands.shown import Drawing
from kurbel.errors import ProblemError
from kurbel.formats.registry import FORMATS
from kurbel.page.table import Table
from kurbel.reading.given import choose, found_at

HELP = """\
Draw a construction of the books to scale, or print the lengths that it gives beside their true values.

The file says which: .svg, .png and .pdf are the drawing, other formats and --table the table. Drawings need
the extra `plot`.

\b
kurbel construct blau-9 --ratio 1:4 --angle 50
kurbel construct blau-9 --ratio 1:4 --angle 50 -o fig9.svg
kurbel construct blau-9 --ratio 1:4 --angle 50 -o fig9.pdf
kurbel construct blau-9 --ratio 1:4 --angle 50 --table -o fig9.tex
"""
DRAWN = "kurbel.plot.style:FORMATS"


class AnyFormat(FormatName):
    """A format of tables or of drawings."""

    def read(self, text: str, typed: Mapping[str, Any]) -> str:
        return text if text in found_at(DRAWN) else super().read(text, typed)

    def known(self, typed: Mapping[str, Any]) -> Iterable[str]:
        return dict.fromkeys((*super().known(typed), *found_at(DRAWN)))


class ConstructCommand(TableCommand):
    """The command, whose options are those of the table and of the drawing."""

    def __init__(self) -> None:
        super().__init__("construct", construction_table.command)
        own = {one.name: click_option(one) for one in plot_construction.command.parameters.values()}
        for place, param in enumerate(self.params):
            if param.name == "format":
                self.params[place] = _format_option()
        self.params += [
            Option(["--table"], is_flag=True, help="The table of the lengths, also as PDF."),
            Option(["--text"], is_flag=True, help="SVG: letters stay text, to be searched and edited."),
            own["width"],
            own["height"],
        ]
        self.help = HELP

    def made(self, given: Given) -> tuple[Table | Drawing, int]:  # type: ignore[override]
        if given.values["table"]:
            return super().made(given)
        return self._drawn(given), 0

    def run(self, given: Given) -> int:
        from kurbel.formats.render import whole_file

        name, output = _drawing_format(given), given.values["output"]
        if given.values["table"] or not name:
            _check_table(given)
            return super().run(given)
        if output == "-" and sys.stdout.isatty():
            raise click.UsageError(f"a terminal shows no drawings; name a file, such as -o kurbel.{name}")
        drawn = self._drawn(given).image(name, text=given.values["text"])
        with whole_file(output) as stream:
            stream.write(drawn)
        return 0

    def _drawn(self, given: Given) -> Drawing:
        _check_drawn(given)
        command = plot_construction.command
        drawing: Drawing = command.ask(**resolved(command, given, RIVALS.get("construct", ())))
        return drawing


def _format_option() -> click.Option:
    return Option(
        ["format", "-f", "--format"], type=Type(AnyFormat("format", FORMATS)),
        envvar="KURBEL_CONSTRUCT_FORMAT",
        help="Format of the drawing, svg, png or pdf, or of the table; default: by the suffix of -o, else"
        " text.",
    )  # fmt: skip


def _drawing_format(given: Given) -> str:
    """Return the format of a drawing that is asked for, nothing for a table."""
    drawn = found_at(DRAWN)
    named = given.values["format"] or os.path.splitext(given.values["output"])[1].lower()[1:]
    return named if named in drawn else ""


def _check_table(given: Given) -> None:
    for name in ("width", "height", "text"):
        if given.typed(name):
            raise ProblemError(f"--{name} is for the drawing; name a file for it, such as -o kurbel.svg")
    if given.values["format"]:
        choose(given.values["format"], FORMATS, "format")


def _check_drawn(given: Given) -> None:
    for name in ("columns", "layout", "layouts", "digits", "rounding", "label", "units", "note", "source"):
        if given.typed(name):
            raise ProblemError(f"--{name} is for the table; add --table, or leave it out")


construct = ConstructCommand()
