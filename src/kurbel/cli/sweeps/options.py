"""The options of a sweep: those of its command, each of which takes several values, and its own."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import click

from kurbel.cli.options import FileName, Option, Type, click_option, machine_option, output_option
from kurbel.commands import options as kinds
from kurbel.commands.subject import Command
from kurbel.exact.numerals import MOST_DIGITS

MOST_SEED = 9999
# What says nothing of columns of numbers, or is another thing of sweeps.
PAGES = frozenset(("label", "caption", "note", "source", "templates", "units", "digits"))


class _Listed(kinds.Kind):
    """A kind of which several are written with semicolons; they are read where the command is known."""

    def __init__(self, one: kinds.Kind) -> None:
        self.one = one
        self.name = one.name

    def offered(self, begun: str, typed: Mapping[str, Any]) -> Iterable[str]:
        before, mark, last = begun.rpartition(";")
        return (before + mark + text for text in self.one.offered(last, typed))


class SweptOption(Option):
    """An option that may be given several times, and in the environment once."""

    def value_from_envvar(self, ctx: click.Context) -> Any:
        found = self.resolve_envvar_value(ctx)
        return None if found is None else (found,)


def own_options(command: Command) -> list[click.Parameter]:
    """Return the options of the command as those of a sweep."""
    params: list[click.Parameter] = [machine_option()] if command.machine else []
    return params + [_swept(one) for one in command.parameters.values() if one.name not in PAGES]


def _swept(option: kinds.Option[Any]) -> click.Parameter:
    if option.kind is kinds.FLAG or option.last or option.first or isinstance(option.kind, kinds.LayoutName):
        return click_option(option)
    kind: Any = FileName() if option.kind is kinds.FILE else Type(_Listed(option.kind))
    more: dict[str, Any] = {"is_flag": False, "flag_value": option.bare} if option.bare else {}
    return SweptOption(
        [option.name, option.flag, *filter(None, [option.short])],
        type=kind,
        metavar=option.metavar,
        multiple=True,
        help=option.help,
        envvar=option.environment or None,
        **more,
    )


def sweep_options() -> list[click.Parameter]:
    """Return the options of sweeps alone."""
    return [
        Option(["format", "-f", "--format"], metavar="FORM",
               help="parquet, arrow, csv, netcdf or zarr; default: by the suffix of -o, a folder such as out/"
               " for Parquet in partitions."),
        output_option("File to write, whole or not at all: sweep.parquet."),
        Option(["zip_", "--zip"], multiple=True, metavar="NAMES",
               help="Options that go through their values together, not each with each: eps,back."),
        Option(["--only"], multiple=True, metavar="CONDITION",
               help="Combinations to compute, the others are left out: 'eps*back < 1', 'ratio < 1/4'."),
        Option(["--sample"], metavar="DESIGN",
               help="Points between the ends of ranges in place of a grid: random:1000, sobol:1024,"
               " halton:1000, or lhs:1000, the Latin hypercube."),
        Option(["--seed"], type=Type(kinds.Count("seed", 0, MOST_SEED, "is no seed")), metavar="N",
               help="Of the sample: other points for another number; default 0."),
        Option(["--digits"], metavar="N",
               type=Type(kinds.Count("digits", 0, MOST_DIGITS, "cannot be stored")),
               help="Certified decimals in place of floats, the very digits of the single command."),
        Option(["--bounds"], is_flag=True,
               help="Beside each float how far from the true value it may lie at the most."),
        Option(["--strict"], is_flag=True, help="End at the first combination that is refused."),
        Option(["--dry-run"], is_flag=True,
               help="Say how many rows, which columns, how large and how long, and write nothing."),
    ]  # fmt: skip
