"""The file of a sweep, sweep.toml: its keys, how it is read, and its options as the command line has them."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import click
from msgspec import Struct

from kurbel.cli.options import FileName
from kurbel.cli.sweep import MOST_SEED, TABLES
from kurbel.commands.options import FILE as A_FILE
from kurbel.commands.options import FLAG, Option
from kurbel.errors import FailedError, KurbelError
from kurbel.exact.numerals import MOST_DIGITS
from kurbel.reading.given import choose
from kurbel.reading.toml_file import Choice, Fault, TomlFile, TomlKind, about, within
from kurbel.sweeps.asked import values_of

if TYPE_CHECKING:
    from kurbel.cli.sweep_command import SweepCommand

KIND = TomlKind(
    "sweep",
    FailedError,
    10**7,
    'a sweep has command = "delta", its [axes], [options] and an output',
    "sweep.toml",
)
SECTIONS = ("axes", "options")
VALUE: Mapping[str, object] = {"type": ["string", "number", "boolean"]}


class Command(Choice, what="command that can be swept", allowed=TABLES):
    """A command by its name."""


class Given(tuple[object, ...]):
    """One value or several: texts as they would be typed, numbers, or true and false."""

    SCHEMA: ClassVar[Mapping[str, object]] = {
        "anyOf": [VALUE, {"type": "array", "items": VALUE, "minItems": 1}]
    }

    @classmethod
    def read(cls, given: object, _: str) -> Given:
        values = given if isinstance(given, list) else [given]
        if not values or not all(isinstance(one, str | int | float) for one in values):
            raise Fault('a text such as "1..10:0.5", a number, true or false, or a list of them')
        return cls(one if isinstance(one, bool) else str(one) for one in values)


class SweepFile(Struct, frozen=True):
    """A sweep: a command, what is the same everywhere, what varies, and where its rows go."""

    NOUN: ClassVar[str] = "key of a sweep"

    command: Annotated[Command, about("The command that is computed.", "delta")]
    output: Annotated[
        str | None, about("The file that is written, beside this one: its suffix says the form.")
    ] = None
    format: Annotated[str | None, about("The form of the file, where its suffix does not say it.")] = None
    axes: Annotated[
        dict[str, Given] | None,
        about("What varies, in this order, the last fastest: options with a range, or a list of values."),
    ] = None
    options: Annotated[
        dict[str, Given] | None, about("Options of the command that are the same everywhere.")
    ] = None
    columns: Annotated[tuple[str, ...], about("The columns, as in `kurbel quantities`.")] = ()
    zip: Annotated[
        tuple[str, ...], about('Axes that go through their values together: "eps,back", a text a group.')
    ] = ()
    only: Annotated[
        tuple[str, ...], about("Conditions: combinations at which one does not hold are left out.")
    ] = ()
    sample: Annotated[
        str | None, about("Points between the ends of ranges in place of a grid.", "sobol:1024")
    ] = None
    seed: Annotated[int, about("Of the sample: other points for another number."), within(0, MOST_SEED)] = 0
    digits: Annotated[
        Annotated[int, within(0, MOST_DIGITS)] | None, about("Certified decimals in place of floats.")
    ] = None
    bounds: Annotated[bool, about("Whether each float has a column that says how far it may be off.")] = False
    strict: Annotated[bool, about("Whether the first combination that is refused ends the run.")] = False


class ReadFile:
    """A sweep's file that was read."""

    def __init__(self, path: str) -> None:
        self.file = TomlFile(path, KIND)
        self.declared = self.file.read(SweepFile)
        self.folder = os.path.dirname(path)

    def beside(self, name: str) -> str:
        """Return the name of a file, which counts from where this one lies."""
        return os.path.join(self.folder, name)

    def values(self, known: Mapping[str, Option[object]]) -> dict[str, Given]:
        """Return the options by their names, the axes first, in the order of the file.

        Raises FailedError for one that the command does not have, or a value that cannot be read.
        """
        found: dict[str, Given] = {}
        for section in SECTIONS:
            for key, given in (getattr(self.declared, section) or {}).items():
                name = key.replace("-", "_")
                try:
                    choose(name, known, f"option of kurbel {self.declared.command}")
                    if len(given) > 1 and section == "options" and not known[name].many:
                        raise FailedError(f"{key} has several values; put it under [axes]")
                    if not isinstance(given[0], bool):
                        values_of(known[name], given)
                except KurbelError as error:
                    raise self.file.error((section, key), error) from None
                found.setdefault(name, given)
        return found


SUFFIX = ".toml"
# Where a context keeps the options of the file in their order, with the values of flags that vary, which no
# word says.
FILE = "kurbel.cli.sweep.file"
MACHINE: Option[object] = Option("Machine in a TOML file.", "FILE", A_FILE)


def words_of(
    read: ReadFile, command: SweepCommand, typed: Sequence[str]
) -> tuple[list[str], dict[str, tuple[bool, ...]]]:
    """Return the words of the file and what is typed; and the options of the file in their order, with the
    values of flags that vary. Raises KurbelError."""
    context = click.Context(command, info_name=command.name, resilient_parsing=True)
    *_, order = command.make_parser(context).parse_args(args=[*typed])
    outdone = {one.name for one in order}
    options = {one.name: one for one in command.params if isinstance(one, click.Option)}
    own = command.asking.options
    machine = {"machine": MACHINE} if "machine" in options else {}
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
    """Yield what the file says of the sweep itself by the names of the options, each as a list of values."""
    said = {
        name: getattr(read.declared, name) for name in SweepFile.__struct_fields__[1:] if name not in SECTIONS
    }
    said |= {"columns": ",".join(said["columns"]), "seed": said["seed"] if said["sample"] else None}
    said["zip_"] = said.pop("zip")
    for name, value in said.items():
        yield name, value if isinstance(value, tuple) else [] if value in (None, "") else [value]
