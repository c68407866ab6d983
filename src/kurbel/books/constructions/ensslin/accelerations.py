"""Ensslin's Figs. 1 and 2: the acceleration of A, and of any point of the rod, as that of B and a rest."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from kurbel.books.constructions.ensslin.rocker import GIVEN as GIVEN_ROCKER
from kurbel.books.constructions.ensslin.rocker import with_rocker
from kurbel.books.constructions.ensslin.rod import (
    ACCELERATION,
    HOLDS,
    P_2,
    REFUSAL,
    SCALE,
    SCALES,
    arrows,
    in_scale,
    laid_off,
    on_rod,
    parted,
    rod_points,
    size,
    source,
    with_scale,
)
from kurbel.books.constructions.geometry import distance, dot, plus, to
from kurbel.books.constructions.model import (
    CENTRE,
    HIDDEN,
    LINK,
    RESULT,
    Arrow,
    Circle,
    Construction,
    Length,
    Line,
    Placed,
    Points,
    Step,
)
from kurbel.page.quantity import words

QUARTERS = tuple(Fraction(part, 4) for part in (1, 2, 3))
INNER = tuple(f"rod {share}" for share in QUARTERS)
WHOLE = (*INNER, "A")


def _middle(at: Placed) -> Points:
    """Return Fig. 1: the accelerations in A, B and the middle D of the rod."""
    points = rod_points(at)
    laid_off(laid_off(laid_off(points, "p_2", "A", "B"), "p_3", "A"), "p_1", "A")
    half = at.number(Fraction(1, 2))
    points["D"] = on_rod(points, half)
    points["E"] = plus(points["p_1 A"], to(points["p_1 A"], points["p_2 B"]), half)
    return points


def any_point(at: Placed) -> Points:
    """Return Figs. 2 to 4: the quarters of the rod and its point D at the distance x, with their parts."""
    points = with_scale(rod_points(at), at)
    shares = {
        "B": Fraction(0),
        "A": Fraction(1),
        "D": at.beside.point,
        **dict(zip(INNER, QUARTERS, strict=True)),
    }
    for name, share in shares.items():
        number = at.number(share)
        points[name] = on_rod(points, number)
        laid_off(points, "p_2", name)
        for vector in ("p_3", "p_4", "p_5"):
            laid_off(points, vector, name, share=number)
        laid_off(points, "p_1", name)
        points[f"p {name}"] = plus(points[f"p_2 {name}"], points["p_3"], number)
    return points


def _share(points: Points) -> Any:
    """Return p₃ at D, positive on the side of A."""
    return in_scale(
        dot(to(points["D"], points["p_3 D"]), points["p_3"]) / distance(points["A"], points["p_3 A"])
    )


P_1_LENGTH = Length(
    "p_1", ("A", "p_1 A"), "", "$v^2/R$", size("A", "p_1 A"), lambda at: at.number(1), ACCELERATION
)
P_2_LENGTH = Length(
    "p_2", ("B", "p_2 B"), "", P_2, lambda points: in_scale(points["B"].x - points["p_2 B"].x),
    lambda at: parted(at).common.along, ACCELERATION,
)  # fmt: skip
P_3_LENGTH = Length(
    "p_3", ("A", "p_3 A"), "", "$sqrt(p_1^2 + p_2^2 - 2 p_1 p_2 cos φ)$", size("A", "p_3 A"),
    lambda at: parted(at).replaced_size(), ACCELERATION,
)  # fmt: skip
# Where B moves on an arc p₂ has any direction.
COMMON_LENGTH = Length(
    "p_2", ("B", "p_2 B"), "", "", size("B", "p_2 B"), lambda at: parted(at).common.size(), ACCELERATION
)
SHARE_LENGTH = Length(
    "p_3'", ("D", "p_3 D"), "", "$p_3 x/l$", _share,
    lambda at: at.number(at.beside.point) * parted(at).replaced_size(), ACCELERATION,
)  # fmt: skip
GIVEN_CRANK = words("Kurbel $O A$ und Schubstange $A B = l$|Crank $O A$ and rod $A B = l$")
TAKEN = words(
    "Beschleunigung $p_1 = v^2/R$ von $A$, nach $O$ gerichtet; in demselben Maßstab $p_2$ von $B$, die als"
    " bekannt gilt"
    "|Acceleration $p_1 = v^2/R$ of $A$, towards $O$; to the same scale $p_2$ of $B$, which is taken for"
    " known"
)
CRANK = (
    Circle("O", "A", CENTRE),
    Line("way", "B", CENTRE, 4.0),
    Line("O", "A"),
    Line("A", "B", LINK),
)
POINT = ("point",)

_FIG_1 = Construction(
    name="ensslin-1",
    title=words(
        "Beschleunigung des Kurbelzapfens nach Ensslin, Fig. 1"
        "|Acceleration of the crank pin, after Ensslin, Fig. 1"
    ),
    source=source(1),
    points=_middle,
    steps=(
        Step(GIVEN_CRANK, CRANK, ("O", "A", "B")),
        Step(TAKEN, (Arrow("A", "p_1 A", "$p_1$"), Arrow("B", "p_2 B", "$p_2$"))),
        Step(
            words(
                "Die Endpunkte der Beschleunigungen von $A$ und $B$ verbinden; die Mitte $E$ dieser Strecke"
                " ist"
                " der Endpunkt der Beschleunigung $p$ der Stangenmitte $D$"
                "|Join the ends of the accelerations of $A$ and $B$; the middle $E$ of this line is the end"
                " of"
                " the acceleration $p$ of the middle $D$ of the rod"
            ),
            (Line("p_1 A", "p_2 B"), Arrow("D", "E", "$p$")),
            ("D", "E"),
        ),
        Step(
            words(
                "In $A$ wird $p_1$ ersetzt durch $p_2$, gleich lang und gleich gerichtet wie in $B$, und"
                " durch"
                " die zweite Seite $p_3$ des Parallelogramms"
                "|In $A$ replace $p_1$ by $p_2$, as long as in $B$ and in the same direction, and by the"
                " second"
                " side $p_3$ of the parallelogram"
            ),
            (
                Arrow("A", "p_2 A", "$p_2$"),
                Arrow("A", "p_3 A", "$p_3$", RESULT),
                Line("p_2 A", "p_1 A"),
                Line("p_3 A", "p_1 A"),
            ),
        ),
    ),
    lengths=(
        P_1_LENGTH,
        P_2_LENGTH,
        P_3_LENGTH,
        Length(
            "p", ("D", "E"), "", "$sqrt(p_1^2 + p_2^2 + 2 p_1 p_2 cos φ)/2$", size("D", "E"),
            lambda at: parted(at).at_point(at.number(Fraction(1, 2))).size(), ACCELERATION,
        ),
    ),
    holds=HOLDS,
    refusal=REFUSAL,
    scales=SCALES,
    angle_symbol="$φ$",
    notes=(SCALE,),
)  # fmt: skip

_FIG_2 = Construction(
    name="ensslin-2",
    title=words(
        "Beschleunigung eines Stangenpunktes nach Ensslin, Fig. 2"
        "|Acceleration of a point of the rod, after Ensslin, Fig. 2"
    ),
    source=source(2),
    points=any_point,
    steps=(
        Step(GIVEN_CRANK, CRANK, ("O", "A", "B")),
        Step(TAKEN, (Arrow("A", "p_1 A", "$p_1$"), Arrow("B", "p_2 B", "$p_2$"))),
        Step(
            words(
                "Die Strecke zwischen den Endpunkten teilen, wie $D$ die Stange teilt: Beschleunigung $p$"
                " von $D$ im"
                " Abstand $x$ von $B$; ebenso an den Vierteln der Stange"
                "|Divide the line between the ends as $D$ divides the rod: acceleration $p$ of $D$ at the"
                " distance $x$ from $B$; likewise at the quarters of the rod"
            ),
            (
                Line("p_1 A", "p_2 B"),
                Line("p D", "p_2 B"),
                Line("B", "D"),
                Arrow("D", "p D", "$p$"),
                *arrows("p", INNER),
            ),
            ("D",),
        ),
        Step(
            words(
                "In jedem Punkt $p_2$ abtragen: die Endpunkte liegen auf der Parallelen zur Stange"
                "|Lay $p_2$ off from each point: the ends lie on the parallel to the rod"
            ),
            (Line("p_2 A", "p_2 B", HIDDEN), Arrow("A", "p_2 A", "$p_2$"), Arrow("D", "p_2 D", "$p_2$")),
        ),
        Step(
            words(
                "Zwischen der Parallelen und der Strecke der Endpunkte liegt $p_3'$: parallel zu $p_3$ und"
                " dem"
                " Abstand von $B$ verhältnisgleich"
                "|Between the parallel and the line of the ends lies $p_3'$: parallel to $p_3$ and"
                " proportional"
                " to the distance from $B$"
            ),
            (
                Arrow("A", "p_3 A", "$p_3$"),
                Line("p_3 A", "p_1 A"),
                Line("p_2 A", "p_1 A"),
                Arrow("D", "p_3 D", "$p_3'$", RESULT),
                Line("p_3 D", "p D"),
                Line("p_2 D", "p D"),
                *(Line(f"p_2 {one}", f"p {one}") for one in INNER),
            ),
        ),
    ),
    lengths=(
        P_1_LENGTH,
        P_2_LENGTH,
        P_3_LENGTH,
        SHARE_LENGTH,
        Length(
            "p", ("D", "p D"), "", "$sqrt(p_2^2 + p_3'^2 + 2 p_2 (p_1 cos φ - p_2) x/l)$", size("D", "p D"),
            lambda at: parted(at).at_point(at.number(at.beside.point)).size(), ACCELERATION,
        ),
    ),
    holds=HOLDS,
    refusal=REFUSAL,
    scales=SCALES,
    angle_symbol="$φ$",
    notes=(SCALE,),
    takes=POINT,
)  # fmt: skip

FIG_1, FIG_2 = (with_rocker(one, COMMON_LENGTH, given=GIVEN_ROCKER) for one in (_FIG_1, _FIG_2))
