"""A sweep as Parquet: one file, or a folder of files that programs read as one."""

from __future__ import annotations

import os
import re
import shutil
import stat
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from itertools import chain, islice
from typing import Any, BinaryIO

import pyarrow as pa
import pyarrow.parquet as parquet

from kurbel.errors import OutputError
from kurbel.formats.render import whole_file
from kurbel.sweeps.arrow import in_groups, schema_of
from kurbel.sweeps.rows import Sweep

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


def write(sweep: Sweep, batches: Iterable[pa.RecordBatch], target: str, scratch: str) -> None:
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
