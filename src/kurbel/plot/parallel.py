"""The parallel crank true to scale: two equal cranks and the rod that couples them, at given angles."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from kurbel.kernel.circle import circle
from kurbel.plot.sketch import (
    CHAIN,
    Point,
    bearing,
    beside_link,
    beside_points,
    crank_angle,
    crank_circle,
    dimension,
    joint,
    light_links,
    line,
)
from kurbel.plot.style import BLACK, MEDIUM, WIDTH, page, style
from kurbel.plot.ticks import degrees

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# In units of R. The motion is the same whatever the distance of the shafts; this one parts the circles.
SHAFTS = 3.0
# In mm.
BESIDE, ABOVE, DIMENSIONS = 9.0, 7.0, 9.0


class _Sketch(NamedTuple):
    """A drawing in units of R, and what a millimetre is in them."""

    figure: Figure
    axes: Axes
    mm: float


def parallel_mechanism(angles: Sequence[float | Fraction], mark: str) -> Figure:
    """Return a drawing of the parallel crank, true to scale and 120 mm wide.

    Both cranks turn counter-clockwise from the line of shafts. The first angle is drawn strong, with its
    dimensions, the others light.
    """
    pins = [_pin(float(angle)) for angle in angles]
    with style():
        sketch = _laid_out()
        _fixed_lines(sketch)
        for pin in pins[1:]:
            light_links(sketch, (0, 0), pin, _second(pin), (SHAFTS, 0))
        _dimensions(sketch, pins[0], float(angles[0]) % 360)
        _strong(sketch, pins[0])
        if len(pins) > 1:
            texts = [degrees(angle, mark) for angle in angles]
            beside_points(sketch, [(pin, pin, text) for pin, text in zip(pins, texts, strict=True)])
    return sketch.figure


def _pin(angle: float) -> Point:
    point = circle(angle)
    return point.cosine, point.sine


def _second(pin: Point) -> Point:
    """Return the pin of the second crank."""
    return pin[0] + SHAFTS, pin[1]


def _laid_out() -> _Sketch:
    mm = (2 + SHAFTS) / (WIDTH - 2 * BESIDE)
    left, right = -1 - BESIDE * mm, SHAFTS + 1 + BESIDE * mm
    bottom, top = -1 - (ABOVE + DIMENSIONS) * mm, 1 + ABOVE * mm
    figure = page((top - bottom) / mm)
    axes = figure.add_axes((0, 0, 1, 1), label="mechanism", xlim=(left, right), ylim=(bottom, top))
    axes.set_axis_off()
    return _Sketch(figure, axes, mm)


def _fixed_lines(sketch: _Sketch) -> None:
    beyond = 1 + 3.5 * sketch.mm
    line(sketch, (-beyond, 0), (SHAFTS + beyond, 0), linestyle=CHAIN)
    for x in (0.0, SHAFTS):
        line(sketch, (x, -beyond), (x, beyond), linestyle=CHAIN)
        crank_circle(sketch, (x, 0))


def _dimensions(sketch: _Sketch, pin: Point, turn: float) -> None:
    """Draw φ, R of both cranks, L of the rod, which is as long as the shafts are apart."""
    mm = sketch.mm
    if turn:
        crank_angle(sketch, pin, turn, 1 / mm)
    side = 1 if pin[1] >= 0 else -1
    for shaft, end in (((0.0, 0.0), pin), ((SHAFTS, 0.0), _second(pin))):
        beside_link(sketch, shaft, end, "$R$", 0.68, side)
    beside_link(sketch, pin, _second(pin), "$L$", 0.5, side)
    level = -1 - (ABOVE + 4) * mm
    for x in (0.0, SHAFTS):
        line(sketch, (x, -1 - 4.5 * mm), (x, level - mm))
    dimension(sketch, (0, level), (SHAFTS, level), "$L$")


def _strong(sketch: _Sketch, pin: Point) -> None:
    second = _second(pin)
    line(sketch, (0, 0), pin, linewidth=2.4, zorder=6).set_gid("crank")
    line(sketch, (SHAFTS, 0), second, linewidth=2.4, zorder=6).set_gid("second-crank")
    line(sketch, pin, second, linewidth=1.6, zorder=6).set_gid("rod")
    for shaft in ((0.0, 0.0), (SHAFTS, 0.0)):
        bearing(sketch, shaft)
    for centre in (pin, second):
        joint(sketch, centre, 1.1, BLACK, MEDIUM)
