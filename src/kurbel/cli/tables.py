"""The commands that make a table or a drawing, for paper or for a document; those of tables are made from the
function that makes the table in Python. Pages are written whole, the records of long tables in a stream."""

from __future__ import annotations

import os
import sys
from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from itertools import chain, islice
from typing import TYPE_CHECKING, Any, NamedTuple

import click
from click.core import augment_usage_errors

from kurbel.cli import say, screen
from kurbel.cli.app import show
from kurbel.cli.drawings import UNDRAWN, check_undrawn, drawing_format, drawing_options, drawn, write
from kurbel.cli.manual.command import TopicCommand
from kurbel.cli.options import TypedOptions, click_option, help_of, machine_option, printing_options
from kurbel.commands.subject import Command
from kurbel.errors import FailedError, ProblemError
from kurbel.exact.numerals import ROUNDINGS
from kurbel.formats.registry import DEFAULT, FORMATS, BytesFormat, Format, RecordsFormat, for_suffix
from kurbel.formats.render import render, whole_file
from kurbel.page.subject import Question
from kurbel.page.table import Table
from kurbel.reading.names import enumerated

if TYPE_CHECKING:
    from kurbel.commands.shown import Drawing
    from kurbel.page.steps import Step

# What asks for colours where there is no terminal.
FORCED = frozenset(("FORCE_COLOR", "CLICOLOR_FORCE"))
# What helps, where a format alone says too little.
HINTS = {"interactive": ", so add -f html or -o page.html"}
# Shorter tables are done before a bar could be read.
BAR_ROWS = 200_000
BAR_STEPS = 100


class MakingCommand(TopicCommand, ABC):
    """A command of which a document can ask what it makes."""

    @abstractmethod
    def made(self, given: TypedOptions) -> Table | Drawing:
        """Return the table or the drawing. Raises KurbelError, also where the command prints and fails."""

    @abstractmethod
    def run(self, given: TypedOptions) -> int:
        """Print what the options say, and return the exit code."""

    def invoke(self, ctx: click.Context) -> int:
        with augment_usage_errors(ctx):
            return self.run(TypedOptions(ctx))


class TableCommand(MakingCommand):
    """The command of a function; `more` options, by what they stand before, are of the command line alone.

    A drawing is one of its formats, unless its pages are none of numbers or it draws in a way of its own.
    """

    def __init__(
        self, name: str, command: Command, more: Mapping[str, Sequence[click.Parameter]] | None = None
    ) -> None:
        params, self.draws = _params(name, command, more or {}), name not in UNDRAWN
        super().__init__(
            name,
            params=[*params, *drawing_options()] if self.draws else params,
            help=help_of(command),
            in_short=command.asks.in_short,
        )
        self.made_by = command

    def question(self, given: TypedOptions) -> Any:
        """Return what is asked for. Raises KurbelError."""
        return self.made_by.ask(given)

    def check(self, given: TypedOptions, question: Question) -> None:
        """Raise FailedError where the command fails once it has printed."""

    def made(self, given: TypedOptions) -> Table | Drawing:
        is_drawn = self.draws and drawing_format(given)
        if not is_drawn:
            # What cannot be printed so is refused, too.
            PrintOptions.chosen(given)
            if PrintOptions.interactive(given):
                return self.stepped(given)
        question = self.question(given)
        self.check(given, question)
        return drawn(question, given) if is_drawn else self.made_by.built(question, given)

    def stepped(self, given: TypedOptions) -> Table:
        """Return the table of an interactive page, with those of its steps. Raises KurbelError."""
        from kurbel.commands.stepped import NOTHING, stepped

        page = stepped(self.made_by, given)
        if page.steps is None and given.typed("interactive"):
            raise ProblemError(NOTHING)
        return page

    def run(self, given: TypedOptions) -> int:
        if self.draws and (name := drawing_format(given)):
            question = self.question(given)
            write(drawn(question, given), name, given)
            self.check(given, question)
            return 0
        printing = PrintOptions.chosen(given)
        if PrintOptions.interactive(given):
            page = self.stepped(given)
            with _counted(page) as counted:
                printing._replace(standalone=True).print(counted)
            return 0
        question = self.question(given)
        self.print(question, printing, given)
        self.check(given, question)
        return 0

    def print(self, question: Question, printing: PrintOptions, given: TypedOptions) -> None:
        """Write the table to the file, whole or not at all."""
        if isinstance(printing.format, RecordsFormat):
            from kurbel.commands.streams import record_chunks

            form = printing.format.for_excel if printing.excel else printing.format
            decimal = form.decimal_name(question.lang, printing.decimal)
            request = self.made_by.request(question, given)
            _write(record_chunks(question, request, form, decimal), printing.output, len(question))
        else:
            with screen.counted():
                page = self.made_by.built(question, given)
            printing.print(page)


class CollateCommand(TableCommand):
    """`kurbel collate`, which may fail, and takes neither digits nor rounding."""

    def question(self, given: TypedOptions) -> Any:
        if given.values["digits"] is not None:
            raise ProblemError(
                "--digits has no use here: a value is recomputed to as many places as are printed"
            )
        if given.values["rounding"] != ROUNDINGS[0]:
            raise ProblemError(
                "--rounding has no use here: printed values are held against half rounded away"
            )
        return super().question(given)

    def check(self, given: TypedOptions, question: Any) -> None:
        if given.says("strict") and question.deviations:
            raise FailedError(f"printed values deviate ({len(question.deviations)}), and --strict fails then")


