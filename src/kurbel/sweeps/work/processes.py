"""Processes that make parts of sweeps and handbooks, each by itself: one that dies takes no other along."""

from __future__ import annotations

import gc
import os
import signal
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing import get_context, parent_process
from queue import SimpleQueue
from threading import Thread
from types import ModuleType
from typing import Any, Generic, NoReturn

from kurbel.errors import FailedError
from kurbel.sweeps.work.hands import FOR_EACH, Made

# A part that ended so many processes will end those that come after.
MOST_DEATHS = 3
# So many more objects than before let a process look for garbage.
ALLOCATED = 1_000_000


def _refuse(number: int) -> NoReturn:
    raise FailedError(
        f"processes that had to compute part {number} were ended {MOST_DEATHS} times, for want of"
        " memory or from outside; --jobs 1 leaves more memory to each"
    )


class Processes(Generic[Made]):
    """Processes, each by itself: one that dies takes nothing along but the parts that it was given, `ahead`
    at the most. A part that ends so many as it has `tries` becomes what `ended` makes of its number."""

    def __init__(
        self,
        make: Callable[[int], Made],
        count: int,
        ahead: int = FOR_EACH,
        tries: int = MOST_DEATHS,
        ended: Callable[[int], Made] = _refuse,
    ) -> None:
        self.most = count * ahead
        self._make, self._tries, self._ended = make, tries, ended
        self._pools = [_pool(make) for _ in range(count)]
        self._given = [0] * count
        self._deaths: dict[int, int] = {}
        self._done: SimpleQueue[tuple[int, int, ProcessPoolExecutor, Future[Made]]] = SimpleQueue()

    def give(self, number: int) -> None:
        place = self._given.index(min(self._given))
        with _without_script(), unheard():
            try:
                future = self._pools[place].submit(_made, number)
            except BrokenProcessPool:
                self._replace(place)
                future = self._pools[place].submit(_made, number)
        self._given[place] += 1
        pool = self._pools[place]
        future.add_done_callback(lambda done: self._done.put((number, place, pool, done)))

    def take(self) -> tuple[int, Made]:
        while True:
            number, place, pool, future = self._done.get()
            self._given[place] -= 1
            if not isinstance(future.exception(), BrokenProcessPool):
                self._deaths.pop(number, None)
                return number, future.result()
            if pool is self._pools[place]:
                self._replace(place)
            self._deaths[number] = self._deaths.get(number, 0) + 1
            if self._deaths[number] == self._tries:
                return number, self._ended(number)
            self.give(number)

    def _replace(self, place: int) -> None:
        self._pools[place].shutdown(wait=False)
        self._pools[place] = _pool(self._make)

    def end(self, at_once: bool) -> None:
        for pool in self._pools:
            if at_once:
                for process in [*(pool._processes or {}).values()]:
                    process.kill()
                # The rest of what one of them had begun to send would be waited for without end.
                if pool._processes:
                    pool._result_queue._writer.close()  # type: ignore[attr-defined]
            pool.shutdown(cancel_futures=True)


def _pool(make: Callable[[int], Any]) -> ProcessPoolExecutor:
    # Started anew, not copied, so that a part finds the same process on every system.
    return ProcessPoolExecutor(1, get_context("spawn"), initializer=_start, initargs=(make,))


@contextmanager
def unheard() -> Iterator[None]:
    """Start processes in the block that Ctrl-C does not reach, from their first moment; here it comes behind
    the block."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextmanager
def _without_script() -> Iterator[None]:
    """Have processes that start here not run the script anew that started this one: they do not need it, and
    it may have no place that only the first process passes."""
    script = sys.modules["__main__"]
    sys.modules["__main__"] = ModuleType("__main__")
    try:
        yield
    finally:
        sys.modules["__main__"] = script


_make: list[Callable[[int], Any]] = []


def _start(make: Callable[[int], Any]) -> None:
    """Make a process ready: it ends with the one that started it, and by no other's Ctrl-C."""
    _make[:] = [make]
    gc.set_threshold(ALLOCATED)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = parent_process()
    assert parent is not None

    def follow() -> None:
        parent.join()
        os._exit(1)

    Thread(target=follow, daemon=True).start()


def _made(number: int) -> Any:
    return _make[0](number)
