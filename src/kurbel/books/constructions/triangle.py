"""The forces of the crank drive by their triangles: at the crosshead, and at the crank pin."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from kurbel.books.constructions.geometry import Point, cross, dot, foot, meet, plus, to, turned
from kurbel.books.constructions.model import (
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
    Position,
    RightAngle,
    Step,
)
from kurbel.kernel import forces
from kurbel.kernel.circle import root
from kurbel.page.quantity import words

# The piston force on paper, and how high above the shaft the plan of forces lies, in R.
SCALE, HIGH = 2, 1.5
UNIT = "$F$"


def _points(at: Placed) -> Points:
    zero = at.number(0)
    head, pin = at.crosshead, at.pin
    towards_shaft, crank, rod = Point(at.number(-SCALE), zero), to(at.shaft, pin), to(head, pin)
    start = Point(head.x, at.number(_high(at)))
    end = plus(start, towards_shaft)
    closed = meet(start, rod, end, turned(towards_shaft))
    return {
        "O": at.shaft,
        "A": pin,
        "B": head,
        "H": foot(at.shaft, head, pin),
        "P": start,
        "Q": end,
        "S": closed,
        "T": meet(start, turned(crank), closed, crank),
        "f": plus(head, towards_shaft),
        # Where angles count from, and where the slide line begins and ends.
        "w": Point(at.number(1), zero),
        "s": Point(at.rod + 1, at.offset),
        "t": Point(zero, at.offset),
        "r": Point(at.number(1), zero) if at.drive.offset else at.shaft,
    }


def _high(at: Placed) -> Fraction:
    """Return how high the plan of forces begins so that nothing of it reaches down to the drive."""
    turn, ratio = math.radians(at.angle), float(at.drive.ratio)
    slant = math.tan(math.asin(ratio * (math.sin(turn) - float(at.drive.offset))))
    tangential = math.sin(turn) + math.cos(turn) * slant
    lowest = min(0.0, slant, tangential * math.cos(turn))
    return Fraction(round(100 * (HIGH - SCALE * lowest)), 100)


def _force(kernel: Callable[..., Any]) -> Callable[[Placed], Any]:
    """Return what computes a force by the kernel, in units of the piston force."""
    return lambda at: kernel(at.circle, at.ratio, at.offset if at.drive.offset else None)


def _arm(at: Placed) -> Any:
    """Return sin(φ + ψ), of the rod's force about the shaft."""
    return _force(forces.tangential_force)(at) / _force(forces.rod_force)(at)


def _rod_way(points: Points) -> Point:
    """Return the direction of the rod, of length 1."""
    way = to(points["P"], points["S"])
    length = root(dot(way, way))
    return Point(way.x / length, way.y / length)


def _part(start: str, end: str, way: Callable[[Points], Point]) -> Callable[[Points], Any]:
    """Return what measures a force of the plan in a direction, in units of the piston force."""
    return lambda points: dot(to(points[start], points[end]), way(points)) / SCALE


def _square_to_slide(points: Points) -> Point:
    # The slide's own length in the plan is that of the piston force.
    way = turned(to(points["Q"], points["P"]))
    return Point(way.x / SCALE, way.y / SCALE)


