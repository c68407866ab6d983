"""Write the JSON Schemas of machines, layouts and handbooks into the package; tests compare them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import kurbel
from kurbel.cli.asking import option_names
from kurbel.drive import machine
from kurbel.handbook import model as handbook_model
from kurbel.handbook.model import SCHEMA
from kurbel.page import layouts

PACKAGE = Path(kurbel.__file__).parent


def main() -> None:
    schemas: dict[str, dict[str, Any]] = {
        "drive/machine.schema.json": machine.schema(),
        "page/layout.schema.json": layouts.schema(),
        f"handbook/{SCHEMA}": handbook_model.schema(option_names()),
    }
    for name, schema in schemas.items():
        text = json.dumps(schema, indent=2, ensure_ascii=False)
        (PACKAGE / name).write_text(f"{text}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
