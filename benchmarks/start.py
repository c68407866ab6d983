"""How many times what its libraries cost a small page costs: whole processes, processor time."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from benchmarks.race import Race, Row, kurbel, python

IMPORTS, FIGURE = "`import click, flint`", "saving an empty figure of matplotlib as SVG"
EMPTY, SCRIPT = "an empty Python", "the least script with NumPy and Jinja2"
# Where Python has compiled nothing before.
BARE = ", nothing compiled"
TABLE = "table --ratio 1:5"
EMPTY_FIGURE = """
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
import os
FigureCanvasSVG(Figure()).print_svg(os.devnull)
"""
# What somebody would write who has NumPy and Jinja at hand and needs this one table.
LEAST_SCRIPT = '''
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
FLOORS = {
    IMPORTS: python("import click, flint"),
    IMPORTS + BARE: python("import click, flint", bare=True),
    FIGURE: python(EMPTY_FIGURE, needs="matplotlib"),
    EMPTY: python("pass"),
    SCRIPT: python(LEAST_SCRIPT),
    SCRIPT + BARE: python(LEAST_SCRIPT, bare=True),
}


class Start(NamedTuple):
    """A command line, what it is held against, and how many times that it may cost."""

    words: str
    beside: str
    aim: float | None = None
    bare: bool = False


STARTS = (
    Start(TABLE, SCRIPT, 0.75),
    Start(TABLE, SCRIPT + BARE, 1, bare=True),
    Start(TABLE, IMPORTS + BARE, bare=True),
    Start(TABLE, IMPORTS),
    Start(f"{TABLE} -f html", IMPORTS, 2.8),
    Start(f"{TABLE} -f latex", IMPORTS, 2.8),
    Start("delta --eps 2..6", IMPORTS, 2.8),
    Start("solve --ratio 1:5 --where p=0", IMPORTS, 2.8),
    Start("harmonics", IMPORTS, 2.8),
    Start("inertia --ratio 1:5 --centre 0.65 --gyration 0.35", IMPORTS),
    Start("inertia --ratio 1:5 --centre 0.65 --gyration 0.35 --layout inertia-errors", IMPORTS),
    Start("table --stroke 100mm --rod 250mm", IMPORTS),
    Start("table --stroke 4in --rod 10in", IMPORTS),
    Start("table --ratio 1:5 -o motion.svg", FIGURE, 1.6),
    Start("--help", EMPTY),
)


def races(quick: bool) -> Iterator[Race]:
    commands, rows = {}, []
    for words, beside, aim, bare in STARTS:
        after = BARE if bare else ""
        commands[words + after] = kurbel(words, bare=bare)
        rows.append(Row(f"`kurbel {words}`{after}", words + after, beside, aim))
    yield Race({**FLOORS, **commands}, rows, rounds=5 if quick else 15, clock="processor")
