"""Curves over the crank angle as they are run through: a line and dots, and above them the mechanism."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kurbel.errors import ProblemError
from kurbel.page.steps import Scene
from kurbel.plot.chart.course import Course
from kurbel.plot.chart.model import NOTHING_AROUND, Around, Panel
from kurbel.plot.chart.plan import SPOT, Plan
from kurbel.plot.film.mechanism import MARGIN, TURN, Staged, refined, run_through
from kurbel.plot.film.model import Film, Part, Seen, Way, straight_way, toggled
from kurbel.plot.film.scene import Moving, corners, draw_scene
from kurbel.plot.film.svg import named
from kurbel.plot.place import Chosen, Points
from kurbel.plot.plotting import Chart, charted
from kurbel.plot.sketch import sketch_in
from kurbel.plot.style import LINES, MEDIUM, MM, MM_PER_INCH, USUAL, WHITE, Size, style
from kurbel.reading.notation import about

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# In mm: the mechanism above curves, and the dots on them.
RADIUS, MOST_HEIGHT, LEAST_RADIUS, DOT = 18.0, 75.0, 4.0, 1.6 * SPOT
# Where a film begins, as pages that are interactive do.
BEGIN = 60.0
# The colour of the line at the crank angle, and of dots on black curves: that of no curve but a third one.
RUNNING = LINES[2].colour
NOTHING = Moving((), (), (), ())


class Shot(NamedTuple):
    """How a film is made: in so many seconds a run, and with the mechanism where there is one."""

    seconds: float
    staged: Staged | None = None


def curves_film(
    panels: Sequence[Panel],
    lang: str,
    mark: str,
    shot: Shot,
    around: Around = NOTHING_AROUND,
    size: Size = USUAL,
) -> tuple[Chart, Film]:
    """Return curves with dots that run along them, and above them the mechanism if it can be drawn to scale.

    Raises ProblemError for curves over no whole turns, or what cannot be drawn.
    """
    first, last = whole_turns([angle for panel in panels for curve in panel.curves for angle in curve.angles])
    at = first + (BEGIN - first) % TURN
    run = run_through(first, last, at)
    run = refined(shot.staged, run) if shot.staged else run
    scene = shot.staged(run.tolist()) if shot.staged else None
    with style():
        above = _height(scene, size.width) if scene else 0.0
        chart = charted(panels, lang, mark, around, size, above)
        moving = (
            _above(chart, scene, above, size.width, run, int(np.searchsorted(run, at))) if scene else NOTHING
        )
        lines = [_line(one, number, (first, last), at) for number, one in enumerate(chart.axes, 1)]
        dots = [one for number in range(len(chart.axes)) for one in _dots(chart, number, at)]
    parts = (*moving.parts, *lines, *(dot for dot, _ in dots))
    seen = (*moving.seen, *(gap for _, gap in dots if gap is not None))
    film = Film(first, last, at, shot.seconds, parts, moving.grown, seen, moving.above)
    named(film)
    return chart, film


def whole_turns(angles: Sequence[float]) -> tuple[float, float]:
    """Return the least and the greatest angle; raise ProblemError where no whole turns lie between them."""
    first, last = min(angles), max(angles)
    if last == first or (last - first) % TURN:
        raise ProblemError(
            f"a drawing that moves runs through whole turns, and these are the angles from"
            f" {about(Fraction(first))}° to {about(Fraction(last))}°; leave --from, --to and --step out, or"
            " --animate"
        )
    return first, last


def _radius(scene: Scene, width: float) -> float:
    (left, low), (right, high) = scene.low, scene.high
    return min(RADIUS, (width - 2 * MARGIN) / (right - left), (MOST_HEIGHT - 2 * MARGIN) / (high - low))


def _height(scene: Scene, width: float) -> float:
    """Return what a mechanism needs above curves, in mm."""
    radius = _radius(scene, width)
    if radius < LEAST_RADIUS:
        raise ProblemError(
            f"the width is {about(Fraction(width))} mm; above its curves this mechanism needs more of it to"
            " be drawn to scale, or leave --width out"
        )
    return (scene.high[1] - scene.low[1]) * radius + 2 * MARGIN


def _above(chart: Chart, scene: Scene, height: float, width: float, run: np.ndarray, at: int) -> Moving:
    """Draw the mechanism at the top of the page, in the middle."""
    mm = 1 / _radius(scene, width)
    low, high = corners(scene, MARGIN, mm)
    across, total = (high[0] - low[0]) / mm / width, chart.figure.get_figheight() * MM_PER_INCH
    box = ((1 - across) / 2, 1 - height / total, across, height / total)
    return draw_scene(sketch_in(chart.figure, box, low, high, mm), scene, run, at)


def _line(axes: Axes, number: int, span: tuple[float, float], at: float) -> Part:
    """Draw the line at the crank angle."""
    low, high = axes.get_ylim()
    line = axes.plot((at, at), (low, high), color=RUNNING, linewidth=MEDIUM, zorder=2.8, clip_on=False)[0]
    return Part(f"at-{number}", (line,), axes, straight_way(*span, ((span[0], low, 0), (span[1], low, 0))))


def _dots(chart: Chart, panel: int, at: float) -> Iterator[tuple[Part, Seen | None]]:
    """Draw a dot on each curve of a panel."""
    axes, plan = chart.axes[panel], chart.plans[panel]
    for number, course in enumerate(plan.courses):
        name = f"dot-{panel + 1}-{number + 1}"
        way, gaps = _course(course)
        x, y, _ = way.at(at)
        (dot,) = axes.plot([x], [y], marker="o", markersize=2 * DOT * MM, zorder=7, clip_on=False)
        dot.set(color=_colour(plan, number), markeredgecolor=WHITE, markeredgewidth=MEDIUM)
        seen = Seen(f"{name}-seen", (dot,), gaps) if gaps is not None else None
        yield Part(name, (dot,), axes, way), seen


def _colour(plan: Plan, number: int) -> str:
    several = len(plan.courses) > 1 and not plan.panel.curves[number].dotted
    return LINES[number].colour if several else RUNNING


def filled(angles: Points, rows: Points, known: Chosen) -> Points:
    """Return the rows, with those that are not known on the way between their neighbours."""
    if known.all():
        # A row beside a jump stays as it is.
        return rows
    return np.column_stack([np.interp(angles, angles[known], column[known]) for column in rows.T])


def _course(course: Course) -> tuple[Way, Way | None]:
    """Return the way along a curve, and where that is no number, if anywhere."""
    known = np.isfinite(course.values)
    values = filled(course.angles, course.values[:, None], known)
    rows = np.column_stack((course.angles, values, np.zeros(len(values))))
    return Way(course.angles, rows), None if known.all() else toggled(course.angles, known)
