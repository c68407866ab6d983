"""Values with their first two slopes: a kernel formula that is run on jets returns its own derivatives."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from flint import arb

from kurbel.exact.certify import half_turn_circle, pi
from kurbel.kernel.circle import Circle, Numeric


# Not frozen, which would be half the time of a sum.
@dataclass(slots=True)
class Jet:
    """A value, its slope and its bend, f, f' and f'', all of one kind of number; a bare one is a constant."""

    value: Any
    slope: Any
    bend: Any

    def __add__(self, other: Jet | Numeric) -> Jet:
        if not isinstance(other, Jet):
            return Jet(self.value + other, self.slope, self.bend)
        return Jet(self.value + other.value, self.slope + other.slope, self.bend + other.bend)

    __radd__ = __add__

    def __neg__(self) -> Jet:
        return Jet(-self.value, -self.slope, -self.bend)

    def __sub__(self, other: Jet | Numeric) -> Jet:
        return self.__add__(-other)

    def __rsub__(self, other: Jet | Numeric) -> Jet:
        return (-self).__add__(other)

    def __mul__(self, other: Jet | Numeric) -> Jet:
        if not isinstance(other, Jet):
            return Jet(self.value * other, self.slope * other, self.bend * other)
        return Jet(
            self.value * other.value,
            self.slope * other.value + self.value * other.slope,
            self.bend * other.value + 2 * (self.slope * other.slope) + self.value * other.bend,
        )

    __rmul__ = __mul__

    def __truediv__(self, other: Jet | Numeric) -> Jet:
        if not isinstance(other, Jet):
            return Jet(self.value / other, self.slope / other, self.bend / other)
        value = self.value / other.value
        slope = (self.slope - value * other.slope) / other.value
        return Jet(value, slope, (self.bend - 2 * (slope * other.slope) - value * other.bend) / other.value)

    def __rtruediv__(self, other: Jet | Numeric) -> Jet:
        return Jet(other, 0, 0) / self

    def __pow__(self, exponent: Any) -> Jet:
        """Return the power to a number, of a positive value but for whole exponents."""
        if exponent == 0.5:
            return self.sqrt()
        value = self.value**exponent
        rate = exponent * value / self.value
        rise = (exponent - 1) * rate / self.value
        return Jet(value, rate * self.slope, rate * self.bend + rise * self.slope * self.slope)

    def sqrt(self) -> Jet:
        value = self.value**0.5
        slope = self.slope / (2 * value)
        return Jet(value, slope, (self.bend / 2 - slope * slope) / value)

    def __abs__(self) -> Jet:
        """Return the magnitude; about a zero its slope is a ball with both signs, and its bend any number."""
        if not self.value.contains(0):
            return self if self.value > 0 else -self
        slope = arb(self.slope)
        return Jet(abs(self.value), slope.union(-slope), arb(0, "inf"))

    def log(self) -> Jet:
        rate = self.slope / self.value
        return Jet(self.value.log(), rate, self.bend / self.value - rate * rate)

    def asin(self) -> Jet:
        """Return the arc that has this sine, within a right angle."""
        cosine = (1 - self.value * self.value) ** 0.5
        slope = self.slope / cosine
        return Jet(self.value.asin(), slope, (self.bend + self.value * slope * slope) / cosine)


def jets(circle: Circle[Any]) -> Circle[Jet]:
    """Return the circle of an angle with its slopes over the angle in radians."""
    sine, cosine, versine, *_ = circle
    return Circle(Jet(sine, cosine, -sine), Jet(cosine, -sine, -cosine), Jet(versine, sine, cosine))


def ball_jets(half_turns: arb) -> Circle[Jet]:
    """Return the same of an angle in half turns, a ball."""
    return jets(half_turn_circle(half_turns))


def slopes(jet: Callable[[arb], Jet]) -> tuple[Callable[[arb], arb], Callable[[arb], arb]]:
    """Return the slope and the bend, over half turns, of what has slopes over the angle in radians."""

    def slope(half_turns: arb) -> arb:
        found: arb = jet(half_turns).slope * pi()
        return found

    def bend(half_turns: arb) -> arb:
        found: arb = jet(half_turns).bend * pi() * pi()
        return found

    return slope, bend
