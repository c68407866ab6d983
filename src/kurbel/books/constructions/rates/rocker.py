"""The turned-round plan of velocities of the arc crank: the line through the shaft is parallel to the rocker.

As Schmolke's rod: the velocities of its ends have the same part along it, whatever guides them. Re-derived.
"""

from __future__ import annotations

from typing import Any

from kurbel.books.constructions.geometry import Point, circles, distance, dot, meet, plus, to, turned
from kurbel.books.constructions.model import (
    AID,
    CENTRE,
    GIVEN,
    LINK,
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
)
from kurbel.books.constructions.rates import plan
from kurbel.kernel import linkage
from kurbel.motion.evaluation import OUT
from kurbel.page.quantity import words


def rocker_points(at: Placed) -> Points:
    """Return the links, the turned plan and the velocities of both ends of the rod."""
    drive, shaft, pin = at.drive, at.shaft, at.pin
    along = 1 / drive.crank.ratio + drive.shift
    pivot = Point(at.number(along), at.number(drive.pivot_height))
    # Seen from the crank pin the rod's end is right of the pivot, for a negative curvature left of it.
    end = circles(pin, at.rod, pivot, at.number(drive.rocker), -1 if drive.curvature > 0 else 1)
    c = meet(pin, to(end, pin), shaft, to(pivot, end))
    return {
        "O": shaft,
        "P": pin,
        "Q": end,
        "A": pivot,
        "C": c,
        "V": plus(pin, turned(pin)),
        "W": plus(end, turned(c)),
        # The way of the outstroke: the pivot is on its right, for a negative curvature on its left.
        "T": plus(end, turned(to(pivot, end)), -1 if drive.curvature > 0 else 1),
        "across": Point(pivot.x, shaft.y),
    }


def on_path(points: Points, vector: Point) -> Any:
    """Return how long a vector is along the path of Q, positive the way of the outstroke, from Q to T."""
    return dot(vector, to(points["Q"], points["T"])) / distance(points["Q"], points["T"])


def _along_path(points: Points) -> Any:
    """Return O C, positive where turned back it points the way of the outstroke."""
    return on_path(points, turned(to(points["O"], points["C"])))


def _velocity(at: Placed) -> Any:
    found = at.drive.at(OUT, at.circle, at.kind)
    return linkage.velocity(found.place, found.arc)


def _swing(at: Placed) -> Any:
    found = at.drive.at(OUT, at.circle, at.kind)
    return abs(at.rod * linkage.rod_velocity(found.place, found.arc))


DRIVE = words(
    "Kurbelkreis um $O$, Kurbel $O P = R$, Schubstange $P Q = L$, Schwinge $A Q = B$; die Geschwindigkeit"
    " $v = ω R$ des Kurbelzapfens ist so lang wie $R$"
    "|Crank circle about $O$, crank $O P = R$, rod $P Q = L$, rocker $A Q = B$; the velocity $v = ω R$ of the"
    " crank pin is as long as $R$"
)
PLAN = words(
    "Parallele zur Schwinge durch $O$, senkrecht zur Bahn von $Q$: sie trifft die Schubstange oder ihre"
    " Verlängerung in $C$; $O C = c/ω$, und $P C$ ist die Geschwindigkeit von $Q$ um $P$, beide um 90°"
    " gedreht"
    "|Parallel to the rocker through $O$, square to the path of $Q$: it meets the rod, or the rod produced,"
    " at $C$; $O C = c/ω$, and $P C$ is the velocity of $Q$ about $P$, both turned by 90°"
)
ANGLES = words(
    "$δ$ zwischen Kurbel und Schubstange, $μ$ zwischen Schubstange und Schwinge, $η$ zwischen Kurbel und"
    " Schwinge; $c$ längs der Bahn von $Q$, im Hingang positiv"
    "|$δ$ between crank and rod, $μ$ between rod and rocker, $η$ between crank and rocker; $c$ along the path"
    " of $Q$, positive on the outstroke"
)
LENGTHS = (
    Length("OC", ("O", "C"), "$c/ω$", "$R (sin δ)/(sin μ)$", _along_path, _velocity),
    Length("PC", ("P", "C"), "$u/ω$", "$R (sin η)/(sin μ)$", plan.on_rod("P", "C", "P", "Q"), _swing),
)
OF_ROCKER = Construction(
    name="velocity",
    title=words(
        "Geschwindigkeit des Stangenendes aus dem gedrehten Geschwindigkeitsplan"
        "|Velocity of the rod's end, from the turned-round plan of velocities"
    ),
    source=plan.SCHMOLKE,
    points=rocker_points,
    angle_symbol="$φ$",
    holds=("arc",),
    steps=(
        Step(
            DRIVE,
            (
                Circle("O", "P", CENTRE),
                Line("across", "O", CENTRE, 6),
                Line("O", "P", LINK),
                Line("P", "Q", LINK),
                Line("A", "Q", LINK),
                Angle("O", "across", "P", "$φ$", 1),
                Arrow("P", "V", "$v$", GIVEN),
                RightAngle("P", "O", "V"),
            ),
            ("O", "P", "Q", "A"),
        ),
        Step(
            PLAN,
            (
                Line("P", "C", AID, 3),
                Line("O", "C", AID, 3),
                Measure("PC", look=GIVEN),
                Measure("OC"),
            ),
            ("C",),
        ),
        plan.BACK,
    ),
    lengths=LENGTHS,
    notes=(ANGLES,),
)
