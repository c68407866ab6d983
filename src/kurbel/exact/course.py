"""The course of a quantity over a stroke: where it is greatest, and all places where it has a given value.

Between two neighbouring places of zero slope a quantity rises or falls, and has a value once or not at all:
the signs at both ends prove which. The zeros of the slope are all among those of a polynomial (`Surd.norm`),
and whether a quantity has a rational value exactly at such a place is settled by algebra, not by digits.
Angles are half turns in the frame of the stroke.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple

import flint
from flint import arb, fmpz_poly

from kurbel.exact.certify import ball, pi
from kurbel.exact.place import (
    FIRST_BITS,
    PRECISIONS,
    Centre,
    Place,
    fraction,
    is_after,
    recognised,
    unsettled,
)
from kurbel.exact.precision import at_bits
from kurbel.exact.search import Function, Zero, greatest
from kurbel.exact.surd import Surd

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
