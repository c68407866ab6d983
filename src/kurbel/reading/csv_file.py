"""A user's CSV file: its lines, read one by one within bounds, and its columns, found by their heads.

A head is a name and perhaps a unit, as `mass [kg]`, `mass (kg)`, `mass/kg`, `mass in kg` or `mass kg`; a
value may have its unit behind it, as `8,1 kg`. Semicolons, tabs or commas part the columns; a decimal comma
is read where commas do not part. Columns are in any order, those of other names are left out. No file,
however strange, fills memory.
"""

from __future__ import annotations

import csv
import os
import re
import stat
from collections.abc import Callable, Collection, Iterator, Sequence
from typing import NamedTuple, TypeVar

from kurbel.errors import KurbelError, NotationError

Row = TypeVar("Row")

LARGEST_FILE = 10**8
LONGEST_LINE = 10_000
# A million points below their head.
MOST_LINES = 10**6 + 1

_BOM = "\ufeff"
_CONTROL = re.compile(r"[\x00-\x08\x0a-\x1f\x7f]")
# A spreadsheet writes its empty rows as delimiters alone.
_BLANKS = ";,\t "
_HEAD = re.compile(
    r"(?P<name>\w+)\s*(?:\[(?P<square>[^\]]*)\]|/?\s*\((?P<round>[^)]*)\)|(?:/|\bin\b)?(?P<bare>.*))"
)
_VALUE = re.compile(r"([+−-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d{1,3})?)\s*([A-Za-zµ%].*)?", re.ASCII)
_DELIMITERS = ";\t,"
ALL, NONE = slice(None), slice(0)


class Kind(NamedTuple):
    """A kind of file: what messages call it and what is in its lines, and the error that they are."""

    noun: str
    points: str
    error: type[KurbelError]


def numbered_lines(path: str | os.PathLike[str], kind: Kind) -> Iterator[tuple[int, str]]:
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


class Column(NamedTuple):
    """A column that is needed: its place in the row and the unit in its head, "" if there is none."""

    name: str
    place: int
    unit: str


class Head(NamedTuple):
    """The columns that are needed, in the order of their names, and how a row is parted."""

    columns: tuple[Column, ...]
    delimiter: str
    width: int


def read_rows(
    path: str | os.PathLike[str],
    kind: Kind,
    head_of: Callable[[str], Head],
    row_of: Callable[[list[str], Head, int], Row],
    starts: str,
    numbers: slice = ALL,
    refused: type[KurbelError] = NotationError,
) -> Iterator[Row]:
    """Yield what `row_of` makes of the texts in the head's columns, of each row with the number of its line.

    `numbers` are the columns in which a decimal mark is one. NotationErrors and what else is `refused` become
    errors of the kind, with the file's name and line; so does a file without a head, which `starts` names.
    """
    name, head, marks = shown(path), None, ""
    for line_number, line in numbered_lines(path, kind):
        try:
            if head is None:
                head = head_of(line)
                continue
            texts = read_row(line, head)
            marks = decimal_marks(texts[numbers], marks)
            row = row_of(texts, head, line_number)
        except (NotationError, refused) as error:
            raise kind.error(f"{place(name, line_number)}: {error}") from None
        yield row
    if head is None:
        raise kind.error(f"{name} is empty; {starts}")


def read_head(line: str, names: Sequence[str]) -> tuple[Head, list[str]]:
    """Return those columns of a line of heads that have one of the names, and all its heads as they stand.

    Raises NotationError where quotes do not match.
    """
    # The delimiter that parts the line into most of the columns sought, or into most columns; quotes match
    # for the right one only.
    split = {delimiter: _fields(line, delimiter, strict=False) for delimiter in _DELIMITERS}
    delimiter = max(split, key=lambda one: (len(_columns(split[one], names)), len(split[one])))
    fields = _fields(line, delimiter)
    columns = sorted(_columns(fields, names), key=lambda column: names.index(column.name))
    return Head(tuple(columns), delimiter, len(fields)), [field.strip() for field in fields]


def whole_head(line: str, delimiters: str = _DELIMITERS) -> Head:
    """Return all columns of a line of heads, by their heads as they stand."""
    delimiter = max(delimiters, key=lambda one: len(_fields(line, one, strict=False)))
    fields = [field.strip() for field in _fields(line, delimiter)]
    columns = tuple(Column(field, index, "") for index, field in enumerate(fields))
    return Head(columns, delimiter, len(fields))


def _columns(fields: Sequence[str], names: Collection[str]) -> list[Column]:
    found = [(index, *name_and_unit(field)) for index, field in enumerate(fields)]
    return [Column(name, index, unit) for index, name, unit in found if name in names]


def name_and_unit(field: str) -> tuple[str, str]:
    """Return the name in a head, in small letters, and its unit."""
    match = _HEAD.fullmatch(field.strip())
    if match is None:
        return field.strip(), ""
    unit = next(unit for unit in match.group("square", "round", "bare") if unit is not None)
    return match["name"].casefold(), unit.strip()


def check_once(head: Head, noun: str) -> None:
    """Raise NotationError where two columns have one name."""
    names = [column.name for column in head.columns]
    for name in names:
        if names.count(name) > 1:
            raise NotationError(f"{names.count(name)} columns are headed {name}; a {noun} has one")


def read_row(line: str, head: Head) -> list[str]:
    """Return the texts in the columns of the head; raise NotationError for a row of another length."""
    fields = _fields(line, head.delimiter)
    if len(fields) != head.width:
        advice = "; with decimal commas, part the columns by semicolons" if head.delimiter == "," else ""
        raise NotationError(f"the row has {len(fields)} fields where the head has {head.width}{advice}")
    return [fields[column.place].strip() for column in head.columns]


def _fields(line: str, delimiter: str, strict: bool = True) -> list[str]:
    if '"' not in line:
        return line.split(delimiter)
    try:
        return next(csv.reader([line], delimiter=delimiter, skipinitialspace=True, strict=strict))
    except csv.Error as error:
        raise NotationError(f"the quotes do not match ({error})") from None


def decimal_marks(texts: Sequence[str], known: str) -> str:
    """Return the decimal mark seen so far; a file has one, for beside commas 1.013 may be a thousand."""
    joined = "".join(texts)
    marks = "".join(mark for mark in ".," if mark in known or mark in joined)
    if len(marks) > 1:
        raise NotationError(
            "decimal points and decimal commas are mixed from here on; write one of them,"
            " and no thousands marks"
        )
    return marks


def digits_and_unit(text: str, column: Column, delimiter: str, example: str) -> tuple[str, str]:
    """Return the number in a field as it is written, and its unit, from the field or the head.

    Raises NotationError for what is no number, or has two units.
    """
    match = _VALUE.fullmatch(text)
    if match is None or (delimiter == "," and "," in match[1]):
        raise NotationError(f'{column.name} "{clipped(text)}" is not a number; write it as {example}')
    digits, unit = match.groups()
    if unit and column.unit:
        raise NotationError(
            f'{column.name} "{clipped(text)}" has a unit behind the value and one in the head,'
            f" {clipped(column.unit)}; write it once"
        )
    return digits, unit or column.unit


def clipped(text: str, most: int = 40) -> str:
    """Return a text for a message, not longer than so many characters."""
    return text if len(text) <= most else f"{text[: most - 3]}..."
