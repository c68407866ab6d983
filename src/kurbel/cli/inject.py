"""`kurbel inject`: the tables at marked places of one's own documents."""

from __future__ import annotations

import os
import shlex
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import NamedTuple

import click

from kurbel.cli import say
from kurbel.cli.app import show
from kurbel.cli.asking import CommandLine, asked
from kurbel.documents.inject import Kind, Place, content, difference, filled, places
from kurbel.errors import KurbelError, LayoutError, MarkerError
from kurbel.formats.registry import PageFormat, kind_of
from kurbel.formats.render import render, whole_file
from kurbel.page.table import Table
from kurbel.reading.given import DOCUMENT


class Document(NamedTuple):
    """A document with its marked places and what should stand there."""

    name: str
    old: bytes
    found: tuple[Place, ...]
    contents: tuple[bytes, ...]

    @property
    def stale(self) -> list[Place]:
        """The places whose content is another one."""
        pairs = zip(self.found, self.contents, strict=True)
        return [place for place, new in pairs if self.old[place.begin : place.end] != new]


@click.command()
@click.argument("files", nargs=-1, required=True, type=click.Path(), metavar="FILE...")
@click.option(
    "--check", is_flag=True, help="Write nothing; show what would change, and exit with 1 if anything would."
)
@click.option("--allow-outside", is_flag=True,
              help="Files that the markers name may lie outside of the document's folder.")  # fmt: skip
def inject(files: tuple[str, ...], check: bool, allow_outside: bool) -> int:
    """Refresh the tables between markers in Markdown, HTML, LaTeX and Typst; all else stays as it is.

    \b
    <!-- kurbel: table --ratio 1:5 --step 15 -->    Markdown, HTML
    <!-- /kurbel -->
    % kurbel: delta --eps 2..6 --lang en            LaTeX
    % /kurbel
    // kurbel: table --machine engine.toml          Typst
    // /kurbel

    A marker stands alone on its line. Files that it names are looked for from the document's folder, and lie
    in it. A document whose tables cannot all be made is left as it is. In HTML, `kurbel: plot` draws.

    \b
    kurbel inject notes.md lectures/*.tex
    kurbel inject --check notes.md
    """  # fmt: skip
    stale: list[Document] = []
    failed = False
    # Each file once, under the first of its names.
    names: dict[str, str] = {}
    for name in files:
        names.setdefault(os.path.realpath(name), name)
    for name in names.values():
        try:
            document = _document(name, "" if allow_outside else DOCUMENT)
            if document.stale and check:
                stale.append(document)
            elif document.stale:
                _refresh(document)
        except KurbelError as error:
            failed = True
            say(str(error))
    if stale:
        _show(stale)
    return int(failed or bool(stale))


def _show(stale: Sequence[Document]) -> None:
    """Show what would change, and say how to change it."""
    show(line for one in stale for line in difference(one.name, one.old, one.found, one.contents))
    for one in stale:
        for place in one.stale:
            say(f"{one.name}:{place.line}: what stands between the markers is stale")
    *others, last = (one.name for one in stale)
    subject = f"{', '.join(others)} and {last} are" if others else f"{last} is"
    dashes = ["--"] if any(one.name.startswith("-") for one in stale) else []
    say(f"{subject} stale; mend with: {shlex.join(['kurbel', 'inject', *dashes, *others, last])}")


def _document(name: str, inside: str) -> Document:
    if os.path.isdir(name):
        raise MarkerError(f"{name} is a directory; name the documents in it")
    form, kind = kind_of(name)
    old = _read(name)
    found = places(old, kind, name)
    if not found:
        # A misspelt one would be taken for a table that is true.
        say(f"{name} has no markers; they are {kind.opening} and {kind.closing}, each on a line of its own")
    made = [_asked(place, form, name, inside) for place in found]
    if kind.labelled:
        made = list(_labelled(found, made, name))
    contents = tuple(
        content(_text(one, form, kind, number, place, name), place, kind)
        for number, (place, one) in enumerate(zip(found, made, strict=True), 1)
    )
    _check_encoding(old, contents, name)
    return Document(name, old, found, contents)


