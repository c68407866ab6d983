"""The terminal that standard output is, if it is one: its size, its colours, and the way of a page to it."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from functools import partial
from itertools import chain
from shutil import get_terminal_size
from stat import S_ISREG
from time import monotonic

# A terminal that can do nothing but print.
DUMB = "dumb"
# What tells the language of the one who reads, the first that is set.
LOCALE = ("LC_ALL", "LC_MESSAGES", "LANG")
# It comes back until a language is chosen, for nothing is kept of earlier calls.
HINT = "English: --lang en, or KURBEL_LANG=en for all; KURBEL_LANG=de ends this"
# Seconds in which nobody doubts that something goes on.
PATIENCE = 1.0
_CODES = re.compile("\x1b\\[[0-9;]*m")


def width() -> int | None:
    """Return the characters of a line of the terminal, None where standard output is none."""
    return get_terminal_size().columns if sys.stdout.isatty() else None


def has_colours() -> bool:
    """Return whether a page may have colours, by the variables that other programs know.

    NO_COLOR outdoes all others. FORCE_COLOR and CLICOLOR_FORCE colour what goes to a pipe, too; nothing
    colours a file.
    """
    said = os.environ.get
    if said("NO_COLOR") or _is_file():
        return False
    if said("FORCE_COLOR") or said("CLICOLOR_FORCE", "0") != "0":
        return True
    return sys.stdout.isatty() and said("TERM") != DUMB and said("CLICOLOR") != "0"


def reads_german(environment: Mapping[str, str]) -> bool:
    """Return whether the one who reads has a German locale."""
    return next(filter(None, map(environment.get, LOCALE)), "").startswith("de")


def _is_file() -> bool:
    try:
        return S_ISREG(os.fstat(sys.stdout.fileno()).st_mode)
    except OSError:
        # It is no stream of the system's, but is collected in memory.
        return True


def show(pieces: Iterable[bytes], paging: bool) -> None:
    """Write to standard output, with `paging` through a pager what is longer than the screen."""
    pieces = iter(pieces)
    if paging and sys.stdout.isatty() and os.environ.get("TERM") != DUMB:
        from kurbel.cli.pager import pager

        first, is_longer = _screenful(pieces)
        pieces = chain(first, pieces)
        if is_longer and (found := pager(os.environ)):
            found.show(pieces)
            return
    for piece in pieces:
        sys.stdout.buffer.write(piece)
    sys.stdout.buffer.flush()


def _screenful(pieces: Iterator[bytes]) -> tuple[list[bytes], bool]:
    """Return the pieces that are seen at first, and whether there is more than that.

    On the last line of the screen one goes on typing.
    """
    columns, rows = get_terminal_size()
    first, height = [], 0
    for piece in pieces:
        first.append(piece)
        lines = _CODES.sub("", piece.decode(errors="replace")).splitlines()
        height += sum(max(-(-len(line) // columns), 1) for line in lines)
        if height >= rows:
            return first, True
    return first, False


@contextmanager
def counted(patience: float = PATIENCE) -> Iterator[None]:
    """Show on a terminal how many numbers of a page are done, where that takes long."""
    from kurbel.page.build import WATCHER

    with ExitStack() as bars:
        token = WATCHER.set(partial(_bar, bars, monotonic() + patience))
        try:
            yield
        finally:
            WATCHER.reset(token)


def _bar(bars: ExitStack, begin: float, count: int) -> Callable[[], None]:
    """Return what counts the numbers, on a bar as soon as it is time to begin."""
    done, bar = 0, None

    def passed() -> None:
        nonlocal done, bar
        done += 1
        if bar is not None:
            bar.update(1)
        elif monotonic() >= begin:
            from click import progressbar

            bar = bars.enter_context(progressbar(length=count, label=f"{count} numbers", file=sys.stderr))
            bar.update(done)

    return passed
