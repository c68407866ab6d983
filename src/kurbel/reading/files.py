"""Files as they are named: relative to some folder, and shown in messages as they were written."""

from __future__ import annotations

import os


class File(os.PathLike[str]):
    """A file by its name, which counts from a folder; no folder is the one in which kurbel runs."""

    __slots__ = ("folder", "name")

    def __init__(self, name: str, folder: str = "") -> None:
        self.name = name
        self.folder = folder

    def __fspath__(self) -> str:
        return os.path.join(self.folder, self.name)

    def __bool__(self) -> bool:
        return bool(self.name)

    def __str__(self) -> str:
        return self.name

    def beside(self, name: str) -> File:
        """Return the file of a name that counts from where this one lies."""
        return File(os.path.join(os.path.dirname(self.name), name), self.folder)
