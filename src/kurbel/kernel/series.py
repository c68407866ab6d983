"""Approximations: the motion by powers of λ, the coefficients of these, and Rötscher's successive steps.

The piston path up to λⁿ, its slopes term by term, and those of the rod:

    x = 1 - cos φ + ½ λ sin² φ + ⅛ λ³ sin⁴ φ + 1/16 λ⁵ sin⁶ φ + 5/128 λ⁷ sin⁸ φ + 7/256 λ⁹ sin¹⁰ φ + …

Units and signs are those of `kurbel.kernel.kinematics`. Even powers do not occur: an even order is the odd
one below it. Source: Blau, § 6, the expansion of fd before eq. (22), continued by the binomial series. Floats
add to the error of the formulas of first order at most one unit in the last place.

Rötscher's GF = CF²/(2 L - GF), step by step: C lies on a circle of radius L about K; G and F are where the
circle and the perpendicular from C meet the slide line. The exact GF is L (1 - cos ψ),
`kernel.kinematics.rod_versine`. From GF = 0 the steps rise to it: the step keeps GF and 2 L - GF, and the
distances from these are in a ratio that each step makes q times as large, q = GF/(2 L - GF) = tan² ½ψ. So the
k-th is GF (1 - q^k)/(1 - q^(k+1)), and

    0 < GF - GF_k < q^k GF, and each step leaves less than q of the distance.

Source of the equation: Rötscher, at the end of Ermittlung der Kolbenwege; the rest re-derived.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import comb

from kurbel.kernel import kinematics
from kurbel.kernel.circle import Circle, Numeric


def terms_of(order: int) -> int:
    """Return how many terms of the path have λ to at most this power, of λ, λ³, λ⁵ and so on."""
    return (order + 1) // 2


def versine_term(term: int) -> tuple[int, int]:
    """Return ½, ⅛, 1/16, 5/128, … of λ sin² φ, λ³ sin⁴ φ, … in (1 - cos ψ)/λ: Catalan's numbers."""
    return _reduced(comb(2 * term - 2, term - 1) // term, 2 ** (2 * term - 1))


def slope_term(term: int) -> tuple[int, int]:
    """Return 1, ½, ⅜, 5/16, … of 1, λ² sin² φ, λ⁴ sin⁴ φ, … in 1/cos ψ."""
    return _reduced(comb(2 * term - 2, term - 1), 4 ** (term - 1))


def _reduced(above: int, below: int) -> tuple[int, int]:
    while above % 2 == 0:
        above, below = above // 2, below // 2
    return above, below


def rod_versine(circle: Circle[Numeric], ratio: Numeric, order: int) -> Numeric:
    """Return Blau's fd = ½ λ sin² φ + ⅛ λ³ sin⁴ φ + …, in units of R, up to λ to this power."""
    slant = ratio * circle.sine * circle.sine
    return slant / 2 + _further_path(circle, ratio, order)


def piston_path(circle: Circle[Numeric], ratio: Numeric, order: int) -> Numeric:
    """Return x from the dead centre up to λ to this power, in units of R."""
    return kinematics.piston_path_first_order(circle, ratio) + _further_path(circle, ratio, order)


def piston_velocity(circle: Circle[Numeric], ratio: Numeric, order: int) -> Numeric:
    """Return the slope of x, c = sin φ + λ sin φ cos φ (1 + ½ λ² sin² φ + ⅜ λ⁴ sin⁴ φ + …), in units of v."""
    further = _sum(_square(circle, ratio), order, slope_term)
    first = kinematics.piston_velocity_first_order(circle, ratio)
    return first + ratio * circle.sine * circle.cosine * further


def piston_acceleration(circle: Circle[Numeric], ratio: Numeric, order: int) -> Numeric:
    """Return the slope of c, p = cos φ + λ cos 2φ + ½ λ³ sin² φ (3 cos² φ - sin² φ) + …, in v²/R."""
    square = _square(circle, ratio)
    along = _sum(square, order, lambda term: _times(2 * term - 1, slope_term(term)))
    across = _sum(square, order, slope_term)
    further = circle.cosine * circle.cosine * along - circle.sine * circle.sine * across
    return kinematics.piston_acceleration_first_order(circle, ratio) + ratio * further


def rod_velocity(circle: Circle[Numeric], ratio: Numeric, order: int) -> Numeric:
    """Return λ cos φ (1 + ½ λ² sin² φ + …) up to λ to this power: the rod's angular velocity, in ω."""
    further = _sum(_square(circle, ratio), order, slope_term)
    return kinematics.rod_velocity_first_order(circle, ratio) + ratio * circle.cosine * further


def rod_acceleration(circle: Circle[Numeric], ratio: Numeric, order: int) -> Numeric:
    """Return its slope, -λ sin φ (1 + λ² (½ sin² φ - cos² φ) + …), in units of ω²."""
    square = _square(circle, ratio)
    along = _sum(square, order, lambda term: _times(2 * term - 2, slope_term(term)), least=0)
    across = _sum(square, order, slope_term)
    reach = ratio * circle.cosine
    further = reach * reach * along - across
    return kinematics.rod_acceleration_first_order(circle, ratio) + ratio * circle.sine * further


def _square(circle: Circle[Numeric], ratio: Numeric) -> Numeric:
    sine = ratio * circle.sine
    return sine * sine


def _further_path(circle: Circle[Numeric], ratio: Numeric, order: int) -> Numeric:
    further = _sum(_square(circle, ratio), order, versine_term)
    return ratio * circle.sine * circle.sine * further


def _times(factor: int, coefficient: tuple[int, int]) -> tuple[int, int]:
    return factor * coefficient[0], coefficient[1]


def _sum(
    square: Numeric, order: int, coefficient: Callable[[int], tuple[int, int]], least: int = 1
) -> Numeric:
    """Return the terms beyond the first, a_2 z + a_3 z² + …, for `least` 0 over z; whole numbers over one
    power of two, so that no coefficient of floats is rounded."""
    found = [coefficient(term) for term in range(2, terms_of(order) + 1)]
    if not found:
        return 0
    common = max(below for _, below in found)
    return _horner(square, [above * (common // below) for above, below in found], least) / common


def _horner(square: Numeric, factors: Sequence[int], least: int) -> Numeric:
    *others, last = factors
    value: Numeric = last
    for one in reversed(others):
        value = value * square + one
    return value * square if least else value


def after(circle: Circle[Numeric], ratio: Numeric, steps: int) -> Numeric:
    """Return GF after so many steps from GF = 0; the first is CF²/2 L, the books' first order of fd."""
    across = ratio * circle.sine * circle.sine
    found: Numeric = 0
    for _ in range(steps):
        found = across / (2 - ratio * found)
    return found


def shrinking(circle: Circle[Numeric], ratio: Numeric) -> Numeric:
    """Return q = tan² ½ψ."""
    half = ratio * circle.sine / (1 + kinematics.rod_cosine(circle, ratio))
    return half * half


def closed(circle: Circle[Numeric], ratio: Numeric, steps: int) -> Numeric:
    """Return the same as `after`, in one formula for any number of steps."""
    share = shrinking(circle, ratio) ** steps
    return kinematics.rod_versine(circle, ratio) * (1 - share) / (1 - share * shrinking(circle, ratio))
