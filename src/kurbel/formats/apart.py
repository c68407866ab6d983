"""A process of its own for templates of a user's, which ends where they take too long, and has little memory.

One serves all pages of the process that started it, and ends with it. In a browser, which has no processes,
templates run in place.
"""

from __future__ import annotations

import atexit
import json
import os
import pickle
import signal
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from threading import Lock
from time import process_time
from typing import Any

from kurbel.errors import KurbelError, LayoutError

# A browser has none but its own.
HAS_PROCESSES = sys.platform != "emscripten"
# Templates of one's own have so many seconds of processor time for a page, and so much memory.
PATIENCE, GIGABYTES = 10.0, 4
_PROGRAM = (
    "import signal, sys; signal.signal(signal.SIGINT, signal.SIG_IGN); sys.path[:] = sys.argv[1:];"
    " from kurbel.formats.apart import serve; serve()"
)
# What is left of the seconds, where several pages are one.
_LEFT: ContextVar[list[float] | None] = ContextVar("left", default=None)


@contextmanager
def one_page() -> Iterator[None]:
    """Have all templates of the block within the time of one page."""
    if _LEFT.get() is not None:
        yield
        return
    token = _LEFT.set([PATIENCE])
    try:
        yield
    finally:
        _LEFT.reset(token)


def filled_apart(form: str, template: str, values: Mapping[str, object], folders: Sequence[str]) -> str:
    """Return what a template of the folders makes of the values for a format.

    Raises LayoutError for whatever is wrong with it, and where it is stopped.
    """
    if not HAS_PROCESSES:
        return _filled(form, template, values, folders)
    with one_page():
        left = _LEFT.get()
        assert left is not None
        request = (os.getcwd(), max(left[0], 0.01), GIGABYTES, form, template, values, folders)
        answer = _PROCESS.answer(pickle.dumps(request))
        if answer is None:
            named = " and ".join(folders)
            raise LayoutError(
                f"the templates of {named} were stopped after {PATIENCE:g} s, or at {GIGABYTES} gigabytes"
            )
        text, error, seconds = answer
        left[0] -= seconds
        if error:
            raise LayoutError(error)
        return str(text)


def _filled(form: str, template: str, values: Mapping[str, object], folders: Sequence[str]) -> str:
    from kurbel.formats.templates import filled

    return filled(form, template, values, folders)


class _Process:
    """The process, which is started where it is needed, and anew where it was ended."""

    def __init__(self) -> None:
        self.process: subprocess.Popen[bytes] | None = None
        self.owner = 0
        self.lock = Lock()

    def answer(self, request: bytes) -> Any:
        """Return what it answers, or None if it was ended."""
        with self.lock:
            process = self._started()
            assert process.stdin is not None and process.stdout is not None
            with suppress(OSError):
                process.stdin.write(len(request).to_bytes(8, "big") + request)
                process.stdin.flush()
                if line := process.stdout.readline():
                    return json.loads(line)
            self.end()
            return None

    def _started(self) -> subprocess.Popen[bytes]:
        # A copy of this process would read answers that are not its own.
        if self.process is None or self.owner != os.getpid():
            self.owner = os.getpid()
            self.process = subprocess.Popen(
                [sys.executable, "-c", _PROGRAM, *sys.path], stdin=subprocess.PIPE, stdout=subprocess.PIPE
            )
            atexit.register(self.end)
        return self.process

    def end(self) -> None:
        """End it; it reads the end of its input."""
        process, self.process = self.process, None
        if process is not None and self.owner == os.getpid():
            atexit.unregister(self.end)
            with suppress(OSError):
                process.communicate()


_PROCESS = _Process()


def serve() -> None:
    """Answer requests until there are no more."""
    requests, answers = sys.stdin.buffer, sys.stdout.buffer
    while size := requests.read(8):
        folder, seconds, gigabytes, *page = pickle.loads(requests.read(int.from_bytes(size, "big")))
        os.chdir(folder)
        text, error, before = "", "", process_time()
        with deadline(seconds, gigabytes):
            try:
                text = _filled(*page)
            except KurbelError as found:
                error = str(found)
        answers.write(json.dumps((text, error, process_time() - before)).encode() + b"\n")
        answers.flush()


@contextmanager
def deadline(seconds: float, gigabytes: float | None) -> Iterator[None]:
    """End this process, which is one that was started for this, where the block takes longer.

    Too much memory, if it is limited, is a MemoryError. The seconds are of processor time where the system
    counts it, so that a busy machine ends nothing; either way even a process that is inside of one long
    operation is ended.
    """
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


def _limit_memory(gigabytes: float) -> None:
    try:
        import resource
    except ImportError:
        return
    _, hard = resource.getrlimit(resource.RLIMIT_AS)
    most = int(gigabytes * (1 << 30))
    resource.setrlimit(resource.RLIMIT_AS, (most if hard < 0 else min(most, hard), hard))
