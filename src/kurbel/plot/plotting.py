"""Curves over the crank angle: one or several panels above each other, sharing the angle axis."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kurbel.errors import ProblemError
from kurbel.exact.numerals import Label
from kurbel.plot.place import BESIDE, Points, beside, box_points, densely, freest
from kurbel.plot.style import (
    BLACK,
    LINES,
    MEDIUM,
    MM,
    PALE,
    SMALL_TEXT,
    TEXT_SIZE,
    THIN,
    WIDTH,
    page,
    size_of,
    style,
    text_of,
)
from kurbel.plot.ticks import Across, axis_label, over_angle, power_of_thousand, round_step, value_ticks

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

    from kurbel.plot.ticks import Ticks

# In mm: the numbers stand left of the panels, the quantity and the legend above each.
LEFT, RIGHT, ABOVE, BARE, BELOW = 13.0, 4.0, 7.5, 3.0, 10.5
PANEL_WIDTH = WIDTH - LEFT - RIGHT
HEIGHTS = {1: 72.0, 2: 50.0}
LOWEST = 38.0
TICK_HEIGHT = 7.5
LEGEND_ROW, SAMPLE, SAMPLE_GAP, LEGEND_GAP = 4.2, 9.0, 1.5, 4.0
# More labels than these beside the curves are harder to read than a legend.
MOST_LABELS = 4


class Curve(NamedTuple):
    """Values at rising angles in degrees; a value that is no finite number is a gap in the line.

    Where an angle comes twice the value jumps, from the first to the second.
    """

    label: Label
    angles: Sequence[float]
    values: Sequence[float]


class Panel(NamedTuple):
    """Curves of one unit over one axis; the label names the axis, a single curve needs none of its own."""

    curves: Sequence[Curve]
    label: Label
    unit: Label = ""


class _Line(NamedTuple):
    """The angles and values of a curve, with NaN for what is not finite."""

    angles: Points
    values: Points

    @classmethod
    def of(cls, curve: Curve) -> _Line:
        values = np.asarray(curve.values, float)
        return cls(np.asarray(curve.angles, float), np.where(np.isfinite(values), values, np.nan))

    def broken(self) -> _Line:
        """Return the line with a gap in every jump."""
        after = self._after_jumps()
        gaps = np.insert(self.values, after, np.nan)
        return _Line(np.insert(self.angles, after, self.angles[after]), gaps)

    def jumps(self) -> _Line:
        """Return the jumps alone, with gaps between them."""
        after = self._after_jumps()
        ends = (self.values[after - 1], self.values[after], np.full(len(after), np.nan))
        return _Line(np.repeat(self.angles[after], 3), np.stack(ends, axis=1).ravel())

    def _after_jumps(self) -> NDArray[np.intp]:
        """Return the numbers of the points after jumps, at the angles of those before."""
        return np.flatnonzero(np.diff(self.angles) == 0) + 1


class _Plan(NamedTuple):
    """A panel with all that must be known before the page is laid out; places in mm from its lower left."""

    lines: Sequence[_Line]
    span: tuple[float, float]
    limits: tuple[float, float]
    height: float
    heading: str
    power: int
    texts: tuple[str, ...]
    places: Sequence[Points] | None
    columns: int
    # Whether the legend stands above the heading, not beside it.
    apart: bool = False

    def top(self) -> float:
        """Return what the heading and the legend need above the panel."""
        heading = ABOVE + LEGEND_ROW * self.heading.count("\n") if self.heading else BARE
        if not self.columns:
            return heading
        rows = math.ceil(len(self.texts) / self.columns)
        return heading + LEGEND_ROW * (rows if self.apart else rows - 1)


def curves(panels: Sequence[Panel], lang: str, mark: str, across: Across | None = None) -> Figure:
    """Return a drawing 120 mm wide of panels above each other that share an axis, by default the angle's.

    The curves of a panel have their labels beside them where all find room, else in a legend; panels of like
    curves share the legend of the first. They differ in colour and in pattern, for print in black and for
    eyes that tell no colours. Where a value jumps its curve ends and begins anew, and a thin line leads from
    the one end to the other. Raises ProblemError for a panel of more curves than can be told apart, or
    without any finite value, and for a single angle.
    """
    for panel in panels:
        _check(panel)
    angles = [angle for panel in panels for curve in panel.curves for angle in curve.angles]
    span = (min(angles), max(angles))
    if span[0] == span[1]:
        raise ProblemError(f"the only crank angle is {span[0]:.6g}°; a curve needs two")
    axis = across or over_angle(lang)
    with style():
        plans = _with_one_legend(
            [_plan(panel, span, HEIGHTS.get(len(panels), LOWEST), mark) for panel in panels]
        )
        figure, axes = _laid_out(plans)
        for number, (one, plan) in enumerate(zip(axes, plans, strict=True), 1):
            _draw(one, plan, number)
            _value_axis(one, plan, mark)
            _across_axis(one, axis.ticks(*span, mark), named=number == len(plans))
        axes[-1].set_xlabel(text_of(axis.label, mark), labelpad=3)
    return figure


def check_count(count: int) -> None:
    """Raise ProblemError for a panel of more curves than can be told apart."""
    if count > len(LINES):
        raise ProblemError(f"a panel of {count} curves was asked for; at most {len(LINES)} can be told apart")


def _check(panel: Panel) -> None:
    check_count(len(panel.curves))
    if not any(np.isfinite(curve.values).any() for curve in panel.curves):
        raise ProblemError(f'the panel "{panel.label[:40]}" has no finite value, so nothing can be drawn')


def _plan(panel: Panel, span: tuple[float, float], height: float, mark: str) -> _Plan:
    lines = [_Line.of(curve) for curve in panel.curves]
    values = np.concatenate([line.values for line in lines])
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    room = 0.05 * (high - low) or 0.1 * abs(high) or 1.0
    power = power_of_thousand(values[np.isfinite(values)])
    heading = _in_rows(text_of(axis_label(panel.label, panel.unit, power), mark))
    texts = tuple(text_of(curve.label, mark) for curve in panel.curves)
    plan = _Plan(lines, span, (low - room, high + room), height, heading, power, texts, None, 0)
    if not any(texts):
        return plan
    places = _places(plan) if len(texts) <= MOST_LABELS else None
    return plan._replace(places=places) if places else _with_legend(plan)


def _in_rows(text: str) -> str:
    """Return a heading in rows not wider than the panel, broken at spaces outside of formulas."""
    rows = [""]
    for word in re.split(r" (?=(?:[^$]*\$[^$]*\$)*[^$]*$)", text):
        longer = f"{rows[-1]} {word}".lstrip()
        if rows[-1] and size_of(longer)[0] > PANEL_WIDTH:
            rows.append(word)
        else:
            rows[-1] = longer
    return "\n".join(rows)


def _with_one_legend(plans: list[_Plan]) -> list[_Plan]:
    """Return the plans with a legend in the first panel alone, where one of like panels needs one."""
    if len({plan.texts for plan in plans}) > 1 or not any(plan.columns for plan in plans):
        return plans
    return [_with_legend(plans[0]), *(plan._replace(places=None, columns=0) for plan in plans[1:])]


def _with_legend(plan: _Plan) -> _Plan:
    """Return the plan with a legend beside the heading or, where the two do not fit beside, above it."""
    widest = max(size_of(text)[0] for text in plan.texts) + SAMPLE + SAMPLE_GAP + LEGEND_GAP
    beside = 0 if "\n" in plan.heading else int((PANEL_WIDTH - size_of(plan.heading)[0]) / widest)
    most, count = beside or max(1, int((PANEL_WIDTH + LEGEND_GAP) / widest)), len(plan.texts)
    # Rows of equal length: three and three, not four and two.
    columns = math.ceil(count / math.ceil(count / most))
    return plan._replace(places=None, columns=columns, apart=not beside)


def _places(plan: _Plan) -> Sequence[Points] | None:
    """Return where labels beside the curves have room, or None unless all have."""
    lines = [densely(_on_paper(line.broken(), plan)) for line in plan.lines]
    zero = _Line(np.asarray(plan.span), np.zeros(2))
    labels = [densely(_on_paper(one, plan)) for one in (zero, *(line.jumps() for line in plan.lines))]
    places = []
    for line, text in zip(lines, plan.texts, strict=True):
        size = size_of(text)
        others = np.concatenate([*(other for other in lines if other is not line), *labels])
        place = freest(beside(line, size), size, line, others, (0, 0, PANEL_WIDTH, plan.height), BESIDE)
        if place is None:
            return None
        places.append(place)
        labels.append(box_points(place, size))
    return places


def _on_paper(line: _Line, plan: _Plan) -> Points:
    """Return the points of a line in mm from the panel's lower left corner."""
    points = np.stack(line, axis=1)
    low, high = (np.asarray(ends) for ends in zip(plan.span, plan.limits, strict=True))
    return np.asarray((points - low) / (high - low) * (PANEL_WIDTH, plan.height))


