"""The columns of a sweep as Arrow has them: its schema with all that is known of each, and its batches."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from itertools import repeat
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from kurbel.sweeps.files.about import About
from kurbel.sweeps.files.decimals import decimal_type, decimals_of
from kurbel.sweeps.rows import Column, Part, Sweep

# The column that tells of a refused row why.
REASON = "reason"


def schema_of(sweep: Sweep) -> pa.Schema:
    """Return the schema of a file; each field has what is known of its column."""
    about = About.of(sweep)
    bare = bare_schema(sweep)
    fields = [bare.field(one.key).with_metadata(about.column(one)) for one in sweep.columns]
    said = json.dumps(about.file(), ensure_ascii=False)
    return pa.schema([*fields, bare.field(REASON)], metadata={"kurbel": said})


def bare_schema(sweep: Sweep) -> pa.Schema:
    """Return the names and types of the columns."""
    return pa.schema([*((one.key, _type(one)) for one in sweep.columns), (REASON, pa.string())])


def batch_of(sweep: Sweep, part: Part) -> pa.RecordBatch:
    """Return the rows of a part."""
    return _completed(sweep, part.values, _reasons(part))


def own_batch_of(sweep: Sweep, part: Part) -> pa.RecordBatch:
    """Return what was computed of a part: no option, and reasons where there are any."""
    arrays = {one.key: _array(one, part.values[one.key]) for one in sweep.columns if not one.option}
    if part.reasons:
        arrays[REASON] = _reasons(part)
    return pa.record_batch(arrays)


def with_options(sweep: Sweep, batch: pa.RecordBatch, start: int) -> pa.RecordBatch:
    """Return rows from a first one on, of which a batch has what was computed, with their options."""
    rows = batch.num_rows
    found = {name: batch[name] for name in batch.schema.names}
    reasons = found.get(REASON, pa.nulls(rows, pa.string()))
    return _completed(sweep, {**found, **sweep.varied(start, start + rows)}, reasons)


def _completed(sweep: Sweep, values: Mapping[str, Any], reasons: pa.Array) -> pa.RecordBatch:
    arrays = [_array(column, values[column.key]) for column in sweep.columns]
    return pa.record_batch([*arrays, reasons], bare_schema(sweep))


def in_groups(batches: Iterable[pa.RecordBatch], rows: int) -> Iterator[pa.RecordBatch]:
    """Yield the same rows in batches of so many, but for the last one."""
    return in_sizes(batches, repeat(rows))


def in_sizes(batches: Iterable[pa.RecordBatch], sizes: Iterator[int]) -> Iterator[pa.RecordBatch]:
    """Yield the same rows in batches of these sizes, but for the last one."""
    waiting: list[pa.RecordBatch] = []
    missing = next(sizes)
    for batch in batches:
        start = 0
        while 0 < missing <= batch.num_rows - start:
            yield _joined([*waiting, batch.slice(start, missing)])
            start, missing, waiting = start + missing, next(sizes, 0), []
        if start < batch.num_rows:
            waiting.append(batch.slice(start))
            missing -= batch.num_rows - start
    if waiting:
        yield _joined(waiting)


def _joined(batches: list[pa.RecordBatch]) -> pa.RecordBatch:
    if len(batches) == 1:
        return batches[0]
    (joined,) = pa.Table.from_batches(batches).combine_chunks().to_batches()
    return joined


def _reasons(part: Part) -> pa.Array:
    if not part.reasons:
        return pa.nulls(part.rows, pa.string())
    texts = np.full(part.rows, None, object)
    texts[[*part.reasons]] = [*part.reasons.values()]
    return pa.array(texts, pa.string())


def _type(column: Column) -> pa.DataType:
    if column.kind == "decimal":
        return decimal_type(column)
    return pa.float64() if column.kind == "number" else pa.string()


def _array(column: Column, values: Any) -> pa.Array:
    if isinstance(values, pa.Array):
        return values
    if column.kind == "decimal":
        return decimals_of(column, values)
    if column.kind == "words":
        return pa.array(values, pa.string())
    return _floats(np.ascontiguousarray(values, np.float64))


def _floats(values: NDArray[np.float64]) -> pa.Array:
    """Return floats as they lie in memory, with a null for NaN."""
    nothing = np.isnan(values)
    known = pa.py_buffer(np.packbits(~nothing, bitorder="little")) if nothing.any() else None
    return pa.Array.from_buffers(pa.float64(), len(values), [known, pa.py_buffer(values)])
