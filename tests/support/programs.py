"""Programs that a test starts: with a foreground's signals, and ended with all their children."""

from __future__ import annotations

import os
import select
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress
from threading import Timer
from types import TracebackType
from typing import Any

import pytest
from tools import require

# Bounds what hangs, however busy the machine is; nothing that works takes so long.
PATIENCE = 900.0
# What a job in the background or `nohup` ignores, and what is started by it.
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class Programs:
    """Starts programs, each the leader of a group of processes; at the end no process of them is left."""

    def __init__(self) -> None:
        self._started: list[tuple[subprocess.Popen[bytes], Timer]] = []

    def __enter__(self) -> Programs:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        for process, timer in self._started:
            timer.cancel()
            _end_group(process)
            process.wait()
            for stream in (process.stdin, process.stdout, process.stderr):
                if stream:
                    stream.close()

    def kurbel(self, *words: str, **rest: Any) -> subprocess.Popen[bytes]:
        """Start `kurbel` with these words; its standard error is a pipe."""
        return self.start(sys.executable, "-m", "kurbel", *words, **{"stderr": subprocess.PIPE} | rest)

    def start(
        self, *words: str, prepare: Callable[[], object] = lambda: None, **rest: Any
    ) -> subprocess.Popen[bytes]:
        """Start a program; `prepare` runs in its process before it."""

        def ready() -> None:
            for number in SIGNALS:
                signal.signal(number, signal.SIG_DFL)
            prepare()

        process: subprocess.Popen[bytes] = subprocess.Popen(
            words, start_new_session=True, preexec_fn=ready, **rest
        )
        timer = Timer(PATIENCE, _end_group, [process])
        timer.daemon = True
        timer.start()
        self._started.append((process, timer))
        return process


def _end_group(process: subprocess.Popen[bytes]) -> None:
    with suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)


def is_alone(process: subprocess.Popen[bytes]) -> bool:
    """Whether nothing that the program started, and that stayed in its group, runs any longer."""
    return not any(group == process.pid for _, group in _running())


def is_running(number: int) -> bool:
    """Whether the process of this number runs."""
    return any(own == number for own, _ in _running())


def _running() -> Iterator[tuple[int, int]]:
    """Yield each process and its group, but for those that have ended and that nobody has asked about yet."""
    listed = subprocess.run(
        [require("ps"), "-e", "-o", "pid=,pgid=,stat="], stdout=subprocess.PIPE, check=True
    )
    for line in listed.stdout.decode().splitlines():
        number, group, state = line.split(maxsplit=2)
        if not state.startswith("Z"):
            yield int(number), int(group)


def wait_until(condition: Callable[[], bool]) -> None:
    """Return as soon as the condition holds; it is looked at over and over."""
    for _ in range(int(PATIENCE / 0.005)):
        if condition():
            return
        select.select([], [], [], 0.005)
    pytest.fail(f"what was waited for did not happen within {PATIENCE:.0f} s")
