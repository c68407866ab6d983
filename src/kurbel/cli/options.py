"""The options of commands, made for click, and what gives way to what was typed: defaults from elsewhere."""

from __future__ import annotations

import inspect
import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import click
from click.core import ParameterSource

from kurbel.commands import options as kinds
from kurbel.commands.part import Origin, Values
from kurbel.commands.parts.sheet import PlainPrinting
from kurbel.errors import KurbelError, NotationError
from kurbel.exact.numerals import DECIMALS
from kurbel.formats.registry import FORMATS, format_names
from kurbel.reading.given import File, check_below

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

    from kurbel.commands.subject import Command

_ORIGINS: Mapping[ParameterSource | None, Origin] = {
    ParameterSource.COMMANDLINE: Origin.TYPED,
    ParameterSource.ENVIRONMENT: Origin.ENVIRONMENT,
    ParameterSource.DEFAULT_MAP: Origin.MACHINE,
}


# Generic from click 8.5 on, and not to be subscripted before.
class Type(click.ParamType):  # type: ignore[type-arg]
    """A kind of value, for click."""

    def __init__(self, kind: kinds.Kind) -> None:
        self.kind = kind
        self.name = kind.name

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> object:
        read = self.kind.read(value, ctx.params if ctx else {})
        return self.kind.with_files(read, lambda name: FileName().convert(str(name), param, ctx))

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        from click.shell_completion import CompletionItem

        return [CompletionItem(text) for text in self.kind.offered(incomplete, ctx.params)]


class FormatName(kinds.Choice):
    """A format by its name or by a suffix: latex, tex."""

    def read(self, text: str, typed: Mapping[str, object]) -> str:
        suffixes = {suffix[1:]: name for name, entry in FORMATS.items() for suffix in entry.suffixes}
        return super().read(suffixes.get(text.lower(), text), typed)


class FileName(click.Path):
    """A file that is read; for a document's table its name counts from the document's folder."""

    kind = kinds.FILE

    def convert(  # type: ignore[override]
        self, value: str | File, param: click.Parameter | None, ctx: click.Context | None
    ) -> File:
        document = ctx and ctx.find_object(Document)
        named = document.file if document else File
        file = value if isinstance(value, File) else named(value)
        if "\0" in file.name:
            option = f"{param.opts[0]}: " if param else ""
            raise NotationError(f"{option}the name of a file has a NUL, which no file can have")
        super().convert(os.fspath(file), param, ctx)
        if file.inside:
            check_below(os.fspath(file), file.folder, file.name, file.inside)
        return file


class Document:
    """Stands for a document whose table is asked for in place of a page on paper.

    Names of files count from its folder, and variables of the environment do not count at all: they are
    another one's on another machine. Those that are `inside`, of a handbook or a document, lie in the folder.
    """

    def __init__(self, folder: str, inside: str = "") -> None:
        self.folder = folder
        self.inside = inside

    def file(self, name: str) -> File:
        return File(name, self.folder, self.inside)


