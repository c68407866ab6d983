"""The command line: parses, calls, writes. Commands are imported when they are called."""

from __future__ import annotations

import importlib
import io
import os
import signal
import sys
from types import FrameType
from typing import NoReturn

import click

from kurbel import __version__
from kurbel.errors import KurbelError

# Name, module and one line of help, so that `kurbel --help` imports no command.
COMMANDS = {
    "table": ("kurbel.cli.table", "Print a table of piston path, velocity and acceleration."),
    "layouts": ("kurbel.cli.lists", "List the page layouts."),
    "quantities": ("kurbel.cli.lists", "List the quantities that columns can show."),
}


class LazyGroup(click.Group):
    """A group that imports a command's module only to run it or to print its own help."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, name: str) -> click.Command | None:
        if name not in COMMANDS:
            return None
        command = getattr(importlib.import_module(COMMANDS[name][0]), name)
        assert isinstance(command, click.Command)
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl([(name, line) for name, (_, line) in COMMANDS.items()])

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        from kurbel.choices import choose

        # The help text is the answer to an option in place of a command.
        if not args[0].startswith("-") and not ctx.resilient_parsing:
            choose(args[0], COMMANDS, "command")
        return super().resolve_command(ctx, args)


@click.group(
    cls=LazyGroup,
    context_settings={"help_option_names": ["-h", "--help"], "auto_envvar_prefix": "KURBEL"},
    epilog="Environment: KURBEL_LANG, KURBEL_FORMAT, KURBEL_DECIMAL, KURBEL_TABLE_RATIO ... set defaults.",
)
@click.version_option(__version__, "--version", message="kurbel %(version)s")
def cli() -> None:
    """Compute and typeset tables of the crank drive; every printed digit is right."""


def main() -> NoReturn:
    """Run the command line and leave with its exit code: 0 done, 1 failed, 2 wrong usage."""
    _open_closed_streams()
    if isinstance(sys.stdout, io.TextIOWrapper):
        # Help and lists have characters, such as ∞, that an old terminal lacks.
        sys.stdout.reconfigure(errors="replace")
    for number in (signal.SIGTERM, signal.SIGHUP):
        # nohup has a program ignore the end of its terminal.
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, _terminated)
    try:
        code = _run()
    except BrokenPipeError:
        code = _silenced(128 + signal.SIGPIPE)
    except OSError as error:
        code = _failed(f"cannot write: {error.strerror or error}", 1)
        _silenced(code)
    except KeyboardInterrupt:
        code = 128 + signal.SIGINT
    sys.exit(code)


def _open_closed_streams() -> None:
    """Replace streams that the caller closed (>&-) and Python has as None.

    Errors go nowhere; print would put them among the data. Data cannot be written, which is an error.
    """
    if sys.stderr is None:
        sys.stderr = os.fdopen(os.open(os.devnull, os.O_WRONLY), "w")
    if sys.stdout is None:
        sys.stdout = os.fdopen(os.open(os.devnull, os.O_RDONLY), "w")


def _run() -> int:
    try:
        result = cli.main(prog_name="kurbel", standalone_mode=False)
        sys.stdout.flush()
        return result if isinstance(result, int) else 0
    except KurbelError as error:
        return _failed(str(error), error.exit_code)
    except click.Abort:
        return 128 + signal.SIGINT
    except click.exceptions.NoArgsIsHelpError as error:
        print(error.format_message(), file=sys.stderr)
        return error.exit_code
    except click.ClickException as error:
        return _failed(_one_line(error), error.exit_code)


def _one_line(error: click.ClickException) -> str:
    """Return click's sentences as one of ours."""
    if isinstance(error, click.NoSuchOption):
        from kurbel.choices import did_you_mean

        hint = did_you_mean(error.option_name, error.possibilities or ())
        message = f'there is no option "{error.option_name}"{hint}'
    else:
        message = " ".join(error.format_message().split()).rstrip(".").replace(". ", "; ")
    command = getattr(getattr(error, "ctx", None), "command_path", "")
    return f"{message}; see {command} --help" if command else message


def _failed(message: str, code: int) -> int:
    # The user's own text may have line ends and other controls.
    shown = "".join(one if one.isprintable() else ascii(one)[1:-1] for one in message)
    print(f"kurbel: {shown}", file=sys.stderr)
    return code


def _silenced(code: int) -> int:
    """Keep the interpreter from complaining about a stream that takes nothing more."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return code


def _terminated(number: int, frame: FrameType | None) -> None:
    # As an exception, so that half-written files are removed.
    raise SystemExit(128 + number)
