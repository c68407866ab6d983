"""The printed values of the books, which stand with kurbel's sources alone."""

from __future__ import annotations

import csv
import tomllib
from functools import cache
from pathlib import Path

import kurbel

FORMULAS = (
    *("blau-equations", "blau-solutions", "roetscher-equations", "uebung-equations"),
    *("weisbach-equations", "weisbach-best"),
)
BOOKS = Path(kurbel.__file__).parent / "books" / "sources"


def rows_of(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(lines, delimiter=";"))


@cache
def formulas(key: str) -> list[dict[str, str]]:
    """Return the rows of a table of values or of formulas, such as blau-33."""
    book, name = key.split("-")
    return rows_of(BOOKS / book / f"{name}.csv")


@cache
def letters_of(key: str) -> dict[str, str]:
    """Return the letters of a section of formulas that are made of others."""
    book, name = key.split("-")
    with (BOOKS / book / "source.toml").open("rb") as file:
        return dict(tomllib.load(file)["formulas"][name].get("letters", {}))


@cache
def printed_values(table: str) -> dict[str, str]:
    """Return the characters that a book prints, by their place in its table, such as blau-33."""
    return {row["place"]: row["printed"] for row in formulas(table) if row["printed"]}


def register(path: Path) -> list[dict[str, str]]:
    """Return the rows of a file of tests/sources, each with what is `printed` in the `cell` that it names."""
    return [
        row | {"printed": printed_values(row["place"].split("/")[0])[row["cell"]]} for row in rows_of(path)
    ]