def _laid_out(plans: Sequence[_Plan]) -> tuple[Figure, list[Axes]]:
    """Return the page and its empty panels."""
    total = BELOW + sum(plan.top() + plan.height for plan in plans)
    figure, top = page(total), total
    axes: list[Axes] = []
    for plan in plans:
        top -= plan.top() + plan.height
        box = (LEFT / WIDTH, top / total, PANEL_WIDTH / WIDTH, plan.height / total)
        axes.append(figure.add_axes(box, label=f"panel {len(axes) + 1}"))
    return figure, axes


def _draw(axes: Axes, plan: _Plan, number: int) -> None:
    drawn = []
    for count, (line, look) in enumerate(zip(plan.lines, LINES, strict=False), 1):
        artist = axes.plot(*line.broken())[0]
        artist.set(color=look.colour, linewidth=look.width, zorder=3, clip_on=False)
        artist.set_linestyle((0, look.dashes) if look.dashes else "-")
        artist.set_gid(f"curve-{number}-{count}")
        drawn.append(artist)
        jumps = line.jumps()
        if len(jumps.angles):
            artist = axes.plot(*jumps, color=look.colour, linewidth=THIN, zorder=3)[0]
            artist.set(clip_on=False, gid=f"jumps-{number}-{count}")
    axes.set(xlim=plan.span, ylim=plan.limits)
    if plan.places:
        for place, text, look in zip(plan.places, plan.texts, LINES, strict=False):
            x, y = place / (PANEL_WIDTH, plan.height)
            axes.text(x, y, text, color=look.colour, transform=axes.transAxes, ha="center", va="center")
    elif plan.columns:
        _legend(axes, drawn, plan)


