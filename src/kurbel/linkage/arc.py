"""The arc crank, checked once, and as conditions see it; see kernel/linkage.py."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import isqrt, pi, tan
from typing import ClassVar

from kurbel.drive.at import At
from kurbel.drive.crank import LONGEST_ROD, Crank
from kurbel.errors import ProblemError
from kurbel.exact.certify import FLOAT_BITS, at_bits
from kurbel.exact.kind import Kind
from kurbel.exact.place import SQUARE, Centre
from kurbel.kernel.circle import Circle, Numeric
from kurbel.linkage.linkage import LinkageDrive
from kurbel.linkage.rocker import RockerCrank, direct
from kurbel.motion.evaluation import STROKES
from kurbel.page.quantity import Of, Quantity, Words, words
from kurbel.reading.notation import about, check_bounds

# Lengths in a message are multiples of 1/_STEPS R, rounded so that a length changed by as much will do.
_STEPS = 10**6


@dataclass(frozen=True, slots=True)
class ArcCrank(RockerCrank):
    """An arc crank: the rod of the crank drive moves a rocker of length B, in units of R as all lengths here.

    The pivot lies `distance` from the shaft along the slide direction, from which φ counts, and `height` to
    the side on which the crank pin is during the outstroke, negative to the other. Left out, the distance is
    L, so that the rocker stands square to the slide near mid-stroke, and the height e + B, so that the arc
    touches the slide line of the offset e: as the rocker grows this becomes the straight or offset crank.
    A pivot at height 0 lets φ count from the line of shaft and pivot. Of the two ways to assemble the links,
    circuit 1 has the rod's end on the side of the slide: seen from the crank pin to the right of the pivot,
    for a negative height to its left. Circuit -1 is the other one.

    Valid for R + max(L, B, G) < the sum of the other two of L, B and the distance G of shaft and pivot: the
    crank turns, the rocker swings, and the links never lie in line. λ = 0, the infinite rod, needs the
    default distance.
    """

    mechanism: ClassVar[str] = "arc"
    title: ClassVar[str] = "the arc crank"
    noun: ClassVar[Words] = words("Bogenschubkurbel|Arc crank")

    crank: Crank
    rocker: Fraction
    distance: Fraction | None = None
    height: Fraction | None = None
    circuit: Fraction | int = 1

    def __post_init__(self) -> None:
        if self.circuit not in (1, -1):
            raise ProblemError(
                f"circuit is {self.circuit}; it must be 1 or -1, the two ways to assemble the links"
            )
        if self.height is not None and self.crank.offset:
            raise ProblemError(
                f"offset e = {about(self.crank.offset)} R and a height of the pivot were both given;"
                " give one, for the height is e + B"
            )
        self._check_rocker()
        if self.crank.ratio:
            self._check_pivot()
        elif self.distance is not None:
            raise ProblemError(
                f"the pivot is {about(self.distance)} R from the shaft, but the rod is infinite;"
                " leave the distance out, or give the rod a length"
            )

    def figures(self, stroke: int, kind: Kind) -> tuple[Numeric, Numeric, Numeric, Numeric]:
        one, other, third, fourth = map(kind.of, self.numbers(stroke))
        return one, other, third, fourth

    def numbers(self, stroke: int) -> tuple[Fraction, Fraction, Fraction, Fraction]:
        """Return λ, β, η and σ with the sign of the stroke."""
        return (
            stroke * self.crank.ratio,
            stroke * self.curvature,
            stroke * self.offset,
            stroke * self.shift,
        )

    def at(self, stroke: int, circle: Circle[Numeric], numbers: Kind, method: str, of: object = None) -> At:
        if of is None or not numbers.bounded:
            # Without super(), which classes with slots lose.
            return RockerCrank.at(self, stroke, circle, numbers, method)
        place, arc = direct(self.numbers(stroke), circle, of is Of.STROKE, numbers)
        return At(circle, self, numbers, stroke, place=place, arc=arc)

    @property
    def shift(self) -> Fraction:
        """σ, the distance less the rod length L."""
        return Fraction(0) if self.distance is None else self.distance - 1 / self.crank.ratio

    @property
    def curvature(self) -> Fraction:
        """β = R/B, negative with the pivot on the left of the end's way from the inner dead centre."""
        side = -1 if self.pivot_height < 0 else 1
        return self.circuit * side / self.rocker

    @property
    def offset(self) -> Fraction:
        """η, where the arc comes nearest to the slide direction or, on circuit -1, farthest from it."""
        return self.pivot_height - 1 / self.curvature

    @property
    def pivot_height(self) -> Fraction:
        return self.crank.offset + self.rocker if self.height is None else self.height

    def _check_rocker(self) -> None:
        if self.rocker <= 1:
            raise ProblemError(
                f"rocker length B is {about(self.rocker)} R; it must be longer than the crank radius R,"
                " or the crank cannot turn while the rocker swings"
            )
        lengths = self.rocker, self.distance or Fraction(0), self.height or Fraction(0)
        if max(map(abs, lengths)) > LONGEST_ROD:
            raise ProblemError(
                f"the rocker or its pivot is beyond {LONGEST_ROD} R; take the straight crank for it"
            )

    def _check_pivot(self) -> None:
        rod = 1 / self.crank.ratio
        distance = rod if self.distance is None else self.distance
        check_bounds(
            "the pivot's distance", distance,
            "be above 0, counted along the slide direction from the shaft towards the rod's end", " R",
        )  # fmt: skip
        square = distance * distance + self.pivot_height * self.pivot_height
        _check_ground(square, rod, self.rocker)


