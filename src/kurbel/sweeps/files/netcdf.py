"""A sweep as NetCDF-4: arrays over the axes, described by the conventions for climate and forecast data."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from io import FileIO
from typing import TYPE_CHECKING, Any

import h5netcdf
import h5py
import numpy as np

from kurbel.sweeps.files.grid import Array, fill
from kurbel.sweeps.files.whole import whole_path
from kurbel.sweeps.rows import Sweep

if TYPE_CHECKING:
    import pyarrow as pa

# What is longer has no room in an attribute, and becomes a variable without dimensions.
LONGEST = 60_000
_TYPES = {"number": np.dtype("f8"), "whole": np.dtype("i4"), "words": h5py.string_dtype()}
_EMPTY = {"number": np.nan, "whole": None, "words": None}
_PACKED: Mapping[str, Any] = {"compression": "gzip", "compression_opts": 1, "shuffle": True}


def write(sweep: Sweep, batches: Iterable[pa.RecordBatch], target: str, scratch: str) -> None:
    """Write all batches, in order."""
    with whole_path(target, scratch) as path, _Disk(path) as disk:
        with h5netcdf.File(disk, "w") as file:
            fill(sweep, _while_sound(batches, disk), _File(file))
        disk.check()


class _Disk(FileIO):
    """A file whose first error waits until it is asked for: HDF5 cannot close a file that refuses what it
    writes, and ends in another error."""

    def __init__(self, path: str) -> None:
        super().__init__(path, "w+")
        self._error: OSError | None = None

    def write(self, content: Any) -> int:
        left = memoryview(content).cast("B")
        size = len(left)
        with self._remembered():
            while left and self._error is None:
                left = left[super().write(left) :]
        return size

    def truncate(self, size: int | None = None) -> int:
        with self._remembered():
            if self._error is None:
                super().truncate(size)
        return size or 0

    def flush(self) -> None:
        """All is written as it comes."""

    @contextmanager
    def _remembered(self) -> Iterator[None]:
        try:
            yield
        except OSError as error:
            self._error = self._error or error

    def check(self) -> None:
        if self._error is not None:
            raise self._error


def _while_sound(batches: Iterable[pa.RecordBatch], disk: _Disk) -> Iterator[pa.RecordBatch]:
    for batch in batches:
        disk.check()
        yield batch


class _File:
    def __init__(self, file: Any) -> None:
        self._file = file

    def create(self, array: Array) -> Any:
        for dim, size in zip(array.dims, array.sizes, strict=True):
            if dim not in self._file.dimensions:
                self._file.dimensions[dim] = size
        packed = _PACKED if array.dims and array.kind != "words" else {}
        variable = self._file.create_variable(
            array.key,
            array.dims,
            _TYPES[array.kind],
            chunks=array.chunks or None,
            fillvalue=_EMPTY[array.kind],
            **packed,
        )
        variable.attrs.update(array.attributes)
        return variable

    def describe(self, attributes: Mapping[str, Any]) -> None:
        for name, text in attributes.items():
            if len(text.encode()) <= LONGEST:
                self._file.attrs[name] = text
            else:
                self._file.create_variable(name, (), h5py.string_dtype())[...] = text

    def flags(self, key: str, attributes: Mapping[str, Any]) -> None:
        self._file.variables[key].attrs.update(attributes)
