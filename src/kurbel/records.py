"""Records for programs: CSV and JSON, written row by row so that they need not fit in memory."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator
from typing import Any

from kurbel.formats import DECIMALS
from kurbel.labels import plain
from kurbel.numerals import number_text
from kurbel.table import Field, Number, Records, Table, Value


def csv_rows(records: Records, decimal: str = "point") -> Iterator[str]:
    """Yield the header and the records, each with its line end.

    With a decimal comma the separator is a semicolon. A missing value is empty.
    """
    writer = csv.writer(_Line(), delimiter=";" if decimal == "comma" else ",", lineterminator="\n")
    mark = DECIMALS[decimal]
    # The writer returns what its file's `write` returns: here the line itself.
    yield writer.writerow([field.key for field in records.fields])
    for row in records.rows:
        yield writer.writerow([_csv_value(value, mark) for value in row])


class _Line:
    """A file that hands back what is written to it."""

    def write(self, line: str) -> Any:
        return line


def _csv_value(value: Value, mark: str) -> str:
    if isinstance(value, Number):
        return number_text(value, mark)
    return value or ""


def json_rows(table: Table) -> Iterator[str]:
    """Yield one JSON object in pieces, a row a line.

    Numbers carry exactly the printed digits (0.500), which json.dumps cannot write; a missing value is null.
    """
    yield "{\n"
    for name, value in _json_head(table).items():
        yield f'"{name}": {_json(value)},\n'
    yield from _json_array("columns", (_json(_json_field(field)) for field in table.records.fields))
    yield ",\n"
    yield from _json_array("rows", _json_records(table.records))
    yield "\n}\n"


def _json_head(table: Table) -> dict[str, Any]:
    notes = [{"mark": note.mark, "text": plain(note.text)} for note in table.notes]
    return {
        "table": table.key,
        "lang": table.lang,
        "caption": plain(table.caption),
        "source": plain(table.source),
        "notes": notes,
    }


def _json_field(field: Field) -> dict[str, Any]:
    return {
        "key": field.key,
        "name": field.name,
        "symbol": plain(field.symbol),
        "unit": field.unit,
        "decimals": field.decimals,
        "method": field.method,
    }


def _json_records(records: Records) -> Iterator[str]:
    keys = [_json(field.key) for field in records.fields]
    for row in records.rows:
        pairs = (f"{key}: {_json_value(value)}" for key, value in zip(keys, row, strict=True))
        yield f"{{{', '.join(pairs)}}}"


def _json_array(name: str, lines: Iterator[str]) -> Iterator[str]:
    yield f'"{name}": ['
    separator = "\n"
    for line in lines:
        yield f"{separator}{line}"
        separator = ",\n"
    yield "\n]"


def _json_value(value: Value) -> str:
    return number_text(value) if isinstance(value, Number) else _json(value)


def _json(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False)
