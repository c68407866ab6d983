"""The force on a pin over the turn: the path of the vector's head, drawn from one origin, strokes apart."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from math import ceil
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.plot.panel import (
    MARK_STEP,
    Piece,
    PinForce,
    Strokes,
    amount,
    axis_label,
    power_of_thousand,
    round_step,
    value_ticks,
    with_gaps,
)
from kurbel.plot.place import AROUND, Box, Points, around, box_points, densely, freest, nearest_to
from kurbel.plot.plan import (
    ABOVE,
    BELOW,
    LEFT,
    LEGEND_GAP,
    LEGEND_ROW,
    RIGHT,
    SAMPLE,
    SAMPLE_GAP,
    SPOT,
    draw_legend,
    lined,
)
from kurbel.plot.style import (
    BLACK,
    GREY,
    LINES,
    MEDIUM,
    MM,
    SMALL_TEXT,
    STRONG,
    TEXT_SIZE,
    THIN,
    USUAL,
    Size,
    arrowhead,
    in_rows,
    page,
    size_of,
    style,
    text_of,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


class StrokeStyles(NamedTuple):
    """The names of strokes from the one that begins nearest to 0° on, each of which has its line, and the
    rows and columns of their legend."""

    names: tuple[str, ...] = ()
    rows: int = 0
    columns: int = 1


def looks_of(strokes: Strokes | None, width: float, mark: str) -> StrokeStyles:
    if strokes is None or not strokes.names:
        return StrokeStyles()
    count = len(strokes.names)
    first = min(range(count), key=lambda number: abs(strokes.ends[number]))
    order = (*strokes.names[first:], *strokes.names[:first])
    names = tuple(dict.fromkeys(text_of(name, mark) for name in order))
    each = max(size_of(name)[0] for name in names) + SAMPLE + SAMPLE_GAP + LEGEND_GAP
    most = max(1, min(len(names), int((width + LEGEND_GAP) / each)))
    rows = ceil(len(names) / most)
    return StrokeStyles(names, rows, ceil(len(names) / rows))


def draw_strokes(axes: Axes, pieces: Sequence[Piece], strokes: Strokes | None, looks: StrokeStyles) -> None:
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


MOST_HEIGHT, LEAST_WIDTH, LEAST = 110.0, 60.0, 25.0
# The scale stands in a row of its own where it has no room beside the name of the axis.
SCALE_ROW, SCALE_GAP = 4.5, 8.0
# Room around the curve for the labels of the angles.
EDGE = 8.0
GRID = 9.0
# A vector, or a difference of two, of so small a share is none.
NOTHING = 1e-6
CHORD = (1.5, 3)


# A chord shorter than this, in mm, has no room for an arrow.
LEAST_CHORD = 8.0


class _Plan(NamedTuple):
    """A diagram before it is drawn: scale in mm for a unit of force, the frame in units of force."""

    scale: float
    frame: Box
    grid: Fraction
    power: int
    # In mm: the room above and below the frame.
    above: float = ABOVE
    below: float = BELOW

    def on_paper(self, points: Points) -> Points:
        return np.asarray((points - np.asarray(self.frame[:2])) * self.scale)

    def size(self) -> tuple[float, float]:
        left, bottom, right, top = self.frame
        return (right - left) * self.scale, (top - bottom) * self.scale


def polar(force: PinForce, mark: str, ways: tuple[Label, Label] = ("", ""), size: Size = USUAL) -> Figure:
    """Return the polar diagram of a force, with a mark every 30° of the crank and one scale both ways.

    The diagram is as wide as the size says, or less; ways are the directions of its axes. The arrow on the
    curve points where the angle rises. The strokes differ in pattern and colour and have a legend. Where the
    force jumps the curve ends and begins anew; a dotted chord leads from the one end to the other. Raises
    ProblemError if no vector is finite, and for a size that is too small.
    """
    with style():
        vector, (across, up), unit = force.vector, force.names, force.unit
        path = np.stack((np.asarray(vector.across, float), np.asarray(vector.up, float)), axis=1)
        path[~np.isfinite(path).all(axis=1)] = np.nan
        plan = _plan(path, size)
        labels = (axis_label(one, unit, plan.power) for one in (across, up))
        names = [text_of(", ".join(filter(None, one)), mark) for one in zip(labels, ways, strict=True)]
        names = [in_rows(name, plan.size()[0] + RIGHT) for name in names]
        more = [LEGEND_ROW * name.count("\n") for name in names]
        scale = _scale_text(plan, unit, mark)
        bar = float(plan.grid) * plan.scale + SCALE_GAP + size_of(scale, SMALL_TEXT)[0]
        scaled = bool(more[1]) or size_of(names[1])[0] + bar > plan.size()[0]
        looks = looks_of(force.strokes, plan.size()[0], mark)
        over = ABOVE + more[1] + scaled * SCALE_ROW
        above, below = over + looks.rows * LEGEND_ROW, BELOW + more[0]
        # A page of a given height has its rows within it.
        plan = _plan(path, size, above, below) if size.height else plan
        plan = plan._replace(above=above, below=below)
        figure, axes = _laid_out(plan)
        _scale_bar(axes, plan, scale, over)
        angles = np.asarray(vector.angles, float)
        jumps = np.flatnonzero(np.diff(angles) == 0) + 1
        pieces = [Piece(*one) for one in zip(np.split(angles, jumps), np.split(path, jumps), strict=True)]
        draw_strokes(axes, pieces, force.strokes, looks)
        if looks.rows:
            share = (over - 1) / plan.size()[1]
            draw_legend(axes, *axes.get_legend_handles_labels(), looks.columns, share, "lower left")
        chords = _chords(axes, plan, pieces)
        _axes(axes, plan, names, mark, chords)
        _marks(axes, plan, pieces, chords)
        _arrow(axes, plan, pieces)
    return figure


def _plan(path: Points, size: Size, above: float = ABOVE, below: float = BELOW) -> _Plan:
    finite = path[np.isfinite(path[:, 0])]
    if not finite.any():
        raise ProblemError("the force is nowhere finite and other than 0, so nothing can be drawn")
    # The origin belongs to the diagram.
    low, high = np.minimum(finite.min(axis=0), 0), np.maximum(finite.max(axis=0), 0)
    width, height = (float(side) for side in high - low)
    across = size.width - LEFT - RIGHT
    along = size.height - below - above if size.height else MOST_HEIGHT
    if min(across, along) < LEAST:
        raise ProblemError(
            f"the drawing is {size.width:.6g} mm wide"
            f"{f' and {size.height:.6g} mm high' if size.height else ''}; this one needs"
            f" {LEAST + LEFT + RIGHT:.6g} mm and {LEAST + below + above:.6g} mm"
        )
    most = (across - 2 * EDGE, along - 2 * EDGE)
    scale = min(room / side for room, side in zip(most, (width, height), strict=True) if side)
    least = (across if size.exact else min(LEAST_WIDTH, across), along if size.height else 2 * EDGE)
    spare = (np.asarray(least) / scale - (width, height)) / 2
    room = np.maximum(EDGE / scale, spare)
    (left, bottom), (right, top) = (low - room).tolist(), (high + room).tolist()
    power = power_of_thousand((left, bottom, right, top))
    return _Plan(scale, (left, bottom, right, top), round_step(GRID / scale), power)


def _laid_out(plan: _Plan) -> tuple[Figure, Axes]:
    width, height = plan.size()
    total = (LEFT + width + RIGHT, plan.below + height + plan.above)
    figure = page(total[1], total[0])
    box = (LEFT / total[0], plan.below / total[1], width / total[0], height / total[1])
    left, bottom, right, top = plan.frame
    axes = figure.add_axes(box, label="diagram")
    axes.set(xlim=(left, right), ylim=(bottom, top))
    return figure, axes


def _axes(axes: Axes, plan: _Plan, names: Sequence[str], mark: str, chords: Sequence[Points]) -> None:
    left, bottom, right, top = plan.frame
    for low, high, ticks in ((left, right, axes.set_xticks), (bottom, top, axes.set_yticks)):
        found = value_ticks(low, high, plan.grid, plan.power, mark)
        ticks(found.places, found.texts)
    lined(axes)
    axes.axhline(0, color=BLACK, linewidth=MEDIUM, zorder=2)
    for low, high in _free(bottom, top, chords):
        axes.plot((0, 0), (low, high), color=BLACK, linewidth=MEDIUM, zorder=2)
    axes.set_xlabel(names[0], labelpad=3, linespacing=1.0)
    axes.set_title(names[1], loc="left", pad=4, fontsize=TEXT_SIZE, linespacing=1.0)


def _scale_text(plan: _Plan, unit: Label, mark: str) -> str:
    step = float(plan.grid)
    number = value_ticks(step * 0.9, step * 1.1, plan.grid, plan.power, ".").texts[0]
    shown, named = amount(number, unit, plan.power)
    return text_of(f"${shown}$ {named}", mark)


def _free(low: float, high: float, chords: Sequence[Points]) -> Iterator[tuple[float, float]]:
    """Yield what chords leave of the upright axis: at a dead centre the force has no part across the crank,
    and they lie on it."""
    near = NOTHING * (high - low)
    taken = [sorted(chord[:, 1]) for chord in chords if np.abs(chord[:, 0]).max() <= near]
    for begin, end in sorted(taken):
        if begin > low:
            yield low, begin
        low = max(low, end)
    yield low, high


def _scale_bar(axes: Axes, plan: _Plan, text: str, above: float) -> None:
    """Draw the scale of forces above the frame: it stays true when the drawing is made smaller."""
    _, _, right, top = plan.frame
    step, y = float(plan.grid), top + (above - ABOVE + 2.7) / plan.scale
    ends = (right - step, right)
    axes.plot(ends, (y, y), color=BLACK, linewidth=MEDIUM, clip_on=False, marker="|", markersize=2 * MM)
    axes.text(ends[0] - 1.5 / plan.scale, y, text, ha="right", va="center", fontsize=SMALL_TEXT)


def _chords(axes: Axes, plan: _Plan, pieces: Sequence[Piece]) -> list[Points]:
    """Draw what the force leaps over: between two pieces, and after a whole turn back to its beginning."""
    ends = list(pairwise(pieces))
    if (pieces[-1].angles[-1] - pieces[0].angles[0]) % 360 == 0:
        ends.append((pieces[-1], pieces[0]))
    chords = [np.stack((before.path[-1], after.path[0])) for before, after in ends]
    chords = [chord for chord in chords if np.isfinite(chord).all() and not _same(*chord)]
    for number, (start, end) in enumerate(chords, 1):
        across_up = np.stack((start, end)).T
        axes.plot(*across_up, color=BLACK, linewidth=MEDIUM, dashes=CHORD, zorder=3.2)[0].set_gid(
            f"chord-{number}"
        )
        if np.hypot(*(end - start)) * plan.scale > LEAST_CHORD:
            way = (end - start) / np.hypot(*(end - start))
            arrowhead(axes, end - way * SPOT / plan.scale, way, 1 / plan.scale, size=2.6, slim=0.28)
    return chords


def _marks(axes: Axes, plan: _Plan, pieces: Sequence[Piece], chords: Sequence[Points]) -> None:
    """Draw the vectors at every 30° and write their angles where there is room."""
    heads = _heads(pieces)
    for _, head in heads:
        axes.plot((0, head[0]), (0, head[1]), color=GREY, linewidth=THIN, zorder=3)
        axes.plot(*head[:, None], marker="o", markersize=2 * SPOT * MM, color=BLACK, zorder=5)
    left, bottom, right, top = plan.frame
    lines = [((left, 0), (right, 0)), ((0, bottom), (0, top)), *chords]
    shafts = [np.asarray(((0, 0), head)) for _, head in heads]
    taken = [densely(plan.on_paper(np.asarray(line))) for line in (*lines, *shafts)]
    line = densely(plan.on_paper(with_gaps([piece.path for piece in pieces])))
    marks = plan.on_paper(np.asarray([head for _, head in heads]))
    for (angle, head), at in zip(heads, marks, strict=True):
        rivals = marks[np.hypot(*(marks - at).T) > SPOT]
        taken.append(_mark(axes, plan, f"{angle}°", head, rivals, line, taken))


def _mark(
    axes: Axes, plan: _Plan, text: str, head: Points, rivals: Points, line: Points, taken: Sequence[Points]
) -> Points:
    """Write the angle beside its mark, at best outward and nowhere nearer to a rival of it; return the points
    that it takes."""
    size, at = size_of(text, SMALL_TEXT), plan.on_paper(head)
    others = np.concatenate(taken)
    # Its own vector ends at the mark and may touch the label.
    others = others[np.hypot(*(others - at).T) > 1]
    centres = nearest_to(at, rivals, around(at, size, head), size)
    frame = (0, 0, *plan.size())
    place = freest(centres, size, line, others, frame, AROUND) if len(centres) else None
    if place is None:
        return np.empty((0, 2))
    x, y = place / plan.size()
    axes.text(x, y, text, ha="center", va="center", fontsize=SMALL_TEXT, transform=axes.transAxes, zorder=6)
    return box_points(place, size)


def _heads(pieces: Sequence[Piece]) -> list[tuple[int, Points]]:
    """Return the vectors at every 30°, two where the force jumps, none of no length."""
    heads = [(angle, piece.at(angle)) for piece in pieces for angle in piece.marked()]
    if len(heads) > 1 and _same(heads[0][1], heads[-1][1]):
        del heads[-1]
    most = max(float(np.nanmax(np.abs(piece.path), initial=0)) for piece in pieces)
    return [(angle, head) for angle, head in heads if np.hypot(*head) > NOTHING * most]


def _same(one: Points, other: Points) -> bool:
    return float(np.hypot(*(one - other))) <= NOTHING * float(np.hypot(*one))


def _arrow(axes: Axes, plan: _Plan, pieces: Sequence[Piece]) -> None:
    """Draw an arrow on the longest piece between two marks, pointing where the angle rises."""
    half = MARK_STEP / 2
    stretches = [
        [piece.at(middle + way) for way in (-half, 0, 0.5)]
        for piece in pieces
        for middle in np.arange(piece.angles[0] + half, piece.angles[-1], MARK_STEP)
    ]
    stretches = [one for one in stretches if np.isfinite(one).all() and not _same(one[1], one[2])]
    if stretches:
        _, tip, beyond = max(stretches, key=lambda one: float(np.hypot(*(one[1] - one[0]))))
        arrowhead(axes, tip, beyond - tip, 1 / plan.scale, size=2.6, slim=0.28)
