"""A handbook of 500 tables in four text formats: built anew, and again with nothing changed."""

from __future__ import annotations

from collections.abc import Iterator

from benchmarks.race import ALONE, Race, Row, kurbel

FORMATS = ("text", "markdown", "latex", "html")
COLD = "`kurbel table --ratio 1:5`, cold"


def manifest(tables: int) -> str:
    """Return a manifest of so many tables of different ratios, in chapters of 50."""
    lines = ['title = "Tafeln"', f"formats = {[*FORMATS]}"]
    for number in range(tables):
        if number % 50 == 0:
            lines += ["[[chapter]]", f'title = "Kapitel {number // 50}"']
        lines += ["[[chapter.part]]", f'run = "table --ratio 1:{3 + number / 100:.2f}"']
    return "\n".join(lines)


def races(quick: bool) -> Iterator[Race]:
    tables = 50 if quick else 500
    files = {"handbook.toml": manifest(tables)}
    what = f"handbook of {tables} tables in {len(FORMATS)} formats"
    cold = kurbel("table --ratio 1:5")
    yield Race(
        {
            "anew": kurbel("handbook build .", files=files),
            ALONE: kurbel("handbook build .", files=files, cores=1),
            COLD: cold,
        },
        [Row(f"{what}, built anew", "anew", one) for one in (COLD, ALONE)],
        rounds=2,
    )
    # Building nothing must not take twice a table.
    yield Race(
        {"again": kurbel("handbook build .", files=files, kept=True), COLD: cold},
        [Row(f"{what}, with nothing changed", "again", COLD, 2)],
        clock="processor",
    )
