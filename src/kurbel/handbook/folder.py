"""The folder that a handbook is built into, and whether anything that it is made of was saved.

Nothing but the folder is touched, and one build at a time writes. Beside the output lies what the last build
knew, so that the next one makes only what changed. It is never believed alone: a file whose content is not
the one that was written is made anew.
"""

from __future__ import annotations

import hashlib
import json
import os
import stat
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress

import msgspec

from kurbel.errors import HandbookError, KurbelError, OutputError
from kurbel.formats.registry import FORMATS, PageFormat
from kurbel.formats.render import remove_left_over, whole_file
from kurbel.handbook.manifest import manifest_path, read_manifest
from kurbel.handbook.pool import ListEntry
from kurbel.page.layouts import template_folder
from kurbel.sweeps.hands import lock

# What is only of use on this machine: the lock and what the last build knew.
OWN = ".kurbel"
STATE = f"{OWN}/state.json"
# The sheets of tables, which wait here for their workbook.
SHEETS = f"{OWN}/sheets"
# All that was built, with hashes: it tells what an earlier build left behind, also on another machine.
CONTENTS = "contents.json"
# Bytes of a file; no page has so many.
LARGEST = 1 << 28


class BuiltPart(msgspec.Struct, frozen=True):
    """A part or a document as it was made: from what, out of which files, and which files it became."""

    key: str
    inputs: dict[str, str]
    files: dict[str, str]
    about: ListEntry | None = None


