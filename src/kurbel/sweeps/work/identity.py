"""What the bytes of a sweep depend on: what was asked for, this kurbel, and the libraries below it."""

from __future__ import annotations

import hashlib
import os
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
