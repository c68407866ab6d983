"""Long tables of drives without a crosshead: floats within their bounds, and the digits of short tables."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from cli import printed

from kurbel.motion.long.columns import LongColumns

DRIVES = (
    ("table", "--mechanism=arc", "--ratio=1:5", "--rocker=6"),
    ("table", "--mechanism=beam", "--beam=5", "--stroke=600mm", "--speed=120/min"),
    ("forces", "--mechanism=arc", "--rocker=5", "--force=10kN", "--stroke=600mm", "--speed=100/min",
     "--reciprocating=200kg"),
    ("table", "--mechanism=parallel"),
)  # fmt: skip


@pytest.mark.parametrize("words", DRIVES, ids=lambda words: f"{words[0]} {words[1]}")
def test_long_tables_have_the_digits_of_short_ones(
    words: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    settled: list[int] = []
    exactly = LongColumns.exactly

    def counted(self: LongColumns, *asked: Any) -> Any:
        settled.append(0)
        return exactly(self, *asked)

    monkeypatch.setattr(LongColumns, "exactly", counted)
    monkeypatch.setattr("kurbel.linkage.question.PAGE_CELLS", 5000)
    long = printed(*words, "--to=180", "--step=0.1", "--digits=6", "-f", "csv").records()
    assert len(settled) < len(long) / 20
    rows = {Fraction(record["phi"]): record for record in long}
    short = printed(*words, "--digits=6", "--angle=0;12.3;77.1;90;111;180", "-f", "csv").records()
    for record in short:
        assert {**rows[Fraction(record["phi"])], "phi": ""} == {**record, "phi": ""}
