"""The options that all printing commands share, and how their names are completed."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, TypeVar

import click
from click.core import ParameterSource
from click.shell_completion import CompletionItem

from kurbel.errors import NotationError, ProblemError
from kurbel.exact.numerals import MOST_DIGITS, ROUNDINGS
from kurbel.formats.registry import DECIMALS, DEFAULT, FORMATS, Format
from kurbel.page.folders import LANGUAGES, layout_names
from kurbel.reading import notation
from kurbel.reading.choices import choose

Command = TypeVar("Command", bound=Callable[..., Any])


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
        before, comma, last = incomplete.rpartition(",")
        chosen = before.split(",")
        keys = _column_keys(ctx.params.get("layout") or self._default(ctx.params))
        return [
            CompletionItem(before + comma + key) for key in keys if key.startswith(last) and key not in chosen
        ]

    def _default(self, typed: Mapping[str, Any]) -> str:
        """The layout that the other options choose."""
        if mechanism := typed.get("mechanism"):
            from kurbel.cli.mechanism import MECHANISMS

            return MECHANISMS[mechanism].layout
        return "delta-detail" if typed.get("detail") else self.layout


def _column_keys(name: str) -> tuple[str, ...]:
    from kurbel.page.layouts import layout

    page = layout(name)
    from kurbel.page.subject import SUBJECTS, subject

    if page.subject in SUBJECTS:
        return subject(page.subject).column_keys(page)
    if page.subject == "dead centres":
        from kurbel.linkage.beam_page import beam_column_keys

        return beam_column_keys()
    if page.subject in ("arc crank", "parallel crank"):
        from kurbel.linkage.page import linkage_column_keys

        return linkage_column_keys(page)
    from kurbel.engine.request import engine_column_keys

    return engine_column_keys(page)


class LayoutName(Name):
    """A layout by its name; those about other subjects are not offered."""

    def __init__(self, subjects: tuple[str, ...]) -> None:
        super().__init__("layout", layout_names)
        self.subjects = subjects

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        return value if value in layout_names() else choose(value, self._fitting(), self.name)

    def _fitting(self) -> list[str]:
        from kurbel.page.layouts import layout

        return [name for name in layout_names() if layout(name).subject in self.subjects]

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        items = super().shell_complete(ctx, param, incomplete)
        fitting = self._fitting()
        return [item for item in items if item.value in fitting]


def layout_option(default: str, *subjects: str) -> Callable[[Command], Command]:
    """Add --layout; with an empty default the command chooses by its other options."""
    return click.option(
        "--layout", type=LayoutName(subjects), default=default or None, show_default=True,
        help="Page layout; `kurbel layouts` lists them.",
    )  # fmt: skip


def output_options(command: Command) -> Command:
    """Add -f, -o, --lang, --decimal, --digits, --rounding, --label, --standalone and --longtable."""
    digits = (
        click.option("--digits", type=Count("digits", 0, MOST_DIGITS), metavar="N",
                     help=f"Decimals of every column, 0 to {MOST_DIGITS}."),
        click.option("--rounding", type=Name("rounding", lambda: ROUNDINGS), default=ROUNDINGS[0],
                     show_default=True, help="What becomes of a tie."),
    )  # fmt: skip
    return in_order((*_format_options(command), *digits, *_document_options()))(command)


def page_options(command: Command) -> Command:
    """Add the same without --digits and --rounding, for pages whose figures have places of their own."""
    return in_order((*_format_options(command), *_document_options()))(command)


def _format_options(command: Command) -> tuple[Callable[[Command], Command], ...]:
    return (
        click.option("-f", "--format", type=FormatName("format", lambda: FORMATS),
                     envvar=[f"KURBEL_{command.__name__.upper()}_FORMAT", "KURBEL_FORMAT"],
                     help="Output format; default: by the suffix of -o, else text."),
        click.option("-o", "--output", type=click.Path(allow_dash=True), metavar="FILE", default="-",
                     help="File to write, whole or not at all; - is standard output."),
        click.option("--lang", type=Name("language", lambda: LANGUAGES), default="de", show_default=True,
                     envvar="KURBEL_LANG", help="Language of headings and captions: de or en."),
        click.option("--decimal", type=Name("decimal mark", lambda: DECIMALS), envvar="KURBEL_DECIMAL",
                     help="comma or point; default: by the language, point in CSV and JSON."),
    )  # fmt: skip


def _document_options() -> tuple[Callable[[Command], Command], ...]:
    return (
        click.option("--label", metavar="NAME", default="",
                     help="Name for cross references: \\label{tab:NAME}; default: the layout's."),
        click.option("--standalone", is_flag=True,
                     help="LaTeX, HTML and Typst: a whole document, not a fragment."),
        click.option("--longtable", is_flag=True, help="LaTeX: a longtable, which breaks across pages."),
    )  # fmt: skip


def sheet_of(options: Mapping[str, Any], example: str = "") -> dict[str, Any]:
    """Return digits, language, label and, with an example of them, the columns, as a request takes them."""
    sheet = {name: options[name] for name in ("digits", "rounding", "lang", "label")}
    return {**sheet, "columns": notation.names(options["columns"], "columns", example)} if example else sheet


def in_order(options: Sequence[Callable[[Any], Any]]) -> Callable[[Command], Command]:
    """Add options to a command, the first one first in its help."""

    def add(command: Command) -> Command:
        for option in reversed(options):
            command = option(command)
        return command

    return add


def chosen_format(format_name: str | None, output: str, standalone: bool, longtable: bool) -> Format:
    """Return the format named by -f, or by the file's suffix, or by the environment, or text."""
    from kurbel.formats.registry import for_suffix

    if not output:
        raise click.UsageError("--output names no file; - is standard output.")
    named = output == "-" or typed("format")
    chosen = FORMATS[format_name or DEFAULT] if named else for_suffix(output)
    if chosen.kind == "compiled":
        _refuse_terminal(chosen.name, output)
    if standalone and chosen.kind != "compiled" and not chosen.standalone and typed("standalone"):
        *documents, last = (name for name, entry in FORMATS.items() if entry.standalone)
        raise click.UsageError(
            f"--standalone is for {', '.join(documents)} and {last}; {chosen.name} has no documents."
        )
    if longtable and not chosen.breaks and typed("longtable"):
        breaking = ", ".join(name for name, entry in FORMATS.items() if entry.breaks)
        raise click.UsageError(f"--longtable is for {breaking}; the format is {chosen.name}.")
    return chosen


def _refuse_terminal(name: str, output: str) -> None:
    if output == "-" and sys.stdout.isatty():
        raise click.UsageError(f"a terminal shows no {name}; name a file, such as -o kurbel.{name}")


def typed(option: str) -> bool:
    """Whether an option stands on the command line; a default from the environment gives way."""
    return click.get_current_context().get_parameter_source(option) is ParameterSource.COMMANDLINE


def without_foreign(options: dict[str, Any], foreign: Mapping[str, str]) -> dict[str, Any]:
    """Return the options without those that cannot be used; what was typed is refused with its sentence."""
    for option, sentence in foreign.items():
        if typed(option):
            raise ProblemError(sentence)
    return options | {option: nothing(options[option]) for option in foreign}


def without_outdone(options: dict[str, Any], rivals: Iterable[tuple[str, set[str]]]) -> dict[str, Any]:
    """Return the options without defaults of the environment whose rivals were all typed."""
    kept = dict(options)
    for option, others in rivals:
        if not typed(option) and all(map(typed, others)):
            kept[option] = nothing(options[option])
    return kept


def nothing(value: Any) -> tuple[()] | None:
    """Return what an option is that was not given."""
    return () if isinstance(value, tuple) else None
