"""The strokes of a polar diagram, each with its own line and its name in a legend."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import ceil
from typing import TYPE_CHECKING, NamedTuple

from kurbel.plot.chart.legend import LEGEND_GAP, SAMPLE, SAMPLE_GAP
from kurbel.plot.chart.model import Strokes
from kurbel.plot.chart.vector import Piece, with_gaps
from kurbel.plot.style import BLACK, LINES, STRONG, size_of, text_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Looks(NamedTuple):
    """The names of strokes from the one that begins nearest to 0° on, each of which has its line, and the
    rows and columns of their legend."""

    names: tuple[str, ...] = ()
    rows: int = 0
    columns: int = 1


def looks_of(strokes: Strokes | None, width: float, mark: str) -> Looks:
    if strokes is None or not strokes.names:
        return Looks()
    count = len(strokes.names)
    first = min(range(count), key=lambda number: abs(strokes.ends[number]))
    order = (*strokes.names[first:], *strokes.names[:first])
    names = tuple(dict.fromkeys(text_of(name, mark) for name in order))
    each = max(size_of(name)[0] for name in names) + SAMPLE + SAMPLE_GAP + LEGEND_GAP
    most = max(1, min(len(names), int((width + LEGEND_GAP) / each)))
    rows = ceil(len(names) / most)
    return Looks(names, rows, ceil(len(names) / rows))


def draw_strokes(axes: Axes, pieces: Sequence[Piece], strokes: Strokes | None, looks: Looks) -> None:
    """Draw the path of the force, stroke by stroke in its own line."""
    if strokes is None:
        curve = axes.plot(*with_gaps([piece.path for piece in pieces]).T, color=BLACK, linewidth=STRONG)
        curve[0].set(zorder=4, gid="curve")
        return
    spans = list(zip(pairwise(strokes.ends), strokes.names, strict=True))
    for number, (name, look) in enumerate(zip(looks.names, LINES, strict=False), 1):
        of_name = [span for span, one in spans if text_of(one, ".") == name]
        parts = [piece.within(*span) for piece in pieces for span in of_name]
        parts = [part for part in parts if len(part) > 1]
        if parts:
            line = axes.plot(*with_gaps(parts).T, color=look.colour, linewidth=look.width, zorder=4)[0]
            line.set_linestyle((0, look.dashes) if look.dashes else "-")
            line.set(gid=f"curve-{number}", label=name)
