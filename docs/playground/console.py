"""The playground's side in Python: what is typed becomes what kurbel prints and the files that it writes.

It runs in the browser, in Pyodide; nothing here needs that, so tests run it on the machine too.
"""

from __future__ import annotations

import gc
import io
import os
import re
import shlex
import sys
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack, redirect_stderr, redirect_stdout
from importlib.abc import MetaPathFinder
from pathlib import Path
from typing import NamedTuple
from unittest import mock

from kurbel.errors import FailedError

# What a telephone makes of quotes and of the two strokes of an option.
TYPED = str.maketrans("“”„‘’‚\u00a0", "\"\"\"''' ")
STROKES = re.compile(r"(?<!\S)[—–](?=[a-z])")
VARIABLE = re.compile(r"([A-Z][A-Z_]*)=(.*)", re.DOTALL)
OF_A_SHELL = frozenset(("|", "||", "&", "&&", "<", "<<", ">>", "2>", "&>", "2>&1"))
# The libraries that no browser has.
ABSENT = frozenset(("numpy", "scipy"))
NOT_HERE = (
    "this needs NumPy and SciPy, as sweeps, drawings and indicator cards do, and these do not run in this"
    " page; kurbel on a computer of your own has them"
)
# Loaded when it is asked for.
LATER = "typst"


class Ran(NamedTuple):
    """How a command ended; `later` is a library that it lacked and that can be loaded."""

    code: int
    out: bytes
    err: str
    later: str = ""


class Typed(NamedTuple):
    """A line of a shell as far as there is a shell here."""

    words: Sequence[str]
    variables: Mapping[str, str]
    target: str | None


class AbsentError(FailedError, ImportError):
    """A library that kurbel takes for granted, and that is not there."""


class Watch(MetaPathFinder):
    """Asked last for a library, hence for those that are not there; notes which they were."""

    def __init__(self) -> None:
        self.asked: set[str] = set()

    def find_spec(self, name: str, path: object = None, target: object = None) -> None:
        if name in ABSENT:
            raise AbsentError(NOT_HERE)
        self.asked.add(name)


class Screen(io.TextIOWrapper):
    """What a command prints: on the terminal of the page, or into a file."""

    def __init__(self, is_terminal: bool) -> None:
        self.bytes = io.BytesIO()
        self.is_terminal = is_terminal
        super().__init__(self.bytes, encoding="utf-8", newline="\n", write_through=True)

    def isatty(self) -> bool:
        return self.is_terminal

    def fileno(self) -> int:
        return 1 if self.is_terminal else super().fileno()


class Refused(Exception):
    """What there is no shell here for."""


watch = Watch()


def start() -> None:
    """Note from now on what is missing."""
    sys.meta_path.append(watch)


def run(line: str, columns: int) -> Ran:
    """Run what was typed, on a terminal of so many columns."""
    try:
        typed = _read(line)
    except Refused as refused:
        return Ran(2, b"", f"{refused}\n")
    watch.asked.clear()
    out, err = Screen(typed.target is None), io.StringIO()
    code = _called(typed, out, err, columns)
    if typed.target is not None:
        try:
            Path(typed.target).write_bytes(out.bytes.getvalue())
        except OSError as error:
            return Ran(1, b"", f"{typed.target}: {error.strerror}\n")
        return Ran(code, b"", err.getvalue(), _later(code))
    return Ran(code, out.bytes.getvalue(), err.getvalue(), _later(code))


def _later(code: int) -> str:
    return LATER if code and LATER in watch.asked else ""


def _read(line: str) -> Typed:
    try:
        words = shlex.split(STROKES.sub("--", line.translate(TYPED)))
    except ValueError:
        raise Refused("a quotation mark is opened and not closed") from None
    if words[:1] == ["$"]:
        del words[0]
    variables = {}
    while words and (match := VARIABLE.fullmatch(words[0])):
        variables[match[1]] = match[2]
        del words[0]
    target = None
    if words[-2:-1] == [">"] and re.search("[a-zA-Z]", words[-1]):
        target = words[-1]
        del words[-2:]
    if found := OF_A_SHELL.intersection(words):
        raise Refused(f'"{min(found)}" is for a shell; here runs one command at a time, "> FILE" may end it')
    return Typed(words, variables, target)


