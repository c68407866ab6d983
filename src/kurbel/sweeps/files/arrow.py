"""The columns of a sweep as Arrow has them: its schema with all that is known of each, and its batches."""

from __future__ import annotations

from typing import Any

import pyarrow as pa

from kurbel.sweeps.rows import Column, Part, Sweep

# The column that tells of a refused row why.
REASON = "reason"


def schema_of(sweep: Sweep) -> pa.Schema:
    """Return the schema; each field has what is known of its column."""
    return pa.schema([*map(_field, sweep.columns), pa.field(REASON, pa.string())])


def batch_of(sweep: Sweep, part: Part) -> pa.RecordBatch:
    """Return the rows of a part."""
    arrays = [_array(column, part.values[column.key]) for column in sweep.columns]
    reasons = pa.array([part.reasons.get(row) for row in range(part.rows)], pa.string())
    return pa.record_batch([*arrays, reasons], schema_of(sweep))


def _field(column: Column) -> pa.Field:
    about = {name: text for name in ("name", "symbol", "unit") if (text := getattr(column, name))}
    return pa.field(column.key, _type(column), metadata=about)


def _type(column: Column) -> pa.DataType:
    return pa.float64() if column.kind == "number" else pa.string()


def _array(column: Column, values: Any) -> pa.Array:
    return pa.array(values, _type(column), from_pandas=True)
