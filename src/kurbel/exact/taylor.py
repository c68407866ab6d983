"""Formulas continued from between two corners, and their power series about a place, with bounds.

A formula of the house may be of another shape on both sides of a corner, as the force of steam is at cut-off.
Between two corners only one of these shapes holds, and that one is continued, to balls that reach over a
corner, where a slope of both shapes would tell nothing, or to complex ones on which an integrand or a series
is bounded: a number carries what it is at a point between the same corners, and comparisons are of these.

A function that is analytic and at most B on the disk of radius r about the place has terms of at most B/r^k
(Cauchy), of which a geometric series bounds those that are not kept, and their slopes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from fractions import Fraction
from math import ceil, log2, perm
from typing import Any

import flint
from flint import acb, arb, arb_poly, arb_series

from kurbel.errors import ProblemError
from kurbel.exact.certify import at_bits, ball, pi
from kurbel.exact.kind import Kind, unordered
from kurbel.exact.search import Jet, interval
from kurbel.kernel.circle import Circle

# A comparison of floats nearer than this, or by so much of what they are, is left undecided.
NEAREST = 1e-13


class ComplexNumber:
    """A complex ball, a power series, a jet or, of a constant, a real ball, and the float that the same
    formula has at the point that stands for its piece."""

    __slots__ = ("at", "ball")

    def __init__(self, ball: Any, at: float) -> None:
        self.ball = ball
        self.at = at

    @classmethod
    def of(cls, number: ComplexNumber | arb | Fraction | float) -> ComplexNumber:
        """Return a number of another kind as a constant."""
        if isinstance(number, ComplexNumber):
            return number
        # Whole numbers first: of what is none, an abstract class such as Fraction is asked slowly.
        if not isinstance(number, int) and isinstance(number, Fraction):
            return cls(ball(number), float(number))
        return cls(arb(number), float(number))

    def __neg__(self) -> ComplexNumber:
        return ComplexNumber(-self.ball, -self.at)

    def __add__(self, other: ComplexNumber | arb | Fraction | float) -> ComplexNumber:
        other = ComplexNumber.of(other)
        return ComplexNumber(self.ball + other.ball, self.at + other.at)

    def __sub__(self, other: ComplexNumber | arb | Fraction | float) -> ComplexNumber:
        other = ComplexNumber.of(other)
        return ComplexNumber(self.ball - other.ball, self.at - other.at)

    def __mul__(self, other: ComplexNumber | arb | Fraction | float) -> ComplexNumber:
        other = ComplexNumber.of(other)
        return ComplexNumber(self.ball * other.ball, self.at * other.at)

    def __truediv__(self, other: ComplexNumber | arb | Fraction | float) -> ComplexNumber:
        other = ComplexNumber.of(other)
        return ComplexNumber(self.ball / other.ball, self.at / other.at)

    def __rsub__(self, other: ComplexNumber | arb | Fraction | float) -> ComplexNumber:
        return ComplexNumber.of(other) - self

    def __rtruediv__(self, other: ComplexNumber | arb | Fraction | float) -> ComplexNumber:
        return ComplexNumber.of(other) / self

    def __abs__(self) -> ComplexNumber:
        return self if self._above(0) >= 0 else -self

    __radd__ = __add__
    __rmul__ = __mul__

    def __pow__(self, exponent: Fraction | float) -> ComplexNumber:
        if isinstance(exponent, int):
            return ComplexNumber(self.ball**exponent, self.at**exponent)
        if exponent == 0.5:
            return ComplexNumber(self.ball.sqrt(**self._cuts), self.at**0.5)
        other = ComplexNumber.of(exponent)
        raised = self.ball.pow(other.ball, analytic=True) if self._cuts else self.ball**other.ball
        return ComplexNumber(raised, self.at**other.at)

    @property
    def _cuts(self) -> dict[str, bool]:
        """What makes a complex function no number on its cut."""
        return {"analytic": True} if isinstance(self.ball, acb) else {}

    def log(self) -> ComplexNumber:
        return ComplexNumber(self.ball.log(**self._cuts), math.log(self.at))

    def __eq__(self, other: Any) -> bool:
        return bool(self.ball == ComplexNumber.of(other).ball)

    def __lt__(self, other: ComplexNumber | arb | Fraction | float) -> bool:
        return self._above(other) < 0

    def __gt__(self, other: ComplexNumber | arb | Fraction | float) -> bool:
        return self._above(other) > 0

    def max(self, other: ComplexNumber | arb | Fraction | float) -> ComplexNumber:
        return self if self._above(other) >= 0 else ComplexNumber.of(other)

    def union(self, other: ComplexNumber | arb | Fraction | float) -> ComplexNumber:
        """Two shapes, of which a ball over a corner has both, do not meet here."""
        raise ProblemError("a corner lies where none was looked for; give slightly other numbers")

    def rad(self) -> Any:
        """The radius, by which formulas know a ball."""
        return self.ball.rad()

    def _above(self, other: ComplexNumber | arb | Fraction | float) -> float:
        other = ComplexNumber.of(other)
        if self == other:
            return 0.0
        apart = self.at - other.at
        if abs(apart) < NEAREST * max(1.0, abs(self.at)):
            raise ProblemError("two corners lie too near to each other; give slightly other numbers")
        return float(apart)


def continued() -> Kind:
    """Return these numbers as a kind, at the precision in force; exponents are balls of reals."""
    return unordered(
        ComplexNumber.of,
        lambda degrees: half_turn_circle(degrees / 180),
        _degrees,
        ComplexNumber.of(pi()),
        exponent=ball,
        enclosed=lambda value: ComplexNumber.of(value()),
    )


def _degrees(sine: ComplexNumber | arb | Fraction | float) -> ComplexNumber:
    """Return the angle within -90°..90° that has this sine; on the cuts beyond -1 and 1 it is no number."""
    place = ComplexNumber.of(sine)
    angle = place.ball.asin()
    if isinstance(place.ball, acb):
        cut = (1 - place.ball * place.ball).sqrt(analytic=True)
        angle = angle if cut.is_finite() else cut
    return ComplexNumber(angle * 180 / arb.pi(), math.degrees(math.asin(place.at)))


def half_turn_circle(half_turns: ComplexNumber | arb | Fraction | float) -> Circle[ComplexNumber]:
    """Return sine, cosine and versine of half turns, exact ones or continued."""
    place = ComplexNumber.of(half_turns)
    sine, cosine = place.ball.sin_cos_pi()
    half, angle = (place.ball / 2).sin_pi(), math.pi * place.at
    return Circle(
        ComplexNumber(sine, math.sin(angle)),
        ComplexNumber(cosine, math.cos(angle)),
        ComplexNumber(2 * half * half, 2 * math.sin(angle / 2) ** 2),
    )


Formula = Callable[[ComplexNumber], ComplexNumber]

# Bits of a bound, and beyond those of the precision in force to which a series is taken.
BOUND_BITS, GUARD_BITS = 64, 8
# So often a rectangle about a disk is halved until a function is bounded on it.
HALVINGS = 5
# On so much of the radius a power is bounded.
SHRUNK = Fraction(13, 16)


@dataclass(frozen=True, eq=False)
class Taylor:
    """A function about a place: its first terms, so many, and its bound on the disk of a radius."""

    middle: Fraction
    radius: Fraction
    terms: arb_poly
    length: int
    bound: arb

    def at(self, place: arb, order: int = 0) -> arb:
        """Return the function, or its slope of an order, at a place within the disk, a ball."""
        away, terms = place - ball(self.middle), self.terms
        for _ in range(order):
            terms = terms.derivative()
        value: arb = terms(away)
        return value + arb(0, self._left_out(away, order))

    def _left_out(self, away: arb, order: int) -> arb:
        with at_bits(BOUND_BITS):
            share = abs(away).upper() / ball(self.radius)
            if not share < 1:
                return arb("inf")
            # The terms' slopes grow with k, (m + j)!/(m + j - d)! at most as m!/(m - d)! (j + d)!/(j! d!).
            tail = share ** (self.length - order) / (1 - share) ** (order + 1)
            tail *= self.bound * perm(self.length, order) / ball(self.radius) ** order
            return tail.upper()

    def about(self, middle: Fraction) -> Taylor:
        """Return the same function about another place, on a disk half as wide, and its bound there."""
        away = middle - self.middle
        moved, left = self.terms(arb_poly([ball(away), 1])), self._left_out(ball(away), 0)
        # What its slope of an order k leaves out over k!, each from that before.
        step, terms = abs(ball(away)) * (1 - abs(ball(away / self.radius))), []
        for order in range(self.length):
            terms.append(moved[order] + arb(0, left.upper()))
            left = left * (self.length - order) / ((order + 1) * step)
        found = replace(self, middle=middle, radius=self.radius - abs(away), terms=arb_poly(terms))
        return replace(found, radius=self.radius / 2, bound=found._range(self.radius / 2)[1])

    def _range(self, radius: Fraction) -> tuple[arb, arb]:
        """Return what the function's magnitude is at least and at most on a smaller disk."""
        with at_bits(BOUND_BITS):
            reach, first = ball(radius), abs(self.terms[0])
            swing = arb_poly([0, *map(abs, self.terms.coeffs()[1:])])(reach) + self._left_out(reach, 0)
            return (first - swing).lower(), (first + swing).upper()

    def sum(self) -> Taylor:
        """Return the integral from the middle on."""
        bound = self.bound * ball(self.radius)
        return replace(self, terms=self.terms.integral(), length=self.length + 1, bound=bound)

    def __add__(self, other: Taylor | arb) -> Taylor:
        """Return the sum with a function about the same place, or with a number."""
        if not isinstance(other, Taylor):
            return replace(self, terms=self.terms + other, bound=(self.bound + abs(other)).upper())
        count, radius = min(self.length, other.length), min(self.radius, other.radius)
        terms = (self.terms + other.terms).truncate(count)
        return Taylor(self.middle, radius, terms, count, (self.bound + other.bound).upper())

    def __mul__(self, other: Taylor | arb) -> Taylor:
        if not isinstance(other, Taylor):
            return replace(self, terms=self.terms * other, bound=(self.bound * abs(other)).upper())
        count, radius = min(self.length, other.length), min(self.radius, other.radius)
        terms = (self.terms * other.terms).truncate(count)
        return Taylor(self.middle, radius, terms, count, (self.bound * other.bound).upper())

    def __truediv__(self, other: Taylor | arb) -> Taylor | Quotient:
        return Quotient(self, other) if isinstance(other, Taylor) else self * (1 / other)

    def power(self, exponent: Fraction) -> Taylor | None:
        """Return a power, None where the function is not proved to be above 0 on a smaller disk."""
        radius = self.radius * SHRUNK
        least, most = self._range(radius)
        if not (least > 0 and self.terms[0] > 0):
            return None
        bound = (least if exponent < 0 else most) ** ball(exponent)
        with terms_kept(self.length):
            terms = (arb_series(self.terms) ** ball(exponent)).coeffs()
        return Taylor(self.middle, radius, arb_poly(terms), self.length, bound.upper())

    def lagging(self, rate: arb, begun: arb | int = 0) -> Taylor:
        """Return y of which y' = -rate (f + y) of the function f, and that is so much in the middle."""
        terms = [arb(begun)]
        for order in range(self.length):
            terms.append(-rate * (self.terms[order] + terms[-1]) / (order + 1))
        reach = abs(rate) * ball(self.radius)
        bound = (reach * self.bound + abs(terms[0])) * reach.exp()
        return replace(self, terms=arb_poly(terms), length=self.length + 1, bound=bound.upper())


