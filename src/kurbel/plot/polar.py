"""The force on a pin over the turn: the path of the vector's head, drawn from one origin."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.plot.place import AROUND, Box, Points, around, box_points, densely, freest
from kurbel.plot.style import (
    BLACK,
    GREY,
    MEDIUM,
    MM,
    PALE,
    SMALL_TEXT,
    STRONG,
    TEXT_SIZE,
    THIN,
    WHITE,
    WIDTH,
    arrowhead,
    page,
    size_of,
    style,
    text_of,
)
from kurbel.plot.ticks import axis_label, power_of_thousand, round_step, value_ticks

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LEFT, RIGHT, ABOVE, BELOW = 13.0, 4.0, 7.5, 10.5
MOST_WIDTH, MOST_HEIGHT, LEAST_WIDTH = WIDTH - LEFT - RIGHT, 110.0, 60.0
# The scale stands in a row of its own where it has no room beside the name of the axis.
SCALE_ROW, SCALE_GAP = 4.5, 8.0
# Room around the curve for the labels of the angles.
EDGE = 8.0
GRID = 9.0
MARK_STEP = 30
# The radius of a mark in mm.
MARK = 0.55
# A vector, or a difference of two, of so small a share is none.
NOTHING = 1e-6
CHORD = (6, 4)


# A chord shorter than this, in mm, has no room for an arrow.
LEAST_CHORD = 8.0


class Vector(NamedTuple):
    """The components of a force at rising angles in degrees; a value that is no finite number is a gap.

    Where an angle comes twice the force jumps, from the first of its values to the second.
    """

    angles: Sequence[float]
    across: Sequence[float]
    up: Sequence[float]


class _Piece(NamedTuple):
    """The heads of the vectors at rising angles, without a jump between them."""

    angles: Points
    path: Points

    def at(self, angle: float) -> Points:
        """Return the head at an angle; between two given ones, on the line between their heads."""
        return np.asarray([np.interp(angle, self.angles, component) for component in self.path.T])

    def marked(self) -> range:
        """Return the angles every 30° within it."""
        first, last = math.ceil(self.angles[0] / MARK_STEP), math.floor(self.angles[-1] / MARK_STEP)
        return range(MARK_STEP * first, MARK_STEP * last + 1, MARK_STEP)


class _Plan(NamedTuple):
    """A diagram before it is drawn: scale in mm for a unit of force, the frame in units of force."""

    scale: float
    frame: Box
    grid: Fraction
    power: int
    # In mm: the room above the frame.
    above: float = ABOVE

    def on_paper(self, points: Points) -> Points:
        return np.asarray((points - np.asarray(self.frame[:2])) * self.scale)

    def size(self) -> tuple[float, float]:
        left, bottom, right, top = self.frame
        return (right - left) * self.scale, (top - bottom) * self.scale


def polar(
    vector: Vector, across: Label, up: Label, unit: Label, mark: str, ways: tuple[Label, Label] = ("", "")
) -> Figure:
    """Return the polar diagram of a force, with a mark every 30° of the crank and one scale both ways.

    The diagram is at most 120 mm wide; across and up name its axes, ways their directions. The arrow on
    the curve points where the angle rises. Where the force jumps the curve ends and begins anew; a dashed
    chord leads from the one end to the other. Raises ProblemError if no vector is finite.
    """
    with style():
        path = np.stack((np.asarray(vector.across, float), np.asarray(vector.up, float)), axis=1)
        path[~np.isfinite(path).all(axis=1)] = np.nan
        plan = _plan(path)
        labels = (axis_label(one, unit, plan.power) for one in (across, up))
        names = [text_of(", ".join(filter(None, one)), mark) for one in zip(labels, ways, strict=True)]
        scale = _scale_text(plan, unit, mark)
        bar = float(plan.grid) * plan.scale + SCALE_GAP + size_of(scale, SMALL_TEXT)[0]
        if size_of(names[1])[0] + bar > plan.size()[0]:
            plan = plan._replace(above=ABOVE + SCALE_ROW)
        figure, axes = _laid_out(plan)
        _axes(axes, plan, names, mark)
        _scale_bar(axes, plan, scale)
        angles = np.asarray(vector.angles, float)
        jumps = np.flatnonzero(np.diff(angles) == 0) + 1
        pieces = [_Piece(*one) for one in zip(np.split(angles, jumps), np.split(path, jumps), strict=True)]
        curve = axes.plot(*_with_gaps(pieces).T, color=BLACK, linewidth=STRONG, zorder=4)
        curve[0].set_gid("curve")
        chords = _chords(axes, plan, pieces)
        _marks(axes, plan, pieces, chords)
        _arrow(axes, plan, pieces)
    return figure


def _plan(path: Points) -> _Plan:
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
    total = (LEFT + width + RIGHT, BELOW + height + plan.above)
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


def _scale_text(plan: _Plan, unit: Label, mark: str) -> str:
    step = float(plan.grid)
    number = value_ticks(step * 0.9, step * 1.1, plan.grid, plan.power, ".").texts[0]
    factor = f" · 10^{plan.power}" if plan.power > 0 else f" · 10^({plan.power})" if plan.power else ""
    return text_of(f"${number}{factor}$ {unit}", mark)


def _scale_bar(axes: Axes, plan: _Plan, text: str) -> None:
    """Draw the scale of forces above the frame: it stays true when the drawing is made smaller."""
    _, _, right, top = plan.frame
    step, y = float(plan.grid), top + (plan.above - ABOVE + 2.7) / plan.scale
    ends = (right - step, right)
    axes.plot(ends, (y, y), color=BLACK, linewidth=MEDIUM, clip_on=False, marker="|", markersize=2 * MM)
    axes.text(ends[0] - 1.5 / plan.scale, y, text, ha="right", va="center", fontsize=SMALL_TEXT)


def _with_gaps(pieces: Sequence[_Piece]) -> Points:
    gap = np.full((1, 2), np.nan)
    return np.concatenate([row for piece in pieces for row in (gap, piece.path)][1:])


def _chords(axes: Axes, plan: _Plan, pieces: Sequence[_Piece]) -> list[Points]:
    """Draw what the force leaps over: between two pieces, and after a whole turn back to its beginning."""
    ends = list(pairwise(pieces))
    if (pieces[-1].angles[-1] - pieces[0].angles[0]) % 360 == 0:
        ends.append((pieces[-1], pieces[0]))
    chords = [np.stack((before.path[-1], after.path[0])) for before, after in ends]
    chords = [chord for chord in chords if np.isfinite(chord).all() and not _same(*chord)]
    for number, (start, end) in enumerate(chords, 1):
        across_up = np.stack((start, end)).T
        # At a dead centre the force has no part across the crank: chords lie on the axis and on each other.
        axes.plot(*across_up, color=WHITE, linewidth=3 * MEDIUM, zorder=3.2, solid_capstyle="butt")
        axes.plot(*across_up, color=BLACK, linewidth=MEDIUM, dashes=CHORD, zorder=3.2)[0].set_gid(
            f"chord-{number}"
        )
        if np.hypot(*(end - start)) * plan.scale > LEAST_CHORD:
            way = (end - start) / np.hypot(*(end - start))
            arrowhead(axes, end - way * MARK / plan.scale, way, 1 / plan.scale, size=2.6, slim=0.28)
    return chords


def _marks(axes: Axes, plan: _Plan, pieces: Sequence[_Piece], chords: Sequence[Points]) -> None:
    """Draw the vectors at every 30° and write their angles where there is room."""
    heads = _heads(pieces)
    for _, head in heads:
        axes.plot((0, head[0]), (0, head[1]), color=GREY, linewidth=THIN, zorder=3)
        axes.plot(*head[:, None], marker="o", markersize=2 * MARK * MM, color=BLACK, zorder=5)
    left, bottom, right, top = plan.frame
    lines = [((left, 0), (right, 0)), ((0, bottom), (0, top)), *chords]
    shafts = [np.asarray(((0, 0), head)) for _, head in heads]
    taken = [densely(plan.on_paper(np.asarray(line))) for line in (*lines, *shafts)]
    line = densely(plan.on_paper(_with_gaps(pieces)))
    for angle, head in heads:
        taken.append(_mark(axes, plan, f"{angle}°", head, line, taken))


def _mark(axes: Axes, plan: _Plan, text: str, head: Points, line: Points, taken: Sequence[Points]) -> Points:
    """Write the angle beside its mark, at best outward, and return the points that it takes."""
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


def _heads(pieces: Sequence[_Piece]) -> list[tuple[int, Points]]:
    """Return the vectors at every 30°, two where the force jumps, none of no length."""
    heads = [(angle, piece.at(angle)) for piece in pieces for angle in piece.marked()]
    if len(heads) > 1 and _same(heads[0][1], heads[-1][1]):
        del heads[-1]
    most = max(float(np.nanmax(np.abs(piece.path), initial=0)) for piece in pieces)
    return [(angle, head) for angle, head in heads if np.hypot(*head) > NOTHING * most]


def _same(one: Points, other: Points) -> bool:
    return float(np.hypot(*(one - other))) <= NOTHING * float(np.hypot(*one))


def _arrow(axes: Axes, plan: _Plan, pieces: Sequence[_Piece]) -> None:
    """Draw an arrow on the longest piece between two marks, pointing where the angle rises."""
    half = MARK_STEP / 2
    stretches = [
        [piece.at(middle + way) for way in (-half, 0, 0.5)]
        for piece in pieces
        for middle in np.arange(piece.angles[0] + half, piece.angles[-1], MARK_STEP)
    ]
    stretches = [one for one in stretches if np.isfinite(one).all()]
    if stretches:
        _, tip, beyond = max(stretches, key=lambda one: float(np.hypot(*(one[1] - one[0]))))
        arrowhead(axes, tip, beyond - tip, 1 / plan.scale, size=2.6, slim=0.28)
