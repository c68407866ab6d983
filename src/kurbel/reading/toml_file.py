"""TOML files that users write: read whole, with a sentence for what is none, and where their keys stand."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import Any, NamedTuple

from kurbel.errors import KurbelError

Place = tuple[str | int, ...]


class TomlKind(NamedTuple):
    """What a file is called, what is wrong with it, how large it may be, what it has, and a name for one."""

    name: str
    error: type[KurbelError]
    largest: int
    shape: str
    example: str


def read_toml(path: str, kind: TomlKind) -> dict[str, Any]:
    """Return what the file says; raise the kind's error, with the file's name, for one that says nothing."""
    return parsed(path, kind, text_of(path, kind))


def parsed(path: str, kind: TomlKind, text: str) -> dict[str, Any]:
    """Return what the text of the file says."""
    import tomllib

    if _LONG_KEY.search(text):
        raise kind.error(f"{path} has a key of very many parts; {kind.shape}")
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise kind.error(f"{path} is nested too deeply; {kind.shape}") from None
    except ValueError as error:
        # A malformed file is a ValueError that says the line.
        raise kind.error(f"cannot read the {kind.name} {path}: {error}") from None


# The parser takes minutes over them.
_LONG_KEY = re.compile(r"(?:[A-Za-z0-9_\"'-]{1,50}[ \t]{0,9}\.[ \t]{0,9}){200}")


def text_of(path: str, kind: TomlKind) -> str:
    """Return the text of the file."""
    if not path:
        raise kind.error(f"the {kind.name}'s file has no name; give one, such as {kind.example}")
    if os.path.exists(path) and not os.path.isfile(path):
        raise kind.error(
            f"cannot read the {kind.name} {path}: it is a directory or a device; name a TOML file"
        )
    try:
        with open(path, "rb") as file:
            content = file.read(kind.largest + 1)
    except FileNotFoundError:
        raise kind.error(f"cannot read the {kind.name} {path}: there is no such file") from None
    except (OSError, ValueError) as error:
        raise kind.error(f"cannot read the {kind.name} {path}: {error}") from None
    if len(content) > kind.largest:
        raise kind.error(f"{path} has more than {kind.largest} bytes; no {kind.name} needs them")
    try:
        # An editor may have put a mark before the text.
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        raise kind.error(
            f"{path}, line {line}: the byte 0x{content[error.start]:02x} is not UTF-8;"
            f" save the {kind.name} so"
        ) from None


def shown(value: Any) -> str:
    """What a value is, in the words of a TOML file."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, list):
        return "a list" if value else "an empty list"
    return f'"{value}"'[:42] if isinstance(value, str) else str(value)[:40]


_HEAD = re.compile(r"\s*(\[\[?)\s*([^\]]+?)\s*\]\]?\s*(?:#.*)?$")
_KEY = re.compile(r"\s*([A-Za-z0-9_-]+(?:\s*\.\s*[A-Za-z0-9_-]+)*|\"[^\"]*\"|'[^']*')\s*=")
_LONG_TEXT = re.compile(r'"""|\'\'\'')


def key_lines(text: str) -> dict[Place, int]:
    """Return the line, from 1, of each key and section of a file that was read without an error.

    The place of a key is its path: ("chapter", 0, "part", 2, "run"). Keys inside of tables and lists that
    stand on one line have none.
    """
    lines: dict[Place, int] = {}
    section: Place = ()
    counts: dict[Place, int] = {}
    for number, line in _lines_of_keys(text):
        if head := _HEAD.match(line):
            section = _section(head[2].split("."), counts, several=head[1] == "[[")
            lines[section] = number
        elif key := _KEY.match(line):
            names = tuple(part.strip().strip("\"'") for part in key[1].split("."))
            lines.setdefault(section + names, number)
    return lines


def _lines_of_keys(text: str) -> Iterator[tuple[int, str]]:
    """Yield the lines that do not lie inside of a text of several lines."""
    closing = ""
    for number, line in enumerate(text.split("\n"), 1):
        if not closing:
            yield number, line
        for mark in _LONG_TEXT.findall(line):
            closing = "" if mark == closing else closing or mark


def _section(names: list[str], counts: dict[Place, int], several: bool) -> Place:
    """Return the path of a section; in a list of sections, with its number."""
    path: Place = ()
    for place, name in enumerate(names, 1):
        path += (name.strip().strip("\"'"),)
        if place == len(names) and several:
            counts[path] = counts.get(path, -1) + 1
        if path in counts:
            path += (counts[path],)
    return path
