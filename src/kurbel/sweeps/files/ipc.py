"""A sweep as an Arrow file, whose columns a program maps into memory as they lie."""

from __future__ import annotations

from collections.abc import Iterable

import pyarrow as pa

from kurbel.formats.render import whole_file
from kurbel.sweeps.files.arrow import in_groups, schema_of
from kurbel.sweeps.rows import Sweep

# Rows of a batch.
GROUP = 1 << 16


def write(sweep: Sweep, batches: Iterable[pa.RecordBatch], target: str, scratch: str) -> None:
    """Write all batches, in order."""
    schema = schema_of(sweep)
    with whole_file(target) as stream, pa.ipc.new_file(stream, schema) as writer:
        for batch in in_groups(batches, GROUP):
            writer.write_batch(batch)
