"""The rows of all races as one table: text for a terminal, Markdown for docs/speed.md."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from tabulate import tabulate

from benchmarks.race import Race, Row, Taken

HEADS = ("what", "kurbel", "beside it", "takes", "kurbel : it", "asked")
RIGHT = ("left", "right", "left", "right", "right", "left")
PREFIXES = ((1e9, "G"), (1e6, "M"), (1e3, "k"))


class Cells(NamedTuple):
    """A row as it is printed."""

    what: str
    kurbel: str
    beside: str
    its: str
    ratio: str
    asked: str


def measured(race: Race, taken: Mapping[str, Taken]) -> list[Cells]:
    """Return the rows of a race that was run."""
    return [_cells(row, race, taken) for row in race.rows]


def _cells(row: Row, race: Race, taken: Mapping[str, Taken]) -> Cells:
    asked = f"at most {ratio(row.aim)}" if row.aim else ""
    if row.kurbel not in taken or (row.beside not in taken and not row.limit):
        return Cells(row.what, "", row.beside, "not installed", "", asked)
    if row.limit:
        figures, show = (taken[row.kurbel].memory, row.limit), memory
        shown = [show(one) for one in figures]
    elif row.error:
        figures = (taken[row.kurbel].errors[row.error], taken[row.beside].errors[row.error])
        shown = [f"{_three(one)} ulp" for one in figures]
    else:
        figures = (getattr(taken[row.kurbel], race.clock), getattr(taken[row.beside], race.clock))
        shown = [time(figures[0], row.times), time(figures[1], row.its_times or row.times)]
    share = figures[0] / figures[1]
    missed = ", missed" if row.aim and share > row.aim else ""
    return Cells(row.what, shown[0], row.beside, shown[1], ratio(share), asked + missed)


def ratio(share: float) -> str:
    """Return how many times as much, below one as a fraction of one."""
    return _three(share) if share > 0.95 else f"1/{_three(1 / share)}"


def time(seconds: float, count: int = 0) -> str:
    """Return a time, and how many of the things that were done that is a second."""
    taken = f"{_three(seconds)} s" if seconds >= 1 else f"{_three(seconds * 1e3)} ms"
    return f"{taken}, {_rate(count / seconds)}/s" if count else taken


def memory(size: float) -> str:
    return f"{size:.0f} MiB"


def _rate(rate: float) -> str:
    for least, prefix in PREFIXES:
        if rate >= least:
            return f"{_three(rate / least)} {prefix}"
    return _three(rate) + " "


def _three(value: float) -> str:
    """Return a number with about three digits, of thousands all."""
    return f"{value:,.0f}".replace(",", " ") if value >= 99.5 else f"{value:.3g}"


def text(rows: Sequence[Cells]) -> str:
    return tabulate(rows, headers=HEADS, disable_numparse=True, colalign=RIGHT)


def markdown(rows: Sequence[Cells]) -> str:
    lines = [" | ".join(row).join(("| ", " |")) for row in (HEADS, *rows)]
    rule = "| " + " | ".join("---:" if side == "right" else "---" for side in RIGHT) + " |"
    return "\n".join((lines[0], rule, *lines[1:]))