def _read(name: str) -> bytes:
    if os.path.exists(name) and not os.path.isfile(name):
        raise MarkerError(f"{name} is no file that could be written anew; name a document")
    try:
        with open(name, "rb") as stream:
            return stream.read()
    except (OSError, ValueError) as error:
        raise MarkerError(f"cannot read {name}: {getattr(error, 'strerror', None) or error}") from None


def _asked(place: Place, form: PageFormat, name: str, inside: str) -> CommandLine:
    where = f"{name}:{place.line}"
    try:
        words = shlex.split(place.words)
    except ValueError:
        raise MarkerError(
            f'{where}: the marker has a quotation mark or a backslash without its second half; write "2°30\'"'
            " between quotation marks, as in a shell"
        ) from None
    folder = os.path.dirname(os.path.realpath(name))
    try:
        return asked(words, {}, format=form.name, folder=folder, inside=inside)
    except KurbelError as error:
        raise MarkerError(f"{where}: {error}") from None


def _labelled(found: Sequence[Place], made: Sequence[CommandLine], name: str) -> Iterator[CommandLine]:
    """Yield what the places ask for, each table with a label of its own.

    Of several tables of one layout the one with its defaults, else the first, keeps the label of the layout.
    """
    tables = [one.made for one in made if isinstance(one.made, Table)]
    # The last one of a dictionary wins.
    owners = {table.key: table for table in [*reversed(tables), *(one for one in tables if not one.variant)]}
    lines: dict[str, int] = {}
    for place, one in zip(found, made, strict=True):
        if not isinstance(one.made, Table):
            yield one
            continue
        table = replace(one.made, variant=None) if owners[one.made.key] is one.made else one.made
        if table.anchor in lines:
            raise MarkerError(
                f'{name}:{place.line}: the label "{table.anchor}" is that of the table of line'
                f" {lines[table.anchor]} too; write --label NAME into one of the two markers"
            )
        lines[table.anchor] = place.line
        yield one._replace(made=table)


def _text(one: CommandLine, form: PageFormat, kind: Kind, number: int, place: Place, name: str) -> str:
    """Return a table as a fragment of the document, a drawing for HTML as SVG."""
    where = f"{name}:{place.line}"
    if isinstance(one.made, Table):
        for remark in form.remarks(one.made, one.longtable):
            say(f"{where}: {remark}")
        wishes = partial(
            render, decimal=one.decimal, longtable=one.longtable, siunitx=one.siunitx, plain=one.plain
        )
        try:
            return wishes(one.made, form.name)
        except LayoutError as error:
            raise MarkerError(f"{where}: {error}") from None
    if not form.draws:
        command = next(word for word in place.words.split() if word != "kurbel")
        raise MarkerError(
            f"{where}: a drawing can stand in HTML only; write it into a file with kurbel {command} -o, and"
            f" include that in {kind.name}"
        )
    return form.writer.drawing(one.made.image().decode(), f"kurbel-{number}", one.made.plain_title)


def _check_encoding(old: bytes, contents: Sequence[bytes], name: str) -> None:
    if all(new.isascii() for new in contents):
        return
    try:
        old.decode()
    except UnicodeDecodeError:
        raise MarkerError(
            f"{name} is not in UTF-8, in which its tables would be written; save it in UTF-8"
        ) from None


def _refresh(document: Document) -> None:
    count = len(document.stale)

    # Tables take their time, in which an author may save the document.
    if _read(document.name) != document.old:
        raise MarkerError(f"{document.name} was changed while its tables were made; refresh it again")
    with whole_file(document.name) as stream:
        stream.write(filled(document.old, document.found, document.contents))
    say(f"{count} {'place' if count == 1 else 'places'} in {document.name} refreshed")
