"""The diagram of tangential pressures that has Radinger's name: around the crank circle and over it.

His book, Dampfmaschinen mit hoher Kolbengeschwindigkeit, was not at hand; re-derived. Under a constant force
the piece that the rod's line cuts off from O on the perpendicular to the slide is the tangential pressure and
it is carried to the developed circle, in Lineham's Text-book of Mechanical Engineering, too.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from kurbel.books.constructions.geometry import Point, meet, plus, to
from kurbel.books.constructions.model import (
    AID,
    CENTRE,
    GIVEN,
    LINK,
    RESULT,
    Arrow,
    Circle,
    Construction,
    Curve,
    Length,
    Line,
    Placed,
    Points,
    Step,
)
from kurbel.exact.kind import floats
from kurbel.kernel.steam import logarithm
from kurbel.kernel.turning import mean_force
from kurbel.page.quantity import words

SIZE = Fraction(3, 4)
# In R: where the developed circle begins, how far below the shaft it lies, and the force above the slide.
LEFT, LOW, CARD = Fraction(-2), Fraction(-33, 10), Fraction(1, 2)
# A rod that is shorter has the force as high as this.
SHORT, HIGH = Fraction(13, 5), Fraction(21, 10)
STEPS, TURN = 360, 360


def _base(at: Placed) -> Fraction:
    """Return how high the force on the stroke is drawn: of a short rod above the diagram, else beside it."""
    crank = at.drive.crank
    return HIGH if crank.ratio * SHORT > 1 else crank.offset + CARD


def _stroke(at: Placed) -> int:
    """Return 0 on the outstroke and 1 on the return."""
    moved = at.drive.moved(floats(), "exact")
    begin, end = (180 * (stroke + float(moved.dead_centre(stroke))) for stroke in (0, 1))
    return 0 if begin <= (float(at.angle) - begin) % TURN + begin < end else 1


def _circle(at: Placed, stroke: int) -> Any:
    return at.kind.circle(at.angle - 180 * stroke)


def _share(at: Placed) -> Any:
    """Return the share of the stroke that the piston has gone."""
    moved, stroke = at.drive.moved(at.kind, "exact"), _stroke(at)
    return moved.path(stroke, _circle(at, stroke)) / moved.length


def _force(at: Placed) -> Any:
    """Return P on the piston, over Q."""
    steam = at.beside.steam
    if steam is None:
        return at.number(1)
    acting = steam.numbers(at.kind.of, at.kind.exponent)
    return acting.force(_share(at))


def _tangential(at: Placed) -> Any:
    """Return T by the kernel, over Q."""
    stroke = _stroke(at)
    return _force(at) * at.drive.moved(at.kind, "exact").velocity(stroke, _circle(at, stroke))


def _mean(at: Placed) -> Any:
    """Return the constant tangential pressure that does as much work, by the kernel."""
    length = at.drive.moved(at.kind, "exact").length
    if at.beside.steam is None:
        return length / at.kind.pi
    return mean_force(at.beside.steam.strokes(at.kind, True), at.kind.pi, length)


def _laid_mean(at: Placed) -> Any:
    """Return the same by Weisbach's P, with the work of the stroke over that of the half circle."""
    length, steam = at.drive.moved(at.kind, "exact").length, at.beside.steam
    if steam is None:
        return length / at.kind.pi
    ratio = at.number(steam.expansion)
    back = 1 / ratio if steam.back is None else at.number(steam.back)
    return length / at.kind.pi * ((1 + logarithm(ratio)) / ratio - back)


def _points(at: Placed) -> Points:
    pin, head, shaft, one = at.pin, at.crosshead, at.shaft, at.number(1)
    zero, size, stroke = 0 * one, at.number(SIZE), _stroke(at)
    upright, force = Point(zero, one), _force(at)
    points = {"O": shaft, "A": pin, "B": head, "slide": Point(zero, at.offset)}
    points["K"] = meet(pin, to(pin, head), shaft, upright)
    points["D"] = plus(shaft, pin, size * force)
    points["E"] = meet(points["D"], to(pin, head), shaft, upright)
    points["up"] = Point(zero, one if stroke == 0 else -one)
    turning = points["E"].y * points["up"].y
    points["F"] = plus(pin, pin, turning)
    base = at.number(_base(at))
    points["I"], points["J"] = Point(head.x, base), Point(head.x, base + size * force)
    # What is developed is as long as an arc.
    left, low = at.number(LEFT), at.number(LOW)
    mean = size * _laid_mean(at)
    points["G"] = Point(left + at.number(at.angle) * at.kind.pi / 180, low)
    points["H"] = Point(points["G"].x, low + turning)
    end = left + 2 * at.kind.pi
    points |= {
        "begin": Point(left, low),
        "M": Point(end, low),
        "N": Point(end, low + mean),
        "mean": Point(left, low + mean),
    }
    return points