@dataclass(frozen=True, eq=False)
class Quotient:
    """A function over another one, both about the same place."""

    above: Taylor
    below: Taylor

    def at(self, place: arb, order: int = 0) -> arb:
        """Return the quotient, or its slope of an order up to 2, at a place within the disk, a ball."""
        above, below = (
            Jet(*(one.at(place, part) if part <= order else 0 for part in range(3)))
            for one in (self.above, self.below)
        )
        found = above / below
        return ball((found.value, found.slope, found.bend)[order])

    def about(self, middle: Fraction) -> Quotient:
        """Return the same about another place, on a disk half as wide."""
        return Quotient(self.above.about(middle), self.below.about(middle))

    def __truediv__(self, other: arb) -> Quotient:
        return Quotient(self.above, self.below * other)

    def power(self, exponent: Fraction) -> Taylor | None:
        """Return a power, None where both are not proved to be above 0 on a smaller disk."""
        above, below = self.above.power(exponent), self.below.power(-exponent)
        return above * below if above and below else None


def bounded(function: Formula, low: Fraction, high: Fraction, radii: int, most: float) -> arb | None:
    """Return a bound of a function on a disk of so many half widths about the middle of low..high.

    None where none is found that is below `most` times what the function is in the middle, or 1 if that is
    more.
    """
    middle, radius = (low + high) / 2, (high - low) / 2 * radii
    reference = float(middle)
    with at_bits(BOUND_BITS):
        most *= max(1.0, abs(function(ComplexNumber(ball(middle), reference)).at))
        # Of a real function the other half of the disk is a mirror image.
        return _bound(function, reference, (middle - radius, middle + radius), (Fraction(0), radius), most)


