"""What a manifest may name: engines that set a PDF, and options for which there are defaults."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from functools import cache
from typing import Any, NamedTuple

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


@cache
def default_options() -> tuple[str, ...]:
    """Return the options for which there may be defaults, as the published schema lists them.

    To ask the commands themselves would take the time in which a handbook without changes is done.
    """
    with open(os.path.join(os.path.dirname(__file__), SCHEMA), encoding="utf-8") as file:
        published: dict[str, Any] = json.load(file)
    return tuple(published["properties"]["defaults"]["properties"])
