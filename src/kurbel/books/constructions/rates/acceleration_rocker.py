"""The plan of accelerations of the arc crank: the rod's end is accelerated along its arc and to the pivot.

Letters of the drive as in the turned plan of velocities; the polygon is that of Khurmi and Gupta, with the
normal acceleration of the rocker first, as in the exercise of the TU Chemnitz. Formulas are re-derived.
"""

from __future__ import annotations

from typing import Any

from kurbel.books.constructions.geometry import Point, meet, plus, to, turned
from kurbel.books.constructions.model import (
    AID,
    CENTRE,
    GIVEN,
    LINK,
    RESULT,
    Angle,
    Arrow,
    Circle,
    Construction,
    Length,
    Line,
    Measure,
    Placed,
    Points,
    RightAngle,
    Step,
    between,
)
from kurbel.books.constructions.rates import plan, polygon, rocker
from kurbel.kernel import linkage
from kurbel.kernel.circle import root
from kurbel.linkage.linkage import At
from kurbel.motion.evaluation import OUT
from kurbel.page.quantity import words


def _drive(at: Placed) -> Points:
    points = {**rocker.rocker_points(at)}
    pin, end, pivot = points["P"], points["Q"], points["A"]
    swing = turned(to(pin, points["C"]))
    points.pop("V")
    return {
        **points,
        "D": plus(pin, swing),
        "E": polygon.altitude(pin, swing, end),
        "F": polygon.altitude(end, to(end, points["W"]), pivot),
    }


def _polygon(drive: Points, pole: Point) -> Points:
    rod, arm = to(drive["P"], drive["Q"]), to(drive["A"], drive["Q"])
    of_pin = plus(pole, to(drive["P"], drive["O"]))
    x = plus(of_pin, to(drive["P"], drive["E"]))
    y = plus(pole, to(drive["F"], drive["Q"]))
    return {"o'": pole, "p'": of_pin, "x": x, "y": y, "q'": meet(x, turned(rod), y, turned(arm))}


def _points(at: Placed) -> Points:
    return polygon.with_polygon(at, _drive, _polygon, -1 if at.drive.pivot_height >= 0 else 1)


def _found(at: Placed) -> At:
    found: At = at.drive.at(OUT, at.circle, at.kind)
    return found


def _along(at: Placed) -> Any:
    """Return p, along the arc, in units of v²/R."""
    found = _found(at)
    return linkage.acceleration(found.place, found.arc)


def _to_pivot(at: Placed) -> Any:
    """Return c²/B."""
    found = _found(at)
    c = linkage.velocity(found.place, found.arc)
    return abs(found.arc.curvature) * c * c


def _whole(at: Placed) -> Any:
    along, to_pivot = _along(at), _to_pivot(at)
    return root(along * along + to_pivot * to_pivot)


def _normal(at: Placed) -> Any:
    """Return u²/L."""
    found = _found(at)
    turn = linkage.rod_velocity(found.place, found.arc)
    return at.rod * turn * turn


def _tangential(at: Placed) -> Any:
    """Return how fast Q moves faster square to the rod, seen from P."""
    found = _found(at)
    return abs(at.rod * linkage.rod_acceleration(found.place, found.arc))


