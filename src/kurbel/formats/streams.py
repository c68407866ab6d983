"""Records in chunks of bytes: column-wise text for long CSV, row by row for the rest."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain, islice
from typing import TYPE_CHECKING

from kurbel.formats.registry import DECIMALS
from kurbel.motion.digits import MOST_DECIMALS, largest
from kurbel.motion.rows import CHUNK, RecordRows
from kurbel.page.angles import angle_decimals, angle_number
from kurbel.page.build import Asked, build
from kurbel.page.table import Table
from kurbel.reading.notation import Progression, ratio_text

if TYPE_CHECKING:
    from kurbel.formats.columns import Scaled


def record_chunks(request: Asked, format_name: str, decimal: str) -> Iterator[bytes]:
    """Yield the table's records as CSV or JSON, a chunk of rows at a time."""
    from kurbel.formats.records import csv_rows, json_rows

    table = build(request, pages=False)
    rows = table.records.rows
    if isinstance(rows, RecordRows) and rows.question.bulk and _fits(rows.question.angles):
        yield from _bulk_csv(rows, decimal) if format_name == "csv" else _bulk_json(table, rows)
        return
    lines = csv_rows(table.records, decimal) if format_name == "csv" else json_rows(table)
    for line in lines:
        yield "".join(chain([line], islice(lines, CHUNK - 1))).encode()


def _bulk_csv(rows: RecordRows, decimal: str) -> Iterator[bytes]:
    from kurbel.formats.columns import csv_lines

    separator = b";" if decimal == "comma" else b","
    yield separator.join(key.encode() for key in rows.keys) + b"\n"
    for fields in _bulk_fields(rows, DECIMALS[decimal]):
        yield csv_lines([fields[key] for key in rows.keys], separator)


def _bulk_json(table: Table, rows: RecordRows) -> Iterator[bytes]:
    from kurbel.formats.columns import csv_lines
    from kurbel.formats.records import JSON_CLOSING, JSON_SEPARATOR, json_opening

    before = json_opening(table)
    for fields in _bulk_fields(rows, "."):
        line: list[Scaled | bytes] = []
        for place, key in enumerate(rows.keys):
            value = fields[key]
            line += [f'{", " if place else "{"}"{key}": '.encode(), _quoted(value)]
        # Every line ends with the separator; the last one of the table must not.
        lines = csv_lines([*line, b"},"], b"")
        yield before.encode() + lines.removesuffix(JSON_SEPARATOR.encode())
        before = JSON_SEPARATOR
    yield JSON_CLOSING.encode()


def _quoted(value: Scaled | bytes) -> Scaled | bytes:
    return b'"' + value + b'"' if isinstance(value, bytes) else value


def _bulk_fields(rows: RecordRows, mark: str) -> Iterator[dict[str, Scaled | bytes]]:
    """Yield the columns of each chunk by their keys."""
    from kurbel.formats.columns import Scaled

    decimals = {key: column.places for key, column in rows.columns.items()}
    of_angles = angle_decimals(rows.question.angles) or 0
    for crank, angles, values in rows.chunks():
        fields: dict[str, Scaled | bytes] = {
            key: Scaled(values[key], decimals[key], mark.encode()) for key in values
        }
        fields["ratio"] = ratio_text(crank.ratio, mark).encode()
        fields["phi"] = _scaled_angles(angles, of_angles, mark.encode())
        yield fields


def _fits(angles: Sequence[Fraction]) -> bool:
    """Whether every angle is a finite decimal that fits an int64."""
    decimals = angle_decimals(angles)
    return decimals is not None and decimals <= MOST_DECIMALS and largest(angles) * 10**decimals < 2**62


def _scaled_angles(angles: Sequence[Fraction], decimals: int, mark: bytes) -> Scaled:
    import numpy as np

    from kurbel.formats.columns import Scaled
    from kurbel.motion.digits import integer_angles

    if isinstance(angles, Progression):
        numerators, denominator = integer_angles(angles)
        # A denominator of tens only divides the power of ten.
        scaled = numerators * (10**decimals // denominator)
    else:
        scaled = np.array([angle_number(angle, decimals).scaled for angle in angles], dtype=np.int64)
    return Scaled(scaled.astype(np.int64), decimals, mark)
