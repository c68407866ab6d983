"""Where an arc crank stands, by formulas with small separation bounds.

The kernel's formulas of the arc crank shun differences, at the price of so many quotients that their bounds
reach a million bits. Here the rocker's angle θ comes first, with rational coefficients settled beforehand and
one root each for the dead centre, if it counts from there, and the place: some thousand bits, but no digits
for floats to rely on.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any, TypeAlias

from kurbel.exact.kind import Kind
from kurbel.kernel.circle import Circle
from kurbel.kernel.linkage import Arc, Place

# λ, β, η and σ with the sign of the stroke.
Numbers: TypeAlias = tuple[Fraction, Fraction, Fraction, Fraction]


def direct(numbers: Numbers, circle: Circle[Any], of_stroke: bool, kind: Kind) -> tuple[Place[Any], Arc[Any]]:
    """Return where the drive stands, its way from the dead centre only if that is wanted."""
    sine, cosine, slant, slant_cosine = _turn(numbers, circle, kind.of)
    ratio, curvature = map(kind.of, numbers[:2])
    nothing = kind.of(Fraction(0))
    # With θ = 0 at the dead centre the slide direction is its tangent, in which along and across are.
    along, rise = nothing, nothing
    dead_crank = (nothing, nothing)
    if of_stroke:
        dead, dead_crank = _dead_turn(numbers, kind.of)
        along, rise = (dead[0] - sine) / curvature, (dead[1] - cosine) / curvature
    across = circle.sine * cosine - circle.cosine * sine
    facing = circle.cosine * cosine + circle.sine * sine
    velocity = across + facing * slant / slant_cosine
    place = Place(nothing, along, rise, slant, slant_cosine, across, facing, velocity)
    return place, Arc(ratio, curvature, nothing, nothing, nothing, *dead_crank)


def _turn(numbers: Numbers, circle: Circle[Any], of: Callable[[Fraction], Any]) -> tuple[Any, Any, Any, Any]:
    """Return sin θ and cos θ of the rocker, sin ψ and cos ψ of the rod against the arc."""
    ratio, curvature, offset, shift = numbers
    level, up = _pivot(numbers)
    mean = curvature * shift + ratio * offset + ratio * curvature * (1 + shift**2 + offset**2) / 2
    slant = of(level) * circle.cosine + of(up) * circle.sine - of(mean)
    slant_cosine = (1 - slant * slant) ** 0.5
    both = ratio * curvature
    sine, cosine = _rocker_turn(
        of(curvature) * slant - of(ratio),
        of(curvature) * slant_cosine,
        of(level) - of(both) * circle.cosine,
        of(up) - of(both) * circle.sine,
        of(level**2 + up**2 + both**2) - of(2 * both) * (of(level) * circle.cosine + of(up) * circle.sine),
    )
    return sine, cosine, slant, slant_cosine


def _dead_turn(numbers: Numbers, of: Callable[[Fraction], Any]) -> tuple[tuple[Any, Any], tuple[Any, Any]]:
    """Return sine and cosine of θ at the dead centre, and those of the crank angle there."""
    ratio, curvature, offset, shift = numbers
    level, up = _pivot(numbers)
    gap = 1 - shift + ratio * (1 - shift**2 - offset**2) / 2
    dead = curvature * gap - ratio * offset
    root = of((1 + ratio) ** 2 - dead**2) ** 0.5
    sine, cosine = _rocker_turn(
        of(curvature * dead - ratio),
        of(curvature) * root,
        of(level),
        of(up),
        of(level**2 + up**2),
    )
    # The rod, at sin ψ = dead/(1 + λ) against the arc, is in line with the crank.
    whole, slant = of(1 + ratio), of(dead)
    crank = (sine * root - cosine * slant) / whole, (cosine * root + sine * slant) / whole
    return (sine, cosine), crank


def _pivot(numbers: Numbers) -> tuple[Fraction, Fraction]:
    """Return the pivot seen from the shaft, along and across the slide direction, times λβ."""
    ratio, curvature, offset, shift = numbers
    return curvature * (1 + ratio * shift), ratio * (1 + curvature * offset)


def _rocker_turn(along: Any, across: Any, level: Any, up: Any, square: Any) -> tuple[Any, Any]:
    """Return sin θ and cos θ from the rod's end in the frame of pin and pivot, all times λβ.

    `level` and `up` lead from the pin to the pivot, `square` is the square of this distance.
    """
    return (along * level + across * up) / square, (across * level - along * up) / square
