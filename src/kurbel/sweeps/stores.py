"""A sweep as NetCDF-4, or as a Zarr, a folder of arrays, each chunk a file of its own."""

from __future__ import annotations

import json
import os
import re
import warnings
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from io import FileIO
from itertools import chain
from typing import TYPE_CHECKING, Any

import numpy as np

from kurbel.sweeps.arrow import whole_path
from kurbel.sweeps.grid import Array, fill
from kurbel.sweeps.rows import Sweep

if TYPE_CHECKING:
    import h5netcdf
    import pyarrow as pa
    from _typeshed import ReadableBuffer

# What is longer has no room in an attribute, and becomes a variable without dimensions.
LONGEST = 60_000
_NUMBERS = {"number": np.dtype("f8"), "whole": np.dtype("i4")}
_NOTHING = {"number": np.nan, "whole": None, "words": None}
_PACKED: Mapping[str, object] = {"compression": "gzip", "compression_opts": 1, "shuffle": True}


def write_netcdf(sweep: Sweep, batches: Iterable[pa.RecordBatch], target: str, scratch: str) -> None:
    """Write all batches, in order, as arrays that the conventions for climate and forecast data describe."""
    import h5netcdf
    from h5py import string_dtype

    with whole_path(target, scratch) as path, _Disk(path) as disk:
        with h5netcdf.File(disk, "w") as file:
            fill(sweep, _while_sound(batches, disk), _File(file, string_dtype()))
        disk.check()


class _Disk(FileIO):
    """A file whose first error waits until it is asked for: HDF5 cannot close a file that refuses what it
    writes, and ends in another error."""

    def __init__(self, path: str) -> None:
        super().__init__(path, "w+")
        self._error: OSError | None = None

    def write(self, content: ReadableBuffer) -> int:
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
    def __init__(self, file: h5netcdf.File, text: object) -> None:
        self._file, self._text = file, text

    def create(self, array: Array) -> Any:
        for dim, size in zip(array.dims, array.sizes, strict=True):
            if dim not in self._file.dimensions:
                self._file.dimensions[dim] = size
        packed = _PACKED if array.dims and array.kind != "words" else {}
        variable = self._file.create_variable(
            array.key,
            array.dims,
            _NUMBERS.get(array.kind, self._text),
            chunks=array.chunks or None,
            fillvalue=_NOTHING[array.kind],
            **packed,
        )
        variable.attrs.update(array.attributes)
        return variable

    def describe(self, attributes: Mapping[str, str]) -> None:
        for name, text in attributes.items():
            if len(text.encode()) <= LONGEST:
                self._file.attrs[name] = text
            else:
                self._file.create_variable(name, (), self._text)[...] = text

    def flags(self, key: str, attributes: Mapping[str, object]) -> None:
        self._file.variables[key].attrs.update(attributes)


_ABOUT, _CHUNK = "zarr.json", re.compile(r"c(/\d+)*")
_FILLED: Mapping[str, object] = {"number": np.nan, "whole": 0, "words": ""}


def write_zarr(sweep: Sweep, batches: Iterable[pa.RecordBatch], target: str, scratch: str) -> None:
    """Write all batches, in order."""
    import zarr

    with whole_path(target, scratch, _is_ours) as folder:
        fill(sweep, batches, _Folder(zarr.open_group(folder, mode="w", zarr_format=3)))
        with warnings.catch_warnings():
            # That only Zarr for Python knows all metadata in one place; the others read them one by one.
            warnings.simplefilter("ignore")
            zarr.consolidate_metadata(folder)


def _is_ours(folder: str) -> bool:
    """Whether a folder has nothing but what sweeps write: arrays and their chunks, and what they are of."""
    try:
        with open(os.path.join(folder, _ABOUT), encoding="utf-8") as file:
            about = json.load(file)
        arrays = {*about["consolidated_metadata"]["metadata"]} if "kurbel" in about["attributes"] else ()
    except (OSError, ValueError, TypeError, KeyError):
        return False
    names = (os.path.join(path, name) for path, *some in os.walk(folder) for name in chain(*some))
    return all(_is_of(arrays, os.path.relpath(name, folder).split(os.sep)) for name in names)


def _is_of(arrays: Collection[str], path: Sequence[str]) -> bool:
    key, *own = path
    return path == [_ABOUT] or (
        key in arrays and (own in ([], [_ABOUT]) or _CHUNK.fullmatch("/".join(own)) is not None)
    )


class _Folder:
    def __init__(self, group: Any) -> None:
        self._group = group

    def create(self, array: Array) -> Any:
        from zarr.codecs import BloscCodec

        packed: Any = {} if array.kind == "words" else {"compressors": BloscCodec(cname="zstd", clevel=1)}
        return self._group.create_array(
            array.key,
            shape=array.sizes,
            chunks=array.chunks,
            dtype=_NUMBERS.get(array.kind, str),
            fill_value=_FILLED[array.kind],
            dimension_names=array.dims,
            attributes=dict(array.attributes),
            **packed,
        )

    def describe(self, attributes: Mapping[str, str]) -> None:
        self._group.attrs.update(attributes)

    def flags(self, key: str, attributes: Mapping[str, object]) -> None:
        plain = {name: one.tolist() if hasattr(one, "tolist") else one for name, one in attributes.items()}
        self._group[key].attrs.update(plain)
