"""Panels to scale: a unit of the axis and what stands for it among the values are as long on paper."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from kurbel.errors import ProblemError
from kurbel.plot.chart.model import Panel
from kurbel.plot.chart.plan import BELOW, LEFT, RIGHT, Plan, Room
from kurbel.plot.style import Size

# In mm: the room beside the curves in their frame, that above and below, the greatest height of a drawing of
# which none is given, that of a panel without a scale, and the least width of the curves.
SIDE, EDGE, MOST_HEIGHT, PLAIN, LEAST = 5.0, 7.0, 185.0, 38.0, 25.0

# From panels, the ends of the axis and the room of each to their plans.
Planned = Callable[[tuple[float, float], Sequence[Room]], list[Plan]]


class _Extent(NamedTuple):
    """The least and the greatest value of a panel, and its scale if it has one."""

    low: float
    high: float
    scale: float | None

    @classmethod
    def of(cls, panel: Panel) -> _Extent:
        values = np.concatenate([np.asarray(curve.values, float) for curve in panel.curves])
        finite = values[np.isfinite(values)]
        return cls(min(float(finite.min()), 0.0), max(float(finite.max()), 0.0), panel.scale)

    def along(self) -> float:
        """Return its height in units of the axis, 0 without a scale."""
        return (self.high - self.low) / self.scale if self.scale else 0.0

    def room(self, room: Room, mm: float, more: float) -> Room:
        """Return the room of the panel with so many mm for a unit of the axis, and so much more height."""
        if not self.scale:
            return room._replace(height=PLAIN)
        height = self.along() * mm + 2 * EDGE + more
        middle, half = (self.low + self.high) / 2, height / mm * self.scale / 2
        return room._replace(height=height, limits=(middle - half, middle + half))


def plans_to_scale(
    panels: Sequence[Panel], span: tuple[float, float], rooms: Sequence[Room], size: Size, planned: Planned
) -> list[Plan]:
    """Return the panels as large as the size allows, or as a page of usual height does; what is wider than
    the curves need is theirs on both sides."""
    extents, way = [_Extent.of(panel) for panel in panels], span[1] - span[0]
    mm = (size.width - LEFT - RIGHT - 2 * SIDE) / way
    most = size.height or (None if size.exact else MOST_HEIGHT)
    plans = _planned(extents, span, rooms, mm, size, planned)
    # Legends may need more rows in less width.
    for _ in range(3 if most else 0):
        assert most is not None
        scaled = sum(extent.along() for extent in extents)
        over = _height(plans) - most
        mm = min(mm, mm - over / scaled) if over > 0 else mm
        if mm * way < LEAST:
            raise ProblemError(
                f"the drawing is {size.width:.6g} mm wide and at most {most:.6g} mm high; these curves, which"
                f" are to scale, need {LEAST + 2 * SIDE + LEFT + RIGHT:.6g} mm of width and more height"
            )
        plans = _planned(extents, span, rooms, mm, size, planned)
    if size.height:
        count = sum(bool(extent.scale) for extent in extents)
        plans = _planned(extents, span, rooms, mm, size, planned, (size.height - _height(plans)) / count)
    return plans


def _planned(
    extents: Sequence[_Extent],
    span: tuple[float, float],
    rooms: Sequence[Room],
    mm: float,
    size: Size,
    planned: Planned,
    more: float = 0.0,
) -> list[Plan]:
    width = size.width - LEFT - RIGHT if size.exact else (span[1] - span[0]) * mm + 2 * SIDE
    middle, half = sum(span) / 2, width / mm / 2
    own = [
        extent.room(room._replace(width=width), mm, more) for extent, room in zip(extents, rooms, strict=True)
    ]
    return planned((middle - half, middle + half), own)


def _height(plans: Sequence[Plan]) -> float:
    return BELOW + sum(plan.top() + plan.room.height for plan in plans)
