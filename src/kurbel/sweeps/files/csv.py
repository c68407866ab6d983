"""A sweep as CSV: commas, points, a line feed behind each line, nothing where there is nothing."""

from __future__ import annotations

from collections.abc import Iterable

import pyarrow as pa
import pyarrow.compute as compute

from kurbel.formats.render import whole_file
from kurbel.sweeps.files.arrow import in_groups, schema_of
from kurbel.sweeps.files.decimals import texts_of
from kurbel.sweeps.rows import Sweep

# Rows whose text is made at once.
GROUP = 1 << 16
_SPECIAL = '[",\r\n]'


def write(sweep: Sweep, batches: Iterable[pa.RecordBatch], target: str, scratch: str) -> None:
    """Write the names of the columns and all batches, in order."""
    with whole_file(target) as stream:
        stream.write(",".join(schema_of(sweep).names).encode() + b"\n")
        for batch in in_groups(batches, GROUP):
            stream.write(lines_of(batch))


def lines_of(batch: pa.RecordBatch) -> pa.Buffer:
    """Return the lines of a batch: the texts of an array of them lie behind each other in its memory."""
    fields = [_text(column) for column in batch.columns]
    lines = compute.binary_join_element_wise(*fields, ",", null_handling="replace")
    ended = compute.binary_join_element_wise(lines, "", "\n").cast(pa.large_string())
    return ended.buffers()[2]


def _text(column: pa.Array) -> pa.Array:
    if pa.types.is_decimal(column.type):
        return texts_of(column)
    if not pa.types.is_string(column.type):
        return column.cast(pa.string())
    inner = compute.replace_substring(column, '"', '""')
    quoted = compute.binary_join_element_wise('"', inner, '"', "")
    return compute.if_else(compute.match_substring_regex(column, _SPECIAL), quoted, column)
