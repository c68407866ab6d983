"""Which step of a construction a part of its drawing belongs to, by its id."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from kurbel.books.constructions import model
from kurbel.books.constructions.model import Construction

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_STEP = re.compile(r"step-(\d+)-")


def step_of(shown: Construction) -> Callable[[str], int]:
    """Return what says the number of the step by an id, 0 for one of none."""
    lengths = dict(_lengths(shown))

    def step(name: str) -> int:
        found = _STEP.match(name)
        return int(found[1]) if found else lengths.get(name, 0)

    return step


def _lengths(shown: Construction) -> Iterator[tuple[str, int]]:
    """Yield the ids of lengths that are read off, which have those of their letters, with their steps."""
    ends = {one.ends: one.letters for one in shown.lengths}
    for number, step in enumerate(shown.steps, 1):
        for one in step.drawn:
            if isinstance(one, model.Measure):
                yield f"length-{one.letters}", number
            elif isinstance(one, model.Arrow | model.Line) and (one.start, one.end) in ends:
                yield f"length-{ends[one.start, one.end]}", number


def hide_later(axes: Axes, shown: Construction, last: int) -> None:
    """Hide what is drawn after a step; what is left stays where it is."""
    step = step_of(shown)
    for one in (*axes.lines, *axes.patches, *axes.texts):
        one.set_visible(step(str(one.get_gid() or "")) <= last)
