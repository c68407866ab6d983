"""Drawings that move: a mechanism by itself, curves as they are run through, a force on the crank pin."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kurbel.errors import ProblemError
from kurbel.page.steps import Joint, Scene
from kurbel.plot.film import STEPS, Film, Part, VisibleArtists, Way, named, straight_way, toggled
from kurbel.plot.panel import NOTHING_AROUND, Panel, PanelFrame, PinForce, degrees
from kurbel.plot.place import Chosen, Points
from kurbel.plot.plan import SPOT, Course, Plan
from kurbel.plot.plotting import Chart, charted
from kurbel.plot.sketch import Sketch, laid_out, page_fitted, sketch_in
from kurbel.plot.stage import GROUNDS, MovingScene, corners, draw_scene
from kurbel.plot.style import LINES, MEDIUM, MM, MM_PER_INCH, USUAL, WHITE, WIDTH, Size, style
from kurbel.reading.notation import about

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

# The scene of a drive, with its joints at these angles; nothing for one that cannot be drawn to scale.
Staged = Callable[..., Scene | None]
# In mm.
MARGIN, LARGEST_RADIUS, MOST_HEIGHT = 3.0, 24.0, 150.0
TURN = 360.0
# In R: so far from a straight line between two known places links may be; a step is halved so often at most.
STRAIGHT, MOST_HALVED = 2e-5, 8


def mechanism_film(
    staged: Staged, angles: Sequence[float | Fraction], mark: str, seconds: float, size: Size = USUAL
) -> tuple[Figure, Film] | None:
    """Return a mechanism that moves, drawn at the first angle, at the others light; nothing for one whose
    links are too long. Raises ProblemError for a page that is too small."""
    at = float(angles[0]) % TURN
    run = refined(staged, run_through(0.0, TURN, at))
    scene = staged(run.tolist())
    if scene is None:
        return None
    with style():
        sketch = laid_out(*page_fitted(lambda mm: corners(scene, MARGIN, mm), _usual(scene), size))
        for angle in angles[1:]:
            _light(sketch, staged, angle, mark)
        moving = draw_scene(sketch, scene, run, int(np.searchsorted(run, at)))
    film = Film(0.0, TURN, at, seconds, *moving)
    named(film)
    return sketch.figure, film


def run_through(first: float, last: float, at: float) -> Points:
    """Return the angles at which a run is known, one of its own among them."""
    count = max(STEPS, round((last - first) / TURN * STEPS))
    even = first + (last - first) * np.arange(count + 1) / count
    return np.union1d(even[np.abs(even - at) > 1e-9], at)


def refined(staged: Staged, run: Points) -> Points:
    """Return the angles of a run with further ones between those where links leave straight ways: the rod
    of R:L near 1 swings within a degree."""
    for _ in range(MOST_HALVED):
        middles = (run[:-1] + run[1:]) / 2
        known, between = staged(run.tolist()), staged(middles.tolist())
        if known is None or between is None:
            return run
        bent = np.zeros(len(middles), bool)
        for here, there in zip(known.links, between.links, strict=True):
            for ends, halfway in ((here.start, there.start), (here.end, there.end)):
                if len(ends) > 1:
                    places = np.asarray(ends)
                    away = np.asarray(halfway) - (places[:-1] + places[1:]) / 2
                    bent |= np.hypot(*away.T) > STRAIGHT
        if not bent.any():
            return run
        run = np.union1d(run, middles[bent])
    return run


def _usual(scene: Scene) -> float:
    (left, low), (right, high) = scene.low, scene.high
    across, up = (most - 2 * MARGIN for most in (WIDTH, MOST_HEIGHT))
    return min(LARGEST_RADIUS, across / (right - left), up / (high - low))


def _light(sketch: Sketch, staged: Staged, angle: float | Fraction, mark: str) -> None:
    """Draw a further position, and its angle beside the pin of its first crank."""
    scene = staged([float(angle)])
    assert scene is not None
    pins = [_here(pin) for pin in scene.pins]
    shafts = [line.points[0] for line in scene.fixed if line.kind in GROUNDS]
    for number, link in enumerate(scene.links):
        ends = _here(link.start), _here(link.end)
        sketch.light_links(ends, [] if number else pins, shafts)
    pin = _here(scene.links[0].end)
    sketch.beside_points([(pin, pin, degrees(angle, mark))])


def _here(joint: Joint) -> tuple[float, float]:
    return joint[0]


# In mm: the mechanism above curves, and the dots on them.
RADIUS, MOST_ABOVE, LEAST_RADIUS, DOT = 18.0, 75.0, 4.0, 1.6 * SPOT
# Where a film begins, as pages that are interactive do.
BEGIN = 60.0
# The colour of the line at the crank angle, and of dots on black curves: that of no curve but a third one.
RUNNING = LINES[2].colour
NOTHING = MovingScene((), (), (), ())


class FilmSettings(NamedTuple):
    """How a film is made: in so many seconds a run, and with the mechanism where there is one."""

    seconds: float
    staged: Staged | None = None


def curves_film(
    panels: Sequence[Panel],
    lang: str,
    mark: str,
    shot: FilmSettings,
    around: PanelFrame = NOTHING_AROUND,
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
    return min(RADIUS, (width - 2 * MARGIN) / (right - left), (MOST_ABOVE - 2 * MARGIN) / (high - low))


def _height(scene: Scene, width: float) -> float:
    """Return what a mechanism needs above curves, in mm."""
    radius = _radius(scene, width)
    if radius < LEAST_RADIUS:
        raise ProblemError(
            f"the width is {about(Fraction(width))} mm; above its curves this mechanism needs more of it to"
            " be drawn to scale, or leave --width out"
        )
    return (scene.high[1] - scene.low[1]) * radius + 2 * MARGIN


def _above(chart: Chart, scene: Scene, height: float, width: float, run: np.ndarray, at: int) -> MovingScene:
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


def _dots(chart: Chart, panel: int, at: float) -> Iterator[tuple[Part, VisibleArtists | None]]:
    """Draw a dot on each curve of a panel."""
    axes, plan = chart.axes[panel], chart.plans[panel]
    for number, course in enumerate(plan.courses):
        name = f"dot-{panel + 1}-{number + 1}"
        way, gaps = _course(course)
        x, y, _ = way.at(at)
        dot = _dot(axes, x, y, _colour(plan, number))
        seen = VisibleArtists(f"{name}-seen", (dot,), gaps) if gaps is not None else None
        yield Part(name, (dot,), axes, way), seen


def _dot(axes: Axes, x: float, y: float, colour: str) -> Line2D:
    (dot,) = axes.plot([x], [y], marker="o", markersize=2 * DOT * MM, zorder=7, clip_on=False)
    dot.set(color=colour, markeredgecolor=WHITE, markeredgewidth=MEDIUM)
    return dot


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


def polar_film(figure: Figure, force: PinForce, seconds: float) -> Film:
    """Return how a dot runs along the curve of a polar diagram. Raises ProblemError for no whole turns."""
    vector = force.vector
    angles, path = np.asarray(vector.angles, float), np.column_stack((vector.across, vector.up))
    first, last = whole_turns(angles.tolist())
    at = first + (BEGIN - first) % 360
    known = np.isfinite(path).all(axis=1)
    way = Way(angles, np.column_stack((filled(angles, path, known), np.zeros(len(angles)))))
    (axes, *_) = figure.axes
    with style():
        x, y, _ = way.at(at)
        dot = _dot(axes, x, y, RUNNING)
    seen = () if known.all() else (VisibleArtists("dot-seen", (dot,), toggled(angles, known)),)
    film = Film(first, last, at, seconds, (Part("dot", (dot,), axes, way),), seen=seen)
    named(film)
    return film
