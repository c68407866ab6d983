"""The greatest magnitude of a rod's force over the turn, enclosed with proof.

The force is greatest at a zero of a slope, and all zeros are enclosed (`search.isolate`), so that none is
missed. The quarters of the turn, where many of them lie, are settled exactly: there values are algebraic
numbers of known degree and can be proved to lie on a rounding boundary.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cached_property, lru_cache, reduce
from typing import Any

import flint
from flint import arb

from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.certify import GUARD_BITS, MOST_BITS, ball, ball_circle, half_turn_circle, pi, vanishes
from kurbel.exact.kind import Kind
from kurbel.exact.search import (
    BEFORE,
    BEHIND,
    SHARP_BITS,
    Jet,
    Summit,
    Zero,
    ball_jets,
    greatest,
    isolate,
    jet_of,
    jets,
)
from kurbel.exact.separation import Separation, circle_separation
from kurbel.exact.terms import algebraic
from kurbel.kernel.circle import Circle, Numeric
from kurbel.kernel.moving import Masses
from kurbel.kernel.rod import LoadedCrank
from kurbel.motion.inertia import RodForce, RodFormula

# The circle of an angle, balls as balls, bounds as bounds or either with its slopes.
CircleOf = Callable[[Any], Circle[Any]]
CONTENDING_BITS = 256
# Of a crank, at which its motion is kept.
MOST_PLACES = 10_000


class Peak:
    """The greatest magnitude of one force of the crank's rod, for the rod's masses or others in its place.

    Of the straight crank half a turn is searched, of which the other half is a mirror image.
    """

    def __init__(self, force: RodForce, crank: Crank, masses: Masses[Fraction]) -> None:
        self.force = force
        self.crank = crank
        self.masses = masses
        self._summit = Summit(self._magnitude)
        self._moved = _places(crank)
        self._bearing = lru_cache(8)(lambda of, bits: Masses(*map(of, map(Fraction, masses))))
        self._last: tuple[arb | None, int, Jet] = (None, 0, Jet(0, 0, 0))

    @cached_property
    def vanishes(self) -> bool:
        """Whether the force is zero throughout."""
        return not any(self.force.coefficients(self.masses, not self.crank.ratio))

    @cached_property
    def is_level(self) -> bool:
        """Whether the magnitude is the same throughout, so that no place is that of the greatest."""
        return not any(self.force.changes(self.masses, not self.crank.ratio))

    @cached_property
    def places(self) -> tuple[Zero, ...]:
        """Where it is greatest, in half turns, exact places first: several only if they differ by nothing
        measurable."""
        if self.is_level:
            return (self._zero(Fraction(0), Fraction(0)),)
        found = greatest(self._candidates(), self._value_at, precisions=(CONTENDING_BITS,))
        return tuple(sorted(found, key=lambda place: (place.low < place.high, place.low)))

    def value(self) -> arb:
        """Return the magnitude in units of M R ω², a ball at the precision in force."""
        if self.vanishes:
            return ball(0)
        return reduce(arb.max, (self._value_at(place) for place in self.places))

    def on(self, numbers: Kind) -> Numeric:
        """Return the magnitude on balls or on Terms."""
        return algebraic(numbers, self.value, self.separation)

    @property
    def exact_degrees(self) -> Fraction | None:
        """Where it is greatest if that is at a quarter of the turn."""
        return 180 * self.places[0].low if _is_exact(self.places[0]) else None

    def degrees(self) -> arb:
        """Return where it is greatest, from 0° to 180° or, of an offset crank, 360°; the first such place."""
        return 180 * self.places[0].place()

    def share_of(self, whole: Peak) -> Fraction | None:
        """Return how many times the other's magnitude this is, throughout, if they are in proportion."""
        infinite = not self.crank.ratio
        own = [Fraction(one) for one in self.force.coefficients(self.masses, infinite)]
        others = [Fraction(one) for one in self.force.coefficients(whole.masses, infinite)]
        share = next((one / other for one, other in zip(own, others, strict=True) if other), None)
        if share is None or any(one != share * other for one, other in zip(own, others, strict=True)):
            return None
        return abs(share)

    def separation(self) -> Separation | None:
        """Return the bound of the magnitude where it is an algebraic number of known degree, else None."""
        if self.vanishes:
            return Separation.rational(0)
        if not all(map(_is_exact, self.places)):
            return None
        formula, of = self.force.formula, Separation.rational
        bounds: list[Any] = [self._at(formula, _bounds, place.low, of) for place in self.places]
        found: Separation = reduce(Separation.union, bounds)
        return found

    def _at(
        self,
        formula: RodFormula,
        circle: CircleOf,
        place: arb | Fraction,
        of: Callable[[Fraction], Any] = ball,
    ) -> Numeric:
        """Return what the formula says of a place in half turns; the rod moves alike in all its forces."""
        near: object = place
        if isinstance(place, arb):
            near = place.mid().man_exp(), place.rad().man_exp()
        key = circle, near, flint.ctx.prec
        if key not in self._moved:
            if len(self._moved) >= MOST_PLACES:
                self._moved.clear()
            self._moved[key] = _loaded(self.crank, circle(place), of)
        return formula(self._moved[key].bearing(self._bearing(of, flint.ctx.prec)))

    def _jet(self, formula: RodFormula, half_turns: arb) -> Jet:
        return jet_of(self._at(formula, ball_jets, half_turns))

    def _smooth(self, half_turns: arb) -> Jet:
        # A slope is asked for with its bend.
        place, precision, jet = self._last
        if place is not half_turns or precision != flint.ctx.prec:
            jet = self._jet(self.force.smooth, half_turns)
            self._last = half_turns, flint.ctx.prec, jet
        return jet

    def _slope(self, half_turns: arb) -> arb:
        return ball(self._smooth(half_turns).slope)

    def _bend(self, half_turns: arb) -> arb:
        return ball(self._smooth(half_turns).bend) * pi()

    def _candidates(self) -> Iterator[Zero]:
        """Yield the quarters of the turn and all zeros of the slope between them.

        With an infinite rod the torque is greatest at the eighths, where values are algebraic too. Beside
        the peak of a rod as long as the crank the slope of what is left, a millionth of it, is told from zero
        in millions of pieces, of which none matters.
        """
        turn, parts = (2 if self.crank.offset else 1), (2 if self.crank.ratio else 4)
        quarters = [Fraction(quarter, parts) for quarter in range(parts * turn + 1)]
        for quarter in quarters:
            self._summit.reach(ball(quarter))
            yield self._zero(quarter, quarter)
        ends = -BEFORE, turn + BEHIND
        for zero in isolate(self._slope, self._bend, *ends, self._summit.concerns, SHARP_BITS):
            near = [quarter for quarter in quarters if zero.low <= quarter <= zero.high]
            # The one zero in an interval is that of the quarter, if it has one; beyond both ends of the
            # search all comes again.
            is_quarter = zero.rising is not None and any(map(self._is_level, near))
            if not (is_quarter or zero.place() < 0 or zero.place() > turn):
                yield zero

    def _zero(self, low: Fraction, high: Fraction) -> Zero:
        return Zero(self._slope, self._bend, low, high, None)

    def _magnitude(self, half_turns: arb) -> arb:
        return abs(ball(self._at(self.force.formula, half_turn_circle, half_turns)))

    def _is_level(self, quarter: Fraction) -> bool:
        """Whether the slope at a quarter of the turn is zero, proved by its separation bound."""
        bits = jet_of(self._at(self.force.smooth, _bound_jets, quarter, _constant)).slope.bits()
        return vanishes(lambda: self._slope(ball(quarter)), float(bits))

    def _value_at(self, place: Zero) -> arb:
        at = place.place()
        found = self._at(self.force.formula, _exact, place.low) if _is_exact(place) else self._magnitude(at)
        value = abs(ball(found))
        if _is_exact(place) or place.rising is not None:
            return value
        nearer = abs(self._around(at))
        # A magnitude has no slope where it is zero.
        return nearer if nearer.is_finite() else value

    def _around(self, at: arb) -> arb:
        """Return all values within an interval that precision does not narrow, by mean-value forms."""
        if flint.ctx.prec > MOST_BITS:
            raise ProblemError(
                f"the place of the greatest {self.force.name['en'].lower()} is not settled by"
                f" {MOST_BITS - GUARD_BITS} bits; ask for fewer digits"
            )
        middle, wide = self._jet(self.force.formula, at.mid()), self._jet(self.force.formula, at)
        away = (at - at.mid()) * pi()
        return ball(middle.value + away * (middle.slope + away * wide.bend))


@lru_cache(maxsize=16)
def _places(crank: Crank) -> dict[tuple[object, ...], LoadedCrank]:
    """Return what is known of the crank's motion, for all forces of its rod."""
    return {}


def _loaded(crank: Crank, circle: Circle[Any], of: Callable[[Fraction], Any]) -> LoadedCrank:
    """Return the crank's drive, without masses."""
    offset = of(crank.offset) if crank.offset else None
    return LoadedCrank(circle, of(crank.ratio), Masses(0, 0, 0), offset)


def _is_exact(place: Zero) -> bool:
    return place.low == place.high


def _exact(half_turns: Fraction) -> Circle[arb]:
    return ball_circle(180 * half_turns)


def _bounds(half_turns: Fraction) -> Circle[Separation]:
    return circle_separation(180 * half_turns)


def _bound_jets(half_turns: Fraction) -> Circle[Jet]:
    return jets(_bounds(half_turns))


def _constant(value: Fraction) -> Jet:
    return Jet(Separation.rational(value), 0, 0)