def _called(typed: Typed, out: Screen, err: io.StringIO, columns: int) -> int:
    words = [*typed.words]
    environment = {
        **{name: value for name, value in os.environ.items() if not name.startswith("KURBEL_")},
        **{"KURBEL_PAGER": "", "TERM": "xterm", "COLUMNS": str(columns), "LINES": "50"},
        **typed.variables,
    }
    with ExitStack() as stack:
        stack.enter_context(mock.patch.dict(os.environ, environment, clear=True))
        stack.enter_context(redirect_stdout(out))
        stack.enter_context(redirect_stderr(err))
        if words and words[0] in OWN:
            return OWN[words[0]](words[1:])
        return _kurbel(words[1:] if words[:1] == ["kurbel"] else words)


def _kurbel(words: Sequence[str]) -> int:
    from kurbel.cli import main

    code: int | str | None = 1
    with mock.patch.object(sys, "argv", ["kurbel", *words]):
        try:
            main()
        except SystemExit as end:
            code = end.code
        finally:
            # What main() keeps for the end of a process is to be freed here.
            gc.unfreeze()
    return code if isinstance(code, int) else int(bool(code))


def _ls(words: Sequence[str]) -> int:
    return _each("ls", words or ["."], lambda path: print(*_listed(path), sep="\n"))


def _listed(path: Path) -> list[str]:
    if path.is_file():
        return [str(path)]
    return sorted(one.name + "/" * one.is_dir() for one in path.iterdir() if not one.name.startswith("."))


def _cat(words: Sequence[str]) -> int:
    return _each("cat", words, lambda path: sys.stdout.buffer.write(path.read_bytes()))


def _rm(words: Sequence[str]) -> int:
    return _each("rm", words, Path.unlink)


def _each(name: str, words: Sequence[str], do: Callable[[Path], object]) -> int:
    if not words:
        print(f"{name}: write the name of a file behind it", file=sys.stderr)
        return 2
    code = 0
    for word in words:
        try:
            do(Path(word))
        except OSError as error:
            print(f"{name}: {word}: {error.strerror}", file=sys.stderr)
            code = 1
    return code


# What one wants of a shell when there are files.
OWN: Mapping[str, Callable[[Sequence[str]], int]] = {"ls": _ls, "cat": _cat, "rm": _rm}


def complete(line: str) -> list[tuple[str, str]]:
    """Return what may stand for the last word of the line, each with a word of help."""
    from click.shell_completion import ShellComplete, split_arg_string

    from kurbel.cli.app import cli

    words = split_arg_string(line)
    last = words.pop() if words and not line[-1:].isspace() else ""
    if words[:1] == ["kurbel"]:
        del words[0]
    elif not words and "kurbel".startswith(last) and last:
        return [("kurbel", "")]
    found: list[tuple[str, str]] = []
    for one in ShellComplete(cli, {}, "kurbel", "_KURBEL_COMPLETE").get_completions(words, last):
        if one.type in ("file", "dir"):
            found += [(name, "") for name in _names(str(one.value))]
        else:
            found.append((str(one.value), one.help or ""))
    return found


def _names(begun: str) -> list[str]:
    folder = Path(begun).parent if not begun.endswith("/") else Path(begun)
    if not folder.is_dir():
        return []
    names = [str(one) + "/" * one.is_dir() for one in sorted(folder.iterdir())]
    return [name for name in names if name.startswith(begun)]


def files(folder: str = ".") -> list[tuple[str, int, int]]:
    """Return the files there: path, size and when it was written."""
    found = []
    for path in sorted(Path(folder).rglob("*")):
        if path.is_file():
            about = path.stat()
            found.append((path.as_posix(), about.st_size, about.st_mtime_ns))
    return found
