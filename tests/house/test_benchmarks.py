"""The benchmarks and the page of what they measured."""

from __future__ import annotations

import importlib

import pytest
from places import ROOT


def test_the_page_of_speed_has_every_row_that_is_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(ROOT)
    runner = importlib.import_module("benchmarks.__main__")
    page = (ROOT / "docs" / "speed.md").read_text(encoding="utf-8")
    table = [line.strip("| ").split(" | ") for line in page.splitlines() if line.startswith("| ")]
    rows = [row for name in runner.NAMES for race in runner.races(name) for row in race.rows]
    assert [(cells[0], cells[2]) for cells in table[2:]] == [(row.what, row.beside) for row in rows]
