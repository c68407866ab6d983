"""One command as a sweep: its options with their several values become a plan, and that a file."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import click
from click.core import augment_usage_errors

from kurbel.cli import say
from kurbel.cli.manual.command import TopicCommand
from kurbel.cli.manual.examples import SWEEPS
from kurbel.cli.options import Given, help_of
from kurbel.cli.sweep import SweepRequest, own_options, running, running_options, sweep_options
from kurbel.cli.sweep_file import FILE
from kurbel.commands.part import Origin, Values, flag_of
from kurbel.commands.subject import Command
from kurbel.reading.environment import need
from kurbel.sweeps.asked import planned
from kurbel.sweeps.hands import cores

if TYPE_CHECKING:
    from kurbel.sweeps.plan import Plan
    from kurbel.sweeps.rows import Sweep
    from kurbel.sweeps.run import Outcome

# Where a context keeps the options in the order in which they were typed.
ORDER = "kurbel.cli.sweep.order"


class SweepCommand(TopicCommand):
    """The sweep of a command, which lies at a place."""

    swept = True

    def __init__(self, name: str, place: str, command: Command) -> None:
        super().__init__(
            name,
            params=[*own_options(command), *sweep_options(), *running_options()],
            help=help_of(command),
            in_short=command.asks.in_short,
        )
        self.place, self.asking = place, command
        line = f"kurbel sweep {name} {SWEEPS[name]}"
        self.examples = [(line, "into a file"), (f"{line} --dry-run", "how much, how long")]

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        with augment_usage_errors(ctx):
            if not ctx.resilient_parsing:
                *_, order = self.make_parser(ctx).parse_args(args=[*args])
                ctx.meta[ORDER] = [one.name for one in order]
        return super().parse_args(ctx, args)

    def invoke(self, ctx: click.Context) -> int:
        with augment_usage_errors(ctx):
            return self.run(Given(ctx), ctx.meta[ORDER])

    def run(self, given: Given, order: Sequence[str]) -> int:
        """Write the file, and return the exit code."""
        from kurbel.sweeps.rows import Sweep

        asked = SweepRequest.of(given.values)
        sweep, output, form = Sweep(self.plan(given, order)), asked.output, asked.format
        need("a file of columns", "scale", "pyarrow")
        if asked.dry_run:
            show_estimate(sweep, output, form)
            return 0
        if not output:
            raise click.UsageError(
                "a sweep needs a file to write, -o sweep.parquet; --dry-run says how large it would be"
            )
        from kurbel.sweeps.run import run

        with running(asked, sweep) as how:
            outcome = run(sweep, output, how, form)
        if output != "-" or outcome.refused:
            say(_told(output, outcome))
        return 0

    def plan(self, given: Given, order: Sequence[str]) -> Plan:
        """Return the plan that the options make: in the order of the file, then of the command line, and
        behind them what comes from elsewhere. Raises KurbelError."""
        values, file = given.values, click.get_current_context().meta.get(FILE, {})
        asked = SweepRequest.of(values)
        flags = {name: several for name, several in file.items() if several}
        options = {
            name: flags.get(name, values[name])
            for name in dict.fromkeys((*file, *order, *values))
            if name in values
        }
        if asked.seed is not None and not asked.sample:
            raise click.UsageError("--seed is of a sample; add one, such as --sample sobol:1024")
        return planned(
            self.place,
            Values(options, given.origins | dict.fromkeys(flags, Origin.TYPED)),
            linked=asked.zip_,
            digits=asked.digits,
            bounds=asked.bounds,
            strict=asked.strict,
            only=joined(asked.only),
            sample=asked.sample or "",
            seed=asked.seed or 0,
        )


def _told(target: str, outcome: Outcome) -> str:
    """Return what was written, and how much of it was refused."""
    from kurbel.sweeps.parts import OTHERS

    written = f"{target}: {_counted(outcome.rows)}"
    count = outcome.refused.total()
    if not count:
        return written
    reason, most = next(one for one in outcome.refused.most_common() if one[0] != OTHERS)
    few = "was refused and has" if count == 1 else "were refused and have"
    times = "" if most == count else f" (so {_counted(most)})"
    return (
        f"{written}, of which {count} {few} no values; the column reason says why, such as: {reason}{times}"
    )


def _counted(rows: int) -> str:
    return "1 row" if rows == 1 else f"{rows} rows"


def joined(conditions: Sequence[str]) -> str:
    """Return several conditions as one."""
    return conditions[0] if len(conditions) == 1 else " and ".join(f"({one})" for one in conditions)


TIMES = ((86400, "days"), (3600, "hours"), (60, "minutes"), (1, "seconds"))
SIZES = ((10**12, "TB"), (10**9, "GB"), (10**6, "MB"), (10**3, "kB"))
# What is shorter and smaller says nothing.
LEAST = {"seconds": "less than a second", "kB": "less than a kilobyte"}


def show_estimate(sweep: Sweep, target: str | None, format: str | None) -> None:
    """Print rows, columns, parts, size and time of a sweep. Raises KurbelError."""
    from kurbel.sweeps.parts import form_of
    from kurbel.sweeps.run import estimated

    form = form_of(target or "-", format or (None if target else "parquet"))
    form.check(sweep, target or "sweep")
    found = estimated(sweep, form)
    hands = min(cores(), found.parts)
    product = " x ".join(
        f"{len(group[0].values)} of " + " and ".join(flag_of(one.option) for one in group)
        for group in sweep.plan.groups
    )
    each = f", {sweep.each} records each" if sweep.each > 1 else ""
    rows = {
        "rows": f"{found.rows} ({product or 'one combination'}{each})",
        "columns": ", ".join(one.key for one in sweep.columns) + ", reason",
        "parts": f"{found.parts} of {min(sweep.rows_at_once, found.rows)} rows",
        "size": f"about {_in(found.size, SIZES, 'kB')} as {form.name}",
        "time": f"about {_in(found.seconds(hands), TIMES, 'seconds')} on {hands} core{'s' * (hands > 1)},"
        " measured on a sample",
    }
    if found.refused:
        rows["refused"] = f"{found.refused[0]}: {found.refused[1]}"
    for name, said in rows.items():
        click.echo(f"{name:8} {said}")


def _in(value: float, units: tuple[tuple[int, str], ...], last: str) -> str:
    for size, unit in units:
        if value >= size:
            return f"{value / size:.2g} {unit}" if value < 100 * size else f"{value / size:.0f} {unit}"
    return LEAST[last]
