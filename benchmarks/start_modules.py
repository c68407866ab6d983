"""Print where a start goes: the interpreter, click, flint, more of Python, kurbel's modules, and the page.

python -m benchmarks.start_modules [--runs 15] [COMMAND]      by default table --ratio 1:5

What modules take is as `python -X importtime` says, of each the least of all runs; what is left of the
command's processor time is the page itself. Last come those of kurbel's modules that take longest.
"""

from __future__ import annotations

import argparse
import re
import subprocess
import sys

from tabulate import tabulate

from benchmarks.race import ENVIRONMENT, KURBEL, Contestant, kurbel, python

IMPORTED = re.compile(r"^import time: +(\d+) \| +\d+ \| +(\S+)$", re.MULTILINE)
LONGEST = 12


def times_of(code: list[str], runs: int) -> dict[str, int]:
    """Return the microseconds of each module that is loaded."""
    found: dict[str, int] = {}
    for _ in range(runs):
        command = [sys.executable, "-X", "importtime", *code]
        told = subprocess.run(command, capture_output=True, text=True, check=True, env=ENVIRONMENT).stderr
        for time, name in IMPORTED.findall(told):
            found[name] = min(int(time), found.get(name, int(time)))
    return found


def least(command: Contestant, runs: int) -> float:
    """Return the seconds of processor time of a command; its first run fills caches and does not count."""
    with command.ready() as once:
        once()
        return min(once().processor for _ in range(runs))


def shares(words: list[str], runs: int) -> tuple[list[tuple[str, int, float]], dict[str, int]]:
    """Return the parts of a start with their modules and milliseconds, and kurbel's modules."""
    bare, click, both = (
        times_of(["-c", code], runs) for code in ("pass", "import click", "import click, flint")
    )
    loaded = {name: time for name, time in times_of([KURBEL, *words], runs).items() if name not in bare}
    own = {name: time for name, time in loaded.items() if name.split(".")[0] == "kurbel"}
    parts = {
        "click and what it loads": {name: loaded[name] for name in loaded.keys() & click.keys()},
        "flint": {name: loaded[name] for name in loaded.keys() & both.keys() - click.keys()},
        "more of Python and libraries": {
            name: time for name, time in loaded.items() if name not in both and name not in own
        },
        "kurbel's modules": own,
    }
    nothing, whole = least(python("pass"), runs), least(kurbel(" ".join(words)), runs)
    rows = [(part, len(times), sum(times.values()) / 1000) for part, times in parts.items()]
    rest = 1000 * (whole - nothing) - sum(time for _, _, time in rows)
    interpreter = ("the interpreter", len(bare), 1000 * nothing)
    return [interpreter, *rows, ("reading, computing, setting", 0, rest)], own


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=15)
    parser.add_argument("words", nargs=argparse.REMAINDER, metavar="COMMAND")
    given = parser.parse_args()
    words = given.words or ["table", "--ratio", "1:5"]
    rows, own = shares(words, given.runs)
    heads = (f"kurbel {' '.join(words)}", "modules", "ms")
    print(tabulate(rows, headers=heads, floatfmt=".1f"))
    longest = sorted(own.items(), key=lambda one: -one[1])[:LONGEST]
    print()
    print(tabulate([(name, time / 1000) for name, time in longest], headers=("module", "ms"), floatfmt=".1f"))


if __name__ == "__main__":
    main()
