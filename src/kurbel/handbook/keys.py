"""The keys of a handbook's manifest: what each is, its type and the values it may have; their JSON Schema."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from functools import cache
from typing import Any, NamedTuple

from kurbel.formats.pdf.by_typst import STANDARDS
from kurbel.formats.registry import DECIMALS, FORMATS
from kurbel.page.layouts import LANGUAGES

SCHEMA = "handbook.schema.json"


class Engine(NamedTuple):
    """What sets a PDF: from the documents in which format, and from files with these suffixes."""

    source: str
    suffixes: tuple[str, ...]


_TEX = Engine("latex", (".tex", ".pdf"))
ENGINES: Mapping[str, Engine] = {
    "typst": Engine("typst", (".typ", ".svg")),
    "lualatex": _TEX,
    "latexmk": _TEX,
}


class Key(NamedTuple):
    """A key of the manifest: what it is, its type, and the values it may have, if they are few."""

    about: str
    kind: str = "text"
    allowed: tuple[str, ...] = ()
    label: bool = False


_LANG = Key("language: de or en", allowed=LANGUAGES)
_DEFAULTS = Key("options for every table of it that has them, as on the command line", "options")
KEYS: Mapping[str, Mapping[str, Key]] = {
    "handbook": {
        "title": Key("title, with formulas between dollar signs", label=True),
        "subtitle": Key("line below the title", label=True),
        "author": Key("author, below the title", label=True),
        "lang": _LANG,
        "decimal": Key("decimal mark: comma or point; default: by the language", allowed=tuple(DECIMALS)),
        "formats": Key("what is built", "texts", (*FORMATS,)),
        "output": Key("folder for what is built, inside of the manifest's folder"),
        "machine": Key("machine's file, for every command that takes --machine"),
        "templates": Key("folder with templates of one's own"),
        "pdf": Key("how the PDF is made", "pdf"),
        "defaults": _DEFAULTS,
        "chapter": Key("chapters", "chapters"),
    },
    "pdf": {
        "engine": Key("what sets the PDF: typst, or lualatex or latexmk of a TeX", allowed=tuple(ENGINES)),
        "standards": Key("standards that the PDF keeps; for typst", "texts", STANDARDS),
    },
    "chapter": {
        "title": Key("title, with formulas between dollar signs", label=True),
        "name": Key("name for references and files; default: from the title"),
        "lang": _LANG,
        "defaults": _DEFAULTS,
        "part": Key("texts, tables and figures, in their order", "parts"),
    },
    "part": {
        "run": Key('a command that prints a table or draws: "table --ratio 1:5", "plot --ratio 1:5"'),
        "text": Key("a text in Markdown"),
        "file": Key("a file with a text in Markdown"),
        "name": Key("name for references and files; default: from the command"),
        "caption": Key(
            "caption in place of the command's own, with formulas between dollar signs", label=True
        ),
        "lang": _LANG,
    },
}


@cache
def default_options() -> tuple[str, ...]:
    """Return the options for which there may be defaults, as the published schema lists them.

    To ask the commands themselves would take the time in which a handbook without changes is done.
    """
    with open(os.path.join(os.path.dirname(__file__), SCHEMA), encoding="utf-8") as file:
        published: dict[str, Any] = json.load(file)
    return tuple(published["properties"]["defaults"]["properties"])


def schema(options: Iterable[str]) -> dict[str, Any]:
    """Return the JSON Schema of the file; `options` are the names that defaults may have."""
    value = {"type": ["string", "number", "boolean"]}
    one_or_more = {"anyOf": [value, {"type": "array", "items": value, "minItems": 1}]}

    def section(name: str) -> dict[str, Any]:
        own = {key: {"description": one.about, **typed(one)} for key, one in KEYS[name].items()}
        return {"type": "object", "additionalProperties": False, "properties": own, **REQUIRED.get(name, {})}

    def typed(key: Key) -> dict[str, Any]:
        text = {"type": "string", **({"enum": [*key.allowed]} if key.allowed else {})}
        match key.kind:
            case "texts":
                return {"type": "array", "items": text}
            case "options":
                names = sorted(name.replace("_", "-") for name in options)
                return {
                    "type": "object",
                    "additionalProperties": False,
                    "properties": dict.fromkeys(names, one_or_more),
                }
            case "pdf":
                return section("pdf")
            case "chapters" | "parts":
                return {"type": "array", "items": section(key.kind.removesuffix("s"))}
        return text

    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "A handbook for kurbel",
        **section("handbook"),
    }


REQUIRED: Mapping[str, Mapping[str, Any]] = {
    "handbook": {"required": ["title"]},
    "chapter": {"required": ["title"]},
    "part": {"oneOf": [{"required": [key]} for key in ("run", "text", "file")]},
}