def _curves(at: Placed) -> Mapping[str, Sequence[Point]]:
    """Return the pressure around the circle and over it, and the force on the stroke in question."""
    angles = [Fraction(TURN * step, STEPS) for step in range(STEPS + 1)]
    places = [Placed(at.drive, angle % TURN, at.kind, beside=at.beside) for angle in angles]
    size, stroke = float(SIZE), _stroke(at)
    values = [size * _tangential(place) for place in places]
    around = [plus(place.pin, place.pin, value) for place, value in zip(places, values, strict=True)]
    over = [
        Point(float(LEFT) + math.radians(angle), float(LOW) + value)
        for angle, value in zip(angles, values, strict=True)
    ]
    base = float(_base(at))
    card = sorted(
        Point(place.crosshead.x, base + size * _force(place)) for place in places if _stroke(place) == stroke
    )
    return {
        "around": around,
        "over": over,
        "force": [Point(card[0].x, base), *card, Point(card[-1].x, base), Point(card[0].x, base)],
    }


def _read(start: str, end: str) -> Any:
    return lambda points: (points[end].y - points[start].y) / SIZE.numerator * SIZE.denominator


FORCE = "$Q$"
TANGENTIAL_FORMULA = "$P sin(φ + ψ)/(cos ψ)$"

TANGENTIAL = Construction(
    name="radinger",
    title=words("Tangentialdruckdiagramm nach Radinger|Diagram of tangential pressures, after Radinger"),
    source=words(
        "Radinger zugeschrieben; neu hergeleitet|Attributed to Radinger; re-derived"
    ),
    points=_points,
    curves=_curves,
    steps=(
        Step(
            words(
                "Kurbel $O A$, Schubstange $A B$; über dem Kolbenweg die Kolbenkraft des Hubes, an der"
                " Stelle von $B$"
                " ist sie $I J = P$"
                "|Crank $O A$, rod $A B$; over the piston path the force of the stroke, at the place of $B$"
                " it is"
                " $I J = P$"
            ),
            (
                Circle("O", "A", CENTRE),
                Line("O", "A", LINK),
                Line("A", "B", LINK),
                Line("slide", "B", CENTRE, 4.0),
                Curve("force", AID),
                Line("B", "I"),
                Line("I", "J", GIVEN, 0.0, "$P$"),
            ),
            ("O", "A", "B", "I", "J"),
        ),
        Step(
            words(
                "Auf der Kurbel von $O$ aus $O D = P$ abtragen|Lay $O D = P$ off on the crank, from $O$"
            ),
            (),
            ("D",),
        ),
        Step(
            words(
                "Die Parallele zur Schubstange durch $D$ schneidet die Senkrechte zur Schubrichtung durch"
                " $O$ in $E$:"
                " $O E = T$, denn die Schubstange selbst schneidet sie in $K$, und $T:P = O K:R$"
                "|The parallel to the rod through $D$ cuts the perpendicular to the slide through $O$ at"
                " $E$: $O E ="
                " T$, for the rod itself cuts it at $K$, and $T:P = O K:R$"
            ),
            (
                Line("O", "K", AID, 3.0),
                Line("A", "K"),
                Line("D", "E"),
                Line("O", "E", RESULT, 0.0, "$T$"),
            ),
            ("E", "K"),
        ),
        Step(
            words(
                "$A F = T$ auf der verlängerten Kurbel; ebenso in allen Stellungen: das Diagramm um den"
                " Kurbelkreis"
                "|$A F = T$ on the crank produced; likewise in all positions: the diagram around the crank"
                " circle"
            ),
            (Arrow("A", "F", "$T$"), Curve("around", GIVEN)),
            ("F",),
        ),
        Step(
            words(
                "Den Kurbelkreis abwickeln und $G H = T$ auftragen: das Diagramm über dem Weg der Kurbel"
                "|Develop the crank circle and lay off $G H = T$: the diagram over the way of the crank"
            ),
            (Line("begin", "M"), Curve("over", GIVEN), Line("G", "H", RESULT, 0.0, "$T$")),
            ("G", "H"),
        ),
        Step(
            words(
                "$M N = T_m$: das Rechteck über dem abgewickelten Kreis ist so groß wie die Fläche des"
                " Diagramms und"
                " wie die Arbeit der Kolbenkraft"
                "|$M N = T_m$: the rectangle over the developed circle is as large as the area of the"
                " diagram, and"
                " as the work of the piston force"
            ),
            (Line("mean", "N"), Line("begin", "mean"), Line("M", "N", RESULT, 0.0, "$T_m$")),
            ("M", "N"),
        ),
    ),
    lengths=(
        Length("IJ", ("I", "J"), "$P$", "", _read("I", "J"), _force, FORCE),
        Length(
            "OE", ("O", "E"), "$T$", TANGENTIAL_FORMULA,
            lambda points: _read("O", "E")(points) * points["up"].y, _tangential, FORCE,
        ),
        Length(
            "GH", ("G", "H"), "$T$", TANGENTIAL_FORMULA, _read("G", "H"), _tangential, FORCE,
        ),
        Length(
            "MN", ("M", "N"), "$T_m$", "", _read("M", "N"), _mean, FORCE
        ),
    ),
    holds=("straight", "offset"),
    refusal=(
        "the diagram of tangential pressures is constructed for a crosshead on a straight line; take a"
        " straight or"
        " an offset crank"
    ),
    takes=("eps", "back"),
    angle_symbol="$φ$",
    scales={FORCE: SIZE},
    notes=(
        words(
            "Maßstab: $Q$ ist $3/4 R$ lang gezeichnet|Scale: $Q$ is drawn $3/4 R$ long"
        ),
    ),
)  # fmt: skip
