"""--machine: defaults of a command's options from a file."""

from __future__ import annotations

from typing import Any

import click

from kurbel.cli.options import FileName, Option
from kurbel.errors import MachineError
from kurbel.reading.given import File

# Where a context keeps the name of the file.
MACHINE = "kurbel.drive.machine"


def machine_option() -> click.Option:
    """Return --machine, which gives defaults to those options that the command has."""
    return Option(
        ["--machine"], metavar="FILE", type=FileName(), is_eager=True, expose_value=False, callback=_load,
        help="Machine in a TOML file: [crank], [steam], [masses], [flywheel]; what is typed outdoes it.",
    )  # fmt: skip


def _load(context: click.Context, parameter: click.Parameter, file: File | None) -> None:
    if file is not None:
        context.default_map = {**(context.default_map or {}), **machine_defaults(context.command, file)}
        context.meta[MACHINE] = str(file)


def machine_defaults(command: click.Command, file: File) -> dict[str, Any]:
    """Return what the file says of the options of the command, by their names."""
    from kurbel.drive.machine import read_machine, with_ratio

    names = {one.name for one in command.params}
    machine = read_machine(file)
    if "rod" not in names:
        machine = with_ratio(machine)
    if machine.get("offset") and "offset" not in names:
        raise MachineError(
            f"{file}: crank.offset is {machine['offset']}, and kurbel {command.name} is about the"
            " straight crank; leave the offset out of the machine"
        )
    return {name: value for name, value in machine.items() if name in names}
