"""Klein's construction: the common chord of two circles cuts the piston's acceleration off the slide line.

The circle on the rod as its diameter and the one about the crank pin through the turned plan's point. Letters
and steps are those of Khurmi and Gupta.
"""

from __future__ import annotations

from fractions import Fraction

from kurbel.books.constructions.geometry import Point, meet, plus, to, turned
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
    pin, head, shaft, m = at.pin, at.crosshead, at.shaft, plan.turned_plan(at)
    rod, share = to(pin, head), plan.shared(at, m)
    # The chord of the two circles is square to the rod where C Q = u²/L, and K Q² = C Q · Q P above it. Two
    # circles in general lose all digits where C M is short.
    q, high = plus(pin, rod, share), root(share * (1 - share))
    return {
        "O": shaft,
        "C": pin,
        "P": head,
        "M": m,
        "middle": plus(pin, rod, at.number(Fraction(1, 2))),
        "K": plus(q, turned(rod), high),
        "L": plus(q, turned(rod), -high),
        "Q": q,
        "N": meet(q, turned(rod), shaft, plan.ALONG),
        # The slide line of an offset crank, and the parallel to it through the shaft, have an end each.
        "across": Point(head.x, shaft.y),
        "above": Point(shaft.x, head.y),
    }


KLEIN = Construction(
    name="klein",
    title=words("Kolbenbeschleunigung nach Klein|Acceleration of the piston, after Klein"),
    source=words(
        "Khurmi und Gupta, Theory of Machines, Kap. 15, Fig. 15.2: Klien’s construction"
        "|Khurmi and Gupta, Theory of Machines, ch. 15, Fig. 15.2: Klien’s construction"
    ),
    points=_points,
    angle_symbol="$φ$",
    holds=("straight", "offset"),
    refusal="Klein's construction holds for the straight and the offset crank alone: the rod's end of others"
    " is not accelerated along a line; acceleration holds for the arc crank, too",
    mirrored=True,
    steps=(
        plan.drive_step("C", "P"),
        plan.plan_step("C", "P", "M", Measure("CM", look=GIVEN, written=False), Measure("OM")),
        Step(words("Kreis um $C$ durch $M$|Circle about $C$ through $M$"), (Circle("C", "M"),)),
        Step(
            words("Kreis über dem Durchmesser $C P$|Circle with the diameter $C P$"), (Circle("middle", "C"),)
        ),
        Step(
            words(
                "Die gemeinsame Sehne $K L$ der Kreise trifft die Schubstange in $Q$ und die Schubrichtung"
                " durch $O$ in $N$"
                "|The common chord $K L$ of the circles meets the rod at $Q$ and the slide direction through"
                " $O$ at $N$"
            ),
            (Line("K", "L", AID, 3), Line("Q", "N", AID, 3), RightAngle("Q", "P", "N")),
            ("K", "L", "Q", "N"),
        ),
        Step(
            plan.said(plan.PARTS, shaft="O", pin="C", head="P", share="Q", end="N"),
            (Measure("CQ", written=False), Measure("QN", written=False), Measure("NO")),
        ),
    ),
    notes=(plan.SIGNS,),
    lengths=(
        plan.velocity_length("O", "M"),
        plan.swing_length("C", "M", "P"),
        plan.normal_length("C", "Q", "C", "P"),
        plan.tangential_length("Q", "N", "C", "P"),
        plan.acceleration_length("N", "O"),
    ),
)
