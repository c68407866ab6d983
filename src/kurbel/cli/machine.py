"""--machine: defaults of a command's options from a file."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

from kurbel.errors import MachineError

# Where a context keeps the name of the file.
MACHINE = "kurbel.drive.machine"
Command = TypeVar("Command", bound=Callable[..., Any])


def machine_option(command: Command) -> Command:
    """Add --machine, which gives defaults to those options that the command has."""
    return click.option(
        "--machine", metavar="FILE", type=click.Path(), is_eager=True, expose_value=False, callback=_load,
        help="Machine in a TOML file: [crank], [steam], [masses], [flywheel]; what is typed outdoes it.",
    )(command)  # fmt: skip


def _load(context: click.Context, parameter: click.Parameter, path: str | None) -> None:
    if path is not None:
        context.default_map = {**(context.default_map or {}), **machine_defaults(context.command, path)}
        context.meta[MACHINE] = path


def machine_defaults(command: click.Command, path: str) -> dict[str, Any]:
    """Return what the file says of the options of the command, by their names."""
    from kurbel.drive.machine import read_machine, with_ratio

    names = {one.name for one in command.params}
    machine = read_machine(path)
    if "rod" not in names:
        machine = with_ratio(machine)
    if machine.get("offset") and "offset" not in names:
        raise MachineError(
            f"{path}: crank.offset is {machine['offset']}, and kurbel {command.name} is about the"
            " straight crank; leave the offset out of the machine"
        )
    return {name: value for name, value in machine.items() if name in names}
