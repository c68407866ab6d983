"""What a machine's file says of the options of a command."""

from __future__ import annotations

from typing import Any

import click

from kurbel.errors import MachineError
from kurbel.reading.given import File

# What those commands are about that a list of unlike cylinders says nothing to.
_ALIKE = {"pressures": "one", "construct": "one", "power": "cylinders alike", "balance": "cylinders alike"}


def machine_defaults(command: click.Command, file: File) -> dict[str, Any]:
    """Return what the file says of the options of the command, by their names."""
    from kurbel.drive.machine import read_machine, with_ratio

    names = {one.name for one in command.params}
    machine = read_machine(file)
    if "rod" not in names:
        machine = with_ratio(machine)
    for name in ("offset", "mechanism"):
        if machine.get(name, "straight") != "straight" and name not in names:
            raise MachineError(
                f"{file}: crank.{name} is {machine[name]}, and kurbel {command.name} is about the"
                f" straight crank; leave the {name} out of the machine"
            )
    if machine.get("cylinder") and "cylinder" not in names and (alike := _ALIKE.get(command.name or "")):
        raise MachineError(
            f"{file}: the machine has a list of cylinders, and kurbel {command.name} is about {alike}; take"
            " the list out, and write what one of them has into the sections, as bore into [steam] and"
            " reciprocating into [masses]"
        )
    # What may be repeated is a list, though the machine has one of it.
    lists = {one.name for one in command.params if one.multiple}
    return {
        name: [value] if name in lists and isinstance(value, str) else value
        for name, value in machine.items()
        if name in names
    }