def _check_ground(square: Fraction, rod: Fraction, rocker: Fraction) -> None:
    """Raise ProblemError unless the square of G lets the crank turn: R + |L - B| < G < L + B - R."""
    ground = isqrt(int(square * _STEPS * _STEPS))
    pivot = f"the pivot is G = {_length(ground)} R from the shaft"
    links = f"for L = {about(rod)} R and B = {about(rocker)} R"
    far, near = rod + rocker - 1, 1 + abs(rod - rocker)
    if square >= far * far:
        change = _length(ground + 1 - int(far * _STEPS))
        raise ProblemError(
            f"{pivot}, too far {links}; the crank turns with G below L + B - R = {about(far)} R or, the pivot"
            f" left in place, with a rod or rocker longer by {change} R"
        )
    if square <= 1:
        raise ProblemError(
            f"{pivot}; it must be farther than the crank radius R, and {links} farther than"
            f" R + |L - B| = {about(near)} R, or the rocker is carried round"
        )
    if square <= near * near:
        longer, shorter = ("rod", "rocker") if rod < rocker else ("rocker", "rod")
        change = _length(int(near * _STEPS) + 2 - ground)
        raise ProblemError(
            f"{pivot}, too near {links}; the crank turns with G above R + |L - B| = {about(near)} R or, the"
            f" pivot left in place, with the {longer} longer or the {shorter} shorter by {change} R"
        )


def _length(steps: int) -> str:
    return about(Fraction(steps, _STEPS))


# Half turns about the middle of the stroke within which t = tan ½(φ - 90°) stays far from infinity.
HALF_REACH = 0.45


class ArcDrive(LinkageDrive):
    """The arc crank."""

    def __init__(self, crank: RockerCrank, page: str = "arc") -> None:
        super().__init__(crank, page)
        self.centre = self._centre()

    def _centre(self) -> Centre:
        with at_bits(FLOAT_BITS):
            ends = [float(place().mid()) for stroke in STROKES for place in self.dead_angles(stroke)]
        if min(ends) > -HALF_REACH and max(ends) < 1 + HALF_REACH:
            return SQUARE
        middle = (min(ends) + max(ends)) / 2
        turns = round(middle / 2)
        return Centre(Fraction(tan(pi * (middle / 2 - turns))).limit_denominator(10), turns)

    def is_free(self, quantity: Quantity) -> bool:
        return quantity.of is not Of.STROKE and super().is_free(quantity)
