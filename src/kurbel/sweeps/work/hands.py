"""Who computes parts on this machine: this thread, its threads, or processes (processes.py)."""

from __future__ import annotations

import os
from collections.abc import Callable, Generator
from concurrent.futures import Future, ThreadPoolExecutor
from queue import SimpleQueue
from threading import Event, Lock, local
from typing import Protocol, TypeVar

from kurbel.errors import FailedError

# The precision of balls is that of the process: of several threads one at a time computes with them.
BALLS = Lock()
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


class LetGoError(FailedError):
    """A part that nobody waits for any longer."""


def check_wanted() -> None:
    """Raise LetGoError in a thread that was let go."""
    if (let_go := getattr(_thread, "let_go", None)) and let_go.is_set():
        raise LetGoError("the run was stopped")


def cores() -> int:
    """Return how many processes run at once."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class Hands(Protocol[Taken]):
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


def taken(hands: Hands[Made], count: int) -> Generator[tuple[int, Made], None, None]:
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


class Here:
    """This thread, for a sweep that is done before a process has started."""

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
