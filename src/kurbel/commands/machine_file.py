"""A machine written once, in a TOML file, for every command: crank, steam, masses, flywheel.

    [crank]
    ratio = "1:5"
    stroke = "600mm"
    speed = "120/min"

    [steam]
    eps = 4
    bore = "300mm"
    pressure = "8bar"

    [masses]
    reciprocating = "300kg"

An engine of unlike cylinders has a [[cylinder]] for each, with what is its own: `angle`, `bank`, `bore`,
`eps` and so on, as the options are called; the sections say what all have.

Each key is an option, written as on the command line; what is typed there outdoes it. In which sections it
stands, its declaration says.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from types import GenericAlias
from typing import Annotated, Any, ClassVar

from msgspec import Struct, defstruct
from msgspec.structs import asdict

from kurbel.commands import parts
from kurbel.commands.options import FILE, FLAG, LOADS, SECTIONS, Option
from kurbel.commands.part import Part
from kurbel.errors import MachineError
from kurbel.reading.given import File as NamedFile
from kurbel.reading.given import as_length
from kurbel.reading.toml_file import MOST_BITS, Fault, Place, TomlFile, TomlKind, about

KIND = TomlKind(
    "machine", MachineError, 20_000, "a machine has sections with entries", "--machine engine.toml"
)
# Of options that are nothing without a unit, by that of bare numbers, one that they may have.
UNITS = {
    "m": "mm", "turns a second": "/min", "Pa": "bar", "kg": "kg", "N": "N", "W": "kW", "s": "s",
    "kg m²": "kgm²", "m³/kg": "m³/kg",
}  # fmt: skip
ONE: Mapping[str, object] = {"type": ["string", "number"]}


class ValueList(tuple[str, ...]):
    """One value or several, as they would be typed."""

    MUST = 'text such as "600mm", a number or a list'
    SCHEMA: ClassVar[Mapping[str, object]] = {"anyOf": [ONE, {"type": "array", "items": ONE, "minItems": 1}]}

    @classmethod
    def read(cls, given: object, _: str) -> ValueList:
        values = given if isinstance(given, list) else [given]
        if not values or not all(map(_is_value, values)):
            raise Fault(cls.MUST)
        if len(values) > 1 and issubclass(cls, SingleValue):
            raise Fault("one value")
        return cls(map(str, values))


class SingleValue(ValueList):
    """One value."""

    MUST = 'text such as "600mm", a number'
    SCHEMA = ONE


class JoinedValues(ValueList):
    """Several values, which their option takes in one text."""


class Files(ValueList):
    """Files beside the machine's."""

    @classmethod
    def read(cls, given: object, name: str) -> ValueList:
        found = super().read(given, name)
        if any("\0" in one for one in found):
            raise Fault("the name of a file, and none has a NUL in it")
        return found


class File(Files, SingleValue):
    """One of them."""


def _is_value(given: object) -> bool:
    if isinstance(given, bool) or not isinstance(given, str | int | float):
        return False
    return not isinstance(given, int) or given.bit_length() < MOST_BITS


class Section(Struct, forbid_unknown_fields=True):
    """A section of the file; an entry that is left out is None."""


@cache
def machine_keys() -> Mapping[str, Mapping[str, Option[object]]]:
    """Return the sections of the file with their keys, each the option that its part declares so."""
    found: dict[str, dict[str, Option[object]]] = {section: {} for section in SECTIONS}
    for module in iter_modules(parts.__path__, f"{parts.__name__}."):
        for part in vars(import_module(module.name)).values():
            if isinstance(part, type) and issubclass(part, Part):
                for option in part.options().values():
                    for place in option.machine.split():
                        section, _, key = place.partition(".")
                        found[section].setdefault(key or option.name, option)
    return found


@cache
def machine_model() -> type[Any]:
    """Return the model of the file."""
    from kurbel.commands.parts.engine import PLACE, Cylinder

    fields: list[tuple[str, object, object]] = [
        (name, _section(name.title(), keys) | None, None) for name, keys in machine_keys().items()
    ]
    cylinder = GenericAlias(tuple, (_section("Cylinder", Cylinder.entries(), PLACE), ...))
    fields.append(("cylinder", cylinder | None, None))
    return defstruct("Machine", fields, bases=(Section,), namespace={"NOUN": "section"}, module=__name__)


def _section(
    name: str, options: Mapping[str, Option[object]], places: Mapping[str, str] | None = None
) -> type[Struct]:
    """Return a section by its keys and the options behind them; of a cylinder also what sets its place."""
    keys = {option.name: key for key, option in options.items()}
    fields: list[tuple[str, object, object]] = [
        (place, _described(SingleValue, text), None) for place, text in (places or {}).items()
    ]
    for option in options.values():
        # [pump] by itself says which one; of a cylinder it is one of several loads.
        usual = SingleValue((option.bare,)) if option.bare and places is None else None
        fields.append((option.name, _described(_kind(option), _help(option, keys)), usual))
    return defstruct(name, fields, bases=(Section,), rename=keys, module=__name__)


