"""Kuhn's parabola of accelerations: to first order p is the way from the crank pin to it along the slide.

Letters and steps are those of Kuhn, Dinglers Polytechnisches Journal 342 (1927), 253-256, Abb. 3, with the
letters of Abb. 1; his ω, the crank angle, is φ here, and T his T with an index.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from kurbel.books.constructions.geometry import Point
from kurbel.books.constructions.model import (
    AID,
    CENTRE,
    GIVEN,
    LINK,
    Angle,
    Circle,
    Construction,
    Curve,
    Length,
    Line,
    Measure,
    Placed,
    Points,
    RightAngle,
    Step,
    along,
)
from kurbel.books.constructions.rates import plan
from kurbel.page.quantity import words

# Of the half of the parabola that is drawn.
POINTS = 60


def _on_parabola(at: Placed, height: Any) -> Point:
    """Return its point so far from the slide line: y² = (x + R λ) R/(2 λ), x to the side of the crosshead."""
    return Point(at.ratio * (2 * height * height - 1), height)


def _points(at: Placed) -> Points:
    one, zero = at.number(1), at.number(0)
    return {
        "O": at.shaft,
        "M": at.pin,
        "N": Point(zero, at.pin.y),
        "P": _on_parabola(at, at.pin.y),
        "S": Point(-at.ratio, zero),
        "T": Point(one, zero),
        "bottom": Point(zero, -one),
        "top": Point(zero, one),
        "end": Point(-one, zero),
    }


def _curves(at: Placed) -> Mapping[str, Sequence[Point]]:
    heights = (step / POINTS for step in range(-POINTS, POINTS + 1))
    return {"parabola": [_on_parabola(at, height) for height in heights]}


KUHN = Construction(
    name="kuhn",
    title=words(
        "Kolbenbeschleunigung nach Kuhn, mit der Parabel"
        "|Acceleration of the piston, after Kuhn, by the parabola"
    ),
    source=words(
        "Kuhn, Dinglers Polytechnisches Journal 342 (1927), 253–256, Abb. 3"
        "|Kuhn, Dinglers Polytechnisches Journal 342 (1927), 253–256, Fig. 3"
    ),
    points=_points,
    curves=_curves,
    angle_symbol="$φ$",
    refusal="Kuhn's parabola is that of the formula cos φ + λ cos 2φ, which is of the straight crank alone",
    mirrored=True,
    steps=(
        Step(
            words(
                "Kurbelkreis um $O$, $T$ die innere Totlage, $O S = R λ$ auf der anderen Seite; die"
                " Geschwindigkeit $v = ω R$ des Kurbelzapfens ist so lang wie $R$"
                "|Crank circle about $O$, $T$ the inner dead centre, $O S = R λ$ on the other side; the"
                " velocity $v = ω R$ of the crank pin is as long as $R$"
            ),
            (
                Circle("O", "T", CENTRE),
                Line("T", "end", CENTRE, 4),
                Line("bottom", "top", CENTRE, 4),
                Measure("OS", look=GIVEN, written=False),
            ),
            ("O", "T", "S"),
        ),
        Step(
            words(
                "Parabel mit dem Scheitel $S$ und der Schubrichtung als Achse; in der Höhe $R$ ist sie um"
                " $R λ$ von der Senkrechten durch $O$ entfernt, in der Höhe $R/2$ um die Hälfte, dort auf der"
                " Seite von $S$"
                "|Parabola with the vertex $S$ and the slide direction as its axis; at the height $R$ it is"
                " $R λ$ away from the perpendicular through $O$, at the height $R/2$ half as much, there on"
                " the side of $S$"
            ),
            (Curve("parabola", GIVEN),),
        ),
        Step(
            words(
                "Kurbel $O M$ um $φ$ aus der inneren Totlage gedreht"
                "|Crank $O M$ turned by $φ$ out of the inner dead centre"
            ),
            (Line("O", "M", LINK), Angle("O", "T", "M", "$φ$", 1)),
            ("M",),
        ),
        Step(
            words(
                "Parallele zur Schubrichtung durch $M$: sie trifft die Senkrechte in $N$ und die Parabel in"
                " $P$; $M P = p/ω^2$"
                "|Parallel to the slide through $M$: it meets the perpendicular at $N$ and the parabola at"
                " $P$; $M P = p/ω^2$"
            ),
            (
                Line("M", "P", AID, 3),
                RightAngle("N", "M", "O"),
                Measure("MN", look=GIVEN, written=False),
                Measure("NP", look=GIVEN, written=False),
                Measure("MP"),
            ),
            ("N", "P"),
        ),
    ),
    lengths=(
        Length("OS", ("O", "S"), "", "$R λ$", along("O", "S"), lambda at: at.ratio),
        Length("MN", ("M", "N"), "", "$R cos φ$", along("M", "N"), lambda at: at.circle.cosine),
        Length(
            "NP", ("N", "P"), "", "$R λ cos 2 φ$", along("N", "P"),
            lambda at: at.ratio * (1 - 2 * at.circle.sine * at.circle.sine),
        ),
        Length(
            "MP", ("M", "P"), "$p/ω^2$", "$R(cos φ + λ cos 2 φ)$", along("M", "P"), plan.acceleration,
            approximate=words(
                "die Parabel ist die der Formel erster Ordnung in $λ$"
                "|the parabola is that of the formula to first order in $λ$"
            ),
        ),
    ),
)  # fmt: skip
