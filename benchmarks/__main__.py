"""Measure kurbel beside its peers: python -m benchmarks [NAME ...] [--quick] [--rounds N] [--write]

All of it takes some ten minutes, --quick with small sizes one; --write puts the table into docs/speed.md.
"""

from __future__ import annotations

import argparse
import os
import platform
import re
import sys
from collections.abc import Iterator, Sequence
from importlib import import_module
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from textwrap import fill

from benchmarks.race import Race, Taken, run
from benchmarks.table import Cells, markdown, measured, text

NAMES = ("start", "motion", "engines", "long_tables", "columns_csv", "handbook", "sweeps")
# What needs more than `make bench` sets up.
OTHERS = ("playground",)
LIBRARIES = (
    "numpy", "scipy", "python-flint", "numba", "numexpr", "pyarrow", "polars", "pandas", "matplotlib", "dask",
)  # fmt: skip
PAGE = Path(__file__).parents[1] / "docs" / "speed.md"
BEGIN, END = "<!-- python -m benchmarks --write -->\n", "<!-- /benchmarks -->\n"


def races(name: str, quick: bool = False) -> Iterator[Race]:
    """Return the races of a module."""
    yield from import_module(f"benchmarks.{name}").races(quick)


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=(__doc__ or "").splitlines()[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"{', '.join(NAMES)}, {', '.join(OTHERS)}")
    parser.add_argument("--quick", action="store_true", help="small sizes")
    parser.add_argument("--rounds", type=int, help="how often each runs; the least time counts")
    parser.add_argument("--write", action="store_true", help="put the table into docs/speed.md")
    asked = parser.parse_args()
    if unknown := [name for name in asked.names if name not in (*NAMES, *OTHERS)]:
        parser.error(f"there is no {' and no '.join(unknown)}; there are {', '.join((*NAMES, *OTHERS))}")
    if asked.write and (asked.quick or asked.names):
        parser.error("--write takes all of it in full size, or the page would have the rows of several runs")
    rows = list(results(asked.names or NAMES, asked.quick, asked.rounds))
    print(f"{text(rows)}\n\n{conditions()}")
    if asked.write:
        PAGE.write_text(renewed(PAGE.read_text(encoding="utf-8"), rows), encoding="utf-8")


def results(names: Sequence[str], quick: bool, rounds: int | None) -> Iterator[Cells]:
    for name in names:
        for race in races(name, quick):
            print(f"measuring {race.rows[0].what}", file=sys.stderr)
            taken: dict[str, Taken] = run(race, rounds)
            yield from measured(race, taken)


def conditions() -> str:
    """Return what was measured on: the processor, Python and the libraries."""
    known = [f"{name} {found}" for name in LIBRARIES if (found := _version(name))]
    line = f"{_processor()}; {platform.system()}, Python {platform.python_version()}; {', '.join(known)}."
    return fill(line, 120, break_long_words=False, break_on_hyphens=False)


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    named = re.search(r"model name\s*: (.+)", info.read_text()) if info.exists() else None
    return f"{named[1] if named else platform.machine()}, {os.cpu_count()} cores"


def _version(name: str) -> str | None:
    try:
        return version(name)
    except PackageNotFoundError:
        return None


def renewed(page: str, rows: Sequence[Cells]) -> str:
    """Return the page with the table of these rows between its marks."""
    before, begin, rest = page.partition(BEGIN)
    _, end, after = rest.partition(END)
    assert begin and end, f"{PAGE} has lost its marks"
    return f"{before}{BEGIN}\n{markdown(rows)}\n\n{conditions()}\n\n{END}{after}"


if __name__ == "__main__":
    main()
