"""By what digits and files are made: this kurbel, and the libraries below it."""

from __future__ import annotations

import hashlib
import os
import platform
from collections.abc import Mapping
from functools import cache
from importlib.metadata import PackageNotFoundError, version

from kurbel.page.layouts import template_folder

# By these numbers are computed and files are written.
LIBRARIES = ("numpy", "scipy", "python-flint", "numba", "pyarrow")
NONE = "none"
_PACKAGE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


@cache
def makers(libraries: tuple[str, ...] = LIBRARIES) -> dict[str, str]:
    """Return kurbel and all that its digits and files are made by, with their versions."""
    python = f"{platform.python_implementation()} {'.'.join(platform.python_version_tuple()[:2])}"
    # The source tells this kurbel from others of the same version.
    source = hashlib.sha256(f"{tree_of(_PACKAGE)}{tree_of(template_folder())}".encode()).hexdigest()
    own = {"kurbel": f"{_version('kurbel')} ({source[:12]})", "python": python}
    return {**own, "processor": platform.machine(), **{name: _version(name) for name in libraries}}


def other(own: Mapping[str, str], theirs: Mapping[str, str]) -> str:
    """Return in words what is other there than here, or nothing."""
    return ", ".join(
        f"{name} {theirs.get(name, NONE)[:30]} in place of {ours[:30]}"
        for name, ours in own.items()
        if theirs.get(name) != ours
    )


def content_of(path: str) -> str:
    """Return what tells the content of a file, or of a folder, from others; nothing of what is not there."""
    if os.path.isdir(path):
        return tree_of(path)
    try:
        # A pipe would be waited for, and a device may have no end.
        if not os.path.isfile(path):
            return ""
        with open(path, "rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except (OSError, ValueError):
        return ""


def tree_of(top: str) -> str:
    """Return what tells the files of a folder, and of those in it, from others."""
    found = hashlib.sha256()
    for folder, below, names in os.walk(top):
        below[:] = sorted(name for name in below if name != "__pycache__")
        for name in sorted(names):
            path = os.path.join(folder, name)
            found.update(f"{os.path.relpath(path, top)}\n{content_of(path)}\n".replace(os.sep, "/").encode())
    return found.hexdigest()


def _version(library: str) -> str:
    try:
        return version(library)
    except PackageNotFoundError:
        return NONE
