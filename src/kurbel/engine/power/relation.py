"""Relations in which powers of variables are multiplied: each known one makes another known."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from kurbel.exact.product import Product


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
