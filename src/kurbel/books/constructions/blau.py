"""Blau's Fig. 9: the piston paths of both strokes by arcs of the rod's length about the crosshead."""

from __future__ import annotations

from typing import Any

from kurbel.books.constructions.geometry import Point
from kurbel.books.constructions.model import (
    CENTRE,
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
from kurbel.kernel import kinematics
from kurbel.page.quantity import words


def _points(at: Placed) -> Points:
    one, rod, (x, y) = at.number(1), at.rod, at.pin
    zero = 0 * one
    # The return stroke's pin is opposite: the same angle from the other dead centre.
    back = Point(-x, -y)
    head, returned = at.crosshead_of(at.pin), at.crosshead_of(back)
    return {
        "O": at.shaft,
        "a": Point(one, zero),
        "b": Point(-one, zero),
        "A": Point(one + rod, zero),
        "B": Point(rod - one, zero),
        "c": at.pin,
        "C": head,
        "f": Point(x, zero),
        "d": Point(head.x - rod, zero),
        "c'": back,
        "C'": returned,
        "f'": Point(-x, zero),
        "d'": Point(returned.x - rod, zero),
    }


def _slant(at: Placed) -> Any:
    """Return fd = L (1 - cos ψ) in units of R."""
    return kinematics.piston_path(at.circle, at.ratio) - at.circle.versine


FIG_9 = Construction(
    name="blau-9",
    title=words("Kolbenwege nach Blau, Fig. 9|Piston paths, after Blau, Fig. 9"),
    source=words("Blau 1905, § 6, Fig. 9, Gl. (20)–(22)|Blau 1905, § 6, Fig. 9, eq. (20)–(22)"),
    points=_points,
    mirrored=True,
    refusal="that the strokes differ by twice the same length fd holds for the straight crank alone;"
    " roetscher-1047-line is for an offset one",
    steps=(
        Step(
            words(
                "Kurbelkreis um $O$, auf der Schubrichtung $a A = L$: die Totlage"
                "|Crank circle about $O$, and $a A = L$ on the slide direction: the dead centre"
            ),
            (Circle("O", "a", CENTRE), Line("A", "b", CENTRE, 4)),
            ("O", "a", "b", "A"),
        ),
        Step(
            words(
                "Kurbel $O c$ um den Winkel $α$ aus der Totlage gedreht, Schubstange $c C = L$"
                "|Crank $O c$ turned by $α$ out of the dead centre, rod $c C = L$"
            ),
            (Line("O", "c", LINK), Line("c", "C", LINK), Angle("O", "a", "c", "$α$", 1)),
            ("c", "C"),
        ),
        Step(
            words(
                "Bogen $c d$ um $C$ mit dem Halbmesser $L$: $a d = x$"
                "|Arc $c d$ about $C$ of radius $L$: $a d = x$"
            ),
            (Arc("C", "c", "d"), Measure("ad", -1)),
            ("d",),
        ),
        Step(
            words(
                "Lot von $c$: $a f$ ist der Weg bei unendlich langer Stange, $f d$ kommt von der endlichen"
                "|Perpendicular from $c$: $a f$ is the path with an infinite rod, $f d$ the rest"
            ),
            (Line("c", "f"), RightAngle("f", "c", "O"), Measure("af", -2), Measure("fd", -2)),
            ("f",),
        ),
        Step(
            words(
                "Rückgang: Kurbel $O c'$ um $α$ aus der anderen Totlage, Stange $c' C' = L$, Bogen $c' d'$ um"
                " $C'$: $b d'$ ist der Kolbenweg, $b f' = a f$, $f' d' = f d$"
                "|Return: crank $O c'$ turned by $α$ out of the other dead centre, rod $c' C' = L$, arc"
                " $c' d'$ about $C'$: $b d'$ is the path, $b f' = a f$, $f' d' = f d$"
            ),
            (
                Line("O", "c'", LINK),
                Line("c'", "C'", LINK),
                Angle("O", "b", "c'", "$α$", 1),
                Arc("C'", "c'", "d'"),
                Line("c'", "f'"),
                Measure("bd'", 1),
                Measure("bf'", 2),
                Measure("f'd'", 2),
            ),
            ("c'", "C'", "d'", "f'"),
        ),
    ),
    lengths=(
        Length(
            "ad", ("a", "d"), "$x$", "$R(1 - cos α) + f d$", along("a", "d"),
            lambda at: kinematics.piston_path(at.circle, at.ratio),
        ),
        Length("af", ("a", "f"), "", "$R(1 - cos α)$", along("a", "f"), lambda at: at.circle.versine),
        Length("fd", ("f", "d"), "", "$L - sqrt(L^2 - R^2 sin^2 α)$", along("f", "d"), _slant),
        Length(
            "bd'", ("d'", "b"), "$x$", "$R(1 - cos α) - f' d'$", along("d'", "b"),
            lambda at: kinematics.piston_path(at.circle, -at.ratio),
        ),
        Length("bf'", ("f'", "b"), "", "$R(1 - cos α)$", along("f'", "b"), lambda at: at.circle.versine),
        Length("f'd'", ("f'", "d'"), "", "$f d$", along("f'", "d'"), _slant),
    ),
)  # fmt: skip
