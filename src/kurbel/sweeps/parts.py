"""The parts of a sweep: made in a thread, in another process or on another machine, and joined to the target.

Into one file parts go one after the other, and whoever joins them encodes them. Of a folder of partitions
each is written as it stays, by whoever computes it: then nobody has more to do with more of them.
"""

from __future__ import annotations

import os
import zlib
from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from io import FileIO
from pkgutil import resolve_name
from typing import TYPE_CHECKING, ClassVar, NamedTuple

import pyarrow as pa
import pyarrow.compute as compute

from kurbel.errors import ChoiceError, OutputError
from kurbel.reading.environment import need
from kurbel.reading.given import allowed_name
from kurbel.sweeps.arrow import REASON, ROWS, gather, own_batch_of, reasons_of, with_options, write_partition
from kurbel.sweeps.columns import MISSING
from kurbel.sweeps.rows import Sweep

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer


class Form(NamedTuple):
    """A form of files.

    `writer` is the place of the function that takes a sweep, its batches in order, the target, and a folder
    beside it for what is half written. `refuse` is that of the function that raises KurbelError for a sweep
    which such a file cannot hold. What `streams` can go to standard output; `needs` are the libraries that
    must be there. Arrays have rows `in_places`, also those that belong to no record.
    """

    name: str
    suffixes: tuple[str, ...]
    writer: str
    refuse: str = ""
    streams: bool = True
    needs: tuple[str, ...] = ("pyarrow",)
    in_places: bool = False

    def check(self, sweep: Sweep, target: str) -> None:
        """Raise KurbelError for a sweep or a target that cannot become such a file."""
        need(f"A file of columns ({self.name})", "scale", *self.needs)
        if not self.streams and (target == "-" or is_device(target)):
            raise OutputError(f"{self.name} cannot be written to {target}; name a file or a folder")
        if self.refuse:
            check: Callable[[Sweep], None] = resolve_name(self.refuse)
            check(sweep)

    def write(self, sweep: Sweep, batches: Iterable[pa.RecordBatch], target: str, scratch: str) -> None:
        """Write the batches, in order, to the target, whole or not at all. Raises KurbelError."""
        writer: Callable[..., None] = resolve_name(self.writer)
        writer(sweep, batches, target, scratch)


_HERE = "kurbel.sweeps"
_NETCDF, _ZARR = ("pyarrow", "h5netcdf", "h5py"), ("pyarrow", "zarr")
PARTITIONS = Form("partitions", ("/",), f"{_HERE}.arrow:write_folder", streams=False)
FORMS = (
    Form("parquet", (".parquet", ".pq"), f"{_HERE}.arrow:write_parquet"),
    PARTITIONS,
    Form("arrow", (".arrow", ".feather"), f"{_HERE}.arrow:write_arrow"),
    Form("csv", (".csv",), f"{_HERE}.arrow:write_csv"),
    Form("netcdf", (".nc",), f"{_HERE}.stores:write_netcdf", f"{_HERE}.grid:refuse", False, _NETCDF, True),
    Form("zarr", (".zarr",), f"{_HERE}.stores:write_zarr", f"{_HERE}.grid:refuse", False, _ZARR, True),
)
_KNOWN = ".parquet, .arrow, .feather, .csv, .nc, .zarr, or a folder such as delta/ for Parquet in partitions"


def form_of(target: str, name: str | None = None) -> Form:
    """Return the form of a file by its suffix, or by its name. Raises ChoiceError."""
    if name:
        known = {form.name: form for form in FORMS}
        form = known[allowed_name(name, known, "format")]
        return PARTITIONS if form.name == "parquet" and _is_folder(target) else form
    if _is_folder(target):
        return PARTITIONS
    if target == "-":
        raise ChoiceError("standard output has no suffix; say the format by -f parquet, arrow or csv")
    for form in FORMS:
        if target.rstrip("/" + os.sep).lower().endswith(form.suffixes):
            return form
    if os.path.isdir(target):
        return PARTITIONS
    suffix = os.path.splitext(target)[1]
    raise ChoiceError(f"{suffix or target[-40:]} is no form of columns; name a file with {_KNOWN}")


