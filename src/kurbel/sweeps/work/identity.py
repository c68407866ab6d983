"""What the bytes of a sweep depend on: what was asked for, this kurbel, and the libraries below it."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from kurbel.commands.options import FILE
from kurbel.reading.given import File
from kurbel.sweeps.plan import Axis, Plan
from kurbel.sweeps.rows import Sweep
from kurbel.sweeps.work.versions import content_of, makers

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

    def absolute(value: Any) -> File:
        if isinstance(value, File):
            return File(value.name, os.path.abspath(value.folder), value.inside)
        return File(os.fspath(value), os.getcwd())

    return _with_files(plan, absolute)


def _with_files(plan: Plan, file: Callable[[Any], Any]) -> Plan:
    """Return the plan with what `file` makes of each file that its options name."""
    kinds = {one.name: one.kind for one in plan.asking.parameters.values()}

    def named(name: str, value: Any) -> Any:
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
