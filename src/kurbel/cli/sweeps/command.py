"""One command as a sweep: its options with their several values become a plan, and that a file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import click
from click.core import augment_usage_errors

from kurbel.cli import say
from kurbel.cli.manual.command import TopicCommand
from kurbel.cli.options import Given, help_of
from kurbel.cli.sweeps.from_file import FILE
from kurbel.cli.sweeps.options import own_options, sweep_options
from kurbel.cli.sweeps.running import running, running_options
from kurbel.commands.options import is_given
from kurbel.commands.subject import Command

if TYPE_CHECKING:
    from kurbel.sweeps.plan import Plan
    from kurbel.sweeps.run import Outcome

# Where a context keeps the options in the order in which they were typed.
ORDER = "kurbel.cli.sweeps"


class SweepCommand(TopicCommand):
    """The sweep of a command, which lies at a place."""

    swept = True

    def __init__(self, name: str, place: str, command: Command) -> None:
        super().__init__(
            name,
            params=[*own_options(command), *sweep_options(), *running_options()],
            help=help_of(command),
        )
        self.place, self.asking = place, command

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        ctx.allow_extra_args = True
        with augment_usage_errors(ctx):
            if not ctx.resilient_parsing:
                *_, order = self.make_parser(ctx).parse_args(args=[*args])
                ctx.meta[ORDER] = [one.name for one in order]
            left = super().parse_args(ctx, [*args])
        if left and not ctx.resilient_parsing:
            from kurbel.cli.astray import stray

            raise click.UsageError(stray(left[0], self, args), ctx)
        return left

    def invoke(self, ctx: click.Context) -> int:
        with augment_usage_errors(ctx):
            return self.run(Given(ctx), ctx.meta[ORDER])

    def run(self, given: Given, order: Sequence[str]) -> int:
        """Write the file, and return the exit code."""
        from kurbel.sweeps.rows import Sweep
        from kurbel.sweeps.run import run

        sweep = Sweep(self.plan(given, order))
        if given.values["dry_run"]:
            from kurbel.cli.sweeps.dry import show_estimate

            show_estimate(sweep, given.values["output"], given.values["format"])
            return 0
        if not given.values["output"]:
            raise click.UsageError(
                "a sweep needs a file to write, -o sweep.parquet; --dry-run says how large it would be"
            )
        with running(given.values, sweep) as how:
            outcome = run(sweep, given.values["output"], how, given.values["format"])
        if given.values["output"] != "-" or outcome.refused:
            say(_told(given.values["output"], outcome))
        return 0

    def plan(self, given: Given, order: Sequence[str]) -> Plan:
        """Return the plan that the options make. Raises KurbelError."""
        from kurbel.sweeps.asked import planned

        values = given.values
        linked = [text.replace("-", "_").replace(";", ",").split(",") for text in values["zip_"]]
        told = _in_order(self.told(given, order), click.get_current_context().meta.get(FILE, {}))
        return planned(
            self.place,
            told,
            linked=[[name.strip() for name in names] for names in linked],
            defaults=[name for name in told if not given.typed(name)],
            digits=values["digits"],
            bounds=values["bounds"],
            strict=values["strict"],
            only=joined(values["only"]),
            sample=_sample(values),
            seed=values["seed"] or 0,
        )

    def told(self, given: Given, order: Sequence[str]) -> dict[str, Any]:
        """Return the options that say something by what they are given, in the order of the command line;
        behind them those whose values come from elsewhere, without what others outdo."""
        from kurbel.sweeps.asked import not_outdone, values_of

        own = {one.name: one for one in self.asking.parameters.values()}
        said = {name: value for name, value in given.values.items() if name in own and is_given(value)}
        if given.origins["lang"] is None:
            # Files are in English unless somebody asks for another language.
            del said["lang"]
        left = not_outdone(
            self.asking, given, {name: values_of(own[name], value)[0] for name, value in said.items()}
        )
        names = [*dict.fromkeys(name for name in order if name in said), *said]
        return {name: said[name] for name in dict.fromkeys(names) if name in left}


def _told(target: str, outcome: Outcome) -> str:
    """Return what was written, and how much of it was refused."""
    from kurbel.sweeps.work.joining import OTHERS

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


def _sample(values: Mapping[str, Any]) -> str:
    sample: str | None = values["sample"]
    if values["seed"] is not None and not sample:
        raise click.UsageError("--seed is of a sample; add one, such as --sample sobol:1024")
    return sample or ""


def _in_order(told: Mapping[str, Any], file: Mapping[str, Sequence[bool]]) -> dict[str, Any]:
    """Return what is told with the options of a file in front, in their order, and its flags that vary."""
    merged = {**told, **{name: values for name, values in file.items() if values}}
    return {name: merged[name] for name in dict.fromkeys((*file, *told)) if name in merged}
