"""Records as CSV, written row by row so that they need not fit in memory."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import chain
from typing import TYPE_CHECKING, Any

from kurbel.exact.numerals import DECIMALS, Number, number_text
from kurbel.formats.writer import Chunks, RecordsWriter
from kurbel.page.labels import plain
from kurbel.page.table import Table, Value

if TYPE_CHECKING:
    from kurbel.formats.columns import Field


class Writer(RecordsWriter):
    def rows(self, table: Table, decimal: str) -> Iterator[str]:
        """Yield the header and the records, each with its line end.

        With a decimal comma the separator is a semicolon. A missing value is empty. Text that a spreadsheet
        would run as a formula has an apostrophe before it; numbers are never changed.
        """
        records, mark = table.records, DECIMALS[decimal]
        writer = csv.writer(_Line(), delimiter=SEPARATORS[decimal], lineterminator="\n")
        # The writer returns what its file's `write` returns: here the line itself.
        yield writer.writerow([field.key for field in records.fields])
        for row in records.rows:
            yield writer.writerow([self.value(value, mark) for value in row])

    def value(self, value: Value, mark: str) -> str:
        """Return what stands in a field."""
        return _csv_value(value, mark)

    def bulk(self, table: Table, names: Sequence[str], chunks: Chunks, decimal: str) -> Iterator[bytes]:
        """Yield the header and the lines of each chunk."""
        from kurbel.formats.columns import csv_lines

        separator = SEPARATORS[decimal]
        yield f"{separator.join(names)}\n".encode()
        for fields in chunks(DECIMALS[decimal]):
            yield csv_lines([self.field(fields[name]) for name in names], separator.encode())

    def field(self, field: Field) -> Field:
        """Return a column as it stands in the file."""
        return field


class ForExcel(Writer):
    """CSV that Excel opens by a double click: it knows the encoding, and takes no ratio for a time."""

    def rows(self, table: Table, decimal: str) -> Iterator[str]:
        yield from chain([BYTE_ORDER_MARK], super().rows(table, decimal))

    def bulk(self, table: Table, names: Sequence[str], chunks: Chunks, decimal: str) -> Iterator[bytes]:
        yield from chain([BYTE_ORDER_MARK.encode()], super().bulk(table, names, chunks, decimal))

    def value(self, value: Value, mark: str) -> str:
        text = super().value(value, mark)
        return text if value is None or isinstance(value, Number) else no_time(text, mark)

    def field(self, field: Field) -> Field:
        return no_time(field.decode(), ",").encode() if isinstance(field, bytes) else field


# By it Excel knows that a file is UTF-8.
BYTE_ORDER_MARK = "\ufeff"
# What a spreadsheet takes for a time (1:5) or a day (1-3-2, 2/3), and with a decimal comma 0.5 as well.
_TIME = re.compile(r"[0-9][0-9.,]*(?:[:/-][0-9][0-9.,]*)+")
_POINTED = re.compile(r"[+-]?[0-9]+\.[0-9]+")
# The same signs as letters: ratio, division slash, hyphen. No spreadsheet reads a value in them.
_SIGNS = str.maketrans({":": "\u2236", "/": "\u2215", "-": "\u2010"})


def no_time(text: str, mark: str) -> str:
    """Return text that no spreadsheet takes for a time or a day, 1∶5 with the sign of ratios."""
    if _POINTED.fullmatch(text):
        return text.replace(".", mark)
    return text.translate(_SIGNS) if _TIME.fullmatch(text) else text


SEPARATORS = {"comma": ";", "point": ","}


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


# The labels of records, the ratios, repeat in many rows.
_plain = lru_cache(plain)
