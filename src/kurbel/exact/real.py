"""Real numbers of which pages print digits: formulas on any kind of number, and products of powers.

What is rational, or a rational multiple of a power of π, stays so in products, quotients and sums; of all
else exact/terms.py tells zeros and ties.

A `Product` is r^(1/n) π^p Π X^u with a rational r > 0; an X is a formula on any kind of number. Without one
it is settled what it equals: π being transcendental, it is rational only where p = 0 and r has an exact root.
A `Term` is one times powers of variables that are not known.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import reduce
from math import lcm
from operator import add, mul, sub, truediv
from typing import TypeAlias

from flint import arb

from kurbel.exact.certify import at_bits, ball
from kurbel.exact.kind import Kind, balls, settled
from kurbel.exact.numerals import Number, figures, given
from kurbel.exact.separation import Operation
from kurbel.exact.terms import HALF, exact_root, terms, vanishes
from kurbel.kernel.circle import Numeric

EXACT_ZERO = Number(0, 0)
"""A value that is 0 by proof is printed as 0, one that is only small as 0.0000."""
ESTIMATE_BITS = 128

Known: TypeAlias = "Real | Fraction | int"
# What becomes of powers of π in a product and a quotient.
_OF_POWERS = {mul: add, truediv: sub}


def _operation(operator: Operation, swapped: bool = False) -> Callable[[Real, Known], Real]:
    def call(own: Real, other: Known) -> Real:
        one, two = (Real.of(other), own) if swapped else (own, Real.of(other))
        if operator is mul and 0 in (one.share, two.share):
            return Real.of(0)
        if one.share is not None and two.share is not None and (operator in _OF_POWERS or one.pi == two.pi):
            pi = _OF_POWERS[operator](one.pi, two.pi) if operator in _OF_POWERS else one.pi
            return Real.of(operator(one.share, two.share), pi)
        return Real(lambda kind: operator(one.on(kind), two.on(kind)))

    return call


@dataclass(frozen=True, eq=False, slots=True)
class Real:
    """A number on any kind; where it was made so, it is a rational `share` of a power of π."""

    on: Callable[[Kind], Numeric]
    share: Fraction | None = None
    pi: int = 0

    @classmethod
    def of(cls, value: Known, pi: int = 0) -> Real:
        if isinstance(value, Real):
            return value
        share = Fraction(value)
        pi = pi if share else 0

        def on(kind: Kind) -> Numeric:
            found = kind.of(share)
            for _ in range(abs(pi)):
                found = found * kind.pi if pi > 0 else found / kind.pi
            return found

        return cls(on, share, pi)

    @property
    def rational(self) -> Fraction | None:
        return None if self.pi else self.share

    @classmethod
    def transcendental(cls, value: Callable[[Kind], Numeric]) -> Real:
        """Return a number of which no rational multiple of a power of π is rational."""
        return cls(lambda kind: kind.enclosed(lambda: ball(value(balls()))))

    __add__, __sub__, __mul__, __truediv__ = map(_operation, (add, sub, mul, truediv))
    __radd__, __rsub__, __rmul__, __rtruediv__ = (_operation(one, True) for one in (add, sub, mul, truediv))

    def __abs__(self) -> Real:
        if self.share is not None:
            return Real.of(abs(self.share), self.pi)
        return Real(lambda kind: abs(self.on(kind)))

    def root(self) -> Real:
        """Return the square root of a number that is not negative."""

        def on(kind: Kind) -> Numeric:
            found = self.on(kind)
            # A ball about 0 has no root.
            return found.nonnegative_part().sqrt() if isinstance(found, arb) else found ** kind.exponent(HALF)

        return Real(on)

    def __float__(self) -> float:
        """Return a float near it, 0 for one that is not told from it."""
        with at_bits(ESTIMATE_BITS):
            near = ball(self.on(balls()))
        return float(near.mid()) if near.is_finite() else 0.0

    def vanishes(self) -> bool:
        """Whether it is 0, by proof."""
        if self.share is not None:
            return not self.share
        return vanishes(self.on)

    def number(self, decimals: int | None, rounding: str = "half-away") -> Number:
        """Return it correctly rounded, without decimals to five figures; 0 where it is proved to be 0."""
        if self.rational is not None:
            return given(self.rational, decimals, rounding) if self.rational else EXACT_ZERO
        if decimals is None:
            if self.vanishes():
                return EXACT_ZERO
            decimals = figures(float(self))
        scaled = settled(self.on, decimals, rounding)
        return Number(scaled, decimals) if scaled or not self.vanishes() else EXACT_ZERO


PI = Real.of(1, pi=1)


_NEAR_BITS = 80
_SURE_BITS = 1000
_SHORT = 10**6


# A positive number on any kind.
Enclosed: TypeAlias = Callable[[Kind], Numeric]


@dataclass(frozen=True, eq=False, slots=True)
class Product:
    """r^(1/n) π^p Π X^u, positive."""

    base: Fraction
    root: int = 1
    pi: Fraction = Fraction(0)
    enclosed: tuple[tuple[Enclosed, Fraction], ...] = ()

    @classmethod
    def of(cls, value: Fraction | int, pi: int = 0) -> Product:
        """Return a rational number above 0 times a power of π."""
        assert value > 0
        return cls(Fraction(value), pi=Fraction(pi))

    @classmethod
    def about(cls, value: Enclosed) -> Product:
        """Return a number above 0 by its formula."""
        return cls(Fraction(1), enclosed=((value, Fraction(1)),))

    @classmethod
    def reduced(cls, value: Enclosed) -> Product:
        """Return the same where it is not proved to be a short rational number, or one times a power of π."""
        left = terms(value) or {}
        if len(left) == 1:
            [(unit, number)] = left.items()
            with at_bits(_NEAR_BITS):
                short = Fraction(float(number.ball.mid())).limit_denominator(_SHORT)
            found = cls(abs(short), pi=unit.pi)
            if unit.log is None and short > 0 and vanishes(lambda kind: value(kind) - found.on(kind)):
                return found
        return cls.about(value)

    def __mul__(self, other: Product | int) -> Product:
        other = Product.of(other) if isinstance(other, int) else other
        root = lcm(self.root, other.root)
        base = self.base ** (root // self.root) * other.base ** (root // other.root)
        powers = dict(self.enclosed)
        for one, power in other.enclosed:
            powers[one] = powers.get(one, Fraction(0)) + power
        left = tuple((one, power) for one, power in powers.items() if power)
        return Product(*_reduced(base, root), self.pi + other.pi, left)

    def __truediv__(self, other: Product | int) -> Product:
        return self * (Product.of(other) if isinstance(other, int) else other) ** Fraction(-1)

    def __pow__(self, power: Fraction) -> Product:
        base, root = _reduced(self.base**power.numerator, self.root * power.denominator)
        enclosed = tuple((one, own * power) for one, own in self.enclosed)
        return Product(base, root, self.pi * power, enclosed)

    def plus(self, other: Product, sign: int = 1) -> Product:
        """Return the sum, or with sign -1 the difference, which must be above 0.

        Of numbers whose ratio is rational it is exact. Else it is no rational number: powers of π, and roots
        of rational numbers, whose ratios are not rational depend on each other by no rational factors.
        """
        share = (other / self).rational
        if share is not None:
            return self * Product.of(1 + sign * share)
        return Product.about(lambda kind: self.on(kind) + sign * other.on(kind))

    @property
    def rational(self) -> Fraction | None:
        """The number where it is known to be rational, else None."""
        return self.base if self.root == 1 and not self.pi and not self.enclosed else None

    def on(self, kind: Kind) -> Numeric:
        """Return the number on a kind of numbers."""
        factors = [_power(kind.of(self.base), Fraction(1, self.root), kind)]
        if self.pi:
            factors.append(_power(kind.pi, self.pi, kind))
        factors += (_power(one(kind), power, kind) for one, power in self.enclosed)
        return reduce(mul, factors)

    def ball(self, bits: int = _NEAR_BITS) -> arb:
        """Return the ball around the number to about so many bits."""
        with at_bits(bits):
            return ball(self.on(balls()))

    def __float__(self) -> float:
        return float(self.ball().mid())

    def equals(self, other: Product) -> bool:
        """Whether two numbers are one; of enclosed ones whether nothing tells them apart."""
        quotient = self / other
        if not quotient.enclosed:
            return quotient.rational == 1
        return bool(quotient.ball(_SURE_BITS).contains(1))

    def exceeds(self, other: Product) -> bool:
        """Whether a number is greater than another."""
        return not self.equals(other) and bool((self / other).ball(_SURE_BITS) > 1)

    def number(self, decimals: int | None, rounding: str, times: int = 1) -> Number:
        """Return the number times a factor, rounded correctly; without decimals to five figures."""
        scaled = self * times
        if scaled.rational is not None:
            return given(scaled.rational, decimals, rounding)
        if decimals is None:
            decimals = figures(float(scaled))
        return Number(settled(scaled.on, decimals, rounding), decimals)


@dataclass(frozen=True, slots=True)
class Term:
    """A known number times powers of variables that are not known."""

    known: Product
    powers: Mapping[str, Fraction] = field(default_factory=dict)

    def __mul__(self, other: Term | int) -> Term:
        if isinstance(other, int):
            return Term(self.known * other, self.powers)
        names = dict.fromkeys((*self.powers, *other.powers))
        powers = {one: self.power(one) + other.power(one) for one in names}
        return Term(self.known * other.known, {one: power for one, power in powers.items() if power})

    def __truediv__(self, other: Term | int) -> Term:
        if isinstance(other, int):
            return Term(self.known / other, self.powers)
        return self * other ** Fraction(-1)

    def __pow__(self, exponent: Fraction) -> Term:
        return Term(self.known**exponent, {one: power * exponent for one, power in self.powers.items()})

    def power(self, name: str) -> Fraction:
        """Return the exponent of a variable."""
        return self.powers.get(name, Fraction(0))

    def solved_for(self, name: str) -> Term:
        """Return the variable with which this term is 1."""
        return self._without(name) ** (-1 / self.power(name))

    def put(self, name: str, value: Term) -> Term:
        """Return the term with a value in the place of a variable."""
        power = self.power(name)
        return self._without(name) * value**power if power else self

    def _without(self, name: str) -> Term:
        return Term(self.known, {one: power for one, power in self.powers.items() if one != name})


def number(value: Fraction | int, pi: int = 0) -> Term:
    """Return a rational number above 0 times a power of π."""
    return Term(Product.of(value, pi))


def variable(name: str) -> Term:
    """Return a variable that is not known."""
    return Term(Product.of(1), {name: Fraction(1)})


def _power(value: Numeric, power: Fraction, kind: Kind) -> Numeric:
    return value if power == 1 else value ** kind.exponent(power)


def _reduced(base: Fraction, root: int) -> tuple[Fraction, int]:
    """Return the same number with the least root."""
    for divisor in range(root, 1, -1):
        if root % divisor == 0:
            parts = [exact_root(part, divisor) for part in (base.numerator, base.denominator)]
            if all(parts):
                return Fraction(parts[0] or 1, parts[1] or 1), root // divisor
    return base, root
