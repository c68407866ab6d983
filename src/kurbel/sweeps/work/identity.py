"""What the bytes of a sweep depend on: what was asked for, this kurbel, and the libraries below it."""

from __future__ import annotations

import hashlib
import os
import platform
from collections.abc import Mapping
from functools import cache
from importlib.metadata import PackageNotFoundError, version

import kurbel
from kurbel.page.layouts import template_folder
from kurbel.sweeps.rows import Sweep

# By these numbers are computed and files are written.
LIBRARIES = ("numpy", "scipy", "python-flint", "numba", "pyarrow")
NONE = "none"
ASKED = "sweep"


def identity_of(sweep: Sweep) -> dict[str, str]:
    """Return what tells a sweep, and who computes it, from all others."""
    asked = hashlib.sha256(repr((sweep.plan, sweep.rows_at_once)).encode()).hexdigest()
    return {ASKED: asked, **makers()}


@cache
def makers() -> dict[str, str]:
    """Return kurbel and all that its digits and files are made by, with their versions."""
    python = f"{platform.python_implementation()} {'.'.join(platform.python_version_tuple()[:2])}"
    own = {"kurbel": f"{kurbel.__version__} ({_sources()[:12]})", "python": python}
    return {**own, "processor": platform.machine(), **{name: _version(name) for name in LIBRARIES}}


def other(own: Mapping[str, str], theirs: Mapping[str, str]) -> str:
    """Return in words what is other there than here, or nothing."""
    return ", ".join(
        f"{name} {theirs.get(name, NONE)} in place of {ours}"
        for name, ours in own.items()
        if theirs.get(name) != ours
    )


def _version(library: str) -> str:
    try:
        return version(library)
    except PackageNotFoundError:
        return NONE


def _sources() -> str:
    """Return what tells the source of this kurbel from others of the same version."""
    found = hashlib.sha256()
    for top in (os.path.dirname(kurbel.__file__), template_folder()):
        for folder, below, names in os.walk(top):
            below[:] = sorted(name for name in below if name != "__pycache__")
            for name in sorted(names):
                path = os.path.join(folder, name)
                found.update(os.path.relpath(path, top).replace(os.sep, "/").encode())
                with open(path, "rb") as file:
                    found.update(file.read())
    return found.hexdigest()