class Folder:
    """An output folder below a base folder. Paths in it are relative, parted by /."""

    def __init__(self, base: str, name: str) -> None:
        """Raise HandbookError if the way from the base to the folder leads over a link or a file."""
        self.path = os.path.normpath(os.path.join(base, *name.split("/")))
        self.base = base
        self.name = name
        self._check("")

    def at(self, relative: str) -> str:
        return os.path.join(self.path, *relative.split("/")) if relative else self.path

    def _check(self, relative: str) -> None:
        """Raise HandbookError if a folder on the way to the path is a link or no folder."""
        parts = [*self.name.split("/"), *(relative.split("/")[:-1] if relative else [])]
        if ".." in parts or os.path.isabs(relative):
            raise HandbookError(f"{relative[:60]} lies outside of the output folder {self.name}")
        way = self.base
        for part in parts:
            way = os.path.join(way, part)
            with suppress(FileNotFoundError):
                mode = os.lstat(way).st_mode
                if stat.S_ISLNK(mode):
                    raise HandbookError(f"{way} is a link, which may lead anywhere; name a folder")
                if not stat.S_ISDIR(mode):
                    raise HandbookError(f"{way} is a file; the handbook is built into a folder")

    def read(self, relative: str) -> bytes | None:
        """Return what a file has, or None if there is no such file.

        What a build cannot have written, such as a link, a pipe or a path that leads elsewhere, is none.
        """
        path = self.at(relative)
        try:
            self._check(relative)
            status = os.lstat(path)
            if not stat.S_ISREG(status.st_mode) or status.st_size > LARGEST:
                return None
            with open(path, "rb") as file:
                return file.read()
        except PermissionError as error:
            raise OutputError(f"cannot read {path}: {error.strerror}") from error
        except (HandbookError, OSError, ValueError):
            # A path from a list that somebody wrote may be one that no file can have.
            return None

    def has(self, relative: str, hashed: str) -> bool:
        """Tell whether there is a file with content of this hash."""
        content = self.read(relative)
        return content is not None and digest(content) == hashed

    def write(self, relative: str, content: bytes) -> bool:
        """Write a file whole or not at all; tell whether it was another one before.

        Raises HandbookError for anything but a file in its place, OutputError where the disk is full.
        """
        self._check(relative)
        path = self.at(relative)
        _check_place(path)
        if self.read(relative) == content:
            return False
        try:
            os.makedirs(os.path.dirname(path), exist_ok=True)
        except OSError as error:
            raise OutputError(f"cannot make {os.path.dirname(path)}: {error.strerror}") from error
        with whole_file(path) as stream:
            stream.write(content)
        return True

    def remove(self, relative: str) -> None:
        """Remove a file, and its folder if nothing else is in it."""
        self._check(relative)
        try:
            os.unlink(self.at(relative))
        except OSError as error:
            raise OutputError(f"cannot remove {self.at(relative)}: {error.strerror}") from error
        if "/" in relative:
            with suppress(OSError):
                os.rmdir(os.path.dirname(self.at(relative)))

    @contextmanager
    def locked(self, waiting: Callable[[], None]) -> Iterator[None]:
        """Hold the folder against other builds; `waiting` is called if one is under way.

        The lock ends with the process, however that ends. What a killed build left half written is removed.
        """
        name = f"{OWN}/lock"
        self._check(name)
        try:
            os.makedirs(self.at(OWN), exist_ok=True)
            handle = os.open(self.at(name), os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o644)
        except OSError as error:
            raise OutputError(f"cannot write into {self.path}: {error.strerror}") from error
        try:
            if not lock(handle):
                waiting()
                lock(handle, wait=True)
            self._remove_left_over()
            self.write(f"{OWN}/.gitignore", b"*\n")
            yield
        finally:
            os.close(handle)

    def _remove_left_over(self) -> None:
        for part in {
            "",
            OWN,
            SHEETS,
            "tables",
            "figures",
            *(form.folder for form in FORMATS.values() if isinstance(form, PageFormat)),
        }:
            # A link in place of a folder leads to files of others.
            with suppress(HandbookError):
                self._check(f"{part}/" if part else "")
                remove_left_over(self.at(part))

    def state(self) -> dict[str, BuiltPart]:
        """Return what the last build made, by name; nothing if there is none that can be read."""
        try:
            return msgspec.json.decode(self.read(STATE) or b"{}", type=dict[str, BuiltPart])
        except (ValueError, RecursionError):
            # Not ours, or of another version: all is made anew.
            return {}

    def keep_state(self, state: Mapping[str, BuiltPart]) -> None:
        # A caption is a kind of text.
        self.write(STATE, msgspec.json.encode(state, enc_hook=str))

    def contents(self) -> dict[str, str]:
        """Return the files of the list that lies here; none if there is no list or it is not ours."""
        try:
            listed = msgspec.json.decode(self.read(CONTENTS) or b"{}", type=dict[str, dict[str, str]])
        except (ValueError, RecursionError):
            return {}
        return {path: hashed for path, hashed in listed.get("files", {}).items() if not path.startswith(".")}

    def list_contents(self, files: Mapping[str, str]) -> None:
        """Write the list of what was built: each file and its hash."""
        listed = {path: hashed for path, hashed in sorted(files.items()) if not is_own(path)}
        self.write(CONTENTS, (json.dumps({"files": listed}, indent=0) + "\n").encode())


def is_own(path: str) -> bool:
    """Tell whether a file is nothing that is built, but what a build keeps for the next."""
    return path.startswith(f"{OWN}/")


def _check_place(path: str) -> None:
    """Raise HandbookError if there is anything but a file."""
    with suppress(FileNotFoundError):
        mode = os.lstat(path).st_mode
        if stat.S_ISLNK(mode):
            raise HandbookError(f"{path} is a link, which may lead anywhere; remove it")
        if not stat.S_ISREG(mode):
            what = "a folder" if stat.S_ISDIR(mode) else "a pipe or a device"
            raise HandbookError(f"{path} is {what}, and a file is to be there; remove it")


def digest(content: bytes) -> str:
    """Return what tells this content from any other."""
    return hashlib.sha256(content).hexdigest()


def key_of(*values: object) -> str:
    """Return what tells these values from all others."""
    return digest(repr(values).encode())


def files_below(path: str) -> list[str]:
    """Return the files in a folder and its folders, sorted, relative to it."""
    found = []
    for way, _, names in os.walk(path):
        found += [os.path.relpath(os.path.join(way, name), path).replace(os.sep, "/") for name in names]
    return sorted(found)


# The hash of no file, for one that changed while it was read.
UNKNOWN = "?"
# Times in nanoseconds, and sizes, by path.
Seen = dict[str, tuple[int, int]]


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
