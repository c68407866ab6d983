"""What an arc crank does between its dead centres, on any kind of number; see kernel/linkage.py."""

from __future__ import annotations

from typing import Any

from kurbel.exact.certify import Kind
from kurbel.kernel import linkage
from kurbel.linkage.arc.crank import ArcCrank
from kurbel.motion.evaluation import OUT, RETURN


def dead_angle(crank: ArcCrank, stroke: int, kind: Kind) -> Any:
    """Return φ_i, or for RETURN φ_o - 180°, in degrees within ±180°."""
    arc = crank.dead_centre(stroke, kind)
    return 2 * kind.arc(linkage.half_sine(arc.sine, arc.cosine))


def swing(crank: ArcCrank, kind: Kind) -> Any:
    """Return the rocker's swing in degrees; its way along the arc is `arc_stroke`."""
    inner, outer = (crank.dead_centre(stroke, kind) for stroke in (OUT, RETURN))
    return abs(2 * kind.arc(linkage.swing_half_sine(inner, outer)))


def arc_stroke(crank: ArcCrank, kind: Kind) -> Any:
    """Return the way of the rod's end along its arc between the dead centres, in units of R."""
    return swing(crank, kind) * kind.pi / 180 * kind.of(crank.rocker)


def lead(crank: ArcCrank, kind: Kind) -> Any:
    """Return Δ in degrees, by which the crank turns more than 180° during the outstroke."""
    inner, outer = (crank.dead_centre(stroke, kind) for stroke in (OUT, RETURN))
    return 2 * kind.arc(linkage.lead_half_sine(inner, outer))


def time_ratio(crank: ArcCrank, kind: Kind) -> Any:
    """Return the time of the outstroke over that of the return stroke."""
    more = lead(crank, kind)
    return (180 + more) / (180 - more)


def least_transmission(crank: ArcCrank, kind: Kind) -> Any:
    """Return the least angle between the lines of rod and rocker during a turn, in degrees."""
    return 90 - kind.arc(linkage.steepest_slant(*map(kind.of, crank.numbers(OUT))))
