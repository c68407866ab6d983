"""A table as CSV, a million rows of four columns to six decimals: kurbel beside its peers.

All start from float64 columns; kurbel alone says which digits are doubtful.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from benchmarks.race import Contestant, Race, Row, Run, Task

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Columns = list[NDArray[np.float64]]

DECIMALS = 6


def table(rows: int) -> Columns:
    """Return an angle and x, c and p at it."""
    import numpy as np

    import kurbel

    angles = np.linspace(0, 360, rows)
    return [angles, *kurbel.compute(angles, 0.2345).values()]


def by_kurbel(rows: int) -> Run:
    from kurbel.exact.bulk import nearest
    from kurbel.formats.columns import CHUNK, Scaled, csv_lines

    columns = table(rows)

    def chunk(start: int) -> bytes:
        rounded = [nearest(column[start : start + CHUNK], DECIMALS, 1e-15)[0] for column in columns]
        return csv_lines([Scaled(scaled, DECIMALS) for scaled in rounded], b",")

    return lambda: b"".join(chunk(start) for start in range(0, rows, CHUNK))


def by_polars(rows: int) -> Run:
    import polars

    frame = polars.DataFrame({str(place): column for place, column in enumerate(table(rows))})
    return lambda: _to_bytes(lambda sink: frame.write_csv(sink, float_precision=DECIMALS))


def by_pyarrow(rows: int) -> Run:
    # Arrow's CSV writer takes no number of decimals; it prints the shortest digits that restore the float.
    import pyarrow
    from pyarrow import csv

    arrow = pyarrow.table({str(place): column.round(DECIMALS) for place, column in enumerate(table(rows))})
    return lambda: _to_bytes(lambda sink: csv.write_csv(arrow, sink))


def by_pandas(rows: int) -> Run:
    import pandas

    frame = pandas.DataFrame({str(place): column for place, column in enumerate(table(rows))})
    return lambda: str(frame.to_csv(index=False, float_format=f"%.{DECIMALS}f")).encode()


def by_f_strings(rows: int) -> Run:
    columns = table(rows)

    def text() -> bytes:
        lines = zip(*(column.tolist() for column in columns), strict=True)
        return "".join(f"{a:.6f},{b:.6f},{c:.6f},{d:.6f}\n" for a, b, c, d in lines).encode()

    return text


def _to_bytes(write: Callable[[io.BytesIO], Any]) -> bytes:
    sink = io.BytesIO()
    write(sink)
    return sink.getvalue()


PEERS = {
    "polars": by_polars, "pyarrow": by_pyarrow, "f-strings": by_f_strings, "pandas": by_pandas,
}  # fmt: skip


def races(quick: bool) -> Iterator[Race]:
    rows, told = (10**5, "10⁵") if quick else (10**6, "10⁶")
    needs = {"f-strings": ""}
    peers = {name: Task(peer, (rows,), needs=needs.get(name, name)) for name, peer in PEERS.items()}
    contestants: dict[str, Contestant] = {**peers, "kurbel": Task(by_kurbel, (rows,))}
    what = f"CSV of {told} rows, 4 columns to {DECIMALS} decimals"
    aims = {"polars": 0.7}
    yield Race(contestants, [Row(what, "kurbel", name, aims.get(name), rows) for name in PEERS], rounds=3)
