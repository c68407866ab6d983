"""--machine: defaults of a command's options from a file."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

Command = TypeVar("Command", bound=Callable[..., Any])


def machine_option(command: Command) -> Command:
    """Add --machine, which gives defaults to those options that the command has."""
    return click.option(
        "--machine", metavar="FILE", type=click.Path(), is_eager=True, expose_value=False, callback=_load,
        help="Machine in a TOML file: [crank], [steam], [masses], [flywheel]; what is typed outdoes it.",
    )(command)  # fmt: skip


def _load(context: click.Context, parameter: click.Parameter, path: str | None) -> None:
    if path is None:
        return
    from kurbel.machine import read_machine

    names = {one.name for one in context.command.params}
    given = {name: value for name, value in read_machine(path).items() if name in names}
    context.default_map = {**(context.default_map or {}), **given}
