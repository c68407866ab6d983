"""One command as a sweep: its options, typed or in a file sweep.toml, with several values become a plan, and
that a file."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, cast

import click
from click.core import augment_usage_errors
from msgspec import Struct, defstruct

from kurbel.cli import say
from kurbel.cli.manual.command import TopicCommand
from kurbel.cli.manual.topics import SWEEPS
from kurbel.cli.options import FileName, TypedOptions, help_of
from kurbel.cli.sweep import TABLES, SweepOptions, own_options, running, sweep_options
from kurbel.commands.options import FILE as A_FILE
from kurbel.commands.options import FLAG, Count, Option
from kurbel.commands.part import Origin, Values, flag_of
from kurbel.commands.subject import Command
from kurbel.errors import FailedError, KurbelError
from kurbel.reading.environment import need
from kurbel.reading.given import choose
from kurbel.reading.toml_file import Fault, TextChoice, TomlFile, TomlKind, about, within
from kurbel.sweeps.asked import planned, values_of
from kurbel.sweeps.hands import cores

if TYPE_CHECKING:
    from kurbel.sweeps.plan import Plan
    from kurbel.sweeps.rows import Sweep
    from kurbel.sweeps.run import Outcome

KIND = TomlKind(
    "sweep",
    FailedError,
    10**7,
    'a sweep has command = "delta", its [axes], [options] and an output',
    "sweep.toml",
)
SECTIONS = ("axes", "options")
VALUE: Mapping[str, object] = {"type": ["string", "number", "boolean"]}


class CommandName(TextChoice, what="command that can be swept", allowed=TABLES):
    """A command by its name."""


class Listed(tuple[object, ...]):
    """One value or several: texts as they would be typed, numbers, or true and false."""

    SCHEMA: ClassVar[Mapping[str, object]] = {
        "anyOf": [VALUE, {"type": "array", "items": VALUE, "minItems": 1}]
    }

    @classmethod
    def read(cls, given: object, _: str) -> Listed:
        values = given if isinstance(given, list) else [given]
        if not values or not all(isinstance(one, str | int | float) for one in values):
            raise Fault('a text such as "1..10:0.5", a number, true or false, or a list of them')
        return cls(one if isinstance(one, bool) else str(one) for one in values)


class SweepFile(Struct, frozen=True):
    """A sweep: a command, what is the same everywhere, what varies, and where its rows go. MODEL has the
    options of sweeps beside."""

    NOUN: ClassVar[str] = "key of a sweep"

    command: Annotated[CommandName, about("The command that is computed.", "delta")]
    output: Annotated[
        str | None, about("The file that is written, beside this one: its suffix says the form.")
    ] = None
    axes: Annotated[
        dict[str, Listed] | None,
        about("What varies, in this order, the last fastest: options with a range, or a list of values."),
    ] = None
    options: Annotated[
        dict[str, Listed] | None, about("Options of the command that are the same everywhere.")
    ] = None
    columns: Annotated[tuple[str, ...], about("The columns, as in `kurbel quantities`.")] = ()


# What a file says of the sweep itself, as it may be typed.
OWN = ("format", "zip", "only", "sample", "seed", "digits", "bounds", "strict")


def _key(option: Option[object]) -> tuple[str, Any, None]:
    """Return an option of sweeps as a key of their files: its name, its type and its default."""
    kind: Any = bool if option.kind is FLAG else tuple[str, ...] if option.many else str
    if isinstance(option.kind, Count):
        kind = Annotated[int, within(*option.kind.within)]
    return option.name, Annotated[kind | None, about(option.help)], None


MODEL = defstruct(
    "SweepFile", [_key(SweepOptions.options()[name]) for name in OWN], bases=(SweepFile,), frozen=True
)


class ReadFile:
    """A sweep's file that was read."""

    def __init__(self, path: str) -> None:
        self.file = TomlFile(path, KIND)
        self.declared = cast("SweepFile", self.file.read(MODEL))
        self.folder = os.path.dirname(path)

    def beside(self, name: str) -> str:
        """Return the name of a file, which counts from where this one lies."""
        return os.path.join(self.folder, name)

    def values(self, known: Mapping[str, Option[object]]) -> dict[str, Listed]:
        """Return the options by their names, the axes first, in the order of the file.

        Raises FailedError for one that the command does not have, or a value that cannot be read.
        """
        found: dict[str, Listed] = {}
        for section in SECTIONS:
            for key, given in (getattr(self.declared, section) or {}).items():
                name = key.replace("-", "_")
                try:
                    choose(name, known, f"option of kurbel {self.declared.command}")
                    if len(given) > 1 and section == "options" and not known[name].many:
                        raise FailedError(f"{key} has several values; put it under [axes]")
                    if not isinstance(given[0], bool):
                        values_of(known[name], given)
                except KurbelError as error:
                    raise self.file.error((section, key), error) from None
                found.setdefault(name, given)
        return found


