"""A sweep is run: its parts are computed, and become a file that is whole or absent; or it is estimated.

Parts are computed in any order, by whoever there is, into a folder beside the target. From there they go
in order into the file. What is in memory does not grow with the sweep: few parts at once are being computed,
and of those that are done only the names are known.
"""

from __future__ import annotations

import os
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass, replace
from functools import partial
from tempfile import TemporaryDirectory
from typing import NamedTuple

import pyarrow as pa

from kurbel.errors import ChoiceError, FailedError, OutputError
from kurbel.sweeps.arrow import batch_of
from kurbel.sweeps.folder import Work, files_of, grounded, identity_of, working
from kurbel.sweeps.hands import CallingThread, Processes, Result, Threads, Workers, cores
from kurbel.sweeps.parts import Form, Unit, form_of, is_device, joined, kept, made, unit_of
from kurbel.sweeps.records import TRIED
from kurbel.sweeps.rows import Sweep

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
class SweepRunner:
    """How a sweep is run: by so many `jobs` on this machine, or by the cluster of a `scheduler`.

    `resume` goes on with the parts of an earlier run, `restart` removes them. `watch` is told of rows that
    are done.
    """

    scheduler: str | None = None
    jobs: int | None = None
    resume: bool = False
    restart: bool = False
    watch: Callable[[int], None] = lambda rows: None

    def __post_init__(self) -> None:
        if self.resume and self.restart:
            raise ChoiceError(
                "--resume goes on with finished parts and --restart removes them; give one of the two"
            )
        if self.scheduler and self.jobs:
            raise ChoiceError(
                "--jobs is of this machine, and with --scheduler others compute; give one of the two"
            )
        if self.scheduler == "":
            raise ChoiceError(
                "--scheduler is empty; give an address, tcp://HOST:8786, or leave it out for this machine"
            )


def run(
    sweep: Sweep, target: str, running: SweepRunner = SweepRunner(), format: str | None = None
) -> Outcome:
    """Write the sweep to a file, in the form of its suffix unless its `format` is said.

    Raises KurbelError; then parts that are done are kept for `resume`.
    """
    form = form_of(target, format)
    form.check(sweep, target)
    refused: Counter[str] = Counter()
    # A new one goes to other processes, without what it knows already.
    sweep = replace(sweep, plan=grounded(sweep.plan))
    identity, earlier = identity_of(sweep), {"resume": running.resume, "restart": running.restart}
    with _beside(target, running) as place, working(place, identity, **earlier) as work:
        telling = _telling(work) if place == target else nullcontext()
        unit = unit_of(sweep, form)
        with telling, _hands(unit, work, running) as hands:
            paths = map(work.at, _parts(unit, work, hands, running.watch))
            rows = joined(unit, form, paths, target, work.folder, refused)
        work.remove()
    return Outcome(rows, refused)


@contextmanager
def _beside(target: str, running: SweepRunner) -> Iterator[str]:
    """Give the file beside which parts lie: the target, or one that nobody keeps if it is a stream."""
    if target != "-" and not is_device(target):
        yield target
        return
    if running.resume:
        raise ChoiceError(f"of what is written to {target} nothing is kept to go on with; name a file")
    with TemporaryDirectory(prefix="kurbel-") as folder:
        yield os.path.join(folder, "sweep")


def _parts(unit: Unit, work: Work, hands: Workers[Result], watch: Callable[[int], None]) -> Iterator[str]:
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
def _hands(unit: Unit, work: Work, running: SweepRunner) -> Iterator[Workers[Result]]:
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


def _hired(unit: Unit, work: Work, running: SweepRunner) -> Workers[Result]:
    make = partial(made, unit, work.place)
    if running.scheduler:
        from kurbel.sweeps.cluster import Cluster

        return Cluster(running.scheduler, make, work.place.word, files_of(unit.sweep.plan))
    count = min(running.jobs or cores(), unit.count)
    if count == 1:
        return CallingThread(make)
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


# Seconds that are spent on measuring, and rows of one measurement at the most.
PATIENCE = 1.0
LONGEST = 1 << 18
# Rows of which a file is written where each is computed alone.
WRITTEN = 256
# Forms that are arrays of their own are written by axes: eight bytes a number.
BYTES = 8


@dataclass(frozen=True)
class Estimate:
    """Seconds of computing and of writing on one core, and bytes; `refused` is the first point of the sample
    that was refused, with why."""

    rows: int
    parts: int
    computing: float
    writing: float
    size: float
    refused: tuple[str, str] | None

    def seconds(self, hands: int) -> float:
        """Return how long it takes so many: one of them writes while all compute."""
        return max(self.writing, (self.computing + self.writing) / hands)


def estimated(sweep: Sweep, form: Form) -> Estimate:
    """Return what the sweep would be as a file of a form. Writes nothing that stays."""
    seconds, rows, refused = 0.0, 0, None
    for start, stop in _samples(sweep):
        begun = time.process_time()
        part = sweep.part(start, stop)
        seconds += time.process_time() - begun
        rows += stop - start
        if part.refused and refused is None:
            row = min(part.refused)
            refused = (sweep.in_words(start + row), part.refused[row])
        if seconds > PATIENCE:
            break
    parts = -(-len(sweep) // sweep.rows_at_once)
    size, writing = _file(sweep, form)
    return Estimate(len(sweep), parts, seconds / rows * len(sweep), writing, size, refused)


def _samples(sweep: Sweep) -> Iterator[tuple[int, int]]:
    """Yield runs of rows spread over the sweep: single ones first, then as long as they are computed."""
    count = len(sweep)
    length = 1 if sweep.rows_at_once <= 4096 else min(count, sweep.rows_at_once, LONGEST)
    # The first of all also pays for what is loaded.
    sweep.part(0, min(length, count))
    for start in dict.fromkeys((count - length) * place // TRIED for place in range(TRIED + 1)):
        yield start, start + length


def _file(sweep: Sweep, form: Form) -> tuple[float, float]:
    """Return about how many bytes the file has, and how long it is written, by one of its first rows."""
    rows = min(len(sweep), WRITTEN if sweep.rows_at_once <= 4096 else LONGEST)
    batch = batch_of(sweep, sweep.part(0, rows))
    # What a file of no rows takes, such as the exact inputs that it has, does not grow with them.
    (bare, begin), (size, seconds) = _written(sweep, form, batch[:0]), _written(sweep, form, batch)
    factor = len(sweep) / rows
    if not form.streams and form.name != "partitions":
        size, bare = rows * BYTES * sum(column.role != "axis" for column in sweep.columns), 0
    return bare + (size - bare) * factor, begin + max(seconds - begin, 0) * factor


def _written(sweep: Sweep, form: Form, batch: pa.RecordBatch) -> tuple[float, float]:
    """Return how many bytes a file of a batch has, and how long it is written."""
    with tempfile.TemporaryDirectory() as folder:
        one = os.path.join(folder, "sample")
        plain = form if form.streams else FORMS_OF_FILES
        # The first one also pays for what is loaded.
        for _ in range(2):
            begun = time.process_time()
            plain.write(sweep, iter([batch]), one, folder)
            seconds = time.process_time() - begun
        return os.path.getsize(one), seconds


FORMS_OF_FILES = Form("parquet", (), "kurbel.sweeps.arrow:write_parquet")
