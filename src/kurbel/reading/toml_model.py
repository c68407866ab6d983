"""Models of TOML files: what is amiss in what a file says, in a sentence.

A model is a msgspec Struct, or a dataclass, whose fields have a `Meta` that describes them for editors. A
field may also be of a class with `read`, which makes it of what the file says, and with the SCHEMA of that. A
model may say what its keys are called in NOUN, what it is in SHAPE, and what replaces a key of old in GONE.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from contextlib import suppress
from typing import Any, TypeVar

import msgspec
from msgspec import inspect

from kurbel.errors import KurbelError
from kurbel.reading.foreign import ours
from kurbel.reading.given import choose
from kurbel.reading.toml_file import A_TEXT, Fault, Place, TomlFile, shown

Model = TypeVar("Model")
# What has keys of its own.
KEYED = inspect.StructType | inspect.DataclassType


def read_model(file: TomlFile, model: type[Model]) -> Model:
    """Return what the file says as its model; raise its kind's error for the first thing amiss."""
    for place, said in _faults(file, model):
        raise file.error(place, said)
    return _converted(file, model)


def read_rest(file: TomlFile, model: type[Model]) -> tuple[Model, list[tuple[Place, str]]]:
    """Return the model of all that is right, and what is amiss: the place of each key and the sentence.

    What is amiss is left out of what the file says.
    """
    faults = [*_faults(file, model)]
    for place, _ in faults:
        _leave_out(file.given, place)
    return _converted(file, model), faults


def _faults(file: TomlFile, model: type[Model]) -> Iterator[tuple[Place, str]]:
    if model not in _SHAPES:
        _SHAPES[model] = inspect.type_info(model)
    return _faults_in(file.given, _SHAPES[model], ())


# Of some of them a command reads many files.
_SHAPES: dict[type, inspect.Type] = {}


def _converted(file: TomlFile, model: type[Model]) -> Model:
    try:
        return msgspec.convert(file.given, model, dec_hook=_made)
    except (msgspec.ValidationError, KurbelError) as error:
        raise file.kind.error(f"{file.path}: {error}") from None


def _leave_out(given: Any, place: Place) -> None:
    """Remove a key or, of an entry of a list, the whole list: the others keep their numbers and lines."""
    last = max(index for index, key in enumerate(place) if isinstance(key, str))
    # What it lies in may be left out already.
    with suppress(KeyError):
        for key in place[:last]:
            given = given[key]
        del given[place[last]]


def _faults_in(given: object, shape: inspect.Type, place: Place) -> Iterator[tuple[Place, str]]:
    """Yield where something is amiss, in the order of the file, and the sentence about it."""
    match shape:
        case inspect.Metadata():
            yield from _faults_in(given, shape.type, place)
        case inspect.UnionType():
            yield from _faults_in(given, left(shape), place)
        case inspect.StructType() | inspect.DataclassType() if isinstance(given, dict):
            yield from _of_keys(given, shape, place)
        case inspect.DictType() if isinstance(given, dict):
            for key, value in given.items():
                yield from _faults_in(value, shape.value_type, (*place, key))
        case inspect.VarTupleType() if isinstance(given, list) and len(given) >= (shape.min_length or 0):
            for index, value in enumerate(given):
                yield from _faults_in(value, shape.item_type, (*place, index))
        case inspect.CustomType():
            try:
                _made(shape.cls, given, name := _name(place))
            except Fault as fault:
                yield place, f"{name} is {shown(given)}; it must be {fault}"
            except KurbelError as error:
                yield place, str(error)
        case _:
            if wanted := _wanted(given, shape, place):
                yield place, f"{_name(place)} is {shown(given)}; {wanted}"


def _of_keys(given: Mapping[str, object], shape: KEYED, place: Place) -> Iterator[tuple[Place, str]]:
    fields = {field.encode_name: field for field in shape.fields}
    for key, value in given.items():
        if gone := getattr(shape.cls, "GONE", {}).get(key):
            yield (*place, key), gone
            continue
        try:
            choose(key, fields, getattr(shape.cls, "NOUN", f"entry of [{_dotted(place)}],"))
        except KurbelError as error:
            name, written = ours(key, str(value), [one.replace("_", "-") for one in fields])
            line = f"write {name.replace('-', '_')} = {json.dumps(written, ensure_ascii=False)}"
            said = str(error)
            yield (
                (*place, key),
                f"{said.partition(' (did')[0].partition('; ')[0]}; {line}" if name else said,
            )
        else:
            yield from _faults_in(value, fields[key].type, (*place, key))
    for key, field in fields.items():
        if field.required and key not in given:
            yield place, f"there is no {key}; write {key} = {_example(field.type)}"


def _name(place: Place) -> str:
    """Return what a value is called: by its key, and by its number in a list."""
    keys = [key for key in place if isinstance(key, str)]
    return f"entry {place[-1] + 1} of {keys[-1]}" if isinstance(place[-1], int) else keys[-1]


def left(shape: inspect.UnionType) -> inspect.Type:
    """Return what a value may be that may be left out; TOML has no null."""
    (left,) = (one for one in shape.types if not isinstance(one, inspect.NoneType))
    return left


def _made(kind: Any, value: object, name: str = "") -> object:
    return kind.read(value, name)


def _example(shape: inspect.Type) -> str:
    """Return the first example that a field gives of its value, as TOML."""
    schema = getattr(shape, "extra_json_schema", None) or {}
    return json.dumps(schema["examples"][0], ensure_ascii=False)


def _wanted(given: object, shape: inspect.Type, place: Place) -> str:
    """Return what a value must be that is not of the type; nothing for one that is."""
    match shape:
        case inspect.StrType() if not isinstance(given, str):
            return f"it must be {A_TEXT}"
        case inspect.BoolType() if not isinstance(given, bool):
            return "it must be true or false"
        case inspect.IntType(ge=int(least), le=int(most)) if (
            type(given) is not int or not least <= given <= most
        ):
            return f"it must be a whole number from {least} to {most}"
        case inspect.StructType() | inspect.DataclassType():
            return f"it must be {getattr(shape.cls, 'SHAPE', f'a section, [{_dotted(place)}]')}"
        case inspect.DictType():
            return f"write [{_dotted(place)}]"
        case inspect.VarTupleType(
            item_type=inspect.StructType()
            | inspect.DataclassType()
            | inspect.Metadata(type=inspect.StructType())
        ):
            return f"write [[{_dotted(place)}]]"
        case inspect.VarTupleType():
            return "it must be a list of texts"
    return ""


def _dotted(place: Place) -> str:
    return ".".join(key for key in place if isinstance(key, str))
