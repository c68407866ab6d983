"""A step of a test in a process of its own: what pytest writes meanwhile is not written as another user."""

from __future__ import annotations

import os
import traceback
from collections.abc import Callable

NOBODY = 65534


def apart(call: Callable[[], object]) -> None:
    """Do something in a fork; what fails there fails here."""
    reading, writing = os.pipe()
    if not (child := os.fork()):
        failure = ""
        try:
            call()
        except BaseException:
            failure = traceback.format_exc()
        os.write(writing, failure.encode()[-60_000:])
        os._exit(0)
    os.close(writing)
    with open(reading, encoding="utf-8", errors="replace") as pipe:
        failure = pipe.read()
    assert (os.waitpid(child, 0)[1], failure) == (0, ""), failure


def as_nobody(call: Callable[[], object]) -> None:
    """Do the same as a user who may not write everything: root turns into nobody, others are such a user.

    Nobody may not read Python's own files where they lie with root: what the call needs is loaded before.
    """

    def turned() -> None:
        if os.geteuid() == 0:
            os.setresuid(NOBODY, NOBODY, NOBODY)
        call()

    apart(turned)
