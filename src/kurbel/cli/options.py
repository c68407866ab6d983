"""The options of commands, made for click: kinds of values, completion, and what is for printing alone."""

from __future__ import annotations

import inspect
import os
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import click

from kurbel.commands import options as kinds
from kurbel.commands.options import Parameter
from kurbel.commands.parameters import LANG
from kurbel.exact.numerals import DECIMALS
from kurbel.formats.registry import FORMATS
from kurbel.reading.given import File

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem


# Generic from click 8.5 on, and not to be subscripted before.
class Type(click.ParamType):  # type: ignore[type-arg]
    """A kind of value, for click."""

    def __init__(self, kind: kinds.Kind) -> None:
        self.kind = kind
        self.name = kind.name

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        return self.kind.read(value, ctx.params if ctx else {})

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        from click.shell_completion import CompletionItem

        return [CompletionItem(text) for text in self.kind.offered(incomplete, ctx.params)]


class FormatName(kinds.Choice):
    """A format by its name or by a suffix: latex, tex."""

    def read(self, text: str, typed: Mapping[str, Any]) -> str:
        suffixes = {suffix[1:]: name for name, entry in FORMATS.items() for suffix in entry.suffixes}
        return super().read(suffixes.get(text, text), typed)


class FileName(click.Path):
    """A file that is read; for a document's table its name counts from the document's folder."""

    def convert(  # type: ignore[override]
        self, value: str | File, param: click.Parameter | None, ctx: click.Context | None
    ) -> File:
        document = ctx and ctx.find_object(Document)
        file = value if isinstance(value, File) else File(value, document.folder if document else "")
        super().convert(os.fspath(file), param, ctx)
        return file


class Document:
    """Stands for a document whose table is asked for in place of a page on paper.

    Names of files count from its folder, and variables of the environment do not count at all: they are
    another one's on another machine.
    """

    def __init__(self, folder: str) -> None:
        self.folder = folder


class Option(click.Option):
    """An option that has no default from the environment where a document asks."""

    def resolve_envvar_value(self, ctx: click.Context) -> str | None:
        return None if ctx.find_object(Document) else super().resolve_envvar_value(ctx)


def click_option(parameter: Parameter) -> click.Parameter:
    """Return a parameter of a function as click's."""
    option, default = parameter.option, parameter.default
    plain = option.kind in (kinds.TEXT, kinds.FLAG)
    kind = None if plain else FileName() if option.kind is kinds.FILE else Type(option.kind)
    if option.positional:
        return click.Argument([parameter.name], type=kind, required=False)
    names = [parameter.name, parameter.flag, *filter(None, [option.short])]
    if option.kind is kinds.FLAG:
        return Option(names, is_flag=True, help=option.help)
    own = {} if option.many or default is None else {"default": default}
    return Option(
        names,
        type=kind,
        metavar=option.metavar,
        multiple=option.many,
        required=parameter.required,
        help=option.help,
        show_default=default not in (None, "", ()),
        envvar=option.environment or None,
        is_eager=option.first,
        **own,
    )


def printing_options(command: str, own: Mapping[str, click.Parameter]) -> list[click.Parameter]:
    """Return the options of a command that prints tables in their order, its function's own among them."""
    return [
        Option(["format", "-f", "--format"], type=Type(FormatName("format", FORMATS)),
               envvar=[f"KURBEL_{command.upper()}_FORMAT", "KURBEL_FORMAT"],
               help="Output format; default: by the suffix of -o, else text."),
        Option(["output", "-o", "--output"], type=click.Path(allow_dash=True), metavar="FILE", default="-",
               help="File to write, whole or not at all; - is standard output."),
        own["lang"],
        Option(["--decimal"], type=Type(kinds.Choice("decimal mark", DECIMALS)), envvar="KURBEL_DECIMAL",
               help="comma or point; default: by the language, point in CSV and JSON."),
        *(own[name] for name in ("digits", "rounding", "label") if name in own),
        Option(["--standalone"], is_flag=True,
               help="LaTeX, HTML and Typst: a whole document, not a fragment."),
        Option(["--longtable"], is_flag=True, help="LaTeX: a longtable, which breaks across pages."),
    ]  # fmt: skip


def lang_option(what: str) -> click.Parameter:
    """Return --lang of what is no page."""
    return click_option(
        Parameter("lang", LANG._replace(help=f"Language of the {what}: de or en."), "de", False)
    )


def help_of(function: Callable[..., Any]) -> str:
    """Return the help of a command: its function's docstring."""
    return inspect.cleandoc(function.__doc__ or "").partition("\f")[0]
