"""`kurbel handbook`: whole appendices from one manifest, built, checked, watched and listed."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import click

from kurbel.cli import say, screen
from kurbel.cli.app import Group
from kurbel.cli.listing import Entry, Heading, Shell, plain_lines, set_list, show_lines
from kurbel.cli.options import Type, lang_option
from kurbel.commands.options import Choice, Count
from kurbel.formats.registry import compiled_format
from kurbel.formats.text.wrap import lines_of
from kurbel.handbook.pool import MOST_PROCESSES, cores

if TYPE_CHECKING:
    from kurbel.handbook.build import Build
    from kurbel.handbook.folder import Folder
    from kurbel.handbook.manifest import Manifest, Part

# So many characters of a text tell which it is.
MOST_SHOWN = 50
# How often the files are looked at, in seconds.
GLANCE = 0.4
WAITING = "another build of this handbook is under way; waiting for its end"


class _Group(Group):
    what = "command of kurbel handbook"


@click.group(cls=_Group)
def handbook() -> None:
    """Build a handbook appendix of tables, worked examples and figures from its manifest, handbook.toml.

    \b
    kurbel handbook init appendix/
    kurbel handbook build appendix/
    kurbel handbook check appendix/
    """  # fmt: skip


FOLDER = click.argument("folder", type=click.Path(), default=".")
JOBS = click.option("-j", "--jobs", type=Type(Count("jobs", 1, MOST_PROCESSES)), metavar="N",
                    help="Processes at once; default: one for each core.")  # fmt: skip
ENGINES = Choice("PDF engine", compiled_format().engines)
ENGINE = click.option("--pdf-engine", type=Type(ENGINES), metavar="ENGINE",
                      help="typst (default), lualatex or latexmk; outdoes the manifest.")  # fmt: skip


def building(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add what the commands have that build."""
    return FOLDER(JOBS(ENGINE(command)))


@handbook.command(
    params=[lang_option("handbook")], short_help="Write a first manifest, which builds at once."
)
@FOLDER
def init(folder: str, lang: str) -> None:
    """Write a manifest with comments, which builds at once, into FOLDER."""
    from kurbel.errors import HandbookError, OutputError
    from kurbel.formats.render import whole_file
    from kurbel.handbook.init import first_manifest
    from kurbel.handbook.manifest import NAME

    path = os.path.join(folder, NAME)
    if os.path.lexists(path):
        raise HandbookError(f"{path} is there already; kurbel handbook build builds it")
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as error:
        raise OutputError(f"cannot make the folder {folder}: {error.strerror}") from error
    with whole_file(path) as stream:
        stream.write(first_manifest(lang).encode())
    say(f"{path} is written; build it with: {_build_words(folder)}")


@handbook.command(short_help="Build what changed.")
@building
def build(**options: Any) -> int:
    """Build what changed of the handbook in FOLDER: its tables, figures and documents."""
    return _build(options)


def _build(options: dict[str, Any]) -> int:
    from kurbel.cli.asking import make_part
    from kurbel.handbook.build import build as built

    manifest, folder = _opened(options["folder"], options["pdf_engine"])
    done = built(manifest, folder, make_part, options["jobs"] or cores(), _bar, partial(say, WAITING))
    failed = _report(manifest, done)
    counts = f"{len(done.written)} written, {len(done.unchanged)} unchanged"
    removed = f", {len(done.removed)} removed" if done.removed else ""
    say(f"{folder.path}: {counts}{removed}{failed}")
    return int(bool(failed))


@handbook.command(short_help="Tell whether what was built is up to date.")
@building
def check(**options: Any) -> int:
    """Tell whether what was built in FOLDER is what a build would write now; exit with 1 if not.

    All is built anew, elsewhere. The differences go to standard output.
    """
    from kurbel.cli.asking import make_part
    from kurbel.handbook.check import check as checked

    manifest, folder = _opened(options["folder"], options["pdf_engine"])
    done, stale = checked(manifest, folder, make_part, options["jobs"] or cores(), _bar)
    show_lines(
        line
        for one in stale
        for line in (f"{folder.path}/{one.path}: {one.why}", *(f"    {line}" for line in one.difference))
    )
    failed = _report(manifest, done)
    if stale:
        mend = _build_words(options["folder"], options["pdf_engine"])
        first = "mend what failed, and then" if failed else "this mends it:"
        count = "1 file is" if len(stale) == 1 else f"{len(stale)} files are"
        say(f"{folder.path}: {count} stale{failed}; {first} {mend}")
    elif not failed:
        say(f"{folder.path}: all {len(done.written)} files are what the manifest says")
    return int(bool(stale or failed))


