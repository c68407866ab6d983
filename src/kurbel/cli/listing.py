"""Lists of what there is, as layouts and quantities: with heads on a terminal, plain in a pipe, as records
for programs."""

from __future__ import annotations

import os
import shlex
import sys
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import zip_longest
from typing import NamedTuple

import click

from kurbel.cli import say, screen
from kurbel.cli.app import show
from kurbel.cli.options import Option, Type, TypedOptions, click_option, lang_option
from kurbel.commands.options import Choice
from kurbel.commands.part import flag_of
from kurbel.commands.parts.sheet import Layouts
from kurbel.formats.registry import DEFAULT, FORMATS, RecordsFormat
from kurbel.page.axes import PHI, RATIO
from kurbel.page.labels import fitted, lines_of, longest_word
from kurbel.page.layouts import SUBJECTS, Layout, layout, layout_file, layout_names
from kurbel.page.table import Field, Records, Table
from kurbel.reading.given import File

GAP = 2
RULE = "─"
# How far stands below a first cell what has no room beside it.
INDENT = 4
# So much room a column of names has at the least.
NAME = 16
LANG = lang_option("list")
HEADS: Mapping[str, Mapping[str, Sequence[str]]] = {
    "layouts": {
        "de": ("Layout", "Seite, und der Befehl, der sie druckt"),
        "en": ("layout", "page, and the command that prints it"),
    },
    "quantities": {
        "de": ("Spalte", "Größe", "Einheit", "Befehl"),
        "en": ("column", "quantity", "unit", "command"),
    },
}
COPY = click.Option(
    ["--copy"], nargs=2, metavar="LAYOUT DIR",
    help="Write a layout and the templates of its pages into a folder, to be changed.",
)  # fmt: skip


class Shell(str):
    """A command line, which is whole for the shell wherever its lines end."""


class Heading(NamedTuple):
    """What stands over the entries after it: a line, and what belongs to it."""

    text: str
    further: Texts = ()


# A cell of several texts has them below each other.
Texts = Sequence[str]
Cell = str | Texts
Entry = Sequence[Cell]


@dataclass(frozen=True)
class Listing:
    """A list: its records by their keys, and its `entries` under `heads` on a terminal."""

    key: str
    lang: str
    keys: Sequence[str]
    rows: Sequence[Sequence[str]]
    heads: Sequence[str]
    entries: Sequence[Entry | Heading]


def list_formats() -> tuple[str, ...]:
    """Return the formats that lists have."""
    return DEFAULT, *(name for name, form in FORMATS.items() if isinstance(form, RecordsFormat))


def list_format() -> click.Parameter:
    """Return -f of a command that prints a list."""
    return Option(
        ["form", "-f", "--format"],
        type=Type(Choice("format", list_formats)),
        default=DEFAULT,
        help="Output format: text, csv or json.",
    )


def form_of_list(given: TypedOptions, kept: Collection[str], page: str, example: str) -> str:
    """Return the format of the list that a command prints where no page is named. Raises UsageError for
    another option than those `kept`, which the list has no use for."""
    form = given.values["format"] if given.typed("format") else DEFAULT
    for name in given.values:
        if given.typed(name) and name not in kept and not (name == "format" and form in list_formats()):
            flag = flag_of(name)
            raise click.UsageError(
                f"{flag} is for {page}, and none is named; name one, such as {example}, or leave {flag} out"
                " for the list"
            )
    return str(form)


def show_list(listing: Listing, form: str, plain: Iterable[str] | None = None) -> None:
    """Print a list in a format; as text with heads on a terminal, elsewhere as the plain lines, by default
    those of its records."""
    chosen, width = FORMATS[form], screen.width()
    if isinstance(chosen, RecordsFormat):
        show_lines(_records(listing, chosen), "")
    else:
        plain = plain_lines(listing.rows) if plain is None else plain
        show_lines(plain if width is None else set_list(listing.heads, listing.entries, width))


def show_lines(lines: Iterable[str], end: str = "\n") -> None:
    """Print lines as text, in the characters that standard output has."""
    text = "".join(f"{line}{end}" for line in lines)
    show([text.encode(sys.stdout.encoding, errors="replace")])


def plain_lines(rows: Sequence[Sequence[str]]) -> Sequence[str]:
    """Return a line for each row, its cells in line with those above."""
    from tabulate import tabulate

    lines = tabulate(rows, tablefmt="plain", disable_numparse=True).splitlines() if rows else []
    return [line.rstrip() for line in lines]


def _records(listing: Listing, form: RecordsFormat) -> Iterator[str]:
    fields = tuple(Field(key, key) for key in listing.keys)
    rows = [[one.replace("$", r"\$") for one in row] for row in listing.rows]
    yield from form.writer.rows(Table(listing.key, listing.lang, "", (), Records(fields, rows)), "point")


