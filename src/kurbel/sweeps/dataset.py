"""A sweep for Python: a dataset of xarray, or a file."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, overload

import kurbel
from kurbel.commands.options import Option, is_given
from kurbel.commands.part import Origin, Values
from kurbel.commands.subject import MACHINE, Command, of_machine
from kurbel.errors import ChoiceError, KeywordError, NotationError
from kurbel.reading.given import meant
from kurbel.sweeps.asked import not_outdone, planned, values_of
from kurbel.sweeps.files.forms import need
from kurbel.sweeps.rows import Sweep
from kurbel.sweeps.run import Outcome, Running, run

if TYPE_CHECKING:
    from os import PathLike

    from xarray import Dataset

# Their pages are of books, in which nothing varies.
_BOOKS = frozenset(("collate", "example"))


@overload
def sweep(
    command: Callable[..., Any] | str,
    *,
    digits: int | None = ...,
    bounds: bool = ...,
    zip: str | Iterable[str | Sequence[str]] = ...,
    only: str = ...,
    sample: str = ...,
    seed: int = ...,
    strict: bool = ...,
    output: None = ...,
    **options: Any,
) -> Dataset: ...
@overload
def sweep(
    command: Callable[..., Any] | str,
    *,
    digits: int | None = ...,
    bounds: bool = ...,
    zip: str | Iterable[str | Sequence[str]] = ...,
    only: str = ...,
    sample: str = ...,
    seed: int = ...,
    strict: bool = ...,
    output: str | PathLike[str],
    jobs: int | None = ...,
    scheduler: str | None = ...,
    resume: bool = ...,
    restart: bool = ...,
    **options: Any,
) -> Outcome: ...
def sweep(
    command: Callable[..., Any] | str,
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
    **options: Any,
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
        need("kurbel.sweep", "xarray", "dask")
        if jobs or scheduler or resume or restart:
            raise NotationError(
                "jobs, scheduler, resume and restart are for an output; Dask says what computes a dataset"
            )
    asking = _command(command)
    machine = options.pop(MACHINE, None)
    by_hand = _named(asking, options)
    given = by_hand if machine is None else _on_machine(asking.command, machine, by_hand)
    plan = planned(
        f"{asking.__module__}:{asking.__name__}",
        given,
        defaults=[name for name in given if name not in by_hand],
        linked=_linked(zip),
        digits=digits,
        bounds=bounds,
        strict=strict,
        only=only,
        sample=sample,
        seed=seed,
    )
    asked = Sweep(plan)
    if output is not None:
        return run(asked, str(output), Running(scheduler, jobs, resume, restart))
    from kurbel.sweeps.lazy import dataset_of

    return dataset_of(asked)


def _command(command: Callable[..., Any] | str) -> Any:
    """Return the function that makes a table."""
    functions = [getattr(kurbel, name) for name in kurbel.__all__ if name not in _BOOKS]
    known = {one.command.name: one for one in functions if hasattr(one, "question")}
    if isinstance(command, str):
        return known[meant(command, known, "command")]
    if command not in known.values():
        raise NotationError(
            f"{getattr(command, '__name__', command)} is no function that makes a table of a machine, such as"
            " kurbel.delta"
        )
    return command


def _named(asking: Any, options: Mapping[str, Any]) -> dict[str, Any]:
    """Return the options by their names on the command line, each with its values as a list."""
    known = {one.name: one for one in asking.command.parameters.values()} | dict(asking.command.parameters)
    try:
        given = {known[meant(name, known, "option")]: value for name, value in options.items()}
    except ChoiceError as error:
        raise KeywordError(str(error)) from None
    read = {one.name: _values(one, value) for one, value in given.items()}
    return {name: value for name, value in read.items() if is_given(value)}


def _on_machine(command: Command, file: Any, given: Mapping[str, Any]) -> dict[str, Any]:
    """Return the options, and those of a machine's file that they do not outdo behind them."""
    own = {one.name: one for one in command.parameters.values()}
    found = of_machine(command, file)
    said = {**given, **{name: value for name, value in found.items() if name not in given}}
    origins: dict[str, Origin | None] = dict.fromkeys(own)
    origins |= dict.fromkeys(found, Origin.MACHINE) | dict.fromkeys(given, Origin.TYPED)
    values = Values({**{name: one.default for name, one in own.items()}, **said}, origins)
    first = {name: values_of(own[name], value)[0] for name, value in said.items()}
    left = not_outdone(command, values, first)
    return {name: value for name, value in said.items() if name in left}


def _values(parameter: Option[Any], value: Any) -> Any:
    if (dimensions := getattr(value, "ndim", 0)) > 1:
        raise NotationError(f"{parameter.name} is an array of {dimensions} dimensions; give a list of values")
    if hasattr(value, "tolist"):
        value = value.tolist()
    if not isinstance(value, list | tuple | range):
        return value
    if not value:
        raise NotationError(f"{parameter.name} is an empty list; give values, or leave it out")
    if parameter.whole and not any(isinstance(one, str | list | tuple) for one in value):
        # Of such an option several numbers are one value, as the function takes them: cranks of an engine.
        return [tuple(value)]
    if any(isinstance(one, list | tuple) for one in value):
        raise NotationError(f"{parameter.name} has lists in a list; write each of them as text: '0;120;240'")
    return list(value)


def _linked(zip: str | Iterable[str | Sequence[str]]) -> list[list[str]]:
    """Return the names of options that are linked, group by group: "eps,back", or a list of such."""
    groups = [zip] if isinstance(zip, str) else list(zip)
    alone = [one for one in groups if isinstance(one, str) and "," not in one]
    return [_names(group) for group in ([alone] if alone and alone == groups else groups)]


def _names(group: str | Sequence[str]) -> list[str]:
    names = group.split(",") if isinstance(group, str) else group
    return [name.strip().replace("-", "_") for name in names]
