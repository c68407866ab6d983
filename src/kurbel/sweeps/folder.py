"""The folder beside a target where its parts lie until it is whole, so that a run that ended can go on.

One run at a time has it: its lock ends with the process, however that ends.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import replace
from typing import Any

from kurbel.commands.options import FILE
from kurbel.errors import OutputError
from kurbel.reading.given import File
from kurbel.sweeps.hands import lock
from kurbel.sweeps.parts import Place, is_whole, subfolder
from kurbel.sweeps.plan import Axis, Plan
from kurbel.sweeps.rows import Sweep
from kurbel.sweeps.versions import content_of, makers, other

ASKED = "sweep"


def identity_of(sweep: Sweep) -> dict[str, str]:
    """Return what tells a sweep, and who computes it, from all others."""
    asked = repr((sweep.plan, sweep.rows_at_once, files_of(sweep.plan)))
    return {ASKED: hashlib.sha256(asked.encode()).hexdigest(), **makers()}


def files_of(plan: Plan) -> dict[str, str]:
    """Return the files and folders of a plan, such as an indicator card, and what tells their content.

    What is not there has none, and is refused when it is read.
    """
    found: list[Any] = []
    _with_files(plan, found.append)
    return {path: content_of(path) for path in map(os.path.abspath, found)}


def grounded(plan: Plan) -> Plan:
    """Return the plan with files that count from the folder of this process, wherever it goes."""

    def absolute(value: object) -> File:
        if isinstance(value, File):
            return File(value.name, os.path.abspath(value.folder), value.inside)
        return File(str(value), os.getcwd())

    return _with_files(plan, absolute)


def _with_files(plan: Plan, file: Callable[[object], object]) -> Plan:
    """Return the plan with what `file` makes of each file that its options name."""
    kinds = {name: one.kind for name, one in plan.asking.options.items()}

    def named(name: str, value: object) -> Any:
        if isinstance(value, list | tuple):
            return [named(name, one) for one in value]
        return kinds[name].with_files(value, file) if value and name in kinds else value

    return replace(
        plan,
        given={name: named(name, value) for name, value in plan.given.items()},
        groups=tuple(
            tuple(
                # Other values may be a run that is never written out.
                Axis(name, named(name, [*values])) if kinds.get(name) is FILE else Axis(name, values)
                for name, values in group
            )
            for group in plan.groups
        ),
    )


SUFFIX = ".parts"
_FOLDER = re.compile("[0-9a-f]{16}")
_DONE = re.compile(r"\d{12}\.[0-9a-f]{8}\.(arrow|parquet)")
IDENTITY, LOCK = "sweep.json", "lock"


class Work:
    """The parts of a sweep that are done, by their numbers."""

    def __init__(self, path: str, identity: Mapping[str, str], word: str) -> None:
        self.path = path
        # Whoever still computes for another sweep has another folder, or none.
        self.folder = os.path.join(path, hashlib.sha256(repr(identity).encode()).hexdigest()[:16])
        self.place = Place(self.folder, os.path.join(path, LOCK), word)
        self._listed: tuple[str, dict[int, str]] = ("", {})

    def at(self, name: str) -> str:
        return os.path.join(self.folder, name)

    def found(self, number: int) -> str | None:
        """Return the name of a part that an earlier run made, or None; a broken one is removed."""
        listed, names = self._listed
        if listed != subfolder(number):
            names = self._names(subfolder(number))
            self._listed = subfolder(number), names
        name = names.get(number)
        if name is not None and not is_whole(self.at(name)):
            os.unlink(self.at(name))
            return None
        return name

    def _names(self, folder: str) -> dict[int, str]:
        try:
            names = os.listdir(self.at(folder))
        except FileNotFoundError:
            return {}
        return {int(name.split(".")[0]): f"{folder}/{name}" for name in names if _DONE.fullmatch(name)}

    def is_empty(self) -> bool:
        """Whether it has no part that is done."""
        return not any(_DONE.fullmatch(name) for _, _, names in os.walk(self.folder) for name in names)

    def remove(self) -> None:
        """Remove all parts. If the process ends before that is done, nobody takes what is left for work."""
        with suppress(FileNotFoundError):
            os.unlink(os.path.join(self.path, IDENTITY))
        _emptied(self.path)


@contextmanager
def working(target: str, identity: Mapping[str, str], *, resume: bool, restart: bool) -> Iterator[Work]:
    """Give the folder of parts of a target to this run until the block ends; it stays if it has parts.

    Raises OutputError where another run has it, or where it has parts, but is not to be gone on with.
    """
    path = os.path.realpath(target.rstrip("/" + os.sep)) + SUFFIX
    if not os.path.isdir(parent := os.path.dirname(path)):
        raise OutputError(f"cannot write {target}: the directory {parent} does not exist")
    try:
        handle, word = _locked(path, target)
    except OSError as error:
        raise OutputError(f"cannot write {path}: {error.strerror or error}") from error
    work = Work(path, identity, word)
    try:
        _begin(work, identity, resume, restart)
        try:
            yield work
        finally:
            if work.is_empty():
                work.remove()
    finally:
        _released(handle, path)


def _begin(work: Work, identity: Mapping[str, str], resume: bool, restart: bool) -> None:
    """Make the folder ready, with what is there of an earlier run if that is asked for."""
    earlier = _earlier(work.path)
    if earlier is None or restart:
        _emptied(work.path)
    elif not resume:
        raise OutputError(
            f"{work.path} has finished parts of an earlier run; --resume goes on with them,"
            " --restart begins anew"
        )
    elif earlier.get(ASKED) != identity[ASKED]:
        raise OutputError(
            f"{work.path} has parts of another sweep; give what that run was given, or"
            " --restart to begin anew"
        )
    elif differences := other(identity, earlier):
        raise OutputError(
            f"the parts in {work.path} were computed by {differences}; bytes may differ: go on with what made"
            " them, or begin anew with --restart"
        )
    os.makedirs(work.folder, exist_ok=True)
    temporary = os.path.join(work.path, f"{IDENTITY}.new")
    with open(temporary, "w", encoding="utf-8") as file:
        json.dump(dict(identity), file, indent=1)
    os.replace(temporary, os.path.join(work.path, IDENTITY))


def _earlier(path: str) -> dict[str, str] | None:
    """Return whose parts the folder has, or None if it has nothing of worth."""
    try:
        with open(os.path.join(path, IDENTITY), encoding="utf-8") as file:
            return dict(json.load(file))
    except FileNotFoundError:
        return None
    except (OSError, ValueError, TypeError):
        return {}


def _emptied(path: str) -> None:
    """Remove what runs have left in a folder, and nothing else."""
    for name in os.listdir(path):
        if _FOLDER.fullmatch(name):
            shutil.rmtree(os.path.join(path, name), ignore_errors=True)
        elif name.startswith(IDENTITY):
            os.unlink(os.path.join(path, name))


def _released(handle: int, path: str) -> None:
    """Give the folder free, and remove it if nothing is in it."""
    unused = not os.path.exists(os.path.join(path, IDENTITY))
    if unused and sys.platform != "win32":
        os.unlink(os.path.join(path, LOCK))
    os.close(handle)
    if unused:
        with suppress(OSError):
            # Windows removes no open file.
            if sys.platform == "win32":
                os.unlink(os.path.join(path, LOCK))
            os.rmdir(path)


def _locked(path: str, target: str) -> tuple[int, str]:
    """Return the open lock of the folder, and the word of this run that stands in it."""
    while True:
        with suppress(FileExistsError):
            os.mkdir(path)
        mark = os.path.join(path, LOCK)
        with suppress(FileNotFoundError):
            handle = os.open(mark, os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o644)
            if not lock(handle):
                os.close(handle)
                raise OutputError(f"another run writes {target} at this moment; wait for its end")
            # The run before may have removed it a moment ago.
            if os.path.exists(mark) and os.path.samestat(os.fstat(handle), os.stat(mark)):
                word = os.urandom(16).hex()
                os.ftruncate(handle, 0)
                os.write(handle, word.encode())
                return handle, word
            os.close(handle)
