"""A sweep is run: its parts are computed, and become a file that is whole or absent.

Parts are computed in any order, by whoever there is, into a folder beside the target. From there they go
in order into the file. What is in memory does not grow with the sweep: few parts at once are being computed,
and of those that are done only the names are known.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import dataclass, replace
from functools import partial
from importlib.util import find_spec
from tempfile import TemporaryDirectory
from typing import NamedTuple

from kurbel.errors import ChoiceError, FailedError, OutputError
from kurbel.reading.extras import missing_extra
from kurbel.sweeps.files.forms import form_of, is_device
from kurbel.sweeps.rows import Sweep
from kurbel.sweeps.work.folder import Work, working
from kurbel.sweeps.work.hands import Hands, Here, Result, Threads, cores
from kurbel.sweeps.work.identity import files_of, grounded, identity_of
from kurbel.sweeps.work.processes import Processes
from kurbel.sweeps.work.task import Unit, kept, made

# Parts that are done before one that is not: their names are all that is kept.
AHEAD = 10_000


class Outcome(NamedTuple):
    """How many rows were written, and how many of them were refused, by the sentence."""

    rows: int
    refused: Counter[str]


class StoppedError(FailedError):
    """A run that was ended by Ctrl-C, and of which parts are kept."""

    exit_code = 130


@dataclass(frozen=True)
class Running:
    """How a sweep is run: by so many `jobs` on this machine, or by the cluster of a `scheduler`.

    `resume` goes on with the parts of an earlier run, `restart` removes them. `watch` is told of rows that
    are done.
    """

    scheduler: str | None = None
    jobs: int | None = None
    resume: bool = False
    restart: bool = False
    watch: Callable[[int], None] = lambda rows: None


def run(sweep: Sweep, target: str, running: Running = Running(), format: str | None = None) -> Outcome:
    """Write the sweep to a file, in the form of its suffix unless its `format` is said.

    Raises KurbelError; then parts that are done are kept for `resume`.
    """
    if find_spec("pyarrow") is None:
        raise missing_extra("files of columns need pyarrow", "scale")
    form = form_of(target, format)
    form.check(sweep, target)
    refused: Counter[str] = Counter()
    from kurbel.sweeps.work.joining import joined, unit_of

    # A new one goes to other processes, without what it knows already.
    sweep = replace(sweep, plan=grounded(sweep.plan))
    with _beside(target, running) as place, _working(place, sweep, running) as work:
        telling = _telling(work) if place == target else nullcontext()
        unit = unit_of(sweep, form)
        with telling, _hands(unit, work, running) as hands:
            paths = map(work.at, _parts(unit, work, hands, running.watch))
            rows = joined(unit, form, paths, target, work.folder, refused)
        work.remove()
    return Outcome(rows, refused)


@contextmanager
def _beside(target: str, running: Running) -> Iterator[str]:
    """Give the file beside which parts lie: the target, or one that nobody keeps if it is a stream."""
    if target != "-" and not is_device(target):
        yield target
        return
    if running.resume:
        raise ChoiceError(f"of what is written to {target} nothing is kept to go on with; name a file")
    with TemporaryDirectory(prefix="kurbel-") as folder:
        yield os.path.join(folder, "sweep")


def _working(place: str, sweep: Sweep, running: Running) -> AbstractContextManager[Work]:
    return working(place, identity_of(sweep), resume=running.resume, restart=running.restart)


def _parts(unit: Unit, work: Work, hands: Hands[Result], watch: Callable[[int], None]) -> Iterator[str]:
    """Yield the files of all parts, in order."""
    count, coming, given = unit.count, 0, 0
    ready: dict[int, str] = {}

    def done(number: int, name: str) -> None:
        ready[number] = name
        watch(unit.rows_of(number))

    for number in range(count):
        while number not in ready or (given < hands.most and coming < min(count, number + AHEAD)):
            if given < hands.most and coming < min(count, number + AHEAD):
                if name := work.found(coming):
                    done(coming, name)
                else:
                    hands.give(coming)
                    given += 1
                coming += 1
            else:
                one, result = hands.take()
                given -= 1
                done(one, result if isinstance(result, str) else kept(result, one, work.folder, unit.suffix))
        yield ready.pop(number)


@contextmanager
def _hands(unit: Unit, work: Work, running: Running) -> Iterator[Hands[Result]]:
    """Give who computes the parts; they end with the block."""
    hands = _hired(unit, work, running)
    try:
        yield hands
    except BaseException as error:
        # A disk that is full has room for what the others are at, once one has ended.
        if isinstance(hands, Threads) and isinstance(error, KeyboardInterrupt):
            hands.let_go()
        hands.end(at_once=True)
        raise
    hands.end(at_once=False)


def _hired(unit: Unit, work: Work, running: Running) -> Hands[Result]:
    make = partial(made, unit, work.place)
    if running.scheduler:
        from kurbel.sweeps.work.cluster import Cluster

        return Cluster(running.scheduler, make, work.place.word, files_of(unit.sweep.plan))
    count = min(running.jobs or cores(), unit.count)
    if count == 1:
        return Here(make)
    return Threads(make, count) if unit.sweep.in_threads else Processes(make, count)


@contextmanager
def _telling(work: Work) -> Iterator[None]:
    """Say how to go on where a run ends early and parts are kept."""
    try:
        yield
    except KeyboardInterrupt:
        if work.is_empty():
            raise
        raise StoppedError(f"stopped; {_kept(work)}") from None
    except BrokenPipeError:
        raise
    except OSError as error:
        said = f"cannot write {error.filename or work.path}: {error.strerror or error}"
        raise OutputError(said if work.is_empty() else f"{said}; {_kept(work)}") from error
    except FailedError as error:
        if work.is_empty():
            raise
        raise FailedError(f"{error}; {_kept(work)}") from error


def _kept(work: Work) -> str:
    return f"finished parts are kept in {work.path}: the same command with --resume goes on"
