"""A file or a folder that a library writes by its name: whole or not at all."""

from __future__ import annotations

import os
import shutil
import stat
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from kurbel.errors import OutputError

_NAME = "whole"


@contextmanager
def whole_path(target: str, scratch: str, owned: Callable[[str], bool] | None = None) -> Iterator[str]:
    """Give a name in the folder `scratch`, beside the target, for what becomes the target in the end.

    A folder takes the place of one that is empty or `owned`: that holds nothing but what kurbel wrote.
    """
    target = os.path.realpath(target.rstrip("/" + os.sep) or target)
    half = os.path.join(scratch, _NAME)
    _removed(half)
    try:
        _check(target, owned)
        yield half
        _synced(half)
        # What was put there while this was written.
        _check(target, owned)
        if os.path.isdir(target):
            # A folder cannot be put in the place of another at once: that one first goes to the scratch.
            os.rename(target, f"{half}.old")
        os.replace(half, target)
    except OSError as error:
        raise OutputError(f"cannot write {target}: {_said(error)}") from error
    finally:
        _removed(half)
        _removed(f"{half}.old")


def _check(target: str, owned: Callable[[str], bool] | None) -> None:
    parent = os.path.dirname(target)
    if not os.path.isdir(parent):
        raise FileNotFoundError(2, f"the directory {parent} does not exist")
    if owned is None:
        if os.path.isdir(target):
            raise IsADirectoryError(21, "it is a directory; name a file in it")
    elif os.path.isfile(target):
        raise NotADirectoryError(20, "it is a file, and this is written as a folder")
    elif os.path.isdir(target) and os.listdir(target) and not owned(target):
        raise FileExistsError(17, "the folder has other files; name a new one")


def _said(error: OSError) -> str:
    return error.strerror or str(error)


def _removed(path: str) -> None:
    if os.path.isdir(path) and not os.path.islink(path):
        shutil.rmtree(path, ignore_errors=True)
    elif os.path.lexists(path):
        os.unlink(path)


def _synced(path: str) -> None:
    """Have what was written on the disk before it gets its name, readable to whom a new file is."""
    mask = os.umask(0)
    os.umask(mask)
    for folder, _, names in os.walk(path):
        for name in names:
            _sync(os.path.join(folder, name), mask)
    if os.path.isfile(path):
        _sync(path, mask)


def _sync(path: str, mask: int) -> None:
    with open(path, "rb+") as file:
        os.fsync(file.fileno())
    if stat.S_IMODE(os.stat(path).st_mode) != 0o666 & ~mask:
        os.chmod(path, 0o666 & ~mask)