def _legend(axes: Axes, drawn: Sequence[Line2D], plan: _Plan) -> None:
    in_sizes = MM / TEXT_SIZE
    # matplotlib fills the columns one after the other; we read along the rows.
    order = [place for column in range(plan.columns) for place in range(len(drawn))[column :: plan.columns]]
    axes.legend(
        [drawn[place] for place in order],
        [plan.texts[place] for place in order],
        loc="lower right",
        bbox_to_anchor=(1, 1 + plan.apart * LEGEND_ROW * (1 + plan.heading.count("\n")) / plan.height),
        ncols=plan.columns,
        frameon=False,
        handlelength=SAMPLE * in_sizes,
        handletextpad=SAMPLE_GAP * in_sizes,
        columnspacing=LEGEND_GAP * in_sizes,
        labelspacing=0.35,
        borderaxespad=0,
        borderpad=0.3,
    )


def _value_axis(axes: Axes, plan: _Plan, mark: str) -> None:
    low, high = plan.limits
    step = round_step((high - low) * TICK_HEIGHT / plan.height)
    ticks = value_ticks(low, high, step, plan.power, mark)
    axes.set_yticks(ticks.places, ticks.texts)
    axes.set_title(plan.heading, loc="left", pad=4, fontsize=TEXT_SIZE, linespacing=1.0)
    if low < 0 < high:
        axes.axhline(0, color=BLACK, linewidth=MEDIUM, zorder=2)


def _across_axis(axes: Axes, ticks: Ticks, named: bool) -> None:
    axes.set_xticks(ticks.places, ticks.texts if named else [""] * len(ticks.texts))
    axes.grid(color=PALE, linewidth=THIN)
    axes.set_axisbelow(True)
    axes.tick_params(width=THIN, length=2, pad=2, labelsize=SMALL_TEXT)
