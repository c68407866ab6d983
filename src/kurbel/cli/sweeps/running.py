"""How a sweep is run: the options that say by whom, and the bar that shows how far it is."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import click

from kurbel.cli.options import Option, Type
from kurbel.commands.options import Count
from kurbel.sweeps.work.hands import MOST_JOBS

if TYPE_CHECKING:
    from kurbel.sweeps.rows import Sweep
    from kurbel.sweeps.run import Running


def running_options() -> list[click.Parameter]:
    """Return the options that say who computes, and what becomes of an earlier run."""
    return [
        Option(["--scheduler"], metavar="ADDRESS",
               help="Dask cluster that computes: tcp://HOST:8786, tls://HOST:8786, or scheduler.json."),
        Option(["-j", "--jobs"], type=Type(Count("jobs", 1, MOST_JOBS)), metavar="N",
               help="Processes or threads at once on this machine; default: one for each core."),
        Option(["--resume"], is_flag=True, help="Go on with the finished parts of a run that was ended."),
        Option(["--restart"], is_flag=True, help="Begin anew, and remove the finished parts of such a run."),
    ]  # fmt: skip


@contextmanager
def running(values: Mapping[str, Any], sweep: Sweep) -> Iterator[Running]:
    """Give how to run a sweep by the values of these options; on a terminal a bar tells of it."""
    from kurbel.errors import ChoiceError
    from kurbel.sweeps.run import Running

    if values["resume"] and values["restart"]:
        raise ChoiceError(
            "--resume goes on with finished parts and --restart removes them; give one of the two"
        )
    if values["scheduler"] and values["jobs"]:
        raise ChoiceError(
            "--jobs is of this machine, and with --scheduler others compute; give one of the two"
        )
    if values["scheduler"] == "":
        raise ChoiceError(
            "--scheduler is empty; give an address, tcp://HOST:8786, or leave it out for this machine"
        )
    names = {name: values[name] for name in ("scheduler", "jobs", "resume", "restart")}
    with _bar(sweep, values["output"]) as watch:
        yield Running(**names, watch=watch)


@contextmanager
def _bar(sweep: Sweep, target: str) -> Iterator[Callable[[int], None]]:
    """Give what is told of rows that are done; it shows them where a sweep has several parts."""
    if len(sweep) <= sweep.rows_at_once or not sys.stderr.isatty():
        yield lambda rows: None
        return

    def rate(_: Any) -> str:
        each = bar.time_per_iteration
        return _rate(1 / each) if each else ""

    bar = click.progressbar(length=len(sweep), label=target, item_show_func=rate, file=sys.stderr)
    with bar:
        yield lambda rows: bar.update(rows, "")


def _rate(rows: float) -> str:
    """Return rows a second, to three figures."""
    power = 0 if rows < 999.5 else 1 if rows < 999.5e3 else 2
    return f"{rows / 1000**power:.3g} {('', 'thousand ', 'million ')[power]}rows/s"
