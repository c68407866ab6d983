"""Time whole processes from a cold start: kurbel, an empty Python, the least script that prints the same.

python benchmarks/bench_start.py
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path
from statistics import median
from typing import Any, cast

from tabulate import tabulate

import kurbel
from kurbel.motion.quantities import registry

RUNS = 15
# The first run, which is not counted, compiles what a wheel would bring compiled.
ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
KURBEL = str(Path(sys.executable).with_name("kurbel"))

# What somebody would write who has NumPy and Jinja at hand and needs this one table.
RIVAL = '''
import numpy as np
from jinja2 import Template

angles = np.arange(0, 181, 10)
phi = np.radians(angles)

def columns(ratio):
    sine, cosine = np.sin(phi), np.cos(phi)
    w = np.sqrt(1 - (ratio * sine) ** 2)
    path = 1 - cosine + (1 - w) / ratio
    velocity = sine + ratio * sine * cosine / w
    return path, velocity, cosine + ratio * (np.cos(2 * phi) + ratio**2 * sine**4) / w**3

pairs = [column for both in zip(columns(0.2), columns(-0.2)) for column in both]
rows = [
    [angle, *(f"{column[i]:.4f}".replace(".", ",") for column in pairs)]
    for i, angle in enumerate(angles)
]
print(Template("""{% for row in rows %}
{{ "%4d"|format(row[0]) }}{% for cell in row[1:] %}{{ "%10s"|format(cell) }}{% endfor %}
{% endfor %}""").render(rows=rows))
'''


def every_force() -> list[str]:
    """Return the command for all forces and motions that a drive with its masses has, each degree."""
    given = {"stroke": "600mm", "rod": "1500mm", "speed": "120/min", "force": "10N", "reciprocating": "200kg"}
    given |= {"rod_mass": "150kg", "centre": "0.6", "gyration": "0.3"}
    about = cast("Any", kurbel.forces_table).question(**given)
    known = [key for key, one in registry().items() if not about.missing(one)]
    typed = [f"--{name.replace('_', '-')}={value}" for name, value in given.items()]
    return [KURBEL, "forces", *typed, "--step", "1", "-f", "csv", "--columns", ",".join(known)]


IN_MILLIMETRES = ("table", "--stroke", "100mm", "--rod", "250mm")
IN_INCHES = ("table", "--stroke", "4in", "--rod", "10in")
COMMANDS = {
    "empty Python": [sys.executable, "-c", "pass"],
    "kurbel --help": [KURBEL, "--help"],
    "kurbel table --ratio 1:5": [KURBEL, "table", "--ratio", "1:5"],
    "the same drive in millimetres": [KURBEL, *IN_MILLIMETRES],
    "the same drive in inches": [KURBEL, *IN_INCHES],
    "kurbel delta --eps 2..6": [KURBEL, "delta", "--eps", "2..6"],
    "kurbel forces, every column with masses at 361 angles": every_force(),
    "script with numpy and jinja2": [sys.executable, "-c", RIVAL],
    "import numpy, scipy.optimize": [sys.executable, "-c", "import numpy, scipy.optimize"],
}


def seconds(command: list[str]) -> float:
    start = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=ENVIRONMENT)
    return time.perf_counter() - start


def main() -> None:
    # In turn, so that a machine that slows down slows all of them.
    rounds = [{name: seconds(command) for name, command in COMMANDS.items()} for _ in range(RUNS + 1)][1:]
    medians = {name: median(run[name] for run in rounds) for name in COMMANDS}
    empty = medians["empty Python"]
    rows = [(name, f"{1000 * time:.0f}", f"{time / empty:.1f}") for name, time in medians.items()]
    print(tabulate(rows, headers=("cold start", "ms, median", "empty Python = 1"), disable_numparse=True))


if __name__ == "__main__":
    main()
