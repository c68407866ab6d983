"""A table as CSV, a million rows of four columns to six decimals: kurbel beside its peers, in one run.

Every writer runs in a process of its own, which also tells its peak memory beyond the table itself. All
start from float64 columns; kurbel alone says which digits are doubtful.
Run: python benchmarks/bench_csv.py [number of rows]
"""

from __future__ import annotations

import io
import resource
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from numpy.typing import NDArray

REPEATS = 5
DECIMALS = 6
Columns = list[NDArray[np.float64]]
Writer = Callable[[], bytes]


def save_table(rows: str, path: str) -> None:
    from kurbel.kernel import kinematics
    from kurbel.kernel.circle import circle

    angles = np.linspace(0, 360, int(rows))
    point = circle(angles)
    formulas = (kinematics.piston_path, kinematics.piston_velocity, kinematics.piston_acceleration)
    np.save(path, np.stack([angles, *(formula(point, 0.2345) for formula in formulas)]))


def kurbel(columns: Columns) -> Writer:
    from kurbel.exact.bulk import nearest
    from kurbel.formats.columns import CHUNK, Scaled, csv_lines

    def chunk(start: int) -> bytes:
        rounded = [nearest(column[start : start + CHUNK], DECIMALS, 1e-15)[0] for column in columns]
        return csv_lines([Scaled(scaled, DECIMALS) for scaled in rounded], b",")

    return lambda: b"".join(chunk(start) for start in range(0, len(columns[0]), CHUNK))


def with_polars(columns: Columns) -> Writer:
    frame = import_module("polars").DataFrame({str(place): column for place, column in enumerate(columns)})
    return lambda: _to_bytes(lambda sink: frame.write_csv(sink, float_precision=DECIMALS))


def with_pyarrow(columns: Columns) -> Writer:
    # Arrow's CSV writer takes no number of decimals; it prints the shortest digits that restore the float.
    csv, pyarrow = import_module("pyarrow.csv"), import_module("pyarrow")
    arrow = pyarrow.table({str(place): column.round(DECIMALS) for place, column in enumerate(columns)})
    return lambda: _to_bytes(lambda sink: csv.write_csv(arrow, sink))


def with_pandas(columns: Columns) -> Writer:
    frame = import_module("pandas").DataFrame({str(place): column for place, column in enumerate(columns)})
    return lambda: str(frame.to_csv(index=False, float_format=f"%.{DECIMALS}f")).encode()


def f_strings(columns: Columns) -> Writer:
    def text() -> bytes:
        rows = zip(*(column.tolist() for column in columns), strict=True)
        return "".join(f"{a:.6f},{b:.6f},{c:.6f},{d:.6f}\n" for a, b, c, d in rows).encode()

    return text


def _to_bytes(write: Callable[[io.BytesIO], Any]) -> bytes:
    sink = io.BytesIO()
    write(sink)
    return sink.getvalue()


# Name, what must be installed, writer.
CONTESTANTS: dict[str, tuple[str, Callable[[Columns], Writer]]] = {
    "polars": ("polars", with_polars),
    "pyarrow": ("pyarrow", with_pyarrow),
    "f-strings": ("kurbel", f_strings),
    "pandas": ("pandas", with_pandas),
    "kurbel": ("kurbel", kurbel),
}


def measure(name: str, path: str) -> None:
    """Print the median milliseconds, the bytes written, and the peak memory in MiB beyond the table."""
    # The table comes from a file: computing it here would leave a peak of its own.
    write = CONTESTANTS[name][1](list(np.load(path)))
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    seconds = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        size = len(write())
        seconds.append(time.perf_counter() - start)
    peak = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024
    print(statistics.median(seconds) * 1e3, size, peak)


def child(*arguments: str) -> str:
    # A child inherits the peak of its parent, which must therefore stay small.
    command = [sys.executable, __file__, *arguments]
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout


def compare(path: str) -> None:
    base = None
    for name, (package, _) in CONTESTANTS.items():
        if not find_spec(package):
            print(f"  {name:10} not installed")
            continue
        milliseconds, size, peak = map(float, child("--measure", name, path).split())
        base = base or milliseconds
        share = milliseconds / base
        print(f"  {name:10} {milliseconds:6.0f} ms {share:6.2f} x {size / 1e6:6.1f} MB {peak:6.0f} MiB peak")


JOBS: dict[str, Callable[..., None]] = {"--save": save_table, "--measure": measure}


def main() -> None:
    if sys.argv[1:] and sys.argv[1] in JOBS:
        return JOBS[sys.argv[1]](*sys.argv[2:])
    rows = int(float(sys.argv[1])) if len(sys.argv) > 1 else 10**6
    print(f"{rows:,} rows of 4 columns, {DECIMALS} decimals (peak: output included, table and libraries not)")
    with TemporaryDirectory() as folder:
        path = str(Path(folder) / "table.npy")
        child("--save", str(rows), path)
        compare(path)


if __name__ == "__main__":
    main()
