"""JSON: one object with columns and rows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from kurbel.formats.format import RecordsFormat

if TYPE_CHECKING:
    from kurbel.formats.format import Chunks
    from kurbel.page.table import Table


class Json(RecordsFormat):
    name = "json"
    rank = 90
    suffixes = (".json",)
    media = "one object with columns and rows, for programs"
    legible = 7
    usual = True

    def rows(self, table: Table, decimal: str) -> Iterator[str]:
        from kurbel.formats.json.rows import json_rows

        return json_rows(table)

    def bulk(self, table: Table, names: Sequence[str], chunks: Chunks, decimal: str) -> Iterator[bytes]:
        from kurbel.formats.json.rows import json_bulk

        return json_bulk(table, names, chunks)


FORMAT = Json()
