"""The lines of a user's CSV file, read one by one within bounds: no file, however strange, fills memory."""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Iterator
from typing import NamedTuple

from kurbel.errors import KurbelError

LARGEST_FILE = 10**8
LONGEST_LINE = 10_000
# A million points below their head.
MOST_LINES = 10**6 + 1

_BOM = "\ufeff"
_CONTROL = re.compile(r"[\x00-\x08\x0a-\x1f\x7f]")
# A spreadsheet writes its empty rows as delimiters alone.
_BLANKS = ";,\t "


class Kind(NamedTuple):
    """A kind of file: what messages call it and what is in its lines, and the error that they are."""

    noun: str
    points: str
    error: type[KurbelError]


def said_lines(path: str | os.PathLike[str], kind: Kind) -> Iterator[tuple[int, str]]:
    """Yield the lines that are neither empty nor comments, each with its number from 1, without its end.

    UTF-8 with or without BOM; LF or CRLF; a comment starts with #. At most MOST_LINES lines of LONGEST_LINE
    bytes are read, from a regular file only: a device or a pipe may never end.
    """
    name = shown(path)
    for number, raw in enumerate(_raw_lines(path, name, kind), 1):
        line = _text(raw, number, name, kind)
        if number == 1:
            line = line.removeprefix(_BOM)
        said = line.strip(_BLANKS)
        if said and not said.startswith("#"):
            yield number, line


def place(name: str, number: int | None) -> str:
    """Return where in the file, for the start of a sentence."""
    return name if number is None else f"{name}, line {number}"


def shown(path: str | os.PathLike[str]) -> str:
    """Return the file's name for a message: printable, and not longer than its last 60 characters."""
    name = "".join(char if char.isprintable() else "?" for char in str(path))
    return name if len(name) <= 60 else f"...{name[-57:]}"


def _raw_lines(path: str | os.PathLike[str], name: str, kind: Kind) -> Iterator[bytes]:
    noun = kind.noun
    if name in ("", "-"):
        raise kind.error(f"a {noun} is read from a file, not from standard input; give the file's name")
    try:
        _check_file(os.stat(path), name, kind)
        with open(path, "rb") as file:
            for number in range(1, MOST_LINES + 2):
                raw = file.readline(LONGEST_LINE + 1)
                if not raw:
                    return
                _check_line(raw, number, name, kind)
                yield raw.rstrip(b"\r\n")
    except OSError as error:
        raise kind.error(f"cannot read the {noun} {name}: {error.strerror or error}") from error
    except ValueError:
        # Python's answer to a NUL in a path.
        raise kind.error(f"cannot read the {noun} {name}: no file can have that name") from None


def _check_file(status: os.stat_result, name: str, kind: Kind) -> None:
    noun = kind.noun
    if stat.S_ISDIR(status.st_mode):
        raise kind.error(f"cannot read the {noun} {name}: it is a directory; name a CSV file in it")
    if not stat.S_ISREG(status.st_mode):
        raise kind.error(
            f"cannot read the {noun} {name}: it is a device or a pipe; a {noun} must be a regular file"
        )
    if status.st_size > LARGEST_FILE:
        raise kind.error(
            f"cannot read the {noun} {name}: it has {status.st_size // 10**6} MB;"
            f" a {noun} has at most {LARGEST_FILE // 10**6} MB"
        )


def _check_line(raw: bytes, number: int, name: str, kind: Kind) -> None:
    if number > MOST_LINES:
        raise kind.error(
            f"{name} has more than {MOST_LINES} lines; at most {MOST_LINES - 1} {kind.points}s are read"
        )
    if len(raw) > LONGEST_LINE:
        raise kind.error(
            f"{place(name, number)}: the line is longer than {LONGEST_LINE} bytes;"
            f" a {kind.noun} has one {kind.points} a line"
        )


def _text(raw: bytes, number: int, name: str, kind: Kind) -> str:
    try:
        line = raw.decode()
    except UnicodeDecodeError as error:
        byte = raw[error.start]
        raise kind.error(
            f"{place(name, number)}: the byte 0x{byte:02x} is not UTF-8; save the {kind.noun} as CSV in UTF-8"
        ) from None
    control = _CONTROL.search(line)
    if control:
        raise kind.error(
            f"{place(name, number)}: the character U+{ord(control[0]):04X} is in no text file;"
            f" a {kind.noun} is a CSV file, with lines that end in LF or CRLF"
        )
    return line
