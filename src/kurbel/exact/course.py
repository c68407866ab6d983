"""The course of a quantity over a stroke: where it is greatest, where it has a value, and closed forms of it.

Between two neighbouring places of zero slope a quantity rises or falls, and has a value once or not at all:
the signs at both ends prove which. The zeros of the slope are all among those of a polynomial (`Surd.norm`),
and whether a quantity has a rational value exactly at such a place is settled by algebra, not by digits.
Angles are half turns in the frame of the stroke.

What a condition on path or acceleration makes of the first-order formulas is a quadratic equation, and the
exact path a linear one. Source: Blau, examples 33 to 35.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from math import gcd
from typing import Any, NamedTuple

import flint
from flint import arb, fmpz_poly

from kurbel.exact.certify import NEVER_TIES, at_bits, ball, pi, rounded
from kurbel.exact.numerals import Number, number_text
from kurbel.exact.place import (
    FIRST_BITS,
    PRECISIONS,
    Centre,
    Place,
    Surd,
    fraction,
    is_after,
    recognised,
    unsettled,
)
from kurbel.exact.search import Function, Zero, greatest

# Equal values at both dead centres are 0 or 1.
ROUND = 1000


class Target(NamedTuple):
    """A value to be had: a ball at the precision in force; `exact` None if it is irrational.

    `at_begin` if it is that of the place where the stroke begins.
    """

    ball: Callable[[], arb]
    exact: Fraction | None = None
    at_begin: bool = False

    @classmethod
    def rational(cls, value: Fraction) -> Target:
        return cls(lambda: ball(value), value)


@dataclass(frozen=True, eq=False)
class Course:
    """A quantity over a stroke from `begin` to `end`, as a function of half turns with its slope.

    `formula` is the same as a function of t, with its slope; None for quantities that only rise or only fall
    between the dead centres, but for the `inner` places where their slope is zero. `ends` are their exact
    values there, where they are known to be rational, and `is_exactly` tells whether at so many half turns
    they have a rational value.
    """

    value: Function
    slope: Function
    begin: Place
    end: Place
    formula: Surd | None = None
    formula_slope: Surd | None = None
    ends: tuple[Fraction | None, Fraction | None] = (None, None)
    is_exactly: Callable[[Fraction, Fraction], bool] | None = None
    inner: tuple[Place, ...] = ()

    @property
    def is_constant(self) -> bool:
        return self.formula_slope is not None and self.formula_slope.is_zero

    @cached_property
    def places(self) -> tuple[Place, ...]:
        """Both ends, and between them all places where the slope is zero.

        A few others among them, where the norm is zero and the slope is not, do no harm.
        """
        inner = self.inner if self.formula_slope is None else _zeros(self.formula_slope, self.begin, self.end)
        return (self.begin, *inner, self.end)

    def roots(self, target: Target) -> list[Place]:
        """Return all places where the quantity has the value, in order, each once."""
        signs = [self._sign(place, target) for place in self.places]
        found = [self.places[0]] if signs[0] == 0 else []
        for (low, before), (high, after) in pairwise(zip(self.places, signs, strict=True)):
            if before * after < 0:
                found.append(self._between(low, high, after > 0, target))
            if after == 0:
                found.append(high)
        return found

    def greatest(self, sign: int = 1, measure: Callable[[arb], arb] = lambda value: value) -> list[Place]:
        """Return where the quantity, or a measure of it, is greatest or, with sign -1, least."""
        found: Sequence[Place] = self.places
        for bits in PRECISIONS:
            found = greatest(found, lambda place: measure(self.value(place.half_turns())), sign, (bits,))
            with at_bits(bits):
                if len(found) == 1 or self._are_level(found):
                    return [*found]
        raise unsettled("where the quantity is greatest or least")

    def _are_level(self, places: Sequence[Place]) -> bool:
        value = fraction(self.value(places[0].half_turns()).mid()).limit_denominator(ROUND)
        # Of a magnitude both signs may stand at the places.
        return all(self._equals(place, value) or self._equals(place, -value) for place in places)

    def _sign(self, place: Place, target: Target) -> int:
        """Return whether the quantity is above the target, 1, below, -1, or has its value, 0."""
        if target.at_begin and place is self.begin:
            return 0
        for bits in PRECISIONS:
            with at_bits(bits):
                above = self.value(place.half_turns()) - target.ball()
                if not above.contains(0):
                    return 1 if above > 0 else -1
            if bits == FIRST_BITS and target.exact is not None and self._equals(place, target.exact):
                return 0
        raise unsettled("whether a value is just reached")

    def _equals(self, place: Place, value: Fraction) -> bool:
        if self.formula is not None and place.polynomial is not None:
            return place.vanishes(self.formula - value)
        return value == self.ends[0 if place is self.begin else 1]

    def _between(self, low: Place, high: Place, rising: bool, target: Target) -> Place:
        """Return the one place between two others where the quantity has the value."""
        polynomial = None
        if self.formula is not None and target.exact is not None:
            polynomial = (self.formula - target.exact).norm()

        def function(half_turns: arb) -> arb:
            return self.value(half_turns) - target.ball()

        with at_bits(FIRST_BITS):
            ends = fraction(low.half_turns().lower()), fraction(high.half_turns().upper())
        place = Place(Zero(function, self.slope, *ends, rising).place, low.centre, polynomial)
        is_exactly, wanted = self.is_exactly, target.exact
        if is_exactly is None or wanted is None:
            return recognised(place)
        return recognised(place, lambda half_turns: is_exactly(half_turns, wanted))


def _zeros(slope: Surd, begin: Place, end: Place) -> Iterator[Place]:
    """Yield, in order, the places between both ends where a formula is zero with either sign of its root."""
    if slope.is_zero:
        return
    polynomial = slope.norm()
    with at_bits(FIRST_BITS):
        pairs: Any = polynomial.complex_roots()
        found = [root.real for root, _ in pairs if root.imag == 0]
    for root in sorted(found, key=lambda root: fraction(root.mid())):
        place = _root_place(polynomial, root, begin.centre)
        if is_after(place, begin) and is_after(end, place):
            yield recognised(place)


def _root_place(polynomial: fmpz_poly, found: arb, centre: Centre) -> Place:
    low, high = fraction(found.lower()), fraction(found.upper())
    rising = polynomial(flint.fmpq(high.numerator, high.denominator)) > 0
    zero = Zero(polynomial, polynomial.derivative(), low, high, rising if low < high else None)

    def half_turns() -> arb:
        return centre.half_turns() + 2 * zero.place().atan() / pi()

    return Place(half_turns, centre, polynomial)


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
