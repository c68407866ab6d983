"""Real numbers of which pages print digits: a formula on any kind of number, without a rule of its own.

What is rational, or a rational multiple of a power of π, stays so in products, quotients and sums; of all
else exact/terms.py tells zeros and ties.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from operator import add, mul, sub, truediv
from typing import Any, TypeAlias

from flint import arb

from kurbel.exact import certify
from kurbel.exact.kind import Kind, balls
from kurbel.exact.numerals import Number, figures, given
from kurbel.exact.precision import at_bits
from kurbel.exact.terms import HALF, tie_bits, vanishes

EXACT_ZERO = Number(0, 0)
"""A value that is 0 by proof is printed as 0, one that is only small as 0.0000."""
ESTIMATE_BITS = 128

Known: TypeAlias = "Real | Fraction | int"
# What becomes of powers of π in a product and a quotient.
_OF_POWERS = {mul: add, truediv: sub}


def _operation(operator: Callable[[Any, Any], Any], swapped: bool = False) -> Callable[[Real, Known], Real]:
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

    on: Callable[[Kind], Any]
    share: Fraction | None = None
    pi: int = 0

    @classmethod
    def of(cls, value: Known, pi: int = 0) -> Real:
        if isinstance(value, Real):
            return value
        share = Fraction(value)
        pi = pi if share else 0

        def on(kind: Kind) -> Any:
            found = kind.of(share)
            for _ in range(abs(pi)):
                found = found * kind.pi if pi > 0 else found / kind.pi
            return found

        return cls(on, share, pi)

    @property
    def rational(self) -> Fraction | None:
        return None if self.pi else self.share

    @classmethod
    def transcendental(cls, value: Callable[[Kind], Any]) -> Real:
        """Return a number of which no rational multiple of a power of π is rational."""
        return cls(lambda kind: kind.enclosed(lambda: value(balls())))

    __add__, __sub__, __mul__, __truediv__ = map(_operation, (add, sub, mul, truediv))
    __radd__, __rsub__, __rmul__, __rtruediv__ = (_operation(one, True) for one in (add, sub, mul, truediv))

    def root(self) -> Real:
        """Return the square root of a number that is not negative."""

        def on(kind: Kind) -> Any:
            found = self.on(kind)
            # A ball about 0 has no root.
            return found.nonnegative_part().sqrt() if isinstance(found, arb) else found ** kind.exponent(HALF)

        return Real(on)

    def __float__(self) -> float:
        """Return a float near it, 0 for one that is not told from it."""
        with at_bits(ESTIMATE_BITS):
            near = self.on(balls())
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
        scaled = certify.rounded(
            lambda: self.on(balls()), decimals, rounding, lambda boundary: tie_bits(self.on, boundary)
        )
        return Number(scaled, decimals) if scaled or not self.vanishes() else EXACT_ZERO


PI = Real.of(1, pi=1)
