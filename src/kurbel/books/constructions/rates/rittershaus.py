"""Rittershaus's construction: Klein's point on the rod by two parallels, without compasses.

Letters and steps are those of Khurmi and Gupta, who write Ritterhaus; Ensslin names him Rittershaus.
"""

from __future__ import annotations

from fractions import Fraction

from kurbel.books.constructions.geometry import meet, to, turned
from kurbel.books.constructions.model import (
    AID,
    GIVEN,
    Construction,
    Line,
    Measure,
    Placed,
    Points,
    RightAngle,
    Step,
)
from kurbel.books.constructions.rates import plan
from kurbel.drive.crank import Crank
from kurbel.page.quantity import words


def _points(at: Placed) -> Points:
    pin, head, shaft, m = at.pin, at.crosshead, at.shaft, plan.turned_plan(at)
    rod = to(pin, head)
    k = meet(m, plan.ALONG, shaft, pin)
    q = meet(k, plan.UP, pin, rod)
    return {
        "O": shaft,
        "C": pin,
        "P": head,
        "M": m,
        "K": k,
        "Q": q,
        "N": meet(q, turned(rod), shaft, plan.ALONG),
    }


def _refused(drive: Crank, angle: Fraction) -> str:
    if angle % 180:
        return ""
    return (
        "at a dead centre the lines that are to meet in K are one and the same: Rittershaus's construction"
        " has no point there; take klein, or an angle beside it, such as 1"
    )


RITTERSHAUS = Construction(
    name="rittershaus",
    title=words("Kolbenbeschleunigung nach Rittershaus|Acceleration of the piston, after Rittershaus"),
    source=words(
        "Khurmi und Gupta, Theory of Machines, Kap. 15: Ritterhaus’s construction"
        "|Khurmi and Gupta, Theory of Machines, ch. 15: Ritterhaus’s construction"
    ),
    points=_points,
    angle_symbol="$φ$",
    refused=_refused,
    refusal=plan.STRAIGHT.format(author="Rittershaus"),
    mirrored=True,
    steps=(
        plan.drive_step("C", "P", offset=False),
        plan.plan_step("C", "P", "M", Measure("CM", look=GIVEN, written=False), Measure("OM"), offset=False),
        Step(
            words(
                "Parallele zur Schubrichtung durch $M$: sie trifft die Kurbel oder ihre Verlängerung in $K$"
                "|Parallel to the slide through $M$: it meets the crank, or the crank produced, at $K$"
            ),
            (Line("M", "K", AID, 3), Line("C", "K", AID, 3)),
            ("K",),
        ),
        Step(
            words(
                "Senkrechte zur Schubrichtung durch $K$: sie trifft die Schubstange oder ihre Verlängerung in"
                " $Q$"
                "|Perpendicular to the slide through $K$: it meets the rod, or the rod produced, at $Q$"
            ),
            (Line("K", "Q", AID, 3), RightAngle("K", "M", "Q")),
            ("Q",),
        ),
        Step(
            words(
                "Senkrechte zur Schubstange in $Q$: sie trifft die Schubrichtung in $N$"
                "|Perpendicular to the rod at $Q$: it meets the slide line at $N$"
            ),
            (Line("Q", "N", AID, 3), RightAngle("Q", "P", "N")),
            ("N",),
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