def _described(kind: type, text: str) -> object:
    return Annotated[kind | None, about(text)]


def _kind(option: Option[object]) -> type:
    """Return what stands in the file for an option."""
    if option.kind is FLAG:
        return bool
    if option.kind is FILE:
        return Files if option.many else File
    # A list whose numbers have a unit; another text has parts of its own, as a section of a rim.
    joined = option.whole and option.unit
    return ValueList if option.many else JoinedValues if joined else SingleValue


def _help(option: Option[object], keys: Mapping[str, str]) -> str:
    """Return what the file says of an option, for editors: other options by their keys."""

    def key(flag: re.Match[str]) -> str:
        name = flag[1].replace("-", "_")
        return keys.get(name, name)

    text = re.sub(r"--([a-z-]+)", key, option.help)
    return f"{text} Its path counts from this file's folder." if option.kind is FILE else text


class CylinderEntries(dict[str, object]):
    """The entries of a cylinder by their names, and where its table stands, for the start of a sentence."""

    def __init__(self, entries: Mapping[str, object], where: str) -> None:
        super().__init__(entries)
        self.where = where


def read_machine(path: str | NamedFile) -> dict[str, object]:
    """Return the options that the file gives, by their names: text or a file, several of them, or whether.

    Raises MachineError with the file's name for anything that is no machine.
    """
    file = TomlFile(path, KIND)
    for key, value in file.given.items():
        homes = [home for home, own in machine_keys().items() if key in own]
        if key not in SECTIONS and homes and not isinstance(value, dict):
            raise file.error((key,), f"{key} stands outside of the sections; write it under [{homes[0]}]")
    machine = file.read(machine_model())
    for home in SECTIONS:
        _check_units(file, (home,), getattr(machine, home))
    for number, one in enumerate(machine.cylinder or ()):
        _check_units(file, ("cylinder", number), one)
    loads = [name for name in LOADS if getattr(machine, name) is not None]
    if len(loads) > 1:
        raise file.error(
            (loads[1],), f"[{loads[0]}] and [{loads[1]}] are two loads of one piston; leave one out"
        )
    sections = (getattr(machine, name) for name in SECTIONS)
    given = {name: value for one in sections if one for name, value in asdict(one).items()}
    own = path if isinstance(path, NamedFile) else NamedFile(path)
    options = _options(own, given)
    if machine.cylinder is not None:
        if not machine.cylinder:
            raise file.error(
                ("cylinder",), "cylinder is empty; write a [[cylinder]] for each, or leave it out"
            )
        options["cylinder"] = [
            CylinderEntries(_options(own, asdict(one)), where)
            for number, one in enumerate(machine.cylinder)
            for where in [f"{file.path}, line {file.line(('cylinder', number))}"]
        ]
    return options


def _check_units(file: TomlFile, home: Place, section: Section | None) -> None:
    """Raise MachineError with file, line and key for a number where a measure is wanted."""
    if section is None:
        return
    declared = {one.name: one for keys in machine_keys().values() for one in keys.values()}
    for name, key in zip(section.__struct_fields__, section.__struct_encode_fields__, strict=True):
        option, values = declared.get(name), getattr(section, name)
        unit = option and (option.usual or UNITS.get(option.unit))
        if unit and values and re.fullmatch(r"[+−-]?[\d.,]*\d[\d.,]*", values[0]):
            said = f'{key} is {values[0]}, without a unit; write {key} = "{values[0]}{unit}"'
            raise file.error((*home, key), said)


def _options(machine: NamedFile, given: Mapping[str, object]) -> dict[str, object]:
    return {name: _option(machine, value) for name, value in given.items() if value is not None}


def _option(machine: NamedFile, value: object) -> object:
    """Return a value as its option takes it; files beside the machine's."""
    if isinstance(value, Files):
        beside = [machine.beside(name) for name in value]
        return beside[0] if isinstance(value, File) else beside
    if not isinstance(value, ValueList):
        return value
    return ";".join(value) if isinstance(value, SingleValue | JoinedValues) else [*value]


def with_ratio(options: Mapping[str, object]) -> dict[str, object]:
    """Return the options with the ratio that stroke and rod give, for a command that takes neither."""
    if "ratio" in options or not {"stroke", "rod"} <= set(options):
        return dict(options)
    share = as_length(options["stroke"], "stroke") / 2 / as_length(options["rod"], "rod")
    return {**options, "ratio": [f"{share.numerator}:{share.denominator}"]}
