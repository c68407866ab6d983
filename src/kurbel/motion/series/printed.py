"""The formulas by powers of λ as pages print them: short ones whole, of long ones two terms and the last."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from kurbel.exact.numerals import Label
from kurbel.kernel.series import slope_term, terms_of, versine_term
from kurbel.page.quantity import filled

# So many terms are printed whole.
WHOLE = 3


def with_terms(line: Label, order: int) -> Label:
    """Return the line of a formula with the terms of its series up to λ to this power."""
    return filled(line, ((f"{{{name}}}", terms(order)) for name, terms in TERMS.items()))


def path(order: int) -> str:
    """1/2 λ sin² φ + 1/8 λ³ sin⁴ φ"""
    return _sum(order, lambda term: f"{_share(versine_term(term))}{_power(term)} {_sine(2 * term)}")


def velocity(order: int) -> str:
    """1 + 1/2 λ² sin² φ: what λ sin φ cos φ is multiplied with, and also λ cos φ of the rod."""

    def one(term: int) -> str:
        return "1" if term == 1 else f"{_share(slope_term(term))}{_even(term)} {_sine(2 * term - 2)}"

    return _sum(order, one)


def acceleration(order: int) -> str:
    """λ cos 2φ + 1/2 λ³ sin² φ (4 cos² φ - 1)"""

    def one(term: int) -> str:
        if term == 1:
            return "λ cos 2 {angle}"
        bracket = f"({2 * term} cos^2 {{angle}} - 1)"
        return f"{_share(slope_term(term))}{_power(term)} {_sine(2 * term - 2)} {bracket}"

    return _sum(order, one)


def rod_acceleration(order: int) -> str:
    """1 - 1/2 λ² (3 cos² φ - 1): what -λ sin φ is multiplied with."""

    def one(term: int) -> str:
        if term == 1:
            return "1"
        sine = f" {_sine(2 * term - 4)}" if term > 2 else ""
        bracket = f"({2 * term - 1} cos^2 {{angle}} - 1)"
        return f"{_share(slope_term(term))}{_even(term)}{sine} {bracket}"

    return _sum(order, one, " - ")


def _sum(order: int, term: Callable[[int], str], sign: str = " + ") -> str:
    count = terms_of(order)
    shown = range(1, count + 1) if count <= WHOLE else (1, 2, count)
    parts = [term(one) for one in shown]
    if count > WHOLE:
        parts.insert(2, "…")
    return sign.join(parts)


def _share(coefficient: tuple[int, int]) -> str:
    above, below = coefficient
    return f"{above}/{below} "


def _power(term: int) -> str:
    return "λ" if term == 1 else f"λ^{2 * term - 1}"


def _even(term: int) -> str:
    return f"λ^{2 * term - 2}"


def _sine(power: int) -> str:
    exponent = str(power) if power < 10 else f"({power})"
    return f"sin^{exponent} {{angle}}"


# By their places in printed formulas.
TERMS: Mapping[str, Callable[[int], str]] = {
    "path": path,
    "velocity": velocity,
    "acceleration": acceleration,
    "rod_acceleration": rod_acceleration,
}
