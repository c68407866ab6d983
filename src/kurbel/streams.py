"""Records in chunks of bytes: column-wise text for long CSV, row by row for the rest."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain, islice
from typing import TYPE_CHECKING, Any

from kurbel.build import build
from kurbel.digits import integer_angles, wants_bulk
from kurbel.formats import DECIMALS
from kurbel.notation import Progression, ratio_text
from kurbel.request import Request
from kurbel.rows import CHUNK, RecordRows, angle_decimals, angle_number

if TYPE_CHECKING:
    from kurbel.columns import Column


def record_chunks(request: Request, format_name: str, decimal: str) -> Iterator[bytes]:
    """Yield the table's records as CSV or JSON, about 65,000 rows at a time."""
    from kurbel.records import csv_rows, json_rows

    table = build(request, pages=False, mark=DECIMALS[decimal])
    rows = table.records.rows
    assert isinstance(rows, RecordRows)
    if format_name == "csv" and wants_bulk([column.digits for column in rows.columns], len(rows)):
        yield from _bulk_csv(rows, decimal)
        return
    lines = csv_rows(table.records, decimal) if format_name == "csv" else json_rows(table)
    for line in lines:
        yield "".join(chain([line], islice(lines, CHUNK - 1))).encode()


def _bulk_csv(rows: RecordRows, decimal: str) -> Iterator[bytes]:
    from kurbel.columns import csv_lines

    separator = b";" if decimal == "comma" else b","
    yield separator.join(key.encode() for key in rows.keys()) + b"\n"
    for crank, angles, values in rows.chunks(bulk=True):
        axes = {"ratio": ratio_text(crank.ratio, DECIMALS[decimal]).encode(), "phi": _phi(angles, rows)}
        fields = [axes.get(key) or values[key] for key in rows.keys()]
        yield csv_lines(fields, separator)