class Option(click.Option):
    """An option that has no default from the environment where a document asks, and one value at the most.

    In the help it stands in its topic, that of the option of a command where it is one."""

    def __init__(self, *args: Any, topic: str = "output", **more: Any) -> None:
        super().__init__(*args, **more)
        self.topic = topic

    def add_to_parser(self, parser: Any, ctx: click.Context) -> None:
        if self.multiple or self.is_flag:
            super().add_to_parser(parser, ctx)
        else:
            # All values that are typed, where click would keep the last.
            parser.add_option(obj=self, opts=self.opts, dest=self.name, action="append", nargs=self.nargs)

    def consume_value(self, ctx: click.Context, opts: Mapping[str, Any]) -> tuple[object, ParameterSource]:
        typed = opts.get(self.name or "")
        if isinstance(typed, list) and not self.multiple:
            return super().consume_value(ctx, {**opts, self.name or "": self._one_of(typed, ctx)})
        return super().consume_value(ctx, opts)

    def _one_of(self, typed: Sequence[str], ctx: click.Context) -> Any:
        """Return the value that is typed; raise UsageError for two that do not say the same."""
        if len(dict.fromkeys(typed)) > 1 and not ctx.resilient_parsing:
            said = [
                self.type.convert(one, self, ctx) if isinstance(self.type, Type) else one for one in typed
            ]
            if len(dict.fromkeys(said)) > 1:
                from kurbel.cli.misplaced import long_flag, twice

                raise click.UsageError(twice(long_flag(self), dict.fromkeys(typed), ctx.command.name), ctx)
        return typed[-1]

    def resolve_envvar_value(self, ctx: click.Context) -> str | None:
        return None if ctx.find_object(Document) else super().resolve_envvar_value(ctx)

    def process_value(self, ctx: click.Context, value: object) -> object:
        if ctx.get_parameter_source(self.name or "") is not ParameterSource.ENVIRONMENT:
            return super().process_value(ctx, value)
        with naming_variable(ctx, self):
            return super().process_value(ctx, value)


@contextmanager
def naming_variable(context: click.Context, option: click.Parameter) -> Iterator[None]:
    """Have the sentence that refuses the value of an option name the variable in which it stands."""
    variable = _variable(context, option)
    try:
        yield
    except KurbelError as error:
        error.args = (f"{variable}: {error}",)
        raise
    except click.BadParameter:
        value, flag = os.environ[variable][:40], max(option.opts, key=len)
        raise NotationError(f'{variable} is "{value}"; write 1 for {flag}, or 0 to go without') from None


def _variable(context: click.Context, option: click.Parameter) -> str:
    """Return the variable in which the value of an option stands."""
    several = [option.envvar] if isinstance(option.envvar, str) else [*(option.envvar or ())]
    variables = [*several, f"{context.auto_envvar_prefix}_{(option.name or '').upper()}"]
    return next((one for one in variables if os.environ.get(one)), variables[-1])


def click_option(option: kinds.Option[object]) -> click.Parameter:
    """Return an option of a command as click's."""
    default = option.default
    plain = option.kind in (kinds.TEXT, kinds.FLAG)
    kind = None if plain else FileName() if option.kind is kinds.FILE else Type(option.kind)
    if option.positional:
        return click.Argument([option.name], type=kind, required=False)
    names = [option.name, option.flag, *filter(None, [option.short])]
    if option.kind is kinds.FLAG:
        return Option(names, is_flag=True, help=option.help, topic=option.topic)
    own: dict[str, object] = {} if option.many or default is None else {"default": default}
    if option.bare:
        own |= {"is_flag": False, "flag_value": option.bare}
    return Option(
        names,
        type=kind,
        metavar=option.metavar,
        multiple=option.many,
        required=option.required,
        help=option.help,
        topic=option.topic,
        show_default=default not in (None, "", ()),
        envvar=option.environment or None,
        is_eager=option.first,
        **own,
    )


OF_PAGES = ("digits", "rounding", "label", "caption", "note", "source", "templates")


