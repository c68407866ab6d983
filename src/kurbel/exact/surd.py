"""Kernel formulas as functions of t = tan ½(φ - φ₀): what algebra decides about their zeros.

Sine and cosine of the crank angle are rational in t, and cos ψ is the one square root that a formula takes.
A kernel formula that is run on `Surd` numbers is therefore (a + b √P)/d with polynomials a, b, d and P in t.
All its zeros are among those of the norm, a polynomial with rational coefficients.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from math import isqrt

import flint
from flint import arb, fmpz_poly

from kurbel.kernel.circle import Circle


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
