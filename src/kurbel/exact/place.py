"""Crank angles of which more is known than digits: whether two are one, or a formula is zero there."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from math import comb
from typing import NamedTuple

import flint
from flint import arb, fmpz_poly

from kurbel.errors import UnsettledError
from kurbel.exact.certify import at_bits, ball, kept, pi
from kurbel.exact.surd import Surd, squarefree

PRECISIONS = tuple(128 << step for step in range(6))
FIRST_BITS, MOST_BITS = PRECISIONS[0], PRECISIONS[-1]
# cos 2πm/n is of degree φ(n)/2, at least 100 from n = 1000 on; no polynomial here is of such a degree.
MOST_ORDER = 1000


class Centre(NamedTuple):
    """The angle φ₀ from which t = tan ½(φ - φ₀) covers half a turn either way: tan ½φ₀, and whole turns."""

    tangent: Fraction
    turns: int = 0

    def half_turns(self) -> arb:
        """Return φ₀ as a ball."""
        if self == SQUARE:
            return ball(Fraction(1, 2))
        return 2 * (ball(self.tangent).atan() / pi() + self.turns)


SQUARE = Centre(Fraction(1))
"""90°, about which the strokes of a slide lie."""


@dataclass(frozen=True, eq=False)
class Place:
    """A crank angle: a ball of half turns at the precision in force, and what is known exactly.

    `polynomial`, without double zeros, has tan ½(φ - φ₀) among its zeros; `exact` is the place itself where
    it is a rational number of half turns.
    """

    half_turns: Callable[[], arb]
    centre: Centre = SQUARE
    polynomial: fmpz_poly | None = None
    exact: Fraction | None = None

    def __post_init__(self) -> None:
        # Of a page every value asks for it again, and a root takes some dozen evaluations.
        object.__setattr__(self, "half_turns", kept(self.half_turns))

    @property
    def degrees(self) -> Fraction | None:
        return None if self.exact is None else 180 * self.exact

    def t(self) -> arb:
        """Return tan ½(φ - φ₀)."""
        return ((self.half_turns() - self.centre.half_turns()) * pi() / 2).tan()

    def is_zero_of(self, polynomial: fmpz_poly) -> bool:
        """Whether a polynomial is zero here, decided by its common factors with the place's own."""
        assert self.polynomial is not None
        shared = self.polynomial.gcd(polynomial)
        rest = self.polynomial // shared
        return self._is_first(lambda t: (shared(t), rest(t)), "whether two crank angles are the same")

    def vanishes(self, surd: Surd) -> bool:
        """Whether a formula is zero here."""
        if surd.is_zero or not self.is_zero_of(surd.norm()):
            return surd.is_zero
        return self.is_zero_of(surd.common()) or self._is_first(surd.sheets, "which sign a root has")

    def _is_first(self, pair: Callable[[arb], tuple[arb, arb]], what: str) -> bool:
        """Whether the first of two numbers, of which one is zero here, is it."""
        for bits in PRECISIONS:
            with at_bits(bits):
                this, other = pair(self.t())
                if not this.contains(0):
                    return False
                if not other.contains(0):
                    return True
        raise unsettled(what)


def exact_place(half_turns: Fraction, centre: Centre, polynomial: fmpz_poly) -> Place:
    return Place(lambda: ball(half_turns), centre, polynomial, half_turns)


def recognised(place: Place, confirmed: Callable[[Fraction], bool] | None = None) -> Place:
    """Return the place as an exact one if it is a rational number of half turns of small denominator.

    `confirmed` tells it of places without a polynomial.
    """
    with at_bits(FIRST_BITS):
        found = place.half_turns()
        nearest = fraction(found.mid()).limit_denominator(MOST_ORDER)
        if not found.contains(ball(nearest)):
            return place
    if place.polynomial is None:
        is_there = confirmed is not None and confirmed(nearest)
    else:
        is_there = place.centre == SQUARE and place.is_zero_of(_tangents(nearest - Fraction(1, 2)))
    return replace(place, half_turns=lambda: ball(nearest), exact=nearest) if is_there else place


def _tangents(half_turns: Fraction) -> fmpz_poly:
    """Return the polynomial with the zeros tan(kπ/n), one of which belongs to m/n turns."""
    order = (half_turns / 2).denominator
    odd = [comb(order, power) * (-1) ** (power // 2) if power % 2 else 0 for power in range(order + 1)]
    return squarefree(flint.fmpz_poly(odd))


def is_after(place: Place, other: Place) -> bool:
    """Whether a place lies behind another; the same one does not."""
    for bits in PRECISIONS:
        with at_bits(bits):
            apart = place.half_turns() - other.half_turns()
            if not apart.contains(0):
                return bool(apart > 0)
        if bits == FIRST_BITS and _are_same(place, other):
            return False
    raise unsettled("whether two crank angles are the same")


def _are_same(place: Place, other: Place) -> bool:
    """Whether both are proved to be one place: zeros of one polynomial, nearer than two of them can be."""
    if place.polynomial is None or other.polynomial is None:
        return False
    shared = place.polynomial.gcd(other.polynomial)
    if not (shared.degree() > 0 and place.is_zero_of(shared) and other.is_zero_of(shared)):
        return False
    bits = _least_distance(shared)
    with at_bits(2 * bits + FIRST_BITS):
        return bool(abs(place.t() - other.t()) < ball(2) ** -bits)


def _least_distance(polynomial: fmpz_poly) -> int:
    """Return b such that two zeros of a polynomial without double ones are 2**-b apart at least.

    Mahler, An inequality for the discriminant of a polynomial, Michigan Mathematical Journal 11 (1964).
    """
    degree = polynomial.degree()
    norm = polynomial.height_bits() + (degree + 1).bit_length()
    return (degree + 2) * degree.bit_length() // 2 + (degree - 1) * norm + 1


def fraction(exact: arb) -> Fraction:
    """Return a ball without a radius as a rational number."""
    rational = exact.fmpq()
    return Fraction(int(rational.p), int(rational.q))


def unsettled(what: str) -> UnsettledError:
    """Return the error of a question that the greatest precision leaves open."""
    return UnsettledError(f"{what} is not settled by {MOST_BITS} bits; give slightly other numbers")
