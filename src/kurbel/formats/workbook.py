"""A table as a workbook: the page, and its records to calculate with."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kurbel.errors import LayoutError
from kurbel.exact.numerals import DECIMALS, Number, number_text
from kurbel.formats.sheet import (
    MOST_DECIMALS,
    MOST_FIGURES,
    MOST_ROWS,
    Look,
    Sheet,
    SheetCell,
    Workbook,
    checked_text,
    figures_wide,
    is_kept,
)
from kurbel.formats.sheet_page import BETWEEN, WIDEST_WORDS, page_sheet
from kurbel.page.labels import plain
from kurbel.page.table import Records, Table, Value
from kurbel.reading.dates import source_date_epoch

WORDS = {"de": {"page": "Tafel", "records": "Werte"}, "en": {"page": "Table", "records": "Values"}}
# A zip file has no earlier day.
EARLIEST = 315532800


def epoch() -> int:
    """Return the time that a workbook is of: SOURCE_DATE_EPOCH, else the first day of 1980."""
    return max(source_date_epoch() or 0, EARLIEST)


def table_workbook(table: Table, decimal: str) -> Workbook:
    """Return the workbook of a table: a sheet with its page, and one with its records.

    `decimal` is "comma" or "point", of the numbers in texts.
    """
    mark, words = DECIMALS[decimal], WORDS.get(table.lang, WORDS["en"])
    sheets = page_sheet(table, mark, words["page"]), records_sheet(table.records, mark, words["records"])
    return Workbook(plain(table.caption, mark), "", table.lang, epoch(), sheets)


def remarks(table: Table) -> Iterator[str]:
    """Yield what its author should know of the workbook of a table."""
    cells = (cell for panel in table.panels for row in panel.rows() for cell in row.stub + row.cells)
    if not all(is_kept(cell.value) for cell in cells if isinstance(cell.value, Number)):
        yield (
            f"a spreadsheet keeps {MOST_FIGURES} figures of a number and shows {MOST_DECIMALS} decimals;"
            " columns with more are text, with every digit"
        )


def records_sheet(records: Records, mark: str, name: str) -> Sheet:
    """Return the records as a sheet: a row of keys, as CSV has it, and a row for each record."""
    rows = [*records.rows]
    if len(rows) >= MOST_ROWS:
        raise LayoutError(
            f"a sheet of {len(rows)} records is too long; at most {MOST_ROWS - 1} are in one, use -f csv"
        )
    keys = [field.key for field in records.fields]
    columns = [_column([row[place] for row in rows], mark) for place in range(len(keys))]
    widths = tuple(
        min(max(map(figures_wide, (key, *map(_shown, {*cells}))), default=0.0), WIDEST_WORDS) + BETWEEN
        for key, cells in zip(keys, columns, strict=True)
    )
    head = (
        SheetCell(0, place, key, Look("key", "right" if _has_numbers(columns[place]) else "left"))
        for place, key in enumerate(keys)
    )
    body = _records(zip(*columns, strict=True))
    return Sheet(name, (*head, *body), widths, {}, (1, 0), (0, 1), True, mark)


def _column(values: Sequence[Value], mark: str) -> list[Number | str | None]:
    """Return the values of a column; its numbers are text where a spreadsheet would not keep one of them."""
    kept = all(is_kept(value) for value in values if isinstance(value, Number))
    return [
        value
        if value is None or (kept and isinstance(value, Number))
        else number_text(value, mark)
        if isinstance(value, Number)
        else checked_text(plain(value, mark))
        for value in values
    ]


def _has_numbers(values: Sequence[Number | str | None]) -> bool:
    return any(isinstance(value, Number) for value in values)


def _shown(value: Number | str | None) -> str:
    return number_text(value) if isinstance(value, Number) else value or ""


def _records(rows: Iterator[Sequence[Number | str | None]]) -> Iterator[SheetCell]:
    looks = [Look("body", "right", decimals=decimals) for decimals in range(MOST_DECIMALS + 1)]
    words = Look("body", "left")
    for place, row in enumerate(rows, 1):
        for column, value in enumerate(row):
            if isinstance(value, Number):
                yield SheetCell(place, column, value, looks[value.decimals])
            elif value:
                yield SheetCell(place, column, value, words)
