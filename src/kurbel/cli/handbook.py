"""`kurbel handbook`: whole appendices from one manifest, built, checked, watched and listed."""

from __future__ import annotations

import os
import shlex
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import islice
from typing import Any, NamedTuple

import click

from kurbel.cli import say, screen
from kurbel.cli.app import Group
from kurbel.cli.asking import make_part
from kurbel.cli.listing import Entry, Heading, Shell, plain_lines, set_list, show_lines
from kurbel.cli.options import Option, Type, lang_option
from kurbel.commands.options import Count
from kurbel.errors import KurbelError
from kurbel.handbook.build import Bar, Build, Handbook, chosen, part_from
from kurbel.handbook.build import build as built
from kurbel.handbook.check import CheckedHandbook, places
from kurbel.handbook.check import check as checked
from kurbel.handbook.folder import Folder, Seen, as_built, glance_at
from kurbel.handbook.manifest import Manifest, Part, manifest_path, read_manifest, write_first_manifest
from kurbel.handbook.pool import Answer, by_whom
from kurbel.page.labels import lines_of
from kurbel.sweeps.hands import MOST_JOBS, cores

# How often the files are looked at, in seconds.
GLANCE = 0.4
# GitHub shows no more annotations of a step.
MOST_PLACES = 10


class _Group(Group):
    what = "command of kurbel handbook"


@click.group(cls=_Group)
def handbook() -> None:
    """Build a handbook appendix of tables, worked examples and figures from its manifest, handbook.toml.

    \b
    kurbel handbook init appendix/
    kurbel handbook build appendix/
    kurbel handbook build appendix/ --only kolbenbewegung
    kurbel handbook check appendix/ lectures/
    """  # fmt: skip


FOLDER = click.Argument(["folder"], type=click.Path(), default=".")
OUTSIDE = click.Option(
    ["--allow-outside"], is_flag=True, help="Files that the manifest names may lie outside of its folder."
)
# What the commands have that build.
BUILDING = [
    click.Argument(["folders"], nargs=-1, type=click.Path(), metavar="[FOLDER]..."),
    click.Option(["--only"], multiple=True, metavar="NAME",
                 help="Table, figure or chapter to make, and nothing else; repeatable."),
    Option(["-j", "--jobs"], type=Type(Count("jobs", 1, MOST_JOBS)), metavar="N",
           help="Processes at once; default: one for each core."),
    click.Option(["--scheduler"], metavar="ADDRESS",
                 help="Dask cluster that makes the parts: tcp://HOST:8786."),
    OUTSIDE,
    click.Option(["-q", "--quiet"], is_flag=True, help="Say only what is wrong."),
]  # fmt: skip


class Options(NamedTuple):
    """What is given to the commands that build."""

    folders: tuple[str, ...]
    only: tuple[str, ...]
    jobs: int | None
    scheduler: str | None
    allow_outside: bool
    quiet: bool


@handbook.command(
    params=[lang_option("handbook"), FOLDER], short_help="Write a first manifest, which builds at once."
)
def init(folder: str, lang: str) -> None:
    """Write a manifest with comments, which builds at once, into FOLDER."""
    path = write_first_manifest(folder, lang)
    say(f"{path} is written; build it with: {_build_words(folder)}")


@handbook.command(params=BUILDING, short_help="Build what changed.")
def build(**given: Any) -> int:
    """Build what changed of the handbook in FOLDER, or in several: tables, figures and documents.

    With --only documents stay as they are.
    """
    return _build(Options(**given))


def _build(options: Options) -> int:
    handbooks, wrong = _opened_all(options)
    jobs, by = options.jobs or cores(), by_whom(options.scheduler)
    builds = built(handbooks, make_part, jobs, _bar_of(options), partial(_tell, options), by)
    for one in builds:
        failed = _report(one)
        if not one.ended:
            _tell(options, f"{one.folder.path}: {_counts([one])}{failed}")
        wrong |= bool(failed or one.ended)
    if len(builds) > 1:
        count = sum(len(one.failures) for one in builds)
        failed = f", {count} failed" if count else ""
        _tell(options, f"{len(builds)} handbooks: {_counts(builds)}{failed}")
    return int(wrong)


def _counts(builds: Sequence[Build]) -> str:
    """Return how many files were written, left as they are, and removed."""
    written, unchanged, removed = (
        sum(len(getattr(one, name)) for one in builds) for name in ("written", "unchanged", "removed")
    )
    return f"{written} written, {unchanged} unchanged" + (f", {removed} removed" if removed else "")


