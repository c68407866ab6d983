"""A sweep as a Zarr: a folder of arrays over the axes, each chunk a file of its own."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Mapping
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
    return os.path.isfile(os.path.join(folder, "zarr.json"))


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
