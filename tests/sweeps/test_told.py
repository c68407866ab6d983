"""What is said when a sweep has been written."""

from __future__ import annotations

import re
from math import log
from pathlib import Path

from cli import kurbel


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