def _params(
    name: str, command: Command, more: Mapping[str, Sequence[click.Parameter]]
) -> list[click.Parameter]:
    own = {one.name: click_option(one) for one in command.parameters.values()}
    last = printing_options(name, {**own, **{one.name or "": one for one in more.get("", ())}})
    params: list[click.Parameter] = [machine_option()] if command.machine else []
    for key, param in own.items():
        if param not in last:
            params += [*more.get(key, ()), param]
    return params + last


class PrintOptions(NamedTuple):
    """How a table is to be printed: the options that all printing commands share."""

    format: Format
    output: str
    decimal: str | None
    standalone: bool
    longtable: bool
    siunitx: bool
    plain: bool
    excel: bool

    @classmethod
    def chosen(cls, given: TypedOptions) -> PrintOptions:
        """Return what the options say, checked."""
        return cls._make((_format(given), *(given.values[name] for name in cls._fields[1:])))

    @staticmethod
    def interactive(given: TypedOptions) -> bool:
        """Whether an interactive page is asked for; of a default from elsewhere in one format alone."""
        if not given.values.get("interactive"):
            return False
        if given.in_document:
            return not given.values["format"]
        return given.typed("interactive") or "interactive" in _format(given).takes

    def print(self, table: Table) -> None:
        """Write a table that is there already."""
        _write(self._rendered(table), self.output, 0)

    def _rendered(self, table: Table) -> Iterator[bytes]:
        form = self.format
        if isinstance(form, BytesFormat):
            # How much it takes is of use before it begins.
            for remark in form.remarks(table, True):
                say(remark)
            yield form.content(table, self.decimal)
            return
        width, colours = None, False
        if self.output == "-" and (sys.stdout.isatty() or not FORCED.isdisjoint(os.environ)):
            width, colours = screen.width(), screen.has_colours()
        wishes = {name: value for name, value in self._asdict().items() if name not in ("format", "output")}
        yield render(table, form.name, width=width, colours=colours, **wishes).encode()
        for remark in form.remarks(table, self.standalone or self.longtable):
            say(remark)


def _format(given: TypedOptions) -> Format:
    """Return the format named by -f, or by the file's suffix, or by the environment, or text."""
    named, output = given.text("format"), given.text("output")
    if not output:
        raise click.UsageError("--output names no file; - is standard output.")
    check_undrawn(given)
    if named not in FORMATS:
        # A drawing by the environment is for pages that have one.
        named = DEFAULT
    chosen = FORMATS[named] if output == "-" or given.typed("format") else for_suffix(output)
    of_bytes = isinstance(chosen, BytesFormat)
    if of_bytes and output == "-" and sys.stdout.isatty():
        name = chosen.name
        raise click.UsageError(f"a terminal shows no {name}; name a file, such as -o kurbel.{name}")
    if given.typed("templates"):
        from kurbel.formats.templates import is_set_by_template

        if not is_set_by_template(chosen):
            raise click.UsageError(f"--templates sets no {chosen.name}, which has no template; leave it out.")
    if given.typed("standalone") and not of_bytes and "standalone" not in chosen.takes:
        documents = enumerated(name for name, entry in FORMATS.items() if "standalone" in entry.takes)
        raise click.UsageError(f"--standalone is for {documents}; {chosen.name} has no documents.")
    for option in ("longtable", "siunitx", "plain", "excel"):
        _check_able(given, chosen, option)
    _check_interactive(given, chosen)
    return chosen


def _check_interactive(given: TypedOptions, chosen: Format) -> None:
    """Raise UsageError for an interactive page that is no page by itself, nor part of a handbook."""
    if not given.typed("interactive"):
        return
    if given.in_document and given.values["format"]:
        raise click.UsageError(
            "--interactive makes a whole page, with a script; it is for -o page.html and for handbooks, not"
            " for places in a document of your own."
        )
    if not given.in_document:
        _check_able(given, chosen, "interactive")


def _check_able(given: TypedOptions, chosen: Format, option: str) -> None:
    """Raise UsageError for an option that was typed and is not for the format."""
    if given.typed(option) and option not in chosen.takes:
        able = ", ".join(name for name, entry in FORMATS.items() if option in entry.takes)
        raise click.UsageError(
            f"--{option} is for {able}; the format is {chosen.name}{HINTS.get(option, '')}."
        )


def _write(pieces: Iterator[bytes], output: str, rows: int) -> None:
    # The first piece is made before the file is opened, so that bad input leaves no trace; that of records
    # is their heads alone.
    first = next(pieces)
    if rows:
        pieces = chain([*islice(pieces, 1)], pieces)
    if output == "-" and sys.stdout.isatty():
        show(chain([first], pieces), has_words=not rows)
        return
    with whole_file(output) as stream, screen.bar(_chunks(rows), f"{rows} rows") as done:
        stream.write(first)
        for piece in pieces:
            stream.write(piece)
            done(1)


def _chunks(rows: int) -> int:
    """Return how many chunks a long table has, of whose rows a bar tells."""
    if rows < BAR_ROWS:
        return 0
    from kurbel.motion.bulk import CHUNK

    return -(-rows // CHUNK)


@contextmanager
def _counted(page: Table) -> Iterator[Table]:
    """Give an interactive page whose steps a bar on the terminal counts, if they are many."""
    steps = page.steps
    count = len(steps or ())
    with screen.bar(count if count >= BAR_STEPS else 0, f"{count} steps") as done:

        def make() -> Iterator[Step]:
            for step in steps or ():
                yield step
                done(1)

        yield replace(page, steps=steps and replace(steps, make=make))
