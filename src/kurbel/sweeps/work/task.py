"""A part of a sweep is made: what is done in a thread, in another process or on another machine."""

from __future__ import annotations

import os
import zlib
from contextlib import nullcontext, suppress
from threading import Lock
from typing import NamedTuple

from kurbel.sweeps.rows import Part, Sweep

# The parts of a folder: as many files as every file system likes.
IN_A_FOLDER = 1000
_BALLS = Lock()


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


def made(sweep: Sweep, number: int, place: Place) -> str | bytes:
    """Make a part and return the name of its file; where the folder cannot be seen, its content."""
    content = content_of(sweep, number)
    return kept(content, number, place.folder) if place.is_here else content


def computed(sweep: Sweep, start: int, stop: int) -> Part:
    """Return the rows from one to another, in whatever thread this is."""
    # The precision of balls is that of the process.
    with nullcontext() if sweep.in_threads else _BALLS:
        return sweep.part(start, stop)


def content_of(sweep: Sweep, number: int) -> bytes:
    """Return a part as an Arrow file."""
    import pyarrow as pa

    from kurbel.sweeps.files.arrow import batch_of

    start = number * sweep.rows_at_once
    part = computed(sweep, start, min(start + sweep.rows_at_once, len(sweep)))
    batch, sink = batch_of(sweep, part), pa.BufferOutputStream()
    with pa.ipc.new_file(sink, batch.schema) as writer:
        writer.write_batch(batch)
    return memoryview(sink.getvalue()).tobytes()


def kept(content: bytes, number: int, folder: str) -> str:
    """Write a part, whole or not at all, and return its name, which tells whether it is still whole."""
    name = f"{subfolder(number)}/{number:012d}.{zlib.crc32(content):08x}.arrow"
    path = os.path.join(folder, name)
    # Not the folders above: if they are gone, the run has ended.
    with suppress(FileExistsError):
        os.mkdir(os.path.dirname(path))
    part = f"{path}.{os.urandom(6).hex()}"
    try:
        with open(part, "wb") as file:
            file.write(content)
        os.replace(part, path)
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
    with open(path, "rb") as file:
        return f"{zlib.crc32(file.read()):08x}" == path.split(".")[-2]
