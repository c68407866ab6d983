"""Who makes pieces of work on this machine: this thread, its threads, or processes, each by itself."""

from __future__ import annotations

import gc
import os
import signal
import sys
from collections.abc import Callable, Generator, Iterator
from concurrent.futures import BrokenExecutor, Future, ThreadPoolExecutor
from contextlib import contextmanager
from queue import SimpleQueue
from threading import Event, Thread, local
from types import ModuleType
from typing import TYPE_CHECKING, Any, Generic, NoReturn, Protocol, TypeVar

from kurbel.errors import FailedError

if TYPE_CHECKING:
    from concurrent.futures import ProcessPoolExecutor

# What a part becomes: the name of its file, or its content.
Result = str | bytes
Make = Callable[[int], Result]
Made = TypeVar("Made")
Taken = TypeVar("Taken", covariant=True)
# More processes than these no machine has cores for.
MOST_JOBS = 1024
# One is computed, and one is there as soon as that is done.
FOR_EACH = 2

# What tells a thread that nobody waits any longer for what it computes.
_thread = local()


class AbandonedError(FailedError):
    """A part that nobody waits for any longer."""


def check_wanted() -> None:
    """Raise LetGoError in a thread that was let go."""
    if (let_go := getattr(_thread, "let_go", None)) and let_go.is_set():
        raise AbandonedError("the run was stopped")


def cores() -> int:
    """Return how many processes run at once."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def lock(handle: int, wait: bool = False) -> bool:
    """Lock an open file, and tell whether nobody else has it; with `wait` that is waited for. A file system
    without locks keeps nobody away."""
    try:
        if sys.platform == "win32":
            import msvcrt

            # Behind what is in it, which nobody else could read; it waits for ten seconds at the most.
            os.lseek(handle, 1 << 20, os.SEEK_SET)
            msvcrt.locking(handle, msvcrt.LK_LOCK if wait else msvcrt.LK_NBLCK, 1)
            os.lseek(handle, 0, os.SEEK_SET)
        else:
            import fcntl

            fcntl.flock(handle, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
    except BlockingIOError:
        return False
    except OSError:
        if wait:
            raise
        return sys.platform != "win32"
    return True


class Workers(Protocol[Taken]):
    """Who computes parts: some at once are given, and each is taken as it is done."""

    @property
    def most(self) -> int:
        """How many parts are to be given at once."""

    def give(self, number: int) -> None:
        """Have a part computed."""

    def take(self) -> tuple[int, Taken]:
        """Return a part that is done, waiting for it; raise what kept it from being made."""

    def end(self, at_once: bool) -> None:
        """Let all go; `at_once` without what they are computing."""


def taken(hands: Workers[Made], count: int) -> Generator[tuple[int, Made], None, None]:
    """Yield so many parts as they are done, and let all go then, or where nobody takes them any longer."""
    given = 0
    try:
        for done in range(count):
            while given < min(count, done + hands.most):
                hands.give(given)
                given += 1
            yield hands.take()
    except BaseException:
        hands.end(at_once=True)
        raise
    hands.end(at_once=False)


class CallingThread:
    """The thread itself, for a sweep that is done before a process has started."""

    most = 1

    def __init__(self, make: Make) -> None:
        self._make = make
        self._given: list[int] = []

    def give(self, number: int) -> None:
        self._given.append(number)

    def take(self) -> tuple[int, Result]:
        number = self._given.pop(0)
        return number, self._make(number)

    def end(self, at_once: bool) -> None:
        self._given.clear()


class Threads:
    """Threads of this process, for what NumPy and compiled loops compute."""

    def __init__(self, make: Make, count: int) -> None:
        self.most = count * FOR_EACH
        self._make = make
        self._let_go = Event()
        self._pool = ThreadPoolExecutor(count, initializer=self._begin)
        self._done: SimpleQueue[tuple[int, Future[Result]]] = SimpleQueue()

    def give(self, number: int) -> None:
        future = self._pool.submit(self._make, number)
        future.add_done_callback(lambda done: self._done.put((number, done)))

    def take(self) -> tuple[int, Result]:
        number, future = self._done.get()
        return number, future.result()

    def _begin(self) -> None:
        _thread.let_go = self._let_go

    def let_go(self) -> None:
        """Have no thread finish more than the part of a partition that it is at."""
        self._let_go.set()

    def end(self, at_once: bool) -> None:
        while True:
            try:
                self._pool.shutdown(cancel_futures=True)
            except KeyboardInterrupt:
                # A process cannot end while its threads compute; now they are soon done.
                self.let_go()
            else:
                return


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
            except BrokenExecutor:
                self._replace(place)
                future = self._pools[place].submit(_made, number)
        self._given[place] += 1
        pool = self._pools[place]
        future.add_done_callback(lambda done: self._done.put((number, place, pool, done)))

    def take(self) -> tuple[int, Made]:
        while True:
            number, place, pool, future = self._done.get()
            self._given[place] -= 1
            if not isinstance(future.exception(), BrokenExecutor):
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


def _pool(make: Callable[[int], object]) -> ProcessPoolExecutor:
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

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


_make: list[Callable[[int], object]] = []


def _start(make: Callable[[int], object]) -> None:
    """Make a process ready: it ends with the one that started it, and by no other's Ctrl-C."""
    from multiprocessing import parent_process

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
