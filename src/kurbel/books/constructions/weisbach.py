"""Weisbach's beam engine of § 149: the arc of the beam's end, and how the rod leans at the dead centres.

The transcription begins within the section: D, F, B₁ and B₃ are our letters, and how he draws it is taken
from what he sets equal: the chord C₀ C₁ to r, so that e is r²/2a without error, and the shaft below the
middle of e.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from kurbel.books.constructions.geometry import Point, circles, distance, meet, plus, to
from kurbel.books.constructions.model import (
    CENTRE,
    GIVEN,
    Angle,
    Arc,
    Circle,
    Construction,
    Length,
    Line,
    Placed,
    Points,
    Step,
    Text,
    between,
)
from kurbel.exact.certify import ball
from kurbel.kernel import beam
from kurbel.kernel.circle import root
from kurbel.linkage.beam.engine import LOWER, UPPER, BeamEngine, chord_square
from kurbel.page.quantity import words

# How many times the detail is enlarged, how far about O it reaches in e/2, and where it lies.
ENLARGED, REACH = 5, Fraction(8, 5)
BESIDE = Fraction(-2)


def _points(at: Placed) -> Points:
    engine, one = _engine(at), at.number(1)
    arm, rod, none = at.number(engine.arm), at.rod, 0 * one
    half = one / (4 * arm)
    centre, pivot = Point(none - half, rod), Point(arm - half, rod)
    upper = circles(centre, one, pivot, arm, 1)
    lower = circles(centre, one, pivot, arm, -1)
    points = {
        "A": at.shaft,
        "O": Point(none, rod),
        "D": pivot,
        "C_0": centre,
        "C_1": upper,
        "C_3": lower,
        "F": meet(upper, to(upper, lower), pivot, to(pivot, centre)),
        "pin": Point(one, none),
        "B_1": plus(at.shaft, to(at.shaft, upper), 1 / distance(at.shaft, upper)),
        "B_3": plus(at.shaft, to(at.shaft, lower), -1 / distance(at.shaft, lower)),
        "above": Point(none, rod + one),
        "below": Point(none, none - one),
    }
    return points | _detail(points, half, one * at.number(BESIDE), at)


def _detail(points: Points, half: Any, along: Any, at: Placed) -> dict[str, Point]:
    """Return what lies near O once more, enlarged, beside the arc."""
    middle = Point(along, points["O"].y)

    def enlarged(point: Point) -> Point:
        return plus(middle, to(points["O"], point), ENLARGED)

    size = ENLARGED * half
    edge = size * at.number(REACH)
    high = root(edge * edge - size * size)
    centre, radius = enlarged(points["D"]), ENLARGED * at.number(_engine(at).arm)
    near = Point(0 - half * at.number(REACH), points["O"].y)
    return {
        "C_0*": enlarged(points["C_0"]),
        "O*": middle,
        "F*": enlarged(points["F"]),
        "D*": centre,
        "near": near,
        "left": Point(middle.x - edge, middle.y),
        "right": Point(middle.x + edge, middle.y),
        "top": Point(middle.x, middle.y + edge),
        "bottom": Point(middle.x, middle.y - edge),
        "chord top": Point(middle.x + size, middle.y + high),
        "chord bottom": Point(middle.x + size, middle.y - high),
        "arc top": circles(middle, edge, centre, radius, 1),
        "arc bottom": circles(middle, edge, centre, radius, -1),
    }


def _engine(at: Placed) -> BeamEngine:
    drive: Any = at.drive
    return BeamEngine(drive.arm, drive.crank.ratio)


def _true(value: Callable[[BeamEngine, Any], Any]) -> Callable[[Placed], Any]:
    """Return what the linkage has in truth, from q²/r²."""

    def found(at: Placed) -> Any:
        engine = _engine(at)
        return at.kind.enclosed(lambda: value(engine, chord_square(engine)))

    return found


def _lean(side: int) -> Callable[[Placed], Any]:
    """Return μ (UPPER) or ν (LOWER) in radians."""
    return _true(lambda engine, square: beam.lean_sine(square, *engine.numbers(side)).asin())


def _between_leans(at: Placed) -> Any:
    return _lean(LOWER)(at) - _lean(UPPER)(at)


def _drawn_lean(side: int) -> Callable[[Points], Any]:
    """Return what measures C₀ O over l ± r, which he takes for the arc."""
    return lambda points: distance(points["C_0"], points["O"]) / (points["O"].y + side)


WHY_E = words(
    "der Balancier schwingt in Wahrheit etwas weiter als um $r$ nach oben und unten"
    "|the beam in truth swings somewhat farther than by $r$ up and down"
)
WHY_ROD = words(
    "$A$ liegt um $l$ unter $O$, $C_0 C_1$ und $C_0 C_3$ sind $r$; beide Totlagen zugleich gehen so nicht auf"
    "|$A$ lies $l$ below $O$, $C_0 C_1$ and $C_0 C_3$ are $r$; both dead centres do not close so"
)
WHY_LEAN = words(
    "$e = r^2/(2 a)$, der Bogen für den Sinus und $l ± r$ für die Seite"
    "|$e = r^2/(2 a)$, the arc for the sine and $l ± r$ for the side"
)

BEAM = Construction(
    name="weisbach-149",
    title=words(
        "Totlagen der Balanciermaschine nach Weisbach, § 149|Dead centres of the beam engine, after"
        " Weisbach, § 149"
    ),
    source=words(
        "Weisbach-Herrmann, Lehrbuch der Ingenieur- und Maschinen-Mechanik III, § 149"
        "|Weisbach-Herrmann, Lehrbuch der Ingenieur- und Maschinen-Mechanik III, § 149"
    ),
    points=_points,
    steps=(
        Step(
            words(
                "Drehpunkt $D$ des Balanciers, sein Arm $D C_0 = a$ in der Mittellage waagrecht; Bogen um $D$"
                "|Pivot $D$ of the beam, its arm $D C_0 = a$ horizontal in the middle; arc about $D$"
            ),
            (Line("D", "C_0", GIVEN), Arc("D", "C_1", "C_3", GIVEN, 4.0)),
            ("D", "C_0"),
        ),
        Step(
            words(
                "$C_0 C_1 = C_0 C_3 = r$ auf dem Bogen; die Sehne $C_1 C_3$ schneidet den Arm in $F$:"
                " Pfeilhöhe $F C_0"
                " = e = r^2/(2 a)$"
                "|$C_0 C_1 = C_0 C_3 = r$ on the arc; the chord $C_1 C_3$ cuts the arm at $F$: sagitta $F"
                " C_0 = e"
                " = r^2/(2 a)$"
            ),
            (Line("C_1", "C_3"), Line("D", "C_1"), Line("D", "C_3"), Line("F", "C_0")),
            ("C_1", "C_3"),
        ),
        Step(
            words(
                "$O$ halbiert $F C_0$; auf der Senkrechten durch $O$ die Welle $A$, $O A = l$, und der"
                " Kurbelkreis"
                "|$O$ halves $F C_0$; on the vertical through $O$ the shaft $A$, $O A = l$, and the crank"
                " circle"
            ),
            (Line("above", "below", CENTRE, 4.0), Circle("A", "pin", CENTRE)),
            ("O", "A"),
        ),
        Step(
            words(
                "Strecklage: $A C_1$ trifft den Kurbelkreis in $B_1$; Decklage: $C_3 A$, verlängert, in"
                " $B_3$. Die"
                " Stange weicht um $μ = C_1 A O$ und $ν = C_3 A O$ von der Senkrechten ab"
                "|Stretched: $A C_1$ meets the crank circle at $B_1$; folded: $C_3 A$, produced, at $B_3$."
                " The rod"
                " leans by $μ = C_1 A O$ and $ν = C_3 A O$"
            ),
            (
                Line("A", "C_1"),
                Line("A", "C_3"),
                Line("A", "B_3"),
                Angle("A", "C_1", "O", "$μ$", 0, 1.12),
                Angle("A", "C_3", "O", "$ν$", 0, 0.8),
            ),
            ("B_1", "B_3"),
        ),
        Step(
            words(
                "Einzelheit um $O$, fünffach vergrößert: $C_0 O = e/2$"
                "|Detail about $O$, enlarged five times: $C_0 O = e/2$"
            ),
            (
                Circle("O", "near"),
                Circle("O*", "left"),
                Line("left", "right", GIVEN),
                Line("top", "bottom", CENTRE),
                Line("chord top", "chord bottom"),
                Arc("D*", "arc top", "arc bottom", GIVEN, 0.0),
                Text("top", "$5:1$"),
            ),
            ("C_0*", "O*", "F*"),
        ),
    ),
    lengths=(
        Length(
            "FC_0", ("F", "C_0"), "$e$", "$r^2/(2 a)$", between("F", "C_0"),
            _true(lambda engine, square: beam.sagitta(square, ball(engine.arm))), "$r$", WHY_E,
        ),
        Length(
            "C_1A", ("A", "C_1"), "", "$l + r$", between("A", "C_1"), lambda at: at.rod + 1, "$r$", WHY_ROD
        ),
        Length(
            "C_3A", ("A", "C_3"), "", "$l - r$", between("A", "C_3"), lambda at: at.rod - 1, "$r$", WHY_ROD
        ),
        Length(
            "C_1AO", ("C_1", "O"), "$μ$", "$e/(2 (l + r)) = r^2/(4 a (l + r))$", _drawn_lean(1), _lean(UPPER),
            "°", WHY_LEAN, is_arc=True,
        ),
        Length(
            "C_3AO", ("C_3", "O"), "$ν$", "$e/(2 (l - r)) = r^2/(4 a (l - r))$", _drawn_lean(-1),
            _lean(LOWER), "°", WHY_LEAN, is_arc=True,
        ),
        Length(
            "B_1AB_3", ("B_1", "B_3"), "$ν - μ$", "$r^3/(2 a (l^2 - r^2))$",
            lambda points: _drawn_lean(-1)(points) - _drawn_lean(1)(points), _between_leans,
            "°", WHY_LEAN, is_arc=True,
        ),
    ),
    holds=("beam",),
    refusal=(
        "Weisbach's § 149 is of the beam engine; leave the mechanism out and give its arm, such as --beam 3"
    ),
    usual={"beam": "3"},
    angle="",
    ratio_symbol="r:l",
    notes=(
        words(
            "Der Winkel $B_1 A B_3$ auf der Seite von $D$ ist $180° + (ν - μ)$, der andere $180° - (ν - μ)$"
            "|The angle $B_1 A B_3$ on the side of $D$ is $180° + (ν - μ)$, the other one $180° - (ν - μ)$"
        ),
        words(
            "$r$ Kurbelhalbmesser, $l$ Stangenlänge, $a$ Arm des Balanciers"
            "|$r$ crank radius, $l$ length of the rod, $a$ arm of the beam"
        ),
    ),
    scales={"$r$": Fraction(1)},
)  # fmt: skip
