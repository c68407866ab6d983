"""What the last build knew, so that the next one makes only what changed: hashes, kept beside the output.

The state is never believed alone: a file whose content is not the one that was written is made anew.
"""

from __future__ import annotations

import hashlib
import json
import os
import sys
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from typing import Any, NamedTuple

from kurbel.handbook.folder import OWN, Folder, digest

# The hash of no file, for one that changed while it was read.
UNKNOWN = "?"
STATE = f"{OWN}/state.json"
# All that was built, with hashes: it tells what an earlier build left behind, also on another machine.
CONTENTS = "contents.json"


class Done(NamedTuple):
    """A part or a document as it was made: from what, out of which files, and which files it became.

    `about` is what documents say of a part: its kind, caption and language.
    """

    key: str
    inputs: Mapping[str, str]
    files: Mapping[str, str]
    about: tuple[str, ...] = ()


def read_state(folder: Folder) -> dict[str, Done]:
    """Return what the last build made, by name; nothing if there is none that can be read."""
    try:
        given = json.loads(folder.read(STATE) or b"{}")
        return {name: _done(one) for name, one in given.items()}
    except (ValueError, TypeError, AttributeError, KeyError, RecursionError):
        # Not ours, or of another version: all is made anew.
        return {}


def _done(one: Mapping[str, Any]) -> Done:
    files, inputs = dict(one["files"]), dict(one["inputs"])
    if not all(isinstance(path, str) for path in (*files, *files.values(), *inputs)):
        raise TypeError
    about = tuple(map(str, one["about"]))
    if about and (len(about) != 3 or about[0] not in ("table", "figure")):
        raise ValueError
    return Done(str(one["key"]), inputs, files, about)


def write_state(folder: Folder, state: Mapping[str, Done]) -> None:
    content = json.dumps({name: one._asdict() for name, one in state.items()}, ensure_ascii=False)
    folder.write(STATE, content.encode())


def contents_of(files: Mapping[str, str]) -> bytes:
    """Return the list of what was built: each file and its hash."""
    return (json.dumps({"files": dict(sorted(files.items()))}, indent=0) + "\n").encode()


def contents_in(folder: Folder) -> dict[str, str]:
    """Return the list that lies in the folder; an empty one if there is none or it is not ours."""
    try:
        files = json.loads(folder.read(CONTENTS) or b"{}").get("files", {})
        return {path: hashed for path, hashed in files.items() if isinstance(hashed, str) and _is_plain(path)}
    except (ValueError, AttributeError, RecursionError):
        return {}


def _is_plain(path: str) -> bool:
    """Tell whether a path is one that a build could have written."""
    return not os.path.isabs(path) and ".." not in path.split("/") and not path.startswith(".")


def key_of(*values: Any) -> str:
    """Return what tells these values from all others."""
    return digest(json.dumps(values, ensure_ascii=False, sort_keys=True).encode())


def is_fresh(done: Done, key: str, base: str, folder: Folder) -> bool:
    """Tell whether something would be made again as it lies there."""
    return (
        done.key == key
        and all(digest_of(os.path.join(base, path)) == hashed for path, hashed in done.inputs.items())
        and all(folder.has(path, hashed) for path, hashed in done.files.items())
    )


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


def latest_change(path: str) -> int:
    """Return when a file, or the last of the files in a folder, was saved, in nanoseconds."""
    names = [os.path.join(path, name) for name in files_below(path)]
    with suppress(OSError, ValueError):
        return max(os.stat(one).st_mtime_ns for one in (path, *names))
    return 0


def files_below(path: str) -> list[str]:
    """Return the files in a folder and its folders, sorted, relative to it."""
    found = []
    for way, folders, names in os.walk(path):
        folders.sort()
        found += [os.path.relpath(os.path.join(way, name), path).replace(os.sep, "/") for name in names]
    return sorted(found)


def fingerprint() -> str:
    """Return what tells this kurbel and the libraries below it from others.

    Sizes and times of kurbel's own files, and the names of what is installed, which have the versions in
    them: to ask for the versions one by one takes longer than to build nothing.
    """
    package = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    from kurbel.page.layouts import template_folder

    return key_of(sys.version, [*_files(package)], [*_files(template_folder())], [*_installed()])


def _files(folder: str) -> Iterator[tuple[str, int, int]]:
    for path in files_below(folder):
        if "__pycache__" not in path:
            status = os.stat(os.path.join(folder, path))
            yield path, status.st_size, status.st_mtime_ns


def _installed() -> Iterable[str]:
    for folder in sys.path:
        if os.path.isdir(folder):
            yield from sorted(name for name in os.listdir(folder) if name.endswith(".dist-info"))
