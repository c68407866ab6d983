"""The lines of a card's file, read one by one within bounds: no file, however strange, fills the memory."""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Iterator

from kurbel.errors import CardError

LARGEST_FILE = 10**8
LONGEST_LINE = 10_000
# A million points below their head.
MOST_LINES = 10**6 + 1

_BOM = "\ufeff"
_CONTROL = re.compile(r"[\x00-\x08\x0a-\x1f\x7f]")
# A spreadsheet writes its empty rows as delimiters alone.
_BLANKS = ";,\t "


def said_lines(path: str | os.PathLike[str]) -> Iterator[tuple[int, str]]:
    """Yield the lines that are neither empty nor comments, each with its number from 1, without its end.

    UTF-8 with or without BOM; LF or CRLF; a comment starts with #. At most MOST_LINES lines of LONGEST_LINE
    bytes are read, from a regular file only: a device or a pipe may never end.
    """
    name = shown(path)
    for number, raw in enumerate(_raw_lines(path, name), 1):
        line = _text(raw, number, name)
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
    name = "".join(char if char.isprintable() else "?" for char in os.fsdecode(path))
    return name if len(name) <= 60 else f"...{name[-57:]}"


def _raw_lines(path: str | os.PathLike[str], name: str) -> Iterator[bytes]:
    if name in ("", "-"):
        raise CardError("a card is read from a file, not from standard input; give the file's name")
    try:
        _check_file(os.stat(path), name)
        with open(path, "rb") as file:
            for number in range(1, MOST_LINES + 2):
                raw = file.readline(LONGEST_LINE + 1)
                if not raw:
                    return
                _check_line(raw, number, name)
                yield raw.rstrip(b"\r\n")
    except OSError as error:
        raise CardError(f"cannot read the card {name}: {error.strerror or error}") from error
    except ValueError:
        # Python's answer to a NUL in a path.
        raise CardError(f"cannot read the card {name}: no file can have that name") from None


def _check_file(status: os.stat_result, name: str) -> None:
    if stat.S_ISDIR(status.st_mode):
        raise CardError(f"cannot read the card {name}: it is a directory; name a CSV file in it")
    if not stat.S_ISREG(status.st_mode):
        raise CardError(
            f"cannot read the card {name}: it is a device or a pipe; a card must be a regular file"
        )
    if status.st_size > LARGEST_FILE:
        raise CardError(
            f"cannot read the card {name}: it has {status.st_size // 10**6} MB;"
            f" a card has at most {LARGEST_FILE // 10**6} MB"
        )


def _check_line(raw: bytes, number: int, name: str) -> None:
    if number > MOST_LINES:
        raise CardError(f"{name} has more than {MOST_LINES} lines; at most {MOST_LINES - 1} points are read")
    if len(raw) > LONGEST_LINE:
        raise CardError(
            f"{place(name, number)}: the line is longer than {LONGEST_LINE} bytes;"
            " a card has one point a line"
        )


def _text(raw: bytes, number: int, name: str) -> str:
    try:
        line = raw.decode()
    except UnicodeDecodeError as error:
        byte = raw[error.start]
        raise CardError(
            f"{place(name, number)}: the byte 0x{byte:02x} is not UTF-8; save the card as CSV in UTF-8"
        ) from None
    control = _CONTROL.search(line)
    if control:
        raise CardError(
            f"{place(name, number)}: the character U+{ord(control[0]):04X} is in no text file;"
            " a card is a CSV file, with lines that end in LF or CRLF"
        )
    return line
