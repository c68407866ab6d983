"""The coefficients of the powers of λ, as whole numbers over a power of two: no float rounds them."""

from __future__ import annotations

from math import comb


def terms_of(order: int) -> int:
    """Return how many terms of the path have λ to at most this power: λ, λ³, λ⁵, …"""
    return (order + 1) // 2


def rod_versine(term: int) -> tuple[int, int]:
    """Return ½, ⅛, 1/16, 5/128, … of λ sin² φ, λ³ sin⁴ φ, … in (1 - cos ψ)/λ: Catalan's numbers."""
    return _reduced(comb(2 * term - 2, term - 1) // term, 2 ** (2 * term - 1))


def slope(term: int) -> tuple[int, int]:
    """Return 1, ½, ⅜, 5/16, … of 1, λ² sin² φ, λ⁴ sin⁴ φ, … in 1/cos ψ."""
    return _reduced(comb(2 * term - 2, term - 1), 4 ** (term - 1))


def _reduced(above: int, below: int) -> tuple[int, int]:
    while above % 2 == 0:
        above, below = above // 2, below // 2
    return above, below
