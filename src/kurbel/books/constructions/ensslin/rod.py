"""What Ensslin's figures share: the rod with the accelerations of its points, built as he builds them.

A is the crank-pin end and B the crosshead end; p₁, that of A, reaches to the shaft O. He takes p₂, that of B,
for known; all others follow by parallels and perpendiculars.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from kurbel.books.constructions.beside import CENTRE as CENTRE_OF_MASS
from kurbel.books.constructions.beside import GYRATION
from kurbel.books.constructions.ensslin import rocker
from kurbel.books.constructions.geometry import Point, distance, dot, meet, plus, to, turned
from kurbel.books.constructions.model import AID, LINK, Arrow, Element, Line, Placed, Points, Scale
from kurbel.drive.rod import Rod
from kurbel.kernel.inertia.parts import Parted
from kurbel.kernel.inertia.parts import parted as parted_of
from kurbel.page.quantity import Words, words

SOURCE = "Ensslin, Dinglers Polytechnisches Journal 322 (1907), 593–595, Fig. {number}"
ACCELERATION, FORCE = "$v^2/R$", "$M v^2/R$"
# How long v²/R is drawn, in R: as long as R the ends of all accelerations would lie on the slide.
SIZE = Fraction(3, 2)
SCALES: Mapping[str, Fraction] = {ACCELERATION: SIZE}
HOLDS = ("straight", "offset")
REFUSAL = "Ensslin's figures are drawn of the straight, the offset and the arc crank; take one of these"
USUAL = Rod.from_crosshead(CENTRE_OF_MASS, GYRATION)
QUARTERS = tuple(Fraction(part, 4) for part in range(5))
# How far the slide is drawn before B, and the scale below it, in R.
HALF_TURN = Fraction(180)
ROOM, DEPTH = Fraction(3, 2), Fraction(3, 5)
SCALE = words("Maßstab: $v^2/R$ ist $3/2 R$ lang gezeichnet|Scale: $v^2/R$ is drawn $3/2 R$ long")
P_2 = "$cos φ - sin φ tan ψ + (λ cos^2 φ)/(cos^3 ψ)$"
P_4, P_5 = "$(sin φ - p_5 sin ψ)/(cos ψ)$", "$(λ cos^2 φ)/(cos^2 ψ)$"


def source(number: int) -> Words:
    said = SOURCE.format(number=number)
    return {"de": said, "en": said}


def rod_of(at: Placed) -> Rod:
    return at.beside.rod or USUAL


def parted(at: Placed) -> Parted:
    """Return what the kernel knows of the rod."""
    masses = rod_of(at).masses("exact", at.kind.of)
    if hasattr(at.drive, "rocker"):
        return rocker.parted(at, masses)
    return parted_of(at.circle, at.ratio, masses, at.offset if at.drive.offset else None)


def on_rod(points: Points, share: Any) -> Point:
    """Return the point of the rod at the distance x from B, from x/l."""
    return plus(points["B"], to(points["B"], points["A"]), share)


def rod_points(at: Placed) -> dict[str, Point]:
    """Return the rod with the vectors p₁ to p₅ as he has them.

    p₂ comes from the turned-round velocities: the line through O square to the way of B cuts off A K on the
    rod's, the velocity of A about B, and A K squared over l is p₅. The end of p₃ lies square to the rod from
    that of p₅, and as far along that way from O as p₂ is long; of a rocker the part of p₂ towards its pivot
    is taken off before.
    """
    pin, shaft, zero = at.pin, at.shaft, 0 * at.number(1)
    guided = hasattr(at.drive, "rocker")
    pivot = rocker.pivot_of(at) if guided else shaft
    head = rocker.end_of(at, pivot) if guided else at.crosshead
    across = to(pivot, head) if guided else Point(zero, at.number(1))
    rod = to(pin, head)
    middle = meet(pin, rod, shaft, across)
    cut = to(pin, middle)
    stretching = Point(*(part * dot(cut, cut) / dot(rod, rod) for part in rod))
    start = shaft
    if guided:
        start = plus(shaft, rocker.towards_pivot(head, pivot, distance(shaft, middle)), -1)
    end = meet(plus(pin, stretching), turned(rod), start, turned(across))
    replaced = to(pin, end)
    vectors = {
        "p_1": to(pin, shaft),
        "p_2": to(end, shaft),
        "p_3": replaced,
        "p_4": plus(replaced, stretching, -1),
        "p_5": stretching,
    }
    size, none = at.number(SIZE), Point(zero, zero)
    ends = {name: plus(none, vector, size) for name, vector in vectors.items()}
    guide = {"P": pivot} if guided else {"way": Point(zero, at.offset)}
    return {"O": shaft, "A": pin, "B": head, **guide, **ends}


def laid_off(points: dict[str, Point], vector: str, *at: str, share: Any = 1) -> dict[str, Point]:
    """Lay a vector, or a share of it, off from points: its end at A is "p_2 A"."""
    for one in at:
        points[f"{vector} {one}"] = plus(points[one], points[vector], share)
    return points


def in_scale(length: Any) -> Any:
    """Return in v²/R what a length in R stands for."""
    return length * SIZE.denominator / SIZE.numerator


def size(start: str, end: str) -> Callable[[Points], Any]:
    """Return what measures a vector's amount."""
    return lambda points: in_scale(distance(points[start], points[end]))


def square(start: str, end: str) -> Callable[[Points], Any]:
    """Return what measures a vector square to the rod, positive as p₄ of the outstroke is."""
    return lambda points: _over_rod(points, start, end, turned(to(points["B"], points["A"])))


def lengthwise(start: str, end: str) -> Callable[[Points], Any]:
    """Return what measures a vector along the rod, positive from A towards B."""
    return lambda points: _over_rod(points, start, end, to(points["A"], points["B"]))


def _over_rod(points: Points, start: str, end: str, way: Point) -> Any:
    return in_scale(dot(to(points[start], points[end]), way) / distance(points["A"], points["B"]))


ROD: Sequence[Element] = (Line("A", "B", LINK), rocker.SLIDE)
SCALE_BAR: Sequence[Element] = (Scale("scale", "scale end", ACCELERATION),)


def above(at: Placed) -> int:
    """Return 1 where the rod lies above the slide, -1 below."""
    return -1 if HALF_TURN < at.angle < 2 * HALF_TURN else 1


def with_scale(points: dict[str, Point], at: Placed) -> dict[str, Point]:
    """Add the slide about B, and beside it a line that has the scale."""
    head = points["B"]
    none = Fraction(0)
    # On the other side than the rod.
    depth = -DEPTH * above(at)
    for name, along, across in (
        ("slide", -ROOM, none),
        ("slide end", Fraction(1, 2), none),
        ("scale", -SIZE, depth),
        ("scale end", none, depth),
    ):
        points[name] = Point(head.x + at.number(along), head.y + at.number(across))
    return points


def arrows(vector: str, points: Sequence[str], symbol: str = "", look: str = AID) -> Sequence[Arrow]:
    """Return a vector as it is laid off from points."""
    return tuple(Arrow(one, f"{vector} {one}", symbol, look) for one in points)
