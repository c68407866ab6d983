"""What is said when a sweep has been written."""

from __future__ import annotations

import itertools
import re
from math import asin, degrees, log, radians, sin
from pathlib import Path

import pyarrow.parquet
import pytest
from cli import kurbel, printed
from random_sweeps import READERS


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


@pytest.mark.parametrize("form", ["parquet", "arrow"])
def test_a_refused_combination_stands_once_and_no_row_is_of_no_record(form: str, tmp_path: Path) -> None:
    # sin ψ = λ sin φ reaches 15° at λ = 1/3 in two places of the outstroke, and not at λ = 1/5.
    target = tmp_path / f"roots.{form}"
    result = kurbel("sweep", "solve", "--ratio=1:3;1:5", "--where=psi=15", "-o", str(target))
    assert f"{target}: 3 rows, of which 1 was refused and has no values" in result.err
    *found, refused = READERS[form](target)
    angle = degrees(asin(3 * sin(radians(15))))
    assert [row["phi"] for row in found] == pytest.approx([angle, 180 - angle], rel=1e-12)
    assert {(row["ratio"], row["stroke"], row["reason"]) for row in found} == {(1 / 3, "outstroke", None)}
    assert (refused["ratio"], refused["stroke"], refused["phi"]) == (1 / 5, None, None)
    assert refused["reason"].startswith("psi = 15 is reached nowhere for R:L = 1:5")


@pytest.mark.parametrize(
    ("words", "keys", "rows"),
    [
        ("delta --pump double --ratio 1:4;1:5 --columns v_min", "ratio stroke v_min reason", 6),
        ("delta --pump double;single --ratio 1:4 --columns v_min", "pump stroke v_min reason", 4),
        ("delta --pump double --ratio 1:4;3:1 --columns v_min", "ratio stroke v_min reason", 4),
        ("balance --cranks 0;90 --ratio 1:4;3:1 --columns along", "ratio residual order along reason", 5),
        ("solve --ratio 1:4;1:5 --where psi=max --columns c", "ratio stroke phi c reason", 4),
    ],
)
def test_rows_are_told_apart_by_columns(words: str, keys: str, rows: int) -> None:
    found = kurbel("sweep", *words.split(), "-f", "csv", "-o", "-").records()
    assert [*found[0]] == keys.split()
    assert len({tuple(row[key] for key in keys.split()[:-2]) for row in found}) == len(found) == rows


def test_rows_beyond_a_stroke_are_of_no_stroke_in_names_and_columns(tmp_path: Path) -> None:
    target = tmp_path / "turn.parquet"
    for angles in ("--angle=30;240", "--to=360"):
        kurbel("sweep", "table", "--ratio=1:4;1:5", angles, "-o", str(target))
        schema = pyarrow.parquet.read_schema(target)
        assert schema.names == ["ratio", "phi", "x", "c", "p", "reason"]
        assert schema.field("x").metadata[b"name"] == b"Piston path"
    kurbel("sweep", "table", "--ratio=1:4;1:5", "--step=90", "-o", str(target))
    table = pyarrow.parquet.read_table(target)
    assert (table.num_rows, max(table["phi"].to_pylist())) == (6, 180)
    assert "x_return" in table.column_names


@pytest.mark.parametrize("name", ["x.parquet", "x.arrow", "x.csv", "x.nc"])
def test_an_estimate_multiplies_only_what_grows_with_the_rows(name: str, tmp_path: Path) -> None:
    """A file has all exact inputs, however few of its rows are written."""
    target = tmp_path / name
    words = ("sweep", "table", "--ratio=1:3..8:0.05", "--step=1", "-o", str(target))
    said = kurbel(*words, "--dry-run").out.splitlines()
    kurbel(*words)
    told = {line.split()[0]: line.split(maxsplit=1)[1] for line in said}
    number, unit = re.match(r"(?:about )?([\d.]+) (\w+)", told["size"]).groups()  # type: ignore[union-attr]
    estimated = float(number) * {"bytes": 1, "kB": 1e3, "MB": 1e6, "GB": 1e9}[unit]
    assert estimated == pytest.approx(target.stat().st_size, rel=0.3)


@pytest.mark.parametrize(
    ("free", "count", "said"),
    [
        (0, 2, "3 seconds on 1 core"),
        (0, 600, "5 minutes on 2 cores"),
        (0, 36000, "3.3 hours on 3 cores"),
        (0, 300_000, "1.2 days on 3 cores"),
        # Where rows take no time, one core writes and the others wait.
        (2 * 5, 600, "1 seconds on 2 cores"),
        (999, 600, "less than a second on 2 cores"),
    ],
)
def test_a_sweep_takes_as_long_as_its_sample_times_its_rows(
    free: int, count: int, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Behind the free ones, whatever is measured takes a second: each of five rows, until that is enough, and
    # the file to be written.
    seconds = (max(0, number - free) for number in itertools.count())
    monkeypatch.setattr("time.process_time", lambda: next(seconds))
    monkeypatch.setattr("kurbel.cli.sweep_command.cores", lambda: 3)
    monkeypatch.setattr("kurbel.sweeps.run.TRIED", 4)
    monkeypatch.setattr("kurbel.sweeps.run.WRITTEN", 8)
    words = ["flywheel", "--eps=3", "--ratio=1:5", "--delta=1:50", "--power=50kW", "--dry-run"]
    shown = printed("sweep", *words, f"--speed=1..{count}:1/min").out.splitlines()
    assert f"time     about {said}, measured on a sample" in shown
