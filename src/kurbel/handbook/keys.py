"""What a manifest may name: engines that set a PDF, and options for which there are defaults."""

from __future__ import annotations

import json
import os
from functools import cache
from typing import Any

from kurbel.formats.registry import compiled_format

SCHEMA = "handbook.schema.json"
COMPILED = compiled_format()
ENGINES = COMPILED.writer.engines
STANDARDS = tuple(dict.fromkeys(one for engine in ENGINES.values() for one in engine.standards))


@cache
def default_options() -> tuple[str, ...]:
    """Return the options for which there may be defaults, as the published schema lists them.

    To ask the commands themselves would take the time in which a handbook without changes is done.
    """
    with open(os.path.join(os.path.dirname(__file__), SCHEMA), encoding="utf-8") as file:
        published: dict[str, Any] = json.load(file)
    return tuple(published["properties"]["defaults"]["properties"])
