"""The force on the crank pin as the crank turns: a dot at the head of its vector in the polar diagram."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kurbel.plot.chart.vector import PinForce
from kurbel.plot.film.curves import BEGIN, DOT, RUNNING, filled, whole_turns
from kurbel.plot.film.model import Film, Part, Seen, Way, toggled
from kurbel.plot.film.svg import named
from kurbel.plot.style import MEDIUM, MM, WHITE, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure


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
        (dot,) = axes.plot([x], [y], marker="o", markersize=2 * DOT * MM, zorder=7, clip_on=False)
        dot.set(color=RUNNING, markeredgecolor=WHITE, markeredgewidth=MEDIUM)
    seen = () if known.all() else (Seen("dot-seen", (dot,), toggled(angles, known)),)
    film = Film(first, last, at, seconds, (Part("dot", (dot,), axes, way),), seen=seen)
    named(film)
    return film
