"""Weisbach's works of a stroke, against the pressures of the stroke."""

from __future__ import annotations

import pytest
from cli import records
from verified import verified, words

STAGES = ("full_pressure_work", "expansion_work", "back_work")


@pytest.mark.parametrize(
    "options",
    [
        {"eps": "3", "back": "0.17"},
        {"eps": "3.5"},
        {"eps": "4", "exponent": "2", "clearance": "7%"},
        {"eps": "4", "exponent": "1.13", "back": "0.1"},
    ],
    ids=str,
)
def test_the_works_of_a_stroke_are_integrals_of_its_pressures(options: dict[str, str]) -> None:
    turn, asked = verified(**options), words(options)
    (row,) = records("delta", *asked, f"--columns={','.join(STAGES)}", "--digits=15")
    assert row == {key: turn.value(key).digits(15) for key in STAGES}
