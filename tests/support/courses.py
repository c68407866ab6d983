"""Quantities of a straight or offset crank over a turn by kurbel's keys, in NumPy's floats, for scans.

True digits come from kurbel.verify; a scan shows that nothing was missed between them.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import numpy as np
from machines import Machine, Slide
from strokes import Grid

OUT, RETURN = "outstroke", "return"
# A step into the complex plane, whose derivative has no difference that could cancel.
STEP = 1e-30
Course = Callable[[Grid], Grid]


def slide(ratio: Fraction | float | str, offset: Fraction | float | str = 0, method: str = "exact") -> Slide:
    """Return the drive of a crank ratio and an offset in R; of the infinite rod whatever the ratio is."""
    rod = Fraction(ratio)
    length = float(1 / rod) if rod and method != "infinite" else float("inf")
    return Slide(length, float(Fraction(offset)), method == "series")


def ends(drive: Slide) -> dict[str, tuple[float, float]]:
    """Return in radians where each stroke begins and ends."""
    inner, outer = np.radians(Machine(drive, (), {}).dead_centres)
    return {OUT: (inner, outer), RETURN: (outer, inner + 2 * np.pi)}


def course(drive: Slide, key: str, stroke: str = OUT) -> Course:
    """Return a quantity over radians, positive on both strokes where it drives; psi in degrees."""
    sign = 1 if stroke == OUT else -1
    if key in ("x", "s"):
        begin, end = drive.motion(np.array(ends(drive)[stroke])).way
        whole = end - begin if key == "s" else sign
        return lambda angle: (drive.motion(angle).way - begin) / whole
    if key in ("c", "p", "tangential_force"):

        def speed(angle: Grid) -> Grid:
            return sign * drive.motion(angle).speed

        return slope(speed) if key == "p" else speed

    def lean(angle: Grid) -> Grid:
        return (np.sin(angle) - drive.offset) / drive.length

    def turning(angle: Grid) -> Grid:
        return np.cos(angle) / drive.length / np.sqrt(1 - lean(angle) ** 2)

    def tangent(angle: Grid) -> Grid:
        return np.tan(np.arcsin(lean(angle)))

    return {
        "psi": lambda angle: np.degrees(np.arcsin(lean(angle))),
        "rod_velocity": turning,
        "rod_acceleration": slope(turning),
        "rod_force": lambda angle: 1 / np.sqrt(1 - lean(angle) ** 2),
        "guide_force": tangent,
        "radial_force": lambda angle: sign * (np.cos(angle) - np.sin(angle) * tangent(angle)),
    }[key]


def slope(function: Course) -> Course:
    return lambda angle: (function(np.asarray(angle) + 1j * STEP) / STEP).imag
