"""Whether the files of a handbook are those that a build would write now, and how they differ."""

from __future__ import annotations

import os
from collections.abc import Iterator
from difflib import unified_diff
from itertools import islice
from tempfile import TemporaryDirectory
from typing import NamedTuple

from kurbel.formats.registry import FORMATS
from kurbel.handbook.build import Bar, Build, Maker, build
from kurbel.handbook.folder import CONTENTS, Folder
from kurbel.handbook.manifest import Manifest

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
    """A file that a build would write or remove, in a word why, and perhaps the difference."""

    path: str
    why: str
    difference: tuple[str, ...] = ()


def check(manifest: Manifest, folder: Folder, make: Maker, jobs: int, bar: Bar) -> tuple[Build, list[Stale]]:
    """Build all anew in a folder of its own, and return what failed and which files are stale.

    Nothing that an earlier build knew is believed, and nothing of the folder is changed. Where a part fails,
    only the files of the others count: documents without it are others anyway.
    """
    with TemporaryDirectory(prefix="kurbel-") as temporary:
        anew = Folder(temporary, "build")
        built = build(manifest, anew, make, jobs, bar)
        if built.failures:
            return built, [one for one in _changed(folder, anew) if one.path.startswith(OF_PARTS)]
        left_over = sorted(set(folder.contents()) - set(anew.contents()))
        stale = [
            *_changed(folder, anew),
            *(Stale(path, LEFT_OVER) for path in left_over if folder.read(path) is not None),
        ]
        if not stale and folder.read(CONTENTS) != anew.read(CONTENTS):
            stale.append(Stale(CONTENTS, "differs"))
        return built, stale


def _changed(folder: Folder, anew: Folder) -> Iterator[Stale]:
    differing = []
    for path in anew.contents():
        old = folder.read(path)
        if old is None:
            yield Stale(path, "missing")
        elif old != anew.read(path):
            differing.append(path)
    shown = _worth_showing(differing)
    for path in differing:
        difference = _difference(path, folder, anew) if path in shown else ()
        yield Stale(path, "differs", tuple(difference))


def _worth_showing(paths: list[str]) -> set[str]:
    tables = [path for path in paths if path.startswith("tables/")]
    readable = map(os.path.splitext, tables or [path for path in paths if path.endswith(READABLE)])
    best: dict[str, str] = {}
    for name, suffix in sorted(readable, key=lambda parts: READABLE.index(parts[1])):
        best.setdefault(name, name + suffix)
    return {*best.values()}


def _difference(path: str, folder: Folder, anew: Folder) -> Iterator[str]:
    old, new = folder.read(path) or b"", anew.read(path) or b""
    before, after = (content.decode("utf-8", "replace").splitlines() for content in (old, new))
    lines = unified_diff(before, after, f"{path} (here)", f"{path} (anew)", n=1, lineterm="")
    shown = [line if len(line) <= WIDEST else f"{line[:WIDEST]}…" for line in islice(lines, MOST_LINES)]
    yield from shown or ["only its line ends differ"]
    if left := sum(1 for _ in lines):
        yield f"… and {left} lines more"
