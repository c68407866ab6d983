"""Workbooks of every layout as LibreOffice reads them, against our CSV and the rows of the page."""

from __future__ import annotations

import csv
import io
from dataclasses import replace
from pathlib import Path

import pytest
from cli import printed
from office import AS_SHOWN, GERMAN_CSV, converted, rows_as_shown
from pages import command, default_page
from rows import assert_rows_stand_in
from tools import require, require_library

from kurbel.exact.numerals import Number, number_text
from kurbel.formats.registry import FORMATS, WorkbookFormat
from kurbel.formats.render import render
from kurbel.page.labels import plain
from kurbel.page.layouts import layout_names

BOOKS = [name for name, form in FORMATS.items() if isinstance(form, WorkbookFormat)]
# Numbers, angles in minutes, words, formulas, panels, and units in a column.
SOME = ("kinematics", "collation", "roetscher-112", "delta-detail")


@pytest.mark.parametrize(
    "names", [SOME, pytest.param(layout_names(), marks=pytest.mark.slow)], ids=["some", "all"]
)
def test_what_is_shown_is_what_is_printed(names: tuple[str, ...], tmp_path: Path) -> None:
    require("soffice")
    require_library("xlsxwriter")
    files = [tmp_path / f"{name}-{book}.{book}" for name in names for book in BOOKS]
    for file in files:
        printed(*command(file.stem.rpartition("-")[0]), "-o", str(file))
    converted(files, AS_SHOWN, tmp_path)
    for name in names:
        for book in BOOKS:
            check(name, book, tmp_path)


def check(name: str, book: str, folder: Path) -> None:
    page = default_page(name, "de")
    values = rows_as_shown(folder / f"{name}-{book}-Werte.csv")
    ours = [*csv.reader(io.StringIO(render(page, "csv", decimal="comma")), delimiter=";")]
    # CSV keeps text from being a formula by an apostrophe; cells need none.
    assert [[one.removeprefix("'") for one in row] for row in values] == [
        [one.removeprefix("'") for one in row] for row in ours
    ]
    # Whatever is a number of ours is one of the sheet, and nothing else is.
    for shown, row in zip(values[1:], page.records.rows, strict=True):
        numbers = [number_text(one, ",") if isinstance(one, Number) else None for one in row]
        assert [one if one and not one.startswith("'") else None for one in shown] == numbers
    lines = [" ".join(row) for row in rows_as_shown(folder / f"{name}-{book}-Tafel.csv")]
    # Panels below each other on paper stand beside each other in a sheet.
    for panel in page.panels:
        assert_rows_stand_in(lines, replace(page, panels=(panel,)))
    assert lines[0].replace("\u00a0", " ").strip() == f"'{plain(page.caption, ',')}"


@pytest.mark.slow
def test_csv_for_excel_has_numbers_and_ratios_where_it_is_opened_in_german(tmp_path: Path) -> None:
    names = ("kinematics", "kolbenwege", "delta-tafel", "firing-orders", "locomotive", "collation")
    (tmp_path / "ours").mkdir()
    files = [tmp_path / "ours" / f"{name}.csv" for name in names]
    for file in files:
        printed(*command(file.stem), "--excel", "-o", str(file))
    converted(files, AS_SHOWN, tmp_path, GERMAN_CSV)
    for file in files:
        (read,) = tmp_path.glob(f"{file.stem}-*.csv")
        shown = rows_as_shown(read)[1:]
        for cells, row in zip(shown, default_page(file.stem, "de").records.rows, strict=True):
            for cell, value in zip(cells, row, strict=True):
                if value is None:
                    assert not cell
                    continue
                ours = number_text(value, ",") if isinstance(value, Number) else plain(value, ",")
                try:
                    number = float(ours.replace(",", "."))
                except ValueError:
                    # Signs that look like those of a time or a day are letters here.
                    assert cell.translate({0x2236: ":", 0x2010: "-", 0x2215: "/"}) == f"'{ours}"
                else:
                    assert float(cell.replace(",", ".")) == number
