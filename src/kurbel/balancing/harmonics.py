"""Harmonics of the piston's path (A_k), velocity (C_k) and acceleration (B_k) with certified digits.

The sums are x = Σ A_k cos kφ, c = Σ C_k sin kφ, p = Σ B_k cos kφ of the straight crank; see
kernel/harmonics.py.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any, NamedTuple

from kurbel.drive.crank import Crank
from kurbel.errors import ProblemError
from kurbel.exact.certify import NEVER_TIES, ball, rounded
from kurbel.exact.numerals import Number, nearest
from kurbel.kernel import harmonics
from kurbel.kernel.harmonics import Term

MOST_ORDERS = 100


class Harmonic(NamedTuple):
    """The harmonics of a motion, the path's after so many slopes; `wave` is cos or sin."""

    key: str
    letter: str
    slopes: int
    wave: str = "cos"

    def factor(self, order: int) -> int:
        """Return C_k/A_k or B_k/A_k."""
        return harmonics.slope_factor(order, self.slopes)

    def value(self, order: int, ratio: Any) -> Any:
        """Return the coefficient of the exact motion for λ, a float, an array or a ball (not around 0)."""
        # -k times 0.0 is -0.0, and 0 more is not.
        return 0 + self.factor(order) * harmonics.path_coefficient(order, ratio)


HARMONICS: Mapping[str, Harmonic] = {
    "x": Harmonic("x", "A", 0),
    "c": Harmonic("c", "C", 1, "sin"),
    "p": Harmonic("p", "B", 2),
}
"""The harmonics by the key of the quantity that they add up to."""


def series(harmonic: Harmonic, order: int, terms: int) -> tuple[Term, ...]:
    """Return the first terms of the coefficient by powers of λ, exact: B_2 = λ + λ³/4 + 15 λ⁵/128 + ...

    Fewer where there are no more; none of an odd order above 1.
    """
    factor = harmonic.factor(order)
    shares = harmonics.path_series(order, terms) if factor else ()
    return tuple(Term(power, factor * coefficient) for power, coefficient in shares)


def rational(harmonic: Harmonic, order: int, crank: Crank, method: str = "exact") -> Fraction | None:
    """Return the coefficient if it is a rational number, else None.

    By the first-order formulas (`series`) every one is; by the exact ones those that are the same for all
    rods, and all of an infinite rod.
    """
    if method == "exact" and crank.ratio and harmonic.factor(order) and order % 2 == 0:
        return None
    ratio = Fraction(0) if method == "infinite" else crank.ratio
    terms = series(harmonic, order, 2)
    return sum((one.coefficient * ratio**one.power for one in terms if one.power <= 1), Fraction(0))


def certified(
    harmonic: Harmonic,
    order: int,
    crank: Crank,
    decimals: int,
    method: str = "exact",
    rounding: str = "half-away",
) -> Number:
    """Return the coefficient in its unit, correctly rounded to so many decimals.

    No value lies on a rounding boundary, other than those of `rational`: for 0 < λ < 1 the rest are
    transcendental. π A_2m is a K(λ) + b E(λ) with rational a and b: for m = 1 by its integral, then by the
    recurrence (2m + 3) A_2m+2 + (2m - 3) A_2m-2 = 4m (1 - 2/λ²) A_2m, in which -4 E(λ)/πλ stands for A_0;
    A_0 itself is 1 + (1 - 2 E(λ)/π)/λ. K is half a period of an elliptic curve with rational invariants, E
    a sum of rational multiples of a period and a quasi-period; with π they are linearly independent over the
    algebraic numbers, be there complex multiplication or not (Masser, Elliptic Functions and Transcendence,
    1975, chapters II and III). An algebraic A_2m would relate them unless a = b = 0, but the terms of its
    power series have one sign.
    """
    check_straight(crank)
    exact = rational(harmonic, order, crank, method)
    if exact is not None:
        return nearest(exact, decimals, rounding)

    def value() -> Any:
        return harmonic.value(order, ball(crank.ratio))

    return Number(rounded(value, decimals, rounding, NEVER_TIES), decimals)


def printed_orders(harmonic: Harmonic, last: int) -> tuple[int, ...]:
    """Return the orders up to the last but those that are 0 for all rods: 0 of the path, then 1, 2, 4, ..."""
    if not isinstance(last, int) or not 1 <= last <= MOST_ORDERS:
        raise ProblemError(
            f"orders up to {last} were asked for; the last must be a whole number from 1 to {MOST_ORDERS}"
        )
    orders = (0, 1, *range(2, last + 1, 2))
    return tuple(order for order in orders if harmonic.factor(order))


def check_straight(crank: Crank) -> None:
    """Raise ProblemError if the crank is offset."""
    if crank.offset:
        raise ProblemError(
            "the crank is offset; harmonics are known for the straight crank, without --offset"
        )
