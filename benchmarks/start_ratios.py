"""Print how many times the floor of its libraries each small page costs, from a cold start.

python benchmarks/start_ratios.py [--runs 25]

Each line is whole processes, processor time of user and system together. A page is held against a process
that only imports click and flint, a drawing against one that saves an empty figure of matplotlib as SVG. All
of them run in turn, so that a machine that slows down slows all of them alike; of each the least time counts.
"""

from __future__ import annotations

import argparse
import compileall
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from tabulate import tabulate

import kurbel

# A wheel brings what it has compiled or its installer compiles it; so is it here, before anything is timed.
ENVIRONMENT = {
    name: value
    for name, value in os.environ.items()
    if name != "PYTHONDONTWRITEBYTECODE" and not name.startswith("KURBEL_")
}
KURBEL = str(Path(sys.executable).with_name("kurbel"))
PAGES, DRAWING = "click and flint", "an empty figure"
EMPTY_FIGURE = """
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
import os
FigureCanvasSVG(Figure()).print_svg(os.devnull)
"""
FLOORS = {PAGES: "import click, flint", DRAWING: EMPTY_FIGURE}


@dataclass(frozen=True)
class Start:
    """A command, what it is held against, and how many times that it may cost."""

    words: str
    floor: str
    aim: float


STARTS = (
    Start("table --ratio 1:5", PAGES, 1.5),
    Start("table --ratio 1:5 -f html", PAGES, 2.0),
    Start("table --ratio 1:5 -f latex", PAGES, 2.0),
    Start("delta --eps 2..6", PAGES, 2.0),
    Start("solve --ratio 1:5 --where p=0", PAGES, 2.0),
    Start("harmonics", PAGES, 2.0),
    Start("inertia --ratio 1:5 --centre 0.65 --gyration 0.35", PAGES, 2.5),
    Start("inertia --ratio 1:5 --centre 0.65 --gyration 0.35 --layout inertia-errors", PAGES, 2.5),
    Start("plot --ratio 1:5 -o plot.svg", DRAWING, 1.5),
)


def commands() -> dict[str, list[str]]:
    """Return what is run, by its name: the floors, then the commands."""
    floors = {name: [sys.executable, "-c", code] for name, code in FLOORS.items()}
    return floors | {start.words: [KURBEL, *start.words.split()] for start in STARTS}


def seconds(command: list[str], folder: str) -> float:
    """Return the processor time of a process."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, env=ENVIRONMENT, cwd=folder)
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise subprocess.CalledProcessError(process.returncode, command)
    return used.ru_utime + used.ru_stime


def measured(runs: int) -> dict[str, float]:
    """Return the least time of each command; the first run of each, which fills caches, does not count."""
    compileall.compile_dir(Path(kurbel.__file__).parent, quiet=1)
    with TemporaryDirectory() as folder:
        rounds = [
            {name: seconds(command, folder) for name, command in commands().items()} for _ in range(runs + 1)
        ]
    return {name: min(one[name] for one in rounds[1:]) for name in rounds[0]}


def ratios(times: dict[str, float]) -> list[tuple[Start, float]]:
    """Return each command with how many times its floor it costs."""
    return [(start, times[start.words] / times[start.floor]) for start in STARTS]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=25)
    times = measured(parser.parse_args().runs)
    floors = [(name, f"{1000 * times[name]:.0f}", "", "1.00", "") for name in FLOORS]
    rows = [
        (
            f"kurbel {start.words}",
            f"{1000 * times[start.words]:.0f}",
            start.floor,
            f"{ratio:.2f}",
            f"{start.aim}",
        )
        for start, ratio in ratios(times)
    ]
    heads = ("process", "ms", "floor", "times its floor", "aim")
    print(tabulate(floors + rows, headers=heads, disable_numparse=True))


if __name__ == "__main__":
    main()