def printing_options(command: str, own: Mapping[str, click.Parameter]) -> list[click.Parameter]:
    """Return the options of a command that prints tables in their order, its function's own among them."""
    return [
        Option(["format", "-f", "--format"], type=Type(FormatName("format", format_names)),
               envvar=[f"KURBEL_{command.upper()}_FORMAT", "KURBEL_FORMAT"],
               help="Output format; default: by the suffix of -o, else text. svg, png and pgf are drawings,"
               " and pdf with -f drawing."),
        output_option("File to write, whole or not at all; - is standard output.", default="-"),
        own["lang"],
        Option(["--decimal"], type=Type(kinds.Choice("decimal mark", DECIMALS)),
               envvar="KURBEL_DECIMAL", topic="page",
               help="comma or point; default: by the language, point in CSV and JSON."),
        *(own[name] for name in OF_PAGES if name in own),
        Option(["--standalone"], is_flag=True,
               help="LaTeX, HTML and Typst: a whole document, not a fragment."),
        # Without a crank ratio there is seldom a choice; a sentence says so.
        Option(["--interactive"], is_flag=True, hidden="ratio" not in own,
               help="HTML: a page with sliders for what has several values, such as --ratio 1:3..6, a"
               " mechanism that moves, and certified digits at every step."),
        Option(["--longtable"], is_flag=True, help="LaTeX: a longtable, which breaks across pages."),
        Option(["--siunitx"], is_flag=True, help="LaTeX: S columns, whose numbers the package siunitx sets."),
        Option(["--plain"], is_flag=True,
               help="LaTeX: what one would type by hand, to go on with; it fits no line by itself."),
        Option(["--excel"], is_flag=True,
               help="CSV that Excel opens by a double click: with a byte order mark, the decimal mark of the"
               " language, and ratios that are no times."),
    ]  # fmt: skip


def output_option(help: str, default: str | None = None) -> click.Parameter:
    """Return -o, the file that is written."""
    return Option(
        ["output", "-o", "--output"], type=click.Path(allow_dash=True), metavar="FILE", callback=_named,
        help=help, default=default,
    )  # fmt: skip


def _named(context: click.Context, parameter: click.Parameter, name: str | None) -> str | None:
    """Return the name of a file; of -o=FILE click would take the sign for the name's first letter."""
    if name and name.startswith("="):
        rest = name[1:61]
        raise NotationError(
            f'the file to write is called "{name[:61]}"; write -o {rest} or --output={rest}, and ./={rest}'
            " for a file of that name"
        )
    return name


def lang_option(what: str) -> click.Parameter:
    """Return --lang of what is no page."""
    return click_option(PlainPrinting.lang.but(help=f"Language of the {what}: de or en."))


def help_of(command: Command) -> str:
    """Return the help of a command: its docstring, without the examples of Python."""
    return inspect.cleandoc(command.doc).partition("\f")[0]


class TypedOptions(Values):
    """What was given to a command of click."""

    def __init__(self, context: click.Context) -> None:
        self.in_document = context.find_object(Document) is not None
        sources = {name: context.get_parameter_source(name) for name in context.params}
        origins = {name: _ORIGINS.get(one) for name, one in sources.items()}
        file = context.meta.get(MACHINE)
        places = {
            name: _variable(context, param)
            if origins.get(name) is Origin.ENVIRONMENT
            else f"{name} of {file}"
            if file
            else f"the default {name}"
            for param in context.command.params
            if origins.get(name := param.name or "") in (Origin.ENVIRONMENT, Origin.MACHINE)
        }
        super().__init__(context.params, origins, places)

    def text(self, name: str) -> str:
        """Return the text of an option, nothing where it is not given."""
        value = self.values.get(name)
        return "" if value is None else str(value)


# Where a context keeps the name of the file.
MACHINE = "kurbel.drive.machine"


def machine_option() -> click.Option:
    """Return --machine, which gives defaults to those options that the command has."""
    return Option(
        ["--machine"], metavar="FILE", type=FileName(), is_eager=True, expose_value=False, callback=_load,
        topic="crank",
        help=f"Machine in a TOML file, with {', '.join(f'[{one}]' for one in kinds.SECTIONS)}; what is typed"
        " outdoes it.",
    )  # fmt: skip


def defaults_by_machine(command: click.Command, file: File) -> dict[str, object]:
    """Return what a machine's file says of the options of a command."""
    from kurbel.commands.subject import machine_defaults

    return machine_defaults(
        command.name or "", {one.name or "": one.multiple for one in command.params}, file
    )


def _load(context: click.Context, parameter: click.Parameter, file: File | None) -> None:
    if file is not None:
        context.default_map = {**(context.default_map or {}), **defaults_by_machine(context.command, file)}
        context.meta[MACHINE] = str(file)
