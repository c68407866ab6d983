"""The click application: commands are imported when they are called, and errors become one sentence."""

from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from functools import cache
from typing import Any

import click

from kurbel import __version__
from kurbel.cli import COMMANDS, INTERRUPTED, help_text, say, screen, short_help, tell
from kurbel.errors import ChoiceError, KurbelError

HELP_OPTIONS = ["-h", "--help"]


@cache
def command_of(name: str) -> click.Command:
    """Return the command of that name, made of its function where it prints a table."""
    found = getattr(importlib.import_module(f"kurbel.{COMMANDS[name][0]}"), name)
    if isinstance(found, click.Command):
        return found
    from kurbel.cli.tables import TableCommand

    return TableCommand(name, found.command)


class Group(click.Group):
    """Commands in the order of their use; a wrong name is answered with the nearest."""

    what = "command"

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(self.commands)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        from kurbel.reading.given import allowed_name

        # The help text is the answer to an option in place of a command.
        if not args[0].startswith("-") and not ctx.resilient_parsing:
            try:
                args = [allowed_name(args[0], self.list_commands(ctx), self.what), *args[1:]]
            except ChoiceError:
                from kurbel.cli.misplaced import instead_of

                if self.what == Group.what and (hint := instead_of(args[0])):
                    raise ChoiceError(f'there is no command "{args[0][:60]}"; {hint}') from None
                raise
        return super().resolve_command(ctx, args)


class LazyGroup(Group):
    """A group that imports a command's module only to run it or to print its own help."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, name: str) -> click.Command | None:
        return command_of(name) if name in COMMANDS else None

    def get_help(self, ctx: click.Context) -> str:
        return help_text().rstrip()

    def make_context(self, *words: Any, **more: Any) -> click.Context:
        with _before_click():
            return super().make_context(*words, **more)

    def invoke(self, ctx: click.Context) -> object:
        with _before_click():
            return super().invoke(ctx)


class ClosedPipe(Exception):
    """A pipe that nobody reads any longer; the system's own error would be a failure for click."""


@contextmanager
def _before_click() -> Iterator[None]:
    try:
        yield
    except BrokenPipeError as error:
        raise ClosedPipe from error


# Where a context keeps that long pages go through no pager.
UNPAGED = "kurbel.cli.screen"


def _without_pager(context: click.Context, parameter: click.Parameter, asked: bool) -> None:
    context.meta[UNPAGED] = asked


def show(pieces: Iterable[bytes], has_words: bool = True) -> None:
    """Write what a command prints to standard output, on a terminal through a pager what is long.

    One who reads no German is told how words come to be English, unless a language was chosen.
    """
    context = click.get_current_context(silent=True)
    screen.show(pieces, paging=not (context and context.meta.get(UNPAGED)))
    if not (has_words and context and sys.stdout.isatty() and sys.stderr.isatty()):
        return
    unasked = context.get_parameter_source("lang") is click.core.ParameterSource.DEFAULT
    if unasked and not screen.reads_german(os.environ):
        say(screen.HINT)


def _show_help(context: click.Context, parameter: click.Parameter, asked: bool) -> None:
    if asked and not context.resilient_parsing:
        text = short_help() if parameter.opts == ["-h"] else help_text()
        show([text.encode(sys.stdout.encoding, errors="replace")], has_words=False)
        context.exit()


@click.group(
    cls=LazyGroup,
    add_help_option=False,
    context_settings={"help_option_names": HELP_OPTIONS, "auto_envvar_prefix": "KURBEL"},
)
@click.option(
    "--no-pager",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_without_pager,
    help="Print long pages on a terminal without a pager.",
)
@click.option(
    "short",
    "-h",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_show_help,
    allow_from_autoenv=False,
    help="Show the commands by their names alone.",
)
@click.option(
    "whole", "--help", is_flag=True, is_eager=True, expose_value=False, callback=_show_help,
    allow_from_autoenv=False, help="Show what each command does.",
)  # fmt: skip
@click.version_option(__version__, "--version", message="kurbel %(version)s")
def cli() -> None:
    """Compute and typeset tables of the crank drive; every printed digit is right."""


def run() -> tuple[int, str]:
    """Run the command of the command line; return its exit code and, if it failed, why."""
    if "_KURBEL_COMPLETE" in os.environ:
        _complete_lists()
    try:
        result = cli.main(prog_name="kurbel", standalone_mode=False)
        sys.stdout.flush()
        return (result if isinstance(result, int) else 0), ""
    except ClosedPipe as closed:
        raise BrokenPipeError from closed
    except KurbelError as error:
        return error.exit_code, str(error)
    except click.Abort:
        return INTERRUPTED, ""
    except click.exceptions.NoArgsIsHelpError as error:
        tell(f"{error.format_message()}\n")
        return error.exit_code, ""
    except click.ClickException as error:
        from kurbel.cli.misplaced import one_line

        return error.exit_code, one_line(error, sys.argv[1:])


def _complete_lists() -> None:
    """Have fish complete lists such as phi,x,c: click's script cuts every candidate at its first comma."""
    from click.shell_completion import FishComplete, add_completion_class

    class ListFishComplete(FishComplete):
        source_template = FishComplete.source_template.replace('string split ","', 'string split --max 1 ","')

    add_completion_class(ListFishComplete)
