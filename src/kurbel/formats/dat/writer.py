"""Records as columns of numbers, as pgfplots and gnuplot read them without an option."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import lru_cache

from kurbel.exact.numerals import Number, number_text
from kurbel.formats.writer import Chunks, RecordsWriter
from kurbel.page.labels import plain
from kurbel.page.table import Table, Value


class Writer(RecordsWriter):
    """Writes one line of keys, then a line a record, parted by spaces.

    Numbers have a decimal point, whatever was asked for, and a missing one is nan. A blank line, at which a
    plotted line is interrupted, stands between records whose first columns have different labels.
    """

    def rows(self, table: Table, decimal: str, folders: Sequence[str] = ()) -> Iterator[str]:
        """Yield the keys and the records, each with its line end."""
        yield " ".join(field.key for field in table.records.fields) + "\n"
        curve: Value = None
        for row in table.records.rows:
            if isinstance(row[0], str):
                if curve not in (None, row[0]):
                    yield "\n"
                curve = row[0]
            texts = (number_text(one) if isinstance(one, Number) else _word(one or "nan") for one in row)
            yield " ".join(texts) + "\n"

    def bulk(self, table: Table, names: Sequence[str], chunks: Chunks, decimal: str) -> Iterator[bytes]:
        """Yield the keys and the lines of each chunk."""
        from kurbel.formats.columns import csv_lines

        yield f"{' '.join(names)}\n".encode()
        curve = None
        for fields in chunks("."):
            if isinstance(first := fields[names[0]], bytes):
                if curve not in (None, first):
                    yield b"\n"
                curve = first
            yield csv_lines([fields[name] for name in names], b" ")


# What parts columns, or is obeyed by TeX as it reads them.
_OBEYED = re.compile(r"[\s#%{}\\\"$&~^]+")


@lru_cache
def _word(label: str) -> str:
    """Return a label as one word: "letzte_Stelle"."""
    return _OBEYED.sub("_", plain(label)) or "_"
