"""Records as JSON, written row by row so that they need not fit in memory."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING

from kurbel.exact.numerals import Number, number_text
from kurbel.formats.writer import Chunks, RecordsWriter
from kurbel.page.labels import plain
from kurbel.page.table import Records, Table, Value

if TYPE_CHECKING:
    from kurbel.formats.columns import Field


class Writer(RecordsWriter):
    """Writes one JSON object in pieces."""

    def rows(self, table: Table, decimal: str, folders: Sequence[str] = ()) -> Iterator[str]:
        """Yield the object, a row a line.

        Numbers carry exactly the printed digits (0.500), which json.dumps cannot write; a missing value is
        null.
        """
        yield _opening(table)
        separator = ""
        for row in _json_records(table.records):
            yield f"{separator}{row}"
            separator = _SEPARATOR
        yield _CLOSING

    def bulk(self, table: Table, names: Sequence[str], chunks: Chunks, decimal: str) -> Iterator[bytes]:
        """Yield the object, its rows by chunks."""
        from kurbel.formats.columns import csv_lines

        before = _opening(table)
        for fields in chunks("."):
            line: list[Field] = []
            for place, name in enumerate(names):
                value = fields[name]
                quoted = b'"' + value + b'"' if isinstance(value, bytes) else value
                line += [f'{", " if place else "{"}"{name}": '.encode(), quoted]
            # Every line ends with the separator; the last one of the table must not.
            lines = csv_lines([*line, b"},"], b"")
            yield before.encode() + lines.removesuffix(_SEPARATOR.encode())
            before = _SEPARATOR
        yield _CLOSING.encode()


_SEPARATOR = ",\n"
_CLOSING = "\n]\n}\n"


def _opening(table: Table) -> str:
    """Return all that stands before the first row."""
    caption, notes = table.told or (table.caption, table.notes)
    head: dict[str, object] = {
        "table": table.key,
        "lang": table.lang,
        "caption": plain(caption),
        "source": plain(table.source),
        "notes": [{"mark": note.mark, "text": plain(note.text)} for note in notes],
    }
    if table.request:
        head["request"] = table.request._asdict()
    lines = "".join(f'"{name}": {_json(value)},\n' for name, value in head.items())
    columns = _SEPARATOR.join(
        _json(field._asdict() | {"symbol": plain(field.symbol)}) for field in table.records.fields
    )
    return f'{{\n{lines}"columns": [\n{columns}\n],\n"rows": [\n'


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


def _json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, default=_written)


def _written(value: object) -> object:
    """Return what JSON knows not: an array as a list, a fraction, a decimal, the name of a file as text."""
    return value.tolist() if hasattr(value, "tolist") else str(value)
