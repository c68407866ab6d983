"""Contestants do the same work in turn, each in a process of its own; of each the least time counts.

What else runs on a machine only ever adds, and strikes all that run in turn alike. A child inherits the peak
of memory of its parent: this module imports nothing large.
"""

from __future__ import annotations

import multiprocessing
import os
import resource
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, ExitStack, contextmanager
from dataclasses import dataclass, field
from importlib.util import find_spec
from math import isclose
from multiprocessing.connection import Connection
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Literal, NamedTuple, Protocol, cast

# A wheel brings what it has compiled, or its installer compiles it. Here the first round does, and does not
# count.
ENVIRONMENT = {
    name: value
    for name, value in os.environ.items()
    if name != "PYTHONDONTWRITEBYTECODE" and not name.startswith("KURBEL_")
}
KURBEL = str(Path(sys.executable).with_name("kurbel"))
# What beside kurbel is called that has one core.
ALONE = "kurbel, on one core"
# How far the sums of two contestants' results may lie apart.
AGREEMENT = 1e-9
Run = Callable[[], object]


class Taken(NamedTuple):
    """Seconds on the clock and of the processors, the peak of memory in MiB, the sum of the result, and its
    errors in units of the last place, by what is told of them."""

    wall: float
    processor: float
    memory: float
    sum: float | None = None
    errors: Mapping[str, float] = {}


class Contestant(Protocol):
    """One that does the work of a race."""

    @property
    def needs(self) -> str:
        """The module without which it cannot, if any."""
        ...

    @property
    def cores(self) -> int:
        """How many cores it may have, 0 for all."""
        ...

    def ready(self) -> AbstractContextManager[Callable[[], Taken]]:
        """Be ready: each call does the work once."""
        ...


@dataclass(frozen=True)
class Task:
    """Work within Python: `prepare` gives the function that is timed, in a process that stays.

    The modules named in `without` are missing there. `sums` adds up a result, so that all can be compared;
    `errors` tells how far it is off.
    A slow one does a `share` of the work, and its time is that of the whole. Memory is what the process has
    at its peak beyond what it was prepared with. It may have so many `cores`, 0 for all.
    """

    prepare: Callable[..., Run]
    arguments: tuple[Any, ...] = ()
    without: tuple[str, ...] = ()
    sums: Callable[[Any], float] | None = None
    share: float = 1
    needs: str = ""
    errors: Callable[[Any], Mapping[str, float]] | None = None
    cores: int = 0

    @contextmanager
    def ready(self) -> Iterator[Callable[[], Taken]]:
        ours, theirs = (context := multiprocessing.get_context("spawn")).Pipe()
        process = context.Process(target=_serve, args=(theirs, self))
        with on_cores(self.cores):
            process.start()
        theirs.close()

        def once() -> Taken:
            ours.send("once")
            return cast("Taken", ours.recv())

        try:
            yield once
        finally:
            ours.close()
            process.join()


def _serve(pipe: Connection, task: Task) -> None:
    for name in task.without:
        cast("dict[str, Any]", sys.modules)[name] = None
    run = task.prepare(*task.arguments)
    before = _peak(resource.getrusage(resource.RUSAGE_SELF))
    while True:
        try:
            pipe.recv()
        except EOFError:
            return
        wall, processor = time.perf_counter(), time.process_time()
        result = run()
        wall, processor = time.perf_counter() - wall, time.process_time() - processor
        memory = _peak(resource.getrusage(resource.RUSAGE_SELF)) - before
        wall, processor = wall / task.share, processor / task.share
        total, errors = task.sums(result) if task.sums else None, task.errors(result) if task.errors else {}
        pipe.send(Taken(wall, processor, memory, total, errors))
        del result


