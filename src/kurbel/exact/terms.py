"""Numbers that know what they are made of: algebraic numbers, powers of π, logarithms.

A kernel formula that is run on `Terms` gives a sum of algebraic numbers, each with its ball and its
separation bound, times a power of π and at most one logarithm. Zeros and ties follow from the terms: π is
transcendental (Lindemann), and over the algebraic numbers 1, π and the logarithms of primes are independent
(Baker), so that such a sum is 0 only if every term is, and rational only if every term but that of 1 is. Of
π times a logarithm nobody knows it, nor of what a formula takes from elsewhere, which raises UndecidedError:
such a number is proved to be nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cached_property, lru_cache, reduce
from math import lcm, log2
from typing import NamedTuple, NoReturn, TypeAlias

import flint
from flint import arb

from kurbel.exact import certify
from kurbel.exact.certify import UndecidedError, at_bits
from kurbel.exact.kind import FoundAngle, Kind, balls, unordered
from kurbel.exact.place import Place
from kurbel.exact.separation import Separation, circle_separation
from kurbel.kernel.circle import Circle, Numeric

FIRST_BITS = 128
# The logarithm of a longer fraction is one of its own, for its primes may take years to find.
MOST_FACTORED_BITS = 128
# Numbers in higher powers than this take too long to be told from 1.
MOST_POWER = 10**5


class DoubtfulError(Exception):
    """At the precision in force it is not known whether a number is 0."""


class Algebraic:
    """A real algebraic number: its ball, its separation bound, and what it is where it was made of rational
    numbers, whose balls and bounds are made where they are asked for."""

    __slots__ = ("_ball", "_bound", "exact")

    def __init__(self, ball: arb | None, bound: Separation | None, exact: Fraction | None = None) -> None:
        self._ball, self._bound, self.exact = ball, bound, exact

    @classmethod
    def of(cls, value: Fraction) -> Algebraic:
        return cls(None, None, value)

    @property
    def ball(self) -> arb:
        if self._ball is None:
            self._ball = certify.ball(self.exact or Fraction(0))
        return self._ball

    @property
    def bound(self) -> Separation:
        if self._bound is None:
            self._bound = Separation.rational(self.exact or 0)
        return self._bound

    def __add__(self, other: Algebraic) -> Algebraic:
        if self.exact is not None and other.exact is not None:
            return Algebraic.of(self.exact + other.exact)
        if self.exact == 0:
            return other
        return self if other.exact == 0 else Algebraic(self.ball + other.ball, self.bound + other.bound)

    def __mul__(self, other: Algebraic) -> Algebraic:
        if self.exact is not None and other.exact is not None:
            return Algebraic.of(self.exact * other.exact)
        if 0 in (self.exact, other.exact):
            return Algebraic.of(Fraction(0))
        return Algebraic(self.ball * other.ball, self.bound * other.bound)

    def __neg__(self) -> Algebraic:
        if self.exact is not None:
            return Algebraic.of(-self.exact)
        return Algebraic(-self.ball, self.bound)

    def __pow__(self, power: Fraction) -> Algebraic:
        exact = None if self.exact is None else _rational_power(self.exact, power)
        if exact is not None:
            return Algebraic.of(exact)
        if power.denominator == 1:
            return Algebraic(self.ball ** int(power), self.bound**power)
        # A ball about 0 has no root.
        near = self.ball.nonnegative_part()
        return Algebraic(near.sqrt() if power == HALF else near ** certify.ball(power), self.bound**power)

    def vanishes(self) -> bool:
        """Whether it is 0; raises DoubtfulError where the ball is too wide to tell."""
        if self.exact is not None or not self.ball.contains(0):
            return self.exact == 0
        if abs(self.ball).upper() < flint.arb(2) ** -int(self.bound.bits() + 1):
            return True
        raise DoubtfulError


HALF, HALF_TURN = Fraction(1, 2), Fraction(180)


class Unit(NamedTuple):
    """What a term is a multiple of: a power of π, times the logarithm of a prime or of what is none."""

    pi: Fraction = Fraction(0)
    log: int | Algebraic | None = None

    @property
    def ball(self) -> arb:
        found = flint.arb.pi() ** certify.ball(self.pi) if self.pi else flint.arb(1)
        if self.log is None:
            return found
        return found * (flint.arb(self.log) if isinstance(self.log, int) else self.log.ball).log()


ONE = Unit()
Parts: TypeAlias = Mapping[Unit, Algebraic]


class Terms:
    """Algebraic numbers by what they are multiples of, at the precision in force."""

    def __init__(self, parts: Parts) -> None:
        self.parts = parts

    @classmethod
    def of(cls, value: object) -> Terms:
        """Return a rational number; one that is known by its ball alone is undecided."""
        if isinstance(value, Terms):
            return value
        if not isinstance(value, (int, float, Fraction)) or isinstance(value, FoundAngle):
            raise UndecidedError
        return cls({ONE: Algebraic.of(Fraction(value))})

    def __add__(self, other: Terms | Fraction | float) -> Terms:
        parts = dict(self.parts)
        for unit, one in Terms.of(other).parts.items():
            parts[unit] = parts[unit] + one if unit in parts else one
        return Terms(parts)

    def __mul__(self, other: Terms | Fraction | float) -> Terms:
        total: Terms | None = None
        for unit, one in Terms.of(other).parts.items():
            found = Terms({_product(own, unit): number * one for own, number in self.parts.items()})
            total = found if total is None else total + found
        return Terms({}) if total is None else total

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self) -> Terms:
        return Terms({unit: -one for unit, one in self.parts.items()})

    def __sub__(self, other: Terms | Fraction | float) -> Terms:
        return self + -Terms.of(other)

    def __rsub__(self, other: Terms | Fraction | float) -> Terms:
        return -self + Terms.of(other)

    def __truediv__(self, other: Terms | Fraction | float) -> Terms:
        return self * Terms.of(other) ** -1

    def __rtruediv__(self, other: Terms | Fraction | float) -> Terms:
        return Terms.of(other) * self**-1

    def __pow__(self, exponent: float | Fraction) -> Terms:
        power = Fraction(exponent)
        if power.denominator == 1 and power > 0:
            return reduce(Terms.__mul__, [self] * int(power))
        unit, number = self._only
        if unit.log is not None:
            raise UndecidedError
        return Terms({Unit(unit.pi * power): number**power})

    def __abs__(self) -> Terms:
        return -self if self.sign < 0 else self

    def log(self) -> Terms:
        """Return the natural logarithm, of a rational number by its primes."""
        unit, number = self._only
        if unit != ONE:
            raise UndecidedError
        primes = {number: 1} if number.exact is None else _primes(number.exact)
        if primes is None:
            primes = {number: 1}
        return Terms({Unit(log=one): Algebraic.of(Fraction(times)) for one, times in primes.items()})

    def max(self, other: Terms | Fraction | float) -> Terms:
        other = Terms.of(other)
        return other if (self - other).sign < 0 else self

    def union(self, other: Terms | Fraction | float) -> Terms:
        """Return what either of two numbers may be, which is known if they are one."""
        if (self - other).left:
            raise UndecidedError
        return self

    def __lt__(self, other: Terms | Fraction | float) -> bool:
        return (self - Terms.of(other)).sign < 0

    def __gt__(self, other: Terms | Fraction | float) -> bool:
        return (self - Terms.of(other)).sign > 0

    @property
    def sign(self) -> int:
        """-1, 0 or 1; raises DoubtfulError where the balls are too wide to tell."""
        whole = sum((unit.ball * one.ball for unit, one in self.left.items()), flint.arb(0))
        if whole.contains(0) and whole != 0:
            raise DoubtfulError
        return int(whole > 0) - int(whole < 0)

    @cached_property
    def left(self) -> Parts:
        """The terms that are not 0; logarithms, whose rational multiples may cancel, together."""
        left = {unit: one for unit, one in self.parts.items() if not one.vanishes()}
        for power in {unit.pi for unit in left}:
            logs = {unit: one for unit, one in left.items() if unit.log is not None and unit.pi == power}
            if any(isinstance(unit.log, Algebraic) for unit in logs) and _cancel(logs):
                left = {unit: one for unit, one in left.items() if unit not in logs}
        return left

    @property
    def _only(self) -> tuple[Unit, Algebraic]:
        """The one term."""
        left = self.parts if len(self.parts) == 1 else self.left or {ONE: Algebraic.of(Fraction(0))}
        if len(left) > 1:
            raise UndecidedError
        return next(iter(left.items()))


def _product(one: Unit, other: Unit) -> Unit:
    if one is ONE:
        return other
    if one.log is not None and other.log is not None:
        raise UndecidedError
    return Unit(one.pi + other.pi, other.log if one.log is None else one.log)


def _cancel(logs: Parts) -> bool:
    """Whether logarithms with these factors are 0 together: where all are rational the product of what they
    are of, in powers that are made whole, is 1."""
    factors = {unit.log: one.exact for unit, one in logs.items() if one.exact is not None}
    near = sum((unit.ball * one.ball for unit, one in logs.items()), flint.arb(0))
    if len(factors) < len(logs) or not near.contains(0):
        return False
    whole = lcm(*(one.denominator for one in factors.values()))
    if max(abs(one) * whole for one in factors.values()) > MOST_POWER:
        return False
    total = Algebraic.of(Fraction(1))
    for log, factor in factors.items():
        number = log if isinstance(log, Algebraic) else Algebraic.of(Fraction(log or 1))
        total *= number ** (factor * whole)
    return (total + Algebraic.of(Fraction(-1))).vanishes()


def _rational_power(value: Fraction, power: Fraction) -> Fraction | None:
    """Return the power of a rational number where it is one, too."""
    roots = [exact_root(part, power.denominator) for part in (value.numerator, value.denominator)]
    if None in roots or (not roots[0] and power < 0):
        return None
    return Fraction(roots[0] or 0, roots[1] or 1) ** power.numerator


def exact_root(value: int, degree: int) -> int | None:
    """Return the whole root of a number, None if it has none."""
    if degree == 1:
        return value
    if value < 0:
        return None
    root = int(flint.fmpz(value).root(degree))
    return root if root**degree == value else None


def _primes(value: Fraction) -> dict[int | Algebraic, int] | None:
    """Return the powers of primes in a fraction above 0, None of a long one."""
    if max(value.numerator.bit_length(), value.denominator.bit_length()) > MOST_FACTORED_BITS:
        return None
    found: dict[int | Algebraic, int] = {}
    for part, sign in ((value.numerator, 1), (value.denominator, -1)):
        found |= {int(prime): sign * int(times) for prime, times in flint.fmpz(part).factor()}
    return found


def _circle(degrees: Fraction) -> Circle[Terms]:
    if not isinstance(degrees, (int, Fraction)):
        raise UndecidedError
    if isinstance(degrees, FoundAngle):
        return _turned(_held_circle(degrees), _circle_at(degrees.rest, flint.ctx.prec))
    return _circle_at(Fraction(degrees), flint.ctx.prec)


def _held_circle(degrees: FoundAngle) -> Circle[Terms]:
    """Return the circle of a place whose tangent is algebraic."""
    place = degrees.held()
    if place.polynomial is None or degrees.factor != HALF_TURN:
        raise UndecidedError
    t = Terms({ONE: Algebraic(place.t(), _tangent_bound(place))})
    centre = place.centre.tangent
    return _turned(_of_tangent(t), _of_tangent(Terms.of(centre)))


def _of_tangent(t: Terms) -> Circle[Terms]:
    """Return the circle of an angle by the tangent of its half."""
    over = (1 + t * t) ** -1
    return Circle(2 * t * over, (1 - t * t) * over, 2 * t * t * over)


def _turned(one: Circle[Terms], other: Circle[Terms]) -> Circle[Terms]:
    """Return the circle of the sum of two angles."""
    cosine = one.cosine * other.cosine - one.sine * other.sine
    return Circle(one.sine * other.cosine + one.cosine * other.sine, cosine, 1 - cosine)


def _tangent_bound(place: Place) -> Separation:
    """Return how near the tangent of a place comes to other numbers: of the zeros of a polynomial with the
    leading coefficient a, a t is an algebraic integer of at most |a| and the largest of the others (Cauchy).
    """
    assert place.polynomial is not None
    factors = [one for one, _ in place.polynomial.factor()[1]]
    near = [one for one in factors if one(place.t()).contains(0)]
    own = near[0] if len(near) == 1 else place.polynomial
    whole = [abs(int(one)) for one in own.coeffs()]
    return Separation(log2(whole[-1] + max(whole)), log2(whole[-1]), 1, frozenset({(place, own.degree())}))


@lru_cache(maxsize=256)
def _circle_at(degrees: Fraction, precision: int) -> Circle[Terms]:
    pairs = zip(certify.ball_circle(degrees)[:3], circle_separation(degrees)[:3], strict=True)
    return Circle(*(Terms({ONE: _exactly(*pair)}) for pair in pairs))


def _exactly(ball: arb, bound: Separation) -> Algebraic:
    """Return a sine, cosine or versine: rational ones are whole multiples of ½ (Niven)."""
    doubled = (2 * ball).unique_fmpz() if (2 * ball).is_integer() else None
    return Algebraic(ball, bound) if doubled is None else Algebraic.of(Fraction(int(doubled), 2))


def _undecided(*_: object) -> NoReturn:
    raise UndecidedError


@lru_cache(maxsize=16)
def _kind(precision: int) -> Kind:
    """Return the kind of number at a precision in force; arcs are transcendental but of a few sines."""
    pi = Terms({Unit(Fraction(1)): Algebraic.of(Fraction(1))})
    return unordered(
        Terms.of, _circle, _undecided, pi, _undecided, exponent=Fraction, enclosed=_undecided, bounded=True
    )


def algebraic(kind: Kind, ball: Callable[[], arb], bound: Callable[[], Separation | None]) -> Numeric:
    """Return an algebraic number, which is known by its ball, on a kind of number; on Terms a bound that is
    None leaves it undecided."""
    if not isinstance(kind.pi, Terms):
        return kind.enclosed(ball)
    own = bound()
    if own is None:
        raise UndecidedError
    return Terms({ONE: Algebraic(ball(), own)})


def terms(value: Callable[[Kind], object]) -> Parts | None:
    """Return the terms of a number that are not 0, None where they are not known or no precision tells."""
    bits = FIRST_BITS
    while bits < certify.MOST_TIE_BITS:
        try:
            with at_bits(bits):
                return Terms.of(value(_kind(bits))).left
        except DoubtfulError:
            bits *= 2
        except UndecidedError:
            return None
    return None


def vanishes(value: Callable[[Kind], Numeric]) -> bool:
    """Whether a number on any kind is 0, by proof."""
    with at_bits(FIRST_BITS):
        near = certify.ball(value(balls()))
    return near.contains(0) and terms(value) == {}


def tie_bits(value: Callable[[Kind], Numeric], boundary: Fraction) -> float:
    """Return how near a number on any kind can come to a rounding boundary, as `certify.rounded` asks."""
    # The boundary is that of the magnitude.
    left = terms(lambda kind: abs(Terms.of(value(kind))) - boundary)
    if left is None or any(unit != ONE for unit in left):
        return float("inf")
    return left[ONE].bound.bits() if left else 0.0
