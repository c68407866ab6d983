"""A sweep as a dataset of xarray: its values at once if they are few, else when they are asked for."""

from __future__ import annotations

import hashlib
from dataclasses import replace
from decimal import Context, Decimal
from functools import partial
from math import prod
from typing import Any

import dask.array as da
import numpy as np
import xarray as xr
from numpy.typing import NDArray

from kurbel.errors import ProblemError
from kurbel.sweeps.files.cf import cf_of, cf_of_file
from kurbel.sweeps.files.grid import Grid, chunks_of
from kurbel.sweeps.rows import Column, Part, Sweep
from kurbel.sweeps.ways.pointwise import IN_BALLS
from kurbel.sweeps.work.task import computed

# What tells whether a place was refused, and why.
REFUSED, REASON = "refused", "reason"
# More tasks than these no scheduler keeps in mind.
MOST_CHUNKS, LARGEST_CHUNK = 20_000, 1 << 22
# So many rows of balls are computed at once, and make a chunk, though parts of files are smaller.
FEW = 1 << 12
_ALL_DIGITS = Context(prec=1000)


def dataset_of(sweep: Sweep) -> xr.Dataset:
    """Return the dataset. Raises ProblemError for one that is too long."""
    grid = Grid(sweep)
    columns = [one for one in sweep.columns if one.role != "axis"]
    found = _all(sweep, columns) if len(sweep) <= _at_once(sweep) else _lazily(sweep, columns)
    about = {one.key: cf_of(grid.about, one) for one in columns}
    return xr.Dataset(
        {key: (grid.dims, array, about.get(key, {})) for key, array in found.items()},
        coords=_coordinates(grid),
        attrs=cf_of_file(grid.about),
    )


def _at_once(sweep: Sweep) -> int:
    return FEW if sweep.rows_at_once == IN_BALLS else sweep.rows_at_once


def _coordinates(grid: Grid) -> dict[str, Any]:
    along = {
        array.key: (array.dims, values(0, array.sizes[0]), array.attributes)
        for array, values in grid.coordinates()
    }
    return along | {array.key: (array.dims, values, array.attributes) for array, values in grid.records()}


def _all(sweep: Sweep, columns: list[Column]) -> dict[str, Any]:
    """Return all values, by their keys."""
    part = computed(sweep, 0, len(sweep))
    rows = _structured(part, columns)
    found = {key: np.ascontiguousarray(rows[key]) for key in rows.dtype.names or ()}
    found[REASON] = np.array([part.reasons.get(row, "") for row in range(part.rows)], object)
    return {key: array.reshape(sweep.shape) for key, array in found.items()}


def _lazily(sweep: Sweep, columns: list[Column]) -> dict[str, Any]:
    """Return arrays that compute their values, chunk by chunk, each for all columns at once."""
    most = max(_at_once(sweep), -(-len(sweep) // MOST_CHUNKS))
    if most > LARGEST_CHUNK:
        raise ProblemError(
            f"a dataset of {len(sweep)} rows has too many chunks for arrays of Dask; give an output, or fewer"
            f" than {MOST_CHUNKS * LARGEST_CHUNK} rows"
        )
    kind = _dtype(columns)
    chunks = da.core.normalize_chunks(chunks_of(sweep.shape, most), sweep.shape)
    name = hashlib.sha256(repr((sweep.plan, most)).encode()).hexdigest()[:16]
    rows = da.map_blocks(
        partial(_block, replace(sweep), tuple(columns)),
        chunks=chunks,
        dtype=kind,
        meta=np.empty((0,) * len(sweep.shape), kind),
        name=f"sweep-{name}",
    )
    return {
        key: rows.map_blocks(partial(_of, key), dtype=kind[key], name=f"{key}-{name}")
        for key in kind.names or ()
    }


def _block(sweep: Sweep, columns: tuple[Column, ...], block_info: Any) -> NDArray[Any]:
    """Return the rows of a chunk, which is a run of them, at their places."""
    place = block_info[None]["array-location"]
    extent = tuple(stop - start for start, stop in place)
    first = int(np.ravel_multi_index(tuple(start for start, _ in place), sweep.shape))
    return _structured(computed(sweep, first, first + prod(extent)), columns).reshape(extent)


def _of(key: str, rows: NDArray[Any]) -> NDArray[Any]:
    return np.ascontiguousarray(rows[key])


def _dtype(columns: list[Column] | tuple[Column, ...]) -> np.dtype[Any]:
    kinds = [(one.key, "f8" if one.kind == "number" else "O") for one in columns]
    return np.dtype([*kinds, (REFUSED, "?")])


def _structured(part: Part, columns: list[Column] | tuple[Column, ...]) -> NDArray[Any]:
    """Return the rows of a part, with a field for each column."""
    rows = np.zeros(part.rows, _dtype(columns))
    for column in columns:
        rows[column.key] = _values(column, part.values[column.key])
    rows[REFUSED][[*part.reasons]] = True
    return rows


def _values(column: Column, values: Any) -> Any:
    if column.kind != "decimal":
        return values
    assert column.decimals is not None
    found = np.empty(len(values), object)
    found[:] = [
        None if one is None else Decimal(int(one)).scaleb(-column.decimals, _ALL_DIGITS) for one in values
    ]
    return found
