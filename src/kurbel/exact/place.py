"""Crank angles of which more is known than digits: whether two are one, or a formula is zero there.

Kernel formulas as functions of t = tan ½(φ - φ₀): what algebra decides about their zeros.

Sine and cosine of the crank angle are rational in t, and cos ψ is the one square root that a formula takes.
A kernel formula that is run on `Surd` numbers is therefore (a + b √P)/d with polynomials a, b, d and P in t.
All its zeros are among those of the norm, a polynomial with rational coefficients.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import comb, isqrt
from typing import NamedTuple

import flint
from flint import arb, fmpz_poly

from kurbel.errors import UnsettledError
from kurbel.exact.certify import at_bits, ball, kept, pi
from kurbel.kernel.circle import Circle

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


class SecondRootError(Exception):
    """A formula takes a root that is not a rational multiple of its first one."""


@dataclass(slots=True)
class Field:
    """The functions that one square root generates; which one it is, the first root to be taken settles."""

    radicand: fmpz_poly = field(default_factory=lambda: flint.fmpz_poly([1]))

    def of(self, value: Fraction | int) -> Surd:
        """Return a constant."""
        exact = Fraction(value)
        return self.surd([exact.numerator], [exact.denominator])

    def surd(self, above: list[int], below: list[int]) -> Surd:
        """Return a rational function from its coefficients, the constant ones first."""
        return Surd(self, flint.fmpz_poly(above), flint.fmpz_poly([0]), flint.fmpz_poly(below))

    def circle(self, centre: Fraction) -> Circle[Surd]:
        """Return the circle of φ = φ₀ + 2 arctan t, with centre = tan ½φ₀."""
        whole = 1 + centre * centre
        of_centre = self.of(2 * centre / whole), self.of((1 - centre * centre) / whole)
        sine, cosine = self.surd([0, 2], [1, 0, 1]), self.surd([1, 0, -1], [1, 0, 1])
        turned = of_centre[1] * cosine - of_centre[0] * sine
        return Circle(of_centre[0] * cosine + of_centre[1] * sine, turned, 1 - turned)

    def root(self, above: fmpz_poly, below: fmpz_poly) -> Surd:
        """Return the positive root of a rational function that is positive throughout."""
        content, factors = (above * below).factor_squarefree()
        radicand, whole = flint.fmpz_poly([content]), flint.fmpz_poly([1])
        for factor, power in factors:
            whole *= factor ** (power // 2)
            radicand *= factor ** (power % 2)
        if self.radicand.degree() < 1 and radicand.degree() > 0:
            self.radicand = radicand
        rational = radicand.degree() < 1
        scale = _root_of_quotient(radicand, flint.fmpz_poly([1]) if rational else self.radicand)
        # Positive leading coefficients and no real zeros: both are positive throughout.
        share, below = whole * scale.numerator, below * scale.denominator
        nothing = flint.fmpz_poly([0])
        return Surd(self, share, nothing, below) if rational else Surd(self, nothing, share, below)


def _root_of_quotient(one: fmpz_poly, other: fmpz_poly) -> Fraction:
    """Return the root of a quotient of polynomials that is the square of a rational number."""
    quotient = Fraction(int(one.leading_coefficient()), int(other.leading_coefficient()))
    if one * quotient.denominator != other * quotient.numerator or quotient < 0:
        raise SecondRootError
    above, below = isqrt(quotient.numerator), isqrt(quotient.denominator)
    if Fraction(above * above, below * below) != quotient:
        raise SecondRootError
    return Fraction(above, below)


@dataclass(slots=True, init=False)
class Surd:
    """The function (plain + rooted √P)/below of t, in lowest terms."""

    field: Field
    plain: fmpz_poly
    rooted: fmpz_poly
    below: fmpz_poly

    def __init__(self, field: Field, plain: fmpz_poly, rooted: fmpz_poly, below: fmpz_poly) -> None:
        common = plain.gcd(rooted).gcd(below)
        if below.leading_coefficient() < 0:
            common = -common
        self.field = field
        self.plain, self.rooted, self.below = plain // common, rooted // common, below // common

    def __add__(self, other: Surd | Fraction | int) -> Surd:
        one = self._like(other)
        return Surd(
            self.field,
            self.plain * one.below + one.plain * self.below,
            self.rooted * one.below + one.rooted * self.below,
            self.below * one.below,
        )

    __radd__ = __add__

    def __neg__(self) -> Surd:
        return Surd(self.field, -self.plain, -self.rooted, self.below)

    def __sub__(self, other: Surd | Fraction | int) -> Surd:
        return self + -self._like(other)

    def __rsub__(self, other: Surd | Fraction | int) -> Surd:
        return self._like(other) + -self

    def __mul__(self, other: Surd | Fraction | int) -> Surd:
        one = self._like(other)
        return Surd(
            self.field,
            self.plain * one.plain + self.rooted * one.rooted * self.field.radicand,
            self.plain * one.rooted + self.rooted * one.plain,
            self.below * one.below,
        )

    __rmul__ = __mul__

    def __truediv__(self, other: Surd | Fraction | int) -> Surd:
        one = self._like(other)
        inverse = Surd(self.field, one.plain * one.below, -one.rooted * one.below, one._product())
        return self * inverse

    def __rtruediv__(self, other: Surd | Fraction | int) -> Surd:
        return self._like(other) / self

    def __pow__(self, exponent: float) -> Surd:
        if exponent != 0.5:
            assert exponent in (2, 3, 4), "kernel formulas have square roots and small powers only"
            return self * self ** (exponent - 1) if exponent > 2 else self * self
        if not self.is_rational:
            raise SecondRootError
        return self.field.root(self.plain, self.below)

    @property
    def is_zero(self) -> bool:
        return self.plain.is_zero() and self.rooted.is_zero()

    @property
    def is_rational(self) -> bool:
        return self.rooted.is_zero()

    def norm(self) -> fmpz_poly:
        """Return a polynomial without double zeros that is zero wherever the function is.

        It is zero where the function with the other sign of the root is, too.
        """
        product = self._product()
        return squarefree(product // product.gcd(self.below))

    def sheets(self, t: arb) -> tuple[arb, arb]:
        """Return plain ± rooted √P at t: if the norm is zero there, one of both is."""
        root = self.rooted(t) * self.field.radicand(t).sqrt()
        return self.plain(t) + root, self.plain(t) - root

    def common(self) -> fmpz_poly:
        """Return a polynomial that is zero where both sheets are."""
        return squarefree(self.plain.gcd(self.rooted))

    def _product(self) -> fmpz_poly:
        return self.plain * self.plain - self.rooted * self.rooted * self.field.radicand

    def _like(self, other: Surd | Fraction | int) -> Surd:
        return other if isinstance(other, Surd) else self.field.of(other)


def squarefree(polynomial: fmpz_poly) -> fmpz_poly:
    """Return the product of the factors of a polynomial, each once."""
    return polynomial // polynomial.gcd(polynomial.derivative()) if polynomial.degree() > 0 else polynomial
