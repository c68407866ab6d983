"""The printed values of the books, which stand with kurbel's sources alone."""

from __future__ import annotations

import csv
from functools import cache
from pathlib import Path

from kurbel.books.source import source_tables


@cache
def printed_values(table: str) -> dict[str, str]:
    """Return the characters that a book prints, by their place in its table."""
    return {cell.place: cell.printed.text for cell in source_tables()[table].cells if cell.printed}


def register(path: Path) -> list[dict[str, str]]:
    """Return the rows of a file of tests/sources, each with what is `printed` in the `cell` that it names."""
    with path.open(encoding="utf-8", newline="") as lines:
        rows = list(csv.DictReader(lines, delimiter=";"))
    return [row | {"printed": printed_values(row["place"].split("/")[0])[row["cell"]]} for row in rows]
