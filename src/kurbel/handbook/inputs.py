"""What a handbook is made of, looked at from outside: whether anything of it was saved, or is another one."""

from __future__ import annotations

import hashlib
import os
import sys

from kurbel.errors import KurbelError
from kurbel.handbook.folder import Folder, files_below, key_of
from kurbel.handbook.manifest import manifest_path, read_manifest

# The hash of no file, for one that changed while it was read.
UNKNOWN = "?"
# Times in nanoseconds, and sizes, by path.
Seen = dict[str, tuple[int, int]]


def digest_of(path: str) -> str:
    """Return the hash of a file, or of all files in a folder; nothing for what is not there."""
    if os.path.isdir(path):
        return key_of([(name, digest_of(os.path.join(path, name))) for name in files_below(path)])
    try:
        # A pipe would be waited for, and a device may have no end.
        if not os.path.isfile(path):
            return ""
        with open(path, "rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except (OSError, ValueError):
        return ""


def glance(*paths: str) -> Seen:
    """Return when the files, and those in the folders, were saved, and their sizes; zeros for what is not."""
    seen = {}
    for path in paths:
        for one in (path, *(os.path.join(path, name) for name in files_below(path))):
            try:
                status = os.stat(one)
                seen[one] = (status.st_mtime_ns, status.st_size)
            except (OSError, ValueError):
                seen[one] = (0, 0)
    return seen


def glance_at(given: str, outside: bool = False) -> Seen:
    """Look at the manifest, at the files that its parts name, at its templates and layouts.

    Of a manifest that cannot be read, or whose problems cannot, it is that with the TOML files beside it.
    """
    path = manifest_path(given)
    try:
        manifest = read_manifest(path, outside)
        state = Folder(manifest.folder, manifest.output).state()
    except KurbelError:
        folder = os.path.dirname(path)
        beside = os.listdir(folder or ".") if os.path.isdir(folder or ".") else ()
        return glance(path, *(os.path.join(folder, one) for one in sorted(beside) if one.endswith(".toml")))
    named: list[str | None] = [part.file or part.problems for part in manifest.parts()]
    named += [manifest.machine, manifest.templates, manifest.layouts]
    named += [file for done in state.values() for file in done.inputs]
    return glance(path, *(os.path.join(manifest.folder, one) for one in dict.fromkeys(named) if one))


def as_built(before: Seen, after: Seen, started: int) -> Seen:
    """Return the files as the build found them that began at a time, in nanoseconds.

    Which files there are only the build finds out; one that was saved meanwhile is as it was before.
    """
    return {
        path: before.get(path, status if status[0] < started else (0, 0)) for path, status in after.items()
    }


def fingerprint() -> str:
    """Return what tells this kurbel and the libraries below it from others.

    Sizes and times of kurbel's own files, and the names of what is installed, which have the versions in
    them: to ask for the versions one by one takes longer than to build nothing.
    """
    from kurbel.page.layouts import template_folder

    package = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    files = [
        os.path.join(folder, name)
        for folder in (package, template_folder())
        for name in files_below(folder)
        if "__pycache__" not in name
    ]
    folders = filter(os.path.isdir, sys.path)
    installed = [sorted(name for name in os.listdir(one) if name.endswith(".dist-info")) for one in folders]
    return key_of(sys.version, glance(*files), installed)
