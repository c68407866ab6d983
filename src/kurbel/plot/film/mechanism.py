"""The mechanism to scale as it moves, by itself."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from kurbel.page.steps import Joint, Line, Scene
from kurbel.plot.film.model import STEPS, Film
from kurbel.plot.film.scene import GROUNDS, corners, draw_scene
from kurbel.plot.film.svg import named
from kurbel.plot.paper.fit import fitted
from kurbel.plot.place import Points
from kurbel.plot.sketch import Sketch, laid_out
from kurbel.plot.style import USUAL, WIDTH, Size, style
from kurbel.plot.ticks import degrees

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# The scene of a drive, with its joints at these angles; nothing for one that cannot be drawn to scale.
Staged = Callable[[Sequence[float]], Scene | None]
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
        sketch = laid_out(*fitted(lambda mm: corners(scene, MARGIN, mm), _usual(scene), size))
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
    pins, shafts = [_here(pin) for pin in scene.pins], _shafts(scene.fixed)
    for number, link in enumerate(scene.links):
        ends = _here(link.start), _here(link.end)
        sketch.light_links(ends, [] if number else pins, shafts)
    pin = _here(scene.links[0].end)
    sketch.beside_points([(pin, pin, degrees(angle, mark))])


def _here(joint: Joint) -> tuple[float, float]:
    return joint[0]


def _shafts(lines: Sequence[Line]) -> list[tuple[float, float]]:
    return [line.points[0] for line in lines if line.kind in GROUNDS]
