"""A number that is known by its balls alone, such as a crank angle at which a condition holds.

It is a fraction so near to it that it takes its place where numbers are compared; of a ball it is the number
itself, at any precision. With rational numbers it can be added and multiplied and stays one.
"""

from __future__ import annotations

from fractions import Fraction
from math import floor
from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    from flint import arb

    from kurbel.exact.place import Place

NEAR_BITS = 256


class Held(Protocol):
    """What gives a place, which is found again where it was lost, as by another process; it was asked for."""

    @property
    def asked(self) -> Any: ...

    def __call__(self) -> Place: ...


class Found(Fraction):
    """A factor times the half turns of a place that is `held`, and a rational number."""

    __slots__ = ("factor", "held", "rest")

    held: Held
    factor: Fraction
    rest: Fraction

    def __new__(cls, held: Held, factor: Fraction = Fraction(1), rest: Fraction = Fraction(0)) -> Found:
        from kurbel.exact.certify import at_bits

        with at_bits(NEAR_BITS):
            middle = held().half_turns().mid().fmpq()
        near = factor * Fraction(int(middle.p), int(middle.q)) + rest
        self = super().__new__(cls, near.numerator, near.denominator)
        self.held, self.factor, self.rest = held, factor, rest
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.held, self.factor, self.rest)

    def __copy__(self) -> Found:
        return self

    def __deepcopy__(self, memo: object) -> Found:
        return self

    def enclosed(self) -> arb:
        """Return the ball at the precision in force."""
        from kurbel.exact.certify import ball

        found: arb = ball(self.factor) * self.held().half_turns() + ball(self.rest)
        return found

    def rounded(self, decimals: int) -> int:
        """Return it times 10**decimals, rounded correctly."""
        from kurbel.exact.certify import NEVER_TIES, rounded

        return rounded(self.enclosed, decimals, "half-away", NEVER_TIES)

    def __add__(self, other: Any) -> Any:
        if not _is_rational(other):
            return self._near + other
        return Found(self.held, self.factor, self.rest + other)

    def __mul__(self, other: Any) -> Any:
        if not _is_rational(other):
            return self._near * other
        return Found(self.held, self.factor * other, self.rest * other) if other else Fraction(0)

    def __sub__(self, other: Any) -> Any:
        return self + -other

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __truediv__(self, other: Any) -> Any:
        return self * (1 / Fraction(other)) if _is_rational(other) else self._near / other

    def __neg__(self) -> Found:
        return Found(self.held, -self.factor, -self.rest)

    def __mod__(self, other: Any) -> Any:
        return self - floor(self._near / other) * other

    __radd__, __rmul__ = __add__, __mul__

    @property
    def _near(self) -> Fraction:
        """The fraction alone."""
        return Fraction(self.numerator, self.denominator)


def _is_rational(other: Any) -> bool:
    return isinstance(other, (int, Fraction)) and not isinstance(other, Found)
