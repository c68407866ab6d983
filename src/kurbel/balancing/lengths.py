"""What pages print of a residual: amplitudes, turning parts and half axes, with certified digits."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from math import inf
from typing import Any, NamedTuple

import flint

from kurbel.balancing.arrangement import Residual
from kurbel.drive.at import known
from kurbel.exact.certify import NEVER_TIES, at_bits, rounded
from kurbel.exact.kind import Kind, balls
from kurbel.exact.numerals import Number
from kurbel.exact.real import Known, Real
from kurbel.kernel.balance import Star


class Length(NamedTuple):
    """A magnitude of the residual: whether it is 0, its ball, and whether it is a rational number > 0."""

    vanishes: Callable[[Residual], bool]
    value: Callable[[Residual, Kind], Any]
    equals: Callable[[Residual, Fraction], bool]


def _magnitude(star_of: Callable[[Residual], Star]) -> Length:
    return Length(
        lambda residual: star_of(residual).vanishes(),
        lambda residual, kind: _length(star_of(residual), kind),
        lambda residual, length: (star_of(residual).square() - Star.ray(Fraction(0), length**2)).vanishes(),
    )


def _length(star: Star, kind: Kind) -> Any:
    # A ball around 0 has no root.
    if star.vanishes():
        return kind.of(Fraction(0))
    x, y = star.point(kind.circle, kind.of)
    return (x * x + y * y) ** 0.5


def _half_axis(sign: int) -> Length:
    """Return the half axis |f| ± |b| of the ellipse that the two vectors describe; a line's lesser is 0."""

    def vanishes(residual: Residual) -> bool:
        if sign > 0:
            return residual.forward.vanishes() and residual.backward.vanishes()
        return (residual.forward.square() - residual.backward.square()).vanishes()

    def value(residual: Residual, kind: Kind) -> Any:
        return abs(_length(residual.forward, kind) + sign * _length(residual.backward, kind))

    def equals(residual: Residual, length: Fraction) -> bool:
        forward, backward = residual.forward.square(), residual.backward.square()
        product = forward * backward * 4
        # With l = |f| ± |b| the rest is ±2 |f| |b|; its square alone fits both axes.
        rest = Star.ray(Fraction(0), length**2) - forward - backward
        if not (rest * rest - product).vanishes():
            return False
        return product.vanishes() or _sign(rest) == sign

    return Length(vanishes, value, equals)


def _sign(star: Star) -> int:
    """Return the sign of x of a star that is not 0 and lies along the x-axis."""
    kind, bits = balls(), flint.ctx.prec
    while True:
        with at_bits(bits):
            x, _ = star.point(kind.circle, kind.of)
        if not x.contains(0):
            return 1 if x > 0 else -1
        bits *= 2


LENGTHS: Mapping[str, Length] = {
    "along": _magnitude(lambda residual: residual.component(Fraction(0))),
    "across": _magnitude(lambda residual: residual.component(Fraction(90))),
    "forward": _magnitude(lambda residual: residual.forward),
    "backward": _magnitude(lambda residual: residual.backward),
    "greatest": _half_axis(1),
    "least": _half_axis(-1),
}
"""Amplitudes of the components along and across the line from which angles count; the magnitudes of the
two turning vectors; the half axes of the ellipse that they describe."""


def certified_length(
    length: Length, residual: Residual, decimals: int, factor: Known = 1, rounding: str = "half-away"
) -> Number:
    """Return a magnitude times the factor, correctly rounded; 0 where it is proved to be 0.

    Magnitudes are algebraic, and whether one is a rational number is decided by exact arithmetic. |B_k|
    is transcendental where it is not rational (`harmonics.certified`), and so is its product with one.
    """
    scale = Real.of(factor)
    if scale.rational == 0 or length.vanishes(residual):
        return Number(0, decimals)
    whole, share = Real(lambda kind: length.value(residual, kind)) * scale, scale.rational

    def tie_bits(boundary: Fraction) -> float:
        return 0.0 if length.equals(residual, boundary / known(share)) else inf

    ties = NEVER_TIES if share is None else tie_bits
    return Number(rounded(lambda: whole.on(balls()), decimals, rounding, ties), decimals)
