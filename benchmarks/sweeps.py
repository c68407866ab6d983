"""Sweeps as whole commands, beside loops and beside pyarrow, which writes the same columns ready-made."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from tempfile import TemporaryDirectory
from typing import Any

from benchmarks.race import ALONE, ENVIRONMENT, KURBEL, Race, Row, Run, Task, kurbel

READY = "pyarrow writing these columns ready-made"
# Rows that pyarrow has in memory and writes again and again.
SOME = 10**6
OF_MOTION = "--angle 0..359.9964:0.0036 --columns x,c,p"
OF_ENGINES = "--ratio 1:3..7.995:0.005"
COMMAND, RATIOS = "harmonics", "1:3..8:0.01"
LOOPED = 10


def ready_made(words: str, rows: int, own: bool) -> Run:
    """Write columns as often as it takes for so many rows, in kurbel's encoding or in pyarrow's own.

    The columns are those that kurbel wrote for a smaller sweep.
    """
    import pyarrow.parquet as parquet

    with TemporaryDirectory() as folder:
        name = os.path.join(folder, "ready.parquet")
        subprocess.run([KURBEL, *words.split(), "-o", name], check=True, env=ENVIRONMENT, capture_output=True)
        table = parquet.read_table(name).combine_chunks()
    options = {} if own else _encoding(table.schema)

    def write() -> None:
        with TemporaryDirectory() as folder:
            name = os.path.join(folder, "written.parquet")
            with parquet.ParquetWriter(name, table.schema, **options) as writer:
                for _ in range(rows // len(table)):
                    writer.write_table(table)

    return write


def _encoding(schema: Any) -> dict[str, Any]:
    import pyarrow

    floats = [one.name for one in schema if pyarrow.types.is_floating(one.type)]
    return {
        "compression": "zstd",
        "compression_level": 1,
        "use_dictionary": [one.name for one in schema if one.name not in floats],
        "column_encoding": dict.fromkeys(floats, "BYTE_STREAM_SPLIT"),
    }


def loop_of_shell() -> Run:
    """Start the command once for each of some ratios."""
    words = [
        [KURBEL, COMMAND, "--ratio", f"1:{3 + number / 100:.2f}", "-f", "csv"] for number in range(LOOPED)
    ]
    return lambda: [subprocess.run(one, check=True, env=ENVIRONMENT, capture_output=True) for one in words]


def loop_of_python() -> Run:
    """Ask the function once for each of some ratios, and print its records."""
    import kurbel as library

    ratios = [f"1:{3 + number / 100:.2f}" for number in range(LOOPED)]
    return lambda: [library.harmonics(one).typeset("csv") for one in ratios]


def races(quick: bool) -> Iterator[Race]:
    yield _of_motion(100 if quick else 1000, *(("10⁷", "10⁶") if quick else ("10⁸", "10⁷")))
    yield _of_engines(100 if quick else 1000, "10⁵" if quick else "10⁶")
    yield _of_combinations()


def _of_motion(ratios: int, told: str, fewer: str) -> Race:
    def words(count: int) -> str:
        return f"sweep table --ratio 0.2..{0.2 + (count - 1) / 10000:.4f}:0.0001 {OF_MOTION}"

    rows, some = ratios * 100_000, words(SOME // 100_000)
    what = f"`kurbel sweep table`, {told} rows of x, c and p to Parquet"
    own, few = "pyarrow so, as it comes (dictionaries, snappy)", f"kurbel, {fewer} rows"
    return Race(
        {
            "kurbel": kurbel(f"{words(ratios)} -o motion.parquet"),
            ALONE: kurbel(f"{words(ratios)} -o motion.parquet", cores=1),
            few: kurbel(f"{words(ratios // 10)} -o motion.parquet"),
            READY: Task(ready_made, (some, rows, False)),
            own: Task(ready_made, (some, rows, True)),
        },
        [
            Row(what, "kurbel", READY, 2.2, rows),
            Row(what, "kurbel", own, times=rows),
            Row(what, "kurbel", ALONE, times=rows),
            Row(what, "kurbel", few, times=rows, its_times=rows // 10),
            Row(f"{what}: peak of memory", "kurbel", "1 GiB", 1, limit=1024),
        ],
        rounds=2,
    )


def _of_engines(expansions: int, told: str) -> Race:
    words = f"sweep delta --eps 1.01..{1.01 + (expansions - 1) / 100:.2f}:0.01 {OF_ENGINES}"
    rows = expansions * 1000
    what = f"`kurbel sweep delta`, {told} engines to Parquet"
    return Race(
        {"kurbel": kurbel(f"{words} -o delta.parquet"), READY: Task(ready_made, (words, rows, False))},
        [Row(what, "kurbel", READY, times=rows)],
        rounds=2,
    )


def _of_combinations() -> Race:
    words = f"sweep {COMMAND} --ratio {RATIOS}"
    python, shell = "a loop in Python over the same function", "a loop of the shell over the command"
    return Race(
        {
            "kurbel": kurbel(f"{words} -o harmonics.parquet"),
            ALONE: kurbel(f"{words} -o harmonics.parquet", cores=1),
            python: Task(loop_of_python, share=LOOPED / 501),
            shell: Task(loop_of_shell, share=LOOPED / 501),
        },
        [
            Row(f"`kurbel {words}`, 501 combinations", "kurbel", one, times=501)
            for one in (python, shell, ALONE)
        ],
        rounds=2,
    )