def set_list(heads: Sequence[str], entries: Sequence[Entry | Heading], width: int) -> Iterator[str]:
    """Yield the lines of a list on a terminal: cells side by side, or the last one below the longest, or all
    below the first."""
    rows = [
        [[cell] if isinstance(cell, str) else cell for cell in one]
        for one in entries
        if not isinstance(one, Heading)
    ]
    cells: list[Sequence[Texts]] = [[[head] for head in heads], *rows]
    widths = _widths(cells, width)
    if widths is None and len(heads) > 2:
        merged = _merged(cells)
        if widths := _widths(merged, width):
            cells = merged
    yield from _lines(cells[0], widths, width)
    yield RULE * (width if widths is None else sum(widths) + GAP * (len(widths) - 1) + 1)
    following = iter(cells[1:])
    for one in entries:
        if isinstance(one, Heading):
            yield ""
            yield from _below([(1, [one.text]), (1 + INDENT, one.further)], width)
        else:
            yield from _lines(next(following), widths, width)


def _merged(cells: Sequence[Sequence[Texts]]) -> list[Sequence[Texts]]:
    """Return the cells with the last of each row below the longest between the first and it."""
    longest = [max(len(text) for texts in column for text in texts) for column in zip(*cells, strict=True)]
    place = max(range(1, len(longest) - 1), key=longest.__getitem__)
    return [[*row[:place], [*row[place], *filter(None, row[-1])], *row[place + 1 : -1]] for row in cells]


def _widths(rows: Sequence[Sequence[Texts]], width: int) -> list[int] | None:
    columns = [[text for texts in column for text in texts] for column in zip(*rows, strict=True)]
    natural = [max(map(len, column)) for column in columns]
    least = [max(map(_least, column)) for column in columns]
    # A longer name stands above what belongs to it.
    least[0] = min(least[0], NAME)
    return fitted(natural, least, width - 1 - GAP * (len(natural) - 1))


def _lines(cells: Sequence[Texts], widths: Sequence[int] | None, width: int) -> Iterator[str]:
    if widths is None:
        yield from _below([(1, cells[0]), *((1 + INDENT, texts) for texts in cells[1:])], width)
        return
    if max(map(len, cells[0])) > widths[0]:
        yield from _below([(1, cells[0])], width)
        cells = [[""], *cells[1:]]
    columns = [
        [line for text in texts for line in _wrapped(text, room)]
        for texts, room in zip(cells, widths, strict=True)
    ]
    for line in zip_longest(*columns, fillvalue=""):
        shown = (text.ljust(room) for text, room in zip(line, widths, strict=True))
        yield f" {(' ' * GAP).join(shown)}".rstrip()


def _below(parts: Iterable[tuple[int, Texts]], width: int) -> Iterator[str]:
    """Yield texts below each other, each so far from the left."""
    for left, texts in parts:
        for text in filter(None, texts):
            yield from (" " * left + line for line in _wrapped(text, max(width - left, 1)))


def _least(text: str) -> int:
    if isinstance(text, Shell):
        return max(len(shlex.quote(word)) for word in shlex.split(text)) + len(_FURTHER) + len(_ON)
    return longest_word(text)


# A command goes on in the next line, and that is seen.
_ON = " \\"
_FURTHER = "  "


def _wrapped(text: str, room: int) -> list[str]:
    if not isinstance(text, Shell) or len(text) <= room:
        return lines_of(text, room)
    lines = [""]
    for word in map(shlex.quote, shlex.split(text)):
        before = f"{lines[-1]} " if lines[-1].strip() else lines[-1]
        if lines[-1].strip() and len(before + word) > room - len(_ON):
            lines[-1] += _ON
            before = _FURTHER
            lines.append("")
        lines[-1] = before + word
    return lines


@click.command(params=[click_option(Layouts.layouts), COPY, list_format(), LANG])
def layouts(layouts: File | None, copy: tuple[str, str] | None, form: str, lang: str) -> None:
    """List the page layouts, each with a command that prints it, or copy one."""
    if copy is not None:
        from kurbel.formats.templates import copied

        name, folder = copy
        say(
            f"{copied(name, folder)} is a copy; --layouts {shlex.quote(folder)} takes it in place of kurbel's"
        )
        return
    found = [layout(name, layouts) for name in layout_names(layouts)]
    rows = [(one.key, one.title[lang], Shell(printing(one, layouts))) for one in found]
    entries = [(key, (title, command)) for key, title, command in rows]
    keys = ("layout", "title", "command")
    listing = Listing("layouts", lang, keys, rows, HEADS["layouts"][lang], entries)
    show_list(listing, form)


def printing(layout: Layout, folder: File | None) -> str:
    """Return what prints the layout."""
    own = ("--layouts", str(folder)) if folder and os.path.exists(layout_file(folder, layout.key)) else ()
    sample = SUBJECTS[layout.subject].sample.partition(" --layout ")[0]
    return shlex.join(("kurbel", *sample.split(), *own, "--layout", layout.key))


@click.command(params=[list_format(), LANG])
def quantities(form: str, lang: str) -> None:
    """List the quantities that columns can show, with their units and the commands that print them."""
    from kurbel.page.subject import subject

    rows = [("ratio", RATIO[lang], "", "table"), ("phi", PHI[lang], "°", "table")]
    for about in map(subject, SUBJECTS):
        for one, command in about.entries():
            rows.append((one.key, about.name_of(one, lang), one.plain_unit(lang), command))
    keys = ("key", "name", "unit", "command")
    show_list(Listing("quantities", lang, keys, rows, HEADS["quantities"][lang], rows), form)
