"""The JSON Schemas in the package, for editors, are those of the models that read the files."""

from __future__ import annotations

import json
import runpy

from places import ROOT


def test_the_schemas_in_the_package_are_those_of_the_readers() -> None:
    schemas = runpy.run_path(str(ROOT / "docs" / "generate" / "schemas.py"))["schemas"]()
    assert len(schemas) == 4
    for path, schema in schemas.items():
        assert json.loads(path.read_text(encoding="utf-8")) == schema, path.name
