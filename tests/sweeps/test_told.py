"""What is said when a sweep has been written."""

from __future__ import annotations

import re
from math import log
from pathlib import Path

import pytest
from cli import kurbel

from kurbel.sweeps import estimate
from kurbel.sweeps.asked import planned
from kurbel.sweeps.files.forms import form_of
from kurbel.sweeps.rows import Sweep


def test_of_refused_rows_one_reason_is_named_even_where_each_has_its_own(tmp_path: Path) -> None:
    target = tmp_path / "delta.csv"
    result = kurbel("sweep", "delta", "--eps", "2..10:0.01", "--back", "0.5", "-o", str(target))
    # The mean force is (1 + ln ε)/ε − b.
    refused = sum((1 + log(eps / 100)) / (eps / 100) <= 0.5 for eps in range(200, 1001))
    said = re.fullmatch(
        rf"kurbel: {re.escape(str(target))}: 801 rows, of which {refused} were refused and have no values;"
        r" the column reason says why, such as: back pressure b = 0.5 leaves no work at .* \(so 1 row\)\n",
        result.err,
    )
    assert said, result.err


def test_an_estimate_multiplies_only_what_grows_with_the_rows(monkeypatch: pytest.MonkeyPatch) -> None:
    # A file has all exact inputs, however few of its rows are written.
    monkeypatch.setattr(
        estimate, "_written", lambda sweep, form, batch: (900 + 8 * len(batch), 5 + len(batch))
    )
    sweep = Sweep(planned("kurbel.commands.motion:table", {"ratio": "1:3..8:0.01", "step": "0.1"}))
    found = estimate.estimated(sweep, form_of("x.parquet", None))
    assert found.writing == pytest.approx(5 + len(sweep), rel=1e-12)
    assert found.size == pytest.approx(900 + 8 * len(sweep), rel=1e-12)
