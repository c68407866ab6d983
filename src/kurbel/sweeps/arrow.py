"""The columns of a sweep as Arrow has them, and files of its batches: CSV, Arrow's own, and Parquet, as one
file or in partitions."""

from __future__ import annotations

import json
import os
import re
import shutil
import stat
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from itertools import chain, islice, repeat
from typing import Any, BinaryIO

import numpy as np
import pyarrow as pa
import pyarrow.compute as compute
import pyarrow.parquet as parquet
from numpy.typing import NDArray

from kurbel.errors import OutputError
from kurbel.formats.render import whole_file
from kurbel.sweeps.about import SweepDescription
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
    about = SweepDescription.of(sweep)
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


_NAME = "whole"


@contextmanager
def whole_path(target: str, scratch: str, owned: Callable[[str], bool] | None = None) -> Iterator[str]:
    """Give a name in the folder `scratch`, beside the target, for what becomes the target in the end.

    A folder takes the place of one that is empty or `owned`: that holds nothing but what kurbel wrote.
    """
    target = os.path.realpath(target.rstrip("/" + os.sep) or target)
    half = os.path.join(scratch, _NAME)
    _removed(half)
    try:
        _check(target, owned)
        yield half
        _synced(half)
        # What was put there while this was written.
        _check(target, owned)
        if os.path.isdir(target):
            # A folder cannot be put in the place of another at once: that one first goes to the scratch.
            os.rename(target, f"{half}.old")
        os.replace(half, target)
    except OSError as error:
        raise OutputError(f"cannot write {target}: {error.strerror or error}") from error
    finally:
        _removed(half)
        _removed(f"{half}.old")


def _check(target: str, owned: Callable[[str], bool] | None) -> None:
    parent = os.path.dirname(target)
    if not os.path.isdir(parent):
        raise FileNotFoundError(2, f"the directory {parent} does not exist")
    if owned is None:
        if os.path.isdir(target):
            raise IsADirectoryError(21, "it is a directory; name a file in it")
    elif os.path.isfile(target):
        raise NotADirectoryError(20, "it is a file, and this is written as a folder")
    elif os.path.isdir(target) and os.listdir(target) and not owned(target):
        raise FileExistsError(17, "the folder has other files; name a new one")


def _removed(path: str) -> None:
    if os.path.isdir(path) and not os.path.islink(path):
        shutil.rmtree(path, ignore_errors=True)
    elif os.path.lexists(path):
        os.unlink(path)


def _synced(path: str) -> None:
    """Have what was written on the disk before it gets its name, readable to whom a new file is."""
    mask = os.umask(0)
    os.umask(mask)
    for folder, _, names in os.walk(path):
        for name in names:
            _sync(os.path.join(folder, name), mask)
    if os.path.isfile(path):
        _sync(path, mask)


def _sync(path: str, mask: int) -> None:
    with open(path, "rb+") as file:
        os.fsync(file.fileno())
    if stat.S_IMODE(os.stat(path).st_mode) != 0o666 & ~mask:
        os.chmod(path, 0o666 & ~mask)


# Rows of a row group, and row groups of a file in a folder: some hundred megabytes.
GROUP, GROUPS = 1 << 18, 64
# Rows of such a file.
ROWS = GROUP * GROUPS
_PARTITION = re.compile(r"part-\d{6,}\.parquet")


def write_parquet(sweep: Sweep, batches: Iterable[pa.RecordBatch], target: str, scratch: str) -> None:
    """Write all batches, in order, to one file."""
    with whole_file(target) as stream:
        _write(schema_of(sweep), in_groups(batches, GROUP), stream)


def write_folder(sweep: Sweep, batches: Iterable[pa.RecordBatch], target: str, scratch: str) -> None:
    """Write all batches, in order, to the files part-000000.parquet and so on of a folder."""
    # pyarrow.dataset.write_dataset takes the batches in a thread of its own, so that Ctrl-C is heard when all
    # is done; in order it takes 1.5 times as long, and holds five times the memory, 990 MiB of 4e7 rows. To
    # import it takes 0.4 s and 43 MiB.
    schema, groups = schema_of(sweep), in_groups(batches, GROUP)
    with whole_path(target, scratch, _is_ours) as folder:
        os.mkdir(folder)
        for number, files in enumerate(_parted(groups)):
            with open(os.path.join(folder, f"part-{number:06d}.parquet"), "wb") as stream:
                _write(schema, files, stream)


def write_partition(sweep: Sweep, batches: Iterable[pa.RecordBatch], stream: Any) -> None:
    """Write the batches of one file of a folder, in order."""
    _write(schema_of(sweep), in_groups(batches, GROUP), stream)


def gather(partitions: Iterable[str], target: str, scratch: str) -> None:
    """Have files, which are named in order, as the partitions of a folder; they stay where they are, too."""
    with whole_path(target, scratch, _is_ours) as folder:
        os.mkdir(folder)
        for number, path in enumerate(partitions):
            own = os.path.join(folder, f"part-{number:06d}.parquet")
            try:
                os.link(path, own)
            except OSError:
                # A file system without second names.
                shutil.copyfile(path, own)


def reasons_of(path: str, column: str) -> Iterator[pa.Array]:
    """Yield why rows of a partition were refused, and nothing of groups without such rows."""
    with parquet.ParquetFile(path) as file:
        place = file.schema_arrow.get_field_index(column)
        for group in range(file.num_row_groups):
            about = file.metadata.row_group(group).column(place)
            known = about.statistics is not None and about.statistics.has_null_count
            if not known or about.statistics.null_count < about.num_values:
                yield from file.read_row_group(group, [column])[column].chunks


def _parted(groups: Iterator[pa.RecordBatch]) -> Iterator[Iterator[pa.RecordBatch]]:
    for first in groups:
        yield chain([first], islice(groups, GROUPS - 1))


def _is_ours(folder: str) -> bool:
    return all(map(_PARTITION.fullmatch, os.listdir(folder)))


def _write(schema: pa.Schema, groups: Iterable[pa.RecordBatch], stream: BinaryIO) -> None:
    with parquet.ParquetWriter(stream, schema, **_options(schema)) as writer:
        for group in groups:
            writer.write_batch(group, row_group_size=GROUP)


def _options(schema: pa.Schema) -> dict[str, object]:
    """Return how columns are encoded.

    The bytes of floats are parted by their places, the first ones of all, then the second ones: three digits
    of neighbours are alike. This takes a fifth of the time of dictionaries, which floats fill in vain, and
    half of the room.
    """
    floats = [one.name for one in schema if pa.types.is_floating(one.type)]
    others = [one.name for one in schema if not pa.types.is_floating(one.type)]
    return {
        "compression": "zstd",
        "compression_level": 1,
        "use_dictionary": others,
        "column_encoding": dict.fromkeys(floats, "BYTE_STREAM_SPLIT"),
    }
