"""The options of commands, made for click: kinds of values, completion, and what is for printing alone."""

from __future__ import annotations

import inspect
import os
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import click
from click.shell_completion import CompletionItem

from kurbel.commands import options as kinds
from kurbel.commands.options import Parameter
from kurbel.errors import NotationError
from kurbel.exact.numerals import DECIMALS
from kurbel.formats.registry import FORMATS
from kurbel.page.layouts import layout_names
from kurbel.reading.given import File, choose


# Generic from click 8.5 on, and not to be subscripted before.
class Name(click.ParamType):  # type: ignore[type-arg]
    """One of a few names; a wrong one is answered with the nearest and the list."""

    def __init__(self, what: str, names: Callable[[], Iterable[str]]) -> None:
        self.name = what
        self.names = names

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        return choose(value, self.names(), self.name)

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        return [CompletionItem(name) for name in self.names() if name.startswith(incomplete)]


class Count(click.ParamType):  # type: ignore[type-arg]
    """A whole number within bounds."""

    name = "number"

    def __init__(self, what: str, least: int, most: int) -> None:
        self.what = what
        self.allowed = {str(count): count for count in range(least, most + 1)}
        self.bounds = f"{least} to {most}"

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> int:
        if str(value) not in self.allowed:
            raise NotationError(
                f'{self.what} "{value[:40]}" cannot be printed; write a whole number from {self.bounds}'
            )
        return self.allowed[str(value)]


class FormatName(Name):
    """A format by its name or by a suffix: latex, tex."""

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        suffixes = {suffix[1:]: name for name, entry in FORMATS.items() for suffix in entry.suffixes}
        return super().convert(suffixes.get(value, value), param, ctx)


class Columns(click.ParamType):  # type: ignore[type-arg]
    """Names of columns, parted by commas; which there are depends on the layout."""

    name = "names"

    def __init__(self, layout: str) -> None:
        self.layout = layout

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        return value

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        from kurbel.cli.columns import column_keys

        before, comma, last = incomplete.rpartition(",")
        chosen = before.split(",")
        keys = column_keys(ctx.params.get("layout") or self._default(ctx.params), _folder(ctx))
        return [
            CompletionItem(before + comma + key) for key in keys if key.startswith(last) and key not in chosen
        ]

    def _default(self, typed: Mapping[str, Any]) -> str:
        """The layout that the other options choose."""
        if mechanism := typed.get("mechanism"):
            from kurbel.motion.mechanism import mechanism as mechanism_of

            return mechanism_of(mechanism).layout
        if typed.get("forces") and (typed.get("eps") or typed.get("card")):
            from kurbel.commands.engine_plots import ENGINE_LAYOUT

            return ENGINE_LAYOUT
        return "delta-detail" if typed.get("detail") else self.layout


class LayoutName(Name):
    """A layout by its name; those about other subjects are not offered."""

    def __init__(self, subjects: tuple[str, ...]) -> None:
        super().__init__("layout", layout_names)
        self.subjects = subjects

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        folder = _folder(ctx)
        return value if value in layout_names(folder) else choose(value, self._fitting(folder), self.name)

    def _fitting(self, folder: File | None) -> list[str]:
        from kurbel.page.layouts import layout

        return [name for name in layout_names(folder) if layout(name, folder).subject in self.subjects]

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        names = self._fitting(_folder(ctx))
        return [CompletionItem(name) for name in names if name.startswith(incomplete)]


def _folder(ctx: click.Context | None) -> File | None:
    """Return the folder of --layouts."""
    folder = None if ctx is None else ctx.params.get("layouts")
    # While it parses, click has a mark of its own for what was not given.
    return folder if isinstance(folder, File) else None


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


def _type(kind: kinds.Kind) -> click.ParamType[Any] | None:
    match kind:
        case kinds.Choice():
            return Name(kind.what, kind.names)
        case kinds.Count():
            return Count(kind.what, kind.least, kind.most)
        case kinds.Columns():
            return Columns(kind.layout)
        case kinds.LayoutName():
            return LayoutName(kind.subjects)
    return FileName() if kind is kinds.FILE else None


def click_option(parameter: Parameter) -> click.Parameter:
    """Return a parameter of a function as click's."""
    option, default = parameter.option, parameter.default
    kind = _type(option.kind)
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
        Option(["format", "-f", "--format"], type=FormatName("format", lambda: FORMATS),
               envvar=[f"KURBEL_{command.upper()}_FORMAT", "KURBEL_FORMAT"],
               help="Output format; default: by the suffix of -o, else text."),
        Option(["output", "-o", "--output"], type=click.Path(allow_dash=True), metavar="FILE", default="-",
               help="File to write, whole or not at all; - is standard output."),
        own["lang"],
        Option(["--decimal"], type=Name("decimal mark", lambda: DECIMALS), envvar="KURBEL_DECIMAL",
               help="comma or point; default: by the language, point in CSV and JSON."),
        *(own[name] for name in ("digits", "rounding", "label") if name in own),
        Option(["--standalone"], is_flag=True,
               help="LaTeX, HTML and Typst: a whole document, not a fragment."),
        Option(["--longtable"], is_flag=True, help="LaTeX: a longtable, which breaks across pages."),
    ]  # fmt: skip


def help_of(function: Callable[..., Any]) -> str:
    """Return the help of a command: its function's docstring."""
    return inspect.cleandoc(function.__doc__ or "").partition("\f")[0]
