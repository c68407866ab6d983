"""What a machine's file says of the options of a command."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from kurbel.errors import MachineError
from kurbel.reading.given import File

# What those commands are about that a list of unlike cylinders says nothing to.
_ALIKE = {"pressures": "one", "construct": "one", "power": "cylinders alike", "balance": "cylinders alike"}


def machine_defaults(command: str, options: Mapping[str, bool], file: File) -> dict[str, Any]:
    """Return what the file says of the options of the command, by their names, with whether each may be
    repeated."""
    from kurbel.drive.machine import read_machine, with_ratio

    machine = read_machine(file)
    if "rod" not in options:
        machine = with_ratio(machine)
    for name in ("offset", "mechanism"):
        if machine.get(name, "straight") != "straight" and name not in options:
            raise MachineError(
                f"{file}: crank.{name} is {machine[name]}, and kurbel {command} is about the"
                f" straight crank; leave the {name} out of the machine"
            )
    if machine.get("cylinder") and "cylinder" not in options and (alike := _ALIKE.get(command)):
        raise MachineError(
            f"{file}: the machine has a list of cylinders, and kurbel {command} is about {alike}; take"
            " the list out, and write what one of them has into the sections, as bore into [steam] and"
            " reciprocating into [masses]"
        )
    # What may be repeated is a list, though the machine has one of it.
    return {
        name: [value] if options[name] and isinstance(value, str) else value
        for name, value in machine.items()
        if name in options
    }
