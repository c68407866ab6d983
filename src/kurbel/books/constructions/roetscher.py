"""Rötscher's Abb. 1047: the piston path on the piston-path line, and beside the crank pin."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from kurbel.books.constructions.geometry import Point, foot, on_circle
from kurbel.books.constructions.model import (
    AID,
    CENTRE,
    GIVEN,
    HIDDEN,
    LINK,
    Angle,
    Arc,
    Circle,
    Construction,
    Length,
    Line,
    Measure,
    Placed,
    Points,
    RightAngle,
    Step,
    along,
)
from kurbel.books.constructions.rocker_path import OF_ROCKER
from kurbel.kernel import kinematics
from kurbel.kernel.circle import root
from kurbel.page.quantity import words

SOURCE = words(
    "Rötscher, Maschinenelemente, 14. Abschnitt, Abb. 1047, Gl. (285)"
    "|Rötscher, Maschinenelemente, section 14, Abb. 1047, eq. (285)"
)


def _path(way: int) -> Callable[[Placed], Any]:
    """Return what computes the path of the outstroke (1) or the return stroke (-1) from its dead centre."""

    def path(at: Placed) -> Any:
        if at.drive.offset:
            return kinematics.offset_path(at.circle, way * at.ratio, way * at.offset)
        return kinematics.piston_path(at.circle, way * at.ratio)

    return path


def _line_points(at: Placed) -> Points:
    far, near = at.rod + 1, at.rod - 1
    opposite = Point(-at.pin.x, -at.pin.y)
    inner = Point(root(far * far - at.offset * at.offset), at.offset)
    outer = Point(root(near * near - at.offset * at.offset), at.offset)
    return {
        "O": at.shaft,
        "C": at.pin,
        "D": opposite,
        "A": Point(inner.x / far, inner.y / far),
        "B": Point(-outer.x / near, -outer.y / near),
        "K_1": inner,
        "K_2": outer,
        "K": at.crosshead,
        "K'": at.crosshead_of(opposite),
        # Where angles count from, and where the slide line ends in the drawing.
        "w": Point(at.number(1), at.number(0)),
        "s": Point(outer.x - 1, at.offset),
        # Of an offset crank lines through the shaft; of a straight one they would be on the slide line.
        "p": inner if at.drive.offset else at.shaft,
        "q": outer if at.drive.offset else Point(-outer.x / near, -outer.y / near),
        "r": Point(at.number(1), at.number(0)) if at.drive.offset else at.shaft,
    }


ON_THE_LINE = Construction(
    name="roetscher-1047-line",
    title=words(
        "Kolbenwege auf der Kolbenweglinie nach Rötscher, Abb. 1047"
        "|Piston paths on the piston-path line, after Rötscher, Abb. 1047"
    ),
    source=SOURCE,
    points=_line_points,
    mirrored=True,
    angle_symbol="$φ$",
    holds=("straight", "offset", "arc"),
    refusal="the arc of the rod's length is cut with the path of a crosshead or of a rocker's end; a parallel"
    " crank has none, and that of a beam engine is reckoned along its beam",
    variants={"arc": OF_ROCKER},
    steps=(
        Step(
            words(
                "Kurbelkreis um $O$ und Kolbenweglinie"
                "|Crank circle about $O$, and the piston-path line"
            ),
            (Circle("O", "A", CENTRE), Line("K_1", "s", CENTRE, 4), Line("r", "O", CENTRE)),
            ("O",),
        ),
        Step(
            words(
                "Streck- und Decklage: Bögen um $O$ mit $L + R$ und $L - R$ schneiden die Kolbenweglinie in"
                " den Totlagen $K_1$ und $K_2$ des Kreuzkopfs; $A$ und $B$ sind die Totpunkte der Kurbel"
                "|Rod and crank in line: arcs about $O$ of $L + R$ and $L - R$ cut the piston-path line at"
                " the dead centres $K_1$ and $K_2$ of the crosshead; $A$ and $B$ are those of the crank"
            ),
            (
                Arc("O", "K_1", "K_1", beyond=4.0),
                Arc("O", "K_2", "K_2", beyond=4.0),
                Line("p", "O", HIDDEN),
                Line("q", "B", HIDDEN),
            ),
            ("A", "B", "K_1", "K_2"),
        ),
        Step(
            words(
                "Kurbel $O C$ unter dem Winkel $φ$ gegen die Schubrichtung"
                "|Crank $O C$ at the angle $φ$ to the direction of the slide"
            ),
            (Line("O", "C", LINK), Angle("O", "w", "C", "$φ$", 1)),
            ("C",),
        ),
        Step(
            words(
                "Bogen um $C$ mit der Stangenlänge $L$: er schneidet die Kolbenweglinie in $K$;"
                " $K_1 K = x$ ist der Kolbenweg im Hingang"
                "|Arc about $C$ of the rod's length $L$: it cuts the piston-path line at $K$;"
                " $K_1 K = x$ is the piston path of the outstroke"
            ),
            (Line("C", "K"), Arc("C", "K", "K", beyond=6.0), Measure("K_1K", -1)),
            ("K",),
        ),
        Step(
            words(
                "Gegenüber von $C$ liegt $D$, derselbe Winkel im Rückgang; ebenso $K'$ durch den Bogen um"
                " $D$: $K_2 K' = x$ ist der Kolbenweg aus der äußeren Totlage"
                "|Opposite to $C$ lies $D$, the same angle on the return stroke; likewise $K'$ by the arc"
                " about $D$: $K_2 K' = x$ is the piston path from the outer dead centre"
            ),
            (Line("O", "D", LINK), Line("D", "K'"), Arc("D", "K'", "K'", beyond=6.0), Measure("K_2K'", 1)),
            ("D", "K'"),
        ),
    ),
    lengths=(
        Length(
            "K_1K", ("K_1", "K"), "$x$", "$R(1 - cos φ) + L(1 - cos ψ)$", along("K_1", "K"), _path(1),
            offset_formula="$sqrt((L + R)^2 - e^2) - R cos φ - L cos ψ$",
        ),
        Length(
            "K_2K'", ("K'", "K_2"), "$x$", "$R(1 - cos φ) - L(1 - cos ψ)$", along("K'", "K_2"), _path(-1),
            offset_formula="$L cos ψ - R cos φ - sqrt((L - R)^2 - e^2)$",
        ),
    ),
)  # fmt: skip


def _circle_points(at: Placed) -> Points:
    one, zero, rod = at.number(1), at.number(0), at.rod
    opposite = Point(-at.pin.x, -at.pin.y)
    inner, outer = Point(rod + 1, zero), Point(rod - 1, zero)
    start, end, slide = Point(one, zero), Point(-one, zero), Point(-one, zero)

    def beside(pin: Point, centre: Point) -> Point:
        """Return where the parallel through a pin meets the circle of radius L about a crosshead, on the
        side of the shaft."""
        return on_circle(pin, slide, centre, rod)

    heads = at.crosshead, at.crosshead_of(opposite)
    return {
        "O": at.shaft,
        "A": start,
        "B": end,
        "K_1": inner,
        "K_2": outer,
        "C": at.pin,
        "D": opposite,
        "K": heads[0],
        "K'": heads[1],
        "E": beside(at.pin, inner),
        "E'": beside(opposite, outer),
        "F": foot(at.pin, start, end),
        "F'": foot(opposite, start, end),
        "G": Point(heads[0].x - rod, zero),
        "G'": Point(heads[1].x - rod, zero),
        # The ends of the circles of radius L as far as they are drawn.
        **{
            name: beside(Point(zero, high), centre)
            for centre, names in ((inner, "uv"), (outer, "st"))
            for name, high in zip(names, (one, -one), strict=True)
        },
    }


def _cut(at: Placed) -> Any:
    """Return GF = L (1 - cos ψ) in units of R."""
    return kinematics.piston_path(at.circle, at.ratio) - at.circle.versine


BESIDE_THE_PIN = Construction(
    name="roetscher-1047-circle",
    title=words(
        "Kolbenwege neben dem Kurbelzapfen nach Rötscher, Abb. 1047"
        "|Piston paths beside the crank pin, after Rötscher, Abb. 1047"
    ),
    source=SOURCE,
    points=_circle_points,
    mirrored=True,
    angle_symbol="$φ$",
    refusal="the circle of the rod's length touches the crank circle at its dead centre, from which all paths"
    " are measured; that holds for the straight crank alone. Take roetscher-1047-line for an offset one",
    steps=(
        Step(
            words(
                "Kurbelkreis um $O$ mit den Totpunkten $A$ und $B$ auf der Kolbenweglinie"
                "|Crank circle about $O$ with the dead centres $A$ and $B$ on the piston-path line"
            ),
            (Circle("O", "A", CENTRE), Line("K_1", "B", CENTRE, 4)),
            ("O", "A", "B"),
        ),
        Step(
            words(
                "Kreis vom Halbmesser $L$ um die Totlage $K_1$ des Kreuzkopfs: er berührt den Kurbelkreis in"
                " $A$"
                "|Circle of radius $L$ about the dead centre $K_1$ of the crosshead: it touches the crank"
                " circle at $A$"
            ),
            (Arc("K_1", "u", "v", GIVEN),),
            ("K_1",),
        ),
        Step(
            words(
                "Kurbel $O C$ um $φ$ aus der inneren Totlage gedreht; parallel zur Kolbenweglinie ist"
                " $C E = x$ der Kolbenweg im Hingang"
                "|Crank $O C$ turned by $φ$ out of the inner dead centre; parallel to the piston-path line"
                " $C E = x$ is the piston path of the outstroke"
            ),
            (Line("O", "C", LINK), Angle("O", "A", "C", "$φ$", 1), Measure("CE")),
            ("C", "E"),
        ),
        Step(
            words(
                "Lot $C F$, und Bogen um den Kreuzkopf $K$ mit $L$ durch $C$ bis $G$: $x = F A + G F$, und"
                " weil $C$ auf diesem Kreis liegt, $C F^2 = G F (2 L - G F)$"
                "|Perpendicular $C F$, and arc about the crosshead $K$ of $L$ through $C$ to $G$:"
                " $x = F A + G F$, and as $C$ lies on this circle, $C F^2 = G F (2 L - G F)$"
            ),
            (
                Line("C", "K"),
                Line("C", "F"),
                RightAngle("F", "C", "A"),
                Arc("K", "C", "G"),
                Measure("CF", look=AID),
                Measure("FA", -1),
                Measure("GF", -1),
            ),
            ("K", "F", "G"),
        ),
        Step(
            words(
                "Rückgang: $D$ liegt $C$ gegenüber; der Kreis vom Halbmesser $L$ um die andere Totlage $K_2$"
                " berührt den Kurbelkreis in $B$: $D E' = x$"
                "|Return stroke: $D$ lies opposite to $C$; the circle of radius $L$ about the other dead"
                " centre $K_2$ touches the crank circle at $B$: $D E' = x$"
            ),
            (Line("O", "D", LINK), Arc("K_2", "s", "t", GIVEN), Measure("DE'")),
            ("D", "K_2", "E'"),
        ),
        Step(
            words(
                "Ebenso $F'$ und, durch den Bogen um $K'$, $G'$: $x = F' B - G' F'$"
                "|Likewise $F'$ and, by the arc about $K'$, $G'$: $x = F' B - G' F'$"
            ),
            (
                Line("D", "K'"),
                Line("D", "F'"),
                RightAngle("F'", "D", "O"),
                Arc("K'", "D", "G'"),
                Measure("F'B", 1),
                Measure("G'F'", 1),
            ),
            ("K'", "F'", "G'"),
        ),
    ),
    lengths=(
        Length("CE", ("C", "E"), "$x$", "$F A + G F$", along("E", "C"), _path(1)),
        Length("FA", ("A", "F"), "", "$R(1 - cos φ)$", along("A", "F"), lambda at: at.circle.versine),
        Length("CF", ("C", "F"), "", "$R sin φ$", lambda points: points["C"].y, lambda at: at.circle.sine),
        Length("GF", ("F", "G"), "", "$L - sqrt(L^2 - C F^2)$", along("F", "G"), _cut),
        Length("DE'", ("D", "E'"), "$x$", "$F' B - G' F'$", along("D", "E'"), _path(-1)),
        Length("F'B", ("F'", "B"), "", "$R(1 - cos φ)$", along("F'", "B"), lambda at: at.circle.versine),
        Length("G'F'", ("F'", "G'"), "", "$G F$", along("F'", "G'"), _cut),
    ),
)  # fmt: skip
