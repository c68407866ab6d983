"""A page as a drawing: which format of it is asked for, and its options on the command line."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import click

from kurbel.cli.options import TypedOptions, click_option
from kurbel.commands.parts.drawing import DrawingOptions
from kurbel.formats.registry import DRAWINGS, DRAWN, FORMATS
from kurbel.page.subject import Question

if TYPE_CHECKING:
    from kurbel.commands.shown import Drawing

# What is not drawn, or in a way of its own.
UNDRAWN = ("example", "firing", "rotor", "construct")
# What is a page by itself, and a drawing by -f drawing; the second where it moves, too.
ALSO_PAGES = ("pdf", "html")
# What says how a page is written or what its rows are, and nothing on a drawing.
OF_PAGES = (
    "standalone", "interactive", "longtable", "siunitx", "plain", "excel", "digits", "rounding", "label",
    "note", "source", "templates", "zero", "shares",
)  # fmt: skip


def drawing_options() -> Iterator[click.Parameter]:
    """Yield the options of drawings."""
    return map(click_option, DrawingOptions.options().values())


def drawing_format(
    given: TypedOptions, pages: Sequence[str] = ALSO_PAGES, of_pages: Sequence[str] = ()
) -> str:
    """Return the format of the drawing that is asked for by -f or by the file's suffix, nothing for a page;
    `pages` are by themselves pages, and `of_pages` further options of these.

    Raises UsageError for what says nothing on the one or the other.
    """
    named, output, moves = given.text("format"), given.text("output") or "-", given.says("animate")
    suffix = suffix_of(given)
    by_name = given.typed("format") or output == "-" or given.in_document
    name = named if by_name else suffix
    if name == DRAWN:
        if any(f".{suffix}" in one.suffixes for one in FORMATS.values()) and suffix not in ALSO_PAGES:
            raise click.UsageError(
                f"a drawing is no {suffix}; name a file such as -o kurbel.svg or -o kurbel.pdf"
            )
        name = suffix if suffix in (*DRAWINGS, *ALSO_PAGES) else "svg"
    elif (name in pages or name not in (*DRAWINGS, *ALSO_PAGES)) and not (moves and name == "html"):
        check_page(given, name or "text")
        return ""
    if pages:
        check_moving(name, moves)
    check_drawing(given, name, of_pages)
    if not given.in_document:
        check_terminal(output, name)
    return name


def check_drawing(given: TypedOptions, name: str, of_pages: Sequence[str] = ()) -> None:
    """Raise UsageError for options of pages that were typed beside a drawing."""
    for option in (*OF_PAGES, *of_pages):
        if given.typed(option):
            raise click.UsageError(f"--{option} is for pages, and {name} is a drawing; leave it out")


def suffix_of(given: TypedOptions) -> str:
    """Return the suffix of the file that is written, nothing for standard output."""
    suffix = os.path.splitext(given.text("output"))[1].lower()[1:]
    return "html" if suffix == "htm" else suffix


def check_undrawn(given: TypedOptions) -> None:
    """Raise UsageError for a drawing of a page that has none."""
    name = given.text("format") if given.typed("format") else suffix_of(given)
    if name in (*DRAWINGS, DRAWN):
        raise click.UsageError(f"{name} is a drawing, and this page is not drawn; take text, latex or others")


def check_moving(name: str, moves: bool) -> None:
    """Raise UsageError for a format that cannot move, or that is only for what moves."""
    from kurbel.plot.style import FORMATS, MOVING

    if moves and name not in MOVING:
        raise click.UsageError(
            f"{name} stands still, and --animate writes html, svg or gif, such as -o turn.html; leave it"
            f" out for {name}"
        )
    if not moves and name not in FORMATS:
        raise click.UsageError(f"{name} is for drawings that move; add --animate, or take -f svg, png or pdf")


def check_terminal(output: str, name: str) -> None:
    """Raise UsageError for a drawing on a terminal."""
    if output == "-" and sys.stdout.isatty():
        raise click.UsageError(f"a terminal shows no drawings; name a file, such as -o kurbel.{name}")


def check_page(given: TypedOptions, name: str) -> None:
    """Raise UsageError for options of drawings that were typed beside a page."""
    typed = next((one for one in (*DrawingOptions.options(), "steps") if given.typed(one)), "")
    if typed == "animate":
        check_moving(name, True)
    if typed:
        raise click.UsageError(
            f"--{typed.replace('_', '-')} is for drawings, and {name} is a page; name a file for one, such as"
            " -o kurbel.svg, or add -f drawing"
        )


def drawn(question: Question, given: TypedOptions) -> Drawing:
    """Return what is asked for as a drawing. Raises KurbelError."""
    from kurbel.commands.shown import drawing_of

    return drawing_of(question, DrawingOptions(given), given.text("decimal") or None)


def write(drawing: Drawing, name: str, given: TypedOptions) -> None:
    """Write a drawing to the file, whole or not at all."""
    from kurbel.formats.render import whole_file

    content = drawing.image(name, text=given.says("text"))
    with whole_file(given.text("output")) as stream:
        stream.write(content)
