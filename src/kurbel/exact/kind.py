"""The kinds of number that formulas run on: balls, separation bounds, floats, functions of the angle."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from kurbel.exact.surd import Field


class Kind(NamedTuple):
    """A kind of number: how it is made of a rational number, the circle of an angle in degrees, the arcsine
    in degrees, π, the rod angle in degrees of circle, λ and e/R or None, and what an exponent is to it.

    Separation bounds have neither arcs nor π; functions of the crank angle come with their own circle.
    """

    of: Callable[[Fraction], Any]
    circle: Any = None
    arc: Any = None
    pi: Any = None
    rod_angle: Any = None
    exponent: Any = None


def balls() -> Kind:
    """Return balls at the precision in force."""
    from kurbel.exact import certify

    return Kind(
        certify.ball, certify.ball_circle, certify.ball_degrees, certify.pi(), certify.rod_angle, certify.ball
    )


def bounds() -> Kind:
    """Return separation bounds."""
    from kurbel.exact.separation import Separation, circle_separation

    return Kind(Separation.rational, circle_separation, exponent=Fraction)


def floats() -> Kind:
    """Return floats, or arrays of them."""
    from math import pi

    from kurbel.kernel.circle import arcsine, circle, rod_angle

    def angle(point: Any, ratio: Any, offset: Any) -> Any:
        return rod_angle(point, ratio, offset or 0.0)

    return Kind(float, circle, arcsine, pi, angle, float)


def surds(field: Field) -> Kind:
    """Return functions of the tangent in the field, with their slopes."""
    from kurbel.exact.jet import Jet

    return Kind(lambda number: Jet(field.of(number), field.of(0), field.of(0)))
