"""Terminals of a given size, for programs and for this process."""

from __future__ import annotations

import fcntl
import os
import sys
import termios
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any
from unittest import mock

import pytest
from programs import Programs

# What the tester's own terminal and settings say of pages on it.
SETTINGS = (
    *("COLUMNS", "LINES", "LESS", "PAGER", "NO_COLOR", "FORCE_COLOR", "CLICOLOR", "CLICOLOR_FORCE"),
    *("LC_ALL", "LC_MESSAGES", "LANG"),
)


def environment(**more: str) -> dict[str, str]:
    """Return the environment without the tester's settings, on a terminal that can do what most can."""
    clean = {
        name: value for name, value in os.environ.items() if name not in SETTINGS and "KURBEL" not in name
    }
    return clean | {"TERM": "xterm"} | more


@contextmanager
def terminal(columns: int, lines: int) -> Iterator[tuple[int, int]]:
    """Give both ends of a terminal: what one reads and types at, and what a program has."""
    pty = pytest.importorskip("pty")
    ours, theirs = pty.openpty()
    termios.tcsetwinsize(theirs, (lines, columns))
    try:
        yield ours, theirs
    finally:
        os.close(ours)


def seen(ours: int) -> str:
    """Return all that a terminal shows until nobody holds it any longer."""
    shown = b""
    while True:
        try:
            part = os.read(ours, 65536)
        except OSError:
            # Linux ends a terminal that nobody holds with an error.
            break
        if not part:
            break
        shown += part
    return shown.decode().replace("\r\n", "\n")


def shown(
    programs: Programs,
    *words: str,
    columns: int = 80,
    lines: int = 500,
    meanwhile: Callable[[int], object] = lambda ours: None,
    **settings: str,
) -> tuple[str, int]:
    """Run `kurbel` on a terminal; return what it shows, and the exit code.

    `meanwhile` is called with our end of the terminal, to type at it.
    """
    with terminal(columns, lines) as (ours, theirs):
        run = programs.kurbel(
            *words, stdin=theirs, stdout=theirs, stderr=theirs, env=environment(**settings),
            # Ctrl-C reaches those whose terminal it is.
            prepare=lambda: fcntl.ioctl(theirs, termios.TIOCSCTTY, 0),
        )  # fmt: skip
        os.close(theirs)
        meanwhile(ours)
        text = seen(ours)
        return text, run.wait()


@contextmanager
def own_terminal(columns: int, lines: int, **settings: str) -> Iterator[Any]:
    """Make a terminal of the standard streams of this process, but for its errors; give a function that ends
    it and returns what it shows."""
    with terminal(columns, lines) as (ours, theirs):
        stream = os.fdopen(theirs, "w", encoding="utf-8")

        def end() -> str:
            stream.close()
            return seen(ours)

        with (
            mock.patch.object(sys, "stdin", stream),
            mock.patch.object(sys, "stdout", stream),
            mock.patch.object(sys, "__stdout__", stream),
            mock.patch.dict(os.environ, environment(**settings), clear=True),
        ):
            yield end
        stream.close()