@handbook.command("list", short_help="List what would be built.")
@FOLDER
def listed(folder: str) -> None:
    """List the chapters and parts of the handbook in FOLDER, and what a build would make anew."""
    from kurbel.handbook.build import Build

    manifest, output = _opened(folder)
    one = Build(manifest, output)
    chapters = {
        f"{number} {chapter.title} ({chapter.name})": [_row(one, part) for part in chapter.parts]
        for number, chapter in enumerate(manifest.chapters, 1)
    }
    first, width = f"{output.path}: {', '.join(manifest.formats)}", screen.width()
    if width is None:
        show_lines(_plain_list(first, chapters))
        return
    entries: list[Entry | Heading] = []
    for title, rows in chapters.items():
        entries += [Heading(title), *rows]
    show_lines([*lines_of(first, width), "", *set_list(("part", "made by", "state"), entries, width)])


def _plain_list(first: str, chapters: Mapping[str, Sequence[Sequence[str]]]) -> Iterator[str]:
    yield first
    for title, rows in chapters.items():
        yield from ("", title, *(f"    {line}" for line in plain_lines(rows)))


def _row(one: Build, part: Part) -> tuple[str, ...]:
    """Return what the list says of a part: its name, what it is made of, whether it would be made anew."""
    if not part.words:
        return "text", part.file or " ".join(part.text.split())[:MOST_SHOWN], ""
    return part.name, Shell(part.shown), one.novelty(part)


@handbook.command(short_help="Build again each time a file is saved.")
@building
def watch(**options: Any) -> None:
    """Build the handbook in FOLDER, and again each time a file of it is saved, until Ctrl-C."""
    from kurbel.errors import KurbelError
    from kurbel.handbook.inputs import Seen, as_built, glance_at

    # One that is not there, or has a mistake, ends the command; later ones are waited out.
    _opened(options["folder"], options["pdf_engine"])
    say("each file that is saved is built; Ctrl-C ends this")
    seen: Seen = {}
    while True:
        before, started = glance_at(options["folder"]), time.time_ns()
        if before != seen:
            try:
                _build(options)
            except KurbelError as error:
                say(str(error))
            seen = as_built(before, glance_at(options["folder"]), started)
        time.sleep(GLANCE)


def _opened(given: str, engine: str | None = None) -> tuple[Manifest, Folder]:
    """Return the manifest and the output folder."""
    from kurbel.handbook.folder import Folder
    from kurbel.handbook.manifest import manifest_path, read_manifest

    manifest = read_manifest(manifest_path(given))
    if engine:
        manifest = manifest.set_by(engine)
    return manifest, Folder(manifest.folder, manifest.output)


def _build_words(folder: str, engine: str | None = None) -> str:
    """Return what one would type to build the handbook in a folder."""
    from shlex import join

    where = [] if folder == "." else [folder]
    return join(["kurbel", "handbook", "build", *where, *(["--pdf-engine", engine] if engine else [])])


def _report(manifest: Manifest, done: Build) -> str:
    """Say what failed; return how many did, as the end of a sentence, or nothing."""
    for failure in done.failures:
        line = f", line {failure.line}" if failure.line else ""
        say(f"{manifest.path}{line}, {failure.name}: {failure.said}")
    return f", {len(done.failures)} failed" if done.failures else ""


def _bar(steps: Iterable[Any], count: int) -> Iterator[Any]:
    """Pass the steps on and show on a terminal how many of them are done."""
    if count and sys.stderr.isatty():
        with click.progressbar(steps, count, f"{count} parts", file=sys.stderr) as bar:
            yield from bar
    else:
        yield from steps
