"""`kurbel sweep sweep.toml`: what a file says, in the words of the command line; what is typed outdoes it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import click

from kurbel.cli.options import FileName
from kurbel.commands.options import FLAG

if TYPE_CHECKING:
    from kurbel.cli.sweeps.command import SweepCommand
    from kurbel.sweeps.sweep_file import ReadFile

SUFFIX = ".toml"
# Where a context keeps the options of the file in their order, with the values of flags that vary, which no
# word says.
FILE = "kurbel.cli.sweeps.file"


def words_of(
    read: ReadFile, command: SweepCommand, typed: Sequence[str]
) -> tuple[list[str], dict[str, tuple[bool, ...]]]:
    """Return the words of the file and what is typed; and the options of the file in their order, with the
    values of flags that vary. Raises KurbelError."""
    context = click.Context(command, info_name=command.name, resilient_parsing=True)
    *_, order = command.make_parser(context).parse_args(args=[*typed])
    outdone = {one.name for one in order}
    options = {one.name: one for one in command.params if isinstance(one, click.Option)}
    own = {one.name: one for one in command.asking.parameters.values()}
    machine = {"machine": own["ratio"]} if "machine" in options and "ratio" in own else {}
    values = read.values({**own, **machine})
    flags = {
        name: (*map(bool, given),)
        for name, given in values.items()
        if name in own and own[name].kind is FLAG and len(given) > 1 and name not in outdone
    }
    words: list[str] = []
    for name, given in values.items():
        if name not in outdone and name not in flags and name in options:
            words += _words(read, options[name], given)
    for name, said in _of_sweeps(read):
        if name not in outdone:
            words += _words(read, options[name], said)
    return [*words, *typed], {name: flags.get(name, ()) for name in values}


def _words(read: ReadFile, option: click.Option, given: Sequence[Any]) -> Iterator[str]:
    flag = max(option.opts, key=len)
    for one in given:
        if isinstance(one, bool):
            yield from [flag] if one else []
        else:
            named = isinstance(option.type, FileName) or option.name == "output"
            yield f"{flag}={read.beside(one) if named else one}"


def _of_sweeps(read: ReadFile) -> Iterator[tuple[str, Sequence[Any]]]:
    said = read.said
    told: Mapping[str, Sequence[Any]] = {
        "output": [said.output] if said.output else [],
        "format": [said.format] if said.format else [],
        "columns": [",".join(said.columns)] if said.columns else [],
        "zip_": said.zip,
        "only": said.only,
        "sample": [said.sample] if said.sample else [],
        "seed": [str(said.seed)] if said.sample else [],
        "digits": [] if said.digits is None else [str(said.digits)],
        "bounds": [said.bounds],
        "strict": [said.strict],
    }
    yield from told.items()
