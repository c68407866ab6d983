"""Write the JSON Schemas of machines, layouts, sweeps and handbooks, for editors, into the package."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from msgspec import inspect

import kurbel
from kurbel.cli.asking import option_names
from kurbel.cli.sweep_command import MODEL
from kurbel.commands.machine_file import machine_model
from kurbel.handbook.model import SCHEMA, HandbookKeys
from kurbel.page.layouts import LayoutFile
from kurbel.reading.toml_model import left

PACKAGE = Path(kurbel.__file__).parent


def main() -> None:
    for path, schema in schemas().items():
        text = json.dumps(schema, indent=2, ensure_ascii=False)
        path.write_text(f"{text}\n", encoding="utf-8")


def schemas() -> dict[Path, dict[str, Any]]:
    """Return the JSON Schemas by their files."""
    return {
        PACKAGE / "commands" / "machine.schema.json": schema_of(machine_model(), "A machine for kurbel"),
        PACKAGE / "page" / "layout.schema.json": schema_of(LayoutFile, "A page layout for kurbel"),
        PACKAGE / "sweeps" / "sweep.schema.json": schema_of(MODEL, "A sweep for kurbel"),
        PACKAGE / "handbook" / SCHEMA: handbook_schema(option_names()),
    }


def handbook_schema(options: Iterable[str]) -> dict[str, Any]:
    """Return the JSON Schema of a handbook; `options` are the names that defaults may have."""
    value = {"type": ["string", "number", "boolean"]}
    one_or_more = {"anyOf": [value, {"type": "array", "items": value, "minItems": 1}]}
    names = sorted(name.replace("_", "-") for name in options)
    given = schema_of(HandbookKeys, "A handbook for kurbel")
    for section in (given, given["properties"]["chapter"]["items"]):
        # The reader says of a title that is only blank the same as of none.
        section["required"] = ["title"]
        own = {"additionalProperties": False, "properties": dict.fromkeys(names, one_or_more)}
        section["properties"]["defaults"] |= own
    return given


def schema_of(model: type, title: str) -> dict[str, Any]:
    """Return the JSON Schema (draft 2020-12) of the files of a model."""
    draft = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": title}
    return draft | _schema(inspect.type_info(model))


def _schema(shape: inspect.Type) -> dict[str, Any]:
    match shape:
        case inspect.Metadata():
            told = shape.extra_json_schema or {}
            # Columns that may lie in columns say so themselves.
            return {**told} if "items" in told else {**told, **_schema(shape.type)}
        case inspect.UnionType():
            return _schema(left(shape))
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


if __name__ == "__main__":
    main()
