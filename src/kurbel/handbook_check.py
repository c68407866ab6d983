"""Whether the files of a handbook are those that a build would write now, and how they differ."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from difflib import unified_diff
from itertools import islice
from tempfile import TemporaryDirectory
from typing import NamedTuple

from kurbel.handbook import Built, Maker
from kurbel.handbook_build import CONTENTS, build, contents_in
from kurbel.handbook_folder import OWN, Folder
from kurbel.handbook_manifest import Manifest
from kurbel.handbook_state import files_below

# A reader wants to see what changed, not all that did.
MOST_LINES, WIDEST = 40, 160


class Stale(NamedTuple):
    """A file that a build would write or remove, and in words or as a difference what it would do."""

    path: str
    shown: tuple[str, ...]


def check(
    manifest: Manifest,
    folder: Folder,
    make: Maker,
    jobs: int,
    start: Callable[[int], Callable[[], None]] = lambda count: lambda: None,
) -> tuple[Built, list[Stale]]:
    """Build all anew in a folder of its own, and return what failed and which files are stale.

    Nothing that an earlier build knew is believed, and nothing of the folder is changed.
    """
    with TemporaryDirectory(prefix="kurbel-") as temporary:
        anew = Folder(temporary, "build")
        built = build(manifest, anew, make, jobs, start)
        return built, [*_stale(folder, anew)]


def _stale(folder: Folder, anew: Folder) -> Iterator[Stale]:
    made = [path for path in files_below(anew.path) if not path.startswith(f"{OWN}/")]
    found = [one for path in made if path != CONTENTS for one in _differing(path, folder, anew)]
    found += [
        Stale(path, ("left over: nothing in the manifest makes it",))
        for path in sorted(set(contents_in(folder)) - set(made))
        if folder.read(path) is not None
    ]
    yield from found or _differing(CONTENTS, folder, anew)


def _differing(path: str, folder: Folder, anew: Folder) -> Iterator[Stale]:
    old, new = folder.read(path), anew.read(path) or b""
    if old is None:
        yield Stale(path, ("missing",))
    elif old != new:
        yield Stale(path, tuple(_difference(path, old, new)))


def _difference(path: str, old: bytes, new: bytes) -> Iterator[str]:
    if path.endswith(".pdf"):
        yield f"another PDF: {len(old)} bytes here, {len(new)} anew"
        return
    before, after = (content.decode("utf-8", "replace").splitlines() for content in (old, new))
    lines = unified_diff(before, after, f"{path} (here)", f"{path} (anew)", n=1, lineterm="")
    shown = [line if len(line) <= WIDEST else f"{line[:WIDEST]}…" for line in islice(lines, MOST_LINES)]
    yield from shown or ["only its line ends differ"]
    if left := sum(1 for _ in lines):
        yield f"… and {left} lines more"
