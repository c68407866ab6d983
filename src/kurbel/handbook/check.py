"""Whether the files of a handbook are those that a build would write now, and how they differ."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from difflib import unified_diff
from itertools import islice, takewhile
from tempfile import TemporaryDirectory
from typing import NamedTuple

from kurbel.formats.registry import FORMATS
from kurbel.handbook.build import Bar, Build, Handbook, Maker, build
from kurbel.handbook.folder import CONTENTS, Folder, digest
from kurbel.handbook.pool import Worked, worked

# A reader wants to see what changed, not all that did: of each table one difference, in the first of these
# formats, of documents none beside those of tables.
READABLE = tuple(
    suffix
    for form in sorted(FORMATS.values(), key=lambda form: form.legible)
    if form.legible
    for suffix in form.suffixes
)
MOST_LINES, WIDEST = 40, 160
LEFT_OVER = "left over: nothing in the manifest makes it"
OF_PARTS = ("tables/", "figures/")


class Stale(NamedTuple):
    """A file that a build would write or remove, in a word why, and perhaps the difference.

    `line` is the first of the file that differs, 0 where there is none to be read; `own` tells that it is not
    as it was built.
    """

    path: str
    why: str
    difference: tuple[str, ...] = ()
    line: int = 0
    own: bool = False


class CheckedHandbook(NamedTuple):
    """A handbook, what was built of it elsewhere, and its stale files."""

    handbook: Handbook
    anew: Build
    stale: list[Stale]


def check(
    handbooks: Sequence[Handbook], make: Maker, jobs: int, bar: Bar, by: Worked = worked
) -> list[CheckedHandbook]:
    """Build all anew in folders of their own, and return what failed and which files are stale.

    Nothing that an earlier build knew is believed, and nothing of the folders is changed. Where a part fails,
    only the files of the others count: documents without it are others anyway.
    """
    with ExitStack() as held:
        places = [held.enter_context(TemporaryDirectory(prefix="kurbel-")) for _ in handbooks]
        elsewhere = [
            one._replace(folder=Folder(place, "build")) for one, place in zip(handbooks, places, strict=True)
        ]
        builds = build(elsewhere, make, jobs, bar, by=by)
        return [
            CheckedHandbook(one, anew, [] if anew.ended else _stale(one, anew))
            for one, anew in zip(handbooks, builds, strict=True)
        ]


def _stale(one: Handbook, anew: Build) -> list[Stale]:
    folder = one.folder
    changed = [*_changed(folder, anew.folder)]
    if one.names:
        return changed
    if anew.failures:
        return [file for file in changed if file.path.startswith(OF_PARTS)]
    left_over = sorted(set(folder.contents()) - set(anew.folder.contents()))
    changed += [Stale(path, LEFT_OVER, line=1) for path in left_over if folder.read(path) is not None]
    if not changed and folder.read(CONTENTS) != anew.folder.read(CONTENTS):
        changed.append(Stale(CONTENTS, "differs", line=1))
    return changed


def _changed(folder: Folder, anew: Folder) -> Iterator[Stale]:
    differing, listed = [], folder.contents()
    for path in anew.contents():
        old = folder.read(path)
        if old is None:
            yield Stale(path, "missing")
        elif old != anew.read(path):
            differing.append(path)
    tables = [path for path in differing if path.startswith("tables/")]
    readable = map(os.path.splitext, tables or [path for path in differing if path.endswith(READABLE)])
    best: dict[str, str] = {}
    for name, suffix in sorted(readable, key=lambda parts: READABLE.index(parts[1])):
        best.setdefault(name, name + suffix)
    for path in differing:
        old, new = folder.read(path) or b"", anew.read(path) or b""
        difference = _difference(path, old, new) if path in best.values() else ()
        own = path in listed and digest(old) != listed[path]
        yield Stale(path, "differs", tuple(difference), _first_line(old, new), own)


def _first_line(old: bytes, new: bytes) -> int:
    """Return the first line, from 1, in which a text is another one than it was; 0 of what is no text."""
    try:
        before, after = (content.decode().split("\n") for content in (old, new))
    except UnicodeDecodeError:
        return 0
    same = takewhile(lambda pair: pair[0] == pair[1], zip(before, after, strict=False))
    # Of what ends too early it is the last one.
    return max(1, min(1 + sum(1 for _ in same), old.count(b"\n")))


def places(one: CheckedHandbook) -> Iterator[str]:
    """Yield sentences of what is stale, each with the file and the line where one would look.

    That is the line of the manifest of which a table or a drawing is made. A file that is no longer as it was
    built, or a document of which all tables and drawings are as they should be, is itself looked at.
    """
    manifest = one.handbook.manifest
    makers = {path: name for name, done in one.anew.new.items() for path in done.files}
    lines = {part.name: part.line for part in manifest.parts() if part.words}
    by_part: dict[str, list[Stale]] = {}
    alone: list[Stale] = []
    for file in one.stale:
        name = makers.get(file.path, "")
        if name in lines and not (file.own and file.line):
            by_part.setdefault(name, []).append(file)
        else:
            alone.append(file)
    for name in sorted(by_part, key=lambda name: lines[name]):
        yield f"{manifest.path}, line {lines[name]}, {name}: {_counted(by_part[name])}"
    for file in alone:
        if file.line and (file.own or file.why == LEFT_OVER or not by_part):
            where = f"{one.handbook.folder.path}/{file.path}"
            yield f"{where}, line {file.line}: {_SAID.get(file.why, file.why)}"
    rest = [file for file in alone if not file.line]
    if rest and not by_part:
        yield f"{manifest.path}, line 1: {_counted(rest)}"


_SAID = {"differs": "it is not what a build would write"}


def _counted(files: Sequence[Stale]) -> str:
    first, *others = files
    said = "is missing" if first.why == "missing" else "is stale"
    more = f", and so {'is one' if len(others) == 1 else f'are {len(others)}'} more" if others else ""
    return f"{first.path} {said}{more}"


def _difference(path: str, old: bytes, new: bytes) -> Iterator[str]:
    before, after = (content.decode("utf-8", "replace").splitlines() for content in (old, new))
    lines = unified_diff(before, after, f"{path} (here)", f"{path} (anew)", n=1, lineterm="")
    shown = [line if len(line) <= WIDEST else f"{line[:WIDEST]}…" for line in islice(lines, MOST_LINES)]
    yield from shown or ["only its line ends differ"]
    if left := sum(1 for _ in lines):
        yield f"… and {left} lines more"
