"""A page of many rows takes time by its rows, in every format, and not by their square."""

from __future__ import annotations

from pathlib import Path
from time import process_time

import pytest
from cli import printed

# Sixteen times the rows may take so many times the time.
LONGER = 48
STEPS = "table --step {}", "1.44", "0.09"
RATIOS = "table --step 90 --ratio {}", "1:3..3.2:0.01", "1:3..6.2:0.01"
FORMATS = ("csv", "json", "html", "latex", "markdown", "rst", "text", "typst", "xlsx", "ods")


@pytest.mark.parametrize(
    ("line", "few", "many", "form"),
    [*((*STEPS, form) for form in FORMATS), (*RATIOS, "csv")],
    ids=[*FORMATS, "ratios"],
)
def test_sixteen_times_the_rows_take_no_more_than_three_times_that_long(
    line: str, few: str, many: str, form: str, tmp_path: Path
) -> None:
    more = ("--longtable",) if form == "latex" else ()

    def took(rows: str) -> float:
        before = process_time()
        printed(*line.format(rows).split(), "-f", form, *more, "-o", str(tmp_path / "page"))
        return process_time() - before

    took(few)
    assert took(many) < LONGER * min(took(few) for _ in range(2))
