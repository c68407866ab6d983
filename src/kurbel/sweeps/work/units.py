"""What is computed at once, and has a file of its own until the sweep is whole: a part or a whole partition.

Into one file parts go one after the other, and whoever joins them encodes them. Of a folder of partitions
each is written as it stays, by whoever computes it: then nobody has more to do with more of them.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pyarrow as pa

from kurbel.sweeps.files.arrow import own_batch_of, with_options
from kurbel.sweeps.files.parquet import ROWS, write_partition
from kurbel.sweeps.work.task import Unit, computed


class Parts(Unit):
    """Parts as Arrow files, which have what was computed and no options."""

    suffix = ".arrow"

    @property
    def rows(self) -> int:
        return self.sweep.rows_at_once

    def write(self, number: int, sink: Any) -> None:
        start = number * self.rows
        part = computed(self.sweep, start, start + self.rows_of(number))
        batch = own_batch_of(self.sweep, part)
        with pa.ipc.new_file(sink, batch.schema) as writer:
            writer.write_batch(batch)


class Partitions(Unit):
    """Partitions as they stay, of what is computed fast enough that one takes some seconds."""

    suffix = ".parquet"

    @property
    def rows(self) -> int:
        return ROWS

    def write(self, number: int, sink: Any) -> None:
        write_partition(self.sweep, self._batches(number), sink)

    def _batches(self, number: int) -> Iterator[pa.RecordBatch]:
        start, size = number * self.rows, self.sweep.rows_at_once
        end = start + self.rows_of(number)
        for first in range(start, end, size):
            part = computed(self.sweep, first, min(first + size, end))
            yield with_options(self.sweep, own_batch_of(self.sweep, part), first)
