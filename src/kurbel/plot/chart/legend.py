"""A legend above a frame, read along its rows."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from kurbel.plot.style import MM, TEXT_SIZE

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

LEGEND_ROW, SAMPLE, SAMPLE_GAP, LEGEND_GAP = 4.2, 9.0, 1.5, 4.0


def draw_legend(
    axes: Axes, drawn: Sequence[Artist], texts: Sequence[str], columns: int, above: float, side: str = "right"
) -> None:
    """Draw the legend of lines, at a height above the frame that is a share of the frame's."""
    in_sizes = MM / TEXT_SIZE
    # matplotlib fills the columns one after the other; we read along the rows.
    order = [place for column in range(columns) for place in range(len(drawn))[column::columns]]
    axes.legend(
        [drawn[place] for place in order],
        [texts[place] for place in order],
        loc="lower left" if side == "left" else "lower right",
        bbox_to_anchor=(0 if side == "left" else 1, 1 + above),
        ncols=columns,
        frameon=False,
        handlelength=SAMPLE * in_sizes,
        handletextpad=SAMPLE_GAP * in_sizes,
        columnspacing=LEGEND_GAP * in_sizes,
        labelspacing=0.35,
        borderaxespad=0,
        borderpad=0.3,
    )