@handbook.command(params=BUILDING, short_help="Tell whether what was built is up to date.")
def check(**given: Any) -> int:
    """Tell whether what was built in FOLDER is what a build would write now; exit with 1 if not.

    All is built anew, elsewhere. The stale files and their differences go to standard output; with --quiet
    the files alone.
    """
    options = Options(**given)
    handbooks, wrong = _opened_all(options)
    jobs, by = options.jobs or cores(), by_whom(options.scheduler)
    found = checked(handbooks, make_part, jobs, _bar_of(options), by)
    show_lines(
        line
        for one in found
        for file in one.stale
        for line in (
            f"{one.handbook.folder.path}/{file.path}: {file.why}",
            *(() if options.quiet else (f"    {line}" for line in file.difference)),
        )
    )
    for one in found:
        wrong |= _checked(one, options)
    if len(found) > 1 and not wrong:
        count = sum(len(one.anew.written) for one in found)
        _tell(options, f"{len(found)} handbooks: all {count} files are what the manifests say")
    return int(wrong)


def _checked(one: CheckedHandbook, options: Options) -> bool:
    """Say where what is stale is made, and what failed, of a handbook; tell whether there is any."""
    folder = one.handbook.folder
    failed = _report(one.anew)
    for sentence in islice(places(one), MOST_PLACES):
        say(sentence)
    if one.stale:
        manifest, names = one.handbook.manifest, one.handbook.names
        mend = _build_words(one.handbook.given, names, manifest.outside)
        first = "mend what failed, and then" if failed else "this mends it:"
        count = "1 file is" if len(one.stale) == 1 else f"{len(one.stale)} files are"
        say(f"{folder.path}: {count} stale{failed}; {first} {mend}")
    elif not (failed or one.anew.ended):
        _tell(options, f"{folder.path}: all {len(one.anew.written)} files are what the manifest says")
    return bool(one.stale or failed or one.anew.ended)


@handbook.command("list", params=[FOLDER, OUTSIDE], short_help="List what would be built.")
def listed(folder: str, allow_outside: bool) -> None:
    """List the chapters and parts of the handbook in FOLDER, and what a build would make anew."""
    show_handbook(*_opened(folder, allow_outside))


@handbook.command(params=BUILDING, short_help="Build again each time a file is saved.")
def watch(**given: Any) -> int:
    """Build the handbook in FOLDER, or several, and again each time a file is saved, until Ctrl-C."""
    options = Options(**given)

    def look() -> Seen:
        return {
            path: seen
            for one in options.folders or (".",)
            for path, seen in glance_at(one, options.allow_outside).items()
        }

    # One that is not there, or has a mistake, ends the command; later ones are waited out.
    if _opened_all(options)[1]:
        return 1
    _tell(options, "each file that is saved is built; Ctrl-C ends this")
    seen: Seen = {}
    while True:
        before, started = look(), time.time_ns()
        if before != seen:
            try:
                _build(options)
            except KurbelError as error:
                say(str(error))
            seen = as_built(before, look(), started)
        time.sleep(GLANCE)


def _opened_all(options: Options) -> tuple[list[Handbook], bool]:
    """Return the handbooks that can be built, each once, and whether there are others; say why.

    Raises ChoiceError for a name in --only that no handbook has.
    """
    opened: list[Handbook] = []
    wrong = False
    # Each once, under the first of its names.
    names: dict[str, str] = {}
    for given in options.folders or (".",):
        names.setdefault(os.path.realpath(manifest_path(given)), given)
    for given in names.values():
        try:
            one = Handbook(given, *_opened(given, options.allow_outside))
            if opened:
                part_from(one, opened)
            opened.append(one)
        except KurbelError as error:
            wrong = True
            for said in getattr(error, "mistakes", (str(error),)):
                say(said)
    if opened and options.only:
        opened = chosen(opened, options.only)
    return opened, wrong


def _opened(given: str, outside: bool) -> tuple[Manifest, Folder]:
    """Return the manifest and the output folder."""
    manifest = read_manifest(manifest_path(given), outside)
    return manifest, Folder(manifest.folder, manifest.output)


def _build_words(folder: str, only: Iterable[str] = (), outside: bool = False) -> str:
    """Return what one would type to build the handbook in a folder."""
    where = [] if folder == "." else [folder]
    names = [word for name in only for word in ("--only", name)]
    further = ["--allow-outside"] if outside else []
    return shlex.join(["kurbel", "handbook", "build", *where, *names, *further])


def _report(done: Build) -> str:
    """Say what failed; return how many did, as the end of a sentence, or nothing."""
    if done.ended:
        say(str(done.ended))
    for failure in done.failures:
        line = f", line {failure.line}" if failure.line else ""
        say(f"{done.manifest.path}{line}, {failure.name}: {failure.sentence}")
    return f", {len(done.failures)} failed" if done.failures else ""


def _tell(options: Options, message: str) -> None:
    """Say what is well, unless --quiet is asked for."""
    if not options.quiet:
        say(message)


def _bar_of(options: Options) -> Bar:
    return (lambda steps, _: steps) if options.quiet else _bar


def _bar(steps: Iterable[Answer], count: int) -> Iterator[Answer]:
    """Pass the steps on and show on a terminal how many of them are done."""
    with screen.bar(count, f"{count} parts") as done:
        for step in steps:
            yield step
            done(1)


# So many characters of a text tell which it is.
MOST_SHOWN = 50


def show_handbook(manifest: Manifest, output: Folder) -> None:
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
