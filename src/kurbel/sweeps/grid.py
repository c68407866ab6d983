"""A sweep as arrays over its axes: dimensions, coordinates, and the rows in their places.

A chunk of an array is a run of rows, so that each is written once, as its rows come.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from itertools import chain
from math import prod
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from kurbel.errors import ProblemError
from kurbel.sweeps.about import SweepDescription, cf_of, cf_of_file
from kurbel.sweeps.columns import Column, Part
from kurbel.sweeps.coordinates import values_at
from kurbel.sweeps.plan import Axis
from kurbel.sweeps.records import tried
from kurbel.sweeps.rows import Sweep

if TYPE_CHECKING:
    import pyarrow as pa

# Rows of a chunk.
CHUNK = 1 << 18
POINT, RECORD = "point", "record"
REASON, REASONS = "reason", "reason_text"
# More flags than these are no longer read by anybody.
MOST_FLAGS = 100
Place = tuple[slice, ...]
# From one place on an axis to another: what stands there.
Values = Callable[[int, int], object]


class Array(NamedTuple):
    """An array of a file: its dimensions, its sizes and those of its chunks, and what is said of it."""

    key: str
    kind: str
    dims: tuple[str, ...]
    sizes: tuple[int, ...]
    chunks: tuple[int, ...]
    attributes: Mapping[str, str]


class Store(Protocol):
    """A file of arrays that is being written."""

    def create(self, array: Array) -> Any:
        """Return an array that takes values at slices."""

    def describe(self, attributes: Mapping[str, str]) -> None:
        """Say of the file what it is."""

    def flags(self, key: str, attributes: Mapping[str, object]) -> None:
        """Say of an array what its numbers mean."""


def refuse(sweep: Sweep) -> None:
    """Raise ProblemError for a sweep that no array holds."""
    if sweep.plan.digits is not None:
        raise ProblemError(
            "NetCDF and Zarr have no decimals; write .parquet, .arrow or .csv, or leave --digits out for"
            " floats"
        )


class Grid:
    """The dimensions of a sweep, and which columns are coordinates on which of them."""

    def __init__(self, sweep: Sweep) -> None:
        self.sweep, self.about = sweep, SweepDescription.of(sweep)
        self.columns = {column.option: column for column in sweep.columns if column.option}
        self.dims = tuple(self._dims())
        self.sizes = sweep.shape
        self.chunks = chunks_of(self.sizes)

    def _dims(self) -> Iterator[str]:
        linked = 0
        for group in self._groups:
            if len(group) == 1 and self.sweep.plan.kept is None:
                yield self.columns[group[0].option].key
            else:
                linked += 1
                yield POINT if linked == 1 else f"{POINT}_{linked}"
        if len(self.sweep.shape) > len(self._groups):
            yield self.apart[0].key if len(self.apart) == 1 else RECORD

    @property
    def _groups(self) -> tuple[tuple[Axis, ...], ...]:
        """The options that vary along each dimension: all along one where combinations are left out."""
        groups = self.sweep.plan.groups
        return groups if self.sweep.plan.kept is None else (tuple(chain(*groups)),)

    @property
    def apart(self) -> list[Column]:
        """The columns that tell the records of a point apart."""
        return [one for one in self.sweep.columns if one.role == "axis" and not one.option]

    def records(self) -> Iterator[tuple[Array, NDArray[np.generic]]]:
        """Yield the arrays of what tells the records of a point apart, and their values at a point."""
        found = self._point()
        for column in self.apart:
            size, values = self.sweep.each, found.values[column.key]
            array = Array(
                column.key, column.kind, self.dims[-1:], (size,), (size,), cf_of(self.about, column)
            )
            yield array, np.array(values, object if column.kind == "words" else np.float64)

    def _point(self) -> Part:
        each = self.sweep.each
        for point in tried(self.sweep.plan):
            part = self.sweep.part(point * each, (point + 1) * each)
            if not part.reasons:
                break
        return part

    def coordinates(self) -> Iterator[tuple[Array, Values]]:
        """Yield the arrays of the options that vary, with what gives the values from one place to another."""
        for dim, size, group in zip(self.dims, self.sizes, self._groups, strict=False):
            for axis in group:
                column = self.columns[axis.option]
                about = cf_of(self.about, column)
                array = Array(column.key, column.kind, (dim,), (size,), (min(size, CHUNK),), about)
                yield array, partial(self._along, axis, column)

    def _along(self, axis: Axis, column: Column, start: int, stop: int) -> NDArray[np.generic]:
        if self.sweep.plan.kept is None:
            found = values_at(self.sweep.plan, axis, np.arange(start, stop), column.unit)
        else:
            each = self.sweep.each
            found = self.sweep.varied(start * each, stop * each)[column.key][::each]
        return np.array(found, object if column.kind == "words" else np.float64)

    def variables(self) -> list[Array]:
        """Return the arrays of what is computed."""
        found = [one for one in self.sweep.columns if one.role != "axis"]
        own = {one.key for one in found}
        return [self._over_all(one.key, one.kind, self._said(one, own)) for one in found]

    def _said(self, column: Column, own: set[str]) -> dict[str, str]:
        said = cf_of(self.about, column)
        if (bound := f"{column.key}_bound") in own:
            said["ancillary_variables"] = bound
        axes = [*self.columns.values(), *self.apart]
        if others := [one.key for one in axes if one.key not in self.dims]:
            said["coordinates"] = " ".join(others)
        return said

    def reasons(self) -> Array:
        """Return the array of which number of a sentence refused a place, 0 where nothing was refused."""
        return self._over_all(REASON, "whole", {"long_name": "why there is nothing", "units": "1"})

    def _over_all(self, key: str, kind: str, attributes: Mapping[str, str]) -> Array:
        return Array(key, kind, self.dims, self.sizes, self.chunks, attributes)

    def places(self) -> Iterator[Place]:
        """Yield the places of all chunks, in the order of their rows."""
        counts = [-(-size // chunk) for size, chunk in zip(self.sizes, self.chunks, strict=True)]
        for number in np.ndindex(*counts):
            yield tuple(
                slice(one * chunk, min((one + 1) * chunk, size))
                for one, chunk, size in zip(number, self.chunks, self.sizes, strict=True)
            )


def chunks_of(sizes: tuple[int, ...], rows: int = CHUNK) -> tuple[int, ...]:
    """Return the sizes of chunks that are runs of at most so many rows."""
    for place in range(len(sizes)):
        behind = prod(sizes[place + 1 :])
        if behind <= rows:
            pieces = -(-sizes[place] // min(sizes[place], rows // behind))
            return (*[1] * place, -(-sizes[place] // pieces), *sizes[place + 1 :])
    return ()


def extent(place: Place) -> tuple[int, ...]:
    """Return how far a place reaches along each dimension."""
    return tuple(one.stop - one.start for one in place)


def fill(sweep: Sweep, batches: Iterable[pa.RecordBatch], store: Store) -> None:
    """Write all rows to their places, and all that is known of them."""
    from kurbel.sweeps.arrow import in_sizes

    grid = Grid(sweep)
    store.describe(cf_of_file(grid.about))
    for array, values in grid.coordinates():
        into, (size,) = store.create(array), array.sizes
        for start in range(0, size, CHUNK):
            stop = min(start + CHUNK, size)
            into[start:stop] = values(start, stop)
    records = dict(_records(store, grid))
    arrays = {array.key: (store.create(array), array.kind) for array in grid.variables()}
    refused, numbers = store.create(grid.reasons()), {"": 0}
    first = 0
    chunks = in_sizes(batches, (prod(extent(place)) for place in grid.places()))
    for place, batch in zip(grid.places(), chunks, strict=True):
        for key, (array, kind) in arrays.items():
            array[place] = values_of(batch[key], kind).reshape(extent(place))
        _check_records(records, batch, first)
        first += len(batch)
        if batch[REASON].null_count < len(batch):
            refused[place] = _numbered(batch[REASON], numbers).reshape(extent(place))
    _explain(store, [*numbers])


def _records(store: Store, grid: Grid) -> Iterator[tuple[str, NDArray[np.generic]]]:
    for array, values in grid.records():
        store.create(array)[:] = values
        yield array.key, values


def _check_records(records: Mapping[str, NDArray[np.generic]], batch: pa.RecordBatch, first: int) -> None:
    """Raise ProblemError where the records of a point are not those of the others."""
    for key, values in records.items():
        column = batch[key]
        expected = np.resize(np.roll(values, -(first % len(values))), len(batch))
        known = column.is_valid().to_numpy(zero_copy_only=False)
        if not (column.to_numpy(zero_copy_only=False) == expected)[known].all():
            raise ProblemError(
                f"{key} is not the same at all points, so that it is no axis of an array; write .parquet,"
                " .arrow or .csv, which have it in each row"
            )


def values_of(column: pa.Array, kind: str) -> Any:
    """Return a column of Arrow as an array: NaN, or an empty text, where there is nothing."""
    if kind == "words":
        return column.fill_null("").to_numpy(zero_copy_only=False).astype(object)
    return column.fill_null(np.nan).to_numpy(zero_copy_only=False) if column.null_count else column.to_numpy()


def _numbered(reasons: pa.Array, numbers: dict[str, int]) -> Any:
    """Return the numbers of the sentences; new ones are added, in the order in which they come."""
    coded = reasons.fill_null("").dictionary_encode()
    own = [numbers.setdefault(text, len(numbers)) for text in coded.dictionary.to_pylist()]
    return np.array(own, np.int32)[coded.indices.to_numpy(zero_copy_only=False)]


def _explain(store: Store, texts: list[str]) -> None:
    """Say what the numbers of the sentences mean."""
    count = len(texts)
    array = store.create(
        Array(REASONS, "words", ("reason_number",), (count,), (count,), {"long_name": "sentence of a reason"})
    )
    array[:] = np.array(texts, object)
    if count <= MOST_FLAGS:
        meanings = " ".join(["computed", *(f"refused_{number}" for number in range(1, count))])
        flags = {"flag_values": np.arange(count, dtype=np.int32), "flag_meanings": meanings}
        store.flags(REASON, flags)
