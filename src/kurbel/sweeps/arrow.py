"""The columns of a sweep as Arrow has them, and files of its batches one by one: CSV and Arrow's own."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from itertools import repeat
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as compute
from numpy.typing import NDArray

from kurbel.errors import OutputError
from kurbel.formats.render import whole_file
from kurbel.sweeps.about import About
from kurbel.sweeps.columns import Cells, Column, Part
from kurbel.sweeps.rows import Sweep

# The digits of the two kinds, and how many of them are to be left before the point.
SHORT, LONG, BEFORE = 38, 76, 10


def decimal_type(column: Column) -> pa.DataType:
    """Return the type of a column: 38 digits, or 76 where fewer than ten would stand before the point."""
    assert column.decimals is not None
    is_short = column.decimals + BEFORE <= SHORT
    return pa.decimal128(SHORT, column.decimals) if is_short else pa.decimal256(LONG, column.decimals)


def decimals_of(column: Column, scaled: Sequence[int | None]) -> pa.Array:
    """Return whole numbers of the last place, None where there is nothing, as decimals."""
    kind = decimal_type(column)
    width = kind.bit_width // 8
    limit = 10**kind.precision
    if any(one is not None and abs(one) >= limit for one in scaled):
        raise OutputError(
            f"{column.key} has numbers of more than {kind.precision} digits, which no file of decimals holds;"
            " ask for fewer --digits"
        )
    packed = b"".join(int(one or 0).to_bytes(width, "little", signed=True) for one in scaled)
    known = pa.array([one is not None for one in scaled], pa.bool_()).buffers()[1] if None in scaled else None
    return pa.Array.from_buffers(kind, len(scaled), [known, pa.py_buffer(packed)])


def texts_of(decimals: pa.Array) -> pa.Array:
    """Return all digits as text, also those of 0.0000001, which Arrow would write as 1E-7."""
    places = decimals.type.scale
    whole = type(decimals.type)
    kind = pa.decimal128(SHORT, 0) if whole is pa.Decimal128Type else pa.decimal256(LONG, 0)
    units = pa.Array.from_buffers(kind, len(decimals), decimals.buffers(), offset=decimals.offset)
    text = compute.cast(units, pa.string())
    if not places:
        return text
    sign = compute.if_else(compute.starts_with(text, "-"), "-", "")
    digits = compute.utf8_lpad(compute.utf8_ltrim(text, "-"), places + 1, "0")
    before = compute.utf8_slice_codeunits(digits, 0, -places)
    behind = compute.utf8_slice_codeunits(digits, -places)
    return compute.binary_join_element_wise(compute.binary_join_element_wise(sign, before, ""), behind, ".")


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


def _completed(sweep: Sweep, values: Cells, reasons: pa.Array) -> pa.RecordBatch:
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


# Rows whose text is made at once.
GROUP = 1 << 16
_SPECIAL = '[",\r\n]'


def write_csv(sweep: Sweep, batches: Iterable[pa.RecordBatch], target: str, scratch: str) -> None:
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


def write_arrow(sweep: Sweep, batches: Iterable[pa.RecordBatch], target: str, scratch: str) -> None:
    """Write all batches, in order."""
    schema = schema_of(sweep)
    with whole_file(target) as stream, pa.ipc.new_file(stream, schema) as writer:
        for batch in in_groups(batches, GROUP):
            writer.write_batch(batch)
