"""`kurbel sweep`: what can be swept, and the options of a sweep: those of its command, and its own."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING

import click

from kurbel.cli import COMMANDS, screen
from kurbel.cli.app import Group, command_of
from kurbel.cli.manual.topics import topics_of
from kurbel.cli.options import FileName, Option, Type, click_option, machine_option, output_option
from kurbel.cli.tables import TableCommand
from kurbel.commands import options as kinds
from kurbel.commands.options import Count, flag, word
from kurbel.commands.part import Part
from kurbel.commands.subject import Command
from kurbel.exact.numerals import MOST_DIGITS
from kurbel.sweeps.hands import MOST_JOBS

if TYPE_CHECKING:
    from kurbel.sweeps.rows import Sweep
    from kurbel.sweeps.run import SweepRunner

MOST_SEED = 9999
# What says nothing of columns of numbers, or is another thing of sweeps.
PAGES = frozenset(("label", "caption", "note", "source", "templates", "units", "digits"))


class _Listed(kinds.Kind):
    """A kind of which several are written with semicolons; they are read where the command is known."""

    def __init__(self, one: kinds.Kind) -> None:
        self.one = one
        self.name = one.name

    def offered(self, begun: str, typed: Mapping[str, object]) -> Iterable[str]:
        before, mark, last = begun.rpartition(";")
        return (before + mark + text for text in self.one.offered(last, typed))


class SweptOption(Option):
    """An option that may be given several times, and in the environment once."""

    def value_from_envvar(self, ctx: click.Context) -> tuple[str] | None:
        found = self.resolve_envvar_value(ctx)
        return None if found is None else (found,)


def own_options(command: Command) -> list[click.Parameter]:
    """Return the options of the command as those of a sweep."""
    params: list[click.Parameter] = [machine_option()] if command.machine else []
    return params + [_swept(one) for one in command.parameters.values() if one.name not in PAGES]


def _swept(option: kinds.Option[object]) -> click.Parameter:
    if option.kind is kinds.FLAG or option.last or option.first or isinstance(option.kind, kinds.LayoutName):
        return click_option(option)
    kind: object = FileName() if option.kind is kinds.FILE else Type(_Listed(option.kind))
    more: dict[str, object] = {"is_flag": False, "flag_value": option.bare} if option.bare else {}
    return SweptOption(
        [option.name, option.flag, *filter(None, [option.short])],
        type=kind,
        metavar=option.metavar,
        multiple=True,
        help=option.help,
        topic=option.topic,
        envvar=option.environment or None,
        **more,
    )


class SweepOptions(Part):
    """What is of sweeps alone: which combinations, what is known of each number, who computes."""

    topic = "combinations"

    format = word(
        "parquet, arrow, csv, netcdf or zarr; default: by the suffix of -o, a folder such as out/ for Parquet"
        " in partitions.",
        "FORM", short="-f", topic="output",
    )  # fmt: skip
    zip = word(
        "Options that go through their values together, not each with each: eps,back.", "NAMES", many=True
    )
    only = word(
        "Combinations to compute, the others are left out: 'eps*back < 1', 'ratio < 1/4'.",
        "CONDITION", many=True,
    )  # fmt: skip
    sample = word(
        "Points between the ends of ranges in place of a grid: random:1000, sobol:1024, halton:1000, or"
        " lhs:1000, the Latin hypercube.",
        "DESIGN",
    )
    seed: kinds.Option[int | None] = kinds.Option(
        "Of the sample: other points for another number; default 0.", "N",
        Count("seed", 0, MOST_SEED, "is no seed"),
    )  # fmt: skip
    digits: kinds.Option[int | None] = kinds.Option(
        "Certified decimals in place of floats, the very digits of the single command.", "N",
        Count("digits", 0, MOST_DIGITS, "cannot be stored"), topic="page",
    )  # fmt: skip
    bounds = flag("Beside each float how far from the true value it may lie at the most.")
    strict = flag("End at the first combination that is refused.")
    dry_run = flag(
        "Say how many rows, which columns, how large and how long, and write nothing.", topic="output"
    )
    scheduler = word(
        "Dask cluster that computes: tcp://HOST:8786, tls://HOST:8786, or scheduler.json.",
        "ADDRESS", topic="run",
    )  # fmt: skip
    jobs: kinds.Option[int | None] = kinds.Option(
        "Processes or threads at once on this machine; default: one for each core.", "N",
        Count("jobs", 1, MOST_JOBS), short="-j", topic="run",
    )  # fmt: skip
    resume = flag("Go on with the finished parts of a run that was ended.", topic="run")
    restart = flag("Begin anew, and remove the finished parts of such a run.", topic="run")


def sweep_options() -> list[click.Parameter]:
    """Return the options of sweeps alone."""
    first, *others = map(click_option, SweepOptions.options().values())
    return [first, output_option("File to write, whole or not at all: sweep.parquet."), *others]


@contextmanager
def running(asked: SweepOptions, sweep: Sweep, target: str) -> Iterator[SweepRunner]:
    """Give how to run a sweep into a target by these options; on a terminal a bar tells of it."""
    from kurbel.sweeps.run import SweepRunner

    how = SweepRunner(asked.scheduler, asked.jobs, asked.resume, asked.restart)
    count = len(sweep) if len(sweep) > sweep.rows_at_once else 0
    with screen.bar(count, target, _rate) as watch:
        yield replace(how, watch=watch)


def _rate(rows: float) -> str:
    """Return rows a second, to three figures."""
    power = 0 if rows < 999.5 else 1 if rows < 999.5e3 else 2
    return f"{rows / 1000**power:.3g} {('', 'thousand ', 'million ')[power]}rows/s"


# Those of books have nothing that varies.
TABLES = tuple(name for name, (module, _) in COMMANDS.items() if module.startswith("commands."))


class _Commands(Group):
    what = "command that can be swept"

    def further(self) -> Mapping[str, Sequence[click.Option]]:
        """Return the options of every sweep, by the heads below which manuals have them."""
        own = click.Command("sweep", params=sweep_options(), add_help_option=False)
        return {topic.title: options for topic, options in topics_of(own)}

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(TABLES)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        from kurbel.cli.sweep_command import FILE, SUFFIX, ReadFile, SweepCommand, words_of

        if not args[0].endswith(SUFFIX) or ctx.resilient_parsing:
            return super().resolve_command(ctx, args)
        read = ReadFile(args[0])
        command = self.get_command(ctx, read.declared.command)
        assert isinstance(command, SweepCommand)
        words, ctx.meta[FILE] = words_of(read, command, args[1:])
        return args[0], command, words

    def get_command(self, ctx: click.Context, name: str) -> click.Command | None:
        if name not in TABLES:
            return None
        from kurbel.cli.sweep_command import SweepCommand

        table = command_of(name)
        assert isinstance(table, TableCommand)
        return SweepCommand(name, f"kurbel.{COMMANDS[name][0]}:{name}", table.made_by)


@click.group(cls=_Commands, subcommand_metavar="COMMAND|FILE.toml [OPTIONS]...")
def sweep() -> None:
    """Compute a command at every combination of what its options are given, into a file of columns.

    \b
    kurbel sweep delta --eps 1..10:0.01 --ratio 1:3..8:0.05 -o delta.parquet
    kurbel sweep table --ratio 1:3..8 --step 0.01 --columns x,c -o motion.parquet
    kurbel sweep sweep.toml --dry-run

    COMMAND has the options that it has by itself, and each takes several values: lists '2;3;4', ranges
    2..6:0.5 with units, words. A file sweep.toml says the same: command, [axes], [options], output; what is
    typed outdoes it.
    """
