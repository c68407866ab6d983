"""The first way of Rötscher's Abb. 1047 for the arc crank, where the arc cuts the circle of the rocker.

Rötscher draws the straight crank; what he does with its piston-path line is done here with the circle on
which the rod's end moves.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from kurbel.books.constructions.geometry import Point, circles
from kurbel.books.constructions.model import (
    AID,
    CENTRE,
    GIVEN,
    HIDDEN,
    LINK,
    Angle,
    Arc,
    Circle,
    Construction,
    Length,
    Line,
    Measure,
    Placed,
    Points,
    Step,
    between,
)
from kurbel.kernel import linkage
from kurbel.motion.evaluation import OUT, RETURN
from kurbel.page.quantity import words


def _points(at: Placed) -> Points:
    drive = at.drive
    pivot = Point(at.number(1 / drive.crank.ratio + drive.shift), at.number(drive.pivot_height))
    opposite = Point(-at.pin.x, -at.pin.y)
    # Seen from the shaft the rod's end is right of the pivot, for a negative curvature left of it.
    side = -1 if drive.curvature > 0 else 1

    def end(centre: Point, radius: Any) -> Point:
        return circles(centre, radius, pivot, at.number(drive.rocker), side)

    inner, outer = end(at.shaft, at.rod + 1), end(at.shaft, at.rod - 1)
    return {
        "O": at.shaft,
        "P": pivot,
        "K_1": inner,
        "K_2": outer,
        "A": Point(inner.x / (at.rod + 1), inner.y / (at.rod + 1)),
        "B": Point(-outer.x / (at.rod - 1), -outer.y / (at.rod - 1)),
        "C": at.pin,
        "D": opposite,
        "K": end(at.pin, at.rod),
        "K'": end(opposite, at.rod),
        # Where angles count from.
        "w": Point(at.number(1), at.number(0)),
    }


def _chord(stroke: int) -> Callable[[Placed], Any]:
    """Return what computes the way of the rod's end, straight, from where the stroke begins."""

    def chord(at: Placed) -> Any:
        found = at.drive.at(stroke, at.circle, at.kind)
        return linkage.chord(found.place, found.arc)

    return chord


OF_ROCKER = Construction(
    name="roetscher-1047-line",
    title=words(
        "Wege des Stangenendes auf dem Kreis der Schwinge, wie Rötscher, Abb. 1047"
        "|Ways of the rod's end on the circle of the rocker, as Rötscher, Abb. 1047"
    ),
    source=words(
        "nach Rötscher, Maschinenelemente, 14. Abschnitt, Abb. 1047"
        "|after Rötscher, Maschinenelemente, section 14, Abb. 1047"
    ),
    points=_points,
    mirrored=True,
    angle_symbol="$φ$",
    holds=("arc",),
    notes=(
        words(
            "Gezeichnet ist die Sehne; der Weg auf dem Bogen ist $B ϑ$, $ϑ$ der Winkel im Bogenmaß, um den"
            " sich die Schwinge gedreht hat"
            "|The chord is drawn; the way on the arc is $B ϑ$, $ϑ$ being the angle in radians by which the"
            " rocker has turned"
        ),
    ),
    steps=(
        Step(
            words(
                "Kurbelkreis um $O$, und um das Lager $P$ der Schwinge der Kreis, auf dem das Stangenende"
                " geht"
                "|Crank circle about $O$, and about the bearing $P$ of the rocker the circle on which the"
                " rod's end moves"
            ),
            (Circle("O", "A", CENTRE), Arc("P", "K_1", "K_2", GIVEN, 8.0), Line("O", "w", CENTRE, 4)),
            ("O", "P"),
        ),
        Step(
            words(
                "Streck- und Decklage: Bögen um $O$ mit $L + R$ und $L - R$ schneiden ihn in den Totlagen"
                " $K_1$ und $K_2$; $A$ und $B$ sind die Totpunkte der Kurbel"
                "|Rod and crank in line: arcs about $O$ of $L + R$ and $L - R$ cut it at the dead centres"
                " $K_1$ and $K_2$; $A$ and $B$ are those of the crank"
            ),
            (
                Arc("O", "K_1", "K_1", beyond=4.0),
                Arc("O", "K_2", "K_2", beyond=4.0),
                Line("K_1", "O", HIDDEN),
                Line("K_2", "B", HIDDEN),
            ),
            ("A", "B", "K_1", "K_2"),
        ),
        Step(
            words(
                "Kurbel $O C$ unter dem Winkel $φ$ gegen die Schubrichtung; der Bogen um $C$ mit der"
                " Stangenlänge $L$ schneidet den Kreis der Schwinge in $K$: $K_1 K$ ist der Weg im Hingang"
                "|Crank $O C$ at the angle $φ$ to the direction of the slide; the arc about $C$ of the rod's"
                " length $L$ cuts the circle of the rocker at $K$: $K_1 K$ is the way of the outstroke"
            ),
            (
                Line("O", "C", LINK),
                Angle("O", "w", "C", "$φ$", 1),
                Line("C", "K"),
                Arc("C", "K", "K", beyond=6.0),
                Line("P", "K", AID),
                Measure("K_1K", look=GIVEN),
            ),
            ("C", "K"),
        ),
        Step(
            words(
                "Gegenüber von $C$ liegt $D$; ebenso $K'$ durch den Bogen um $D$: $K_2 K'$ ist der Weg aus"
                " der äußeren Totlage"
                "|Opposite to $C$ lies $D$; likewise $K'$ by the arc about $D$: $K_2 K'$ is the way from the"
                " outer dead centre"
            ),
            (
                Line("O", "D", LINK),
                Line("D", "K'"),
                Arc("D", "K'", "K'", beyond=6.0),
                Measure("K_2K'", look=GIVEN),
            ),
            ("D", "K'"),
        ),
    ),
    lengths=(
        Length("K_1K", ("K_1", "K"), "", "$2 B sin(ϑ/2)$", between("K_1", "K"), _chord(OUT)),
        Length("K_2K'", ("K_2", "K'"), "", "$2 B sin(ϑ/2)$", between("K_2", "K'"), _chord(RETURN)),
    ),
)
