"""What Ensslin's Figs. 5 to 7 share: the rod with its centre of mass, and the forces that it presses with."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from kurbel.books.constructions.ensslin.rod import (
    HOLDS,
    REFUSAL,
    ROD,
    in_scale,
    laid_off,
    on_rod,
    parted,
    rod_of,
    rod_points,
    with_scale,
)
from kurbel.books.constructions.geometry import Point
from kurbel.books.constructions.model import (
    LINK,
    Length,
    Line,
    Placed,
    Points,
    between,
)
from kurbel.kernel.inertia.parts import COMMON
from kurbel.page.quantity import words

QUARTERS = tuple(Fraction(part, 4) for part in (1, 2, 3))
INNER = tuple(f"rod {share}" for share in QUARTERS)
MASSES = ("centre", "gyration")
WIDE, WIDE_FORCE = "$v^2/L$", "$M v^2/L$"


def laden(at: Placed, *vectors: str) -> dict[str, Point]:
    """Return the rod with its centre of mass S, and vectors at its quarters that grow from B, but for p₂."""
    points = with_scale(rod_points(at), at)
    shares = dict(zip(INNER, QUARTERS, strict=True)) | {"A": Fraction(1), "B": Fraction(0)}
    for name, share in shares.items():
        points[name] = on_rod(points, at.number(share))
        for vector in vectors:
            laid_off(points, vector, name, share=at.number(1 if vector == "p_2" else share))
    points["S"] = on_rod(points, at.number(1 - rod_of(at).centre))
    return points


def nothing(at: Placed) -> Point:
    return Point(0 * at.number(1), 0 * at.number(1))


def slidewise(start: str, end: str) -> Callable[[Points], Any]:
    """Return what measures a force along the slide, positive towards the crosshead."""
    return lambda points: in_scale(points[end].x - points[start].x)


def pressed(part: str, of: str) -> Callable[[Placed], Any]:
    """Return what the rod presses on A or B for a part of the acceleration, by the kernel."""

    def pressed(at: Placed) -> Any:
        rod = parted(at)
        if part == COMMON:
            # Of a rocker p₂ has any direction.
            amount = rod.common.size() if hasattr(at.drive, "rocker") else rod.common.along
        else:
            amount = getattr(rod, part)
        return (rod.mass_in_pin(part) if of == "A" else rod.mass_in_crosshead(part)) * amount

    return pressed


def whole(part: str) -> Callable[[Placed], Any]:
    return lambda at: pressed(part, "A")(at) + pressed(part, "B")(at)


CENTRE_LENGTH = Length(
    "BS", ("B", "S"), "$a$", "", between("B", "S"), lambda at: at.number(1 - rod_of(at).centre) * at.rod
)
SCALE_OF_FORCES = words(
    "Maßstab: $v^2/R$ und $M v^2/R$ sind $3/2 R$ lang gezeichnet"
    "|Scale: $v^2/R$ and $M v^2/R$ are drawn $3/2 R$ long"
)
GIVEN_ROD = words(
    "Die Schubstange $A B = l$ mit ihrem Schwerpunkt $S$, $B S = a$, $A S = b$"
    "|The rod $A B = l$ with its centre of mass $S$, $B S = a$, $A S = b$"
)
BY: Mapping[str, Any] = {"holds": HOLDS, "refusal": REFUSAL, "angle_symbol": "$φ$", "takes": MASSES}
DRAWN_ROD = (*ROD, Line("B", "S", LINK, 0.0, "$a$"))