def expanded(function: Formula, low: Fraction, high: Fraction, radii: int, bound: arb) -> Taylor:
    """Return the series of a function about the middle of low..high, of which such a bound is known."""
    middle = (low + high) / 2
    # What a term gains after a power, and a little beyond both ends.
    gain = log2(radii * SHRUNK * Fraction(8, 9))
    count = ceil((flint.ctx.prec + GUARD_BITS + log2(float(bound) + 1)) / gain)
    with terms_kept(count):
        found = function(ComplexNumber(arb_series([ball(middle), 1]), float(middle))).ball
    terms = arb_poly(found.coeffs()) if isinstance(found, arb_series) else arb_poly([found])
    return Taylor(middle, (high - low) / 2 * radii, terms, count, bound)


def _bound(
    function: Formula,
    reference: float,
    along: tuple[Fraction, Fraction],
    across: tuple[Fraction, Fraction],
    most: float,
    halvings: int = HALVINGS,
) -> arb | None:
    """Return a bound of a function on a rectangle of the complex plane, None if that is not below `most`."""
    place = acb(interval(*along), interval(*across))
    found = abs(function(ComplexNumber(place, reference)).ball).upper()
    if found < most or not halvings:
        return found if found < most else None
    if along[1] - along[0] > across[1] - across[0]:
        halves = [(half, across) for half in _halves(*along)]
    else:
        halves = [(along, half) for half in _halves(*across)]
    greatest = arb(0)
    for half in halves:
        found = _bound(function, reference, *half, most, halvings - 1)
        if found is None:
            return None
        greatest = greatest.max(found)
    return greatest


def _halves(low: Fraction, high: Fraction) -> list[tuple[Fraction, Fraction]]:
    return [(low, (low + high) / 2), ((low + high) / 2, high)]


@contextmanager
def terms_kept(count: int) -> Iterator[None]:
    """Keep so many terms of series within."""
    before = flint.ctx.cap
    flint.ctx.cap = count
    try:
        yield
    finally:
        flint.ctx.cap = before
