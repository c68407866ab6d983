"""The polygon of accelerations, below or above the drive that it belongs to.

Pole, points and order of the sides are those of Khurmi and Gupta; a normal part is found on its link by the
altitude of a right-angled triangle, as in the exercise of the TU Chemnitz.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import TypeAlias

from kurbel.books.constructions.geometry import Point, meet, plus, to, turned
from kurbel.books.constructions.model import (
    GIVEN,
    Arc,
    Arrow,
    Line,
    Placed,
    Points,
    RightAngle,
    Step,
)
from kurbel.exact.kind import floats
from kurbel.page.quantity import words

# What makes the points of a drive, and of the polygon those from its pole.
Drive: TypeAlias = Callable[[Placed], Points]
Polygon: TypeAlias = Callable[[Points, Point], Points]
# Between the drive and the polygon, in R, and to what the place of the pole is rounded.
APART, STEPS = Fraction(9, 20), 20
SOURCE = words(
    "Khurmi und Gupta, Theory of Machines, Kap. 8, Fig. 8.3; die Normalbeschleunigungen mit dem Höhensatz wie"
    " in der Aufgabensammlung zur Getriebetechnik der TU Chemnitz, ANA_0388-2"
    "|Khurmi and Gupta, Theory of Machines, ch. 8, Fig. 8.3; the normal accelerations by the altitude"
    " theorem, as in the exercises on mechanisms of the TU Chemnitz, ANA_0388-2"
)
ALTITUDE = Step(
    words(
        "$P C$ um $P$ um 90° zurückgedreht ist $P D$; die Senkrechte zu $D Q$ in $D$ trifft die verlängerte"
        " Schubstange in $E$: nach dem Höhensatz ist $P E = u^2/(ω^2 L)$"
        "|$P C$, turned back by 90° about $P$, is $P D$; the perpendicular to $D Q$ at $D$ meets the rod"
        " produced at $E$: by the altitude theorem $P E = u^2/(ω^2 L)$"
    ),
    (
        Arc("P", "C", "D", beyond=0),
        Line("P", "D", GIVEN),
        Line("D", "Q"),
        Line("D", "E"),
        Line("P", "E", GIVEN),
        RightAngle("D", "Q", "E"),
    ),
    ("D", "E"),
)
NORMAL = Step(
    words(
        "Pol $o'$: $o' p'$ gleich und parallel $P O$ ist die Beschleunigung von $P$; daran $p' x$ gleich und"
        " parallel $P E$, die Normalbeschleunigung von $Q$ um $P$"
        "|Pole $o'$: $o' p'$, equal and parallel to $P O$, is the acceleration of $P$; joined to it $p' x$,"
        " equal and parallel to $P E$, the normal acceleration of $Q$ about $P$"
    ),
    (Arrow("o'", "p'", "", GIVEN), Arrow("p'", "x", "", GIVEN)),
    ("o'", "p'", "x"),
)


def altitude(foot: Point, along: Point, opposite: Point) -> Point:
    """Return the end of what a length, laid off from its foot square to a link, makes of the link: h²/L,
    beyond the foot."""
    high = plus(foot, along)
    return meet(high, turned(to(opposite, high)), foot, to(opposite, foot))


def with_polygon(at: Placed, drive: Drive, polygon: Polygon, side: int) -> Points:
    """Return the points of a drive and of its polygon, which lies below the drive (-1) or above it (1)."""
    pole = _pole(replace(at, kind=floats()), drive, polygon, side)
    points = drive(at)
    return {**points, **polygon(points, Point(at.number(pole.x), at.number(pole.y)))}


def _pole(near: Placed, drive: Drive, polygon: Polygon, side: int) -> Point:
    """Return where the polygon is clear of the drive, over or under the middle of the rod."""
    points = drive(near)
    ends = polygon(points, Point(0.0, 0.0)).values()
    edge = max(1.0, *(side * point.y for point in points.values()))
    reach = max(-side * point.y for point in ends)
    across = [point.x for point in ends]
    middle = (points["P"].x + points["Q"].x - min(across) - max(across)) / 2
    # The pole is at one place for every kind of number.
    return Point(*(Fraction(round(STEPS * one), STEPS) for one in (middle, side * (edge + reach + APART))))