@dataclass(frozen=True)
class Program:
    """A whole process from a cold start, in a folder with `files`: a new one for each run, unless `kept`.

    A `bare` one finds nothing that Python has compiled before, as in many containers, and leaves nothing.
    It may have so many `cores`, 0 for all.
    """

    words: Sequence[str]
    files: Mapping[str, str] = field(default_factory=dict)
    kept: bool = False
    needs: str = ""
    bare: bool = False
    cores: int = 0

    @contextmanager
    def ready(self) -> Iterator[Callable[[], Taken]]:
        with TemporaryDirectory() as kept:
            self._furnish(kept)

            def once() -> Taken:
                if self.kept:
                    return self._process(kept)
                with TemporaryDirectory() as folder:
                    self._furnish(folder)
                    return self._process(folder)

            yield once

    def _process(self, folder: str) -> Taken:
        bare = {"PYTHONDONTWRITEBYTECODE": "1", "PYTHONPYCACHEPREFIX": str(Path(folder, "nothing"))}
        with on_cores(self.cores):
            return _process(self.words, folder, ENVIRONMENT | (bare if self.bare else {}))

    def _furnish(self, folder: str) -> None:
        for name, text in self.files.items():
            Path(folder, name).write_text(text, encoding="utf-8")


@contextmanager
def on_cores(count: int) -> Iterator[None]:
    """Let processes that are started here have so many cores, 0 for all."""
    if not count:
        yield
        return
    every = os.sched_getaffinity(0)
    os.sched_setaffinity(0, sorted(every)[:count])
    try:
        yield
    finally:
        os.sched_setaffinity(0, every)


def cores_here() -> int:
    """Return how many cores this process may have."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def kurbel(words: str, **more: Any) -> Program:
    """Return the program for a command line of kurbel without spaces in its words."""
    return Program((KURBEL, *words.split()), **more)


def python(code: str, **more: Any) -> Program:
    """Return the program for a script."""
    return Program((sys.executable, "-c", code), **more)


def _process(words: Sequence[str], folder: str, environment: Mapping[str, str]) -> Taken:
    begun = time.perf_counter()
    process = subprocess.Popen(
        words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, env=environment, cwd=folder
    )
    assert process.stderr
    said = process.stderr.read()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    wall = time.perf_counter() - begun
    if process.returncode:
        raise SystemExit(f"{' '.join(words)} ended with {process.returncode}: {said.decode()}")
    return Taken(wall, used.ru_utime + used.ru_stime, _peak(used))


def _peak(used: resource.struct_rusage) -> float:
    # In bytes there, in KiB elsewhere.
    return used.ru_maxrss / (1024**2 if sys.platform == "darwin" else 1024)


class Row(NamedTuple):
    """A row of the table: one of the contestants, kurbel, beside another.

    `aim` is how many times the other's figure it may be at most, `times` how many things were done, whose
    rate is of interest, `its_times` how many the other did, if not as many, `limit` a peak of memory in MiB
    that the other's stands for. `error` is what is told of the errors, where these are compared.
    """

    what: str
    kurbel: str
    beside: str
    aim: float | None = None
    times: int = 0
    limit: float = 0
    error: str = ""
    its_times: int = 0


@dataclass(frozen=True)
class Race:
    """Contestants by their names, and what is said of them."""

    contestants: Mapping[str, Contestant]
    rows: Sequence[Row]
    rounds: int = 5
    clock: Literal["wall", "processor"] = "wall"


def run(race: Race, rounds: int | None = None) -> dict[str, Taken]:
    """Let all that are installed run in turn.

    The first round, which compiles and fills caches, does not count.
    """
    there = {name: one for name, one in race.contestants.items() if _is_there(one)}
    with ExitStack() as stack:
        ready = {name: stack.enter_context(one.ready()) for name, one in there.items()}
        found = [{name: once() for name, once in ready.items()} for _ in range(1 + (rounds or race.rounds))]
    _agree(found[0])
    return {name: _least([one[name] for one in found[1:]]) for name in there}


def _is_there(one: Contestant) -> bool:
    can_have_fewer = hasattr(os, "sched_setaffinity")
    return (not one.needs or find_spec(one.needs) is not None) and (not one.cores or can_have_fewer)


def _least(taken: Sequence[Taken]) -> Taken:
    return Taken(
        min(one.wall for one in taken),
        min(one.processor for one in taken),
        max(one.memory for one in taken),
        errors=taken[0].errors,
    )


def _agree(found: Mapping[str, Taken]) -> None:
    sums = {name: one.sum for name, one in found.items() if one.sum is not None}
    for one in sums.values():
        assert isclose(one, next(iter(sums.values())), rel_tol=AGREEMENT), sums