OF_ROCKER = Construction(
    name="acceleration",
    title=words(
        "Beschleunigung des Stangenendes aus dem Beschleunigungsplan"
        "|Acceleration of the rod's end, from the plan of accelerations"
    ),
    source=polygon.SOURCE,
    points=_points,
    angle_symbol="$φ$",
    holds=("arc",),
    steps=(
        Step(
            rocker.DRIVE,
            (
                Circle("O", "P", CENTRE),
                Line("across", "O", CENTRE, 6),
                Line("O", "P", LINK),
                Line("P", "Q", LINK),
                Line("A", "Q", LINK),
                Angle("O", "across", "P", "$φ$", 1),
            ),
            ("O", "P", "Q", "A"),
        ),
        Step(
            rocker.PLAN,
            (
                Line("P", "C", AID, 3),
                Line("O", "C", AID, 3),
                Measure("PC", look=GIVEN, written=False),
                Measure("OC", look=GIVEN, written=False),
            ),
            ("C",),
        ),
        polygon.ALTITUDE,
        Step(
            words(
                "$O C$ zurückgedreht und in $Q$ angetragen ist $Q W$; die Senkrechte zu $W A$ in $W$ trifft"
                " die verlängerte Schwinge in $F$: ebenso ist $Q F = c^2/(ω^2 B)$"
                "|$O C$, turned back and laid off from $Q$, is $Q W$; the perpendicular to $W A$ at $W$ meets"
                " the rocker produced at $F$: likewise $Q F = c^2/(ω^2 B)$"
            ),
            (
                Line("Q", "W", GIVEN),
                Line("W", "A"),
                Line("W", "F"),
                Line("Q", "F", GIVEN),
                RightAngle("W", "A", "F"),
            ),
            ("W", "F"),
        ),
        polygon.NORMAL,
        Step(
            words(
                "$o' y$ gleich $F Q$, zum Drehpunkt $A$ gerichtet: die Normalbeschleunigung von $Q$"
                "|$o' y$, equal to $F Q$ and towards the pivot $A$: the normal acceleration of $Q$"
            ),
            (Arrow("o'", "y", "", GIVEN),),
            ("y",),
        ),
        Step(
            words(
                "Durch $x$ die Senkrechte zur Schubstange, durch $y$ die zur Schwinge: sie treffen sich in"
                " $q'$"
                "|Perpendicular to the rod through $x$, to the rocker through $y$: they meet at $q'$"
            ),
            (
                Line("x", "q'", AID, 3),
                Line("y", "q'", AID, 3),
                RightAngle("x", "p'", "q'"),
                RightAngle("y", "o'", "q'"),
            ),
            ("q'",),
        ),
        Step(
            words(
                "$y q' = p/ω^2$ längs der Bahn von $Q$, $o' q'$ seine ganze Beschleunigung; $p' x$ und $x q'$"
                " sind die von $Q$ um $P$, nach der Stange und senkrecht zu ihr"
                "|$y q' = p/ω^2$ along the path of $Q$, $o' q'$ its whole acceleration; $p' x$ and $x q'$ are"
                " that of $Q$ about $P$, along the rod and square to it"
            ),
            (Arrow("x", "q'", "", GIVEN), Arrow("o'", "q'", "", RESULT), Arrow("y", "q'", "$p$")),
        ),
    ),
    lengths=(
        *rocker.LENGTHS,
        Length("p'x", ("p'", "x"), "", "$u^2/(ω^2 L)$", plan.on_rod("p'", "x", "P", "Q"), _normal),
        Length(
            "xq'", ("x", "q'"), "", "$(c^2/(ω^2 B) - R cos η - (u^2/(ω^2 L)) cos μ)/(sin μ)$",
            plan.square_to_rod("x", "q'", "P", "Q"), _tangential,
        ),
        Length("o'y", ("o'", "y"), "", "$c^2/(ω^2 B)$", plan.on_rod("o'", "y", "A", "Q"), _to_pivot),
        Length(
            "yq'", ("y", "q'"), "$p/ω^2$", "$(u^2/(ω^2 L) - R cos δ - (c^2/(ω^2 B)) cos μ)/(sin μ)$",
            lambda points: rocker.on_path(points, to(points["y"], points["q'"])), _along,
        ),
        Length("o'q'", ("o'", "q'"), "", "$sqrt(p^2 + c^4/B^2)/ω^2$", between("o'", "q'"), _whole),
    ),
    notes=(
        rocker.ANGLES,
        words(
            "$p$ zählt wie $c$; die anderen Strecken sind Beträge ihrer Formeln"
            "|$p$ counts as $c$ does; the other lengths are the amounts of their formulas"
        ),
    ),
)  # fmt: skip
