"""Ensslin's Fig. 5: the rod under the acceleration p₂ alone."""

from __future__ import annotations

from kurbel.books.constructions.ensslin.forces import (
    BY,
    CENTRE_LENGTH,
    DRAWN_ROD,
    GIVEN_ROD,
    INNER,
    SCALE_OF_FORCES,
    laden,
    nothing,
    pressed,
    slidewise,
    whole,
)
from kurbel.books.constructions.ensslin.rocker import with_rocker
from kurbel.books.constructions.ensslin.rod import (
    FORCE,
    P_2,
    SCALES,
    SIZE,
    arrows,
    laid_off,
    rod_of,
    size,
    source,
)
from kurbel.books.constructions.geometry import plus, to
from kurbel.books.constructions.model import (
    AID,
    HIDDEN,
    RESULT,
    Arrow,
    Construction,
    Length,
    Line,
    Placed,
    Points,
    Scale,
    Step,
)
from kurbel.kernel.inertia.parts import COMMON
from kurbel.page.quantity import words


def _common(at: Placed) -> Points:
    """Return Fig. 5: the force at S, and how the diagonal of a parallelogram parts it."""
    points = laden(at, "p_2")
    points["force"] = plus(nothing(at), points["p_2"], -1)
    laid_off(points, "force", "A", "B", "S")
    points["K"] = points["force S"]
    points["H"] = plus(points["A"], to(points["A"], points["force B"]), at.number(rod_of(at).centre))
    points["in A"] = plus(points["A"], to(points["H"], points["K"]))
    points["in B"] = plus(points["B"], to(points["S"], points["H"]))
    return points


_FIG_5 = Construction(
    name="ensslin-5",
    title=words(
        "Kräfte der Schubstange unter der Beschleunigung von B, nach Ensslin, Fig. 5"
        "|Forces of the rod under the acceleration of B, after Ensslin, Fig. 5"
    ),
    source=source(5),
    points=_common,
    steps=(
        Step(GIVEN_ROD, (*DRAWN_ROD, Scale("scale", "scale end", "$v^2/R$, $M v^2/R$")), ("A", "B", "S")),
        Step(
            words(
                "In allen Punkten die Beschleunigung $p_2$; sie wirkt wie die Erdbeschleunigung"
                "|In all points the acceleration $p_2$; it acts like gravity"
            ),
            (
                *arrows("p_2", ("B", *INNER)),
                Arrow("A", "p_2 A", "$p_2$", AID),
                Line("p_2 A", "p_2 B", HIDDEN),
            ),
        ),
        Step(
            words(
                "Die Trägheitskraft $S K = M p_2$ geht durch $S$, der Beschleunigung entgegen"
                "|The inertia force $S K = M p_2$ goes through $S$, against the acceleration"
            ),
            (Arrow("S", "K", "$M p_2$"),),
            ("K",),
        ),
        Step(
            words(
                "Parallelogramm über $A B$ mit $M p_2$; seine Diagonale aus $A$ schneidet $S K$ in $H$"
                "|Parallelogram on $A B$ with $M p_2$; its diagonal from $A$ cuts $S K$ in $H$"
            ),
            (
                Line("A", "force A"),
                Line("B", "force B"),
                Line("force A", "force B"),
                Line("A", "force B"),
            ),
            ("H",),
        ),
        Step(
            words(
                "Die Stange drückt auf $A$ mit $H K = M p_2 a/l$, auf $B$ mit $S H = M p_2 b/l$: wie zwei"
                " Massen"
                " nach dem Schwerpunktsgesetz, $M a/l$ in $A$ und $M b/l$ in $B$"
                "|The rod presses on $A$ with $H K = M p_2 a/l$, on $B$ with $S H = M p_2 b/l$: like two"
                " masses"
                " by the centre of mass, $M a/l$ in $A$ and $M b/l$ in $B$"
            ),
            (
                Arrow("A", "in A", "$M p_2 a/l$", RESULT),
                Arrow("B", "in B", "$M p_2 b/l$", RESULT),
                Line("H", "K"),
                Line("S", "H"),
            ),
        ),
    ),
    lengths=(
        CENTRE_LENGTH,
        Length("SK", ("S", "K"), "$M p_2$", f"$M ({P_2[1:-1]})$", slidewise("S", "K"), whole(COMMON), FORCE),
        Length("HK", ("H", "K"), "", "$M p_2 a/l$", slidewise("H", "K"), pressed(COMMON, "A"), FORCE),
        Length("SH", ("S", "H"), "", "$M p_2 b/l$", slidewise("S", "H"), pressed(COMMON, "B"), FORCE),
    ),
    scales={**SCALES, FORCE: SIZE},
    notes=(SCALE_OF_FORCES,),
    **BY,
)

FIG_5 = with_rocker(
    _FIG_5,
    *(
        one._replace(formula="$M p_2$" if one.letters == "SK" else one.formula, drawn=size(*one.ends))
        for one in _FIG_5.lengths
        if one.unit == FORCE
    ),
)
