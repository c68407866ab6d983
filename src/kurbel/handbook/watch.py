"""What a handbook is made of, looked at from outside: whether anything of it was saved."""

from __future__ import annotations

import os

from kurbel.errors import KurbelError
from kurbel.handbook.folder import Folder
from kurbel.handbook.manifest import manifest_path, read_manifest
from kurbel.handbook.state import files_below, read_state

# Times in nanoseconds, and sizes, by path.
Seen = dict[str, tuple[int, int]]


def glance(given: str) -> Seen:
    """Return times and sizes of the manifest, of the files that its parts name, of its templates
    and layouts.

    Of a manifest that cannot be read it is the manifest alone.
    """
    path = manifest_path(given)
    paths = [path]
    try:
        manifest = read_manifest(path)
        state = read_state(Folder(manifest.folder, manifest.output))
    except KurbelError:
        return _looked_at(paths)
    named = [part.file for part in manifest.parts() if part.file]
    named += [one for one in (manifest.machine, manifest.templates, manifest.layouts) if one]
    named += [file for done in state.values() for file in done.inputs]
    for one in dict.fromkeys(named):
        whole = os.path.join(manifest.folder, one)
        paths += (
            [os.path.join(whole, each) for each in files_below(whole)] if os.path.isdir(whole) else [whole]
        )
    return _looked_at(paths)


def as_built(before: Seen, after: Seen, started: int) -> Seen:
    """Return the files as the build found them that began at a time, in nanoseconds.

    Which files there are only the build finds out; one that was saved meanwhile is as it was before.
    """
    return {
        path: before.get(path, status if status[0] < started else (0, 0)) for path, status in after.items()
    }


def _looked_at(paths: list[str]) -> Seen:
    seen = {}
    for path in paths:
        try:
            status = os.stat(path)
            seen[path] = (status.st_mtime_ns, status.st_size)
        except OSError:
            seen[path] = (0, 0)
    return seen
