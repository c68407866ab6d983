"""The free force or moment of an engine at an angle of the shaft: of an order, and of all together.

Of all orders it is the sum over the cylinders of their piston accelerations, by the exact formula: cos θ,
whose sum is the first order, and a rest that is the same at θ, -θ and θ + 180°.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from kurbel.balancing.arrangement import Arrangement, Cylinder, Residual
from kurbel.balancing.vector import Point, Vector
from kurbel.drive.crank import Crank
from kurbel.exact.kind import Kind
from kurbel.kernel.balance import Star
from kurbel.kernel.kinematics import piston_acceleration

# What a cylinder's force counts: 1, or its arm.
Weigh = Callable[[Cylinder], Fraction]
WEIGH: dict[str, Weigh] = {
    "force": lambda cylinder: Fraction(1),
    "moment": lambda cylinder: cylinder.position,
}


def of_order(residual: Residual, order: int, angle: Fraction) -> Vector:
    """Return the vector of an order at an angle in degrees, in units of m R ω² |B_k|."""
    forward = residual.forward.turned(order * angle)
    return Vector(forward + residual.backward.turned(-order * angle))


def of_all(arrangement: Arrangement, residual: str, first: Residual, crank: Crank, angle: Fraction) -> Vector:
    """Return the vector of all orders at an angle in degrees, in units of m R ω²; `first` is the first order.

    Exact for every crank ratio 0 <= λ < 1.
    """
    groups: dict[Fraction, Star] = {}
    for cylinder in arrangement.cylinders:
        turned = (angle + cylinder.crank - cylinder.bank) % 180
        folded = min(turned, 180 - turned)
        ray = Star.ray(cylinder.bank, cylinder.mass * WEIGH[residual](cylinder))
        groups[folded] = groups.get(folded, Star()) + ray
    rest: list[tuple[Point, Fraction]] = [
        (_even(folded, star, crank.ratio), Fraction(1))
        for folded, star in sorted(groups.items())
        if crank.ratio and not star.vanishes()
    ]
    return Vector(of_order(first, 1, angle).star, tuple(rest))


def _even(angle: Fraction, star: Star, ratio: Fraction) -> Point:
    """Return a star times the piston acceleration less cos θ at an angle."""

    def point(kind: Kind) -> tuple[Any, Any]:
        circle = kind.circle(angle)
        size = piston_acceleration(circle, kind.of(ratio)) - circle.cosine
        x, y = star.point(kind.circle, kind.of)
        return size * x, size * y

    return point