def _is_folder(target: str) -> bool:
    # One whose suffix says so is a Zarr.
    return target.endswith(("/", os.sep)) and not target.rstrip("/" + os.sep).lower().endswith(".zarr")


def is_device(target: str) -> bool:
    """Whether there is something that is neither a file nor a folder."""
    return os.path.exists(target) and not os.path.isfile(target) and not os.path.isdir(target)


# The parts of a folder: as many files as every file system likes.
IN_A_FOLDER = 1000
# Bytes that are read at once.
AT_ONCE = 1 << 20


class Place(NamedTuple):
    """Where parts are to lie: a folder, and a file beside it with a word that no other folder has."""

    folder: str
    mark: str
    word: str

    @property
    def is_here(self) -> bool:
        """Whether this process sees the same folder as the one that named it."""
        try:
            with open(self.mark, encoding="ascii") as file:
                return file.read() == self.word
        except (OSError, UnicodeError):
            return False


@dataclass(frozen=True)
class Unit(ABC):
    """Rows of a sweep that are computed at once, and how they are written to a file of a suffix."""

    sweep: Sweep
    suffix: ClassVar[str]

    @property
    @abstractmethod
    def rows(self) -> int:
        """How many rows it has; the last one may have fewer."""

    @abstractmethod
    def write(self, number: int, sink: object) -> None:
        """Write the rows of a number."""

    @property
    def count(self) -> int:
        """How many there are in the sweep."""
        return -(-len(self.sweep) // self.rows)

    def rows_of(self, number: int) -> int:
        return min(self.rows, len(self.sweep) - number * self.rows)


def made(unit: Unit, place: Place, number: int) -> str | bytes:
    """Make a part and return the name of its file; where the folder cannot be seen, its content."""
    if place.is_here:
        return _kept(partial(unit.write, number), number, place.folder, unit.suffix)
    sink = pa.BufferOutputStream()
    unit.write(number, sink)
    return memoryview(sink.getvalue()).tobytes()


def kept(content: bytes, number: int, folder: str, suffix: str) -> str:
    """Keep a part that came from another machine, and return its name."""
    return _kept(lambda file: file.write(content), number, folder, suffix)


class _Summed:
    """A file and the sum of what was written to it, as arrays lie in memory and without a copy of them."""

    closed = False

    def __init__(self, path: str) -> None:
        self.file = FileIO(path, "wb")
        self.sum = 0

    def write(self, content: ReadableBuffer) -> int:
        self.sum = zlib.crc32(content, self.sum)
        left = memoryview(content).cast("B")
        size = len(left)
        while left:
            # At once a system writes two gigabytes at the most.
            left = left[self.file.write(left) :]
        return size

    def flush(self) -> None:
        """All is written as it comes."""


def _kept(write: Callable[[_Summed], object], number: int, folder: str, suffix: str) -> str:
    """Write a part, whole or not at all, and return its name, which tells whether it is still whole."""
    begin = f"{subfolder(number)}/{number:012d}"
    # Not the folders above: if they are gone, the run has ended.
    with suppress(FileExistsError):
        os.mkdir(os.path.join(folder, subfolder(number)))
    part = os.path.join(folder, f"{begin}.{os.urandom(6).hex()}")
    try:
        into = _Summed(part)
        with into.file:
            write(into)
        name = f"{begin}.{into.sum:08x}{suffix}"
        os.replace(part, os.path.join(folder, name))
    except BaseException:
        with suppress(OSError):
            os.unlink(part)
        raise
    return name


def subfolder(number: int) -> str:
    """Return the folder that a part lies in."""
    return f"{number // IN_A_FOLDER:09d}"


def is_whole(path: str) -> bool:
    """Tell whether a part is what was written: a machine that lost its power may have kept less of it."""
    found = 0
    with open(path, "rb") as file:
        while content := file.read(AT_ONCE):
            found = zlib.crc32(content, found)
    return f"{found:08x}" == path.split(".")[-2]


class Parts(Unit):
    """Parts as Arrow files, which have what was computed and no options."""

    suffix = ".arrow"

    @property
    def rows(self) -> int:
        return self.sweep.rows_at_once

    def write(self, number: int, sink: object) -> None:
        start = number * self.rows
        part = self.sweep.computed(start, start + self.rows_of(number))
        batch = own_batch_of(self.sweep, part)
        with pa.ipc.new_file(sink, batch.schema) as writer:
            writer.write_batch(batch)


class Partitions(Unit):
    """Partitions as they stay, of what is computed fast enough that one takes some seconds."""

    suffix = ".parquet"

    @property
    def rows(self) -> int:
        return ROWS

    def write(self, number: int, sink: object) -> None:
        write_partition(self.sweep, self._batches(number), sink)

    def _batches(self, number: int) -> Iterator[pa.RecordBatch]:
        start, size = number * self.rows, self.sweep.rows_at_once
        end = start + self.rows_of(number)
        for first in range(start, end, size):
            part = self.sweep.computed(first, min(first + size, end))
            yield with_options(self.sweep, own_batch_of(self.sweep, part), first)


# Of so many kinds of refused rows is told how many there are of each, of all others together.
MOST_REASONS = 100
OTHERS = "other reasons"


def unit_of(sweep: Sweep, form: Form) -> Unit:
    """Return what is computed at once, which depends on the plan and the form alone."""
    return Partitions(sweep) if form is PARTITIONS and sweep.in_threads else Parts(sweep)


def joined(
    unit: Unit, form: Form, paths: Iterator[str], target: str, scratch: str, refused: Counter[str]
) -> int:
    """Write the target of the files of all units, in order, and count what was refused; return how many rows
    it has. Only a form of arrays has places for records that are not there."""
    if unit.suffix == Partitions.suffix:
        gather(_noted(paths, refused), target, scratch)
        return len(unit.sweep)
    rows = 0

    def batches() -> Iterator[pa.RecordBatch]:
        nonlocal rows
        for batch in _batches(unit, paths, refused):
            found = batch if form.in_places else _there(unit.sweep, batch)
            rows += found.num_rows
            yield found

    form.write(unit.sweep, batches(), target, scratch)
    return rows


def _there(sweep: Sweep, batch: pa.RecordBatch) -> pa.RecordBatch:
    """Return the rows without those that belong to no record; a refused combination has nothing that tells
    records apart."""
    reasons = batch[REASON]
    if reasons.null_count == len(reasons):
        return batch
    there = compute.fill_null(compute.not_equal(reasons, MISSING), True)
    refused = reasons.is_valid()
    for place, column in enumerate(sweep.columns):
        if column.role == "axis" and not column.option:
            known = compute.if_else(refused, None, batch.column(place))
            batch = batch.set_column(place, batch.schema.field(place), known)
    return batch.filter(there)


def _noted(paths: Iterator[str], refused: Counter[str]) -> Iterator[str]:
    for path in paths:
        _count(reasons_of(path, REASON), refused)
        yield path


def _batches(unit: Unit, paths: Iterator[str], refused: Counter[str]) -> Iterator[pa.RecordBatch]:
    for number, path in enumerate(paths):
        with pa.memory_map(path) as file:
            batch = pa.ipc.open_file(file).get_batch(0)
            if REASON in batch.schema.names:
                _count([batch[REASON]], refused)
            yield with_options(unit.sweep, batch, number * unit.rows)


def _count(reasons: Iterable[pa.Array], refused: Counter[str]) -> None:
    for some in reasons:
        for one in compute.value_counts(some.filter(compute.not_equal(some, MISSING))):
            reason = one["values"].as_py()
            known = reason in refused or len(refused) < MOST_REASONS
            refused[reason if known else OTHERS] += one["counts"].as_py()
