"""`kurbel verify`: the numbers of a page computed a second time, by other formulas and another arithmetic."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import click

from kurbel.cli.listing import Listing, list_format, plain_lines, show_lines, show_list
from kurbel.cli.options import Option
from kurbel.formats.registry import DEFAULT

if TYPE_CHECKING:
    from kurbel.commands.verified import Cell

# What the second computation says of a number.
CONFIRMED, WRONG, UNDECIDED = "confirmed", "wrong", "undecided"

HEADS = ("page", "column", "cells", "confirmed", "wrong", "not computed", "why not")
KEYS = ("page", "column", "cells", "confirmed", "wrong", "uncomputed", "reason")


@click.command(
    params=[
        click.Argument(["files"], nargs=-1, required=True, type=click.Path(), metavar="FILE..."),
        Option(["--strict"], is_flag=True, help="Exit with 1 if any number cannot be computed so, too."),
        list_format(),
    ]
)
def verify(files: Sequence[str], strict: bool, form: str) -> int:
    """Compute the numbers of pages a second time, from what was asked for.

    FILE is a page that kurbel wrote as JSON, - for standard input; it says what was asked for. Nothing of
    what made it is used: places of the links follow from circles and lines, forces from Newton's and Euler's
    equations, works from closed integrals, all enclosed by intervals of mpmath, until each printed digit is
    confirmed or wrong. Exits with 1 if any is wrong.

    \b
    kurbel forces --eps 4 -o page.json
    kurbel verify page.json
    kurbel verify --strict page.json
    """
    from kurbel.commands.verified import checked, read_page

    cells = [(file, cell) for file in files for cell in checked(read_page(file))]
    rows = [*_rows(cells)]
    show_list(Listing("verify", "en", KEYS, rows, HEADS, rows), form, plain_lines([HEADS, *rows]))
    counted = Counter(cell.verdict for _, cell in cells)
    if form == DEFAULT:
        show_lines(_told(cells, counted))
    return int(bool(counted[WRONG]) or (strict and counted[CONFIRMED] < len(cells)))


def _rows(cells: Sequence[tuple[str, Cell]]) -> Iterator[tuple[str, ...]]:
    """Yield what was found of each column of each page."""
    columns: dict[tuple[str, str], list[Cell]] = {}
    for file, cell in cells:
        columns.setdefault((file, cell.key), []).append(cell)
    for place, own in columns.items():
        counted = Counter(cell.verdict for cell in own)
        numbers = (len(own), counted[CONFIRMED], counted[WRONG], counted[UNDECIDED])
        reason = next((cell.told for cell in own if cell.verdict == UNDECIDED), "")
        yield (*place, *map(str, numbers), reason)


def _told(cells: Sequence[tuple[str, Cell]], counted: Counter[str]) -> Iterator[str]:
    """Yield a line for each wrong number, and the sum of all."""
    yield ""
    for file, cell in cells:
        if cell.verdict == WRONG:
            yield f"{file}: {cell}"
    wrong, left = counted[WRONG], counted[UNDECIDED]
    yield (
        f"{counted[CONFIRMED]} of {len(cells)} numbers are confirmed, {wrong} {'is' if wrong == 1 else 'are'}"
        f" wrong, {left} {'is' if left == 1 else 'are'} not computed"
    )
