"""`kurbel man`: the manual pages, shown, printed or written where `man` looks for them."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterable
from shutil import which
from tempfile import NamedTemporaryFile
from typing import TYPE_CHECKING

import click

from kurbel.cli import say
from kurbel.errors import OutputError
from kurbel.reading.given import choose

if TYPE_CHECKING:
    from kurbel.cli.manual.pages import Page


def _offered(context: click.Context, parameter: click.Parameter, begun: str) -> list[str]:
    from kurbel.cli.manual.pages import pages

    return [name for name in pages() if name.startswith(begun)]


@click.command()
@click.argument("page", nargs=-1, metavar="[PAGE]", shell_complete=_offered)
@click.option(
    "-o", "--output", metavar="DIR", type=click.Path(),
    help="Write the pages into man1 and man5 of this folder, all of them if none is named:"
    " ~/.local/share/man.",
)  # fmt: skip
def man(page: tuple[str, ...], output: str | None) -> int:
    """Show the manual page of a command or of a file that it reads; in a pipe, print its source.

    Without a name it is that of kurbel itself. A command of the handbook has its words in a row; the files
    are handbook.toml, machine.toml and layout.toml.

    \b
    kurbel man table
    kurbel man handbook build
    kurbel man handbook.toml
    kurbel man -o ~/.local/share/man
    """
    from kurbel.cli.manual.pages import pages

    known = pages()
    # The name that `man` itself has for it does as well: kurbel-table, kurbel-handbook.toml.
    asked = "-".join(" ".join(page).split()).removeprefix("kurbel-")
    name = choose(asked, known, "manual page") if page else None
    if output is not None:
        return _write([known[name]] if name else [*known.values()], output)
    shown = known[name or "kurbel"]
    if sys.stdout.isatty():
        return _show(shown.text(), name or "")
    sys.stdout.buffer.write(shown.text())
    return 0


def _write(wanted: Iterable[Page], folder: str) -> int:
    from kurbel.formats.render import whole_file

    count, folder = 0, os.path.abspath(os.path.expanduser(folder))
    for page in wanted:
        path = os.path.join(folder, page.file)
        try:
            os.makedirs(os.path.dirname(path), exist_ok=True)
        except (OSError, ValueError) as error:
            why = getattr(error, "strerror", None) or error
            raise OutputError(f"cannot make the folder {folder}: {why}") from None
        with whole_file(path) as stream:
            stream.write(page.text())
        count += 1
    said = "page is" if count == 1 else "pages are"
    say(f"{count} manual {said} written; man finds them with: MANPATH={folder}: man kurbel-table")
    return 0


def _show(text: bytes, name: str) -> int:
    if not which("man"):
        command = f"kurbel {name.replace('-', ' ')}".rstrip()
        raise OutputError(f"there is no program man to show the page; {command} --help says the same")
    with NamedTemporaryFile(suffix=".1") as file:
        file.write(text)
        file.flush()
        return subprocess.run(["man", "-l", file.name], check=False).returncode
