"""Records for programs: CSV and JSON, written row by row so that they need not fit in memory."""

from __future__ import annotations

import csv
import json
import re
from collections.abc import Iterator
from functools import lru_cache
from typing import Any

from kurbel.exact.numerals import Number, number_text
from kurbel.formats.registry import DECIMALS
from kurbel.page.labels import plain
from kurbel.page.table import Field, Records, Table, Value


def csv_rows(records: Records, decimal: str = "point") -> Iterator[str]:
    """Yield the header and the records, each with its line end.

    With a decimal comma the separator is a semicolon. A missing value is empty. Text that a spreadsheet would
    run as a formula has an apostrophe before it; numbers are never changed.
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
    return _harmless(_plain(value, mark)) if value else ""


# White space before them is no hindrance to every spreadsheet; `plain` leaves no other than spaces.
_RUNS = ("=", "+", "-", "@")
# Printed figures keep their signs: -0,0667  +5/4  -2°30'  -32°51½'  +15 %
_FIGURE = re.compile(r"[+-][0-9]+(?:[.,][0-9]+)*(?:/[0-9]+| ?%|°(?:[0-9]+½?['′](?:[0-9]+[\"″])?)?)?")


def _harmless(text: str) -> str:
    """Return text that no spreadsheet takes for a formula: with an apostrophe, unless it is a mere figure."""
    return f"'{text}" if text.lstrip().startswith(_RUNS) and not _FIGURE.fullmatch(text) else text


def json_rows(table: Table) -> Iterator[str]:
    """Yield one JSON object in pieces, a row a line.

    Numbers carry exactly the printed digits (0.500), which json.dumps cannot write; a missing value is null.
    """
    yield json_opening(table)
    separator = ""
    for row in _json_records(table.records):
        yield f"{separator}{row}"
        separator = JSON_SEPARATOR
    yield JSON_CLOSING


JSON_SEPARATOR = ",\n"
JSON_CLOSING = "\n]\n}\n"


def json_opening(table: Table) -> str:
    """Return all that stands before the first row."""
    head = "".join(f'"{name}": {_json(value)},\n' for name, value in _json_head(table).items())
    columns = JSON_SEPARATOR.join(_json(_json_field(field)) for field in table.records.fields)
    return f'{{\n{head}"columns": [\n{columns}\n],\n"rows": [\n'


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


def _json_value(value: Value) -> str:
    if isinstance(value, Number):
        return number_text(value)
    return _json(value and _plain(value, "."))


# The labels of records, the ratios, repeat in many rows.
_plain = lru_cache(plain)


def _json(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False)
