"""TOML files that users write: read whole into one model, with a sentence for what is amiss.

A model is a msgspec Struct, or a dataclass, whose fields have a `Meta` that describes them for editors. A
field may also be of a class with `read`, which makes it of what the file says, and with the SCHEMA of that. A
model may say what its keys are called in NOUN, and what it is in SHAPE.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple, Self, TypeVar

from kurbel.errors import KurbelError
from kurbel.reading.given import choose

if TYPE_CHECKING:
    from msgspec import Meta, inspect

    from kurbel.reading.toml_lines import Place

Model = TypeVar("Model")
A_TEXT = "a text in quotation marks"
# Python writes out no whole number of more than 4,300 digits.
MOST_BITS = 4000


class TomlKind(NamedTuple):
    """What a file is called, what is wrong with it, how large it may be, what it has, and a name for one.

    Sentences name the line and the key, or without `lines` the whole path of the key.
    """

    name: str
    error: type[KurbelError]
    largest: int
    shape: str
    example: str
    lines: bool = True


class Fault(KurbelError):
    """What a value must be; the sentence has its name and the value before that."""


def about(text: str, example: Any = None) -> Meta:
    """Return what is said of a field, to editors too, and an example of it."""
    from msgspec import Meta

    return Meta(description=text) if example is None else Meta(description=text, examples=[example])


def within(least: int, most: int) -> Meta:
    """Return the bounds of a whole number."""
    from msgspec import Meta

    return Meta(ge=least, le=most)


class Choice(str):
    """A text that must be one of a few."""

    what: ClassVar[str]
    allowed: ClassVar[Sequence[str]]
    SCHEMA: ClassVar[Mapping[str, Any]]

    def __init_subclass__(cls, what: str, allowed: Iterable[str]) -> None:
        cls.what, cls.allowed = what, [*allowed]
        cls.SCHEMA = {"type": "string", "enum": cls.allowed}

    @classmethod
    def read(cls, given: Any, _: str) -> Self:
        if not isinstance(given, str):
            raise Fault(A_TEXT)
        return cls(choose(given, cls.allowed, cls.what))


class TomlFile:
    """A file that was read: its text, what it says, and where."""

    def __init__(self, path: str | os.PathLike[str], kind: TomlKind) -> None:
        self.path = path
        self.kind = kind
        self.text = _text_of(path, kind)
        self.given = _parsed(path, kind, self.text)

    @cached_property
    def lines(self) -> Mapping[Place, int]:
        """The lines of the keys; of what is only written part by part, as a.b, that of the first."""
        from kurbel.reading.toml_lines import key_lines

        lines = key_lines(self.text)
        for place, line in [*lines.items()]:
            for end in range(1, len(place)):
                lines.setdefault(place[:end], line)
        return lines

    def line(self, place: Place) -> int:
        """Return the line of a key or, where it has none, of what it lies in."""
        while place and place not in self.lines:
            place = place[:-1]
        return self.lines.get(place, 1)

    def error(self, place: Place, said: object) -> KurbelError:
        """Return the kind's error with the file, the line of the place, and what is to be said."""
        where = f", line {self.line(place)}" if self.kind.lines else ""
        return self.kind.error(f"{self.path}{where}: {said}")

    def read(self, model: type[Model]) -> Model:
        """Return what the file says as its model; raise the kind's error for the first thing amiss."""
        import msgspec

        for place, said in self._faults(self.given, msgspec.inspect.type_info(model), ()):
            raise self.error(place, said)
        try:
            return msgspec.convert(self.given, model, dec_hook=_made)
        except (msgspec.ValidationError, KurbelError) as error:
            raise self.kind.error(f"{self.path}: {error}") from None

    def _faults(self, given: Any, shape: inspect.Type, place: Place) -> Iterator[tuple[Place, str]]:
        """Yield where something is amiss, in the order of the file, and the sentence about it."""
        from msgspec import inspect

        match shape:
            case inspect.Metadata():
                yield from self._faults(given, shape.type, place)
            case inspect.UnionType():
                yield from self._faults(given, _left(shape), place)
            case inspect.StructType() | inspect.DataclassType() if isinstance(given, dict):
                yield from self._faults_of_keys(given, shape, place)
            case inspect.DictType() if isinstance(given, dict):
                for key, value in given.items():
                    yield from self._faults(value, shape.value_type, (*place, key))
            case inspect.VarTupleType() if isinstance(given, list) and len(given) >= (shape.min_length or 0):
                for index, value in enumerate(given):
                    yield from self._faults(value, shape.item_type, (*place, index))
            case inspect.CustomType():
                try:
                    _made(shape.cls, given, name := self._name(place))
                except Fault as fault:
                    yield place, f"{name} is {shown(given)}; it must be {fault}"
                except KurbelError as error:
                    yield place, str(error)
            case _:
                if wanted := _wanted(given, shape, place):
                    yield place, f"{self._name(place)} is {shown(given)}; {wanted}"

    def _faults_of_keys(
        self, given: Mapping[str, Any], shape: inspect.StructType | inspect.DataclassType, place: Place
    ) -> Iterator[tuple[Place, str]]:
        fields = {field.encode_name: field for field in shape.fields}
        for key, value in given.items():
            try:
                choose(key, fields, getattr(shape.cls, "NOUN", f"entry of [{_dotted(place)}],"))
            except KurbelError as error:
                yield (*place, key), str(error)
            else:
                yield from self._faults(value, fields[key].type, (*place, key))
        for key, field in fields.items():
            if field.required and key not in given:
                yield place, f"there is no {key}; write {key} = {_example(field.type)}"

    def _name(self, place: Place) -> str:
        """Return what a value is called: by its key, and by its number in a list."""
        keys = [key for key in place if isinstance(key, str)]
        name = keys[-1] if self.kind.lines else ".".join(keys)
        return f"entry {place[-1] + 1} of {name}" if isinstance(place[-1], int) else name


