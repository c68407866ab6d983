"""The piston force of an indicator card over the share of the stroke travelled, and its work.

Forces are in units of Q, the greatest p_forward of the card times the piston's area; work in units of Q times
the whole stroke. The share counts from the dead centre at which the stroke begins, 0 to 1.

The curve through the points has cubics, monotone between the points, parted at corners. A card has corners,
at cut-off above all. A smooth curve rounds them, which on 200 points costs 1e-5 of the work; so they are
sought, between the points too, and each smooth piece has cubics of its own.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicHermiteSpline
from scipy.optimize import brentq

from kurbel.engine.card.card import Card, CycleCard
from kurbel.errors import ProblemError
from kurbel.kernel.law import Between, Cubics, steady

Points: TypeAlias = NDArray[np.float64]

# Points on one side of a gap by which the curve is continued into it. Five leave 1e-8 of the work at ε = 10;
# four left 3e-8, three 2e-7.
REACH = 5
# A corner is a jump of the slope this many times as large as what the curvature on both sides explains.
SHARPNESS = 2
# Corners that bend the curve by less than this share of its range do not matter.
LEAST_BEND = 1e-6
# Of a noisy card the sharpest gaps alone are looked at; a card has four corners a line.
MOST_CORNERS = 64
# Of cards: each has two halves.
KEPT = 48
# In gaps: how far beyond its gap two continuations may cut each other, and how near to a point is on it.
OVERSHOOT = 0.1
NEAR = 1e-4


@lru_cache(KEPT)
def card_strokes(
    card: Card | CycleCard, double_acting: bool, other_side: float | None = None, unit: float | None = None
) -> tuple[Between, ...]:
    """Return the strokes of a piston whose cylinder end gave the card, two or four.

    Double-acting: both ends give this card, each from its own dead centre, so that the pressure before the
    piston is p_return at the position 1 - share; the strokes are alike. Single-acting: the other face has
    the pressure other_side in Pa throughout, which counts from the zero of the card. Piston rods are those of
    `on_areas`, unequal ends are left out. `unit` in Pa stands in for the card's own greatest p_forward.
    Derived by us.
    """
    scale = card.admission if unit is None else unit
    curves = [curve(shares, [one / scale for one in pressures]) for shares, pressures in card.courses()]
    if double_acting:
        if len(curves) > 2:
            raise ProblemError(
                f"{card.name} is over two turns, and its cylinder works on one side of the piston; add"
                " --single-acting and, for the other face, --other-side, for example 1bar"
            )
        both = Between(*curves)
        return both, both
    if other_side is None:
        raise ProblemError(
            "a single-acting piston has a pressure on its other face, which the card does not tell;"
            " give it as --other-side, for example 1bar"
        )
    other = steady(other_side / scale)
    return tuple(
        Between(other, one) if index % 2 else Between(one, other) for index, one in enumerate(curves)
    )


def on_areas(stroke: Between, behind: float, before: float) -> Between:
    """Return the stroke of a piston with these shares of the bore's area behind and before it."""
    sides: Any = stroke
    return Between(sides.behind.times(behind), sides.before.times(before))


class _Corner(NamedTuple):
    """A corner in the gap behind the point `gap`; `depth` is its distance from the nearer point, in gaps."""

    gap: int
    abscissa: float
    ordinate: float
    depth: float


def curve(abscissas: Sequence[float], ordinates: Sequence[float]) -> Cubics:
    """Return the curve through points with rising abscissas, at least 1e-9 apart.

    Between two points it is monotone, hence nowhere beyond the ordinates. Its area is exact for the curve.
    For smooth pieces the curve is off by h⁴ of the gap h between points.
    """
    x, y = np.array(abscissas, dtype=float), np.array(ordinates, dtype=float)
    x, y, corners = _with_corners(x, y, _corners(x, y))
    ends = [0, *np.searchsorted(x, corners), len(x) - 1]
    pieces = [slice(first, last + 1) for first, last in pairwise(ends)]
    cubics = [CubicHermiteSpline(x[piece], y[piece], _slopes(x[piece], y[piece])).c for piece in pieces]
    return Cubics(x, np.hstack(cubics), corners)


