"""A sweep as a Zarr: a folder of arrays over the axes, each chunk a file of its own."""

from __future__ import annotations

import json
import os
import re
import warnings
from collections.abc import Collection, Iterable, Mapping, Sequence
from itertools import chain
from typing import TYPE_CHECKING, Any

import numpy as np
import zarr
from zarr.codecs import BloscCodec

from kurbel.sweeps.files.grid import Array, fill
from kurbel.sweeps.files.whole import whole_path
from kurbel.sweeps.rows import Sweep

if TYPE_CHECKING:
    import pyarrow as pa

_TYPES: Mapping[str, Any] = {"number": "float64", "whole": "int32", "words": str}
_ABOUT, _CHUNK = "zarr.json", re.compile(r"c(/\d+)*")
_EMPTY: Mapping[str, Any] = {"number": np.nan, "whole": 0, "words": ""}


def write(sweep: Sweep, batches: Iterable[pa.RecordBatch], target: str, scratch: str) -> None:
    """Write all batches, in order."""
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
    return path == [_ABOUT] or (key in arrays and (own in ([], [_ABOUT]) or _is_chunk(own)))


def _is_chunk(path: Sequence[str]) -> bool:
    return _CHUNK.fullmatch("/".join(path)) is not None


class _Folder:
    def __init__(self, group: zarr.Group) -> None:
        self._group = group

    def create(self, array: Array) -> Any:
        packed: Any = {} if array.kind == "words" else {"compressors": BloscCodec(cname="zstd", clevel=1)}
        return self._group.create_array(
            array.key,
            shape=array.sizes,
            chunks=array.chunks,
            dtype=_TYPES[array.kind],
            fill_value=_EMPTY[array.kind],
            dimension_names=array.dims,
            attributes=dict(array.attributes),
            **packed,
        )

    def describe(self, attributes: Mapping[str, Any]) -> None:
        self._group.attrs.update(attributes)

    def flags(self, key: str, attributes: Mapping[str, Any]) -> None:
        plain = {name: one.tolist() if hasattr(one, "tolist") else one for name, one in attributes.items()}
        self._group[key].attrs.update(plain)