def schema_of(model: type, title: str) -> dict[str, Any]:
    """Return the JSON Schema (draft 2020-12) of the files of a model."""
    from msgspec.inspect import type_info

    draft = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": title}
    return draft | _schema(type_info(model))


def _schema(shape: inspect.Type) -> dict[str, Any]:
    from msgspec import inspect

    match shape:
        case inspect.Metadata():
            return {**(shape.extra_json_schema or {}), **_schema(shape.type)}
        case inspect.UnionType():
            return _schema(_left(shape))
        case inspect.StructType() | inspect.DataclassType():
            properties = {field.encode_name: _schema(field.type) for field in shape.fields}
            required = [field.encode_name for field in shape.fields if field.required]
            struct = {"type": "object", "additionalProperties": False, "properties": properties}
            return {**struct, "required": required} if required else struct
        case inspect.VarTupleType():
            return {"type": "array", "items": _schema(shape.item_type)}
        case inspect.DictType():
            return {"type": "object", "additionalProperties": _schema(shape.value_type)}
        case inspect.IntType():
            return {"type": "integer", "minimum": shape.ge, "maximum": shape.le}
        case inspect.CustomType():
            own: Any = shape.cls
            return {**own.SCHEMA}
        case inspect.AnyType():
            return {}
    return {"type": "string" if isinstance(shape, inspect.StrType) else "boolean"}


def _left(shape: inspect.UnionType) -> inspect.Type:
    """Return what a value may be that may be left out; TOML has no null."""
    from msgspec import inspect

    (left,) = (one for one in shape.types if not isinstance(one, inspect.NoneType))
    return left


def _made(kind: Any, value: Any, name: str = "") -> Any:
    return kind.read(value, name)


def _example(shape: inspect.Type) -> str:
    """Return the first example that a field gives of its value, as TOML."""
    import json

    schema = getattr(shape, "extra_json_schema", None) or {}
    return json.dumps(schema["examples"][0], ensure_ascii=False)


def _wanted(given: Any, shape: inspect.Type, place: Place) -> str:
    """Return what a value must be that is not of the type; nothing for one that is."""
    from msgspec import inspect

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


def _parsed(path: str | os.PathLike[str], kind: TomlKind, text: str) -> dict[str, Any]:
    """Return what the text of the file says."""
    import tomllib

    if _LONG_KEY.search(text):
        raise kind.error(f"{path} has a key of very many parts; {kind.shape}")
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise kind.error(f"{path} is nested too deeply; {kind.shape}") from None
    except ValueError as error:
        # A malformed file is a ValueError that says the line.
        raise kind.error(f"cannot read the {kind.name} {path}: {error}") from None


# The parser takes minutes over them.
_LONG_KEY = re.compile(r"(?:[A-Za-z0-9_\"'-]{1,50}[ \t]{0,9}\.[ \t]{0,9}){200}")


def _text_of(path: str | os.PathLike[str], kind: TomlKind) -> str:
    """Return the text of the file."""
    if not os.fspath(path):
        raise kind.error(f"the {kind.name}'s file has no name; give one, such as {kind.example}")
    if os.path.exists(path) and not os.path.isfile(path):
        raise kind.error(
            f"cannot read the {kind.name} {path}: it is a directory or a device; name a TOML file"
        )
    try:
        with open(path, "rb") as file:
            content = file.read(kind.largest + 1)
    except FileNotFoundError:
        raise kind.error(f"cannot read the {kind.name} {path}: there is no such file") from None
    except (OSError, ValueError) as error:
        raise kind.error(f"cannot read the {kind.name} {path}: {error}") from None
    if len(content) > kind.largest:
        raise kind.error(f"{path} has more than {kind.largest} bytes; no {kind.name} needs them")
    try:
        # An editor may have put a mark before the text.
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        raise kind.error(
            f"{path}, line {line}: the byte 0x{content[error.start]:02x} is not UTF-8;"
            f" save the {kind.name} so"
        ) from None


def shown(value: Any) -> str:
    """What a value is, in the words of a TOML file."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, list):
        return "a list" if value else "an empty list"
    if isinstance(value, int) and value.bit_length() > MOST_BITS:
        return "a number of very many digits"
    return f'"{value}"'[:42] if isinstance(value, str) else str(value)[:40]
