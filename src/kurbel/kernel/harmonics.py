"""Harmonics of the straight crank drive: x = Σ A_k cos kφ, c = Σ C_k sin kφ, p = Σ B_k cos kφ.

Units are R, v and v²/R. The crank ratio λ = R/L is a float, an array or a ball. A negative ratio is the
return stroke, whose angle counts from the outer dead centre: the even orders change their signs, but for the
1 in A_0.

Re-derived. With t = tan ½ψ, where ψ = arcsin λ is the rod's greatest angle, cos ψ of any crank angle is
|√(1 + t² e^2iφ)|²/(1 + t²), for (1 + t²)λ = 2t. Two binomial series, multiplied, give for m >= 1

    A_2m = -Σ_j b_j b_(j+m) t^(4j + 2m - 1) = -b_m t^(2m - 1) F(-½, m - ½; m + 1; t⁴),  b_j = (½ over j),

with Gauss's series F, in which all terms but the first, 1, are negative, and A_0 from b_j². A_1 = -1 is the
crank's own share; the other odd orders vanish. By powers of λ the same are `path_series`, which converge
slower: t⁴ is 10^-4 for λ = 1/5 and 0.84 for λ = 0.999, where λ² is 0.998.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import comb
from typing import Any, NamedTuple

from kurbel.kernel.circle import Numeric, cosine_of

_NEGLIGIBLE = 2.0**-56


class Term(NamedTuple):
    """A term of a power series: coefficient times λ to the power."""

    power: int
    coefficient: Fraction


def path_coefficient(order: int, ratio: Numeric) -> Numeric:
    """Return A_k of the piston path from its dead centre, in units of R; A_0 is its mean.

    Floats: relative error at most 3e-15 for k <= 6, 1e-13 for k <= 100, if |λ| <= 1 - 10^-6; beyond, the
    series takes up to 10^6 terms and leaves eleven digits. Valid for |λ| < 1.
    """
    if order == 0:
        return _mean_path(ratio)
    if order == 1:
        return 0 * ratio - 1
    return 0 * ratio + 0 if order % 2 else _even_path(order // 2, ratio)


def slope_factor(order: int, slopes: int) -> int:
    """Return 1 for A_k itself, C_k/A_k = -k of its slope and B_k/A_k = -k² of the slope of that."""
    return -(order**slopes) if slopes else 1


def path_series(order: int, terms: int) -> tuple[Term, ...]:
    """Return the first terms of A_k by powers of λ, exact; fewer where there are no more.

    All have the sign (-1)^(k/2), but for the 1 of A_0, which counts as a term. Re-derived: the powers of
    sin φ in √(1 - λ² sin² φ), expanded in cosines.
    """
    if order % 2:
        return (Term(0, Fraction(-1)),)[:terms] if order == 1 else ()
    if not order:
        return (Term(0, Fraction(1)), *(_power_term(0, n) for n in range(1, terms)))[:terms]
    half = order // 2
    return tuple(_power_term(half, n) for n in range(half, half + terms))


def _power_term(half: int, n: int) -> Term:
    """Return the share of λ^(2n - 1) sin^2n φ in A_2m."""
    share = Fraction(comb(2 * n, n) * comb(2 * n, n - half), 16**n * (2 * n - 1))
    return Term(2 * n - 1, (-1) ** half * (2 if half else 1) * share)


def _half_slant(ratio: Numeric) -> Numeric:
    """Return t = tan ½ψ of the rod's greatest angle, sin ψ = λ."""
    return ratio / (1 + cosine_of(ratio))


def _mean_path(ratio: Numeric) -> Numeric:
    """Return A_0 = 1 + ½ (t - Σ_(j >= 1) b_j² t^(4j - 1))."""
    slant = _half_slant(ratio)
    square = slant * slant
    return 1 + (slant - slant * square * _square_series(square * square)) / 2


def _even_path(half: int, ratio: Numeric) -> Numeric:
    slant = _half_slant(ratio)
    square = slant * slant
    leading = slant / 2
    for j in range(1, half):
        # b_(j+1)/b_j = (½ - j)/(j + 1), and t² a step.
        leading = leading * square * (1 - 2 * j) / (2 * j + 2)
    # A difference, for the negative of 0.0 would have a sign.
    return 0 - leading * _gauss_series(half, square * square)


def _gauss_series(half: int, fourth: Any) -> Numeric:
    """Return F(-½, m - ½; m + 1; t⁴)."""
    if hasattr(fourth, "hypgeom_2f1"):
        minus_half = fourth.__class__(-1) / 2
        # Bounds of the rest pair m - ½ with m + 1, not with 1: else a term of the 268th order takes 0.8 s.
        return fourth.hypgeom_2f1(half + minus_half, minus_half, fourth.__class__(half + 1))
    return _summed(fourth, lambda j: (j - 0.5) * (j + half - 0.5) / ((j + 1) * (j + half + 1)))


def _square_series(fourth: Numeric) -> Numeric:
    """Return Σ_(j >= 1) b_j² t^(4j - 4) = (F(-½, -½; 1; t⁴) - 1)/t⁴."""
    if hasattr(fourth, "hypgeom_2f1"):
        return (_gauss_series(0, fourth) - 1) / fourth
    return _summed(fourth, lambda j: ((j + 0.5) / (j + 2)) ** 2) / 4


def _summed(number: Numeric, quotient: Callable[[int], float]) -> Numeric:
    """Return 1 + q_0 z + q_0 q_1 z² + ... of floats or arrays."""
    total = term = 0 * number + 1.0
    step = 0
    while _matters(term):
        term = term * number * quotient(step)
        total = total + term
        step += 1
    return total


def _matters(term: Numeric) -> bool:
    large = abs(term) > _NEGLIGIBLE
    return large if isinstance(large, bool) else bool(large.any())