def _slopes(x: Points, y: Points) -> Points:
    """Return slopes at the points: of the quartic through five neighbours, within what keeps cubics monotone.

    Source of the bound, three times the smaller secant: Fritsch and Carlson, SIAM J. Numer. Anal. 17 (1980).
    """
    # SciPy's Pchip takes a mean of two secants, off by h²; at ε = 10 its work is off by 1e-6.
    table = _differences(x, y, min(REACH, len(x)))
    first = np.clip(np.arange(len(x)) - REACH // 2, 0, len(x) - len(table))
    _, slope = _continued(table, x, first, x)
    secants = table[1]
    before, after = np.r_[secants[:1], secants], np.r_[secants, secants[-1:]]
    bound = 3 * np.minimum(abs(before), abs(after))
    within = np.where(after < 0, -bound, 0.0), np.where(after > 0, bound, 0.0)
    return np.where(before * after > 0, np.clip(slope, *within), 0.0)


def _differences(x: Points, y: Points, count: int) -> list[Points]:
    """Return the divided differences of order 0 to count - 1; those of an order by their first point."""
    table = [y]
    for order in range(1, count):
        table.append((table[-1][1:] - table[-1][:-1]) / (x[order:] - x[:-order]))
    return table


def _continued(table: Sequence[Points], x: Points, first: Any, at: Any) -> tuple[Any, Any]:
    """Return value and slope of the polynomial through as many points as the table has orders (Newton)."""
    value, slope = table[-1][first], 0.0
    for order in range(len(table) - 2, -1, -1):
        offset = at - x[first + order]
        slope = slope * offset + value
        value = value * offset + table[order][first]
    return value, slope


def _corners(x: Points, y: Points) -> list[_Corner]:
    """Return the corners in their order, no two within three gaps."""
    table = _differences(x, y, REACH)
    found = [_cut(x, table, gap) for gap in _sharp_gaps(x, y)]
    kept: list[_Corner] = []
    for corner in found:
        if corner is None:
            continue
        if kept and corner.gap - kept[-1].gap < 3:
            # The neighbour of a gap with a corner near its end looks sharp too, and is cut at that end; the
            # corner is where the cut lies well within the gap.
            kept[-1] = max(kept[-1], corner, key=lambda one: one.depth)
        else:
            kept.append(corner)
    return kept


def _sharp_gaps(x: Points, y: Points) -> list[int]:
    """Return the gaps, by the point before each, over which the slope jumps beyond all curvature."""
    table = _differences(x, y, 3)
    gaps = np.arange(2, len(x) - 3)
    width, middle = x[gaps + 1] - x[gaps], (x[gaps + 1] + x[gaps]) / 2
    _, before = _continued(table, x, gaps - 2, middle)
    _, after = _continued(table, x, gaps + 1, middle)
    bend = abs(after - before) * width
    curvature = 2 * width**2 * (abs(table[2][gaps - 2]) + abs(table[2][gaps + 1]))
    sharp = (bend > SHARPNESS * curvature) & (bend > LEAST_BEND * np.ptp(y))
    strongest = np.argsort(-np.where(sharp, bend, 0.0), kind="stable")[:MOST_CORNERS]
    return sorted(int(gaps[index]) for index in strongest if sharp[index])


def _cut(x: Points, table: Sequence[Points], gap: int) -> _Corner | None:
    """Return where the curves continued into the gap from left and right cut each other, None if nowhere."""
    count = min(REACH, gap + 1, len(x) - gap - 1)
    low, high = x[gap], x[gap + 1]
    width = high - low

    def left(at: float) -> float:
        return float(_continued(table[:count], x, gap - count + 1, at)[0])

    def distance(at: float) -> float:
        return float(_continued(table[:count], x, gap + 1, at)[0]) - left(at)

    bounds = (low - OVERSHOOT * width, high + OVERSHOOT * width)
    if distance(bounds[0]) * distance(bounds[1]) > 0:
        return None
    at = min(max(brentq(distance, *bounds), low), high)
    between = sorted((table[0][gap], table[0][gap + 1]))
    return _Corner(gap, at, min(max(left(at), between[0]), between[1]), min(at - low, high - at) / width)


def _with_corners(x: Points, y: Points, corners: Sequence[_Corner]) -> tuple[Points, Points, list[float]]:
    """Return the points with those corners that lie between them, and where all corners are."""
    between = [corner for corner in corners if corner.depth > NEAR]
    gaps = [corner.gap + 1 for corner in between]
    wider = np.insert(x, gaps, [corner.abscissa for corner in between])
    higher = np.insert(y, gaps, [corner.ordinate for corner in between])
    places = [corner.abscissa if corner.depth > NEAR else float(x[_nearer(x, corner)]) for corner in corners]
    return wider, higher, places


def _nearer(x: Points, corner: _Corner) -> int:
    return min((corner.gap, corner.gap + 1), key=lambda point: abs(float(x[point]) - corner.abscissa))
