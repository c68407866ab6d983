"""Ensslin's Fig. 6: the rod under the turning accelerations alone.

Its forces stand in the part of the article that is not transcribed; re-derived, with the centre of
percussion T found by k.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

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
    whole,
)
from kurbel.books.constructions.ensslin.rocker import with_rocker
from kurbel.books.constructions.ensslin.rod import (
    FORCE,
    SCALES,
    SIZE,
    above,
    arrows,
    laid_off,
    rod_of,
    source,
    square,
)
from kurbel.books.constructions.geometry import dot, meet, plus, to, turned
from kurbel.books.constructions.model import (
    AID,
    LINK,
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
    between,
)
from kurbel.errors import ProblemError
from kurbel.kernel.circle import root
from kurbel.kernel.inertia.parts import TURNING
from kurbel.page.quantity import words


def _turning(at: Placed) -> Points:
    """Return Fig. 6: the centre of percussion T by a right angle over k, and the force there, parted."""
    points, rod = laden(at, "p_4"), rod_of(at)
    if rod.centre == 1:
        raise ProblemError(
            "with its centre of mass in B a rod that turns about B has no inertia force, but a couple; give a"
            " --centre above 0"
        )
    way = to(points["B"], points["A"])
    size = at.ratio * root(at.number(rod.gyration_square)) * at.rod
    points["K"] = plus(points["S"], turned(way), -size * above(at))
    points["T"] = meet(points["K"], turned(to(points["B"], points["K"])), points["B"], way)
    reach = dot(to(points["B"], points["T"]), way) / dot(way, way)
    points["force"] = plus(nothing(at), points["p_4"], -at.number(1 - rod.centre))
    laid_off(points, "force", "A", "B", "T")
    points["G"] = points["force T"]
    points["H"] = plus(points["B"], to(points["B"], points["force A"]), reach)
    points["in A"] = plus(points["A"], to(points["T"], points["H"]))
    points["in B"] = plus(points["B"], to(points["H"], points["G"]))
    return points


def _against(start: str, end: str) -> Callable[[Points], Any]:
    """Return what measures a force square to the rod, against p₄."""
    return lambda points: 0 - square(start, end)(points)


def _percussion(at: Placed) -> Any:
    """k²/a in R."""
    rod = rod_of(at)
    return at.number(rod.gyration_square / (1 - rod.centre)) * at.rod


_FIG_6 = Construction(
    name="ensslin-6",
    title=words(
        "Kräfte der Schubstange unter den Drehbeschleunigungen, nach Ensslin, Fig. 6"
        "|Forces of the rod under the turning accelerations, after Ensslin, Fig. 6"
    ),
    source=source(6),
    points=_turning,
    steps=(
        Step(GIVEN_ROD, (*DRAWN_ROD, Scale("scale", "scale end", "$v^2/R$, $M v^2/R$")), ("A", "B", "S")),
        Step(
            words(
                "Drehbeschleunigungen $p_4' = p_4 x/l$ senkrecht zur Stange, nach Fig. 4"
                "|Turning accelerations $p_4' = p_4 x/l$ square to the rod, after Fig. 4"
            ),
            (*arrows("p_4", INNER), Arrow("A", "p_4 A", "$p_4$", AID), Line("p_4 A", "B")),
        ),
        Step(
            words(
                "Auf der Stange in $S$ das Lot $S K = k$, der Trägheitshalbmesser um $S$; das Lot in $K$ auf"
                " $B K$"
                " schneidet die Stange im Schwingungsmittelpunkt $T$: $S T = k^2/a$"
                "|Square to the rod in $S$ lay off $S K = k$, the radius of gyration about $S$; the"
                " perpendicular in $K$ on $B K$ cuts the rod in the centre of percussion $T$: $S T = k^2/a$"
            ),
            (
                Line("S", "K", AID, 0.0, "$k$"),
                Line("B", "K"),
                Line("K", "T"),
                RightAngle("K", "B", "T"),
                RightAngle("S", "B", "K"),
                Line("S", "T", LINK),
            ),
            ("K", "T"),
        ),
        Step(
            words(
                "Die Trägheitskraft $T G = M p_4 a/l$ geht durch $T$, der Beschleunigung entgegen"
                "|The inertia force $T G = M p_4 a/l$ goes through $T$, against the acceleration"
            ),
            (Arrow("T", "G", "$M p_4 a/l$"),),
            ("G",),
        ),
        Step(
            words(
                "Parallelogramm über $A B$ mit dieser Kraft; seine Diagonale aus $B$ schneidet $T G$ in $H$:"
                " die"
                " Stange drückt auf $A$ mit $T H$ und auf $B$ mit $H G$"
                "|Parallelogram on $A B$ with this force; its diagonal from $B$ cuts $T G$ in $H$: the rod"
                " presses"
                " on $A$ with $T H$ and on $B$ with $H G$"
            ),
            (
                Line("A", "force A"),
                Line("B", "force B"),
                Line("force A", "force B"),
                Line("B", "force A"),
                Arrow("A", "in A", "", RESULT),
                Arrow("B", "in B", "", RESULT),
                Line("T", "H"),
                Line("H", "G"),
            ),
            ("H",),
        ),
    ),
    lengths=(
        CENTRE_LENGTH,
        Length(
            "SK",
            ("S", "K"),
            "$k$",
            "",
            between("S", "K"),
            lambda at: root(at.number(rod_of(at).gyration_square)) * at.rod,
        ),
        Length("ST", ("S", "T"), "", "$k^2/a$", between("S", "T"), _percussion),
        Length("TG", ("T", "G"), "", "$M p_4 a/l$", _against("T", "G"), whole(TURNING), FORCE),
        Length(
            "TH", ("T", "H"), "", "$M p_4 (k^2 + a^2)/l^2$", _against("T", "H"), pressed(TURNING, "A"), FORCE
        ),
        Length(
            "HG", ("H", "G"), "", "$M p_4 (a b - k^2)/l^2$", _against("H", "G"), pressed(TURNING, "B"), FORCE
        ),
    ),
    scales={**SCALES, FORCE: SIZE},
    notes=(
        SCALE_OF_FORCES,
        words(
            "Die Kräfte dieser Figur stehen in der Fortsetzung, die nicht vorlag; neu hergeleitet"
            "|The forces of this figure stand in the continuation, which was not at hand; re-derived"
        ),
        words(
            "Zwei Massen nach dem Schwerpunktsgesetz drückten auf $A$ mit $M p_4 a/l$ und auf $B$ nicht; sie"
            " sind"
            " hier nur für $k^2 = a b$ genau"
            "|Two masses by the centre of mass would press on $A$ with $M p_4 a/l$ and not on $B$; here they"
            " are"
            " exact for $k^2 = a b$ alone"
        ),
    ),
    **BY,
)

FIG_6 = with_rocker(_FIG_6)
