"""`kurbel handbook`: whole appendices from one manifest, built, checked, watched and listed."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from typing import TYPE_CHECKING, Any

import click

from kurbel.cli import say
from kurbel.cli.app import Group
from kurbel.cli.options import Type, lang_option
from kurbel.commands.options import Choice, Count
from kurbel.formats.registry import compiled_format
from kurbel.handbook.pool import MOST_PROCESSES

if TYPE_CHECKING:
    from kurbel.handbook.build import Build
    from kurbel.handbook.folder import Folder
    from kurbel.handbook.manifest import Manifest, Part
    from kurbel.handbook.pages import Built

# So many characters of a text tell which it is.
MOST_SHOWN = 50
# How often the files are looked at, in seconds.
GLANCE = 0.4


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
ENGINES = Choice("PDF engine", compiled_format().writer.engines)
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
    say(f"{path} is written; build it with: kurbel handbook build{_typed(folder)}")


@handbook.command(short_help="Build what changed.")
@building
def build(**options: Any) -> int:
    """Build what changed of the handbook in FOLDER: its tables, figures and documents."""
    return _build(options)


def _build(options: dict[str, Any]) -> int:
    from kurbel.cli.asking import make_part
    from kurbel.handbook.build import build as built

    manifest, folder, jobs = _opened(options)
    with _bar() as start:
        done = built(manifest, folder, make_part, jobs, start, _waiting)
    _report(manifest, done)
    counts = f"{len(done.written)} written, {len(done.unchanged)} unchanged"
    removed = f", {len(done.removed)} removed" if done.removed else ""
    say(f"{folder.path}: {counts}{removed}{_failed(done)}")
    return int(bool(done.failures))


@handbook.command(short_help="Tell whether what was built is up to date.")
@building
def check(**options: Any) -> int:
    """Tell whether what was built in FOLDER is what a build would write now; exit with 1 if not.

    All is built anew, elsewhere. The differences go to standard output.
    """
    from kurbel.cli.asking import make_part
    from kurbel.handbook.check import check as checked

    manifest, folder, jobs = _opened(options)
    with _bar() as start:
        done, stale = checked(manifest, folder, make_part, jobs, start)
    for one in stale:
        lines = (f"{folder.path}/{one.path}: {one.why}", *(f"    {line}" for line in one.difference))
        click.echo("\n".join(lines))
    _report(manifest, done)
    if stale:
        engine = f" --pdf-engine {options['pdf_engine']}" if options["pdf_engine"] else ""
        mend = f"kurbel handbook build{_typed(options['folder'])}{engine}"
        first = "mend what failed, and then" if done.failures else "this mends it:"
        count = "1 file is" if len(stale) == 1 else f"{len(stale)} files are"
        say(f"{folder.path}: {count} stale{_failed(done)}; {first} {mend}")
    elif not done.failures:
        say(f"{folder.path}: all {len(done.written)} files are what the manifest says")
    return int(bool(stale or done.failures))


@handbook.command("list", short_help="List what would be built.")
@FOLDER
def listed(folder: str) -> None:
    """List the chapters and parts of the handbook in FOLDER, and what a build would make anew."""
    from tabulate import tabulate

    from kurbel.handbook.build import Build

    options = {"folder": folder, "jobs": 1, "pdf_engine": None}
    manifest, output, jobs = _opened(options)
    one = Build(manifest, output, lambda task: "", jobs)
    stale = {part.name for part in one.stale()}
    click.echo(f"{output.path}: {', '.join(manifest.formats)}")
    for number, chapter in enumerate(manifest.chapters, 1):
        click.echo(f"\n{number} {chapter.title} ({chapter.name})")
        rows = [_row(one, part, part.name in stale) for part in chapter.parts]
        lines = tabulate(rows, tablefmt="plain", disable_numparse=True).splitlines() if rows else []
        for line in lines:
            click.echo(f"    {line.rstrip()}")


def _row(one: Build, part: Part, stale: bool) -> tuple[str, ...]:
    """Return what the list says of a part: its name, what it is made of, whether it would be made anew."""
    if not part.words:
        return "text", part.file or " ".join(part.text.split())[:MOST_SHOWN], ""
    return part.name, part.shown, one.novelty(part) if stale else "unchanged"


@handbook.command(short_help="Build again each time a file is saved.")
@building
def watch(**options: Any) -> None:
    """Build the handbook in FOLDER, and again each time a file of it is saved, until Ctrl-C."""
    from kurbel.errors import KurbelError
    from kurbel.handbook.watch import Seen, as_built, glance

    # One that is not there, or has a mistake, ends the command; later ones are waited out.
    _opened(options)
    say("each file that is saved is built; Ctrl-C ends this")
    seen: Seen = {}
    while True:
        before, started = glance(options["folder"]), time.time_ns()
        if before != seen:
            try:
                _build(options)
            except KurbelError as error:
                say(str(error))
            seen = as_built(before, glance(options["folder"]), started)
        time.sleep(GLANCE)


def _opened(options: dict[str, Any]) -> tuple[Manifest, Folder, int]:
    """Return the manifest, the output folder and how many processes may run."""
    from kurbel.handbook.folder import Folder
    from kurbel.handbook.manifest import manifest_path, read_manifest
    from kurbel.handbook.model import check_engine
    from kurbel.handbook.pool import cores

    manifest = read_manifest(manifest_path(options["folder"]))
    if options["pdf_engine"]:
        check_engine(options["pdf_engine"], manifest.standards, manifest.templates or manifest.layouts)
        manifest = manifest._replace(engine=options["pdf_engine"])
    return manifest, Folder(manifest.folder, manifest.output), options["jobs"] or cores()


def _typed(folder: str) -> str:
    """Return the folder as one would type it behind a command, if it must be typed at all."""
    from shlex import quote

    return "" if folder == "." else f" {quote(folder)}"


def _report(manifest: Manifest, done: Built) -> None:
    for failure in done.failures:
        line = f", line {failure.line}" if failure.line else ""
        say(f"{manifest.path}{line}, {failure.name}: {failure.said}")


def _failed(done: Built) -> str:
    return f", {len(done.failures)} failed" if done.failures else ""


def _waiting() -> None:
    say("another build of this handbook is under way; waiting for its end")


@contextmanager
def _bar() -> Iterator[Callable[[int], Callable[[], None]]]:
    """A progress bar on a terminal; it is told how many steps there are and then each of them."""
    with ExitStack() as bars:

        def start(count: int) -> Callable[[], None]:
            if not count or not sys.stderr.isatty():
                return lambda: None
            shown = click.progressbar(length=count, label=f"{count} parts", file=sys.stderr)
            bar = bars.enter_context(shown)
            return lambda: bar.update(1)

        yield start
