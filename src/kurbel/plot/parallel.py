"""The parallel crank true to scale: two equal cranks and the rod that couples them, at given angles."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.kernel.circle import circle
from kurbel.plot.sketch import CHAIN, Point, Sketch, laid_out, pin_texts
from kurbel.plot.style import WIDTH, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# In units of R. The motion is the same whatever the distance of the shafts; this one parts the circles.
SHAFTS = 3.0
# In mm.
BESIDE, ABOVE, DIMENSIONS = 9.0, 7.0, 9.0


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
            sketch.light_links((0, 0), pin, _second(pin), (SHAFTS, 0))
        _dimensions(sketch, pins[0], float(angles[0]) % 360)
        _strong(sketch, pins[0])
        sketch.beside_points(pin_texts(pins, angles, mark))
    return sketch.figure


def _pin(angle: float) -> Point:
    point = circle(angle)
    return point.cosine, point.sine


def _second(pin: Point) -> Point:
    """Return the pin of the second crank."""
    return pin[0] + SHAFTS, pin[1]


def _laid_out() -> Sketch:
    mm = (2 + SHAFTS) / (WIDTH - 2 * BESIDE)
    left, right = -1 - BESIDE * mm, SHAFTS + 1 + BESIDE * mm
    bottom, top = -1 - (ABOVE + DIMENSIONS) * mm, 1 + ABOVE * mm
    return laid_out((left, bottom), (right, top), mm)


def _fixed_lines(sketch: Sketch) -> None:
    beyond = 1 + 3.5 * sketch.mm
    sketch.line((-beyond, 0), (SHAFTS + beyond, 0), linestyle=CHAIN)
    for x in (0.0, SHAFTS):
        sketch.line((x, -beyond), (x, beyond), linestyle=CHAIN)
        sketch.crank_circle((x, 0))


def _dimensions(sketch: Sketch, pin: Point, turn: float) -> None:
    """Draw φ, R of both cranks, L of the rod, which is as long as the shafts are apart."""
    mm = sketch.mm
    sketch.crank_dimensions(pin, turn)
    side = 1 if pin[1] >= 0 else -1
    sketch.beside_link((SHAFTS, 0), _second(pin), "$R$", 0.68, side)
    sketch.beside_link(pin, _second(pin), "$L$", 0.5, side)
    level = -1 - (ABOVE + 4) * mm
    for x in (0.0, SHAFTS):
        sketch.line((x, -1 - 4.5 * mm), (x, level - mm))
    sketch.dimension((0, level), (SHAFTS, level), "$L$")


def _strong(sketch: Sketch, pin: Point) -> None:
    second = _second(pin)
    sketch.strong_links(crank=((0, 0), pin), second_crank=((SHAFTS, 0), second), rod=(pin, second))
    sketch.joints([(0, 0), (SHAFTS, 0)], [pin, second])
