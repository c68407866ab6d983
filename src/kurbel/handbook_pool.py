"""Work across cores, each piece by itself: one that kills its process takes no other along."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing import get_context
from typing import Generic, NamedTuple, TypeVar

Task = TypeVar("Task")
Result = TypeVar("Result")

# Fewer pieces than these are done before another process has loaded the libraries.
WORTH_A_PROCESS = 4


class Killed(NamedTuple):
    """What stands for the result of a piece whose process ended."""


class Worked(NamedTuple, Generic[Task, Result]):
    task: Task
    result: Result | Killed


def cores() -> int:
    """Return how many processes run at once."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def worked(
    work: Callable[[Task], Result], tasks: Sequence[Task], jobs: int, apart: bool = False
) -> Iterator[Worked[Task, Result]]:
    """Yield each task with its result, as they are done.

    With `apart` no task runs in this process. A task whose process ends has the result Killed.
    """
    if not apart and (jobs == 1 or len(tasks) < WORTH_A_PROCESS):
        for task in tasks:
            yield Worked(task, work(task))
        return
    left = {place: task for place, task in enumerate(tasks)}
    with _pool(min(jobs, len(tasks))) as pool:
        places = {pool.submit(work, task): place for place, task in left.items()}
        for future in as_completed(places):
            if not _was_killed(future):
                yield Worked(left.pop(places[future]), future.result())
    # One process that ended has ended the others' pool as well: each of the rest has one of its own.
    for task in left.values():
        with _pool(1) as pool:
            future = pool.submit(work, task)
            yield Worked(task, Killed() if _was_killed(future) else future.result())


def _was_killed(future: Future[Result]) -> bool:
    return isinstance(future.exception(), BrokenProcessPool)


@contextmanager
def _pool(jobs: int) -> Iterator[ProcessPoolExecutor]:
    # Started anew, not copied, so that a piece finds the same process on every system.
    pool = ProcessPoolExecutor(jobs, mp_context=get_context("spawn"), initializer=_start)
    try:
        yield pool
    finally:
        pool.shutdown(cancel_futures=True)


@contextmanager
def deadline(seconds: float, gigabytes: int, counts: bool) -> Iterator[None]:
    """If it `counts`, end this process where the block is not done in time, and limit its memory.

    For the processes of `worked` only. Too much memory is a MemoryError. A watch in C ends even a process
    that is inside of one long operation.
    """
    if not counts:
        yield
        return
    import faulthandler

    _limit_memory(gigabytes)
    with open(os.devnull, "w") as nowhere:
        faulthandler.dump_traceback_later(seconds, exit=True, file=nowhere)
        try:
            yield
        finally:
            faulthandler.cancel_dump_traceback_later()


def _limit_memory(gigabytes: int) -> None:
    try:
        import resource
    except ImportError:
        return
    _, hard = resource.getrlimit(resource.RLIMIT_AS)
    most = gigabytes << 30
    resource.setrlimit(resource.RLIMIT_AS, (most if hard < 0 else min(most, hard), hard))


def _start() -> None:
    # The terminal sends it to all; who waits for the pieces ends them.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
