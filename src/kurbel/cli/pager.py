"""The pager that a long page goes through: that of KURBEL_PAGER, else of PAGER, else less."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
from collections.abc import Iterable, Mapping
from contextlib import redirect_stderr, suppress
from io import StringIO
from shutil import which
from typing import IO, NamedTuple

from kurbel.cli import say

VARIABLES = ("KURBEL_PAGER", "PAGER")
# It ends where one screen is enough, obeys the codes of colours, and leaves the page on the screen.
LESS = "FRX"
# What asks for no pager.
NONE = ("", "cat")
# A program and its options, and nothing that only the shell understands.
_SIMPLE = re.compile(r"([\w./+-]+)( +[\w./+,:=-]+)*")


class Pager(NamedTuple):
    """A command of the shell and its environment."""

    command: str
    environment: Mapping[str, str]

    def show(self, pieces: Iterable[bytes]) -> None:
        """Hand the pieces to the pager, and return when its reader has done with it."""
        process = subprocess.Popen(self.command, shell=True, stdin=subprocess.PIPE, env=self.environment)
        assert process.stdin
        # Ctrl-C is the pager's: the terminal is not the shell's again until that has ended.
        before = signal.signal(signal.SIGINT, signal.SIG_IGN)
        said = StringIO()
        try:
            # What is said meanwhile would be lost among the lines of the page.
            with redirect_stderr(said):
                _write(pieces, process.stdin)
        finally:
            process.wait()
            signal.signal(signal.SIGINT, before)
            sys.stderr.write(said.getvalue())
        if process.returncode in (-signal.SIGINT, 128 + signal.SIGINT):
            raise KeyboardInterrupt


def _write(pieces: Iterable[bytes], stream: IO[bytes]) -> None:
    # Who has seen enough closes the pager.
    with suppress(BrokenPipeError), stream:
        for piece in pieces:
            stream.write(piece)


def pager(environment: Mapping[str, str]) -> Pager | None:
    """Return the pager that the environment names, or less; None where there is none, or is to be none."""
    named = next((name for name in VARIABLES if name in environment), "")
    command = environment[named].strip() if named else f"less -{LESS}"
    if command in NONE:
        return None
    simple = _SIMPLE.fullmatch(command)
    if simple and not which(simple[1]):
        if named:
            say(f'{named} is "{command}", and there is no program {simple[1]}; name another, or cat for none')
        return None
    # The page is UTF-8 wherever it is printed.
    return Pager(command, {"LESS": LESS, "LV": "-c", "LESSCHARSET": "utf-8", **environment})
