"""The piston force of an indicator card over the share of the stroke travelled, and its work.

Forces are in units of Q, the greatest p_forward of the card times the piston's area; work in units of Q times
the whole stroke. The share counts from the dead centre at which the stroke begins, 0 to 1.

The curve through the points has cubics, monotone between the points, parted at corners. A card has corners,
at cut-off above all. A smooth curve rounds them, which on 200 points costs 1e-5 of the work; so they are
sought, between the points too, and each smooth piece has cubics of its own.

A turn of an engine whose piston force comes from an indicator card: in floats, with an error estimate.

What the points of a card do not say, no arithmetic knows. The same turn is therefore computed from every
second point, twice; by how far those results differ from the result of all points tells how many digits the
card supports.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import pairwise
from operator import methodcaller
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicHermiteSpline
from scipy.optimize import brentq

from kurbel.drive.at import CrankForce
from kurbel.engine.arrays import FloatTurn
from kurbel.engine.card.card import Card, CycleCard, Diagram
from kurbel.engine.engine import Assembly, Engine
from kurbel.errors import CardError, ProblemError
from kurbel.kernel.law import Constant, Cubics, Stroke

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
) -> tuple[Stroke, ...]:
    """Return the strokes of a piston whose cylinder end gave the card, two or four.

    Double-acting: both ends give this card, each from its own dead centre, so that the pressure before the
    piston is p_return at the position 1 - share; the strokes are alike. Single-acting: the other face has
    the pressure other_side in Pa throughout, which counts from the zero of the card. `unit` in Pa stands in
    for the card's own greatest p_forward. Derived by us.
    """
    scale = card.admission if unit is None else unit
    curves = [curve(shares, [one / scale for one in pressures]) for shares, pressures in card.courses()]
    if double_acting:
        if len(curves) > 2:
            raise ProblemError(
                f"{card.name} is over two turns, and its cylinder works on one side of the piston; add"
                " --single-acting and, for the other face, --other-side, for example 1bar"
            )
        both = Stroke(curves[0], curves[1])
        return both, both
    if other_side is None:
        raise ProblemError(
            "a single-acting piston has a pressure on its other face, which the card does not tell;"
            " give it as --other-side, for example 1bar"
        )
    other = Constant(other_side / scale)
    return tuple(Stroke(other, one) if index % 2 else Stroke(one, other) for index, one in enumerate(curves))


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


# Of a stroke.
SAMPLES = 721
LEAST_FORCE = 1e-9
# Cubics gain a factor of 16 with twice the points; noise may seem to gain 8 by chance.
MOST_GAIN = 8.0
NOTHING = 1e-300
# Half turns over which a slope is taken.
BESIDE = 1e-3


class CardTurn(FloatTurn):
    """One turn by a method: exact or series kinematics."""

    def __init__(self, engine: Engine | Assembly, method: str) -> None:
        if method == "weisbach":
            raise ProblemError(
                'method "weisbach" has no equations for an indicator card; use exact or series'
            )
        super().__init__(engine, method)
        self.diagrams = tuple(part.steam for part in engine.parts if isinstance(part.steam, Diagram))
        self.diagram = self.diagrams[0]
        mean = round(float(self.mean_force()) / len(engine.cranks), 12) + 0.0
        # Half a card, in the unit of the whole, may well do no work.
        if self.diagram.unit is None and abs(mean) < LEAST_FORCE:
            raise CardError(
                f"{self.diagram.card.name} does no work: the mean tangential force is {mean:.3g} Q,"
                " and it must be above 0, or below where the shaft drives the piston; p_forward drives it,"
                " p_return resists it"
            )

    @cached_property
    def coarser(self) -> tuple[CardTurn, ...]:
        """The turns of the cards that have every second point of these, in the same Q."""
        return tuple(CardTurn(engine, self.method) for engine in self._halves())

    def _halves(self) -> Iterator[Engine | Assembly]:
        parts = [
            [replace(part, steam=half) for half in part.steam.halves()]
            if isinstance(part.steam, Diagram)
            else [part, part]
            for part in self.engine.parts
        ]
        for half in zip(*parts, strict=True):
            yield half[0] if len(half) == 1 else Assembly(half)

    @cached_property
    def gain(self) -> float:
        """How many times nearer to the truth twice the points have come; 1 for noise."""
        before = max(half.work_apart for half in self.coarser)
        return min(max(before / (self.work_apart + NOTHING), 1.0), MOST_GAIN)

    @cached_property
    def work_apart(self) -> float:
        """The greatest difference of work from the coarser cards', at any share of the strokes, in 2 Q R."""
        return max(float(abs(one).max()) for one in self._apart("work"))

    @cached_property
    def force_apart(self) -> float:
        """The mean difference of force from the coarser cards', and the step of the pressures, in Q."""
        return float(np.sqrt(np.mean(np.square(self._apart("force"))))) + self.step

    def _apart(self, name: str) -> list[Points]:
        """The differences of a value over the strokes from those of the coarser cards."""
        value = methodcaller(name, np.linspace(0, 1, SAMPLES))
        return [
            (value(own) - value(other)) * (1.0 if mine.unit is None else mine.unit)
            for half in self.coarser
            for part, mine, coarse in zip(self.engine.parts, self.cylinders, half.cylinders, strict=True)
            if part.carded
            for own, other in zip(mine.strokes, coarse.strokes, strict=True)
        ]

    @property
    def step(self) -> float:
        """The last place of the pressures as written, in Q."""
        return max(one.card.resolution / one.pressure for one in self.diagrams)

    def place_error(self, greatest: bool, stroke: int | None) -> float:
        """How far the place of an extreme may be off, in half turns.

        Where the tangential force passes its mean at a small angle, little of it moves the place far.
        """
        place = float(self.peaks(greatest, stroke)[0].place)
        slope = (self.excess(place + BESIDE) - self.excess(place - BESIDE)) / (2 * BESIDE)
        halves = (half.peaks(greatest, stroke)[0].place for half in self.coarser)
        apart = max(abs(place - half) for half in halves)
        return float(max(apart, 2 * self.force_apart / (abs(slope) + NOTHING)))

    def excess(self, half_turns: float) -> float:
        """The power of all cranks less its mean."""
        return float(self.power(Fraction(half_turns)) - self.mean_force())

    def crank_force_error(self, force: CrankForce, half_turns: Fraction) -> float:
        """How far such a force may be off, in Q: as far as the net pressure there, by the rod's slant."""
        _, stroke, angle = self.first(half_turns)
        circle = self.cylinder.circle(angle)
        share = self.cylinder.share(stroke, circle)
        own = self.cylinder.strokes[stroke].force(share)
        apart = max(abs(float(own - half.cylinder.strokes[stroke].force(share))) for half in self.coarser)
        return max(apart, self.force_apart) * abs(float(self.cylinder.drive.bare(force, stroke % 2, circle)))
