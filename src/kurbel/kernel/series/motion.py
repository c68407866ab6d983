"""The motion by powers of λ: the piston path up to λⁿ, its slopes term by term, and those of the rod.

    x = 1 - cos φ + ½ λ sin² φ + ⅛ λ³ sin⁴ φ + 1/16 λ⁵ sin⁶ φ + 5/128 λ⁷ sin⁸ φ + 7/256 λ⁹ sin¹⁰ φ + …

Units and signs are those of `kurbel.kernel.kinematics`. Even powers do not occur: an even order is the odd
one below it. Source: Blau, § 6, the expansion of fd before eq. (22), continued by the binomial series. Floats
add to the error of the formulas of first order at most one unit in the last place.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from kurbel.kernel import kinematics
from kurbel.kernel.circle import Circle, Number
from kurbel.kernel.series import coefficients


def rod_versine(circle: Circle[Number], ratio: Number, order: int) -> Number:
    """Return Blau's fd = ½ λ sin² φ + ⅛ λ³ sin⁴ φ + …, in units of R, up to λ to this power."""
    slant = ratio * circle.sine * circle.sine
    return slant / 2 + _further_path(circle, ratio, order)


def piston_path(circle: Circle[Number], ratio: Number, order: int) -> Number:
    """Return x from the dead centre up to λ to this power, in units of R."""
    return kinematics.piston_path_first_order(circle, ratio) + _further_path(circle, ratio, order)


def piston_velocity(circle: Circle[Number], ratio: Number, order: int) -> Number:
    """Return the slope of x, c = sin φ + λ sin φ cos φ (1 + ½ λ² sin² φ + ⅜ λ⁴ sin⁴ φ + …), in units of v."""
    further = _sum(_square(circle, ratio), order, coefficients.slope)
    first = kinematics.piston_velocity_first_order(circle, ratio)
    return first + ratio * circle.sine * circle.cosine * further


def piston_acceleration(circle: Circle[Number], ratio: Number, order: int) -> Number:
    """Return the slope of c, p = cos φ + λ cos 2φ + ½ λ³ sin² φ (3 cos² φ - sin² φ) + …, in v²/R."""
    square = _square(circle, ratio)
    along = _sum(square, order, lambda term: _times(2 * term - 1, coefficients.slope(term)))
    across = _sum(square, order, coefficients.slope)
    further = circle.cosine * circle.cosine * along - circle.sine * circle.sine * across
    return kinematics.piston_acceleration_first_order(circle, ratio) + ratio * further


def rod_velocity(circle: Circle[Number], ratio: Number, order: int) -> Number:
    """Return λ cos φ (1 + ½ λ² sin² φ + …) up to λ to this power: the rod's angular velocity, in ω."""
    further = _sum(_square(circle, ratio), order, coefficients.slope)
    return kinematics.rod_velocity_first_order(circle, ratio) + ratio * circle.cosine * further


def rod_acceleration(circle: Circle[Number], ratio: Number, order: int) -> Number:
    """Return its slope, -λ sin φ (1 + λ² (½ sin² φ - cos² φ) + …), in units of ω²."""
    square = _square(circle, ratio)
    along = _sum(square, order, lambda term: _times(2 * term - 2, coefficients.slope(term)), least=0)
    across = _sum(square, order, coefficients.slope)
    reach = ratio * circle.cosine
    further = reach * reach * along - across
    return kinematics.rod_acceleration_first_order(circle, ratio) + ratio * circle.sine * further


def _square(circle: Circle[Number], ratio: Number) -> Number:
    sine = ratio * circle.sine
    return sine * sine


def _further_path(circle: Circle[Number], ratio: Number, order: int) -> Number:
    further = _sum(_square(circle, ratio), order, coefficients.rod_versine)
    return ratio * circle.sine * circle.sine * further


def _times(factor: int, coefficient: tuple[int, int]) -> tuple[int, int]:
    return factor * coefficient[0], coefficient[1]


def _sum(square: Number, order: int, coefficient: Callable[[int], tuple[int, int]], least: int = 1) -> Number:
    """Return the terms beyond the first, a_2 z + a_3 z² + …, for `least` 0 over z; whole numbers over one
    power of two, so that no coefficient of floats is rounded."""
    found = [coefficient(term) for term in range(2, coefficients.terms_of(order) + 1)]
    if not found:
        return 0
    common = max(below for _, below in found)
    return _horner(square, [above * (common // below) for above, below in found], least) / common


def _horner(square: Number, factors: Sequence[int], least: int) -> Number:
    *others, last = factors
    value: Number = last
    for one in reversed(others):
        value = value * square + one
    return value * square if least else value
