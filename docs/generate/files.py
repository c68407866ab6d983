"""The pages about files that kurbel reads, each with a JSON Schema: its keys, and the schema itself."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

from markdown import plain, table, toctree
from schemas import schemas

FOLDER = "reference/files"
# What a file is called, where it is told of, and the file of its schema.
FILES = {
    "machine.schema.json": ("machine", "A machine", "subjects/engines.md"),
    "layout.schema.json": ("layout", "layout.toml", "howto/layout-keys.md"),
    "sweep.schema.json": ("sweep", "sweep.toml", "howto/sweeps.md"),
    "handbook.schema.json": ("handbook", "handbook.toml", "howto/handbook.md"),
}
Schema = Mapping[str, Any]


def pages() -> Iterator[tuple[str, str]]:
    names = []
    for path, schema in schemas().items():
        name, title, guide = FILES[path.name]
        names.append(name)
        yield f"{FOLDER}/{name}.md", "\n\n".join(_page(schema, title, guide, path.name)) + "\n"
        yield f"{FOLDER}/{path.name}", json.dumps(schema, indent=2, ensure_ascii=False) + "\n"
    index = (
        "# Files",
        "TOML files that kurbel reads, with their keys. Editors complete and check them by the JSON Schemas,"
        " which lie in the package, too.",
        toctree(names),
    )
    yield f"{FOLDER}/index.md", "\n\n".join(index) + "\n"


def _page(schema: Schema, title: str, guide: str, file: str) -> Iterator[str]:
    yield f"# {title}"
    yield f"What it is for is told [in the guide](../../{guide})."
    yield f"Its JSON Schema: {{download}}`{file} <{file}>`."
    yield from _section(schema, "")


def _section(schema: Schema, name: str) -> Iterator[str]:
    """Yield the keys of a table of TOML, then those of the tables in it."""
    keys = schema.get("properties", {})
    required = schema.get("required", ())
    inner = {key: _inner(one) for key, one in keys.items()}
    plain_keys = {key: one for key, one in keys.items() if not inner[key]}
    if name:
        yield f"## {name}"
    if plain_keys:
        rows = [(f"`{key}`", _kind(one), _about(one, key in required)) for key, one in plain_keys.items()]
        yield table(("key", "value", "what it says"), rows)
    for key, found in inner.items():
        if found:
            bracket = "[[{}]]" if keys[key].get("type") == "array" else "[{}]"
            path = f"{name.strip('[]')}.{key}".lstrip(".")
            yield from _section(found, bracket.format(path))


def _inner(schema: Schema) -> Schema | None:
    """Return what a table or an array of tables holds."""
    if schema.get("type") == "array":
        return _inner(schema["items"])
    return schema if "properties" in schema else None


def _kind(schema: Schema) -> str:
    if choices := schema.get("enum"):
        return ", ".join(f"`{json.dumps(one)}`" for one in choices)
    if alternatives := schema.get("anyOf"):
        return " or ".join(_kind(one) for one in alternatives)
    kind = schema.get("type", "any")
    if kind == "array":
        return f"list of {_kind(schema['items'])}"
    if kind == "object":
        return "table"
    return " or ".join(kind) if isinstance(kind, list) else str(kind)


def _about(schema: Schema, required: bool) -> str:
    return plain(schema.get("description", "")) + (" (must be given)" if required else "")
