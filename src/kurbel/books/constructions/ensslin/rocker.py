"""Ensslin's figures of the arc crank: B moves on an arc, and p₂ has a part towards the pivot.

His theorem is of any straight rod, however it is guided.
"""

from __future__ import annotations

from typing import Any

from kurbel.books.constructions.geometry import Point, circles, distance, plus, to
from kurbel.books.constructions.model import CENTRE, LINK, Circle, Construction, Length, Line, Placed, Step
from kurbel.kernel.inertia.parts import Parted, parted_rocker
from kurbel.motion.evaluation import OUT
from kurbel.page.quantity import words

GIVEN = Step(
    words(
        "Kurbel $O A$, Schubstange $A B = l$ und Schwinge $P B$|Crank $O A$, rod $A B = l$ and rocker $P B$"
    ),
    (Circle("O", "A", CENTRE), Line("O", "A"), Line("A", "B", LINK), Line("P", "B", LINK)),
    ("O", "A", "B", "P"),
)
CHI = words(
    "$χ$ zwischen $p_1$ und $p_2$; $p_2$ hat einen Teil längs des Bogens und einen zum Drehpunkt $P$ hin"
    "|$χ$ between $p_1$ and $p_2$; $p_2$ has a part along the arc and one towards the pivot $P$"
)


# The line along which B moves, elsewhere than on an arc.
SLIDE = Line("slide", "slide end", CENTRE)
ON_ARC = words(
    "Die Schubstange $A B = l$; $B$ bewegt sich auf dem Bogen der Schwinge"
    "|The rod $A B = l$; $B$ moves on the arc of the rocker"
)


def pivot_of(at: Placed) -> Point:
    drive = at.drive
    return Point(at.number(1 / drive.crank.ratio + drive.shift), at.number(drive.pivot_height))


def end_of(at: Placed, pivot: Point) -> Point:
    """Return B; seen from the crank pin it is right of the pivot, for a negative curvature left of it."""
    side = -1 if at.drive.curvature > 0 else 1
    return circles(at.pin, at.rod, pivot, at.number(at.drive.rocker), side)


def towards_pivot(end: Point, pivot: Point, velocity: Any) -> Point:
    """Return the acceleration of B towards the pivot, from its velocity over v, in v²/R."""
    way = to(end, pivot)
    square = velocity * velocity / (distance(end, pivot) * distance(end, pivot))
    return plus(Point(0 * way.x, 0 * way.y), way, square)


def parted(at: Placed, masses: Any) -> Parted:
    """Return what the kernel knows of the rod."""
    found = at.drive.at(OUT, at.circle, at.kind)
    return parted_rocker(found.circle, found.place, found.arc, masses)


def of_rocker(shown: Construction, *own: Length, given: Step | None = None) -> Construction:
    """Return a figure as it is of the arc crank, with the lengths that are others, and its first step.

    Without one the first step is as it was, but for the line of the slide.
    """
    others = {one.letters: one for one in own}
    first = shown.steps[0]
    drawn = tuple(one for one in first.drawn if one != SLIDE)
    return shown._replace(
        holds=("arc",),
        steps=(given or first._replace(drawn=drawn), *shown.steps[1:]),
        lengths=tuple(others.get(one.letters) or _general(one) for one in shown.lengths),
        notes=(*shown.notes, CHI)
        if any("χ" in _general(one).formula for one in shown.lengths)
        else shown.notes,
    )


def _general(length: Length) -> Length:
    """Return a length whose formula does not hold for the straight line alone."""
    formula = length.formula.replace("- 2 p_1 p_2 cos φ", "- 2 p_1 p_2 cos χ")
    formula = formula.replace("+ 2 p_1 p_2 cos φ", "+ 2 p_1 p_2 cos χ").replace(
        "(p_1 cos φ -", "(p_1 cos χ -"
    )
    return length._replace(formula="" if "φ" in formula else formula)


def with_rocker(shown: Construction, *own: Length, given: Step | None = None) -> Construction:
    """Return a figure that holds for the arc crank, too."""
    holds = (*shown.holds, "arc")
    return shown._replace(holds=holds, variants={"arc": of_rocker(shown, *own, given=given)})
