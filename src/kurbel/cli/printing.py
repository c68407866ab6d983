"""From what was asked for to a file: the pages whole, the records of long tables in a stream."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING, Any, NamedTuple

import click

from kurbel.cli.rivals import Given
from kurbel.formats.output import whole_file
from kurbel.formats.registry import DEFAULT, FORMATS, CompiledFormat, Format, RecordsFormat, for_suffix

if TYPE_CHECKING:
    from kurbel.page.subject import Question
    from kurbel.page.table import Table

# Shorter tables are done before a bar could be read.
BAR_ROWS = 200_000


class Printing(NamedTuple):
    """How a table is to be printed: the options that all printing commands share."""

    format: Format
    output: str
    decimal: str | None
    standalone: bool
    longtable: bool

    @classmethod
    def chosen(cls, given: Given) -> Printing:
        """Return what the options say, checked."""
        names = ("output", "decimal", "standalone", "longtable")
        return cls(_format(given), *(given.values[name] for name in names))


def _format(given: Given) -> Format:
    """Return the format named by -f, or by the file's suffix, or by the environment, or text."""
    named, output = given.values["format"], given.values["output"]
    if not output:
        raise click.UsageError("--output names no file; - is standard output.")
    chosen = FORMATS[named or DEFAULT] if output == "-" or given.typed("format") else for_suffix(output)
    if chosen.kind == "compiled" and output == "-" and sys.stdout.isatty():
        name = chosen.name
        raise click.UsageError(f"a terminal shows no {name}; name a file, such as -o kurbel.{name}")
    if given.typed("standalone") and chosen.kind != "compiled" and not chosen.standalone:
        *documents, last = (name for name, entry in FORMATS.items() if entry.standalone)
        raise click.UsageError(
            f"--standalone is for {', '.join(documents)} and {last}; {chosen.name} has no documents."
        )
    if given.typed("longtable") and not chosen.breaks:
        breaking = ", ".join(name for name, entry in FORMATS.items() if entry.breaks)
        raise click.UsageError(f"--longtable is for {breaking}; the format is {chosen.name}.")
    return chosen


def print_table(request: Question, printing: Printing) -> None:
    """Write the table in the format to the file, whole or not at all."""
    chosen = printing.format
    if not isinstance(chosen, RecordsFormat):
        from kurbel.page.build import build

        print_made(build(request), printing)
        return
    from kurbel.formats.streams import record_chunks

    pieces = record_chunks(request, chosen, chosen.decimal_name(request.lang, printing.decimal))
    _write(pieces, printing.output, len(request))


def print_made(table: Table, printing: Printing) -> None:
    """Write a table that is there already."""
    _write(_rendered(table, printing), printing.output, 0)


def _write(pieces: Iterator[bytes], output: str, rows: int) -> None:
    # The first piece is made before the file is opened, so that bad input leaves no trace.
    first = next(pieces)
    with whole_file(output) as stream, _bar(rows) as bar:
        stream.write(first)
        for piece in pieces:
            stream.write(piece)
            bar.update(1)


def _rendered(table: Table, printing: Printing) -> Iterator[bytes]:
    form, output, decimal, standalone, longtable = printing
    if isinstance(form, CompiledFormat):
        yield form.writer.compiled(table, decimal)
        return
    from kurbel.formats.render import render

    width = None
    if output == "-" and sys.stdout.isatty():
        from shutil import get_terminal_size

        width = get_terminal_size().columns
    text = render(table, form.name, decimal=decimal, standalone=standalone, longtable=longtable, width=width)
    yield text.encode()
    if not (standalone or longtable) and form.is_tall(table):
        click.echo("kurbel: the table is longer than a page; --longtable lets it break", err=True)


class _NoBar:
    def update(self, steps: int) -> None:
        """Show nothing."""


def _bar(rows: int) -> AbstractContextManager[Any]:
    """A bar on the terminal for long tables, counted in chunks of rows."""
    from kurbel.motion.page import CHUNK

    if rows < BAR_ROWS or not sys.stderr.isatty():
        return nullcontext(_NoBar())
    return click.progressbar(length=-(-rows // CHUNK), label=f"{rows} rows", file=sys.stderr)
