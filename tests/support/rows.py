"""The figures of a page, wherever it is printed: every row in a line."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from tools import require

from kurbel.exact.numerals import Number, number_text
from kurbel.page.labels import plain
from kurbel.page.table import Row, Table


def text_of_pdf(folder: Path) -> str:
    subprocess.run([require("pdftotext"), "-layout", "page.pdf", "page.txt"], cwd=folder, check=True)
    return (folder / "page.txt").read_text(encoding="utf-8")


def assert_rows_stand_in(lines: list[str], page: Table, angles: bool = True) -> None:
    """Check that the figures of every row of the page stand in a line, from left to right and going down.

    Of a page without any, the words do.
    """
    below = iter(lines)
    rows = [row_of_figures(row, page.lang, angles) for panel in page.panels for row in panel.rows()]
    if not any(rows):
        rows = [row_of_words(row) for panel in page.panels for row in panel.rows()]
    assert any(rows)
    for row in rows:
        pattern = re.compile(".*?".join(rf"(?<![\d.,]){re.escape(figure)}(?!\d|[.,]\d)" for figure in row))
        assert any(pattern.search(written(line)) for line in below), f"{page.key} has no row {row}"


def row_of_figures(row: Row, lang: str, angles: bool) -> list[str]:
    """Return the numbers and angles of a row in the notation of the language."""
    mark = {"de": ",", "en": "."}[lang]
    return [
        number_text(cell.value, mark) if isinstance(cell.value, Number) else written(plain(cell.value))
        for cell in row.stub + row.cells
        if isinstance(cell.value, Number)
        or (angles and isinstance(cell.value, str) and ANGLE.fullmatch(cell.value))
    ]


def row_of_words(row: Row) -> list[str]:
    """Return the labels of a row that have no formula, as plain text."""
    labels = [cell.value for cell in row.stub + row.cells if isinstance(cell.value, str)]
    return [written(plain(label)) for label in labels if "$" not in label]


ANGLE = re.compile(r"\$\d+°\d+'\$")


def written(line: str) -> str:
    """Return the line with one minus sign and one prime for all."""
    return line.replace("−", "-").replace("′", "'")
