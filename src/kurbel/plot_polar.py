"""The force on a pin over the turn: the path of the vector's head, drawn from one origin."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from kurbel.errors import ProblemError
from kurbel.plot_place import AROUND, Box, Points, around, box_points, densely, freest
from kurbel.plot_style import (
    BLACK,
    GREY,
    MEDIUM,
    MM,
    PALE,
    SMALL_TEXT,
    STRONG,
    TEXT_SIZE,
    THIN,
    WIDTH,
    arrowhead,
    page,
    size_of,
    style,
    text_of,
)
from kurbel.plot_ticks import axis_label, power_of_thousand, round_step, value_ticks
from kurbel.table import Label

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LEFT, RIGHT, ABOVE, BELOW = 13.0, 4.0, 7.5, 10.5
MOST_WIDTH, MOST_HEIGHT, LEAST_WIDTH = WIDTH - LEFT - RIGHT, 110.0, 60.0
# Room around the curve for the labels of the angles.
EDGE = 8.0
GRID = 9.0
MARK_STEP = 30


class Vector(NamedTuple):
    """The components of a force at rising angles in degrees; a value that is no finite number is a gap."""

    angles: Sequence[float]
    across: Sequence[float]
    up: Sequence[float]


class _Plan(NamedTuple):
    """A diagram before it is drawn: scale in mm for a unit of force, the frame in units of force."""

    scale: float
    frame: Box
    grid: Fraction
    power: int

    def on_paper(self, points: Points) -> Points:
        import numpy as np

        return np.asarray((points - np.asarray(self.frame[:2])) * self.scale)

    def size(self) -> tuple[float, float]:
        left, bottom, right, top = self.frame
        return (right - left) * self.scale, (top - bottom) * self.scale


def polar(vector: Vector, across: Label, up: Label, unit: Label, mark: str) -> Figure:
    """Return the polar diagram of a force, with a mark every 30° of the crank and one scale both ways.

    The diagram is at most 120 mm wide; across and up name its axes. The arrow on the curve points where
    the angle rises. Raises ProblemError if no vector is finite.
    """
    import numpy as np

    with style():
        path = np.stack((np.asarray(vector.across, float), np.asarray(vector.up, float)), axis=1)
        path[~np.isfinite(path).all(axis=1)] = np.nan
        plan = _plan(path)
        figure, axes = _laid_out(plan)
        _axes(axes, plan, [text_of(axis_label(one, unit, plan.power), mark) for one in (across, up)], mark)
        _scale_bar(axes, plan, unit, mark)
        _curve(axes, plan, path)
        _marks(axes, plan, np.asarray(vector.angles, float), path)
    return figure


def _plan(path: Points) -> _Plan:
    import numpy as np

    finite = path[np.isfinite(path[:, 0])]
    if not finite.any():
        raise ProblemError("the force is nowhere finite and other than 0, so nothing can be drawn")
    # The origin belongs to the diagram.
    low, high = np.minimum(finite.min(axis=0), 0), np.maximum(finite.max(axis=0), 0)
    width, height = (float(side) for side in high - low)
    most = (MOST_WIDTH - 2 * EDGE, MOST_HEIGHT - 2 * EDGE)
    scale = min(room / side for room, side in zip(most, (width, height), strict=True) if side)
    spare = (np.asarray((LEAST_WIDTH, 2 * EDGE)) / scale - (width, height)) / 2
    room = np.maximum(EDGE / scale, spare)
    (left, bottom), (right, top) = (low - room).tolist(), (high + room).tolist()
    power = power_of_thousand((left, bottom, right, top))
    return _Plan(scale, (left, bottom, right, top), round_step(GRID / scale), power)


def _laid_out(plan: _Plan) -> tuple[Figure, Axes]:
    width, height = plan.size()
    total = (LEFT + width + RIGHT, BELOW + height + ABOVE)
    figure = page(total[1], total[0])
    box = (LEFT / total[0], BELOW / total[1], width / total[0], height / total[1])
    left, bottom, right, top = plan.frame
    axes = figure.add_axes(box, label="diagram")
    axes.set(xlim=(left, right), ylim=(bottom, top))
    return figure, axes


def _axes(axes: Axes, plan: _Plan, names: Sequence[str], mark: str) -> None:
    left, bottom, right, top = plan.frame
    for low, high, ticks in ((left, right, axes.set_xticks), (bottom, top, axes.set_yticks)):
        found = value_ticks(low, high, plan.grid, plan.power, mark)
        ticks(found.places, found.texts)
    axes.grid(color=PALE, linewidth=THIN)
    axes.set_axisbelow(True)
    axes.tick_params(width=THIN, length=2, pad=2, labelsize=SMALL_TEXT)
    axes.axhline(0, color=BLACK, linewidth=MEDIUM, zorder=2)
    axes.axvline(0, color=BLACK, linewidth=MEDIUM, zorder=2)
    axes.set_xlabel(names[0], labelpad=3)
    axes.set_title(names[1], loc="left", pad=4, fontsize=TEXT_SIZE)


def _scale_bar(axes: Axes, plan: _Plan, unit: Label, mark: str) -> None:
    """Draw the scale of forces above the frame: it stays true when the drawing is made smaller."""
    _, _, right, top = plan.frame
    step, y = float(plan.grid), top + 2.7 / plan.scale
    ends = (right - step, right)
    axes.plot(ends, (y, y), color=BLACK, linewidth=MEDIUM, clip_on=False, marker="|", markersize=2 * MM)
    number = value_ticks(step * 0.9, step * 1.1, plan.grid, plan.power, ".").texts[0]
    factor = f" · 10^{plan.power}" if plan.power > 0 else f" · 10^({plan.power})" if plan.power else ""
    text = text_of(f"${number}{factor}$ {unit}", mark)
    axes.text(ends[0] - 1.5 / plan.scale, y, text, ha="right", va="center", fontsize=SMALL_TEXT)


def _curve(axes: Axes, plan: _Plan, path: Points) -> None:
    drawn = axes.plot(*path.T, color=BLACK, linewidth=STRONG, zorder=4)[0]
    drawn.set_gid("curve")


def _marks(axes: Axes, plan: _Plan, angles: Points, path: Points) -> None:
    """Draw the vectors at every 30° and write their angles where there is room."""
    import numpy as np

    heads = _heads(angles, path)
    for head in heads.values():
        axes.plot((0, head[0]), (0, head[1]), color=GREY, linewidth=THIN, zorder=3)
        axes.plot(*head[:, None], marker="o", markersize=1.1 * MM, color=BLACK, zorder=5)
    left, bottom, right, top = plan.frame
    lines = [((left, 0), (right, 0)), ((0, bottom), (0, top))]
    shafts = [np.asarray(((0, 0), head)) for head in heads.values()]
    taken = [densely(plan.on_paper(np.asarray(line))) for line in (*lines, *shafts)]
    for angle, head in heads.items():
        taken.append(_mark(axes, plan, f"{angle}°", head, densely(plan.on_paper(path)), taken))
    _arrow(axes, plan, angles, path)


def _mark(axes: Axes, plan: _Plan, text: str, head: Points, line: Points, taken: Sequence[Points]) -> Points:
    """Write the angle beside its mark, at best outward, and return the points that it takes."""
    import numpy as np

    size, at = size_of(text, SMALL_TEXT), plan.on_paper(head)
    others = np.concatenate(taken)
    # Its own vector ends at the mark and may touch the label.
    others = others[np.hypot(*(others - at).T) > 1]
    place = freest(around(at, size, head), size, line, others, (0, 0, *plan.size()), AROUND)
    if place is None:
        return np.empty((0, 2))
    x, y = place / plan.size()
    axes.text(x, y, text, ha="center", va="center", fontsize=SMALL_TEXT, transform=axes.transAxes, zorder=6)
    return box_points(place, size)


def _heads(angles: Points, path: Points) -> dict[int, Points]:
    """Return the vector at every 30°, between two given angles on the line between their vectors."""
    import numpy as np

    first, last = math.ceil(angles[0] / MARK_STEP), math.floor(angles[-1] / MARK_STEP)
    marks = [MARK_STEP * number for number in range(first, last + 1)]
    heads = {angle: _between(angle, angles, path) for angle in marks}
    if len(marks) > 1 and _same(heads[marks[0]], heads[marks[-1]]):
        del heads[marks[-1]]
    return {angle: head for angle, head in heads.items() if np.isfinite(head).all()}


def _same(one: Points, other: Points) -> bool:
    import numpy as np

    return float(np.hypot(*(one - other))) <= 1e-6 * float(np.hypot(*one))


def _between(angle: float, angles: Points, path: Points) -> Points:
    import numpy as np

    return np.asarray([np.interp(angle, angles, component) for component in path.T])


def _arrow(axes: Axes, plan: _Plan, angles: Points, path: Points) -> None:
    """Draw an arrow on the longest piece between two marks, pointing where the angle rises."""
    import numpy as np

    middles = np.arange(angles[0] + MARK_STEP / 2, angles[-1], MARK_STEP)
    pieces = [[_between(one + way, angles, path) for way in (-MARK_STEP / 2, 0, 0.5)] for one in middles]
    pieces = [piece for piece in pieces if np.isfinite(piece).all()]
    if pieces:
        _, tip, beyond = max(pieces, key=lambda piece: float(np.hypot(*(piece[1] - piece[0]))))
        arrowhead(axes, tip, beyond - tip, 1 / plan.scale, size=2.6, slim=0.28)
