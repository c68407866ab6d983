"""A sweep in one Parquet file, whole or not at all."""

from __future__ import annotations

from collections.abc import Iterable

import pyarrow as pa
import pyarrow.parquet as parquet

from kurbel.formats.render import whole_file
from kurbel.sweeps.files.arrow import schema_of
from kurbel.sweeps.rows import Sweep


def write(sweep: Sweep, batches: Iterable[pa.RecordBatch], target: str) -> None:
    """Write all batches, in order."""
    with whole_file(target) as stream, parquet.ParquetWriter(stream, schema_of(sweep)) as writer:
        for batch in batches:
            writer.write_batch(batch)
