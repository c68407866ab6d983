"""A part of a sweep is made: what is done in a thread, in another process or on another machine."""

from __future__ import annotations

import os
import zlib
from abc import ABC, abstractmethod
from collections.abc import Callable
from contextlib import nullcontext, suppress
from dataclasses import dataclass
from functools import partial
from io import FileIO
from typing import Any, ClassVar, NamedTuple

from kurbel.sweeps.rows import Part, Sweep
from kurbel.sweeps.work.hands import BALLS, check_wanted

# The parts of a folder: as many files as every file system likes.
IN_A_FOLDER = 1000
# Bytes that are read at once.
AT_ONCE = 1 << 20


class Place(NamedTuple):
    """Where parts are to lie: a folder, and a file beside it with a word that no other folder has."""

    folder: str
    mark: str
    word: str

    @property
    def is_here(self) -> bool:
        """Whether this process sees the same folder as the one that named it."""
        try:
            with open(self.mark, encoding="ascii") as file:
                return file.read() == self.word
        except (OSError, UnicodeError):
            return False


@dataclass(frozen=True)
class Unit(ABC):
    """Rows of a sweep that are computed at once, and how they are written to a file of a suffix."""

    sweep: Sweep
    suffix: ClassVar[str]

    @property
    @abstractmethod
    def rows(self) -> int:
        """How many rows it has; the last one may have fewer."""

    @abstractmethod
    def write(self, number: int, sink: Any) -> None:
        """Write the rows of a number."""

    @property
    def count(self) -> int:
        """How many there are in the sweep."""
        return -(-len(self.sweep) // self.rows)

    def rows_of(self, number: int) -> int:
        return min(self.rows, len(self.sweep) - number * self.rows)


def made(unit: Unit, place: Place, number: int) -> str | bytes:
    """Make a part and return the name of its file; where the folder cannot be seen, its content."""
    if place.is_here:
        return _kept(partial(unit.write, number), number, place.folder, unit.suffix)
    import pyarrow as pa

    sink = pa.BufferOutputStream()
    unit.write(number, sink)
    return memoryview(sink.getvalue()).tobytes()


def computed(sweep: Sweep, start: int, stop: int) -> Part:
    """Return rows without the options that vary, in whatever thread this is."""
    check_wanted()
    # The precision of balls is that of the process.
    with nullcontext() if sweep.in_threads else BALLS:
        return sweep.computed(start, stop)


def kept(content: bytes, number: int, folder: str, suffix: str) -> str:
    """Keep a part that came from another machine, and return its name."""
    return _kept(lambda file: file.write(content), number, folder, suffix)


class _Summed:
    """A file and the sum of what was written to it, as arrays lie in memory and without a copy of them."""

    closed = False

    def __init__(self, path: str) -> None:
        self.file = FileIO(path, "wb")
        self.sum = 0

    def write(self, content: Any) -> int:
        self.sum = zlib.crc32(content, self.sum)
        left = memoryview(content).cast("B")
        while left:
            # At once a system writes two gigabytes at the most.
            left = left[self.file.write(left) :]
        return len(content)

    def flush(self) -> None:
        """All is written as it comes."""


def _kept(write: Callable[[Any], object], number: int, folder: str, suffix: str) -> str:
    """Write a part, whole or not at all, and return its name, which tells whether it is still whole."""
    begin = f"{subfolder(number)}/{number:012d}"
    # Not the folders above: if they are gone, the run has ended.
    with suppress(FileExistsError):
        os.mkdir(os.path.join(folder, subfolder(number)))
    part = os.path.join(folder, f"{begin}.{os.urandom(6).hex()}")
    try:
        into = _Summed(part)
        with into.file:
            write(into)
        name = f"{begin}.{into.sum:08x}{suffix}"
        os.replace(part, os.path.join(folder, name))
    except BaseException:
        with suppress(OSError):
            os.unlink(part)
        raise
    return name


def subfolder(number: int) -> str:
    """Return the folder that a part lies in."""
    return f"{number // IN_A_FOLDER:09d}"


def is_whole(path: str) -> bool:
    """Tell whether a part is what was written: a machine that lost its power may have kept less of it."""
    found = 0
    with open(path, "rb") as file:
        while content := file.read(AT_ONCE):
            found = zlib.crc32(content, found)
    return f"{found:08x}" == path.split(".")[-2]
