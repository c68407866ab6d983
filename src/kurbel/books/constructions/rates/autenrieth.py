"""Autenrieth's construction as Schmolke tells it after him: a tangent at a circle about the crosshead.

Letters and steps are those of Schmolke, Dinglers Polytechnisches Journal 330 (1915), 475-476, who refers to
Autenrieth and Ensslin, Technische Mechanik. His C, of the turned plan, is that of his Abb. 3.
"""

from __future__ import annotations

from kurbel.books.constructions.geometry import meet, plus, to, turned
from kurbel.books.constructions.model import (
    AID,
    GIVEN,
    Circle,
    Construction,
    Line,
    Measure,
    Placed,
    Points,
    RightAngle,
    Step,
)
from kurbel.books.constructions.rates import plan
from kurbel.kernel.circle import root
from kurbel.page.quantity import words


def _points(at: Placed) -> Points:
    pin, head, shaft, c = at.pin, at.crosshead, at.shaft, plan.turned_plan(at)
    rod, share = to(head, pin), plan.shared(at, c)
    # The tangent from P touches the circle above F, where Q F · Q P = u².
    f = plus(head, rod, share)
    # Of the two tangents the one on the other side than E, which is on that of the pin.
    side = -1 if at.angle > 180 else 1
    e = meet(f, turned(rod), pin, plan.ALONG)
    return {
        "O": shaft,
        "P": pin,
        "Q": head,
        "C": c,
        "D": plus(f, turned(rod), side * root(share * (1 - share))),
        "F": f,
        "E": e,
        "G": plus(e, to(pin, shaft)),
    }


AUTENRIETH = Construction(
    name="autenrieth",
    title=words("Kolbenbeschleunigung nach Autenrieth|Acceleration of the piston, after Autenrieth"),
    source=words(
        "Schmolke, Dinglers Polytechnisches Journal 330 (1915), 475–476, Abb. 3 und 4, nach"
        " Autenrieth-Ensslin, Technische Mechanik"
        "|Schmolke, Dinglers Polytechnisches Journal 330 (1915), 475–476, Figs. 3 and 4, after"
        " Autenrieth-Ensslin, Technische Mechanik"
    ),
    points=_points,
    angle_symbol="$φ$",
    refusal=plan.STRAIGHT.format(author="Autenrieth"),
    steps=(
        plan.drive_step("P", "Q", offset=False),
        plan.plan_step("P", "Q", "C", Measure("PC", look=GIVEN, written=False), Measure("OC"), offset=False),
        Step(
            words(
                "Kreis um $Q$ mit dem Halbmesser $P C$, Tangente $P D$ an ihn"
                "|Circle about $Q$ of radius $P C$, tangent $P D$ to it"
            ),
            (Circle("Q", "D"), Line("P", "D", AID, 3), Line("Q", "D"), RightAngle("D", "P", "Q")),
            ("D",),
        ),
        Step(
            words(
                "Lot von $D$ auf die Schubstange: $Q F$ ist die Beschleunigung von $Q$ um $P$ nach der Stange"
                "|Perpendicular from $D$ to the rod: $Q F$ is the acceleration of $Q$ about $P$ along the rod"
            ),
            (Line("D", "F", AID, 3), RightAngle("F", "P", "D")),
            ("F",),
        ),
        Step(
            words(
                "Parallele zu $O Q$ durch $P$: sie trifft dieses Lot in $E$"
                "|Parallel to $O Q$ through $P$: it meets this perpendicular at $E$"
            ),
            (Line("P", "E", AID, 3), Line("F", "E", AID, 3)),
            ("E",),
        ),
        Step(
            words(
                "Parallele zu $O P$ durch $E$: sie trifft die Schubrichtung in $G$, $Q G = p/ω^2$; $Q F$ und"
                " $F E$ sind ebenso die Beschleunigung von $Q$ um $P$, nach der Stange und senkrecht zu ihr,"
                " $E G$ die von $P$"
                "|Parallel to $O P$ through $E$: it meets the slide line at $G$, $Q G = p/ω^2$; so are $Q F$"
                " and $F E$ the acceleration of $Q$ about $P$, along the rod and square to it, and $E G$ that"
                " of $P$"
            ),
            (
                Line("E", "G", GIVEN),
                Measure("QF", written=False),
                Measure("FE", written=False),
                Measure("QG"),
            ),
            ("G",),
        ),
    ),
    notes=(plan.SIGNS,),
    lengths=(
        plan.velocity_length("O", "C"),
        plan.swing_length("P", "C", "Q"),
        plan.normal_length("Q", "F", "P", "Q"),
        plan.tangential_length("F", "E", "P", "Q"),
        plan.acceleration_length("Q", "G"),
    ),
)
