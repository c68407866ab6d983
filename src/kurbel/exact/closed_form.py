"""Closed forms of cos φ where a condition on the straight crank leads to one: cos φ = (-5 ± √33)/4.

What a condition on path or acceleration makes of the first-order formulas is a quadratic equation, and the
exact path a linear one. Source: Blau, examples 33 to 35.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import gcd
from typing import NamedTuple

import flint
from flint import arb, fmpz_poly

from kurbel.exact.certify import NEVER_TIES, ball, rounded
from kurbel.exact.course import Target
from kurbel.exact.numerals import Number, number_text
from kurbel.exact.place import FIRST_BITS, Place
from kurbel.exact.precision import at_bits
from kurbel.exact.surd import Surd

DECIMALS = 4
# Longer forms say nothing.
LARGEST = 10**9


class ClosedForm(NamedTuple):
    """cos φ = (plain + outside √radicand)/below; of a rational one `outside` is 0."""

    plain: int
    outside: int
    radicand: int
    below: int

    @property
    def twin(self) -> ClosedForm:
        """The other root of the quadratic equation; a rational root is its own twin."""
        return self._replace(outside=-self.outside)

    def ball(self) -> arb:
        return (self.plain + self.outside * ball(self.radicand).sqrt()) / self.below

    @property
    def is_usable(self) -> bool:
        """Whether it is a cosine."""
        with at_bits(FIRST_BITS):
            return not bool(abs(self.ball()) > 1)


def closed_forms(formula: Surd, target: Target) -> list[ClosedForm]:
    """Return the closed forms among all roots cos φ of formula = target, in falling order.

    With a root in the formula, false ones of the other sign may be among them. An equation that sin φ enters
    otherwise than by its square has none.
    """
    if target.exact is None:
        return []
    polynomial = _of_cosine((formula - target.exact).norm())
    if polynomial is None:
        return []
    _, factors = polynomial.factor()
    found = [form for factor, _ in factors for form in _solved(factor)]
    with at_bits(FIRST_BITS):
        return sorted(set(found), key=lambda form: -float(form.ball().mid()))


def is_at(form: ClosedForm, place: Place) -> bool:
    """Whether the closed form is cos φ at a place that fulfils the condition."""
    with at_bits(FIRST_BITS):
        return bool(form.ball().overlaps((place.half_turns()).cos_pi()))


def form_text(form: ClosedForm) -> str:
    """Return a rational closed form as it is, -5/2, another to some decimals."""
    if not form.outside:
        return str(form.plain) if form.below == 1 else f"{form.plain}/{form.below}"
    # The root of no square is not rational.
    return number_text(Number(rounded(form.ball, DECIMALS, "half-away", NEVER_TIES), DECIMALS))


def _of_cosine(polynomial: fmpz_poly) -> fmpz_poly | None:
    """Return the polynomial in u = cos φ = -2t/(1 + t²) that is zero with one in t, or None.

    A function of cos φ alone is the same at t and 1/t, of which u = -2/y with y = t + 1/t.
    """
    single = flint.fmpz_poly([1])
    # At t = 0, 1 and -1, where cos φ is 0, -1 and 1, there is no pair t and 1/t.
    for end in (0, 1, -1):
        if polynomial(end) == 0:
            polynomial //= flint.fmpz_poly([-end, 1])
            single *= flint.fmpz_poly([end, 1])
    coefficients = [int(one) for one in polynomial.coeffs()]
    if len(coefficients) % 2 == 0 or coefficients != coefficients[::-1]:
        return None
    half = len(coefficients) // 2
    # t^k + t^-k as a polynomial in y, from those before it.
    y = flint.fmpz_poly([0, 1])
    before, power = flint.fmpz_poly([2]), y
    total = flint.fmpz_poly([coefficients[half]])
    for coefficient in coefficients[half + 1 :]:
        total += coefficient * power
        before, power = power, y * power - before
    in_cosine = [int(one) * (-2) ** index for index, one in enumerate(total.coeffs())]
    return flint.fmpz_poly(in_cosine[::-1]) * single


def _solved(factor: fmpz_poly) -> Iterator[ClosedForm]:
    """Yield the roots of a factor of degree 1 or 2, if they are real and short."""
    match [int(one) for one in factor.coeffs()]:
        case [constant, linear]:
            root = Fraction(-constant, linear)
            forms = [ClosedForm(root.numerator, 0, 1, root.denominator)]
        case [constant, linear, square]:
            forms = list(_quadratic(constant, linear, square))
        case _:
            return
    yield from (form for form in forms if max(abs(form.plain), form.radicand, form.below) < LARGEST)


def _quadratic(constant: int, linear: int, square: int) -> Iterator[ClosedForm]:
    discriminant = linear * linear - 4 * square * constant
    if discriminant < 0 or discriminant > LARGEST**2:
        return
    outside = next(one for one in range(1000, 0, -1) if discriminant % (one * one) == 0)
    shared = gcd(linear, 2 * square, outside) * (1 if square > 0 else -1)
    for sign in (1, -1):
        yield ClosedForm(
            -linear // shared, sign * outside // abs(shared), discriminant // outside**2, 2 * square // shared
        )
