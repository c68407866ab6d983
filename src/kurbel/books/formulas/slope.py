"""The slope of a formula by one of its letters: numbers that bear their slope with them, on any algebra."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any


@dataclass(frozen=True, slots=True)
class Dual:
    """A value and its slope."""

    value: Any
    slope: Any

    def __add__(self, other: Dual) -> Dual:
        return Dual(self.value + other.value, self.slope + other.slope)

    def __sub__(self, other: Dual) -> Dual:
        return Dual(self.value - other.value, self.slope - other.slope)

    def __neg__(self) -> Dual:
        return Dual(-self.value, -self.slope)

    def __mul__(self, other: Dual) -> Dual:
        return Dual(self.value * other.value, self.slope * other.value + self.value * other.slope)

    def __truediv__(self, other: Dual) -> Dual:
        quotient = self.value / other.value
        return Dual(quotient, (self.slope - quotient * other.slope) / other.value)


# A product of such numbers has three of those that they are made of.
PRODUCTS = 3


class Duals:
    """The algebra of such numbers on another one."""

    def __init__(self, algebra: Any) -> None:
        self.algebra = algebra
        self.pi = self.constant(algebra.pi)

    def spend(self, operations: float) -> None:
        self.algebra.spend(PRODUCTS * operations)

    def constant(self, value: Any) -> Dual:
        return Dual(value, self.algebra.of(Fraction(0)))

    def of(self, value: Fraction) -> Dual:
        return self.constant(self.algebra.of(value))

    def letter(self, value: Any) -> Dual:
        """Return the letter by which the slope is taken."""
        return Dual(value, self.algebra.of(Fraction(1)))

    def apply(self, function: str, value: Dual) -> Dual:
        found = self.algebra.apply(function, value.value)
        return Dual(found, _SLOPES[function](self.algebra, value.value, found) * value.slope)


def _one(algebra: Any) -> Any:
    return algebra.of(Fraction(1))


# Of an algebra, a value and what a function makes of it.
_SLOPES: Mapping[str, Callable[[Any, Any, Any], Any]] = {
    "sin": lambda algebra, value, found: algebra.apply("cos", value),
    "cos": lambda algebra, value, found: -algebra.apply("sin", value),
    "tan": lambda algebra, value, found: _one(algebra) + found * found,
    "cot": lambda algebra, value, found: -_one(algebra) - found * found,
    "sqrt": lambda algebra, value, found: _one(algebra) / (found + found),
    "ln": lambda algebra, value, found: _one(algebra) / value,
    "arcsin": lambda algebra, value, found: (
        _one(algebra) / algebra.apply("sqrt", _one(algebra) - value * value)
    ),
    "arctan": lambda algebra, value, found: _one(algebra) / (_one(algebra) + value * value),
}
