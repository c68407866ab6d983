"""Records as CSV: what its template reads, and long tables column by column, which need not fit in memory."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import chain, islice
from typing import TYPE_CHECKING, ClassVar

from kurbel.errors import LayoutError
from kurbel.exact.numerals import DECIMALS, Number, number_text
from kurbel.formats.render import filled_by, has_template, pieces, template_of
from kurbel.formats.writer import Chunks, RecordsWriter
from kurbel.page.labels import plain
from kurbel.page.table import Table, Value

if TYPE_CHECKING:
    from kurbel.formats.columns import Field


class Writer(RecordsWriter):
    """With a decimal comma the separator is a semicolon. A missing value is empty. Text that a spreadsheet
    would run as a formula has an apostrophe before it; numbers are never changed.
    """

    excel: ClassVar[bool] = False

    def rows(self, table: Table, decimal: str, folders: Sequence[str] = ()) -> Iterator[str]:
        """Raises LayoutError for more rows than a template of one's own can set."""
        from kurbel.formats.csv import FORMAT

        template, rows = template_of(table, FORMAT.name, folders), table.records.rows
        if own := has_template(folders, template):
            rows = tuple(islice(rows, MOST_ROWS + 1))
            if len(rows) > MOST_ROWS:
                raise LayoutError(
                    f"a table of more than {MOST_ROWS} rows streams past templates, and {template} would be"
                    " ignored; leave it out of the folder, or print fewer rows"
                )
        values = {
            "fields": table.records.fields,
            "rows": rows,
            "mark": DECIMALS[decimal],
            "separator": SEPARATORS[decimal],
            "excel": self.excel,
        }
        if own:
            yield filled_by(FORMAT, template, values, tuple(folders))
        else:
            yield from pieces(FORMAT, template, values)

    def filters(self) -> Mapping[str, Callable[..., object]]:
        return {"field": field_text, "quoted": quoted}

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

    excel = True

    def bulk(self, table: Table, names: Sequence[str], chunks: Chunks, decimal: str) -> Iterator[bytes]:
        yield from chain([BYTE_ORDER_MARK.encode()], super().bulk(table, names, chunks, decimal))

    def field(self, field: Field) -> Field:
        return no_time(field.decode(), ",").encode() if isinstance(field, bytes) else field


# What is set by a template of one's own is made whole.
MOST_ROWS = 100_000
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


# What a field is put in quotation marks for, beside the separator.
_QUOTED = re.compile(r'["\r\n]')


def field_text(value: Value, mark: str, excel: bool = False) -> str:
    """Return what stands in a field; for Excel no time."""
    if isinstance(value, Number):
        return number_text(value, mark)
    text = _harmless(_plain(value, mark)) if value else ""
    return no_time(text, mark) if excel else text


def quoted(text: str, separator: str, row: Sequence[Value]) -> str:
    """Return the text of a field in quotation marks if it needs them; alone in its row nothing does."""
    if separator in text or _QUOTED.search(text) or (not text and len(row) == 1):
        return '"' + text.replace('"', '""') + '"'
    return text


# White space before them is no hindrance to every spreadsheet; `plain` leaves no other than spaces.
_RUNS = ("=", "+", "-", "@")
# Printed figures keep their signs: -0,0667  +5/4  -2°30'  -32°51½'  +15 %
_FIGURE = re.compile(r"[+-][0-9]+(?:[.,][0-9]+)*(?:/[0-9]+| ?%|°(?:[0-9]+½?['′](?:[0-9]+[\"″])?)?)?")


def _harmless(text: str) -> str:
    """Return text that no spreadsheet takes for a formula: with an apostrophe, unless it is a mere figure."""
    return f"'{text}" if text.lstrip().startswith(_RUNS) and not _FIGURE.fullmatch(text) else text


# The labels of records, the ratios, repeat in many rows.
_plain = lru_cache(plain)
