"""Whether files lie in a folder, wherever links lead: what a handbook or a document may read."""

from __future__ import annotations

import os

from kurbel.errors import OutsideError

HANDBOOK, DOCUMENT = "handbook", "document"


def is_inside(path: str, folder: str) -> bool:
    """Tell whether a file lies in a folder."""
    home = os.path.join(os.path.realpath(folder or "."), "")
    return os.path.join(os.path.realpath(path), "").startswith(home)


def check_inside(path: str, folder: str, name: str, whose: str = HANDBOOK) -> None:
    """Raise OutsideError for a file that lies outside of the folder; `name` is what it was called.

    `whose` the folder is: that of a handbook or of a document.
    """
    if not is_inside(path, folder):
        raise OutsideError(name, whose)


def check_below(path: str, folder: str, name: str, whose: str) -> None:
    """Raise the same for a folder that has something in it which leads out; a file has nothing in it."""
    for way, folders, files in os.walk(path):
        for one in (*folders, *files):
            file = os.path.join(way, one)
            check_inside(file, folder, os.path.join(name, os.path.relpath(file, path)), whose)
