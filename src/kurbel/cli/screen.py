"""The terminal that standard output is, if it is one: its size, its colours, and the way of a page to it."""

from __future__ import annotations

import os
import re
import shlex
import signal
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, redirect_stderr
from functools import partial
from io import StringIO
from itertools import chain
from shutil import get_terminal_size, which
from stat import S_ISREG
from time import monotonic

from kurbel.cli import say

# The variables that name the pager, and what each of them says to have none.
PAGERS, UNPAGED = ("KURBEL_PAGER", "PAGER"), ("", "cat")
# It ends where one screen is enough, obeys the codes of colours, and leaves the page on the screen, which is
# UTF-8 wherever it is printed.
LESS = {"LESS": "FRX", "LV": "-c", "LESSCHARSET": "utf-8"}
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
        first, is_longer = _screenful(pieces)
        pieces = chain(first, pieces)
        if is_longer and (pager := _pager()):
            _page(pieces, pager)
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


def _pager() -> str:
    """Return the pager that the environment names, or less; nothing where there is none, or is to be none."""
    named = next((name for name in PAGERS if name in os.environ), "")
    command = os.environ[named].strip() if named else "less -FRX"
    if command in UNPAGED:
        return ""
    try:
        program = shlex.split(command)[0]
    except (ValueError, IndexError):
        # A quotation mark without its other.
        program = command
    if which(program):
        return command
    if named:
        say(f'{named} is "{command}", and there is no program {program}; name another, or cat for none')
    return ""


def _page(pieces: Iterable[bytes], pager: str) -> None:
    """Hand the pieces to the pager, and return when its reader has done with it."""
    from click import get_pager_file

    # click reads them here.
    os.environ.update(LESS | os.environ | {"PAGER": pager})
    said = StringIO()
    try:
        # What is said meanwhile would be lost among the lines of the page.
        with redirect_stderr(said), get_pager_file() as stream, _without_ctrl_c():
            for piece in pieces:
                stream.buffer.write(piece)
    finally:
        sys.stderr.write(said.getvalue())


@contextmanager
def _without_ctrl_c() -> Iterator[None]:
    """Leave Ctrl-C to the pager: the terminal is not the shell's again until that has ended."""
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


@contextmanager
def bar(
    count: int, label: str, speed: Callable[[float], str] | None = None
) -> Iterator[Callable[[int], None]]:
    """Give what is told of steps that are done. A bar on the terminal, if it is any, shows how many these are
    of the count, which may be none, and the `speed` of so many a second."""
    if not count or not sys.stderr.isatty():
        yield lambda done: None
        return
    from click import progressbar

    def rate(_: object) -> str | None:
        each = shown.time_per_iteration
        return speed and (speed(1 / each) if each else "")

    shown = progressbar(length=count, label=label, item_show_func=rate, file=sys.stderr)
    with shown:
        yield lambda done: shown.update(done, "")


@contextmanager
def counted(patience: float = PATIENCE) -> Iterator[None]:
    """Show on a terminal how many numbers of a page are done, where that takes long."""
    if not sys.stderr.isatty():
        yield
        return
    from kurbel.page.build import WATCHER

    with ExitStack() as bars:
        token = WATCHER.set(partial(_counting, bars, monotonic() + patience))
        try:
            yield
        finally:
            WATCHER.reset(token)


def _counting(bars: ExitStack, begin: float, count: int) -> Callable[[], None]:
    """Return what counts the numbers, on a bar as soon as it is time to begin."""
    left, tell = 0, None

    def passed() -> None:
        nonlocal left, tell
        left += 1
        if tell is None and monotonic() >= begin:
            tell = bars.enter_context(bar(count, f"{count} numbers"))
        if tell is not None:
            tell(left)
            left = 0

    return passed
