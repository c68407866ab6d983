"""The commands that draw what has no page: `kurbel plot`, and `kurbel construct`, a construction as a drawing
where the file is one, else as the table of its lengths."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import click

from kurbel.books.constructions.construction_page import construction, construction_names
from kurbel.books.constructions.model import Construction
from kurbel.cli.drawings import check_drawing, check_moving, check_page, check_terminal, drawing_format, write
from kurbel.cli.listing import Listing, form_of_list, plain_lines, show_list
from kurbel.cli.manual.command import with_examples
from kurbel.cli.options import (
    Option,
    Type,
    TypedOptions,
    click_option,
    help_of,
    machine_option,
    output_option,
)
from kurbel.cli.tables import MakingCommand, TableCommand
from kurbel.commands import construct as pages
from kurbel.commands.options import Choice
from kurbel.commands.parts.drawing import DrawingOptions
from kurbel.commands.plot import plot_mechanism
from kurbel.commands.shown import Drawing
from kurbel.errors import ProblemError
from kurbel.page.layouts import Folder
from kurbel.page.table import Table
from kurbel.reading.given import File

HELP = """\
Draw a construction of the books to scale, or print the lengths that it gives beside their true values.

The file says which: .svg, .png, .pdf and .pgf, for LaTeX's own fonts, are the drawing, .html is a page with
the steps to click through; other formats and --table are the table. Drawings need the extra `plot`. Without
NAME the constructions are listed.

\b
kurbel construct  # all there are
kurbel construct blau-9 --ratio 1:4 --angle 50  # its lengths
kurbel construct blau-9 --ratio 1:4 --angle 50 -o fig9.svg  # drawn
kurbel construct blau-9 --ratio 1:4 --angle 50 -o fig9.html  # to click through
kurbel construct roetscher-1047-line --offset 0.3 --ratio 1:4 -o abb1047.pgf
kurbel construct forces --ratio 1:4 -o kraefte.pdf
kurbel construct blau-9 --ratio 1:4 --angle 50 --table -o fig9.tex
"""
# What is for the table alone, beside what is on no drawing.
OF_TABLES = ("columns", "layout", "layouts", "units", "caption")
HEADS: Mapping[str, Sequence[str]] = {
    "de": ("Konstruktion", "was sie zeigt", "Getriebe"),
    "en": ("construction", "what it shows", "mechanisms"),
}
LAST = ("animate", "seconds", "width", "height", "lang", "units", "decimal")


class ConstructCommand(TableCommand):
    """The command, whose options are those of the table and of the drawing."""

    def __init__(self) -> None:
        super().__init__("construct", pages.construct.command)
        own = {one.name: click_option(one) for one in pages.plot_construction.command.parameters.values()}
        named = next(one for one in self.params if one.name == "format")
        assert isinstance(named, click.Option)
        named.help = (
            "Format of the drawing, svg, png, pdf, pgf or html, or of the table; default: by the suffix of"
            " -o, else text."
        )
        self.params += [
            Option(
                ["--table"], is_flag=True, topic="question", help="The table of the lengths, also as PDF."
            ),
            click_option(DrawingOptions.text),
            own["steps"],
            own["width"],
            own["height"],
        ]
        self.help, self.examples = with_examples(HELP)

    def made(self, given: TypedOptions) -> Table | Drawing:
        if given.values["name"] is None:
            raise ProblemError('"construct" prints a list; a document needs the name of a construction')
        if given.values["table"]:
            return super().made(given)
        check_drawing(given, "a construction", OF_TABLES)
        return self._drawn(given)

    def run(self, given: TypedOptions) -> int:
        if given.values["name"] is None:
            _print_list(given)
            return 0
        if given.values["table"]:
            check_page(given, "the table")
        elif name := drawing_format(given, (), OF_TABLES):
            write(self._drawn(given), name, given)
            return 0
        return super().run(given)

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("The constructions"):
            formatter.write_dl([(key, one.given.title["en"]) for key, one in _constructions()], col_max=26)

    def _drawn(self, given: TypedOptions) -> Drawing:
        drawing: Drawing = pages.plot_construction.command.ask(given)
        return drawing


def _print_list(given: TypedOptions) -> None:
    """Print the constructions; raise an error for options that the list has no use for."""
    form = form_of_list(given, ("lang", "constructions"), "a construction", "blau-9")
    lang, folder = given.text("lang"), given.values["constructions"]
    assert isinstance(folder, File | None)
    rows = [(key, one.given.title[lang], " ".join(one.given.holds)) for key, one in _constructions(folder)]
    listing = Listing("constructions", lang, ("construction", "title", "mechanisms"), rows, HEADS[lang], rows)
    show_list(listing, form, plain_lines([row[:2] for row in rows]))


def _constructions(folder: Folder | None = None) -> Iterator[tuple[str, Construction]]:
    for key in construction_names(folder):
        yield key, construction(key, folder)


construct = ConstructCommand()


class PlotCommand(MakingCommand):
    """The command, whose options are those of the function and of its files."""

    def __init__(self) -> None:
        command = plot_mechanism.command
        super().__init__("plot", params=_params(), help=help_of(command), in_short=command.asks.in_short)

    def made(self, given: TypedOptions) -> Drawing:
        drawing: Drawing = plot_mechanism.command.ask(given)
        return drawing

    def run(self, given: TypedOptions) -> int:
        name = _format(given)
        write(self.made(given), name, given)
        return 0


def _format(given: TypedOptions) -> str:
    """Return the format of -f or of the file's suffix; raise an error for one that cannot move, or that is
    only for what moves, and for a terminal, which takes none."""
    name, output = given.text("format"), given.text("output")
    if not output:
        raise click.UsageError("--output names no file; - is standard output.")
    check_terminal(output, "svg")
    if output == "-" and not name:
        raise click.UsageError("no file was named; add -o kurbel.svg, or -f svg for standard output")
    if output != "-" and not given.typed("format"):
        from kurbel.plot.style import format_of

        name = format_of(output, moves=given.says("animate"))
    check_moving(name, given.says("animate"))
    return name


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
        click_option(DrawingOptions.text),
    ]  # fmt: skip
    first = (param for name, param in own.items() if name not in LAST)
    return [machine_option(), *first, *output, *(own[name] for name in LAST)]


plot = PlotCommand()