TRIANGLE = Construction(
    name="forces",
    title=words("Kräfte am Kurbeltrieb|Forces of the crank drive"),
    source=words(
        "Übung „Kräfte am Kurbeltrieb“, Technische Mechanik I, Gl. (1)–(11)"
        "|Exercise „Kräfte am Kurbeltrieb“, Technische Mechanik I, eq. (1)–(11)"
    ),
    points=_points,
    mirrored=True,
    angle_symbol="$φ$",
    holds=("straight", "offset"),
    refusal="the triangle of forces has one side square to a straight slide, for the force of its guide;"
    " an arc crank is held by its rocker, and a parallel crank and a beam engine have no crosshead",
    scales={UNIT: Fraction(SCALE)},
    position=Position(
        forces.square_position,
        words(
            "die Schubstange berührt den Kurbelkreis: $tan ψ = R/L$"
            "|the rod touches the crank circle: $tan ψ = R/L$"
        ),
    ),
    steps=(
        Step(
            words(
                "Kurbel $O A$, Schubstange $A B$; am Kreuzkopf $B$ wirkt die Kolbenkraft $F$"
                "|Crank $O A$, rod $A B$; the piston force $F$ acts on the crosshead $B$"
            ),
            (
                Circle("O", "A", CENTRE),
                Line("s", "t", CENTRE, 4),
                Line("r", "O", CENTRE),
                Line("O", "A", LINK),
                Line("A", "B", LINK),
                Angle("O", "w", "A", "$φ$", 1),
                Angle("B", "t", "A", "$ψ$"),
                Arrow("B", "f", "$F$"),
            ),
            ("O", "A", "B"),
        ),
        Step(
            words(
                "Kräftedreieck des Kreuzkopfs: $P Q = F$ in Schubrichtung"
                "|Triangle of forces of the crosshead: $P Q = F$ along the slide"
            ),
            (Arrow("P", "Q", "$F$"),),
            ("P", "Q"),
        ),
        Step(
            words(
                "Durch $Q$ senkrecht zur Schubrichtung, durch $P$ parallel zur Schubstange: $Q S = F_Q$ ist"
                " die Querkraft der Gleitbahn, $P S = F_S$ die Stangenkraft"
                "|Through $Q$ square to the slide, through $P$ parallel to the rod: $Q S = F_Q$ is the force"
                " of the guide, $P S = F_S$ that of the rod"
            ),
            (Arrow("Q", "S", "$F_Q$"), Arrow("P", "S", "$F_S$"), RightAngle("Q", "P", "S")),
            ("S",),
        ),
        Step(
            words(
                "Am Kurbelzapfen: durch $P$ senkrecht zur Kurbel, durch $S$ parallel zu ihr: $P T = F_T$ ist"
                " die Tangentialkraft, $T S = F_R$ die Radialkraft"
                "|At the crank pin: through $P$ square to the crank, through $S$ parallel to it: $P T = F_T$"
                " is the tangential force, $T S = F_R$ the radial one"
            ),
            (Arrow("P", "T", "$F_T$"), Arrow("T", "S", "$F_R$"), RightAngle("T", "P", "S")),
            ("T",),
        ),
        Step(
            words(
                "Lot von $O$ auf die Stange: der Hebelarm $O H$; das Drehmoment ist $M = F_S · O H = F_T R$"
                "|Perpendicular from $O$ to the rod: the arm $O H$; the torque is $M = F_S · O H = F_T R$"
            ),
            (Line("A", "H"), Measure("OH", look=GIVEN), RightAngle("H", "O", "B")),
            ("H",),
        ),
    ),
    lengths=(
        Length(
            "QS", ("Q", "S"), "$F_Q$", "$F tan ψ$", _part("Q", "S", _square_to_slide),
            _force(forces.guide_force), UNIT,
        ),
        Length(
            "PS", ("P", "S"), "$F_S$", "$F/(cos ψ)$", _part("P", "S", _rod_way), _force(forces.rod_force),
            UNIT,
        ),
        Length(
            "PT", ("P", "T"), "$F_T$", "$(F sin(φ + ψ))/(cos ψ)$",
            _part("P", "T", lambda points: turned(to(points["O"], points["A"]))),
            _force(forces.tangential_force), UNIT,
        ),
        Length(
            "TS", ("T", "S"), "$F_R$", "$(F cos(φ + ψ))/(cos ψ)$",
            _part("T", "S", lambda points: to(points["A"], points["O"])), _force(forces.radial_force), UNIT,
        ),
        Length(
            "OH", ("O", "H"), "", "$R sin(φ + ψ)$",
            lambda points: cross(to(points["O"], points["A"]), _rod_way(points)), _arm,
        ),
    ),
)  # fmt: skip
