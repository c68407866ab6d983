"""A drive true to scale by what it says of its outline: its shafts and, at given angles, its links."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from kurbel.kernel.circle import circle
from kurbel.linkage.linkage import Outline, Point, Stand
from kurbel.plot.coupler.paths import Coupled, around, draw_paths, usual_scale
from kurbel.plot.paper.fit import fitted
from kurbel.plot.sketch import DOWN, HANGING, UP, Sketch, laid_out, pin_texts
from kurbel.plot.style import USUAL, WIDTH, Size, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# In mm.
BESIDE, ABOVE, DIMENSIONS = 9.0, 7.0, 9.0


def outlined(
    outline: Outline,
    angles: Sequence[float | Fraction],
    mark: str,
    size: Size = USUAL,
    paths: Sequence[Coupled] = (),
) -> Figure:
    """Return a drawing of the drive, true to scale, by itself 120 mm wide.

    Cranks turn counter-clockwise from the line of shafts. The first angle is drawn strong, with its
    dimensions, the others light. Raises ProblemError for a page that is too small.
    """
    pins = [_pin(float(angle)) for angle in angles]
    first, *others = map(outline.stand, pins)
    with style():
        sketch = _laid_out(outline, size, paths)
        _fixed_lines(sketch, outline)
        for one in others:
            for chain in one.chains:
                sketch.light_links(chain, one.pins, outline.shafts)
        _dimensions(sketch, first, pins[0], float(angles[0]) % 360)
        sketch.strong_links(**first.links)
        for shaft in outline.shafts:
            sketch.bearing(shaft, UP if pins[0][1] < -HANGING else DOWN)
        sketch.joints(first.pins)
        if paths:
            draw_paths(sketch, paths, *first.links["rod"], mark)
        sketch.beside_points(pin_texts(pins, angles, mark))
        sketch.write()
    return sketch.figure


def _pin(angle: float) -> Point:
    point = circle(angle)
    return point.cosine, point.sine


def _laid_out(outline: Outline, size: Size, paths: Sequence[Coupled]) -> Sketch:
    usual = (WIDTH - 2 * BESIDE) / (outline.right - outline.left)
    corners = around(lambda mm: _corners(outline, mm), paths)
    return laid_out(*fitted(corners, usual_scale(corners, usual, paths), size))


def _corners(outline: Outline, mm: float) -> tuple[Point, Point]:
    """Return the corners of the page, of which a millimetre is so much of R."""
    left, right = outline.left - BESIDE * mm, outline.right + BESIDE * mm
    return (left, -1 - (ABOVE + DIMENSIONS) * mm), (right, 1 + ABOVE * mm)


def _fixed_lines(sketch: Sketch, outline: Outline) -> None:
    beyond = 3.5 * sketch.mm
    sketch.centre_line((outline.left - beyond, 0), *outline.shafts, (outline.right + beyond, 0))
    for x, y in outline.shafts:
        sketch.centre_line((x, y - 1 - beyond), (x, y), (x, y + 1 + beyond))
        sketch.crank_circle((x, y))


def _dimensions(sketch: Sketch, stand: Stand, pin: Point, turn: float) -> None:
    """Draw φ and R of the first crank, the letters of links, and lengths along the line of shafts."""
    mm = sketch.mm
    sketch.crank_dimensions(pin, turn)
    side = 1 if pin[1] >= 0 else -1
    for name, letter, share in stand.letters:
        sketch.beside(stand.links[name], letter, share, side)
    level = -1 - (ABOVE + 4) * mm
    for start, end, letter in stand.lengths:
        if abs(end - start) > mm:
            for x in (start, end):
                sketch.line((x, -1 - 4.5 * mm), (x, level - mm))
            sketch.dimension((start, level), (end, level), letter)