SUFFIX = ".toml"
# Where a context keeps the options of the file in their order, with the values of flags that vary, which no
# word says.
FILE = "kurbel.cli.sweep.file"
MACHINE: Option[object] = Option("Machine in a TOML file.", "FILE", A_FILE)


def words_of(
    read: ReadFile, command: SweepCommand, typed: Sequence[str]
) -> tuple[list[str], dict[str, tuple[bool, ...]]]:
    """Return the words of the file and what is typed; and the options of the file in their order, with the
    values of flags that vary. Raises KurbelError."""
    context = click.Context(command, info_name=command.name, resilient_parsing=True)
    *_, order = command.make_parser(context).parse_args(args=[*typed])
    outdone = {one.name for one in order}
    options = {one.name: one for one in command.params if isinstance(one, click.Option)}
    own = command.asking.options
    machine = {"machine": MACHINE} if "machine" in options else {}
    values = read.values({**own, **machine})
    flags = {
        name: (*map(bool, given),)
        for name, given in values.items()
        if name in own and own[name].kind is FLAG and len(given) > 1 and name not in outdone
    }
    words: list[str] = []
    for name, given in values.items():
        if name not in outdone and name not in flags and name in options:
            words += _words(read, options[name], given)
    for name, said in _of_sweeps(read):
        if name not in outdone:
            words += _words(read, options[name], said)
    return [*words, *typed], {name: flags.get(name, ()) for name in values}


def _words(read: ReadFile, option: click.Option, given: Sequence[object]) -> Iterator[str]:
    flag = max(option.opts, key=len)
    for one in given:
        if isinstance(one, bool):
            yield from [flag] if one else []
        else:
            named = isinstance(option.type, FileName) or option.name == "output"
            yield f"{flag}={read.beside(str(one)) if named else one}"


def _of_sweeps(read: ReadFile) -> Iterator[tuple[str, Sequence[object]]]:
    """Yield what the file says of the sweep itself by the names of the options, each as a list of values."""
    said = {name: getattr(read.declared, name) for name in ("output", *OWN)}
    for name, value in (said | {"columns": ",".join(read.declared.columns)}).items():
        yield name, value if isinstance(value, tuple) else [] if value in (None, "") else [value]


# Where a context keeps the options in the order in which they were typed.
ORDER = "kurbel.cli.sweep.order"


class SweepCommand(TopicCommand):
    """The sweep of a command, which lies at a place."""

    swept = True

    def __init__(self, name: str, place: str, command: Command) -> None:
        super().__init__(
            name,
            params=[*own_options(command), *sweep_options()],
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
            return self.run(TypedOptions(ctx), ctx.meta[ORDER])

    def run(self, given: TypedOptions, order: Sequence[str]) -> int:
        """Write the file, and return the exit code."""
        from kurbel.sweeps.rows import Sweep

        asked = SweepOptions(given)
        sweep, output, form = Sweep(self.plan(given, order)), given.text("output"), asked.format
        need("a file of columns", "scale", "pyarrow")
        if asked.dry_run:
            show_estimate(sweep, output, form)
            return 0
        if not output:
            raise click.UsageError(
                "a sweep needs a file to write, -o sweep.parquet; --dry-run says how large it would be"
            )
        from kurbel.sweeps.run import run

        with running(asked, sweep, output) as how:
            outcome = run(sweep, output, how, form)
        if output != "-" or outcome.refused:
            say(_told(output, outcome))
        return 0

    def plan(self, given: TypedOptions, order: Sequence[str]) -> Plan:
        """Return the plan that the options make: in the order of the file, then of the command line, and
        behind them what comes from elsewhere. Raises KurbelError."""
        values, file = given.values, click.get_current_context().meta.get(FILE, {})
        asked = SweepOptions(given)
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
            linked=asked.zip or (),
            digits=asked.digits,
            bounds=asked.bounds,
            strict=asked.strict,
            only=joined(asked.only or ()),
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
