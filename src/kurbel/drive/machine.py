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

Each entry is the option of the same meaning, written as on the command line; what is typed there outdoes it.
Which sections and entries there are stands in sections.py.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from msgspec.structs import asdict

from kurbel.drive.sections import LOADS, SECTIONS, File, Files, Joined, Machine, One, Section, Several
from kurbel.errors import KurbelError, MachineError
from kurbel.reading.given import File as NamedFile
from kurbel.reading.toml_file import Place, TomlFile, TomlKind

KIND = TomlKind(
    "machine",
    MachineError,
    20_000,
    "a machine has sections with entries",
    "--machine engine.toml",
)


# Entries that are nothing without a unit, by one that it may have.
UNITS = {
    name: unit
    for unit, names in {
        "mm": "stroke crank true_stroke rod bore piston_rod tail_rod radius rim_diameter rim_breadth"
        " rim_thickness disc_diameter disc_thickness",
        "/min": "speed",
        "bar": "pressure suction_pressure delivery_pressure",
        "kg": "reciprocating rod_mass rotating mass",
        "N": "friction",
        "kW": "power",
        "s": "pendulum",
        "kgm²": "inertia rocker_inertia",
        "kg/m³": "density",
        "m³/kg": "specific_volume",
        "MPa": "hoop_stress",
    }.items()
    for name in names.split()
}


class Listed(dict[str, Any]):
    """The entries of a cylinder by their names, and where its table stands, for the start of a sentence."""

    def __init__(self, entries: Mapping[str, Any], where: str) -> None:
        super().__init__(entries)
        self.where = where


def read_machine(path: str | NamedFile) -> dict[str, Any]:
    """Return the options that the file gives, by their names: text or a file, several of them, or whether.

    Raises MachineError with the file's name for anything that is no machine.
    """
    file = TomlFile(path, KIND)
    for key, value in file.given.items():
        homes = [home for home, own in SECTIONS.items() if key in own.__struct_encode_fields__]
        if key not in SECTIONS and homes and not isinstance(value, dict):
            raise file.error((key,), f"{key} stands outside of the sections; write it under [{homes[0]}]")
    machine = file.read(Machine)
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
    options = _sized(_options(own, given), str(file.path))
    if machine.cylinder is not None:
        if not machine.cylinder:
            raise file.error(
                ("cylinder",), "cylinder is empty; write a [[cylinder]] for each, or leave it out"
            )
        options["cylinder"] = [
            Listed(_sized(_options(own, asdict(one)), where), where)
            for number, one in enumerate(machine.cylinder)
            for where in [f"{file.path}, line {file.line(('cylinder', number))}"]
        ]
    return options


def _check_units(file: TomlFile, home: Place, section: Section | None) -> None:
    """Raise MachineError with file, line and key for a number where a measure is wanted."""
    if section is None:
        return
    for name, key in zip(section.__struct_fields__, section.__struct_encode_fields__, strict=True):
        (value,) = getattr(section, name) or ("",) if name in UNITS else ("",)
        if re.fullmatch(r"[+−-]?[\d.,]*\d[\d.,]*", value):
            said = f'{key} is {value}, without a unit; write {key} = "{value}{UNITS[name]}"'
            raise file.error((*home, key), said)


def _sized(options: dict[str, Any], where: str) -> dict[str, Any]:
    """Return the options with the stroke, which a crank radius gives, too."""
    if "crank" not in options:
        return options
    from kurbel.drive.size import in_strokes

    try:
        return in_strokes(options)
    except KurbelError as error:
        raise MachineError(f"{where}: {error}") from None


def _options(machine: NamedFile, given: Mapping[str, Any]) -> dict[str, Any]:
    return {name: _option(machine, value) for name, value in given.items() if value is not None}


def _option(machine: NamedFile, value: Any) -> Any:
    """Return a value as its option takes it; files beside the machine's."""
    if isinstance(value, File | Files):
        beside = [machine.beside(name) for name in value]
        return beside if isinstance(value, Files) else beside[0]
    if not isinstance(value, Several):
        return value
    return ";".join(value) if isinstance(value, One | Joined) else [*value]


def with_ratio(options: Mapping[str, Any]) -> dict[str, Any]:
    """Return the options with the ratio that stroke and rod give, for a command that takes neither."""
    if "ratio" in options or not {"stroke", "rod"} <= set(options):
        return dict(options)
    from kurbel.reading.units import length

    share = length(options["stroke"], "stroke") / 2 / length(options["rod"], "rod")
    return {**options, "ratio": [f"{share.numerator}:{share.denominator}"]}
