"""A sweep in one Parquet file, whole or not at all."""

from __future__ import annotations

import pyarrow.parquet as parquet

from kurbel.formats.render import whole_file
from kurbel.sweeps.files.arrow import batch_of, schema_of
from kurbel.sweeps.rows import Sweep


def write(sweep: Sweep, target: str) -> None:
    """Write all rows, part by part."""
    with whole_file(target) as stream, parquet.ParquetWriter(stream, schema_of(sweep)) as writer:
        for start in range(0, len(sweep), sweep.rows_at_once):
            part = sweep.part(start, min(start + sweep.rows_at_once, len(sweep)))
            writer.write_batch(batch_of(sweep, part))
