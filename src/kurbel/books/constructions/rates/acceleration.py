"""The plan of accelerations, from which the acceleration of the crosshead is read off: not turned round.

O, P, Q and C are the letters of the plan of velocities; pole, points and order of the polygon are those of
Khurmi and Gupta, ch. 8, Fig. 8.3.
"""

from __future__ import annotations

from kurbel.books.constructions.geometry import Point, meet, plus, to, turned
from kurbel.books.constructions.model import (
    AID,
    GIVEN,
    Arrow,
    Construction,
    Line,
    Measure,
    Placed,
    Points,
    RightAngle,
    Step,
)
from kurbel.books.constructions.rates import plan, polygon
from kurbel.books.constructions.rates.acceleration_rocker import OF_ROCKER
from kurbel.page.quantity import words


def _drive(at: Placed) -> Points:
    pin, head, shaft, c = at.pin, at.crosshead, at.shaft, plan.turned_plan(at)
    swing = turned(to(pin, c))
    return {
        "O": shaft,
        "P": pin,
        "Q": head,
        "C": c,
        "D": plus(pin, swing),
        "E": polygon.altitude(pin, swing, head),
        "across": Point(head.x, shaft.y),
        "above": Point(shaft.x, head.y),
    }


def _polygon(drive: Points, pole: Point) -> Points:
    of_pin = plus(pole, to(drive["P"], drive["O"]))
    x = plus(of_pin, to(drive["P"], drive["E"]))
    return {
        "o'": pole,
        "p'": of_pin,
        "x": x,
        "q'": meet(x, turned(to(drive["P"], drive["Q"])), pole, plan.ALONG),
    }


ACCELERATION = Construction(
    name="acceleration",
    title=words(
        "Kolbenbeschleunigung aus dem Beschleunigungsplan"
        "|Acceleration of the piston, from the plan of accelerations"
    ),
    source=polygon.SOURCE,
    points=lambda at: polygon.with_polygon(at, _drive, _polygon, -1),
    angle_symbol="$φ$",
    holds=("straight", "offset", "arc"),
    variants={"arc": OF_ROCKER},
    steps=(
        plan.drive_step("P", "Q"),
        plan.plan_step(
            "P", "Q", "C", Measure("PC", look=GIVEN, written=False), Measure("OC", look=GIVEN, written=False)
        ),
        polygon.ALTITUDE,
        polygon.NORMAL,
        Step(
            words(
                "Durch $x$ die Senkrechte zur Schubstange, durch $o'$ die Parallele zur Schubrichtung: sie"
                " treffen sich in $q'$"
                "|Perpendicular to the rod through $x$, parallel to the slide through $o'$: they meet at $q'$"
            ),
            (Line("x", "q'", AID, 3), Line("o'", "q'", AID, 3), RightAngle("x", "p'", "q'")),
            ("q'",),
        ),
        Step(
            words(
                "$o' q' = p/ω^2$; ebenso sind $p' x$ und $x q'$ die Beschleunigung von $Q$ um $P$, nach der"
                " Stange und senkrecht zu ihr, $o' p'$ die von $P$"
                "|$o' q' = p/ω^2$; so are $p' x$ and $x q'$ the acceleration of $Q$ about $P$, along the rod"
                " and square to it, and $o' p'$ that of $P$"
            ),
            (Arrow("x", "q'", "", GIVEN), Arrow("o'", "q'", "$p$")),
        ),
    ),
    notes=(plan.SIGNS,),
    lengths=(
        plan.velocity_length("O", "C"),
        plan.swing_length("P", "C", "Q"),
        plan.normal_length("p'", "x", "P", "Q"),
        plan.tangential_length("x", "q'", "P", "Q"),
        plan.acceleration_length("o'", "q'"),
    ),
)
