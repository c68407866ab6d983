"""The help of a command: what it does, examples that fit the terminal, and its options in their sections."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import click

from kurbel.cli import LANGUAGES
from kurbel.cli.manual.sections import sections

# What an option takes in the first column; a longer one has its sentence below it.
WIDEST = 26
# What stands before a line that goes on an example of the shell.
FURTHER = 4
# Where such a line can begin: at an option.
_OPTION = re.compile(r" (?=--?[a-z])")


def write_text(text: str, formatter: click.HelpFormatter) -> None:
    """Write what the command does, and how pages come to be in English."""
    formatter.write_paragraph()
    with formatter.indentation():
        formatter.write_text(folded(text, formatter.width - formatter.current_indent))
        formatter.write_paragraph()
        formatter.write_text(LANGUAGES)


def folded(text: str, width: int) -> str:
    """Return the text with examples of the shell on as many lines as they need."""
    return "\n".join(
        line for one in text.split("\n") for line in (_folded(one, width) if _is_example(one) else (one,))
    )


def _is_example(line: str) -> bool:
    return line.startswith("kurbel ")


def _folded(example: str, width: int) -> Iterator[str]:
    first, *options = _OPTION.split(example)
    line = first
    for place, option in enumerate(options):
        # The backslash that goes on needs two columns, but behind the last option.
        room = width - (2 if place < len(options) - 1 else 0)
        if len(line) + 1 + len(option) > room:
            yield f"{line} \\"
            line = " " * FURTHER + option
        else:
            line += f" {option}"
    yield line


def write_options(command: click.Command, context: click.Context, formatter: click.HelpFormatter) -> None:
    """Write the options in their sections, their sentences below each other throughout."""
    found = {title: list(_records(options, context)) for title, options in sections(command)}
    width = max(len(written) for rows in found.values() for written, _ in rows if len(written) <= WIDEST)
    for title, ((written, said), *others) in found.items():
        with formatter.section(title):
            # The first column is as wide as what stands in its section.
            formatter.write_dl([(written.ljust(width), said), *others], col_max=WIDEST)


def _records(options: Sequence[click.Option], context: click.Context) -> Iterator[tuple[str, str]]:
    for one in options:
        if record := one.get_help_record(context):
            yield record
