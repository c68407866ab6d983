"""Records in chunks of bytes: column-wise text for long CSV, row by row for the rest."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain, islice
from typing import TYPE_CHECKING

from kurbel.build import build
from kurbel.formats import DECIMALS
from kurbel.notation import Progression, ratio_text
from kurbel.request import Request
from kurbel.rows import CHUNK, RecordRows, angle_decimals, angle_number

if TYPE_CHECKING:
    from kurbel.columns import Scaled


def record_chunks(request: Request, format_name: str, decimal: str) -> Iterator[bytes]:
    """Yield the table's records as CSV or JSON, a chunk of rows at a time."""
    from kurbel.records import csv_rows, json_rows

    table = build(request, pages=False, mark=DECIMALS[decimal])
    rows = table.records.rows
    assert isinstance(rows, RecordRows)
    if format_name == "csv" and rows.bulk() and _fits(request.angles):
        yield from _bulk_csv(rows, decimal)
        return
    lines = csv_rows(table.records, decimal) if format_name == "csv" else json_rows(table)
    for line in lines:
        yield "".join(chain([line], islice(lines, CHUNK - 1))).encode()


def _bulk_csv(rows: RecordRows, decimal: str) -> Iterator[bytes]:
    from kurbel.columns import Scaled, csv_lines

    mark, separator = DECIMALS[decimal].encode(), b";" if decimal == "comma" else b","
    decimals = {column.key: column.digits.decimals for column in rows.columns}
    yield separator.join(key.encode() for key in rows.names()) + b"\n"
    for crank, angles, values in rows.chunks():
        columns: dict[str, Scaled | bytes] = {key: Scaled(values[key], decimals[key], mark) for key in values}
        columns["ratio"] = ratio_text(crank.ratio, DECIMALS[decimal]).encode()
        columns["phi"] = _scaled_angles(angles, mark)
        yield csv_lines([columns[key] for key in rows.names()], separator)


def _fits(angles: Sequence[Fraction]) -> bool:
    """Whether every angle is a finite decimal that fits an int64."""
    decimals = angle_decimals(angles)
    return decimals is not None and max(abs(angles[0]), abs(angles[-1])) * 10**decimals < 2**62


def _scaled_angles(angles: Sequence[Fraction], mark: bytes) -> Scaled:
    import numpy as np

    from kurbel.columns import Scaled
    from kurbel.digits import integer_angles

    decimals = angle_decimals(angles) or 0
    if isinstance(angles, Progression):
        numerators, denominator = integer_angles(angles)
        # A denominator of tens only divides the power of ten.
        scaled = numerators * (10**decimals // denominator)
    else:
        scaled = np.array([angle_number(angle, angles).scaled for angle in angles], dtype=np.int64)
    return Scaled(scaled.astype(np.int64), decimals, mark)
