"""The cells of a page computed a second time, from the request that its JSON carries.

A cell is confirmed, wrong, or not computed, with the reason why: no cell counts as right because nothing was
found.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple, TypedDict, TypeGuard

from kurbel.commands.requested import Figure
from kurbel.commands.second import Head, SecondComputation
from kurbel.errors import ProblemError

SHAPE = {"request": dict, "columns": list, "rows": list}


class Cell(NamedTuple):
    """A cell of a page: its row, counted from 1, with what stands there beside the numbers, the key of its
    column, what is printed, whether it is confirmed, and else the right digits or why there are none."""

    row: int
    place: Mapping[str, str]
    key: str
    printed: str
    verdict: str
    told: str = ""

    def __str__(self) -> str:
        where = ", ".join(f"{key} {value}" for key, value in self.place.items())
        return f"{self.key} at {where} is printed {self.printed}; right is {self.told}"


class Request(TypedDict):
    """What a page in JSON was made of."""

    command: str
    options: dict[str, object]


class Page(TypedDict):
    """A page in JSON, as far as it is computed a second time."""

    table: str
    request: Request
    columns: list[Head]
    rows: list[dict[str, str | None]]


def read_page(path: str) -> Page:
    """Return the page of a JSON file, of standard input for "-". Raises KurbelError."""
    name = "standard input" if path == "-" else path
    try:
        text = sys.stdin.read() if path == "-" else Path(path).read_text(encoding="utf-8")
    except OSError as error:
        raise ProblemError(f"{name} cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise ProblemError(f"{name} is no JSON: it is not UTF-8; write a page with -f json") from None
    return page_of(text, name)


def page_of(text: str, name: str) -> Page:
    """Return the page of a text in JSON, called by a name. Raises KurbelError."""
    try:
        page = json.loads(text, parse_float=Figure, parse_int=Figure)
    except ValueError as error:
        raise ProblemError(f"{name} is no JSON: {error}; write a page with -f json") from None
    if not isinstance(page, dict) or page.keys() & SHAPE.keys() == set():
        raise ProblemError(f"{name} is no page of kurbel's; write one with -f json")
    if "request" not in page:
        raise ProblemError(f"{name} does not say what was asked for; write the page anew with -f json")
    if wrong := next((key for key, kind in SHAPE.items() if not isinstance(page.get(key), kind)), ""):
        raise ProblemError(f"{name} is damaged: its {wrong} cannot be read; write the page anew with -f json")
    if not _is_whole(page):
        raise ProblemError(f"{name} is damaged: its columns, a row or what was asked for lack something")
    return page


def _is_whole(page: Mapping[str, Any]) -> TypeGuard[Page]:
    """Whether every row has a text, a number or nothing for every column, and the request its command and
    its options."""
    request, columns, rows = page["request"], page["columns"], page["rows"]
    described = all(
        isinstance(one, dict) and all(isinstance(one.get(name), str) for name in ("key", "unit", "method"))
        for one in columns
    )
    if not described or not isinstance(request.get("options"), dict):
        return False
    keys = {one["key"] for one in columns}
    return isinstance(request.get("command"), str) and all(
        isinstance(row, dict) and keys <= row.keys() and all(isinstance(row[key], str | None) for key in keys)
        for row in rows
    )


def checked(page: Page) -> Iterator[Cell]:
    """Yield the cells of a page with numbers, each computed a second time. Raises KurbelError."""
    options = page["request"]["options"]
    second = SecondComputation(
        page["request"]["command"], options, str(options.get("layout", page.get("table")))
    )
    columns = {column["key"]: column for column in page["columns"]}
    for line, whole in enumerate(page["rows"], 1):
        row = {key: text for key in columns if (text := whole[key]) is not None}
        place = {key: one for key, one in row.items() if not columns[key]["method"]}
        for key, column in columns.items():
            if column["method"] and key in row:
                verdict, told = second.verdict(key, column, row)
                yield Cell(line, place, key, row[key], verdict, told)
