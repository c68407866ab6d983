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

Each entry is the option of the same meaning, written as on the command line; what is typed there outdoes it.
`schema` describes the file for editors (JSON Schema, draft 2020-12).
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, NamedTuple

from kurbel.errors import ChoiceError, MachineError
from kurbel.reading.choices import choose
from kurbel.reading.toml_file import TomlKind, read_toml, shown

KIND = TomlKind(
    "machine", MachineError, 20_000, "a machine has sections with entries", "--machine engine.toml"
)


class Entry(NamedTuple):
    """An entry of the file: the option that it stands for, what it is, whether it may be a list, and whether
    the option is repeated for one."""

    option: str
    about: str
    many: bool = False
    several: bool = False
    flag: bool = False
    file: bool = False


SECTIONS: Mapping[str, Mapping[str, Entry]] = {
    "crank": {
        "ratio": Entry("ratio", 'crank ratio R:L, such as "1:5"', many=True, several=True),
        "stroke": Entry("stroke", 'stroke 2R, such as "600mm"'),
        "rod": Entry("rod", 'length of the rod, such as "1500mm"'),
        "speed": Entry("speed", 'speed, such as "120/min"'),
        "offset": Entry("offset", "offset e as a share of R, or a length"),
        "angles": Entry("cranks", "angles in degrees by which several cranks follow the first", many=True),
    },
    "steam": {
        "eps": Entry("eps", "expansion ratio ε", many=True, several=True),
        "back": Entry("back", "back pressure as a share of the steam pressure"),
        "exponent": Entry("exponent", "n of p Vⁿ = const."),
        "clearance": Entry("clearance", "clearance as a share of the swept volume"),
        "pressure": Entry("pressure", 'steam pressure before cut-off, such as "8bar"'),
        "bore": Entry("bore", 'bore of the cylinder, such as "300mm"'),
        "single_acting": Entry("single_acting", "whether steam works on the outstroke only", flag=True),
        "card": Entry(
            "card", "indicator card, a CSV file beside this one", many=True, several=True, file=True
        ),
        "other_side": Entry("other_side", "pressure on the other face of a single-acting piston"),
    },
    "masses": {
        "reciprocating": Entry("reciprocating", 'mass of piston and crosshead, such as "300kg"'),
        "rod": Entry("rod_mass", 'mass of the connecting rod, such as "150kg"'),
        "centre": Entry("centre", "its centre of mass from the crosshead pin, in rod lengths or a length"),
        "gyration": Entry("gyration", "its radius of gyration about that, in rod lengths or a length"),
        "rotating": Entry("rotating", "mass of the crank itself at its pin, less counterweights"),
        "file": Entry("rod_file", "its masses, a CSV file beside this one", file=True),
    },
    "flywheel": {
        "power": Entry("power", 'power, such as "50kW"'),
        "delta": Entry("delta", 'degree of irregularity to keep, such as "1:100"', many=True, several=True),
        "radius": Entry("radius", "radius at which the mass of the rim is wanted"),
    },
}


def read_machine(path: str) -> dict[str, Any]:
    """Return the options that the file gives, by their names: text, a list of texts, or True.

    Raises MachineError with the file's name for anything that is no machine.
    """
    given = read_toml(path, KIND)
    options: dict[str, Any] = {}
    for section, entries in given.items():
        _check_section(path, section, entries)
        for key, value in entries.items():
            entry = SECTIONS[section][choose_in(path, key, SECTIONS[section], f"entry of [{section}],")]
            options[entry.option] = _option(path, f"{section}.{key}", entry, value)
    return options


def with_ratio(options: Mapping[str, Any]) -> dict[str, Any]:
    """Return the options with the ratio that stroke and rod give, for a command that takes neither."""
    if "ratio" in options or not {"stroke", "rod"} <= set(options):
        return dict(options)
    from kurbel.reading.units import length

    share = length(options["stroke"], "stroke") / 2 / length(options["rod"], "rod")
    return {**options, "ratio": [f"{share.numerator}:{share.denominator}"]}


def _check_section(path: str, section: str, entries: Any) -> None:
    homes = [home for home, own in SECTIONS.items() if section in own]
    if section not in SECTIONS and homes and not isinstance(entries, dict):
        raise MachineError(f"{path}: {section} stands outside of the sections; write it under [{homes[0]}]")
    choose_in(path, section, SECTIONS, "section")
    if not isinstance(entries, dict):
        raise MachineError(f"{path}: {section} is {shown(entries)}; it must be a section, [{section}]")


def choose_in(path: str, name: str, allowed: Mapping[str, Any], what: str) -> str:
    """Return the name if it is allowed, else raise with the file, the nearest name and the list."""
    try:
        return choose(name, allowed, what)
    except ChoiceError as error:
        raise MachineError(f"{path}: {error}") from None


def _option(path: str, name: str, entry: Entry, value: Any) -> Any:
    if entry.flag:
        if not isinstance(value, bool):
            raise MachineError(f"{path}: {name} is {shown(value)}; it must be true or false")
        return value
    values = value if isinstance(value, list) else [value]
    if not values or any(isinstance(one, bool) or not isinstance(one, (str, int, float)) for one in values):
        allowed = 'text such as "600mm", a number' + (" or a list" if entry.many else "")
        raise MachineError(f"{path}: {name} is {shown(value)}; it must be {allowed}")
    if len(values) > 1 and not entry.many:
        raise MachineError(f"{path}: {name} is a list; it must be one value")
    texts = [str(one) for one in values]
    if entry.file:
        texts = [os.path.join(os.path.dirname(path), text) for text in texts]
    return texts if entry.several else ";".join(texts)


def schema() -> dict[str, Any]:
    """Return the JSON Schema of the file."""
    one = {"type": ["string", "number"]}
    several = {"anyOf": [one, {"type": "array", "items": one, "minItems": 1}]}

    def described(entry: Entry) -> dict[str, Any]:
        kind: dict[str, Any] = {"type": "boolean"} if entry.flag else several if entry.many else one
        return {"description": entry.about, **kind}

    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "A machine for kurbel",
        "type": "object",
        "additionalProperties": False,
        "properties": {
            section: {
                "type": "object",
                "additionalProperties": False,
                "properties": {key: described(entry) for key, entry in entries.items()},
            }
            for section, entries in SECTIONS.items()
        },
    }
