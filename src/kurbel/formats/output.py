"""Files are written whole or not at all: into a temporary file beside the target, renamed at the end."""

from __future__ import annotations

import os
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, BinaryIO

from kurbel.errors import OutputError

if TYPE_CHECKING:
    from pathlib import Path


@contextmanager
def whole_file(target: str) -> Iterator[BinaryIO]:
    """Give a binary stream that becomes the file `target` when the block ends without an exception.

    "-" is standard output. A link keeps pointing to its file; a device or a pipe is written directly.
    """
    if target == "-":
        yield sys.stdout.buffer
        sys.stdout.buffer.flush()
        return
    # Later than most imports: the first table on a terminal is there sooner without it.
    from pathlib import Path

    try:
        descriptor = _descriptor(target)
        if descriptor is not None:
            with os.fdopen(os.dup(descriptor), "wb") as stream:
                yield stream
        elif _is_device(Path(target)):
            with open(target, "wb") as device:
                yield device
        else:
            yield from _replaced(Path(os.path.realpath(target)))
    except BrokenPipeError:
        raise
    except OSError as error:
        raise OutputError(f"cannot write {target}: {_reason(error)}") from error


def _descriptor(target: str) -> int | None:
    """The number of the open stream that the target names: opened by name, a file behind it would be cut."""
    names = {"/dev/stdout": 1, "/dev/stderr": 2}
    folder, _, number = target.rpartition("/")
    if folder in ("/dev/fd", "/proc/self/fd") and number.isdecimal() and len(number) < 6:
        return int(number)
    return names.get(target)


def _is_device(path: Path) -> bool:
    # Asked of the target as it was given: a link such as /dev/fd/.. may lead to a pipe that has no path.
    return path.exists() and not path.is_file() and not path.is_dir()


def _replaced(path: Path) -> Iterator[BinaryIO]:
    _check(path)
    # Random, for a process killed in a container leaves its file, and the next one often has its number. The
    # target's name is cut, for with the additions it must not be longer than file names may be.
    name = path.with_name(f".{path.name[:40]}.{os.urandom(6).hex()}.part")
    try:
        handle = os.open(name, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
        with os.fdopen(handle, "wb") as stream:
            yield stream
            stream.flush()
            os.fsync(stream.fileno())
        os.chmod(name, _mode(path))
        os.replace(name, path)
    except BaseException:
        with suppress(FileNotFoundError):
            os.unlink(name)
        raise


def _check(path: Path) -> None:
    if path.is_dir():
        raise IsADirectoryError(21, "it is a directory; name a file in it")
    if path.parent.exists() and not path.parent.is_dir():
        raise NotADirectoryError(20, f"{path.parent} is not a directory")
    if not path.parent.is_dir():
        raise FileNotFoundError(2, f"the directory {path.parent} does not exist")
    if path.exists() and not os.access(path, os.W_OK):
        raise PermissionError(13, "the file is read-only")


def _mode(path: Path) -> int:
    """The mode of the old file, or what a new file would get."""
    if path.exists():
        return stat.S_IMODE(path.stat().st_mode)
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask


def _reason(error: OSError) -> str:
    return error.strerror or str(error)
