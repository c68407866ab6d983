"""Ensslin's Figs. 3 and 4: the rod under the two accelerations of each point alone, p₂ and p₃'."""

from __future__ import annotations

from kurbel.books.constructions.ensslin.accelerations import (
    COMMON_LENGTH,
    INNER,
    P_2_LENGTH,
    P_3_LENGTH,
    POINT,
    SHARE_LENGTH,
    any_point,
)
from kurbel.books.constructions.ensslin.rocker import ON_ARC, with_rocker
from kurbel.books.constructions.ensslin.rod import (
    ACCELERATION,
    HOLDS,
    P_4,
    P_5,
    REFUSAL,
    ROD,
    SCALE,
    SCALE_BAR,
    SCALES,
    arrows,
    lengthwise,
    parted,
    source,
    square,
)
from kurbel.books.constructions.model import (
    HIDDEN,
    LINK,
    RESULT,
    Arrow,
    Construction,
    Length,
    Line,
    RightAngle,
    Step,
)
from kurbel.page.quantity import words

GIVEN_ROD = words(
    "Die Schubstange $A B = l$; $B$ bewegt sich auf der Geraden|The rod $A B = l$; $B$ moves along the line"
)

_FIG_3 = Construction(
    name="ensslin-3",
    title=words(
        "Schubstange unter der Beschleunigung von B allein, nach Ensslin, Fig. 3"
        "|The rod under the acceleration of B alone, after Ensslin, Fig. 3"
    ),
    source=source(3),
    points=any_point,
    steps=(
        Step(GIVEN_ROD, (*ROD, *SCALE_BAR), ("A", "B")),
        Step(
            words("Beschleunigung $p_2$ von $B$, nach Fig. 1|Acceleration $p_2$ of $B$, after Fig. 1"),
            (Arrow("B", "p_2 B", "$p_2$"),),
        ),
        Step(
            words(
                "In allen Punkten der Stange gleich groß und gleich gerichtet|Equal and in the same direction"
                " in all points of the rod"
            ),
            (*arrows("p_2", INNER), Arrow("A", "p_2 A", "$p_2$"), Line("p_2 A", "p_2 B", HIDDEN)),
        ),
    ),
    lengths=(P_2_LENGTH, ),
    holds=HOLDS,
    refusal=REFUSAL,
    scales=SCALES,
    angle_symbol="$φ$",
    notes=(SCALE,),
)  # fmt: skip

_FIG_4 = Construction(
    name="ensslin-4",
    title=words(
        "Schubstange unter dem Rest der Beschleunigungen, nach Ensslin, Fig. 4"
        "|The rod under the rest of the accelerations, after Ensslin, Fig. 4"
    ),
    source=source(4),
    points=any_point,
    steps=(
        Step(GIVEN_ROD, (*ROD, *SCALE_BAR), ("A", "B")),
        Step(
            words("Beschleunigung $p_3$ in $A$, nach Fig. 1|Acceleration $p_3$ in $A$, after Fig. 1"),
            (Arrow("A", "p_3 A", "$p_3$"),),
        ),
        Step(
            words(
                "Ihren Endpunkt mit $B$ verbinden: $p_3'$ in allen Punkten, parallel zu $p_3$ und dem"
                " Abstand $x$ von"
                " $B$ verhältnisgleich"
                "|Join its end with $B$: $p_3'$ in all points, parallel to $p_3$ and proportional to the"
                " distance $x$ from $B$"
            ),
            (
                Line("p_3 A", "B"),
                Line("p_3 D", "B"),
                Line("B", "D"),
                *arrows("p_3", INNER),
                Arrow("D", "p_3 D", "$p_3'$"),
            ),
            ("D",),
        ),
        Step(
            words(
                "$p_3$ senkrecht zur Stange und nach ihr zerlegen: Drehbeschleunigung $p_4$ und"
                " Dehnungsbeschleunigung $p_5$; ebenso $p_3'$ in $p_4'$ und $p_5'$"
                "|Part $p_3$ square to the rod and along it: turning acceleration $p_4$ and stretching"
                " acceleration $p_5$; likewise $p_3'$ into $p_4'$ and $p_5'$"
            ),
            (
                Arrow("A", "p_4 A", "$p_4$", RESULT),
                Arrow("p_4 A", "p_3 A", "$p_5$", RESULT),
                RightAngle("p_4 A", "A", "p_3 A"),
                Arrow("D", "p_4 D", "$p_4'$", RESULT),
                Arrow("p_4 D", "p_3 D", "$p_5'$", RESULT),
            ),
        ),
    ),
    lengths=(
        P_3_LENGTH,
        Length(
            "p_4", ("A", "p_4 A"), "", P_4, square("A", "p_4 A"),
            lambda at: parted(at).turning, ACCELERATION,
        ),
        Length(
            "p_5", ("p_4 A", "p_3 A"), "", P_5, lengthwise("p_4 A", "p_3 A"),
            lambda at: parted(at).stretching, ACCELERATION,
        ),
        SHARE_LENGTH,
        Length(
            "p_4'", ("D", "p_4 D"), "", "$p_4 x/l$", square("D", "p_4 D"),
            lambda at: at.number(at.beside.point) * parted(at).turning, ACCELERATION,
        ),
        Length(
            "p_5'", ("p_4 D", "p_3 D"), "", "$p_5 x/l$", lengthwise("p_4 D", "p_3 D"),
            lambda at: at.number(at.beside.point) * parted(at).stretching, ACCELERATION,
        ),
    ),
    holds=HOLDS,
    refusal=REFUSAL,
    scales=SCALES,
    angle_symbol="$φ$",
    notes=(SCALE,),
    takes=POINT,
)  # fmt: skip

ON_ROCKER = Step(ON_ARC, (Line("A", "B", LINK), *SCALE_BAR), ("A", "B"))
FIG_3, FIG_4 = (with_rocker(one, COMMON_LENGTH, given=ON_ROCKER) for one in (_FIG_3, _FIG_4))
