"""The pages of the command line, a page a command, made of the commands themselves."""

from __future__ import annotations

import inspect
from collections.abc import Iterable, Iterator

import click
from markdown import described, directive, plain, table, toctree

from kurbel.cli import COMMANDS, LANGUAGES, SUMMARY, VARIABLES
from kurbel.cli.app import HELP_OPTIONS, cli, command_of
from kurbel.cli.manual.topics import topics_of
from kurbel.cli.tables import MakingCommand

FOLDER = "reference/command-line"
CODES = (
    ("0", "Done."),
    ("1", "Failed, or with `--check` and `--strict` something is stale or deviates; one sentence says what."),
    ("2", "Wrong usage."),
)


def pages() -> Iterator[tuple[str, str]]:
    yield f"{FOLDER}/index.md", "\n\n".join(_overview()) + "\n"
    yield f"{FOLDER}/kurbel.md", "\n\n".join(_kurbel()) + "\n"
    for name in COMMANDS:
        page = "\n\n".join(_page(command_of(name), f"kurbel {name}", "#"))
        yield f"{FOLDER}/{name}.md", page + "\n"


def _overview() -> Iterator[str]:
    yield "# Command line"
    yield plain(
        "Every command prints its own help, in short by `kurbel table -h`, whole by `kurbel table --help`."
    )
    yield _listed()
    yield toctree(("kurbel", *COMMANDS), ":hidden:")


def _listed() -> str:
    rows = ((f"[`kurbel {name}`]({name}.md)", line) for name, (_, line) in COMMANDS.items())
    return table(("command", "what it does"), rows)


def _kurbel() -> Iterator[str]:
    """Yield kurbel itself; the list of all pages stands elsewhere, or its manual page would have them all."""
    yield "# kurbel"
    yield plain(f"{SUMMARY} {LANGUAGES}")
    yield directive("program", "kurbel", "")
    yield from _described(cli.get_params(_context(cli, "kurbel")), _context(cli, "kurbel"))
    yield "## Commands"
    yield plain("Each has its own help, `kurbel table --help`, and a manual page, `man kurbel-table`.")
    yield _listed()
    yield "## Environment"
    yield plain(VARIABLES)
    yield "## Exit status"
    yield table(("code", "what it says"), CODES)


def _page(command: click.Command, name: str, level: str) -> Iterator[str]:
    yield f"{level} {name}"
    context = _context(command, name)
    yield from described(inspect.cleandoc(command.help or ""))
    yield f"```text\n{name} {' '.join(command.collect_usage_pieces(context))}\n```"
    yield directive("program", name, "")
    if isinstance(command, MakingCommand):
        for topic, options in topics_of(command):
            yield f"{level}# {topic.title}"
            yield from _described(options, context)
    else:
        yield from _described(command.get_params(context), context)
    if hasattr(command, "further"):
        # Of a group whose commands are told elsewhere.
        for title, options in command.further().items():
            yield f"{level}# {title}"
            yield from _described(options, context)
    if isinstance(command, click.Group):
        for one, inner in command.commands.items():
            yield from _page(inner, f"{name} {one}", f"{level}#")


def _context(command: click.Command, name: str) -> click.Context:
    context = click.Context(command, info_name=name)
    context.help_option_names = HELP_OPTIONS
    return context


def _described(options: Iterable[click.Parameter], context: click.Context) -> Iterator[str]:
    for one in options:
        if record := one.get_help_record(context):
            written, about = record
            yield directive("option", written, plain(about))
