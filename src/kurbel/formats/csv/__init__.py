"""CSV: one record a line."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from kurbel.formats.format import RecordsFormat

if TYPE_CHECKING:
    from kurbel.formats.format import Chunks
    from kurbel.page.table import Table


class Csv(RecordsFormat):
    name = "csv"
    rank = 80
    suffixes = (".csv",)
    media = "one record a line, for spreadsheets"
    legible = 1
    usual = True

    def rows(self, table: Table, decimal: str) -> Iterator[str]:
        from kurbel.formats.csv.rows import csv_rows

        return csv_rows(table.records, decimal)

    def bulk(self, table: Table, names: Sequence[str], chunks: Chunks, decimal: str) -> Iterator[bytes]:
        from kurbel.formats.csv.rows import csv_bulk

        return csv_bulk(names, chunks, decimal)


FORMAT = Csv()
