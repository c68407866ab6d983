"""What was typed, and what gives way to it: defaults from the environment and from a machine's file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import click
from click.core import ParameterSource

from kurbel.cli.options import FileName, Option
from kurbel.commands.options import is_given
from kurbel.commands.subject import Command
from kurbel.errors import MachineError, ProblemError
from kurbel.reading.given import File, as_length, as_ratios
from kurbel.reading.notation import ratio_text

# An option, and those that outdo it where they are all typed.
Rivals = Sequence[tuple[str, str]]
_ANGLES: Rivals = (
    *(("angle", other) for other in ("from", "to", "step")),
    *((other, "angle") for other in ("from", "to", "step")),
)
_STEAM: Rivals = (
    *((name, "card") for name in ("eps", "back", "exponent", "clearance", "pressure")),
    ("card", "eps"),
)
_ROD: Rivals = (
    *((name, "rod_file") for name in ("rod_mass", "centre", "gyration")),
    *(("rod_file", name) for name in ("centre", "gyration")),
)
RIVALS: Mapping[str, Rivals] = {
    "table": (*_ANGLES, ("mechanism", "layout"), ("layout", "mechanism")),
    # A force that is typed outdoes the steam of a machine.
    "forces": (*_ANGLES, *_STEAM, *_ROD, ("eps", "force"), ("card", "force")),
    "inertia": (*_ANGLES, *_ROD),
    **dict.fromkeys(("delta", "turning", "flywheel", "plot"), (*_STEAM, *_ROD)),
    "balance": (("engine", "cranks"), *((name, "engine") for name in ("cranks", "positions", "banks"))),
}
_LENGTHS = ("ratio", "stroke", "rod")


class Given:
    """The values of a command's options by their names, and where they come from."""

    def __init__(self, context: click.Context) -> None:
        self.values: dict[str, Any] = dict(context.params)
        self.sources = {name: context.get_parameter_source(name) for name in context.params}

    def typed(self, name: str) -> bool:
        """Whether an option stands on the command line; a default from elsewhere gives way."""
        return self.sources.get(name) is ParameterSource.COMMANDLINE

    def drop(self, name: str) -> None:
        """Make an option one that was not given."""
        value = self.values[name]
        self.values[name] = () if isinstance(value, tuple) else False if value is True else None

    def settle(self, rivals: Rivals) -> None:
        """Drop what is outdone by what was typed."""
        for name, other in rivals:
            if not self.typed(name) and self.typed(other):
                self.drop(name)

    def settle_lengths(self) -> None:
        """Keep two of crank ratio, stroke and length of the rod at the most, for two give the third.

        Raises ProblemError where what is left says two different things.
        """
        if self.typed("ratio") and self.sources["rod"] is ParameterSource.ENVIRONMENT:
            self.drop("rod")
        if not all(is_given(self.values[name]) for name in _LENGTHS):
            return
        if not self.typed("ratio"):
            if not (self.typed("stroke") or self.typed("rod")):
                self._check_agreement()
            self.drop("ratio")
        elif self.typed("stroke") != self.typed("rod"):
            self.drop("rod" if self.typed("stroke") else "stroke")
        elif not self.typed("rod"):
            raise ProblemError(
                "stroke and rod are known and give the ratio; beside --ratio give the stroke or the rod"
                " as well"
            )

    def _check_agreement(self) -> None:
        ratio, stroke, rod = (self.values[name] for name in _LENGTHS)
        share = as_length(stroke, "stroke") / 2 / as_length(rod, "rod")
        if set(as_ratios(ratio)) != {share}:
            raise ProblemError(
                f"stroke {stroke} and rod {rod} give R:L = {ratio_text(share)},"
                f" and the ratio is {';'.join(ratio)}; leave one of the three out"
            )


def resolved(command: Command, given: Given, rivals: Rivals = ()) -> dict[str, Any]:
    """Return the values as the command's function takes them, by its parameters' names.

    Raises ProblemError for what was typed in vain.
    """
    given.settle(rivals)
    own = {one.name for one in command.parameters.values()}
    values = {name: value for name, value in given.values.items() if name in own}
    command.refuse(values, given.typed)
    for name in command.foreign(values):
        given.drop(name)
    if own.issuperset(_LENGTHS):
        given.settle_lengths()
    # What may be repeated and was not given is an empty tuple for click.
    return {
        key: one.default if (value := given.values[one.name]) == () else value
        for key, one in command.parameters.items()
    }


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
