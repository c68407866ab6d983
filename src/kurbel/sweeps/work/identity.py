"""What the bytes of a sweep depend on: what was asked for, this kurbel, and the libraries below it."""

from __future__ import annotations

import hashlib
import os
import platform
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from typing import Any

import kurbel
from kurbel.commands.options import FILE
from kurbel.page.layouts import template_folder
from kurbel.reading.given import File
from kurbel.sweeps.plan import Axis, Plan
from kurbel.sweeps.rows import Sweep

# By these numbers are computed and files are written.
LIBRARIES = ("numpy", "scipy", "python-flint", "numba", "pyarrow")
NONE = "none"
ASKED = "sweep"


def identity_of(sweep: Sweep) -> dict[str, str]:
    """Return what tells a sweep, and who computes it, from all others."""
    asked = repr((sweep.plan, sweep.rows_at_once, files_of(sweep.plan)))
    return {ASKED: hashlib.sha256(asked.encode()).hexdigest(), **makers()}


def files_of(plan: Plan) -> dict[str, str]:
    """Return the files and folders of a plan, such as an indicator card, and what tells their content.

    What is not there has none, and is refused when it is read.
    """
    names = _file_options(plan)
    given = [value for name, value in plan.given.items() if name in names and value]
    given += [one for group in plan.groups for axis in group if axis.option in names for one in axis.values]
    return {path: content_of(path) for path in map(os.path.abspath, given)}


def grounded(plan: Plan) -> Plan:
    """Return the plan with files that count from the folder of this process, wherever it goes."""
    names = _file_options(plan)

    def absolute(name: str, value: Any) -> Any:
        if name not in names or not value:
            return value
        if isinstance(value, File):
            return File(value.name, os.path.abspath(value.folder), value.inside)
        return File(os.fspath(value), os.getcwd())

    return replace(
        plan,
        given={name: absolute(name, value) for name, value in plan.given.items()},
        groups=tuple(
            tuple(
                Axis(name, [absolute(name, one) for one in values] if name in names else values)
                for name, values in group
            )
            for group in plan.groups
        ),
    )


def _file_options(plan: Plan) -> set[str]:
    return {one.name for one in plan.asking.parameters.values() if one.option.kind is FILE}


def content_of(path: str) -> str:
    """Return what tells the content of a file, or of a folder, from others; nothing of what is not there."""
    if os.path.isdir(path):
        return tree_of(path)
    # A pipe would be waited for, and could be read once.
    if not os.path.isfile(path):
        return ""
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


@cache
def makers() -> dict[str, str]:
    """Return kurbel and all that its digits and files are made by, with their versions."""
    python = f"{platform.python_implementation()} {'.'.join(platform.python_version_tuple()[:2])}"
    own = {
        "kurbel": f"{kurbel.__version__} ({hashlib.sha256(_sources().encode()).hexdigest()[:12]})",
        "python": python,
    }
    return {**own, "processor": platform.machine(), **{name: _version(name) for name in LIBRARIES}}


def other(own: Mapping[str, str], theirs: Mapping[str, str]) -> str:
    """Return in words what is other there than here, or nothing."""
    return ", ".join(
        f"{name} {theirs.get(name, NONE)[:30]} in place of {ours[:30]}"
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
    return tree_of(os.path.dirname(kurbel.__file__)) + tree_of(template_folder())


def tree_of(top: str) -> str:
    """Return what tells the files of a folder, and of those in it, from others."""
    found = hashlib.sha256()
    for folder, below, names in os.walk(top):
        below[:] = sorted(name for name in below if name != "__pycache__")
        for name in sorted(names):
            path = os.path.join(folder, name)
            found.update(f"{os.path.relpath(path, top)}\n{content_of(path)}\n".replace(os.sep, "/").encode())
    return found.hexdigest()
