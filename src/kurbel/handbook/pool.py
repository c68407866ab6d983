"""Work across cores, each piece by itself: one that kills its process takes no other along."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Generic, NamedTuple, TypeVar

if TYPE_CHECKING:
    from concurrent.futures import Future, ProcessPoolExecutor

Task = TypeVar("Task")
Result = TypeVar("Result")

# Windows waits for no more processes at once.
MOST_PROCESSES = 61
# Fewer pieces than these are done before another process has loaded the libraries.
WORTH_A_PROCESS = 4
# What ended the processes of so many pieces will end those of the rest.
MOST_KILLED = 3


class Killed(NamedTuple):
    """What stands for the result of a piece whose process ended, or that was not tried as others ended."""

    tried: bool = True


class Worked(NamedTuple, Generic[Task, Result]):
    task: Task
    result: Result | Killed


def cores() -> int:
    """Return how many processes run at once."""
    count = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return min(count, MOST_PROCESSES)


def worked(
    work: Callable[[Task], Result], tasks: Sequence[Task], jobs: int, apart: bool = False
) -> Iterator[Worked[Task, Result]]:
    """Yield each task with its result, as they are done.

    With `apart` no task runs in this process. A task whose process ends has the result Killed.
    """
    if not apart and (jobs == 1 or len(tasks) < WORTH_A_PROCESS):
        for task in tasks:
            yield Worked(task, work(task))
    elif tasks:
        yield from _worked_apart(work, tasks, jobs)


def _worked_apart(
    work: Callable[[Task], Result], tasks: Sequence[Task], jobs: int
) -> Iterator[Worked[Task, Result]]:
    # Later than most imports: a handbook without changes needs no processes.
    from concurrent.futures import as_completed

    left = dict(enumerate(tasks))
    with _pool(min(jobs, len(tasks))) as pool:
        places = {pool.submit(work, task): place for place, task in left.items()}
        for future in as_completed(places):
            if not _was_killed(future):
                yield Worked(left.pop(places[future]), future.result())
    # One process that ended has ended the others' pool as well: each of the rest has one of its own.
    killed = 0
    for task in left.values():
        if killed == MOST_KILLED:
            yield Worked(task, Killed(tried=False))
            continue
        with _pool(1) as pool:
            alone = pool.submit(work, task)
            killed += _was_killed(alone)
            yield Worked(task, Killed() if _was_killed(alone) else alone.result())


def _was_killed(future: Future[Any]) -> bool:
    from concurrent.futures.process import BrokenProcessPool

    return isinstance(future.exception(), BrokenProcessPool)


@contextmanager
def _pool(jobs: int) -> Iterator[ProcessPoolExecutor]:
    """Give a pool of so many processes; they end at once where the block ends early."""
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import active_children, get_context

    # Started anew, not copied, so that a piece finds the same process on every system.
    pool = ProcessPoolExecutor(jobs, mp_context=get_context("spawn"), initializer=_start)
    try:
        yield pool
    except BaseException:
        for child in active_children():
            child.kill()
        raise
    finally:
        pool.shutdown(cancel_futures=True)


def _start() -> None:
    """Make a process of the pool ready: it ends with the one that started it, and by no other's Ctrl-C."""
    from multiprocessing import parent_process
    from threading import Thread

    # The terminal sends it to all; who waits for the pieces ends them.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = parent_process()
    assert parent is not None

    def follow() -> None:
        parent.join()
        os._exit(1)

    Thread(target=follow, daemon=True).start()


@contextmanager
def deadline(seconds: float, gigabytes: int | None, counts: bool) -> Iterator[None]:
    """If it `counts`, end this process where the block takes longer, and perhaps limit its memory.

    For the processes of `worked` only. Too much memory is a MemoryError. The seconds are of processor time
    where the system counts it, so that a busy machine ends nothing; either way even a process that is inside
    of one long operation is ended.
    """
    if not counts:
        yield
        return
    if gigabytes is not None:
        _limit_memory(gigabytes)
    with _processor_watch(seconds) if hasattr(signal, "setitimer") else _clock_watch(seconds):
        yield


@contextmanager
def _processor_watch(seconds: float) -> Iterator[None]:
    signal.signal(signal.SIGPROF, signal.SIG_DFL)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


@contextmanager
def _clock_watch(seconds: float) -> Iterator[None]:
    import faulthandler

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
