"""A sweep for Python: a dataset of xarray, or a file."""

from __future__ import annotations

import hashlib
import inspect
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from decimal import Context, Decimal
from functools import partial
from math import prod
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import NDArray

import kurbel
from kurbel.commands.options import Option, is_given
from kurbel.commands.part import Origin, Values
from kurbel.commands.subject import MACHINE, Command, of_machine
from kurbel.errors import ChoiceError, NotationError, ProblemError
from kurbel.reading.environment import need
from kurbel.reading.given import allowed_name
from kurbel.reading.names import checks_keywords, spelling_keywords, unknown
from kurbel.sweeps.about import cf_of, cf_of_file
from kurbel.sweeps.asked import planned
from kurbel.sweeps.columns import Column, Part
from kurbel.sweeps.grid import Grid, chunks_of
from kurbel.sweeps.plan import Cell
from kurbel.sweeps.records import IN_BALLS
from kurbel.sweeps.rows import Sweep

if TYPE_CHECKING:
    from os import PathLike

    from xarray import Dataset

    from kurbel.sweeps.run import Outcome

# Their pages are of books, in which nothing varies.
_BOOKS = frozenset(("collate", "example"))


@overload
def sweep(command: Callable[..., object] | str, *, output: None = ..., **options: Any) -> Dataset: ...
@overload
def sweep(
    command: Callable[..., object] | str, *, output: str | PathLike[str], **options: Any
) -> Outcome: ...
@checks_keywords
def sweep(
    command: Callable[..., object] | str,
    *,
    digits: int | None = None,
    bounds: bool = False,
    zip: str | Iterable[str | Sequence[str]] = (),
    only: str = "",
    sample: str = "",
    seed: int = 0,
    strict: bool = False,
    output: str | PathLike[str] | None = None,
    jobs: int | None = None,
    scheduler: str | None = None,
    resume: bool = False,
    restart: bool = False,
    **options: object,
) -> Dataset | Outcome:
    """Compute a command at every combination of what its options are given, as a dataset of xarray.

    `command` is a function that makes a table, such as `kurbel.delta`, or its name, "delta". Its
    options may be given several values: lists, NumPy arrays, ranges as text. The dataset has a dimension
    for each of these, in their order; options that `zip` names, "eps,back", go through their values together
    and share the dimension "point". So do all where `only`, "eps*back < 1", leaves combinations out, and
    where `sample`, "sobol:1024" or "random:1000", takes points of intervals, the same for the same `seed`.
    Where nothing can be computed is NaN, and `refused` is true; a small dataset also has the sentences,
    `reason`. A `strict` sweep raises the first of them.

    What takes some seconds is computed at once; more becomes arrays of Dask, which compute what is asked of
    them and no more. Values are floats; with `bounds` each has a variable beside it that says how far from
    the true value it may lie, and with `digits` they are `Decimal`, certified to so many decimals. With an
    `output` all becomes a file instead, whose form its suffix says: .parquet, .arrow, .csv, .nc, .zarr, or a
    folder. It is computed by so many `jobs` on this machine, or by the cluster of a `scheduler`, may `resume`
    what an earlier run left or `restart` it; what comes back says how many rows there are, and how many of
    them were refused. A `machine` is a file that gives the options which are not given here.

    >>> import kurbel
    >>> found = kurbel.sweep("delta", eps=[2, 3, 4], ratio="1:4..1:6")
    >>> dict(found.sizes)
    {'epsilon': 3, 'ratio': 3}
    >>> found["delta"].sel(epsilon=3, ratio=0.2).round(3).item()
    1.374

    Raises KurbelError.
    """
    if output is None:
        need("kurbel.sweep", "scale", "xarray", "dask")
        if jobs or scheduler or resume or restart:
            raise NotationError(
                "jobs, scheduler, resume and restart are for an output; Dask says what computes a dataset"
            )
    asking = _command(command)
    own = inspect.signature(sweep).parameters
    with spelling_keywords(lambda: {**asking.command.keywords(), **dict.fromkeys(own, ())}):
        plan = planned(
            f"{asking.__module__}:{asking.__name__}",
            _values_of(asking.command, options.pop(MACHINE, None), options),
            linked=_linked(zip),
            digits=digits,
            bounds=bounds,
            strict=strict,
            only=only,
            sample=sample,
            seed=seed,
        )
        if output is not None:
            need("a file of columns", "scale", "pyarrow")
            from kurbel.sweeps.run import SweepRunner, run

            return run(Sweep(plan), str(output), SweepRunner(scheduler, jobs, resume, restart))
    return dataset_of(Sweep(plan))


def _command(command: Callable[..., object] | str) -> Any:
    """Return the function that makes a table."""
    functions = [getattr(kurbel, name) for name in kurbel.__all__ if name not in _BOOKS]
    known = {one.command.name: one for one in functions if hasattr(one, "question")}
    if isinstance(command, str):
        return known[allowed_name(command, known, "command")]
    if command not in known.values():
        raise NotationError(
            f"{getattr(command, '__name__', command)} is no function that makes a table of a machine, such as"
            " kurbel.delta"
        )
    return command


