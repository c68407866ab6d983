"""Ensslin's Fig. 7: the rod under the stretching accelerations alone."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from kurbel.books.constructions.ensslin.forces import (
    BY,
    CENTRE_LENGTH,
    DRAWN_ROD,
    GIVEN_ROD,
    INNER,
    QUARTERS,
    WIDE,
    WIDE_FORCE,
    laden,
    nothing,
    pressed,
)
from kurbel.books.constructions.ensslin.rocker import with_rocker
from kurbel.books.constructions.ensslin.rod import (
    SIZE,
    above,
    parted,
    rod_of,
    size,
    source,
)
from kurbel.books.constructions.geometry import plus, to, turned
from kurbel.books.constructions.model import (
    AID,
    RESULT,
    Arrow,
    Construction,
    Length,
    Line,
    Placed,
    Points,
    RightAngle,
    Scale,
    Step,
)
from kurbel.kernel.inertia.parts import STRETCHING
from kurbel.page.quantity import words

# How far beside the rod accelerations along it are drawn, in R.
BESIDE = Fraction(1, 4)


def _stretching(at: Placed) -> Points:
    """Return Fig. 7: p₅ square to the rod as an ordinate, that of S, and the force in A along the rod."""
    points = laden(at)
    way = to(points["B"], points["A"])
    points["p_5"] = plus(nothing(at), points["p_5"], at.rod)
    beside = plus(nothing(at), turned(way), at.ratio * at.number(BESIDE) * above(at))
    for name, share in (*zip(INNER, QUARTERS, strict=True), ("A", Fraction(1))):
        points[f"low {name}"] = plus(points[name], beside)
        points[f"low p_5 {name}"] = plus(points[f"low {name}"], points["p_5"], at.number(share))
    # p₅ turned by 90°, away from the arrows.
    points["C"] = plus(points["A"], turned(points["p_5"]), above(at))
    points["H"] = plus(points["B"], to(points["B"], points["C"]), at.number(1 - rod_of(at).centre))
    points["G"] = plus(points["A"], points["p_5"], -at.number(1 - rod_of(at).centre))
    return points


def _stretched(at: Placed) -> Any:
    """p₅ in v²/L."""
    return parted(at).stretching * at.rod


_FIG_7 = Construction(
    name="ensslin-7",
    title=words(
        "Kräfte der Schubstange unter den Dehnungsbeschleunigungen, nach Ensslin, Fig. 7"
        "|Forces of the rod under the stretching accelerations, after Ensslin, Fig. 7"
    ),
    source=source(7),
    points=_stretching,
    steps=(
        Step(GIVEN_ROD, (*DRAWN_ROD, Scale("scale", "scale end", "$v^2/L$, $M v^2/L$")), ("A", "B", "S")),
        Step(
            words(
                "Dehnungsbeschleunigungen $p_5' = p_5 x/l$ in der Stange, neben ihr gezeichnet, nach Fig. 4"
                "|Stretching accelerations $p_5' = p_5 x/l$ along the rod, drawn beside it, after Fig. 4"
            ),
            (
                *(Line(one, f"low {one}") for one in (*INNER, "A")),
                *(Arrow(f"low {one}", f"low p_5 {one}", "", AID) for one in INNER),
                Arrow("low A", "low p_5 A", "$p_5$", AID),
            ),
        ),
        Step(
            words(
                "$A C = p_5$ senkrecht zur Stange auftragen; die Gerade $B C$ gibt in $S$ die Beschleunigung"
                " $S H ="
                " p_5 a/l$ des Schwerpunkts"
                "|Lay off $A C = p_5$ square to the rod; the line $B C$ gives in $S$ the acceleration $S H ="
                " p_5 a/l$ of the centre of mass"
            ),
            (Line("A", "C"), Line("B", "C"), Line("S", "H"), RightAngle("A", "B", "C")),
            ("C", "H"),
        ),
        Step(
            words(
                "Die Trägheitskraft $A G = M p_5 a/l$ wirkt in der Stange gegen $A$ hin: wie die Masse $M"
                " a/l$ in"
                " $A$; in $B$ wirkt keine"
                "|The inertia force $A G = M p_5 a/l$ acts along the rod towards $A$: like the mass $M a/l$"
                " in"
                " $A$; in $B$ there is none"
            ),
            (Arrow("A", "G", "$M p_5 a/l$", RESULT),),
            ("G",),
        ),
    ),
    lengths=(
        CENTRE_LENGTH,
        Length("AC", ("A", "C"), "$p_5$", "$(cos^2 φ)/(cos^2 ψ)$", size("A", "C"), _stretched, WIDE),
        Length(
            "SH",
            ("S", "H"),
            "",
            "$p_5 a/l$",
            size("S", "H"),
            lambda at: at.number(1 - rod_of(at).centre) * _stretched(at),
            WIDE,
        ),
        Length(
            "AG",
            ("A", "G"),
            "",
            "$M p_5 a/l$",
            size("A", "G"),
            lambda at: pressed(STRETCHING, "A")(at) * at.rod,
            WIDE_FORCE,
        ),
    ),
    scales={WIDE: SIZE, WIDE_FORCE: SIZE},
    notes=(
        words(
            "Maßstab: $v^2/L$ und $M v^2/L$ sind $3/2 R$ lang gezeichnet"
            "|Scale: $v^2/L$ and $M v^2/L$ are drawn $3/2 R$ long"
        ),
    ),
    **BY,
)

FIG_7 = with_rocker(_FIG_7)
