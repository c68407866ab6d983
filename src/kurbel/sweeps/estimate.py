"""What a sweep would be, before it is run: its rows, its size and its time, measured on some of them."""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass

import pyarrow as pa

from kurbel.sweeps.files.arrow import batch_of
from kurbel.sweeps.files.forms import Form
from kurbel.sweeps.rows import Sweep
from kurbel.sweeps.ways.records import TRIED

# Seconds that are spent on measuring, and rows of one measurement at the most.
PATIENCE = 1.0
LONGEST = 1 << 18
# Rows of which a file is written where each is computed alone.
WRITTEN = 256
# Forms that are arrays of their own are written by axes: eight bytes a number.
BYTES = 8


@dataclass(frozen=True)
class Estimate:
    """Seconds of computing and of writing on one core, and bytes; `refused` is the first point of the sample
    that was refused, with why."""

    rows: int
    parts: int
    computing: float
    writing: float
    size: float
    refused: tuple[str, str] | None

    def seconds(self, hands: int) -> float:
        """Return how long it takes so many: one of them writes while all compute."""
        return max(self.writing, (self.computing + self.writing) / hands)


def estimated(sweep: Sweep, form: Form) -> Estimate:
    """Return what the sweep would be as a file of a form. Writes nothing that stays."""
    seconds, rows, refused = 0.0, 0, None
    for start, stop in _samples(sweep):
        begun = time.process_time()
        part = sweep.part(start, stop)
        seconds += time.process_time() - begun
        rows += stop - start
        if part.refused and refused is None:
            row = min(part.refused)
            refused = (sweep.said(start + row), part.refused[row])
        if seconds > PATIENCE:
            break
    parts = -(-len(sweep) // sweep.rows_at_once)
    size, writing = _file(sweep, form)
    return Estimate(len(sweep), parts, seconds / rows * len(sweep), writing, size, refused)


def _samples(sweep: Sweep) -> Iterator[tuple[int, int]]:
    """Yield runs of rows spread over the sweep: single ones first, then as long as they are computed."""
    count = len(sweep)
    length = 1 if sweep.rows_at_once <= 4096 else min(count, sweep.rows_at_once, LONGEST)
    # The first of all also pays for what is loaded.
    sweep.part(0, min(length, count))
    for start in dict.fromkeys((count - length) * place // TRIED for place in range(TRIED + 1)):
        yield start, start + length


def _file(sweep: Sweep, form: Form) -> tuple[float, float]:
    """Return about how many bytes the file has, and how long it is written, by one of its first rows."""
    rows = min(len(sweep), WRITTEN if sweep.rows_at_once <= 4096 else LONGEST)
    batch = batch_of(sweep, sweep.part(0, rows))
    # What a file of no rows takes, such as the exact inputs that it has, does not grow with them.
    (bare, begin), (size, seconds) = _written(sweep, form, batch[:0]), _written(sweep, form, batch)
    factor = len(sweep) / rows
    if not form.streams and form.name != "partitions":
        size, bare = rows * BYTES * sum(column.role != "axis" for column in sweep.columns), 0
    return bare + (size - bare) * factor, begin + max(seconds - begin, 0) * factor


def _written(sweep: Sweep, form: Form, batch: pa.RecordBatch) -> tuple[float, float]:
    """Return how many bytes a file of a batch has, and how long it is written."""
    with tempfile.TemporaryDirectory() as folder:
        one = os.path.join(folder, "sample")
        plain = form if form.streams else FORMS_OF_FILES
        # The first one also pays for what is loaded.
        for _ in range(2):
            begun = time.process_time()
            plain.write(sweep, iter([batch]), one, folder)
            seconds = time.process_time() - begun
        return os.path.getsize(one), seconds


FORMS_OF_FILES = Form("parquet", (), "kurbel.sweeps.files.parquet:write")