def _values_of(command: Command, machine: object, options: Mapping[str, object]) -> Values:
    """Return the options by their names on the command line, several values of one as a list, and behind them
    what a machine's file says."""
    known = {**command.options, **command.parameters}
    typed = {}
    for name, value in options.items():
        try:
            one = known[allowed_name(name, known, "option")]
        except ChoiceError:
            raise unknown("sweep", name, known, f"it has those of kurbel.{command.name}") from None
        typed[one.name] = _listed(one, value)
    typed = {name: value for name, value in typed.items() if is_given(value)}
    found = {} if machine is None else of_machine(command, machine)
    origins = dict.fromkeys(found, Origin.MACHINE) | dict.fromkeys(typed, Origin.TYPED)
    return Values(typed | {name: value for name, value in found.items() if name not in typed}, origins)


def _listed(option: Option[object], value: object) -> object:
    if (dimensions := getattr(value, "ndim", 0)) > 1:
        raise NotationError(f"{option.name} is an array of {dimensions} dimensions; give a list of values")
    if hasattr(value, "tolist"):
        value = value.tolist()
    if not isinstance(value, list | tuple | range):
        return value
    if not value:
        raise NotationError(f"{option.name} is an empty list; give values, or leave it out")
    if option.whole and not any(isinstance(one, str | list | tuple) for one in value):
        # Of such an option several numbers are one value, as the function takes them: cranks of an engine.
        return [tuple(value)]
    if any(isinstance(one, list | tuple) for one in value):
        raise NotationError(f"{option.name} has lists in a list; write each of them as text: '0;120;240'")
    return list(value)


def _linked(zip: str | Iterable[str | Sequence[str]]) -> list[str | Sequence[str]]:
    """Return the options that are linked, group by group: "eps,back", or a list of such."""
    if not isinstance(zip, Iterable) or not all(isinstance(one, str | list | tuple) for one in zip):
        raise NotationError(f"zip is {str(zip)[:60]}; write the options that go together as 'eps,back'")
    groups: list[str | Sequence[str]] = [zip] if isinstance(zip, str) else [*zip]
    names = [one for one in groups if isinstance(one, str) and "," not in one]
    # Names one by one are a group.
    return [names] if names and len(names) == len(groups) else groups


# What tells whether a place was refused, and why.
REFUSED, REASON = "refused", "reason"
# More tasks than these no scheduler keeps in mind.
MOST_CHUNKS, LARGEST_CHUNK = 20_000, 1 << 22
# So many rows of balls are computed at once, and make a chunk, though parts of files are smaller.
FEW = 1 << 12
_ALL_DIGITS = Context(prec=1000)


def dataset_of(sweep: Sweep) -> Dataset:
    """Return the dataset. Raises ProblemError for one that is too long."""
    from xarray import Dataset

    grid = Grid(sweep)
    columns = [one for one in sweep.columns if one.role != "axis"]
    found = _all(sweep, columns) if len(sweep) <= _at_once(sweep) else _lazily(sweep, columns)
    about = {one.key: cf_of(grid.about, one) for one in columns}
    return Dataset(
        {key: (grid.dims, array, about.get(key, {})) for key, array in found.items()},
        coords=_coordinates(grid),
        attrs=cf_of_file(grid.about),
    )


def _at_once(sweep: Sweep) -> int:
    return FEW if sweep.rows_at_once == IN_BALLS else sweep.rows_at_once


def _coordinates(grid: Grid) -> Mapping[str, object]:
    along = {
        array.key: (array.dims, values(0, array.sizes[0]), array.attributes)
        for array, values in grid.coordinates()
    }
    return along | {array.key: (array.dims, values, array.attributes) for array, values in grid.records()}


def _all(sweep: Sweep, columns: list[Column]) -> dict[str, object]:
    """Return all values, by their keys."""
    part = sweep.computed(0, len(sweep))
    rows = _structured(part, columns)
    found = {key: np.ascontiguousarray(rows[key]) for key in rows.dtype.names or ()}
    found[REASON] = np.array([part.reasons.get(row, "") for row in range(part.rows)], object)
    return {key: array.reshape(sweep.shape) for key, array in found.items()}


def _lazily(sweep: Sweep, columns: list[Column]) -> dict[str, object]:
    """Return arrays that compute their values, chunk by chunk, each for all columns at once."""
    import dask.array as da

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


def _block(sweep: Sweep, columns: tuple[Column, ...], block_info: Any) -> NDArray[np.void]:
    """Return the rows of a chunk, which is a run of them, at their places."""
    place = block_info[None]["array-location"]
    extent = tuple(stop - start for start, stop in place)
    first = int(np.ravel_multi_index(tuple(start for start, _ in place), sweep.shape))
    return _structured(sweep.computed(first, first + prod(extent)), columns).reshape(extent)


def _of(key: str, rows: NDArray[np.void]) -> NDArray[np.generic]:
    return np.ascontiguousarray(rows[key])


def _dtype(columns: list[Column] | tuple[Column, ...]) -> np.dtype[np.void]:
    kinds = [(one.key, "f8" if one.kind == "number" else "O") for one in columns]
    return np.dtype([*kinds, (REFUSED, "?")])


def _structured(part: Part, columns: list[Column] | tuple[Column, ...]) -> NDArray[np.void]:
    """Return the rows of a part, with a field for each column."""
    rows = np.zeros(part.rows, _dtype(columns))
    for column in columns:
        rows[column.key] = _column_values(column, part.values[column.key])
    rows[REFUSED][[*part.reasons]] = True
    return rows


def _column_values(column: Column, values: Cell) -> Cell | NDArray[np.object_]:
    if column.kind != "decimal":
        return values
    assert column.decimals is not None
    found = np.empty(len(values), object)
    found[:] = [
        None if one is None else Decimal(int(one)).scaleb(-column.decimals, _ALL_DIGITS) for one in values
    ]
    return found
