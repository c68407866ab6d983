"""The kinds of number on which a formula runs, and what settles the digits of one that runs on any.

Neither floats nor separation bounds load flint.

A number that is known by its balls alone, such as a crank angle at which a condition holds.

It is a fraction so near to it that it takes its place where numbers are compared; of a ball it is the number
itself, at any precision. With rational numbers it can be added and multiplied and stays one.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache
from math import floor
from typing import TYPE_CHECKING, Any, NamedTuple, NoReturn, Protocol

from kurbel.exact.separation import Separation, circle_separation
from kurbel.kernel import circle as on_floats
from kurbel.kernel.circle import Circle, Numeric

if TYPE_CHECKING:
    from flint import arb

    from kurbel.exact.place import Field, Place


# Of balls that become floats.
_ROUNDED_BITS = 192


def _missing(*_: object) -> NoReturn:
    raise NotImplementedError("numbers of this kind have none")


class Kind(NamedTuple):
    """A kind of number: how it is made of a rational number, the circle of an angle in degrees, the arcsine
    in degrees, π, the rod angle in degrees of circle, λ and e/R or None, what an exponent is to it, and how
    it is made of a number that is known by its balls alone. Of `bounded` numbers every root counts, as of
    separation bounds: formulas with few of them are best.

    Separation bounds have neither arcs nor π; functions of the crank angle come with their own circle.
    """

    of: Callable[[Any], Numeric]
    circle: Callable[[Any], Circle[Numeric]] = _missing
    arc: Callable[[Any], Numeric] = _missing
    pi: Numeric = math.nan
    rod_angle: Callable[..., Numeric] = _missing
    exponent: Callable[[Fraction], Numeric] = _missing
    enclosed: Callable[[Callable[[], arb]], Numeric] = _missing
    bounded: bool = False


def unordered(*numbers: Any, **more: Any) -> Kind:
    """Return a kind of numbers that lack an order or a nearest float: formulas on them ask for none."""
    return Kind(*numbers, **more)


def balls() -> Kind:
    """Return balls at the precision in force."""
    import flint

    return _balls(flint.ctx.prec)


@lru_cache(maxsize=16)
def _balls(precision: int) -> Kind:
    from kurbel.exact import certify as on

    return Kind(on.ball, on.ball_circle, on.ball_degrees, on.pi(), on.rod_angle, on.ball, _itself)


def _itself(value: Callable[[], arb]) -> arb:
    return value()


def bounds() -> Kind:
    """Return separation bounds."""
    return unordered(Separation.rational, circle_separation, exponent=Fraction, bounded=True)


def separation_of(value: Callable[[Kind], Numeric]) -> Separation:
    """Return the separation bound of a number on any kind."""
    found = value(bounds())
    assert isinstance(found, Separation)
    return found


def settled(value: Callable[[Kind], Numeric], decimals: int, rounding: str = "half-away") -> int:
    """Return what `rounded` does of a value on any kind of number; of what it is made its ties follow."""
    from kurbel.exact import certify

    def tie_bits(boundary: Fraction) -> float:
        # Few values touch a boundary.
        from kurbel.exact import terms

        return terms.tie_bits(value, boundary)

    return certify.rounded(lambda: value(balls()), decimals, rounding, tie_bits)


def floats() -> Kind:
    """Return floats, or arrays of them."""

    def angle(point: Circle[Numeric], ratio: Numeric, offset: Numeric | None) -> Numeric:
        return on_floats.rod_angle(point, ratio, offset or 0.0)

    def circle(degrees: Any) -> Circle[Numeric]:
        return on_floats.circle(float(degrees) if isinstance(degrees, Fraction) else degrees)

    return Kind(float, circle, on_floats.arcsine, math.pi, angle, float, _rounded)


def _rounded(value: Callable[[], arb]) -> float:
    from kurbel.exact.certify import at_bits

    with at_bits(_ROUNDED_BITS):
        return float(value().mid())


def surds(field: Field) -> Kind:
    """Return functions of the tangent in the field, with their slopes."""
    from kurbel.exact.search import Jet

    return unordered(lambda number: Jet(field.of(number), field.of(0), field.of(0)), bounded=True)


NEAR_BITS = 256


class PlaceSource(Protocol):
    """What gives a place, which is found again where it was lost, as by another process; it was asked for."""

    @property
    def asked(self) -> Any: ...

    def __call__(self) -> Place: ...


class FoundAngle(Fraction):
    """A factor times the half turns of a place that is `held`, and a rational number."""

    __slots__ = ("factor", "held", "rest")

    held: PlaceSource
    factor: Fraction
    rest: Fraction

    def __new__(
        cls, held: PlaceSource, factor: Fraction = Fraction(1), rest: Fraction = Fraction(0)
    ) -> FoundAngle:
        from kurbel.exact.certify import at_bits

        with at_bits(NEAR_BITS):
            middle = held().half_turns().mid().fmpq()
        near = factor * Fraction(int(middle.p), int(middle.q)) + rest
        self = super().__new__(cls, near.numerator, near.denominator)
        self.held, self.factor, self.rest = held, factor, rest
        return self

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (self.held, self.factor, self.rest)

    def __copy__(self) -> FoundAngle:
        return self

    def __deepcopy__(self, memo: object) -> FoundAngle:
        return self

    def enclosed(self) -> arb:
        """Return the ball at the precision in force."""
        from kurbel.exact.certify import ball

        return ball(self.factor) * self.held().half_turns() + ball(self.rest)

    def rounded(self, decimals: int) -> int:
        """Return it times 10**decimals, rounded correctly."""
        from kurbel.exact.certify import NEVER_TIES, rounded

        return rounded(self.enclosed, decimals, "half-away", NEVER_TIES)

    def __add__(self, other: Any) -> Any:
        if not _is_rational(other):
            return self._near + other
        return FoundAngle(self.held, self.factor, self.rest + other)

    def __mul__(self, other: Any) -> Any:
        if not _is_rational(other):
            return self._near * other
        return FoundAngle(self.held, self.factor * other, self.rest * other) if other else Fraction(0)

    def __sub__(self, other: Any) -> Any:
        return self + -other

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __truediv__(self, other: Any) -> Any:
        return self * (1 / Fraction(other)) if _is_rational(other) else self._near / other

    def __neg__(self) -> FoundAngle:
        return FoundAngle(self.held, -self.factor, -self.rest)

    def __mod__(self, other: Any) -> Any:
        return self - floor(self._near / other) * other

    __radd__, __rmul__ = __add__, __mul__

    @property
    def _near(self) -> Fraction:
        """The fraction alone."""
        return Fraction(self.numerator, self.denominator)


def _is_rational(other: object) -> bool:
    return isinstance(other, (int, Fraction)) and not isinstance(other, FoundAngle)
