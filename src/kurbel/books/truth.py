"""What a value of a book is, with every digit certified: a number, or what a formula makes of others."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from math import inf
from typing import NamedTuple

from flint import arb

from kurbel.books.expression import Expression, IrrationalError, Kind, fraction_root, irrational
from kurbel.books.printed_value import Printed, Units
from kurbel.errors import NotationError
from kurbel.exact.certify import NEVER_TIES, TieBits, ball, ball_circle, ball_degrees, rounded, vanishes
from kurbel.exact.separation import Separation, circle_separation

BALLS = Kind(ball, ball_circle, lambda value: value.log(), lambda value: 90 - ball_degrees(value))
FRACTIONS = Kind(lambda value: value, irrational, irrational, irrational, fraction_root)
BOUNDS = Kind(Separation.rational, circle_separation, irrational, irrational)


class Truth(NamedTuple):
    """What a cell is: its ball at the precision in force, its separation bound, None without one.

    `rational` is the value itself where it is known to be a fraction.
    """

    value: Callable[[], arb]
    bound: Callable[[], Separation] | None = None
    rational: Fraction | None = None

    def in_units(self, printed: Printed) -> Units | None:
        """Return how many units of the printed value's last place it is, rounded half away from zero.

        A quotient has none, and is the value itself: None where that is irrational.
        Where there is no bound no value is a tie. Nor is an angle one, an odd number of quarters or halves of
        a minute or degree: those here are rational over π, or have a cosine of at most degree 2 over the
        rationals, and those odd numbers one of a higher degree.
        """
        unit = printed.unit
        if printed.exact:
            if self.rational is not None:
                return self.rational / unit
            return next(
                (sign * printed.scaled for sign in (1, -1) if self.equals(sign * printed.value)), None
            )

        def tie_bits(boundary: Fraction) -> float:
            assert self.bound is not None
            return float((self.bound() - Separation.rational(boundary * unit)).bits())

        ties: TieBits | None = NEVER_TIES if self.bound is None else tie_bits
        return rounded(lambda: self.value() / ball(unit), 0, "half-away", ties)

    def written_as(self, printed: Printed) -> Printed:
        """Return the value as another is printed; one in place of a quotient is rational."""
        units = self.in_units(printed)
        assert units is not None
        return printed.with_units(units)

    def equals(self, value: Fraction) -> bool:
        """Return whether it is this number itself."""
        bits = inf if self.bound is None else (self.bound() - Separation.rational(value)).bits()
        return vanishes(lambda: self.value() - ball(value), float(bits))


def constant(value: Fraction) -> Truth:
    """Return what is a rational number."""
    return Truth(lambda: ball(value), lambda: Separation.rational(value), value)


def formula_truth(formula: Expression, cells: Callable[[str], Truth]) -> Truth:
    """Return what a formula makes of the cells that it names."""
    rational = _rational(formula, cells)
    if rational is not None:
        return constant(rational)

    def bound(name: str) -> Separation:
        found = cells(name).bound
        assert found is not None
        return found()

    algebraic = not formula.transcendental and all(cells(name).bound is not None for name in formula.names)
    return Truth(
        lambda: formula.value(BALLS, lambda name: cells(name).value()),
        (lambda: formula.value(BOUNDS, bound)) if algebraic else None,
    )


def _rational(formula: Expression, cells: Callable[[str], Truth]) -> Fraction | None:
    """Return the value if fractions and roots of squares alone make it."""

    def fraction(name: str) -> Fraction:
        found = cells(name).rational
        return irrational(name) if found is None else found

    try:
        value: Fraction = formula.value(FRACTIONS, fraction)
    except IrrationalError:
        return None
    except ZeroDivisionError:
        raise NotationError(f'"{formula.text[:60]}" divides by zero') from None
    return value


def kept(truth: Truth) -> Truth:
    """Return the same, computed once for each precision."""
    from flint import ctx

    at = cache(lambda precision: truth.value())
    return Truth(lambda: at(ctx.prec), truth.bound and cache(truth.bound), truth.rational)
