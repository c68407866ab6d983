"""The harmonics of the straight crank's motion, by the powers of sin² φ of its rod, with a bound of the rest.

    cos ψ = √(1 - λ² sin² φ) = Σ C(½, j) (-λ² sin² φ)^j,
    sin^2j φ = ... + 2 (-1)^m C(2j, j - m)/4^j cos 2mφ + ...

No C(½, j) and no share of a cosine in a power is above 1, so what follows the power N is at most
λ^(2N + 2)/(1 - λ²). Of x = 1 - cos φ + (1 - cos ψ)/λ the acceleration has -k² times the share of cos kφ.
"""

from __future__ import annotations

from fractions import Fraction
from math import comb

from kurbel.verify.enclose import Working
from kurbel.verify.numbers import Number, number, spread


def of_acceleration(ratio: Fraction, order: int) -> Number:
    """B_k of p = Σ B_k cos kφ."""
    if order % 2 or not ratio:
        return number(int(order == 1))
    m, square = order // 2, ratio * ratio
    least, total, binomial, power = Fraction(1, 2**Working.bits), Fraction(0), Fraction(1), Fraction(1)
    j = 0
    while j <= m or power / (1 - square) > least:
        if j >= m:
            total += binomial * power * (-1) ** j * Fraction(2 * (-1) ** m * comb(2 * j, j - m), 4**j)
        binomial *= (Fraction(1, 2) - j) / (j + 1)
        power *= square
        j += 1
    rest = power / (1 - square)
    return spread(total - rest, total + rest) * Fraction(order**2) / ratio
